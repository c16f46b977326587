//! Histories as a table of numbers: `monitors.csv` and `energy.csv`, written while the run goes on.

use std::collections::HashSet;
use std::path::Path;

use crate::growing_file::GrowingFile;
use crate::table::is_name;
use crate::{Column, Error, Extent, columns, number};

/// Writes a table row by row. Numbers are printed as [`number::push`] does it: no digit is lost,
/// and equal runs give equal bytes.
#[derive(Debug)]
pub struct TableWriter {
    file: GrowingFile,
    columns: usize,
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
        let file = GrowingFile::create(path)?;
        let mut writer = TableWriter { file, columns: columns.len(), text: header };
        writer.flush()?;
        Ok(writer)
    }

    /// Opens a table to go on with it behind what [`TableWriter::extent`] told at a checkpoint. What was written later is cut off, and whose
    /// columns they are is written again.
    ///
    /// # Errors
    /// [`Error::Format`] if the file is shorter, has other columns, does not break after a row there, or does not hold what it held:
    /// it is not the file of that checkpoint. It is then left as it is. [`Error::Io`].
    pub fn resume(path: &Path, columns: &[Column], extent: Extent) -> Result<Self, Error> {
        let file = GrowingFile::resume(path, &header(path, columns)?, extent)?;
        columns::write(path, columns)?;
        Ok(TableWriter { file, columns: columns.len(), text: String::new() })
    }

    /// The same for whoever wrote the table a moment ago: it does not read what stands in it.
    pub(crate) fn go_on(path: &Path, columns: &[Column], extent: Extent) -> Result<Self, Error> {
        let file = GrowingFile::go_on(path, &header(path, columns)?, extent)?;
        Ok(TableWriter { file, columns: columns.len(), text: String::new() })
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

    /// What is in the file so far. A checkpoint keeps it for [`TableWriter::resume`].
    pub fn extent(&self) -> Extent {
        self.file.extent()
    }

    /// Waits until all is on the disk. A checkpoint does this before it records the extent.
    ///
    /// # Errors
    /// [`Error::Io`].
    pub fn sync(&self) -> Result<(), Error> {
        self.file.sync()
    }

    fn flush(&mut self) -> Result<(), Error> {
        self.file.put(self.text.as_bytes())?;
        self.text.clear();
        Ok(())
    }
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
