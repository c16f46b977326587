//! SAC, binary, header versions 6 and 7, in either byte order: one component a file.
//!
//! A header of 70 floats, 40 integers and 192 characters (632 bytes), then the samples as floats. SAC does not state the unit of
//! an acceleration reliably (the manual has nm/s², programs write what they have), so it must be declared, or the sensitivity where the
//! samples are counts. `CMPINC` (0 up, 90 horizontal, 180 down) and `CMPAZ` give the direction, or else the channel's code.

use super::header::Direction;
use super::mseed;
use super::source::Source;
use super::{ReadOptions, date};
use crate::{Channel, Error, Orientation, Units};

const HEADER: usize = 632;
const VERSION: usize = 76;
const UNDEFINED: f64 = -12345.0;

/// Words of the header in the file's byte order.
struct Header<'a> {
    bytes: &'a [u8],
    big: bool,
}

impl<'a> Header<'a> {
    /// None for what is no such file.
    fn new(bytes: &'a [u8]) -> Option<Header<'a>> {
        let sound = |big: &bool| {
            let header = Header { bytes, big: *big };
            matches!(header.integer(VERSION), 6 | 7) && header.integer(79) > 0
        };
        let big = [false, true].into_iter().find(|big| bytes.len() >= HEADER && sound(big))?;
        Some(Header { bytes, big })
    }

    fn word(&self, i: usize) -> [u8; 4] {
        // The header's length was compared.
        self.bytes.get(4 * i..4 * i + 4).and_then(|w| w.try_into().ok()).unwrap_or_default()
    }

    fn integer(&self, i: usize) -> i32 {
        let word = self.word(i);
        if self.big { i32::from_be_bytes(word) } else { i32::from_le_bytes(word) }
    }

    fn float(&self, i: usize) -> f64 {
        let word = self.word(i);
        f64::from(if self.big { f32::from_be_bytes(word) } else { f32::from_le_bytes(word) })
    }

    /// A float, unless undefined.
    fn given(&self, i: usize) -> Option<f64> {
        Some(self.float(i)).filter(|v| *v != UNDEFINED && v.is_finite())
    }

    /// Eight characters from a word on, unless undefined.
    fn text(&self, i: usize) -> String {
        let bytes = self.bytes.get(4 * i..4 * i + 8).unwrap_or_default();
        let text: String =
            bytes.iter().take_while(|b| b.is_ascii_graphic()).map(|b| char::from(*b)).collect();
        if text == "-12345" { String::new() } else { text }
    }
}

pub(super) fn recognises(source: &Source) -> bool {
    Header::new(source.bytes).is_some()
}

pub(super) fn read(source: &Source, options: &ReadOptions) -> Result<Vec<Channel>, Error> {
    let fault =
        |byte: usize, problem: String, remedy: &str| Error::binary(source.file, byte, problem, remedy);
    let Some(header) = Header::new(source.bytes) else {
        return Err(fault(0, "this is no SAC file".into(), "fetch the file again"));
    };
    let quantity = match header.integer(86) {
        6 => "displacement",
        7 => "velocity",
        _ => "",
    };
    if !quantity.is_empty() {
        return Err(fault(
            4 * 86,
            format!("the file holds {quantity} (IDEP)"),
            "give a record of acceleration",
        ));
    }
    if header.integer(85) != 1 || header.integer(105) != 1 {
        let problem = "the file is no equally spaced time series (IFTYPE, LEVEN)".into();
        return Err(fault(4 * 85, problem, "resample it, and write it as a time series"));
    }
    // Above 0, as recognised.
    let count = usize::try_from(header.integer(79)).unwrap_or(0);
    let end = HEADER + 4 * count;
    if source.bytes.len() < end {
        let there = (source.bytes.len() - HEADER) / 4;
        return Err(fault(4 * 79, format!("samples: {there} ({count} stated)"), "fetch the file again"));
    }
    let code = header.text(150);
    let name = [152, 110, 116].map(|i| header.text(i)).join(".") + "." + &code;
    // Of single precision: 0.005 is not 0.004999999888.
    let dt: f64 = (header.float(0) as f32).to_string().parse().unwrap_or(0.0);
    let dt = source.stated_interval(0, dt, options.dt).map_err(|e| e.at_byte(0))?;
    let start = header.given(5).unwrap_or(0.0);
    let time = [70, 71, 72, 73, 74, 75].map(|i| i64::from(header.integer(i)));
    let clock = date::midnight(time[0], time[1]).map(|midnight| {
        let seconds = time[2] * 3600 + time[3] * 60 + time[4];
        midnight as f64 / 1e9 + seconds as f64 + time[5] as f64 / 1e3 + start
    });

    let mut remarks = Vec::new();
    let mut stated = None;
    let options = match &options.stations {
        Some(stations) => {
            let begin = clock.ok_or_else(|| {
                fault(
                    280,
                    "the file states no time, by which StationXML has its epochs".into(),
                    "declare the number alone: sensitivity = \"427336 counts/(m/s2)\"",
                )
            })?;
            let epoch = stations.epoch(&name, begin, begin + dt * (count - 1) as f64);
            let epoch = epoch.map_err(|(problem, remedy)| fault(608, problem, &remedy))?;
            remarks.extend(epoch.remarks());
            stated = epoch.direction;
            &ReadOptions { sensitivity: Some(epoch.sensitivity), ..options.clone() }
        }
        None => options,
    };
    let units = match (options.units, options.sensitivity) {
        (Some(units), _) => units,
        (None, Some(_)) => Units::Counts,
        (None, None) => {
            return Err(fault(
                4 * 86,
                "SAC does not state the unit of the samples".into(),
                "declare it, for example units = \"cm/s2\" (--units cm/s2), or the sensitivity of counts",
            ));
        }
    };
    if units == Units::Counts && !code.is_empty() {
        mseed::units(source, 600, &name, true, options)?;
    }
    if let Some(scale) = header.given(3).filter(|s| *s != 1.0) {
        remarks.push(format!("The header's factor SCALE is {scale}; it was not applied."));
    }
    let values = source.bytes[HEADER..end].chunks_exact(4).map(|word| {
        // Chunks of four.
        let word: [u8; 4] = word.try_into().unwrap_or_default();
        f64::from(if header.big { f32::from_be_bytes(word) } else { f32::from_le_bytes(word) })
    });
    let values: Vec<f64> = values.collect();
    if let Some(i) = values.iter().position(|v| !v.is_finite()) {
        return Err(fault(HEADER + 4 * i, format!("sample {} is not finite", i + 1), "correct the value"));
    }
    let direction = match (header.given(58), header.given(57)) {
        (Some(0.0), _) => Direction::Along(Orientation::Up),
        (Some(180.0), _) => Direction::Down,
        (Some(90.0), Some(azimuth)) => Direction::Along(Orientation::from_degrees(azimuth)),
        (Some(_), _) => Direction::Unknown,
        (None, _) => Orientation::of_channel_code(&code).map_or(Direction::Unknown, Direction::Along),
    };
    let other_sensor = units == Units::Counts && !code.is_empty() && !mseed::accelerates(&name);
    let channel = Channel { start, clock, other_sensor, remarks, ..source.channel(None, dt, values) };
    let channel = source
        .converted(0, units, options, stated.unwrap_or(direction).given_to(channel))
        .map_err(|e| e.at_byte(0))?;
    Ok(vec![channel])
}
