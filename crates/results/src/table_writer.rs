//! Histories as a table of numbers: `monitors.csv` and `energy.csv`, written while the run goes on.

use std::collections::HashSet;
use std::io::Write;
use std::path::{Path, PathBuf};

use crate::table::is_name;
use crate::{Column, Error, columns, number};
use tremolite_files::Appended;

/// Writes a table row by row. Numbers are printed as [`number::push`] does it: no digit is lost,
/// and equal runs give equal bytes.
#[derive(Debug)]
pub struct TableWriter {
    file: Appended,
    path: PathBuf,
    columns: usize,
    bytes: u64,
    text: String,
}

impl TableWriter {
    /// Starts a table, replacing a file of that name, and writes the headers, and beside it whose columns they are
    /// ([`columns`]).
    ///
    /// # Errors
    /// [`Error::Format`] for a column whose name is not one plain word (see [`is_name`]), a unit with a
    /// comma or a line end, two columns of one name, or no column; [`Error::Io`].
    pub fn create(path: &Path, columns: &[Column]) -> Result<Self, Error> {
        let header = header(path, columns)?;
        columns::write(path, columns)?;
        let file = Appended::create(path).map_err(Error::io(path, "write this file"))?;
        let mut writer =
            TableWriter { file, path: path.to_owned(), columns: columns.len(), bytes: 0, text: header };
        writer.flush()?;
        Ok(writer)
    }

    /// Opens a table to go on with it after its first `bytes` bytes, as [`TableWriter::bytes_written`] told
    /// at a checkpoint. What was written later is cut off.
    ///
    /// # Errors
    /// [`Error::Format`] if the file is shorter, has other columns, or does not break after a row
    /// there: it is not the file of that checkpoint. It is then left as it is. [`Error::Io`].
    pub fn resume(path: &Path, columns: &[Column], bytes: u64) -> Result<Self, Error> {
        let file = reopen(path, &header(path, columns)?, bytes)?;
        Ok(TableWriter { file, path: path.to_owned(), columns: columns.len(), bytes, text: String::new() })
    }

    /// Writes one row, or several one after the other, and hands them to the operating system in
    /// one piece: another program can read them at once.
    ///
    /// # Panics
    /// If the number of values is not a multiple of the number of columns.
    ///
    /// # Errors
    /// [`Error::Io`], a full disk for one.
    pub fn write(&mut self, values: &[f64]) -> Result<(), Error> {
        assert_eq!(values.len() % self.columns, 0, "{} values for {} columns", values.len(), self.columns);
        for row in values.chunks_exact(self.columns) {
            for (column, &value) in row.iter().enumerate() {
                if column > 0 {
                    self.text.push(',');
                }
                number::push(&mut self.text, value);
            }
            self.text.push('\n');
        }
        self.flush()
    }

    /// Bytes in the file so far. A checkpoint keeps this number for [`TableWriter::resume`].
    pub fn bytes_written(&self) -> u64 {
        self.bytes
    }

    /// Waits until all is on the disk. A checkpoint does this before it records the length.
    ///
    /// # Errors
    /// [`Error::Io`].
    pub fn sync(&self) -> Result<(), Error> {
        self.file.sync().map_err(Error::io(&self.path, "write this file"))
    }

    fn flush(&mut self) -> Result<(), Error> {
        self.file.write_all(self.text.as_bytes()).map_err(Error::io(&self.path, "write this file"))?;
        self.bytes += self.text.len() as u64;
        self.text.clear();
        Ok(())
    }
}

/// Opens a table of these headers (with their line end) behind its first `bytes` bytes, and cuts off what was written later.
///
/// # Errors
/// As [`TableWriter::resume`].
pub(crate) fn reopen(path: &Path, header: &str, bytes: u64) -> Result<Appended, Error> {
    let mut file = Appended::open(path).map_err(Error::io(path, "open this file to go on with it"))?;
    let found = file.length().map_err(Error::io(path, "read this file"))?;
    if found < bytes {
        let what = format!(
            "{found} bytes long, but the checkpoint was made at {bytes}; put the file of that run back, or \
             start the run anew"
        );
        return Err(Error::format(path, None, what));
    }
    let foreign = "not the table of the run that made the checkpoint; put that file back, or start anew";
    if bytes < header.len() as u64 {
        return Err(Error::format(path, None, foreign));
    }
    let mut start = vec![0; header.len()];
    let mut end = [0];
    file.read(0, &mut start)
        .and_then(|()| file.read(bytes - 1, &mut end))
        .map_err(Error::io(path, "read this file"))?;
    if start != header.as_bytes() || end != *b"\n" {
        return Err(Error::format(path, None, foreign));
    }
    file.cut(bytes).map_err(Error::io(path, "cut this file at the checkpoint"))?;
    Ok(file)
}

fn header(path: &Path, columns: &[Column]) -> Result<String, Error> {
    let mut seen = HashSet::new();
    for column in columns {
        let Column { name, unit, .. } = column;
        if !is_name(name) {
            let what = format!(
                "'{}' cannot head a column; give a name without blanks, commas, quotes and square brackets",
                name.escape_debug()
            );
            return Err(Error::format(path, None, what));
        }
        if unit.contains(|c: char| matches!(c, ',' | '"' | '[' | ']') || c.is_control()) {
            let what = format!("column '{name}': '{}' cannot be written as a unit", unit.escape_debug());
            return Err(Error::format(path, None, what));
        }
        if !seen.insert(name) {
            return Err(Error::format(
                path,
                None,
                format!("two columns named '{name}'; give each its own name"),
            ));
        }
    }
    if columns.is_empty() {
        return Err(Error::format(path, None, "a table needs at least one column"));
    }
    let mut text = columns.iter().map(Column::header).collect::<Vec<_>>().join(",");
    text.push('\n');
    Ok(text)
}
