//! Pages, and comparisons, from result files alone.

use crate::errors::{failed, unusable};
use pyo3::prelude::*;
use std::path::PathBuf;
use tremolite_report::Language;

/// A language by its word.
///
/// # Errors
/// If it is none of the page's.
pub fn language(word: Option<&str>) -> PyResult<Option<Language>> {
    word.map(|word| {
        word.parse()
            .map_err(|_| unusable(format!("{word:?} is no language of the page; give \"en\" or \"zh\"")))
    })
    .transpose()
}

/// Writes figures and report.html of a result folder; the page's path.
#[pyfunction]
#[pyo3(signature = (folder, language = None))]
fn write_page(py: Python<'_>, folder: PathBuf, language: Option<&str>) -> PyResult<PathBuf> {
    let language = self::language(language)?;
    py.detach(|| match language {
        Some(language) => tremolite_report::write_in(&folder, language),
        None => tremolite_report::write(&folder),
    })
    .map_err(failed)
}

/// Writes the comparison of result folders into the file `page`.
#[pyfunction]
#[pyo3(signature = (folders, page, language = None))]
fn write_comparison(
    py: Python<'_>,
    folders: Vec<PathBuf>,
    page: PathBuf,
    language: Option<&str>,
) -> PyResult<()> {
    let language = self::language(language)?;
    py.detach(|| tremolite_report::compare(&folders, &page, language)).map_err(failed)
}

/// What differs between two result folders beyond what may between runs of the same bits.
#[pyfunction]
fn differences(py: Python<'_>, one: PathBuf, other: PathBuf) -> PyResult<Vec<String>> {
    py.detach(|| tremolite_results::differences(&one, &other)).map_err(unusable)
}

pub fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(differences, module)?)?;
    module.add_function(wrap_pyfunction!(write_page, module)?)?;
    module.add_function(wrap_pyfunction!(write_comparison, module)?)
}
