//! Rows of a script's own tables, from what it gives.

use crate::errors::unusable;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use tremolite_results::Column;
use tremolite_results::own_table::{OwnRow, column, is_file_name};

/// The row of a table at a time \[s\]: a number or an array (n,) under each head.
///
/// # Errors
/// If the table can have no such name or column, or a value is no number.
pub fn row(table: &str, time: f64, values: &Bound<'_, PyDict>) -> PyResult<OwnRow> {
    if !is_file_name(table) {
        return Err(unusable(format!(
            "{table:?} is no name of a table: it is that of a file, of letters, digits, `_`, `-` and dots"
        )));
    }
    let mut row =
        OwnRow { table: table.to_owned(), columns: vec![Column::new("time", "s")], values: vec![time] };
    for (head, value) in values {
        let head: String = head.extract()?;
        let Some(Column { name, unit, .. }) = column(&head) else {
            return Err(unusable(format!("{head:?} heads no column; write a word and its unit, \"ux [m]\"")));
        };
        let refused = || {
            unusable(format!(
                "{table}: {head:?} is given {value}, which is no number and no array (n,) of some"
            ))
        };
        let numbers = value
            .py()
            .import("numpy")?
            .call_method1("asarray", (&value, "float64"))
            .map_err(|_| refused())?;
        match numbers.getattr("ndim")?.extract::<usize>()? {
            0 => {
                row.columns.push(Column::new(name, unit));
                row.values.push(numbers.extract()?);
            }
            1 => {
                let numbers: Vec<f64> = numbers.extract()?;
                row.columns
                    .extend((0..numbers.len()).map(|k| Column::new(format!("{name}{k}"), unit.clone())));
                row.values.extend(numbers);
            }
            _ => return Err(refused()),
        }
    }
    let twice = |c: &Column| row.columns.iter().filter(|other| other.name == c.name).count() > 1;
    match row.columns.iter().find(|column| twice(column)) {
        _ if row.columns.len() == 1 => Err(unusable(format!("{table}: no number is given to record"))),
        Some(column) => Err(unusable(format!("{table}: two columns are called {:?}", column.name))),
        None => Ok(row),
    }
}
