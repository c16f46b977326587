//! Channels of miniSEED, versions 2 and 3. The small files are written by the crate miniseed-rs, which shares no code with
//! the reader.

use miniseed_rs::{EncodingFormat, MseedRecord, NanoTime, Samples, encode};
use tremolite_motion::{Geographic, Orientation, ReadOptions, Units};

use super::{Figures, compared, one, parse, refusal};

/// 2019-07-06 03:19:53.04 UTC (date -u -d '2019-07-06 03:19:53' +%s).
pub(super) const BEGIN: f64 = 1_562_383_193.04;
pub(super) const INTS: EncodingFormat = EncodingFormat::Int32;

/// A record at 100 Hz that begins so many samples behind [`BEGIN`].
pub(super) fn built(
    version: u8,
    channel: &str,
    late: u32,
    encoding: EncodingFormat,
    samples: Samples,
) -> MseedRecord {
    let fresh = if version == 2 { MseedRecord::new().with_record_length(128) } else { MseedRecord::new_v3() };
    let ticks = 304 + late;
    let time = NanoTime {
        year: 2019,
        day: 187,
        hour: 3,
        minute: 19,
        second: 50 + u8::try_from(ticks / 100).unwrap(),
        nanosecond: ticks % 100 * 10_000_000,
    };
    fresh
        .with_nslc("CI", "CLC", "", channel)
        .with_start_time(time)
        .with_sample_rate(100.0)
        .with_encoding(encoding)
        .with_samples(samples)
}

pub(super) fn record(
    version: u8,
    channel: &str,
    late: u32,
    encoding: EncodingFormat,
    samples: Samples,
) -> Vec<u8> {
    encode(&built(version, channel, late, encoding, samples)).unwrap()
}

pub(super) fn ints(version: u8, channel: &str, late: u32, samples: &[i32]) -> Vec<u8> {
    record(version, channel, late, INTS, Samples::Int(samples.to_vec()))
}

/// Files small enough to be damaged many times.
pub fn small() -> Vec<Vec<u8>> {
    let wave = Samples::Int((0..18).map(|i| [0, 40, -300, 7000][i % 4] + i as i32).collect());
    let floats = Samples::Float(vec![0.5, -0.25, 1.0, 2.0]);
    vec![
        [
            record(2, "HNE", 0, EncodingFormat::Steim2, wave.clone()),
            record(2, "HNE", 18, EncodingFormat::Steim1, wave.clone()),
            ints(2, "HNZ", 0, &[1, -2, 3]),
        ]
        .concat(),
        [
            record(3, "HNN", 0, EncodingFormat::Steim2, wave),
            record(3, "HNN", 18, EncodingFormat::Float32, floats),
        ]
        .concat(),
    ]
}

pub(super) fn none() -> ReadOptions {
    ReadOptions::default()
}

fn sensitive() -> ReadOptions {
    ReadOptions { sensitivity: "1000 counts/(m/s2)".parse().ok(), ..none() }
}

#[test]
fn counts_become_acceleration_by_a_sensitivity_only() {
    let file = ints(2, "HNE", 0, &[1000, -2500, 0]);
    let channel = one(&file, &sensitive());
    assert_eq!((channel.acceleration.as_slice(), channel.raw), (&[1.0, -2.5, 0.0][..], false));
    assert_eq!((channel.units, channel.name.as_str()), (Units::Counts, "small"));
    assert!(channel.remarks.is_empty());
    let declared = |units| ReadOptions { units: Some(units), ..none() };
    assert!(one(&file, &declared(Units::Counts)).raw);
    assert!(refusal(&file, &declared(Units::G)).contains("whole numbers, which are counts"));
    let floats = record(3, "HNE", 0, EncodingFormat::Float32, Samples::Float(vec![0.5, -1.0]));
    assert!(one(&floats, &none()).raw);
    let channel = one(&floats, &declared(Units::CentimetrePerSecond2));
    assert_eq!((channel.acceleration.as_slice(), channel.raw), (&[0.005, -0.01][..], false));
    let both = ReadOptions { sensitivity: sensitive().sensitivity, ..declared(Units::G) };
    assert!(refusal(&floats, &both).contains("byte 0: a sensitivity was declared, but the file is in g"));
}

#[test]
fn channels_of_no_accelerometer_stay_counts_whatever_is_declared() {
    for (code, remark) in
        [("HHE", "velocity"), ("BLZ", "velocity"), ("EPZ", "velocity"), ("LDO", "not of an")]
    {
        let file = ints(2, code, 0, &[1, 2]);
        let channel = one(&file, &none());
        assert!(
            channel.raw && channel.remarks.iter().any(|r| r.contains(remark)),
            "{code}: {:?}",
            channel.remarks
        );
        assert!(channel.other_sensor && channel.window(0.0, 1.0).unwrap().other_sensor);
        // It is no use to ask for a sensitivity.
        let refused = Geographic::from_parts(Some(&channel), None, None).unwrap_err().to_string();
        assert!(refused.contains("does not record acceleration") && !refused.contains("counts"), "{refused}");
        let floats = record(3, code, 0, EncodingFormat::Float32, Samples::Float(vec![0.5, -1.0]));
        assert!(one(&floats, &none()).other_sensor);
        let declared = ReadOptions { units: Some(Units::G), ..none() };
        assert!(!one(&floats, &declared).other_sensor, "another program made acceleration of it");
        let message = refusal(&file, &sensitive());
        assert!(message.contains(&format!("channel CI.CLC..{code} is not of an accelerometer")), "{message}");
        assert!(message.contains("second letter is N"), "{message}");
    }
    let old = one(ints(2, "HGE", 0, &[1, 2]), &sensitive());
    assert!(!old.raw && !old.other_sensor && !one(ints(2, "HNE", 0, &[1, 2]), &none()).other_sensor);
    assert!(old.remarks[0].contains("gravimeter"));
    // Beside an accelerometer's channel as well.
    let mixed = [ints(2, "HNE", 0, &[1, 2]), ints(2, "HHE", 0, &[1, 2])].concat();
    assert!(refusal(mixed, &sensitive()).contains("byte 128: channel CI.CLC..HHE"));
}

#[test]
fn channels_are_told_apart_and_records_are_joined_in_time() {
    for version in [2, 3] {
        let records = [
            ints(version, "HNZ", 4, &[30, 31]),
            ints(version, "HNE", 3, &[4, 5]),
            ints(version, "HN1", 0, &[-1, -2]),
            ints(version, "HNE", 0, &[1, 2, 3]),
            ints(version, "HNE", 5, &[6]),
        ];
        let channels = parse(records.concat(), &none()).unwrap();
        let names: Vec<&str> = channels.iter().map(|c| c.name.as_str()).collect();
        assert_eq!(names, ["small CI.CLC..HN1", "small CI.CLC..HNE", "small CI.CLC..HNZ"]);
        assert_eq!(channels[1].acceleration, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
        assert!(channels[1].remarks[0].contains("order of time") && channels[0].remarks.is_empty());
        assert!(channels[1].start == 0.0 && (channels[2].start - 0.04).abs() < 1e-9);
        assert!((channels[2].clock.unwrap() - BEGIN - 0.04).abs() < 1e-6);
        let directions = channels.iter().map(|c| c.orientation).collect::<Vec<_>>();
        assert_eq!(directions, [None, Some(Orientation::EAST), Some(Orientation::Up)]);
    }
}

#[test]
fn gaps_and_overlaps_of_more_than_half_a_sample_are_refused_with_both_times() {
    let first = ints(2, "HNE", 0, &[1, 2, 3]);
    let gap = refusal([first.clone(), ints(2, "HNE", 104, &[4, 5])].concat(), &none());
    for part in [
        "small, byte 128: channel CI.CLC..HNE has a gap of 1.010000 s",
        "ends at 2019-07-06T03:19:53.0700Z",
        "begins at 2019-07-06T03:19:54.0800Z",
        "cut the record to one side",
    ] {
        assert!(gap.contains(part), "{gap}");
    }
    let overlap = refusal([first.clone(), ints(2, "HNE", 2, &[3, 4])].concat(), &none());
    assert!(overlap.contains("an overlap of 0.010000 s"), "{overlap}");
    // The fraction of the second (0.1 ms) of the next record: 4.9 ms late, then 5.1 ms.
    let late = |fraction: u16| {
        let mut next = ints(2, "HNE", 3, &[4, 5]);
        next[28..30].copy_from_slice(&fraction.to_be_bytes());
        parse([first.clone(), next].concat(), &none())
    };
    assert_eq!(late(749).unwrap()[0].acceleration.len(), 5);
    assert!(late(751).is_err());
    let mut other = built(2, "HNE", 3, INTS, Samples::Int(vec![4]));
    other.sample_rate = 50.0;
    let message = refusal([first, encode(&other).unwrap()].concat(), &none());
    assert!(message.contains("changes its interval from 0.01 s to 0.02 s"), "{message}");
}

#[test]
fn small_shifts_that_add_up_are_told() {
    // Each record is 0.4 of an interval late; after three of them that is more than one sample.
    let shifted = (0..4u16).flat_map(|i| {
        let mut record = ints(2, "HNE", 0, &[1, 2, 3]);
        record[28..30].copy_from_slice(&(400 + 340 * i).to_be_bytes());
        record
    });
    let remarks = one(shifted.collect::<Vec<u8>>(), &none()).remarks;
    assert!(remarks[0].contains("0.012000 s longer than its samples"), "{remarks:?}");
}

/// The figures are ObsPy's (1.5.1, which reads by libmseed).
#[test]
fn a_real_record_has_the_figures_of_an_independent_reading() {
    let figures = Figures {
        file: "mseed/BK.CVS..BHE.mseed",
        npts: 20400,
        dt: 0.025,
        peak: (39571.0, 5961),
        about_mean: (40827.91009803922, 5961),
        ends: (-1274.0, -1121.0),
    };
    let Some(channel) = compared(&figures) else { return };
    assert_eq!((channel.orientation, channel.raw), (Some(Orientation::EAST), true));
    assert!((channel.clock.unwrap() - 1_200_784_295.437463).abs() < 1e-6);
    assert!(channel.remarks.iter().any(|r| r.contains("velocity")), "{:?}", channel.remarks);
}
