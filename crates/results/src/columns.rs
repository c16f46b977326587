//! `monitors.columns.json` beside `monitors.csv`, and so for every table with columns of somebody's: whose each is and which
//! quantity, in the table's order.
//!
//! A file for each table, not one for the folder: who writes a table writes it, without regard to others that do the same, and
//! a table that is carried elsewhere takes it along.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::column::{Column, Subject};
use crate::replace::replace_file;
use crate::{Error, by_name};

/// Where the columns of a table are told.
pub fn beside(table: &Path) -> PathBuf {
    table.with_extension("columns.json")
}

/// Writes it; no file for a table of which nothing is anybody's.
///
/// # Errors
/// [`Error::Io`].
pub fn write(table: &Path, columns: &[Column]) -> Result<(), Error> {
    let path = beside(table);
    if columns.iter().all(|column| column.subject == Subject::None) {
        return match fs::remove_file(&path) {
            Err(e) if e.kind() != io::ErrorKind::NotFound => {
                Err(Error::io(&path, "remove the earlier results")(e))
            }
            _ => Ok(()),
        };
    }
    // One line a column. Strings alone cannot fail to become JSON.
    let line = |column: &Column| serde_json::to_string(column).unwrap_or_default();
    let lines: Vec<String> = columns.iter().map(line).collect();
    replace_file(&path, format!("[\n{}\n]\n", lines.join(",\n")).as_bytes())
}

/// Completes the columns of a table that were read from its headers; without the file, as in folders of older versions, by
/// their names.
///
/// # Errors
/// [`Error::Io`]; [`Error::Format`] if the file is damaged or tells of other columns.
pub(crate) fn complete(table: &Path, columns: &mut Vec<Column>) -> Result<(), Error> {
    let path = beside(table);
    let text = match fs::read_to_string(&path) {
        Err(e) if e.kind() == io::ErrorKind::NotFound => {
            let kind = table.file_stem().unwrap_or_default().to_string_lossy();
            by_name::complete(&kind, columns);
            return Ok(());
        }
        text => text.map_err(Error::io(&path, "read this file"))?,
    };
    let told: Vec<Column> = serde_json::from_str(&text)
        .map_err(|e| Error::format(&path, Some(e.line()), format!("{e}; the file is damaged")))?;
    let header = |column: &Column| column.header();
    if !told.iter().map(header).eq(columns.iter().map(header)) {
        let name = table.file_name().unwrap_or_default().to_string_lossy();
        let what = format!("tells of other columns than {name} has; put back the two files of one run");
        return Err(Error::format(&path, None, what));
    }
    *columns = told;
    Ok(())
}
