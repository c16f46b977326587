//! Studies: their plan, and their page. What runs them is the command, in a process of its own.

use crate::errors::{failed, refused};
use crate::report::language;
use pyo3::prelude::*;
use std::path::PathBuf;

/// The plan of a study by its text, as the command lists it; all of it is checked, and so is the case of every run.
#[pyfunction]
fn study_plan(py: Python<'_>, path: PathBuf, text: &str) -> PyResult<String> {
    py.detach(|| tremolite_cli::study_plan(&path, text)).map_err(|report| refused(py, &report))
}

/// Writes figures and page of a study's folder; the page's path.
#[pyfunction]
#[pyo3(signature = (folder, language = None))]
fn write_study_page(py: Python<'_>, folder: PathBuf, language: Option<&str>) -> PyResult<PathBuf> {
    let language = self::language(language)?;
    py.detach(|| tremolite_report::study(&folder, language)).map_err(failed)
}

pub fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(study_plan, module)?)?;
    module.add_function(wrap_pyfunction!(write_study_page, module)?)
}
