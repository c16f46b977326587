//! SMC files of the US Geological Survey.
//!
//! A trace has 11 lines of text, 48 integers (`8I10`), 50 reals (`5E15.7`), lines of comment that begin with `|`, and numbers
//! in eight columns of 10, or five of 14 where integer 47 is defined, which may touch. The first line says what the numbers
//! are; accelerations are in cm/s².
//!
//! From the headers, counted from 1 as the documentation does:
//! - integer 1 and real 1: what stands for an unknown value;
//! - integer 13, 14: angle from the vertical (0 up, 90 horizontal, 180 down) and azimuth; 16: lines of comment; 17: how many
//!   numbers there are;
//! - real 2: samples a second. An uncorrected trace without it holds pairs of time and acceleration, which `pairs.rs` brings
//!   to equal intervals; then integer 17 counts times and accelerations together.
//!
//! Files hold one trace; several that were put one behind the other are read as several channels.

use super::ReadOptions;
use super::header::{Direction, named_apart};
use super::pairs;
use super::source::{Columns, Source, number};
use crate::{Channel, Error, Orientation};

const TEXT_LINES: usize = 11;
const INTEGERS: Columns = Columns { per_line: 8, width: 10 };
const REALS: Columns = Columns { per_line: 5, width: 15 };
const NUMBERS: Columns = Columns { per_line: 8, width: 10 };
/// Of the programs that write SMC files with more figures; they set integer 47.
const MORE_FIGURES: Columns = Columns { per_line: 5, width: 14 };
/// Integers and reals of the header.
const COUNTS: [usize; 2] = [48, 50];
const HEADER_LINES: usize = TEXT_LINES + COUNTS[0] / 8 + COUNTS[1] / 5;
/// Rates above this (1/s) stand in some headers and mean nothing.
const HIGHEST_RATE: f64 = 1e5;
const CORRUPT: &str = "fetch the file again";

/// What the first line of a trace may say, and what it is if it is not read.
const KINDS: [(&str, &str); 8] = [
    ("1 UNCORRECTED ACCELEROGRAM", ""),
    ("2 CORRECTED ACCELEROGRAM", ""),
    ("3 VELOCITY", "velocity"),
    ("4 DISPLACEMENT", "displacement"),
    ("5 RESPONSE SPECTR", "response spectra"),
    ("6 FOURIER", "a Fourier spectrum"),
    ("0 UNKNOWN", "what the first line does not say"),
    ("*", "what the first line does not say"),
];

/// The kind of a trace that begins at line index `at`: the first line, and a `*` in place of one of the ten texts behind it,
/// as every trace has some.
fn kind(source: &Source, at: usize) -> Option<usize> {
    let first = source.lines.get(at)?.trim();
    let kind = KINDS.iter().position(|(name, _)| {
        first.get(..name.len()).is_some_and(|f| f.eq_ignore_ascii_case(name))
            && (*name != "*" || first == "*")
    })?;
    let text = source.lines.get(at + 1..at + TEXT_LINES)?;
    let integers = source.lines.get(at + TEXT_LINES)?;
    let is_integer = |i| INTEGERS.word(integers, i).is_some_and(|w| w.parse::<i64>().is_ok());
    (text.iter().any(|l| l.trim() == "*") && (0..INTEGERS.per_line).all(is_integer)).then_some(kind)
}

pub(super) fn recognises(source: &Source) -> bool {
    // A first line with a number is SMC even if the header is broken, so that the fault is named.
    let first = source.lines.first().map_or("", |l| l.trim_start());
    kind(source, 0).is_some()
        || KINDS[..2]
            .iter()
            .any(|(name, _)| first.get(..name.len()).is_some_and(|f| f.eq_ignore_ascii_case(name)))
}

pub(super) fn read(source: &Source, options: &ReadOptions) -> Result<Vec<Channel>, Error> {
    let mut channels = Vec::new();
    let mut at = 0;
    while at < source.lines.len() {
        let begins = (at + HEADER_LINES..source.lines.len()).find(|i| kind(source, *i).is_some());
        let end = begins.unwrap_or(source.lines.len());
        channels.push(trace(source, at, end, options)?);
        at = end;
    }
    named_apart(&mut channels);
    Ok(channels)
}

/// How many columns of a line there are, if all hold numbers.
fn numbers_of(line: &str, of: Columns) -> Option<usize> {
    let columns = line.len() / of.width;
    let all = (0..columns).all(|i| of.word(line, i).is_some_and(|w| number(w).is_some()));
    (all && columns > 0).then_some(columns)
}

/// Reads the trace in the lines `at..end`.
fn trace(source: &Source, at: usize, end: usize, options: &ReadOptions) -> Result<Channel, Error> {
    let name = KINDS[kind(source, at).unwrap_or(0)].1;
    if !name.is_empty() {
        return Err(source.error(
            at,
            format!("the trace is {name}"),
            "give a trace of acceleration, '1 UNCORRECTED ACCELEROGRAM' or '2 CORRECTED ACCELEROGRAM' in its first line",
        ));
    }
    let uncorrected = source.lines[at].trim_start().starts_with('1');
    let (integers, next) = source.block(at + TEXT_LINES, INTEGERS, COUNTS[0], CORRUPT)?;
    let (reals, next) = source.block(next, REALS, COUNTS[1], CORRUPT)?;
    // Both blocks have the numbers that are taken from them here.
    let integer = |i: usize| Some(integers[i - 1]).filter(|v| *v != integers[0]);
    let count = |i: usize| {
        // Fits: integers have ten characters, and what is negative or no integer becomes another number than it was.
        integer(i).map(|v| (v, v as usize)).filter(|(v, n)| *n as f64 == *v).map(|(_, n)| n).ok_or_else(
            || {
                let what = if i == 16 { "lines of comment" } else { "numbers" };
                source.error(
                    at + TEXT_LINES + (i - 1) / 8,
                    format!("the number of {what} (integer {i}) is unknown"),
                    CORRUPT,
                )
            },
        )
    };
    let columns = if integer(47).is_some() { MORE_FIGURES } else { NUMBERS };
    let (comments, count) = (count(16)?, count(17)?);
    let begin = next.saturating_add(comments);
    let lines = source.lines[..end].get(begin..).unwrap_or(&[]);
    if let Some(i) = source.lines[..begin.min(end)].iter().skip(next).position(|l| !l.starts_with('|')) {
        return Err(source.error(
            next + i,
            format!("{comments} lines of comment were promised, but this one does not begin with '|'"),
            CORRUPT,
        ));
    }
    let units = source.stated_units(at, "cm/s2", options.units)?;
    let rate = Some(reals[1]).filter(|r| *r != reals[0] && *r > 0.0 && *r < HIGHEST_RATE);
    // Of pairs, integer 17 counts the numbers; a file with twice as many counted the pairs.
    let there: usize = lines.iter().map_while(|l| numbers_of(l, columns)).sum();
    let doubled = uncorrected && rate.is_none() && there == count.saturating_mul(2);
    let count = if doubled { 2 * count } else { count };
    if count.div_ceil(columns.per_line) > lines.len() || begin > end {
        return Err(source.error(
            end.saturating_sub(1),
            format!("the trace ends before the {count} numbers that were promised"),
            CORRUPT,
        ));
    }
    let (numbers, next) = source.block(begin, columns, count, CORRUPT)?;
    let mut remarks = Vec::new();
    // Some files have whole lines of numbers behind those that were counted.
    let more = source.lines[next..end].iter().filter_map(|l| numbers_of(l, columns)).count();
    if more > 0 {
        remarks.push(format!(
            "Behind the {count} numbers that the header counts, {more} line(s) of numbers were left out."
        ));
    }
    let (start, dt, values) = match rate.map(|r| 1.0 / r).or(options.dt.filter(|_| !uncorrected)) {
        Some(dt) => (0.0, source.stated_interval(at + TEXT_LINES, dt, options.dt)?, numbers),
        None if uncorrected && count % 2 == 1 => {
            return Err(source.error(
                at + TEXT_LINES + 2,
                format!(
                    "the trace has no sampling rate, so it holds pairs, but {count} numbers (integer 17)"
                ),
                CORRUPT,
            ));
        }
        None if uncorrected => {
            let line = |i: usize| begin + 2 * i / columns.per_line;
            let even = pairs::equal_intervals(source, &numbers, line, options.dt)?;
            remarks.push(even.remark);
            (even.start, even.dt, even.values)
        }
        None => {
            return Err(source.error(
                at + TEXT_LINES + COUNTS[0] / 8,
                "the samples a second (real 2) are not stated",
                "declare the interval, for example dt = \"0.005 s\"",
            ));
        }
    };
    let azimuth = integer(14).filter(|a| (0.0..=360.0).contains(a));
    let text = source.lines[at..at + TEXT_LINES].iter().find_map(|l| Some(l.split_once("component=")?.1));
    let text = Direction::parse(text.and_then(|t| t.split_whitespace().next()).unwrap_or(""));
    let horizontal = |azimuth: f64| Direction::parse(&azimuth.to_string());
    let direction = match (integer(13), azimuth) {
        (Some(0.0), _) => Direction::parse("UP"),
        (Some(180.0), _) => Direction::Down,
        (Some(90.0), Some(azimuth)) => horizontal(azimuth),
        // Without the angle from the vertical an azimuth of 0 may be that of a vertical component.
        (None, Some(azimuth))
            if text == horizontal(azimuth) || (text == Direction::Unknown && azimuth > 0.0) =>
        {
            remarks.push(format!(
                "The header gives no angle from the vertical (integer 13); the azimuth of {azimuth} deg (integer 14) was taken."
            ));
            horizontal(azimuth)
        }
        (None, None | Some(0.0)) => text,
        (None, Some(azimuth)) => {
            remarks.push(format!(
                "The azimuth of {azimuth} deg (integer 14) contradicts the component in words; neither was taken."
            ));
            Direction::Unknown
        }
        _ => Direction::Unknown,
    };
    let label = match (direction, azimuth) {
        (Direction::Along(Orientation::Azimuth(_)), Some(azimuth)) => Some(format!("{azimuth} deg")),
        (Direction::Along(Orientation::Azimuth(_)) | Direction::Unknown, _) => None,
        _ => Some("vertical".to_string()),
    };
    let channel = Channel { start, remarks, ..source.channel(label.as_deref(), dt, values) };
    source.converted(at, units, options, direction.given_to(channel))
}
