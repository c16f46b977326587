//! Histories as a table of numbers: `monitors.csv` and `energy.csv`, read.

use std::collections::HashMap;
use std::fs;
use std::path::Path;
use std::sync::OnceLock;

use crate::{Column, Error, columns};

/// Whether a monitor, or another thing that heads a column, may have this name: one word without
/// comma, quote, square bracket or control character. Letters of any script are welcome.
pub fn is_name(name: &str) -> bool {
    let bad = |c: char| c.is_whitespace() || c.is_control() || matches!(c, ',' | '"' | '\'' | '[' | ']');
    !name.is_empty() && !name.contains(bad)
}

/// A table as read from a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// Headers, in the order of the file; not to be given other names once one was asked for.
    pub columns: Vec<Column>,
    /// `values[c][r]`: column `c`, row `r`. All columns have the same number of rows.
    pub values: Vec<Vec<f64>>,
    /// The file ended in the middle of a line, which was left out: it is being written, or was cut.
    pub cut: bool,
    places: Places,
}

/// Where columns are by name, once somebody asks: with many monitors there are hundreds of thousands, and each is asked for.
#[derive(Clone, Debug, Default)]
struct Places(OnceLock<HashMap<String, usize>>);

/// What is known of a table's columns is no part of what it is.
impl PartialEq for Places {
    fn eq(&self, _: &Places) -> bool {
        true
    }
}

impl Table {
    /// Of columns with their values, all of the same number of rows.
    pub fn new(columns: Vec<Column>, values: Vec<Vec<f64>>) -> Self {
        Table { columns, values, ..Table::default() }
    }

    /// Reads a table of comma-separated numbers under one line of headers.
    ///
    /// A last line without its line end is left out (`cut`): its last number may lack digits.
    /// NaN and infinities are read as such. Whose columns are is read from the file beside it ([`columns`]). Of columns with equal names, [`Table::column`] finds the first.
    ///
    /// # Errors
    /// [`Error::Io`]; [`Error::Format`] with the line for an empty file, a row of another length
    /// than the header, or a field that is not a number; those of the file of columns.
    pub fn read(path: &Path) -> Result<Self, Error> {
        let bytes = fs::read(path).map_err(Error::io(path, "read this file"))?;
        let text = str::from_utf8(&bytes).map_err(|e| {
            let line = bytes[..e.valid_up_to()].iter().filter(|&&b| b == b'\n').count() + 1;
            Error::format(
                path,
                Some(line),
                "not text in UTF-8; it was not written by this program, or is damaged",
            )
        })?;
        Self::parse(text, path)
    }

    fn parse(text: &str, path: &Path) -> Result<Self, Error> {
        let whole = text.rfind('\n').map_or("", |end| &text[..=end]);
        let mut lines = whole.lines().enumerate();
        let Some((_, header)) = lines.next().filter(|(_, header)| !header.trim().is_empty()) else {
            return Err(Error::format(path, Some(1), "no line of headers; the run wrote nothing here yet"));
        };
        let mut columns: Vec<Column> =
            header.trim_start_matches('\u{feff}').split(',').map(Column::parse).collect();
        columns::complete(path, &mut columns)?;
        let mut values = vec![Vec::new(); columns.len()];
        for (number, line) in lines.filter(|(_, line)| !line.trim().is_empty()) {
            let fault = |what: String| Error::format(path, Some(number + 1), what);
            let found = line.split(',').count();
            if found != columns.len() {
                return Err(fault(format!(
                    "{found} fields under {} headers; the file is damaged",
                    columns.len()
                )));
            }
            for ((field, column), values) in line.split(',').zip(&columns).zip(&mut values) {
                let field = field.trim();
                let value = field.parse().map_err(|_| {
                    let shown: String = field.chars().take(30).collect();
                    fault(format!("'{shown}' in column '{}' is not a number", column.name))
                })?;
                values.push(value);
            }
        }
        Ok(Table { cut: whole.len() < text.len(), ..Table::new(columns, values) })
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.values.first().map_or(0, Vec::len)
    }

    /// The values of the column with this name.
    pub fn column(&self, name: &str) -> Option<&[f64]> {
        Some(&self.values[self.place(name)?])
    }

    /// The first column with this name.
    fn place(&self, name: &str) -> Option<usize> {
        let places = self.places.0.get_or_init(|| {
            let mut places = HashMap::with_capacity(self.columns.len());
            for (k, column) in self.columns.iter().enumerate() {
                places.entry(column.name.clone()).or_insert(k);
            }
            places
        });
        places.get(name).copied()
    }

    /// The unit of the column with this name.
    pub fn unit(&self, name: &str) -> Option<&str> {
        self.place(name).map(|k| self.columns[k].unit.as_str())
    }
}
