//! GeoNet (New Zealand) accelerograms: volume 1, uncorrected, `.V1A`, and volume 2, corrected, `.V2A`.
//!
//! A file holds up to three components. Each has 16 lines of text, 4 lines of ten integers and 6 of ten reals,
//! then acceleration, velocity and displacement, ten numbers a line; volume 1 has no points of the last two. Numbers stand
//! in columns of eight characters and may touch. Acceleration alone is taken. The text has the number of points, the interval
//! and the component's bearing. Units: volume 2 uses the unit of the header's peak, volume 1 states it with a factor,
//! `Raw readings in units of 1.00 mm/s/s  at intervals of 0.005 s`. The header's times count from another zero
//! than the first sample; here the first sample is at 0.

use super::ReadOptions;
use super::header::Direction;
use super::source::{Columns, Source, leading_number, number};
use crate::{Channel, Error};

const TEXT_LINES: usize = 16;
const HEADER_LINES: usize = TEXT_LINES + 4 + 6;
/// The line of the header, and the place on it, where the three numbers of points begin.
const COUNTS: (usize, usize) = (TEXT_LINES + 3, 3);
const COLUMNS: Columns = Columns { per_line: 10, width: 8 };
const BEGINNINGS: [&str; 2] = ["Corrected accelerogram", "Uncorrected accelerogram"];
const CORRUPT: &str = "fetch the file from GeoNet again";

pub(super) fn recognises(source: &Source) -> bool {
    let begins =
        source.lines.first().is_some_and(|l| BEGINNINGS.iter().any(|b| l.trim_start().starts_with(b)));
    begins && source.lines.iter().take(TEXT_LINES).any(|l| l.starts_with("Component "))
}

pub(super) fn read(source: &Source, options: &ReadOptions) -> Result<Vec<Channel>, Error> {
    let mut channels = Vec::new();
    let mut at = 0;
    while source.lines[at.min(source.lines.len())..].iter().any(|l| !l.is_empty()) {
        let (channel, next) = component(source, at, options)?;
        channels.push(channel);
        at = next;
    }
    Ok(channels)
}

/// Reads the component whose header begins at line index `at`, and tells where the next one begins.
fn component(source: &Source, at: usize, options: &ReadOptions) -> Result<(Channel, usize), Error> {
    if source.lines.len() < at + HEADER_LINES {
        return Err(source.error(at, "the header of a component is cut short", CORRUPT));
    }
    // What follows a phrase of the text header, and on which line.
    let after = |phrase: &str| {
        let text = source.lines[at..at + TEXT_LINES].iter().enumerate();
        text.filter_map(|(i, l)| Some((at + i, l.split_once(phrase)?.1)))
            .next()
            .ok_or_else(|| source.error(at, format!("no line of the header has '{phrase}'"), CORRUPT))
    };
    let (line, rest) = after("Number of points")?;
    let count: usize = leading_number(rest)
        .and_then(|w| w.parse().ok())
        .ok_or_else(|| source.error(line, "the number of points is missing", CORRUPT))?;
    let raw = source.lines[at].trim_start().starts_with(BEGINNINGS[1]);
    let (line, rest) = after(if raw { "at intervals of" } else { "data at" })?;
    let dt = leading_number(rest)
        .and_then(number)
        .ok_or_else(|| source.error(line, "the sampling interval is missing", CORRUPT))?;
    let dt = source.stated_interval(line, dt, options.dt)?;
    // 'peak -9733.1 mm/s/s at 44.88 sec', or '1.00 mm/s/s'
    let (line, rest) = after(if raw { "in units of" } else { "Acceleration:" })?;
    let mut words = rest.split_whitespace().skip(if raw { 0 } else { 1 });
    let factor = words.next().filter(|_| raw).map_or(Some(1.0), number).filter(|f| *f > 0.0);
    let factor = factor
        .ok_or_else(|| source.error(line, "the factor before the units is no number above 0", CORRUPT))?;
    let units = source.stated_units(line, words.next().unwrap_or(""), options.units)?;
    let (_, rest) = after("Component ")?;
    let label = rest.split_whitespace().next().unwrap_or("").to_string();
    let direction = Direction::parse(&label);

    let counts = (COUNTS.1..COUNTS.1 + 3).map(|i| {
        COLUMNS.word(source.lines[at + COUNTS.0], i).and_then(|w| w.parse::<usize>().ok()).ok_or_else(|| {
            source.error(at + COUNTS.0, "the numbers of points are not in their columns", CORRUPT)
        })
    });
    let counts = counts.collect::<Result<Vec<usize>, Error>>()?;
    if counts[0] != count {
        return Err(source.error(
            at + COUNTS.0,
            format!("the header has both {count} and {} points of acceleration", counts[0]),
            CORRUPT,
        ));
    }
    let begin = at + HEADER_LINES;
    // Counts are the file's word, so they must not overflow before they are compared with its length.
    let rows: Vec<usize> = counts.iter().map(|n| n.div_ceil(COLUMNS.per_line)).collect();
    let total = rows.iter().fold(0usize, |sum, n| sum.saturating_add(*n));
    if total > source.lines.len() - begin {
        return Err(source.error(
            source.lines.len(),
            format!("the file ends within component {label}: {total} lines of numbers were promised"),
            CORRUPT,
        ));
    }
    let (mut values, _) = source.block(begin, COLUMNS, count, CORRUPT)?;
    let mut remarks = Vec::new();
    if factor != 1.0 {
        values.iter_mut().for_each(|v| *v *= factor);
        remarks.push(format!("The header says that the numbers are in units of {factor} {units}."));
    }
    let channel = Channel { remarks, ..source.channel(Some(&label), dt, values) };
    let channel = source.converted(at, units, options, direction.given_to(channel))?;
    Ok((channel, begin + total))
}
