//! Columns below a header that declares them: AFAD (Türkiye), CWB (Taiwan), JMA csv (Japan), ASA 2.0 (Mexico).
//!
//! A header of lines `KEY : value` states the interval or the rate, the unit and, in most, the number of samples; then come all
//! components of a station side by side. The networks differ in the words of the keys and in the place of the columns' names:
//! - AFAD: `N-S E-W U-D` on the line above the numbers, the unit in the parentheses of `RAW PGA VALUES (gal)`;
//! - CWB: `#DataSequence: Time U(+); N(+); E(+)`, the time in Taiwan's time (GMT+08);
//! - JMA: `NS,EW,UD` above the numbers, the time in Japan's time;
//! - ASA: `/V/N00E/N90E` behind `ORIENTACION`, and rates and numbers of samples by channel, which must be equal.

use super::header::{Direction, named_apart};
use super::source::{Source, leading_number, number};
use super::{ReadOptions, date, text};
use crate::shown::shown;
use crate::{Channel, Error, Orientation};

/// How far down a header may reach.
const HEADER_LINES: usize = 200;
const CORRUPT: &str = "fetch the file again";

/// One network's words. Keys are the beginnings of lines, in capitals and without `#`.
struct Network {
    /// Keys that mark the format.
    marks: [&'static str; 2],
    /// The interval (s), or the rate (1/s).
    interval: &'static str,
    is_rate: bool,
    /// The number of samples.
    count: Option<&'static str>,
    /// The duration (s), where it takes the place of the number.
    duration: Option<&'static str>,
    units: &'static str,
    /// The key of the columns' names; without it they stand above the numbers.
    columns: Option<&'static str>,
    /// The key of the first sample's time, and the hours of its clock before UTC.
    clock: Option<(&'static str, f64)>,
}

const NETWORKS: [Network; 4] = [
    Network {
        marks: ["NUMBER OF DATA", "SAMPLING INTERVAL (SEC)"],
        interval: "SAMPLING INTERVAL (SEC)",
        is_rate: false,
        count: Some("NUMBER OF DATA"),
        duration: None,
        units: "RAW PGA VALUES",
        columns: None,
        // Written by day, month and year; all columns begin together.
        clock: None,
    },
    Network {
        marks: ["STATIONCODE", "DATASEQUENCE"],
        interval: "SAMPLERATE(HZ)",
        is_rate: true,
        count: None,
        duration: Some("RECORDLENGTH(SEC)"),
        units: "AMPLITUDEUNIT",
        columns: Some("DATASEQUENCE"),
        clock: Some(("STARTTIME(GMT+08)", 8.0)),
    },
    Network {
        marks: ["SITE CODE", "SAMPLING RATE"],
        interval: "SAMPLING RATE",
        is_rate: true,
        count: None,
        duration: None,
        units: "UNIT",
        columns: None,
        clock: Some(("INITIAL TIME", 9.0)),
    },
    Network {
        marks: ["ORIENTACION C1-C6", "VEL. DE MUESTREO"],
        interval: "VEL. DE MUESTREO",
        is_rate: true,
        count: Some("NUM. TOTAL DE MUESTRAS"),
        duration: None,
        units: "UNIDADES DE LOS DATOS",
        columns: Some("ORIENTACION C1-C6"),
        clock: None,
    },
];

/// A line without what stands in front of its key.
fn bare(line: &str) -> &str {
    line.trim_start_matches(['#', ' ', '\t'])
}

/// The line that begins with a key, and what stands behind the key's `:` or `=`.
fn value<'a>(source: &Source<'a>, key: &str) -> Option<(usize, &'a str)> {
    let header = source.lines.iter().take(HEADER_LINES).enumerate();
    header.into_iter().find_map(|(i, line)| {
        let line = bare(line);
        let rest = line.get(key.len()..).filter(|_| line[..key.len()].eq_ignore_ascii_case(key))?;
        Some((i, rest.split_once([':', '=']).map_or(rest, |(_, value)| value).trim()))
    })
}

fn network(source: &Source) -> Option<&'static Network> {
    NETWORKS.iter().find(|n| n.marks.iter().all(|mark| value(source, mark).is_some()))
}

pub(super) fn recognises(source: &Source) -> bool {
    network(source).is_some()
}

fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split([' ', '\t', ',']).filter(|w| !w.is_empty())
}

/// The one number of a value, or the same number of every channel: `/200/200/200`.
fn single(source: &Source, key: &str) -> Result<(usize, f64), Error> {
    let (line, text) = value(source, key)
        .ok_or_else(|| source.error(0, format!("no line of the header begins with '{key}'"), CORRUPT))?;
    let numbers: Option<Vec<f64>> =
        text.split('/').filter(|p| !p.trim().is_empty()).map(|p| number(leading_number(p)?)).collect();
    match numbers.as_deref() {
        Some([first, others @ ..]) if others.iter().all(|other| other == first) => Ok((line, *first)),
        Some([_, ..]) => Err(source.error(
            line,
            format!("'{}': the channels differ", shown(text)),
            "give channels of one rate and length in a file each, as columns of text",
        )),
        _ => Err(source.error(line, format!("'{}' is no number", shown(text)), CORRUPT)),
    }
}

/// A column's name and where it looks; `None` for the time.
type Column = Option<(String, Direction)>;

/// A column of a name such as `N00E`, `U(+)` or `Time`.
fn column(name: &str) -> Column {
    let (name, sign) = name.split_once(['(', ';']).unwrap_or((name, ""));
    let turned = sign.starts_with('-');
    let direction = match Direction::parse(if name == "U" { "UP" } else { name }) {
        Direction::Along(Orientation::Up) if turned => Direction::Down,
        Direction::Along(Orientation::Azimuth(a)) if turned => {
            Direction::Along(Orientation::from_degrees(a.to_degrees() + 180.0))
        }
        other => other,
    };
    (!name.eq_ignore_ascii_case("time")).then(|| (shown(name).into_owned(), direction))
}

pub(super) fn read(source: &Source, options: &ReadOptions) -> Result<Vec<Channel>, Error> {
    // Recognised by the same function.
    let network = network(source).unwrap_or(&NETWORKS[0]);
    let (line, stated) = single(source, network.interval)?;
    let dt = source.stated_interval(line, if network.is_rate { 1.0 / stated } else { stated }, options.dt)?;
    let (line, unit) = value(source, network.units)
        .ok_or_else(|| source.error(0, format!("no line begins with '{}'", network.units), CORRUPT))?;
    // AFAD has the unit in the key.
    let unit = match source.lines[line].split_once('(') {
        Some((key, rest)) if key.to_ascii_uppercase().contains("PGA") => rest.split(')').next().unwrap_or(""),
        _ => unit.split([' ', '(', ',']).next().unwrap_or("").trim_end_matches('.'),
    };
    let units = source.stated_units(line, unit, options.units)?;
    let clock = network.clock.and_then(|(key, ahead)| {
        let (_, text) = value(source, key)?;
        Some(date::seconds(text.trim_end_matches([',', ' ']))? - ahead * 3600.0)
    });

    let names = network.columns.and_then(|key| value(source, key));
    let after = names.map_or(0, |(line, _)| line + 1);
    let is_row = |line: &str| words(line).next().is_some() && words(line).all(|w| number(w).is_some());
    let begin = (after..source.lines.len())
        .find(|i| is_row(source.lines[*i]))
        .ok_or_else(|| source.error(source.lines.len(), "no numbers follow the header", CORRUPT))?;
    let above = source.lines[..begin].iter().rposition(|l| !l.is_empty()).unwrap_or(0);
    let (line, names) = names.unwrap_or((above, source.lines[above]));
    let columns: Vec<Column> =
        names.split([' ', '\t', ',', '/']).filter(|w| !w.is_empty()).map(column).collect();

    let mut data = vec![Vec::new(); columns.len()];
    let mut rows = Vec::new();
    for (i, text) in source.lines.iter().enumerate().skip(begin).filter(|(_, l)| !l.is_empty()) {
        let found = words(text).count();
        if found != columns.len() {
            let problem =
                format!("numbers on this line: {found} (columns by line {}: {})", line + 1, columns.len());
            return Err(source.error(i, problem, CORRUPT));
        }
        for (column, word) in data.iter_mut().zip(words(text)) {
            column.push(source.number(i, word)?);
        }
        rows.push(i);
    }
    if let Some(key) = network.count {
        let (line, count) = single(source, key)?;
        if count != rows.len() as f64 {
            return Err(source.error(line, format!("samples: {} ({count} stated)", rows.len()), CORRUPT));
        }
    }
    if let Some(key) = network.duration {
        let (line, duration) = single(source, key)?;
        let there = rows.len() as f64 * dt;
        // The duration may be printed to a second.
        if !((there - duration).abs() < 1.0) {
            return Err(source.error(line, format!("duration: {there} s ({duration} s stated)"), CORRUPT));
        }
    }
    let mut channels = Vec::new();
    let mut start = 0.0;
    for (column, values) in columns.into_iter().zip(data) {
        let Some((label, direction)) = column else {
            start = text::time_base(source, &rows, &values, Some(dt))?.0;
            continue;
        };
        let channel = Channel { start, clock, ..source.channel(Some(&label), dt, values) };
        channels.push(source.converted(begin, units, options, direction.given_to(channel))?);
    }
    if channels.is_empty() {
        return Err(source.error(line, "no column of acceleration is declared", CORRUPT));
    }
    named_apart(&mut channels);
    Ok(channels)
}
