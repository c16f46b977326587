//! PEER strong-motion files, `.AT2`, and files that copy their fourth line.
//!
//! Some lines of text, one of which holds the number of points and the interval, in either style:
//! `NPTS=  7995, DT=  .0050 SEC` or `4000  0.0050  NPTS, DT`. Then the samples, any number on a line. The units
//! stand in the text (`IN UNITS OF G`, `The units are (g)`). The second line of PEER's own files ends in the
//! component's azimuth, `UP` or `DWN`; a vertical that is positive downwards is turned.

use super::ReadOptions;
use super::header::Direction;
use super::source::{Source, leading_number, number};
use crate::shown::shown;
use crate::{Channel, Error};

/// How far down the line with NPTS and DT may stand.
const HEADER_LINES: usize = 50;

/// Index of the line with NPTS and DT.
fn counts_line(source: &Source) -> Option<usize> {
    source.lines.iter().take(HEADER_LINES).position(|line| {
        let line = line.to_ascii_uppercase();
        !line.starts_with('#') && line.contains("NPTS") && line.contains("DT")
    })
}

pub(super) fn recognises(source: &Source) -> bool {
    counts_line(source).is_some()
}

pub(super) fn read(source: &Source, options: &ReadOptions) -> Result<Vec<Channel>, Error> {
    let at = counts_line(source).unwrap_or(0);
    let (count, dt) = counts(source, at)?;
    let dt = source.stated_interval(at, dt, options.dt)?;
    let units = match stated_units(source, at) {
        Some((line, word)) => source.stated_units(line, word, options.units)?,
        None => match options.units {
            Some(units) => units,
            None => {
                return Err(source.error(
                    at,
                    "the header does not state the units",
                    "declare them, for example units = \"g\"",
                ));
            }
        },
    };

    let mut values = Vec::new();
    for (line, text) in source.lines.iter().enumerate().skip(at + 1) {
        for word in text.split_whitespace() {
            if values.len() < count {
                values.push(source.number(line, word)?);
            } else if number(word).is_some() {
                return Err(source.error(
                    line,
                    format!("numbers go on after the {count} samples that the header promises"),
                    "correct NPTS, or remove what does not belong to the record",
                ));
            } else {
                // Text behind the samples, such as '*** End Data ***'.
                break;
            }
        }
    }
    if values.len() < count {
        return Err(source.error(
            source.lines.len(),
            format!("the file ends after {} of {count} samples", values.len()),
            "fetch the file again, or correct NPTS",
        ));
    }
    let label = source.lines.get(1).and_then(|l| l.rsplit_once(',')).map(|(_, label)| label.trim());
    let direction = label.filter(|_| at >= 2).map_or(Direction::Unknown, Direction::parse);
    let channel = direction.given_to(source.channel(None, dt, values));
    Ok(vec![source.converted(at, units, options, channel)?])
}

/// Number of points and interval (s) of the line `at`.
fn counts(source: &Source, at: usize) -> Result<(usize, f64), Error> {
    let line = source.lines[at].to_ascii_uppercase();
    let after = |name: &str| {
        let rest = line.split_once(name)?.1.trim_start().strip_prefix('=')?;
        leading_number(rest)
    };
    let words: Vec<&str> = match (after("NPTS"), after("DT")) {
        (Some(points), Some(interval)) => vec![points, interval],
        _ => line.split([' ', '\t', ',']).filter(|w| !w.is_empty()).take(2).collect(),
    };
    let points = words.first().and_then(|w| w.trim_end_matches('.').parse().ok());
    let interval = words.get(1).and_then(|w| number(w));
    match (points, interval) {
        (Some(points), Some(interval)) => Ok((points, interval)),
        _ => Err(source.error(
            at,
            format!("number of points and interval cannot be read from '{}'", shown(source.lines[at].trim())),
            "write the line as 'NPTS= 4000, DT= .005 SEC'",
        )),
    }
}

/// The word that names the units in the lines of text up to `at`, with its line.
fn stated_units<'a>(source: &Source<'a>, at: usize) -> Option<(usize, &'a str)> {
    source.lines[..=at].iter().enumerate().find_map(|(i, line)| {
        // Upper case of ASCII keeps byte positions, so they hold for the line itself.
        let upper = line.to_ascii_uppercase();
        let found =
            ["UNITS OF ", "UNITS ARE ", "UNITS: "].iter().find_map(|p| Some(upper.find(p)? + p.len()))?;
        let word = line[found..].split_whitespace().next()?;
        Some((i, word.trim_matches(['(', ')', '.', ',', ';'])))
    })
}
