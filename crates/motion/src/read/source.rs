//! The lines of a file, and what all readers need of them.

use std::path::Path;

use crate::shown::shown;
use crate::{Channel, Error, Units};

/// A text file in lines. Line indices count from 0 here, from 1 in messages.
pub(crate) struct Source<'a> {
    pub file: &'a Path,
    pub lines: Vec<&'a str>,
}

impl<'a> Source<'a> {
    /// Splits at LF, CR LF or CR CR LF, or at CR in a file without any LF.
    pub fn new(file: &'a Path, text: &'a str) -> Source<'a> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let separator = if text.contains('\n') { '\n' } else { '\r' };
        Source { file, lines: text.split(separator).map(str::trim_end).collect() }
    }

    /// An error at a line given by index; beyond the end it points at the last line.
    pub fn error(&self, line: usize, problem: impl Into<String>, remedy: impl Into<String>) -> Error {
        Error::record(self.file, line.min(self.lines.len().saturating_sub(1)) + 1, problem, remedy)
    }

    /// The file's name without its last extension.
    pub fn stem(&self) -> String {
        self.file.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_else(|| "record".into())
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

    /// Turns a channel whose samples are still in file units into m/s².
    ///
    /// # Errors
    /// At `line`, if there are fewer than two samples or the numbers are too large.
    pub fn converted(&self, line: usize, units: Units, mut channel: Channel) -> Result<Channel, Error> {
        let values = &mut channel.acceleration;
        if values.len() < 2 {
            return Err(self.error(
                line,
                format!("{} sample(s) of acceleration were found", values.len()),
                "a record needs at least two",
            ));
        }
        values.iter_mut().for_each(|v| *v *= units.factor());
        if values.iter().any(|v| !v.is_finite()) || !channel.end().is_finite() {
            return Err(self.error(
                line,
                "values or times are too large for a record",
                "check the numbers and units",
            ));
        }
        Ok(channel)
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
