//! Histories of a result folder.

use crate::arrays::column;
use crate::errors::unusable;
use pyo3::prelude::*;
use std::path::PathBuf;
use tremolite_results::{ResultFolder, Table};

/// A column: header name, quantity, unit, and whose it is, empty of nobody's.
type Header = (String, String, String, String);

/// Reads a table of numbers: its headers, an array (rows,) for each, and whether its last line was being written.
#[pyfunction]
fn read_table(py: Python<'_>, path: PathBuf) -> PyResult<(Vec<Header>, Vec<Bound<'_, PyAny>>, bool)> {
    let Table { columns, values, cut, .. } = py.detach(|| Table::read(&path)).map_err(unusable)?;
    let header = |column: tremolite_results::Column| {
        let whose = column.subject.name().unwrap_or_default();
        (column.name, column.quantity, column.unit, whose)
    };
    let arrays = values.into_iter().map(|values| column(py, values)).collect::<PyResult<_>>()?;
    Ok((columns.into_iter().map(header).collect(), arrays, cut))
}

/// Refuses a folder that holds no results.
#[pyfunction]
fn check_folder(path: PathBuf) -> PyResult<()> {
    ResultFolder::open_existing(&path).map(drop).map_err(unusable)
}

pub fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(read_table, module)?)?;
    module.add_function(wrap_pyfunction!(check_folder, module)?)
}
