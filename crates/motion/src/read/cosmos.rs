//! COSMOS strong-motion data, version 1.20: volumes 0 (counts), 1 (uncorrected) and 2 (corrected), `.V0`, `.V1`, `.V2c` ….
//!
//! A series has lines of text (the first says how many), then blocks of integers, reals and comments, and the numbers. Above
//! each block stands a line with its length and the Fortran format of its numbers, such as
//! `7000  acceleration pts, approx   70 secs, units=cm/sec2(04),Format=(8F10.5)`. Series stand one behind the other: several
//! channels, or acceleration, velocity and displacement of one. Acceleration alone is taken.
//!
//! From the headers, counted from 1 as the standard (COSMOS Strong Motion Programs Board 2001) does:
//! - integer 2: what was measured (1 acceleration); integers 54, 55: where the sensor looks (azimuth 1–360, 400 up, 401
//!   down, 402 vertical of unknown sense), from north or from the azimuth in integer 20 or 21;
//! - real 62: the interval of the series (ms), or if undefined real 34, that of the recorder (s). They differ where a series
//!   was resampled;
//! - real 22, 42, 47: the digitiser's step (µV), the sensor's sensitivity (V/g) and the recorder's gain, from which the
//!   sensitivity of counts follows. It is told to the user, not applied.

use super::ReadOptions;
use super::fortran;
use super::header::{Direction, named_apart};
use super::source::{Columns, Source, leading_number, number};
use crate::shown::shown;
use crate::{Channel, Error, Orientation, STANDARD_GRAVITY, Sensitivity, Units};

/// Files have 13 lines of text, and may have some more.
const MOST_TEXT: usize = 60;
/// What a header holds where a value is unknown, if its line 13 says nothing else.
const UNDEFINED: f64 = -999.0;
const CORRUPT: &str = "fetch the file again";

fn begins_series(line: &str) -> bool {
    line.to_ascii_lowercase().contains("(format v")
}

pub(super) fn recognises(source: &Source) -> bool {
    let text = source.lines.iter().take(MOST_TEXT);
    source.lines.first().is_some_and(|l| begins_series(l))
        && text.clone().any(|l| is_headed(l, "Integer-header"))
}

/// Whether a line begins with a number and has the word: the head of a block.
fn is_headed(line: &str, word: &str) -> bool {
    let line = line.trim_start().to_ascii_lowercase();
    line.starts_with(|c: char| c.is_ascii_digit()) && line.contains(&word.to_ascii_lowercase())
}

pub(super) fn read(source: &Source, options: &ReadOptions) -> Result<Vec<Channel>, Error> {
    let mut channels = Vec::new();
    let mut other = None;
    let mut at = 0;
    while at < source.lines.len() {
        if begins_series(source.lines[at]) {
            let series = Series::at(source, at)?;
            at = series.end;
            match series.quantity(source)? {
                "" => channels.push(series.channel(source, options)?),
                quantity => {
                    other.get_or_insert((series.head, quantity));
                }
            }
        } else if let Some((count, columns)) = block(source.lines[at])
            && !channels.is_empty()
        {
            // Velocity and displacement without headers of their own.
            at = (at + 1).saturating_add(count_lines(count, columns));
            if at > source.lines.len() {
                return Err(source.error(
                    at,
                    format!("the file ends before {count} numbers that were promised"),
                    CORRUPT,
                ));
            }
        } else {
            // Ends of data, and blank lines.
            let line = source.lines[at];
            if !line.is_empty() && line.split_whitespace().all(|w| number(w).is_some()) {
                return Err(source.error(at, "numbers go on after those that were promised", CORRUPT));
            }
            at += 1;
        }
    }
    match other {
        Some((head, quantity)) if channels.is_empty() => Err(source.error(
            head,
            format!("the file holds {quantity}, not acceleration"),
            "give the file of acceleration of the same channel (.acc.V2c for .vel.V2c, say)",
        )),
        _ => {
            named_apart(&mut channels);
            Ok(channels)
        }
    }
}

/// One series of the file: its headers, and where its numbers are.
struct Series {
    /// Line index of its first line.
    begin: usize,
    integers: Vec<f64>,
    reals: Vec<f64>,
    /// Line index of the line above its numbers, their count and columns, and the line behind them.
    head: usize,
    count: usize,
    columns: Columns,
    end: usize,
}

impl Series {
    /// The series whose first line is at line index `begin`.
    fn at(source: &Source, begin: usize) -> Result<Series, Error> {
        let text = source.lines[begin..].iter().take(MOST_TEXT);
        let at = text
            .clone()
            .position(|l| is_headed(l, "Integer-header"))
            .ok_or_else(|| source.error(begin, "the integer header is missing", CORRUPT))?;
        let (integers, at) = header(source, begin + at, "Integer-header")?;
        let (reals, at) = header(source, at, "Real-header")?;
        let comments = source.lines.get(at).filter(|l| is_headed(l, "Comment"));
        let comments = comments.and_then(|l| leading_number(l)?.parse::<usize>().ok());
        let head = match comments {
            Some(lines) => (at + 1).saturating_add(lines),
            None => return Err(source.error(at, "the number of comment lines is missing", CORRUPT)),
        };
        let line = source.lines.get(head).copied().unwrap_or("");
        let Some((count, columns)) = block(line) else {
            return Err(source.error(
                head,
                "no line such as '7000 acceleration pts, …, Format=(8F10.5)' stands here",
                CORRUPT,
            ));
        };
        // The numbers themselves are read if they are wanted; that they are there is seen from their lines.
        let end = (head + 1).saturating_add(count_lines(count, columns));
        if end > source.lines.len() || source.lines[head..end].iter().any(|l| begins_series(l)) {
            return Err(source.error(
                head,
                format!("the file or series ends before the {count} numbers that were promised"),
                CORRUPT,
            ));
        }
        Ok(Series { begin, integers, reals, head, count, columns, end })
    }

    /// What the numbers are if not acceleration, which is told by an empty text.
    fn quantity(&self, source: &Source) -> Result<&'static str, Error> {
        match (self.integer(2), self.unit(source)) {
            (Some(1), _) => Ok(""),
            (Some(2), _) | (None, Some(5 | 8)) => Ok("velocity"),
            (Some(3 | 4), _) | (None, Some(6 | 9)) => Ok("displacement"),
            (Some(_), _) => Ok("something else"),
            (None, Some(code)) if unit(code).is_some() => Ok(""),
            (None, _) => Err(source.error(
                self.head,
                "the header does not say what was measured (integer 2)",
                "give a record of acceleration",
            )),
        }
    }

    fn channel(&self, source: &Source, options: &ReadOptions) -> Result<Channel, Error> {
        let (units, factor) = self.units(source, options)?;
        // Real 62 in ms is that of the series.
        let dt = self.real(62).map(|ms| ms / 1000.0).or(self.real(34)).or(options.dt).ok_or_else(|| {
            source.error(
                self.begin,
                "the header does not state the interval (real 62 or 34)",
                "declare it, for example dt = \"0.005 s\"",
            )
        })?;
        let dt = source.stated_interval(self.head, dt, options.dt)?;
        let (mut values, _) = source.block(self.head + 1, self.columns, self.count, CORRUPT)?;
        let mut remarks = Vec::new();
        if factor != 1.0 {
            values.iter_mut().for_each(|v| *v *= factor);
            remarks.push(format!("The file's numbers are in units of {factor} {units}."));
        }
        if units == Units::Counts && options.sensitivity.is_none() {
            remarks.extend(self.sensitivity());
        }
        if let (Some(above), Some(header)) = (self.unit(source), self.integer(3))
            && above != header
        {
            remarks.push(format!(
                "The line above the numbers has units of code {above}, the header {header} (integer 3); the line was \
                 followed."
            ));
        }
        let direction = self.direction(source);
        let words = self.words(source).and_then(|w| w.split_once(':')).map_or("", |(_, w)| w.trim());
        if ![Direction::Unknown, direction].contains(&Direction::parse(words)) {
            remarks.push(format!(
                "The header says '{}' in words and something else in its integers 54, 55; the integers were followed.",
                shown(words)
            ));
        }
        if self.integer(54) == Some(402) {
            remarks.push("The header does not say whether up or down is positive; up was taken.".into());
        }
        let channel = Channel { remarks, ..source.channel(self.label(source).as_deref(), dt, values) };
        source.converted(self.head, units, options, direction.given_to(channel))
    }

    /// Where the sensor looks: by integer 54; or by integer 55, which counts from the azimuth in integer 20 or 21; or in words; or by
    /// the channel's code, `BNZ` of the comment `|<SCNL>BMR.BNZ.AK.--`. An azimuth of 0 is what many leave in the header of a
    /// vertical component.
    fn direction(&self, source: &Source) -> Direction {
        let from_north = |code: i64| match code {
            1..=360 => Direction::parse(&code.to_string()),
            400 | 402 => Direction::parse("UP"),
            401 => Direction::Down,
            _ => Direction::Unknown,
        };
        let from_reference = || match self.integer(55)? {
            turn @ 0..=360 => match (self.integer(20).or(self.integer(21))?, turn) {
                (reference @ 0..=360, turn) => Some(from_north((reference + turn + 359) % 360 + 1)),
                _ => None,
            },
            code => Some(from_north(code)),
        };
        let known = |direction: &Direction| *direction != Direction::Unknown;
        self.integer(54)
            .map(from_north)
            .filter(known)
            .or_else(|| from_reference().filter(known))
            .or_else(|| {
                let (_, words) = self.words(source)?.split_once(':')?;
                Some(Direction::parse(words)).filter(known)
            })
            .or_else(|| Orientation::of_channel_code(self.code(source)?).map(Direction::Along))
            .unwrap_or(Direction::Unknown)
    }

    /// The channel's code among the comments.
    fn code<'a>(&self, source: &Source<'a>) -> Option<&'a str> {
        let comments = &source.lines[self.begin..self.head];
        let name =
            comments.iter().find_map(|line| line.trim_start_matches('|').trim().strip_prefix("<SCNL>"))?;
        name.split_whitespace().next()?.split('.').nth(1)
    }

    /// `1: 90 Deg` of the line of text `Sta Chan   1: 90 Deg (Rcrdr Chan  ?) Location:…`.
    fn words<'a>(&self, source: &Source<'a>) -> Option<&'a str> {
        let line = source.lines[self.begin..self.head].iter().find(|l| l.starts_with("Sta Ch"))?;
        let words = line["Sta Ch".len()..].trim_start_matches(|c: char| c.is_ascii_alphabetic() || c == ':');
        words.split('(').next()
    }

    /// What text calls the channel.
    fn label(&self, source: &Source) -> Option<String> {
        let label = self.words(source)?.replace(':', " ");
        let label = label.split_whitespace().collect::<Vec<&str>>().join(" ");
        (!label.is_empty()).then(|| format!("ch {}", shown(&label)))
    }

    /// The code of the unit: of the line above the numbers, or else integer 3.
    fn unit(&self, source: &Source) -> Option<i64> {
        let stated = source.lines[self.head].split_once("nits").and_then(|(_, rest)| {
            let code = rest.split_once('(')?.1.split_once(')')?.0;
            code.trim().parse::<i64>().ok()
        });
        stated.or(self.integer(3))
    }

    /// Units of the numbers, with a factor for those that are multiples of another.
    fn units(&self, source: &Source, options: &ReadOptions) -> Result<(Units, f64), Error> {
        let code = self.unit(source);
        let Some(code) = code else {
            return options.units.map(|units| (units, 1.0)).ok_or_else(|| {
                source.error(
                    self.head,
                    "the units are not stated",
                    "declare them, for example units = \"cm/s2\"",
                )
            });
        };
        let (units, factor) = unit(code).ok_or_else(|| {
            source.error(
                self.head,
                format!("units of code {code} are no units of acceleration that are read"),
                "give a record of acceleration in g, mg, cm/s2 or counts",
            )
        })?;
        source.stated_units(self.head, &units.to_string(), options.units).map(|units| (units, factor))
    }

    /// The sensitivity that follows from the header, as the user could declare it.
    fn sensitivity(&self) -> Option<String> {
        let positive = |i: usize| self.real(i).filter(|v| *v > 0.0);
        let (step, sensor, gain) = (positive(22)?, positive(42)?, positive(47));
        let counts = sensor * gain.unwrap_or(1.0) / (step * 1e-6) / STANDARD_GRAVITY;
        // The header has no more figures.
        let sensitivity = Sensitivity::new(format!("{counts:.5e}").parse().ok()?)?;
        let gain = gain.map_or("no stated gain".into(), |gain| format!("a gain of {gain}"));
        Some(format!(
            "From the header, a count of {step} µV (real 22), a sensor of {sensor} V/g (real 42) and {gain} (real 47) \
             make a sensitivity of \"{sensitivity}\"; it was not applied."
        ))
    }

    /// An integer of the header by its number, from 1; none if undefined.
    fn integer(&self, i: usize) -> Option<i64> {
        // Integers of eight digits are exact as f64.
        self.integers.get(i - 1).filter(|v| **v != UNDEFINED).map(|v| *v as i64)
    }

    fn real(&self, i: usize) -> Option<f64> {
        self.reals.get(i - 1).copied().filter(|v| *v != UNDEFINED)
    }
}

/// The units of a code of the standard's table of physical units: those of acceleration, and counts.
fn unit(code: i64) -> Option<(Units, f64)> {
    match code {
        2 => Some((Units::G, 1.0)),
        4 | 10 => Some((Units::CentimetrePerSecond2, 1.0)),
        7 => Some((Units::CentimetrePerSecond2, 2.54)),
        11 => Some((Units::G, 1e-3)),
        12 => Some((Units::G, 1e-6)),
        50 => Some((Units::Counts, 1.0)),
        _ => None,
    }
}

/// What of a block's head holds the format; `(04)` before it is none anyway.
fn line_format(line: &str) -> &str {
    line.rfind("ormat").map_or("", |at| &line[at..])
}

/// The count and the columns of the numbers below a line such as `7000  acceleration pts, …,Format=(8F10.5)`.
fn block(line: &str) -> Option<(usize, Columns)> {
    let count = leading_number(line)?.parse().ok()?;
    Some((count, fortran::columns(line_format(line)).filter(|_| line.contains("pts"))?))
}

fn count_lines(count: usize, columns: Columns) -> usize {
    count.div_ceil(columns.per_line)
}

/// The numbers of a header block whose head is at line index `at`, and the line behind them.
fn header(source: &Source, at: usize, word: &str) -> Result<(Vec<f64>, usize), Error> {
    let line = source.lines.get(at).copied().filter(|l| is_headed(l, word)).unwrap_or("");
    let count = leading_number(line).and_then(|n| n.parse().ok());
    let (Some(count), Some(columns)) = (count, fortran::columns(line_format(line))) else {
        return Err(source.error(
            at,
            format!("no line such as '100 {word} values follow …, Format= (10I8)' stands here"),
            CORRUPT,
        ));
    };
    source.block(at + 1, columns, count, CORRUPT)
}
