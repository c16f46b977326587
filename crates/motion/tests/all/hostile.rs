//! Damaged files give errors or sound channels, never a panic.

use std::path::Path;
use std::sync::Arc;

use crate::formats;
use tremolite_motion::{
    FORMATS, Geographic, Intensity, Motion, Process, ReadOptions, Stations, Units, process, read_bytes,
    strongest_window,
};

/// Steele and Vigna's splitmix64: small, and the same on every machine, so a failure can be repeated.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, n: usize) -> usize {
        (self.next() % n.max(1) as u64) as usize
    }
}

/// Good files of every format that is read.
fn seeds() -> Vec<Vec<u8>> {
    FORMATS.iter().flat_map(|format| files(format.name)).collect()
}

/// Good files of one format.
fn files(format: &str) -> Vec<Vec<u8>> {
    let files = match format {
        "GeoNet V1A, V2A" => vec![geonet()],
        "PEER AT2" => vec![peer()],
        "text columns" => vec![two_columns(), one_column()],
        other => {
            let files = formats::good(other);
            assert!(!files.is_empty(), "{other}: there is no good file of this format to damage");
            return files;
        }
    };
    files.into_iter().map(String::into_bytes).collect()
}

/// Two components, whose numbers touch in their columns of eight.
fn geonet() -> String {
    let mut geonet = String::from("Corrected accelerogram X\n");
    for line in 2..=16 {
        geonet += match line {
            10 => "Number of points    12    Duration 0.22 sec\n",
            11 => "Instrument corrected data at 0.020 sec intervals\n",
            13 => "Component N28W  Longitudinal Accelerometer Axis\n",
            14 => "Acceleration:  peak -11024.7 mm/s/s at   0.02 sec     rms    719.0 mm/s/s\n",
            _ => "text\n",
        };
    }
    geonet += "0\n0\n0\n   65536     250     250      12      12      12\n0\n0\n0\n0\n0\n0\n";
    for _ in 0..3 {
        geonet += &("     1.5-11024.7".repeat(5) + "\n     2.0     3.0\n");
    }
    geonet.clone() + &geonet
}

fn peer() -> String {
    "PEER\nX, 01/02/03, Y, 090\nIN UNITS OF G\nNPTS=  40, DT= .005 SEC\n".to_string()
        + &" .1E-02 -.2E+01 .3D-1 4\n".repeat(10)
}

/// Time and acceleration, without the units.
fn two_columns() -> String {
    (0..40).map(|i| format!("{:.3} {}\n", 20.0 + 0.005 * f64::from(i), i % 7)).collect()
}

fn one_column() -> String {
    "# units = \"cm/s2\"\n# dt = \"0.01 s\"\n".to_string() + &"1\n-2.5\n3e1\n".repeat(15)
}

/// Words that break readers.
const POISON: &[&[u8]] = &[
    b"NaN",
    b"inf",
    b"-",
    b"1e308",
    b"-1e308",
    b"1e-320",
    b"99999999999999999999",
    b"18446744073709551615",
    b"-5",
    b"\xff\xfe",
    b"\0",
    b"\r",
    b"\n",
    b"\xc3\xa9",
    b"#",
    b"=",
    b"NPTS",
    b"DT",
    b"UNITS OF ",
    b"Component ",
    b" ",
    b",",
];

fn damaged(seed: &[u8], random: &mut Random) -> Vec<u8> {
    let mut bytes = seed.to_vec();
    for _ in 0..=random.below(4) {
        let at = random.below(bytes.len());
        match random.below(5) {
            0 => bytes.truncate(at),
            1 if !bytes.is_empty() => bytes[at] = random.next() as u8,
            2 => {
                let end = (at + random.below(40)).min(bytes.len());
                bytes.drain(at..end);
            }
            3 => {
                let poison = POISON[random.below(POISON.len())];
                let end = (at + poison.len()).min(bytes.len());
                bytes.splice(at..end, poison.iter().copied());
            }
            _ => {
                let end = (at + random.below(60)).min(bytes.len());
                let copy = bytes[at..end].to_vec();
                let to = random.below(bytes.len());
                bytes.splice(to..to, copy);
            }
        }
    }
    bytes
}

/// Everything a command would do with the channels of one file.
fn use_all(bytes: &[u8], options: &ReadOptions) -> bool {
    let Ok(channels) = read_bytes(Path::new("hostile"), bytes, options) else { return false };
    assert!(!channels.is_empty());
    for channel in &channels {
        assert!(channel.dt > 0.0 && channel.start.is_finite() && channel.end().is_finite());
        assert!(channel.acceleration.len() >= 2 && channel.acceleration.iter().all(|a| a.is_finite()));
        let _ = Intensity::of(channel);
        let _ = strongest_window(&[channel], 0.05);
        for step in [
            "detrend linear",
            "baseline polynomial 10",
            "pre-event 0.02 s",
            "taper 0.01 s",
            "bandpass 1 Hz 20 Hz",
            "scale 1e300",
            "pga 1e300 g",
        ] {
            let _ = process(&mut [&mut channel.clone()], &[Process::parse(step).unwrap()]);
        }
        let _ = channel.window(channel.start + 0.01, channel.start + 0.1);
    }
    let part = |i: usize| channels.get(i);
    if let Ok(ground) = Geographic::from_parts(part(0), part(1), part(2))
        && let Ok(motion) = Motion::from_acceleration(ground.dt, ground.model_axes(0.3))
    {
        let s = motion.at(0.5 * motion.duration());
        assert!(s.a.iter().all(|a| a.is_finite()));
    }
    let _ = Geographic::from_channels(&channels);
    true
}

#[test]
fn damaged_files_give_errors_or_sound_channels() {
    let declared = ReadOptions { units: Some(Units::G), dt: Some(0.01), ..ReadOptions::default() };
    let mut random = Random(2018);
    let (mut read, mut refused) = (0, 0);
    for seed in seeds() {
        for end in 0..seed.len() {
            use_all(&seed[..end], &ReadOptions::default());
        }
        for round in 0..2500 {
            let options = if round % 3 == 0 { declared.clone() } else { ReadOptions::default() };
            if use_all(&damaged(&seed, &mut random), &options) {
                read += 1;
            } else {
                refused += 1;
            }
        }
    }
    // The damage must neither spare everything nor break everything, or the test proves little.
    assert!(read > 500 && refused > 2000, "{read} read, {refused} refused");
}

#[test]
fn damaged_station_metadata_give_errors_or_sound_channels() {
    let (record, metadata) = (formats::sac::small(false), formats::sac::STATIONS.as_bytes());
    let mut random = Random(2019);
    let (mut read, mut refused) = (0, 0);
    for round in 0..4000 {
        // Every other time only digits, which leave the XML sound.
        let mut bytes = if round % 2 == 0 { damaged(metadata, &mut random) } else { metadata.to_vec() };
        let digits: Vec<usize> = (0..bytes.len()).filter(|i| bytes[*i].is_ascii_digit()).collect();
        for _ in 0..round % 2 * 2 {
            bytes[digits[random.below(digits.len())]] = b"0123456789-.e"[random.below(13)];
        }
        let stations = Stations::from_bytes(Path::new("hostile.xml"), &bytes);
        let stations = stations.ok().map(Arc::new);
        match stations
            .is_some_and(|s| use_all(&record, &ReadOptions { stations: Some(s), ..Default::default() }))
        {
            true => read += 1,
            false => refused += 1,
        }
    }
    assert!(read > 100 && refused > 1000, "{read} read, {refused} refused");
}

#[test]
fn undamaged_files_of_every_format_are_read() {
    let units = ReadOptions { units: Some(Units::G), ..ReadOptions::default() };
    for seed in seeds() {
        let plain = use_all(&seed, &ReadOptions::default());
        // Two columns of numbers alone do not say their units.
        assert!(plain || use_all(&seed, &units), "{}", String::from_utf8_lossy(&seed));
    }
}
