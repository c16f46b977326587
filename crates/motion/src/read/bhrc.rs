//! BHRC (Building and Housing Research Center, Iran) records, volume 1, `VOL1DS`, `.V1`: three components a file.
//!
//! Behind the first lines a component begins with `COMP L1`. Its text has the azimuths of the two horizontal components
//! (`Azimuth L 352 T 82`), the number of points with the duration, and the unit (`UNITS ARE SECONDS AND G/10`); then come 100 integers,
//! 50 reals and the samples, equally spaced. Numbers may touch. The interval is the duration over the number of points.

use super::ReadOptions;
use super::csmip::{unit, units};
use super::header::{Direction, named_apart};
use super::source::{Source, leading_number, number};
use crate::shown::shown;
use crate::{Channel, Error};

/// Integers and reals in front of the samples.
const HEADER_NUMBERS: usize = 150;
const CORRUPT: &str = "fetch the file again";

pub(super) fn recognises(source: &Source) -> bool {
    source.lines.iter().take(5).any(|l| l.contains("VOL1DS"))
}

fn begins(line: &str) -> bool {
    line.get(..5).is_some_and(|w| w.eq_ignore_ascii_case("COMP "))
}

pub(super) fn read(source: &Source, options: &ReadOptions) -> Result<Vec<Channel>, Error> {
    let begins: Vec<usize> = (0..source.lines.len()).filter(|i| begins(source.lines[*i])).collect();
    if begins.is_empty() {
        return Err(source.error(0, "no line begins a component, such as 'COMP L1'", CORRUPT));
    }
    let ends = begins[1..].iter().copied().chain([source.lines.len()]);
    let mut channels = begins
        .iter()
        .zip(ends)
        .map(|(at, end)| component(source, *at, end, options))
        .collect::<Result<Vec<_>, _>>()?;
    named_apart(&mut channels);
    Ok(channels)
}

/// The component in the lines `at..end`.
fn component(source: &Source, at: usize, end: usize, options: &ReadOptions) -> Result<Channel, Error> {
    let after = |phrase: &str| {
        let text = source.lines[at..end].iter().enumerate().map(|(i, l)| (at + i, l));
        // Capitals of ASCII keep byte positions.
        text.filter_map(|(i, l)| Some((i, &l[l.to_ascii_uppercase().find(phrase)? + phrase.len()..]))).next()
    };
    let value = |phrase: &str| {
        after(phrase)
            .ok_or_else(|| source.error(at, format!("the component has no line with '{phrase}'"), CORRUPT))
    };
    let numeric = |phrase: &str| {
        let (line, text) = value(phrase)?;
        let found = leading_number(text.trim_start_matches([' ', '='])).and_then(number).filter(|n| *n > 0.0);
        found
            .map(|n| (line, n))
            .ok_or_else(|| source.error(line, format!("no number above 0 follows '{phrase}'"), CORRUPT))
    };
    let (points, count) = numeric("NO. OF POINTS")?;
    let (_, duration) = numeric("DURATION")?;
    let (line, text) = value("UNITS")?;
    let (units, factor) = units(source, line, unit(text), options)?;
    let dt = source.stated_interval(points, interval(duration, count), options.dt)?;

    let mut values = Vec::new();
    for (i, text) in source.lines[..end].iter().enumerate().skip(points + 1) {
        // A line of text, such as the letter in front of the next component, ends the numbers.
        let found: Option<Vec<f64>> = apart(text).map(number).collect();
        match found {
            Some(found) => values.extend(found.into_iter().map(|v| v * factor)),
            None if values.is_empty() || !text.contains('.') => {}
            None => return Err(source.error(i, format!("'{}' is no row of numbers", shown(text)), CORRUPT)),
        }
    }
    let there = values.len() as f64 - HEADER_NUMBERS as f64;
    if there != count {
        return Err(source.error(points, format!("samples: {there} ({count} stated)"), CORRUPT));
    }
    values.drain(..HEADER_NUMBERS);
    let name = source.lines[at][5..].split_whitespace().next().unwrap_or("");
    let axis = name.trim_end_matches(|c: char| c.is_ascii_digit()).to_ascii_uppercase();
    let azimuth = || {
        let mut words = after("AZIMUTH")?.1.split_whitespace();
        words.find(|w| w.eq_ignore_ascii_case(&axis))?;
        words.next()
    };
    let direction =
        if axis == "V" { Direction::parse("UP") } else { Direction::parse(azimuth().unwrap_or("")) };
    let mut channel = source.channel(Some(name), dt, values);
    if factor != 1.0 {
        channel.remarks.push("The file's numbers are tenths of g (G/10).".into());
    }
    source.converted(points, units, options, direction.given_to(channel))
}

/// The interval (s) of a duration in which one more or one less sample is counted: the one with the rate nearer to a whole number.
fn interval(duration: f64, count: f64) -> f64 {
    let off = |dt: &f64| (1.0 / dt - (1.0 / dt).round()).abs();
    let [all, between] = [duration / count, duration / (count - 1.0)];
    let dt = if off(&between) < off(&all) { between } else { all };
    // The duration is printed to a millisecond.
    format!("{dt:.5e}").parse().unwrap_or(dt)
}

/// Numbers of a line, also where a sign touches the number in front of it.
fn apart(line: &str) -> impl Iterator<Item = &str> {
    line.split_whitespace().flat_map(|word| {
        let bytes = word.as_bytes();
        let cut = |i: &usize| {
            matches!(bytes[*i], b'-' | b'+') && !matches!(bytes[*i - 1], b'E' | b'e' | b'D' | b'd')
        };
        let cuts: Vec<usize> = std::iter::once(0).chain((1..bytes.len()).filter(cut)).collect();
        let ends: Vec<usize> = cuts[1..].iter().copied().chain([bytes.len()]).collect();
        cuts.into_iter().zip(ends).filter_map(|(a, b)| word.get(a..b)).collect::<Vec<_>>()
    })
}
