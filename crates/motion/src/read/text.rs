//! Columns of numbers, and one series in rows of numbers.
//!
//! Numbers are separated by blanks, tabs, commas or semicolons, so a decimal comma is refused. `#` begins a comment.
//! Comments of the form `# units = "cm/s2"`, `# dt = "0.005 s"` and `# columns = ["east", "north", "up"]` count as declarations,
//! written as in a case file, and `# direction = "332"` (azimuth in degrees, `up` or `down`) as the positive direction of the
//! one column of acceleration. The only header is the number of samples and the interval, on one line or on two. Numbers are one
//! series in rows where that is declared, or where the file states as many samples as it has numbers.

use super::header::Direction;
use super::source::{Source, leading_number, number};
use super::{ReadOptions, TextColumn};
use crate::shown::shown;
use crate::{Channel, Error, Orientation, Units};

/// The numbers of a file.
struct Numbers<'a> {
    values: Vec<f64>,
    /// Line index of each row, and where its values begin.
    rows: Vec<(usize, usize)>,
    /// The first four words, for what a header may be.
    first: Vec<&'a str>,
}

impl Numbers<'_> {
    /// How many numbers the `i`-th row has.
    fn width(&self, i: usize) -> usize {
        self.rows.get(i + 1).map_or(self.values.len(), |r| r.1) - self.rows[i].1
    }

    /// The first row from the `begin`-th on, the last excepted if `last` is false, that is not as wide as that one.
    fn uneven(&self, begin: usize, last: bool) -> Option<usize> {
        let end = if last { self.rows.len() } else { self.rows.len() - 1 };
        (begin..end).find(|&i| self.width(i) != self.width(begin))
    }
}

/// A header of two numbers.
struct Counts {
    /// Rows of it.
    rows: usize,
    count: usize,
    dt: f64,
}

/// Declarations of a file's comments and of the options.
struct Declared {
    units: Option<Units>,
    dt: Option<f64>,
    columns: Option<Vec<TextColumn>>,
    /// A number of samples that a comment states, with its line index.
    count: Option<(usize, usize)>,
}

/// What the numbers are taken for.
struct Layout {
    columns: Vec<TextColumn>,
    /// Whether `columns` is one series, row by row.
    rows: bool,
    remark: Option<String>,
}

fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split([' ', '\t', ',', ';']).filter(|w| !w.is_empty())
}

/// All numbers outside comments.
fn numbers<'a>(source: &Source<'a>) -> Result<Numbers<'a>, Error> {
    let mut found = Numbers { values: Vec::new(), rows: Vec::new(), first: Vec::new() };
    for (line, text) in source.lines.iter().enumerate() {
        let text = text.split('#').next().unwrap_or("");
        if words(text).next().is_none() {
            continue;
        }
        if let Some((word, true)) = decimal_comma(text) {
            return Err(comma(source, line, word));
        }
        // A line of words is the likelier fault than a wrong number of columns.
        if found.rows.is_empty()
            && let Some(word) = words(text).find(|w| number(w).is_none())
        {
            return Err(text_or_header(source, line, word));
        }
        found.rows.push((line, found.values.len()));
        for word in words(text) {
            found.values.push(number(word).ok_or_else(|| not_a_number(source, line, word))?);
            if found.first.len() < 4 {
                found.first.push(word);
            }
        }
    }
    match found.rows[..] {
        [] => Err(source.error(0, "the file holds no numbers", "check that it is the record you mean")),
        [(only, _)] => Err(source.error(only, "there is one line of numbers", "a record needs at least two")),
        _ => Ok(found),
    }
}

/// The number of samples and the interval above the samples, on one line or on two, in either order.
///
/// # Errors
/// At the first line, if it can only be such a header and as many samples do not follow.
fn counts(source: &Source, numbers: &Numbers) -> Result<Option<Counts>, Error> {
    let rows = match (numbers.width(0), numbers.width(1)) {
        (2, _) => 1,
        (1, 1) if numbers.rows.len() > 3 => 2,
        _ => return Ok(None),
    };
    let whole = |i: usize| numbers.first.get(i)?.parse::<usize>().ok().filter(|n| *n >= 2);
    let interval = |i: usize| numbers.values.get(i).copied().filter(|dt| *dt > 0.0 && *dt <= 1.0);
    let pair = whole(0).zip(interval(1)).or_else(|| whole(1).zip(interval(0)));
    let Some((count, dt)) = pair.filter(|_| numbers.rows.len() > rows) else { return Ok(None) };
    let (there, lines) = (numbers.values.len() - 2, numbers.rows.len() - rows);
    // Times that go on from the first row are no samples below a header.
    let pairs = rows == 1 && numbers.width(1) == 2;
    if (count == there || count == lines) && !(pairs && numbers.values[2] > numbers.values[0]) {
        return Ok(Some(Counts { rows, count, dt }));
    }
    let others = &numbers.values[2..];
    let header = match (rows, numbers.width(rows)) {
        // Times do not go back, and samples are no larger than their number.
        (1, 2) => others.len() > 2 && others[0] < numbers.values[0] && others[0] < others[2],
        (1, _) => true,
        _ => {
            count >= 100
                && others.iter().all(|x| x.abs() < count as f64 / 10.0)
                && others.iter().any(|x| x.fract() != 0.0)
        }
    };
    if !header {
        return Ok(None);
    }
    let line = numbers.rows[0].0;
    let problem = format!("header: {count} samples every {dt} s ({there} numbers on {lines} lines follow)");
    Err(source.error(line, problem, "correct the number, or put # before the header and declare dt"))
}

/// What the numbers from row `begin` on are: as declared, or by a stated count, else acceleration or time and acceleration.
fn layout(
    source: &Source,
    numbers: &Numbers,
    begin: usize,
    declared: &Declared,
    stated: Option<(usize, usize)>,
) -> Result<Layout, Error> {
    let (first, width) = (numbers.rows[begin].0, numbers.width(begin));
    let (there, lines) = (numbers.values.len() - numbers.rows[begin].1, numbers.rows.len() - begin);
    let in_rows = stated.filter(|(count, _)| width > 1 && *count == there && *count != lines);
    let columns = |columns: Vec<TextColumn>| match numbers.uneven(begin, true) {
        Some(odd) => Err(fault(
            source,
            numbers.rows[odd].0,
            format!("{} number(s) on this line, {width} on the first", numbers.width(odd)),
            "complete or remove the line",
        )),
        None => Ok(Layout { columns, rows: false, remark: None }),
    };
    let rows = |remark: Option<String>| match numbers.uneven(begin, false) {
        Some(odd) => Err(source.error(
            numbers.rows[odd].0,
            format!("{} number(s) on this line, {width} on the first row", numbers.width(odd)),
            "complete or remove the line",
        )),
        None => Ok(Layout { columns: vec![TextColumn::Acceleration(None)], rows: true, remark }),
    };
    let several =
        "declare every column, for example columns = [\"time\", \"acceleration\", \"skip\", \"skip\"]";
    match (declared.columns.as_deref(), in_rows, width) {
        (Some([TextColumn::Rows]), ..) => rows(None),
        (Some(declared), ..) if declared.contains(&TextColumn::Rows) => {
            Err(source.error(first, "columns: \"rows\" stands beside others", "declare columns = [\"rows\"] alone"))
        }
        (Some(_), Some((count, line)), _) => Err(source.error(
            first,
            format!("columns: {width} declared, but line {} states {count} samples, and the rows hold as many numbers", line + 1),
            "declare one series in rows: columns = [\"rows\"], on the command line --columns rows",
        )),
        (Some(declared), ..) if declared.len() == width => columns(declared.to_vec()),
        (Some(declared), ..) => {
            let problem = format!("the file has {width} columns, but {} were declared", declared.len());
            Err(fault(source, first, problem, several))
        }
        (None, Some((count, line)), _) => rows(Some(format!(
            "The numbers, {width} on a line, are one series, row by row: line {} states {count} samples.",
            line + 1
        ))),
        (None, _, 1) => columns(vec![TextColumn::Acceleration(None)]),
        (None, _, 2) => columns(vec![TextColumn::Time, TextColumn::Acceleration(None)]),
        (None, ..) => Err(fault(
            source,
            first,
            format!(
                "numbers on a line: {width}, which are {width} columns of {lines} samples or one series of {there} samples in rows"
            ),
            "declare the columns from the left, for example columns = [\"time\", \"acceleration\", \"skip\"] (--columns time,acceleration,skip), or \
             columns = [\"rows\"] (--columns rows)",
        )),
    }
}

pub(super) fn read(source: &Source, options: &ReadOptions) -> Result<Vec<Channel>, Error> {
    let declared = declarations(source, options)?;
    let numbers = numbers(source)?;
    let header = counts(source, &numbers)?;
    let begin = header.as_ref().map_or(0, |h| h.rows);
    let first = numbers.rows[begin].0;
    let stated = header.as_ref().map(|h| (h.count, numbers.rows[0].0)).or(declared.count);
    let Layout { columns, rows, remark } = layout(source, &numbers, begin, &declared, stated)?;
    let mut remarks: Vec<String> = remark.into_iter().collect();
    let mut dt = declared.dt;
    if let Some(Counts { count, dt: interval, .. }) = header {
        dt = Some(source.stated_interval(numbers.rows[0].0, interval, dt)?);
        remarks.push(format!(
            "The first two numbers were taken as a header: {count} samples every {interval} s."
        ));
    }
    let values = &numbers.values[numbers.rows[begin].1..];
    let width = if rows { 1 } else { columns.len() };
    let column = |i: usize| values.iter().skip(i).step_by(width).copied().collect::<Vec<f64>>();
    let lines: Vec<usize> = numbers.rows[begin..].iter().map(|r| r.0).collect();

    let times: Vec<usize> = (0..width).filter(|i| columns[*i] == TextColumn::Time).collect();
    let (start, dt) = match (&times[..], dt) {
        ([i], dt) => time_base(source, &lines, &column(*i), dt)?,
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
    let Some(units) = declared.units.or(implied) else {
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
    let stated = if wanted == 1 { direction(source) } else { Direction::Unknown };
    let mut channels = Vec::new();
    for (i, what) in columns.iter().enumerate() {
        if let TextColumn::Acceleration(declared) = *what {
            let direction = declared.map_or(stated, Direction::Along);
            let label = (wanted > 1).then(|| label(declared, i));
            let remarks = remarks.clone();
            let channel = Channel { start, remarks, ..source.channel(label.as_deref(), dt, column(i)) };
            channels.push(source.converted(first, units, options, direction.given_to(channel))?);
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

/// Declarations of the file's own comments and of the options, which must not contradict each other.
fn declarations(source: &Source, options: &ReadOptions) -> Result<Declared, Error> {
    let ReadOptions { units, dt, columns, .. } = options.clone();
    let mut declared = Declared { units, dt, columns, count: None };
    for (line, text) in source.lines.iter().enumerate() {
        let Some(comment) = text.trim_start().strip_prefix('#') else { continue };
        declared.count = declared.count.or_else(|| Some((stated_count(comment)?, line)));
        let Some((key, value)) = comment.split_once('=') else { continue };
        let value = value.trim().trim_matches('"');
        // A comment that only resembles a declaration stays a comment.
        match key.trim() {
            "units" if value.parse::<Units>().is_ok() => {
                declared.units = Some(source.stated_units(line, value, declared.units)?)
            }
            "dt" => {
                let seconds = value.trim_end_matches('s').trim_end();
                if let Some(seconds) = number(seconds) {
                    declared.dt = Some(source.stated_interval(line, seconds, declared.dt)?);
                }
            }
            "columns" => declared.columns = Some(stated_columns(source, line, value, declared.columns)?),
            _ => {}
        }
    }
    Ok(declared)
}

/// The columns of a comment such as `["time", "east"]` or `time, east`.
fn stated_columns(
    source: &Source,
    line: usize,
    value: &str,
    declared: Option<Vec<TextColumn>>,
) -> Result<Vec<TextColumn>, Error> {
    let words = words(value).map(|w| w.trim_matches(['[', ']', '"', '\''])).filter(|w| !w.is_empty());
    let columns = words.map(str::parse).collect::<Result<Vec<TextColumn>, String>>().map_err(|problem| {
        source.error(line, problem, "write the comment as # columns = time, east, skip")
    })?;
    match declared {
        Some(other) if other != columns => Err(source.error(
            line,
            "the file states other columns than were declared",
            "remove the declaration, or correct whichever is wrong",
        )),
        _ => Ok(columns),
    }
}

/// The number of samples in a comment such as `NO. OF POINTS:  1200` or `NPTS=1200`.
fn stated_count(comment: &str) -> Option<usize> {
    let upper = comment.to_ascii_uppercase();
    let names = ["NPTS", "NO. OF POINTS", "NUMBER OF POINTS", "NUMBER OF SAMPLES", "NUMBER OF DATA", "NDATA"];
    let rest = names.iter().find_map(|name| Some(&upper[upper.find(name)? + name.len()..]))?;
    leading_number(rest.trim_start_matches([' ', '=', ':']))?.trim_end_matches('.').parse().ok()
}

/// The direction of a comment; the first that can be read.
fn direction(source: &Source) -> Direction {
    let stated = source.lines.iter().filter_map(|text| {
        let (key, value) = text.trim_start().strip_prefix('#')?.split_once('=')?;
        (key.trim() == "direction").then(|| Direction::parse(value.trim().trim_matches('"')))
    });
    stated.into_iter().find(|d| *d != Direction::Unknown).unwrap_or(Direction::Unknown)
}

/// Start (s) and interval (s) of a column of times, which must be equally spaced.
pub(super) fn time_base(
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
