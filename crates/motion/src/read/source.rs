//! The lines of a file, and what all readers need of them.

use std::path::Path;

use crate::channel::{INTERVALS, LARGEST};
use crate::shown::shown;
use crate::{Channel, Error, ReadOptions, Sensitivity, Units};

/// A file, unpacked, as bytes and as lines of text. Line indices count from 0 here, from 1 in messages.
pub(crate) struct Source<'a> {
    pub file: &'a Path,
    pub bytes: &'a [u8],
    pub lines: Vec<&'a str>,
}

impl<'a> Source<'a> {
    /// Splits at LF, CR LF or CR CR LF, or at CR in a file without any LF.
    pub fn new(file: &'a Path, bytes: &'a [u8], text: &'a str) -> Source<'a> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let separator = if text.contains('\n') { '\n' } else { '\r' };
        Source { file, bytes, lines: text.split(separator).map(str::trim_end).collect() }
    }

    /// An error at a line given by index; beyond the end it points at the last line.
    pub fn error(&self, line: usize, problem: impl Into<String>, remedy: impl Into<String>) -> Error {
        Error::record(self.file, line.min(self.lines.len().saturating_sub(1)) + 1, problem, remedy)
    }

    /// The file's name without its last extension, and without `.gz` behind that.
    pub fn stem(&self) -> String {
        let packed = self.file.extension().is_some_and(|e| e.eq_ignore_ascii_case("gz"));
        let plain = if packed { self.file.with_extension("") } else { self.file.to_path_buf() };
        plain.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_else(|| "record".into())
    }

    /// A channel of this file from 0, still in the file's units; `label` tells it from the others of the file.
    pub fn channel(&self, label: Option<&str>, dt: f64, values: Vec<f64>) -> Channel {
        let name = match label {
            Some(label) => format!("{} {label}", self.stem()),
            None => self.stem(),
        };
        let label = label.unwrap_or_default().to_owned();
        Channel { file: self.file.to_path_buf(), label, ..Channel::new(name, dt, values) }
    }

    /// `count` numbers in columns of fixed width from line index `begin` on, and the index of the line behind them. Numbers may
    /// touch. `remedy` is for a file that ends too early or lacks a number.
    pub fn block(
        &self,
        begin: usize,
        columns: Columns,
        count: usize,
        remedy: &str,
    ) -> Result<(Vec<f64>, usize), Error> {
        let Columns { per_line, width } = columns;
        // The count is the file's word: compared with what is there before anything is reserved for it.
        let end = begin.saturating_add(count.div_ceil(per_line));
        if end > self.lines.len() {
            return Err(self.error(
                self.lines.len(),
                format!("the file ends before the {count} numbers that were promised"),
                remedy,
            ));
        }
        let mut values = Vec::with_capacity(count);
        for i in 0..count {
            let line = begin + i / per_line;
            let word = columns.word(self.lines[line], i % per_line).ok_or_else(|| {
                self.error(line, format!("fewer than {per_line} numbers in columns of {width}"), remedy)
            })?;
            values.push(self.number(line, word)?);
        }
        Ok((values, end))
    }

    /// A number, or an error at its line.
    pub fn number(&self, line: usize, word: &str) -> Result<f64, Error> {
        number(word).ok_or_else(|| {
            self.error(line, format!("'{}' is not a finite number", shown(word)), "correct the value")
        })
    }

    /// A sampling interval that the file states: above 0, and equal to the declared one if there is one.
    pub fn stated_interval(&self, line: usize, dt: f64, declared: Option<f64>) -> Result<f64, Error> {
        if !(dt > 0.0 && dt.is_finite()) {
            return Err(self.error(
                line,
                format!("the sampling interval {dt} s is not above 0"),
                "correct the interval",
            ));
        }
        if !INTERVALS.contains(&dt) {
            return Err(self.error(
                line,
                format!("a sampling interval of {dt} s is none of a record"),
                "correct the interval: 0.001 s to 0.05 s are usual",
            ));
        }
        match declared {
            // A thousandth allows for intervals that a header rounds.
            Some(other) if !((other - dt).abs() <= 1e-3 * dt) => Err(self.error(
                line,
                format!("the file states an interval of {dt} s, but dt = \"{other} s\" was declared"),
                "remove the declaration, or correct whichever is wrong",
            )),
            _ => Ok(dt),
        }
    }

    /// Units that the file states: known, and equal to the declared ones if there are any.
    pub fn stated_units(&self, line: usize, word: &str, declared: Option<Units>) -> Result<Units, Error> {
        let units: Units = word.parse().map_err(|problem: String| {
            self.error(line, problem, "give a record of acceleration in one of these units")
        })?;
        match declared {
            Some(other) if other != units => Err(self.error(
                line,
                format!("the file states units of {units}, but units = \"{other}\" was declared"),
                "remove the declaration, or correct whichever is wrong",
            )),
            _ => Ok(units),
        }
    }

    /// Turns a channel whose samples are still in file units into m/s²; counts only by a declared sensitivity.
    ///
    /// # Errors
    /// At `line`, if there are fewer than two samples, the numbers are too large, or a sensitivity was declared for what is an
    /// acceleration already.
    pub fn converted(
        &self,
        line: usize,
        units: Units,
        options: &ReadOptions,
        mut channel: Channel,
    ) -> Result<Channel, Error> {
        let factor = match (units.factor(), options.sensitivity) {
            (Some(_), Some(_)) => {
                return Err(self.error(
                    line,
                    format!("a sensitivity was declared, but the file is in {units}, not in counts"),
                    "remove the declaration",
                ));
            }
            (Some(factor), None) => Some(factor),
            (None, sensitivity) => sensitivity.map(Sensitivity::per_count),
        };
        (channel.units, channel.raw) = (units, factor.is_none());
        let values = &mut channel.acceleration;
        if values.len() < 2 {
            return Err(self.error(
                line,
                format!("{} sample(s) of acceleration were found", values.len()),
                "a record needs at least two",
            ));
        }
        values.iter_mut().for_each(|v| *v *= factor.unwrap_or(1.0));
        if values.iter().any(|v| !(v.abs() <= LARGEST)) || !channel.end().is_finite() {
            return Err(self.error(
                line,
                "values or times are too large for a record",
                "check the numbers and units",
            ));
        }
        Ok(channel)
    }
}

/// Numbers of a fixed width, as Fortran writes them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Columns {
    /// On a full line, above 0.
    pub per_line: usize,
    /// In characters, above 0.
    pub width: usize,
}

impl Columns {
    /// The `i`-th word of a line, trimmed; `None` if it is blank, missing, or not plain text.
    pub fn word(self, line: &str, i: usize) -> Option<&str> {
        let bytes = line.as_bytes();
        let column = bytes.get(i * self.width..bytes.len().min((i + 1) * self.width))?;
        let word = std::str::from_utf8(column).ok()?.trim();
        (!word.is_empty()).then_some(word)
    }
}

/// A finite number, also with Fortran's exponent letter D.
pub(crate) fn number(word: &str) -> Option<f64> {
    let word = word.trim();
    let value = word.parse::<f64>().ok().or_else(|| {
        // Only words that can be numbers, so that no word of text turns into one.
        let plain = word.bytes().all(|b| b.is_ascii_digit() || b"+-.dD".contains(&b));
        plain.then(|| word.replace(['d', 'D'], "e").parse().ok()).flatten()
    });
    value.filter(|v| v.is_finite())
}

/// The number at the beginning of a text, whatever follows it.
pub(crate) fn leading_number(text: &str) -> Option<&str> {
    let text = text.trim_start();
    let end = text.find(|c: char| !(c.is_ascii_digit() || "+-.".contains(c))).unwrap_or(text.len());
    (end > 0).then(|| &text[..end])
}
