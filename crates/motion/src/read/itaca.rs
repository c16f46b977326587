//! Files of ITACA before DYNA: one component a file.
//!
//! About ten lines of header, `KEY : value`, the last of which names the series and its unit (`Accelaration time
//! series in m/s/s`, so spelt), then numbers five a line in columns of 14 characters that touch.

use super::ReadOptions;
use super::source::{Columns, Source, number};
use crate::shown::shown;
use crate::{Channel, Error, Orientation};

/// How far down the line that names the series may stand.
const HEADER_LINES: usize = 30;
const COLUMNS: Columns = Columns { per_line: 5, width: 14 };
const CORRUPT: &str = "fetch the file from ITACA again";

pub(super) fn recognises(source: &Source) -> bool {
    source.lines[0].starts_with("Event Date & Time") && value(source, "Number of Data").is_some()
}

/// The value of a key of the header, with its line.
fn value<'a>(source: &Source<'a>, key: &str) -> Option<(usize, &'a str)> {
    let header = source.lines.iter().take(HEADER_LINES).enumerate();
    header.filter_map(|(i, l)| Some((i, l.strip_prefix(key)?.trim_start().strip_prefix(':')?.trim()))).next()
}

pub(super) fn read(source: &Source, options: &ReadOptions) -> Result<Vec<Channel>, Error> {
    let stated = |key: &str| {
        value(source, key)
            .ok_or_else(|| source.error(0, format!("no line of the header begins with '{key}'"), CORRUPT))
    };
    let title = source.lines.iter().take(HEADER_LINES).position(|l| l.contains("time series"));
    let Some(title) = title else {
        return Err(source.error(HEADER_LINES, "no line of the header names the time series", CORRUPT));
    };
    if !source.lines[title].starts_with("Accel") {
        return Err(source.error(
            title,
            format!("'{}' is no acceleration", shown(source.lines[title])),
            "give the file of acceleration of this component (its name has .acc)",
        ));
    }
    let units = match (source.lines[title].split_once(" in "), options.units) {
        (Some((_, word)), declared) => source.stated_units(title, word, declared)?,
        (None, Some(declared)) => declared,
        (None, None) => {
            return Err(source.error(
                title,
                "the header does not state the units",
                "declare them, for example units = \"m/s2\"",
            ));
        }
    };
    let (line, text) = stated("Time Increment (s)")?;
    let dt = number(text).ok_or_else(|| source.error(line, "the sampling interval is missing", CORRUPT))?;
    let dt = source.stated_interval(line, dt, options.dt)?;
    let (line, text) = stated("Number of Data")?;
    let count: usize = text
        .parse()
        .map_err(|_| source.error(line, format!("'{}' is no number of samples", shown(text)), CORRUPT))?;
    let (_, label) = stated("Orientation")?;
    // Italian for what others call EW: from west to east.
    let orientation = if label == "WE" { Some(Orientation::EAST) } else { Orientation::parse(label) };

    let (values, end) = source.block(title + 1, COLUMNS, count, CORRUPT)?;
    let beyond = count.div_ceil(COLUMNS.per_line) * COLUMNS.per_line - count;
    let full =
        end > 0 && beyond > 0 && COLUMNS.word(source.lines[end - 1], COLUMNS.per_line - beyond).is_some();
    let more = source.lines[end..].iter().position(|l| !l.trim().is_empty());
    if let Some(line) = if full { Some(end - 1) } else { more.map(|i| end + i) } {
        return Err(source.error(
            line,
            format!("numbers go on after the {count} samples that the header promises"),
            CORRUPT,
        ));
    }
    let channel = Channel { orientation, ..source.channel(None, dt, values) };
    Ok(vec![source.converted(line, units, options, channel)?])
}
