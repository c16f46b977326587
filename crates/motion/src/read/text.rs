//! Columns of numbers.
//!
//! Numbers are separated by blanks, tabs, commas or semicolons, so a decimal comma is refused. `#` begins a comment.
//! There is no header; what the columns hold is declared. Comments of the form
//! `# units = "cm/s2"` and `# dt = "0.005 s"` count as declarations, written as in a case file, and `# direction = "332"`
//! (azimuth in degrees, or `up`) as the positive direction of the one column of acceleration.

use super::source::{Source, number};
use super::{ReadOptions, TextColumn};
use crate::shown::shown;
use crate::{Channel, Error, Orientation, Units};

/// The numbers of a file.
struct Table {
    /// What each column holds.
    columns: Vec<TextColumn>,
    /// One vector a column, equally long, with at least two numbers each.
    data: Vec<Vec<f64>>,
    /// Line index of each row, for messages.
    rows: Vec<usize>,
}

fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split([' ', '\t', ',', ';']).filter(|w| !w.is_empty())
}

/// Reads the numbers, the same count on every line.
fn table(source: &Source, declared: Option<&[TextColumn]>) -> Result<Table, Error> {
    let mut columns = Vec::new();
    let mut data: Vec<Vec<f64>> = Vec::new();
    let mut rows = Vec::new();
    for (line, text) in source.lines.iter().enumerate() {
        let text = text.split('#').next().unwrap_or("");
        let words = || words(text);
        let found = words().count();
        if found == 0 {
            continue;
        }
        if let Some((word, true)) = decimal_comma(text) {
            return Err(comma(source, line, word));
        }
        if rows.is_empty() {
            // A line of words is the likelier fault than a wrong number of columns.
            if let Some(word) = words().find(|w| number(w).is_none()) {
                return Err(text_or_header(source, line, word));
            }
            columns = columns_of(found, declared).map_err(|problem| {
                fault(
                    source,
                    line,
                    problem,
                    "declare every column, for example columns = [\"time\", \"acceleration\", \"skip\", \"skip\"]",
                )
            })?;
            data = vec![Vec::new(); found];
        } else if found != data.len() {
            return Err(fault(
                source,
                line,
                format!("{found} number(s) on this line, {} on the first", data.len()),
                "complete or remove the line",
            ));
        }
        for (column, word) in data.iter_mut().zip(words()) {
            column.push(number(word).ok_or_else(|| not_a_number(source, line, word))?);
        }
        rows.push(line);
    }
    match rows[..] {
        [] => Err(source.error(0, "the file holds no numbers", "check that it is the record you mean")),
        [only] => Err(source.error(only, "there is one line of numbers", "a record needs at least two")),
        _ => Ok(Table { columns, data, rows }),
    }
}

/// What `found` columns hold: as declared, else acceleration, or time and acceleration.
fn columns_of(found: usize, declared: Option<&[TextColumn]>) -> Result<Vec<TextColumn>, String> {
    match (declared, found) {
        (Some(columns), _) if columns.len() == found => Ok(columns.to_vec()),
        (Some(columns), _) => {
            Err(format!("the file has {found} columns, but {} were declared", columns.len()))
        }
        (None, 1) => Ok(vec![TextColumn::Acceleration(None)]),
        (None, 2) => Ok(vec![TextColumn::Time, TextColumn::Acceleration(None)]),
        (None, _) => Err(format!("the file has {found} columns and does not say what they hold")),
    }
}

pub(super) fn read(source: &Source, options: &ReadOptions) -> Result<Vec<Channel>, Error> {
    let (units, dt) = declarations(source, options)?;
    let Table { columns, data, rows } = table(source, options.columns.as_deref())?;
    let first = rows[0];

    let times = columns.iter().zip(&data).filter(|(c, _)| **c == TextColumn::Time).map(|(_, d)| d);
    let times: Vec<&Vec<f64>> = times.collect();
    let (start, dt) = match (&times[..], dt) {
        ([times], dt) => time_base(source, &rows, times, dt)?,
        ([], Some(dt)) => (0.0, source.stated_interval(first, dt, None)?),
        ([], None) => {
            return Err(source.error(
                first,
                "the sampling interval is not known",
                "declare it, for example dt = \"0.005 s\", or give a column of time",
            ));
        }
        _ => return Err(source.error(first, "several columns of time", "declare one column as \"time\"")),
    };
    // Where a count is known, counts are meant.
    let implied = options.sensitivity.map(|_| Units::Counts);
    let Some(units) = units.or(implied) else {
        return Err(source.error(
            first,
            "the units of the numbers are not known",
            "declare them, for example units = \"cm/s2\" (or g, m/s2, mm/s2, counts); on the command line --units cm/s2",
        ));
    };
    let wanted = columns.iter().filter(|c| matches!(c, TextColumn::Acceleration(_))).count();
    if wanted == 0 {
        return Err(source.error(first, "no column holds acceleration", "declare one as \"acceleration\""));
    }
    let stated = if wanted == 1 { direction(source) } else { None };
    let mut channels = Vec::new();
    for (i, (column, values)) in columns.iter().zip(data).enumerate() {
        if let TextColumn::Acceleration(declared) = *column {
            let orientation = declared.or(stated);
            let label = (wanted > 1).then(|| label(orientation, i));
            let channel = Channel { start, orientation, ..source.channel(label.as_deref(), dt, values) };
            channels.push(source.converted(first, units, options, channel)?);
        }
    }
    Ok(channels)
}

fn label(orientation: Option<Orientation>, column: usize) -> String {
    match orientation {
        Some(Orientation::EAST) => "east".into(),
        Some(Orientation::NORTH) => "north".into(),
        Some(orientation) => orientation.to_string(),
        None => format!("column {}", column + 1),
    }
}

fn not_a_number(source: &Source, line: usize, word: &str) -> Error {
    source.error(
        line,
        format!("'{}' is not a finite number, and the file is of no other format known here", shown(word)),
        "put # before lines of text; `tremolite list formats` says which formats are read",
    )
}

/// The first line that is no numbers: a header, if numbers follow.
fn text_or_header(source: &Source, line: usize, word: &str) -> Error {
    let numbers = |text: &&str| words(text).next().is_some() && words(text).all(|w| number(w).is_some());
    if !source.lines[line + 1..].iter().any(numbers) {
        return not_a_number(source, line, word);
    }
    source.error(
        line,
        format!("'{}' is text above the numbers, and a file of plain columns has no header", shown(word)),
        "put # before each such line, and declare what the columns hold, for example columns = [\"time\", \
         \"acceleration\"]; `tremolite list formats` says which formats are read with their headers",
    )
}

/// The first number of a line that looks like `0,012`, and whether that is certain: no one separates whole numbers with
/// commas in one place and with blanks in another, or writes them as 012.
fn decimal_comma(text: &str) -> Option<(&str, bool)> {
    let words = || text.split([' ', '\t', ';']).filter(|w| !w.is_empty());
    let is_decimal = |word: &&str| {
        let digits = word.split_once(',').is_some_and(|(whole, fraction)| {
            whole.ends_with(|c: char| c.is_ascii_digit())
                && fraction.starts_with(|c: char| c.is_ascii_digit())
        });
        digits && number(&word.replacen(',', ".", 1)).is_some()
    };
    if text.contains('.') || words().any(|w| w.starts_with(',') || w.ends_with(',')) {
        return None;
    }
    let word = words().find(is_decimal)?;
    let (whole, fraction) = word.split_once(',')?;
    let zeros = whole == "-0" || (fraction.starts_with('0') && fraction.len() > 1);
    Some((word, zeros || words().nth(1).is_some()))
}

fn comma(source: &Source, line: usize, word: &str) -> Error {
    source.error(
        line,
        format!("'{}' has a decimal comma, but commas separate numbers here", shown(word)),
        "write decimal points in the whole file: 0.012",
    )
}

/// An error of a line, or what explains it: a decimal comma.
fn fault(source: &Source, line: usize, problem: String, remedy: &str) -> Error {
    let text = source.lines.get(line).map_or("", |text| text.split('#').next().unwrap_or(""));
    match decimal_comma(text) {
        Some((word, _)) => comma(source, line, word),
        None => source.error(line, problem, remedy),
    }
}

/// Units and interval from the file's own comments and from the options, which must not contradict them.
fn declarations(source: &Source, options: &ReadOptions) -> Result<(Option<Units>, Option<f64>), Error> {
    let (mut units, mut dt) = (options.units, options.dt);
    for (line, text) in source.lines.iter().enumerate() {
        let Some((key, value)) = text.trim_start().strip_prefix('#').and_then(|t| t.split_once('=')) else {
            continue;
        };
        let value = value.trim().trim_matches('"');
        // A comment that only resembles a declaration stays a comment.
        match key.trim() {
            "units" if value.parse::<Units>().is_ok() => {
                units = Some(source.stated_units(line, value, units)?)
            }
            "dt" => {
                let seconds = value.trim_end_matches('s').trim_end();
                if let Some(seconds) = number(seconds) {
                    dt = Some(source.stated_interval(line, seconds, dt)?);
                }
            }
            _ => {}
        }
    }
    Ok((units, dt))
}

/// The direction of a comment; the first that can be read.
fn direction(source: &Source) -> Option<Orientation> {
    source.lines.iter().find_map(|text| {
        let (key, value) = text.trim_start().strip_prefix('#')?.split_once('=')?;
        (key.trim() == "direction").then(|| Orientation::parse(value.trim().trim_matches('"'))).flatten()
    })
}

/// Start (s) and interval (s) of a column of times, which must be equally spaced.
fn time_base(
    source: &Source,
    rows: &[usize],
    times: &[f64],
    declared: Option<f64>,
) -> Result<(f64, f64), Error> {
    let (first, last) = (times[0], times[times.len() - 1]);
    let mean = (last - first) / (times.len() - 1) as f64;
    // Times are rounded in print; the mean is right to nine figures at best, and 0.005 should read 0.005.
    let dt = declared.unwrap_or(rounded(mean));
    // With a declared interval the column need only show that no sample is missing.
    let allowed = if declared.is_some() { 0.6 } else { 0.1 };
    let fits = |(i, &t): (usize, &f64)| dt > 0.0 && (t - first - i as f64 * dt).abs() <= allowed * dt;
    if let Some(i) = times.iter().enumerate().position(|time| !fits(time)) {
        return Err(unequal(source, rows, times, declared, i));
    }
    Ok((first, source.stated_interval(rows[0], dt, None)?))
}

/// A step counts as another where it differs from the usual one by more than this part of it: half a sample.
const OTHER_STEP: f64 = 0.5;

/// The fault of times that are not equally spaced. `out` is the first of them that lies off equal spacing from end to end, which a gap
/// anywhere puts near the beginning; so the step that differs is looked for beside the median of all steps.
fn unequal(source: &Source, rows: &[usize], times: &[f64], declared: Option<f64>, out: usize) -> Error {
    let mut steps: Vec<f64> = times.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let usual = declared.unwrap_or_else(|| {
        steps.sort_by(f64::total_cmp);
        rounded(steps[steps.len() / 2])
    });
    let differs = |pair: &[f64]| (pair[1] - pair[0] - usual).abs() > OTHER_STEP * usual;
    let resample = "resample the record, or declare what the columns hold, for example columns = [\"skip\", \"acceleration\"] with dt = \
                    \"0.005 s\"";
    let Some(k) = times.windows(2).position(differs).filter(|_| usual > 0.0) else {
        let (t, line) = (times[out], rows[out]);
        return fault(source, line, format!("time: {t} s (not equally spaced by {usual} s)"), resample);
    };
    let (from, to, line) = (times[k], times[k + 1], rows[k + 1]);
    let step = rounded(to - from);
    let problem = format!("time step: {step} s from {from} s to {to} s (usual step {usual} s)");
    let missing = rounded(step - usual);
    if missing > 0.0 {
        let samples = (missing / usual).round();
        let problem = format!("{problem}, missing samples: {samples} ({missing} s)");
        return fault(source, line, problem, "cut the record on one side of the gap, or fill the gap");
    }
    fault(source, line, problem, resample)
}

/// A time to eight digits, as the mean of an interval is.
fn rounded(seconds: f64) -> f64 {
    format!("{seconds:.8e}").parse().unwrap_or(seconds)
}
