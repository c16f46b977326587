//! CSMNC (China Strong Motion Network Centre) records, `.dat`: one component a file.
//!
//! Some 16 lines of text, then the samples in rows, eight on a line. The text has `COMP. EW`, what was recorded with its unit
//! (`UNCORRECTED ACCELERATION UNIT: CM/SEC/SEC`), and `NO. OF POINTS: 1200 EQUALLY SPACED INTERVALS OF: 0.005 SEC`.
//! `RECORDER TIME` is Beijing's (BTM), 8 h ahead of UTC.

use super::header::Direction;
use super::source::{Source, leading_number, number};
use super::{ReadOptions, date};
use crate::{Channel, Error};

/// How far down the lines of text may reach.
const HEADER_LINES: usize = 40;
/// From UTC to Beijing's time (s).
const AHEAD: f64 = 8.0 * 3600.0;
const CORRUPT: &str = "fetch the file again";

/// The line that has a phrase, and what follows it.
fn after<'a>(source: &Source<'a>, phrase: &str) -> Option<(usize, &'a str)> {
    source.lines.iter().take(HEADER_LINES).enumerate().find_map(|(i, line)| {
        // Capitals of ASCII keep byte positions.
        let at = line.to_ascii_uppercase().find(phrase)? + phrase.len();
        Some((i, line[at..].trim_start_matches([' ', ':'])))
    })
}

pub(super) fn recognises(source: &Source) -> bool {
    after(source, "EQUALLY SPACED INTERVALS OF").is_some_and(|(i, _)| !source.lines[i].starts_with('#'))
        && after(source, "COMP.").is_some()
}

pub(super) fn read(source: &Source, options: &ReadOptions) -> Result<Vec<Channel>, Error> {
    let value = |phrase: &str| {
        after(source, phrase)
            .ok_or_else(|| source.error(0, format!("no line of the header has '{phrase}'"), CORRUPT))
    };
    let (points, text) = value("NO. OF POINTS")?;
    let count: usize = leading_number(text)
        .and_then(|n| n.parse().ok())
        .ok_or_else(|| source.error(points, "the number of points is missing", CORRUPT))?;
    let (line, text) = value("INTERVALS OF")?;
    let dt = leading_number(text)
        .and_then(number)
        .ok_or_else(|| source.error(line, "the sampling interval is missing", CORRUPT))?;
    let dt = source.stated_interval(line, dt, options.dt)?;
    let (line, unit) = value("UNIT:")?;
    let units = source.stated_units(line, unit, options.units)?;
    let (_, component) = value("COMP.")?;
    let direction = Direction::parse(component);
    let clock = after(source, "RECORDER TIME").and_then(|(_, text)| date::seconds(text.get(..23)?));

    // The line behind that of the points has the peak; samples are numbers alone.
    let is_row = |l: &str| !l.is_empty() && l.split_whitespace().all(|w| number(w).is_some());
    let begin =
        (points + 2..source.lines.len()).find(|i| is_row(source.lines[*i])).unwrap_or(source.lines.len());
    let mut values = Vec::new();
    for (line, text) in source.lines.iter().enumerate().skip(begin) {
        for word in text.split_whitespace() {
            values.push(source.number(line, word)?);
        }
    }
    if values.len() != count {
        return Err(source.error(points, format!("samples: {} ({count} stated)", values.len()), CORRUPT));
    }
    let channel = Channel { clock: clock.map(|c| c - AHEAD), ..source.channel(None, dt, values) };
    Ok(vec![source.converted(points, units, options, direction.given_to(channel))?])
}
