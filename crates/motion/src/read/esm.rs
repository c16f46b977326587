//! ESM and ITACA files in the format DYNA 1.x: one component a file.
//!
//! Lines of header, `KEY: value`, up to `USER5:` (the 64th in DYNA 1.2), then one number a line. `STREAM` is the channel's
//! code, whose last letter gives the direction, positive to the north, east and up. Files of velocity, displacement and
//! spectra have the same header and are refused by `DATA_TYPE`.

use super::ReadOptions;
use super::date;
use super::source::{Source, number};
use crate::shown::shown;
use crate::{Channel, Error, Orientation};

/// How far down the header may reach; DYNA 1.2 has 64 lines.
const HEADER_LINES: usize = 100;
const LAST_KEY: &str = "USER5:";
const CORRUPT: &str = "fetch the file from ESM again";

pub(super) fn recognises(source: &Source) -> bool {
    let header = || source.lines.iter().take(HEADER_LINES);
    source.lines[0].starts_with("EVENT_NAME:") && header().any(|l| l.starts_with("NDATA:"))
}

pub(super) fn read(source: &Source, options: &ReadOptions) -> Result<Vec<Channel>, Error> {
    let header = source.lines.iter().take(HEADER_LINES).position(|l| l.starts_with(LAST_KEY));
    let Some(last) = header else {
        return Err(source.error(
            source.lines.len().min(HEADER_LINES),
            format!("the header does not end: no line begins with '{LAST_KEY}'"),
            CORRUPT,
        ));
    };
    let value = |key: &str| {
        let header = source.lines[..=last].iter().enumerate();
        header
            .filter_map(|(i, l)| Some((i, l.strip_prefix(key)?.strip_prefix(':')?.trim())))
            .next()
            .ok_or_else(|| source.error(last, format!("no line of the header begins with '{key}:'"), CORRUPT))
    };
    let (line, kind) = value("DATA_TYPE")?;
    if kind != "ACCELERATION" {
        return Err(source.error(
            line,
            format!("the file holds '{}', not ACCELERATION", shown(kind)),
            "give the file of acceleration of this component (its name has .ACC.)",
        ));
    }
    let (line, text) = value("SAMPLING_INTERVAL_S")?;
    let dt = number(text).ok_or_else(|| source.error(line, "the sampling interval is missing", CORRUPT))?;
    let dt = source.stated_interval(line, dt, options.dt)?;
    let (counts_line, text) = value("NDATA")?;
    let count: usize = text.parse().map_err(|_| {
        source.error(counts_line, format!("'{}' is no number of samples", shown(text)), CORRUPT)
    })?;
    let (line, word) = value("UNITS")?;
    let units = source.stated_units(line, word, options.units)?;
    let (line, time) = value("DATE_TIME_FIRST_SAMPLE_YYYYMMDD_HHMMSS")?;
    let clock = date::seconds(time);
    // Analogue records have no time of the first sample.
    if clock.is_none() && !time.is_empty() {
        return Err(source.error(line, format!("'{}' is no date and time", shown(time)), CORRUPT));
    }
    let (_, stream) = value("STREAM")?;
    let orientation = Orientation::of_channel_code(stream);

    let mut values = Vec::new();
    for (line, word) in source.lines.iter().enumerate().skip(last + 1).filter(|(_, l)| !l.trim().is_empty()) {
        values.push(source.number(line, word.trim())?);
    }
    if values.len() != count {
        return Err(source.error(
            source.lines.len(),
            format!("the file has {} samples, but NDATA is {count}", values.len()),
            CORRUPT,
        ));
    }
    let channel = Channel { orientation, clock, ..source.channel(None, dt, values) };
    Ok(vec![source.converted(counts_line, units, options, channel)?])
}
