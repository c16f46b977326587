//! K-NET and KiK-net (NIED, Japan), the ASCII format, one component a file.
//!
//! 17 lines of header, whose values begin behind a key, then counts, eight a line. The header's scale factor makes them
//! cm/s² (`3920(gal)/6182761`). Counts have an offset, which stays in: take it off with `detrend`. `Max. Acc.` of the header
//! is meant without the mean.
//!
//! `Dir.` is `N-S`, `E-W`, `U-D`, positive to the north, east and up, or a KiK-net channel: 1 to 3 are N-S, E-W, U-D of
//! the sensor in the borehole, 4 to 6 of that at the surface.
//!
//! By NIED's manual of the format the recorder's delay makes `Record Time` 15 s later than the first sample, and it is
//! Japanese time, 9 h ahead of UTC. The clock has both taken off; components keep their places to each other either way.

use super::ReadOptions;
use super::date;
use super::source::{Source, leading_number, number};
use crate::shown::shown;
use crate::{Channel, Error, Orientation};

const HEADER_LINES: usize = 17;
/// From UTC to Japanese time, and from the first sample to the record time (s).
const AHEAD: f64 = 9.0 * 3600.0 + 15.0;
const CORRUPT: &str = "fetch the file from NIED again";

pub(super) fn recognises(source: &Source) -> bool {
    let header = source.lines.iter().take(HEADER_LINES);
    source.lines[0].starts_with("Origin Time") && header.clone().any(|l| l.starts_with("Station Code"))
}

pub(super) fn read(source: &Source, options: &ReadOptions) -> Result<Vec<Channel>, Error> {
    let value = |key: &str| {
        let header = source.lines.iter().take(HEADER_LINES).enumerate();
        header
            .filter_map(|(i, l)| Some((i, l.strip_prefix(key)?.trim())))
            .next()
            .ok_or_else(|| source.error(0, format!("no line of the header begins with '{key}'"), CORRUPT))
    };
    if !source.lines.get(HEADER_LINES - 1).is_some_and(|l| l.starts_with("Memo")) {
        return Err(source.error(
            HEADER_LINES - 1,
            "the 17th line, 'Memo.', is not where it belongs",
            CORRUPT,
        ));
    }
    let positive = |key: &str| {
        let (line, text) = value(key)?;
        let number = leading_number(text).and_then(number).filter(|n| *n > 0.0);
        number
            .map(|n| (line, n))
            .ok_or_else(|| source.error(line, format!("'{}' is no number above 0", shown(text)), CORRUPT))
    };
    let (line, frequency) = positive("Sampling Freq(Hz)")?;
    let dt = source.stated_interval(line, 1.0 / frequency, options.dt)?;
    let (_, duration) = positive("Duration Time(s)")?;
    let (line, text) = value("Scale Factor")?;
    let (scale, unit) = scale(text).ok_or_else(|| {
        source.error(line, format!("'{}' is no scale such as 3920(gal)/6182761", shown(text)), CORRUPT)
    })?;
    let units = source.stated_units(line, unit, options.units)?;
    let (line, text) = value("Record Time")?;
    let time = date::seconds(text)
        .ok_or_else(|| source.error(line, format!("'{}' is no date and time", shown(text)), CORRUPT))?;
    let (line, text) = value("Dir.")?;
    let (orientation, label) = direction(text).ok_or_else(|| {
        let problem = format!("'{}' is none of N-S, E-W, U-D and 1 to 6", shown(text));
        source.error(line, problem, CORRUPT)
    })?;

    let mut counts = Vec::new();
    for (line, text) in source.lines.iter().enumerate().skip(HEADER_LINES) {
        for word in text.split_whitespace() {
            counts.push(source.number(line, word)? * scale);
        }
    }
    let promised = (frequency * duration).round();
    if counts.len() as f64 != promised {
        return Err(source.error(
            source.lines.len(),
            format!(
                "the file has {} samples, but {frequency} Hz over {duration} s make {promised}",
                counts.len()
            ),
            CORRUPT,
        ));
    }
    let mut channel = Channel {
        orientation: Some(orientation),
        clock: Some(time - AHEAD),
        ..source.channel(Some(label), dt, counts)
    };
    if label.ends_with('1') {
        channel.remarks.push(format!(
            "a sensor in the borehole (Dir. {text}): its motion is that within the ground, not of an outcrop; in a case it is \
             kind = \"within\", with the sensor's depth below ground as depth"
        ));
    }
    Ok(vec![source.converted(line, units, options, channel)?])
}

/// What a count is in the unit named with it, from `3920(gal)/6182761`.
fn scale(text: &str) -> Option<(f64, &str)> {
    let (above, below) = text.split_once('/')?;
    let (above, unit) = above.trim().strip_suffix(')')?.split_once('(')?;
    let scale = number(above)? / number(below)?;
    (scale > 0.0 && scale.is_finite()).then_some((scale, unit))
}

/// Positive direction, and how NIED ends the name of such a component's file: with 1 if the sensor is in a borehole.
fn direction(text: &str) -> Option<(Orientation, &'static str)> {
    match text {
        "N-S" => Some((Orientation::NORTH, "NS")),
        "E-W" => Some((Orientation::EAST, "EW")),
        "U-D" => Some((Orientation::Up, "UD")),
        "1" => Some((Orientation::NORTH, "NS1")),
        "2" => Some((Orientation::EAST, "EW1")),
        "3" => Some((Orientation::Up, "UD1")),
        "4" => Some((Orientation::NORTH, "NS2")),
        "5" => Some((Orientation::EAST, "EW2")),
        "6" => Some((Orientation::Up, "UD2")),
        _ => None,
    }
}
