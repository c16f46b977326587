//! Volumes 1 and 2 of the California programs: CDMG and CSMIP (OSMS 85-03), USC, Caltech.
//!
//! All descend from the Caltech tapes (Trifunac and Lee 1973) and share a layout: lines of text, 100 integers (`16I5`), reals
//! (`8F10.3`), numbers; channels stand one behind the other, each closed by `/&  --- END OF DATA` in most files.
//!
//! - Volume 2, `CORRECTED ACCELEROGRAM`: 25 lines of text; acceleration, velocity and displacement, each under a line such as
//!   `3251 POINTS OF ACCEL DATA EQUALLY SPACED AT .020 SEC. (UNITS: CM/SEC/SEC)`. Acceleration alone is taken.
//! - Volume 1, `UNCORRECTED ACCELEROGRAM DATA`: 13 lines of text; for digital recorders equally spaced numbers under
//!   `13200 Accelerogram points at 200 pts/sec in units of g`; for film pairs of time and acceleration without such a line
//!   (`UNITS ARE SEC AND G/10`), which are brought to equal intervals by `pairs.rs`.
//!
//! A line above the numbers may state their Fortran format; where it does not, they fill columns of 10 or 9. Pairs stand in
//! columns of 7, behind a blank in USC's files. The direction is read from `CHAN  1:  90 DEG` or `COMP N08W`, or else from
//! integer 27 (up 500, down 600).

use super::ReadOptions;
use super::header::{Direction, named_apart};
use super::source::{Columns, Source, leading_number, number};
use super::{fortran, pairs};
use crate::shown::shown;
use crate::{Channel, Error, Units};

/// How far below the beginning of a channel its numbers begin at the latest.
const HEADER_LINES: usize = 60;
/// Lines of text of volume 1 and of volume 2.
const TEXT_LINES: [usize; 2] = [13, 25];
const INTEGERS: Columns = Columns { per_line: 16, width: 5 };
/// Lines of reals of volume 1.
const REAL_LINES: usize = 7;
const PAIRS: Columns = Columns { per_line: 10, width: 7 };
const CORRUPT: &str = "fetch the file again";

/// Capitals of ASCII keep byte positions.
fn capitals(line: &str) -> String {
    line.to_ascii_uppercase()
}

fn begins_channel(line: &str) -> bool {
    capitals(line).contains("CORRECTED ACCELEROGRAM")
}

fn ends_channel(line: &str) -> bool {
    line.starts_with("/&") || capitals(line).contains("END OF DATA")
}

/// Volume 3 is recognised as well, to be refused for what it is.
pub(super) fn recognises(source: &Source) -> bool {
    let mut lines = source.lines.iter().skip_while(|l| l.is_empty());
    lines.next().is_some_and(|first| {
        begins_channel(first)
            || capitals(first).contains("SPECTRA") && lines.take(2).any(|l| begins_channel(l))
    })
}

pub(super) fn read(source: &Source, options: &ReadOptions) -> Result<Vec<Channel>, Error> {
    let mut channels = Vec::new();
    let mut at = source.lines.iter().take_while(|l| l.is_empty()).count();
    while at < source.lines.len() {
        let (channel, next) = channel(source, at, options)?;
        channels.push(channel);
        at = next;
    }
    named_apart(&mut channels);
    Ok(channels)
}

/// The line above a block of equally spaced numbers.
struct Head<'a> {
    count: usize,
    dt: f64,
    /// `ACCEL`, `VEL`, `DIS`.
    is_acceleration: bool,
    units: &'a str,
    columns: Option<Columns>,
}

fn head(line: &str) -> Option<Head<'_>> {
    let upper = capitals(line);
    let after = |phrase: &str| Some(upper.find(phrase)? + phrase.len());
    let number_after = |phrase: &str| number(leading_number(&upper[after(phrase)?..])?);
    after("POINTS")?;
    let count = leading_number(line)?.parse().ok()?;
    let dt = match number_after("SPACED AT") {
        Some(interval) => interval,
        None if upper.contains("/SEC") => 1.0 / number_after(" AT ")?,
        None => return None,
    };
    let units = after("UNITS").or_else(|| after(" IN ")).map_or("", |at| unit(&line[at..]));
    let is_acceleration = upper.contains("ACC");
    Some(Head { count, dt, is_acceleration, units, columns: fortran::columns(line) })
}

/// The unit at the beginning of a text such as ` of g .   Format`, `: CM/SEC/SEC)` or ` ARE SEC AND G/10.   MAX`.
pub(super) fn unit(text: &str) -> &str {
    let mut text = text.trim_start_matches([':', ' ']);
    let upper = capitals(text);
    // Of times nothing need be said, so what stands behind 'SEC AND' is the unit.
    for phrase in ["SEC AND ", "SECONDS AND ", " IS ", "ARE ", "OF "] {
        if let Some(at) = upper.find(phrase) {
            text = &text[at + phrase.len()..];
            break;
        }
    }
    let end = text.find("  ").unwrap_or(text.len()).min(text.find(['(', ')']).unwrap_or(text.len()));
    text[..end].trim_end_matches([' ', '.', ','])
}

/// Units of a word, with the factor of `G/10`.
pub(super) fn units(
    source: &Source,
    line: usize,
    word: &str,
    options: &ReadOptions,
) -> Result<(Units, f64), Error> {
    let tenths = word.eq_ignore_ascii_case("g/10");
    match (word, options.units) {
        ("", Some(units)) => Ok((units, 1.0)),
        ("", None) => {
            Err(source.error(line, "the units are not stated", "declare them, for example units = \"g\""))
        }
        _ => Ok(source
            .stated_units(line, if tenths { "g" } else { word }, options.units)
            .map(|units| (units, if tenths { 0.1 } else { 1.0 }))?),
    }
}

/// Reads the channel that begins at line index `at`, and tells where the next one begins.
fn channel(source: &Source, at: usize, options: &ReadOptions) -> Result<(Channel, usize), Error> {
    let first = capitals(source.lines[at]);
    if first.contains("SPECTRA") {
        return Err(source.error(
            at,
            "this is volume 3, spectra",
            "give volume 2 or 1 of the same record (.V2, .V1)",
        ));
    }
    let raw = first.contains("UNCORRECTED");
    let header = source.lines[at..].iter().take(HEADER_LINES).enumerate();
    let header = header.take_while(|(i, l)| !(ends_channel(l) || raw && *i > 0 && begins_channel(l)));
    let found = header.clone().find_map(|(i, l)| Some((at + i, head(l)?)));
    let begin = found.as_ref().map_or(header.count() + at, |(line, _)| *line);

    let (channel, line, units, next) = match found {
        Some((line, block)) => {
            if !block.is_acceleration {
                return Err(source.error(
                    line,
                    "the first numbers of the channel are no acceleration",
                    "give a record of acceleration",
                ));
            }
            // Where the line above the numbers has no unit, the header's peak has it: '= -267.957 CM/SEC/SEC AT', or CMS.
            let peak = source.lines[at..line].iter().find_map(|l| {
                capitals(l)
                    .split_once("PEAK ACCELERATION")
                    .map(|(_, rest)| rest.split_whitespace().nth(2).unwrap_or("").replace("CMS/", "CM/"))
            });
            let word = if block.units.is_empty() { peak.as_deref().unwrap_or("") } else { block.units };
            let (units, factor) = units(source, line, word, options)?;
            let dt = source.stated_interval(line, block.dt, options.dt)?;
            let columns = columns(source, line, &block)?;
            let (values, next) = source.block(line + 1, columns, block.count, CORRUPT)?;
            (scaled(source.channel(None, dt, values), factor), line, units, next)
        }
        None if raw => film(source, at, options)?,
        None => {
            return Err(source.error(
                at,
                "no line below says how many points of acceleration there are",
                "volume 2 has a line such as '3251 POINTS OF ACCEL DATA EQUALLY SPACED AT .020 SEC.'; fetch the \
                 file again",
            ));
        }
    };
    let next = behind(source, next)?;
    let (label, direction, remark) = direction(source, at, begin, raw);
    let label = label.unwrap_or_default();
    let name = if label.is_empty() { channel.name.clone() } else { format!("{} {label}", channel.name) };
    let mut channel = direction.given_to(Channel { name, label, ..channel });
    channel.remarks.extend(remark);
    Ok((source.converted(line, units, options, channel)?, next))
}

/// The columns of the numbers below line index `at`: as stated, else as the first line is filled.
///
/// # Errors
/// At that line, if there are fewer lines of numbers than were promised.
fn columns(source: &Source, at: usize, of: &Head) -> Result<Columns, Error> {
    let below = source.lines.get(at + 1..).unwrap_or(&[]);
    let length = below.first().map_or(0, |l| l.len());
    let width = if !length.is_multiple_of(10) && length.is_multiple_of(9) { 9 } else { 10 };
    let columns = of.columns.unwrap_or(Columns { per_line: (length / width).max(1), width });
    let rows = below.get(..of.count.div_ceil(columns.per_line));
    if rows.is_some_and(|rows| !rows.iter().any(|l| ends_channel(l) || head(l).is_some())) {
        return Ok(columns);
    }
    Err(source.error(at, format!("{} numbers were promised here, and fewer are there", of.count), CORRUPT))
}

/// Applies the factor of `G/10`.
fn scaled(mut channel: Channel, factor: f64) -> Channel {
    if factor != 1.0 {
        channel.acceleration.iter_mut().for_each(|a| *a *= factor);
        channel.remarks.push("The file's numbers are tenths of g (G/10).".into());
    }
    channel
}

/// The channel of pairs from film whose header begins at `at`, the line its numbers begin at, their units, and the line behind.
fn film(source: &Source, at: usize, options: &ReadOptions) -> Result<(Channel, usize, Units, usize), Error> {
    let text_end = at + TEXT_LINES[0];
    if source.lines.len() < text_end {
        return Err(source.error(at, "the header of a channel is cut short", CORRUPT));
    }
    let after = |phrase: &str| {
        let text = source.lines[at..text_end].iter().enumerate();
        text.filter_map(|(i, l)| Some((at + i, &l[capitals(l).find(phrase)? + phrase.len()..]))).next()
    };
    let points = after("NO. OF POINTS").and_then(|(line, rest)| {
        Some((line, leading_number(rest.trim_start_matches([' ', '=']))?.parse::<usize>().ok()?))
    });
    let Some((line, count)) = points else {
        return Err(source.error(at, "no line of the header has 'NO. OF POINTS'", CORRUPT));
    };
    let (units_line, word) = after("UNITS").map_or((at, ""), |(i, rest)| (i, unit(rest)));
    let (units, factor) = units(source, units_line, word, options)?;

    // Integers have no point; the reals behind them do.
    let integers = source.lines[text_end..].iter().take_while(|l| !l.contains('.')).count();
    let begin = text_end + integers + REAL_LINES;
    let mut numbers: Vec<f64> = Vec::new();
    let mut lines: Vec<usize> = Vec::new();
    let mut next = begin;
    // Twice a hostile count may overflow; half of what was read cannot.
    while numbers.len() / 2 < count {
        let row = source.lines.get(next).and_then(|l| row(l)).ok_or_else(|| {
            source.error(
                next,
                format!("{} of the {count} pairs of line {} are there", numbers.len() / 2, line + 1),
                CORRUPT,
            )
        })?;
        lines.resize(lines.len() + row.len() / 2, next);
        numbers.extend(row);
        next += 1;
    }
    if numbers.len() / 2 > count {
        return Err(source.error(
            next - 1,
            format!("numbers go on after the {count} pairs that the header promises"),
            CORRUPT,
        ));
    }
    let line = |i: usize| lines.get(i).copied().unwrap_or(begin);
    let even = pairs::equal_intervals(source, &numbers, line, options.dt)?;
    let mut channel = scaled(source.channel(None, even.dt, even.values), factor);
    channel.start = even.start;
    channel.remarks.push(even.remark);
    Ok((channel, begin, units, next))
}

/// The numbers of a line of whole pairs, separate or in columns of 7 that touch.
fn row(line: &str) -> Option<Vec<f64>> {
    let separate: Option<Vec<f64>> = line.split_whitespace().map(number).collect();
    let numbers = match separate {
        Some(numbers) => numbers,
        None => {
            let line = line.get(line.len() % PAIRS.width..)?;
            let words = (0..line.len() / PAIRS.width).map(|i| number(PAIRS.word(line, i)?));
            words.collect::<Option<Vec<f64>>>()?
        }
    };
    (!numbers.is_empty() && numbers.len().is_multiple_of(2)).then_some(numbers)
}

/// Goes from the line behind a channel's acceleration, over velocity and displacement, to the next channel or the end.
fn behind(source: &Source, mut at: usize) -> Result<usize, Error> {
    while let Some(line) = source.lines.get(at) {
        if begins_channel(line) {
            break;
        }
        if let Some(head) = head(line) {
            at += head.count.div_ceil(columns(source, at, &head)?.per_line);
        } else if !line.is_empty() && line.split_whitespace().all(|w| number(w).is_some()) {
            return Err(source.error(at, "numbers go on after those that were promised", CORRUPT));
        }
        at += 1;
    }
    Ok(at)
}

/// What to call the channel whose header is in lines `at..end`, where it looks, and a remark if the header contradicts itself.
fn direction(
    source: &Source,
    at: usize,
    end: usize,
    raw: bool,
) -> (Option<String>, Direction, Option<String>) {
    let stated = source.lines[at..end].iter().skip(1).find_map(|line| {
        let line = line.trim_start();
        let (word, rest) = line.split_at_checked(4)?;
        if word.eq_ignore_ascii_case("CHAN") {
            let (channel, text) = rest.split_once(':')?;
            let text = text.trim_start();
            // '(STA CHN: 17)' or 'FROM' follow.
            let text = text[..text.find("  ").unwrap_or(text.len())].split('(').next()?.trim_end();
            Some((format!("ch {} {text}", channel.trim()), text))
        } else if word.eq_ignore_ascii_case("COMP") {
            let text = rest.split_whitespace().next()?;
            Some((text.to_string(), text))
        } else {
            None
        }
    });
    let line = source.lines.get(at + TEXT_LINES[usize::from(!raw)] + 1);
    let code = line.and_then(|l| INTEGERS.word(l, 26 - INTEGERS.per_line)?.parse::<u16>().ok());
    let coded = match code {
        // North is 360, so that 0 says nothing.
        Some(1..=360) => Direction::parse(&code.unwrap_or(0).to_string()),
        Some(400 | 500) => Direction::parse("UP"),
        Some(600) => Direction::Down,
        _ => Direction::Unknown,
    };
    let Some((label, text)) = stated else { return (None, coded, None) };
    let label = shown(label.trim_end()).into_owned();
    match Direction::parse(text) {
        Direction::Unknown => (Some(label), coded, None),
        said if said == coded || coded == Direction::Unknown => (Some(label), said, None),
        said => {
            let remark = format!(
                "The header says '{}' in words and {} in its integer 27; the words were taken.",
                shown(text),
                code.unwrap_or(0)
            );
            (Some(label), said, Some(remark))
        }
    }
}
