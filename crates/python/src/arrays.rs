//! Arrays for Python: they own their numbers, without a copy of what is given here, and are read-only.

use numpy::ndarray::Array2;
use numpy::{Element, IntoPyArray};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// An array (n, N) of n rows.
///
/// # Errors
/// If NumPy is not there.
pub fn rows<T: Element, const N: usize>(py: Python<'_>, rows: Vec<[T; N]>) -> PyResult<Bound<'_, PyAny>> {
    matrix(py, N, rows.into_flattened())
}

/// An array (n, `columns`) of numbers row by row.
///
/// # Errors
/// If NumPy is not there.
pub fn matrix<T: Element>(py: Python<'_>, columns: usize, numbers: Vec<T>) -> PyResult<Bound<'_, PyAny>> {
    let shape = (numbers.len() / columns.max(1), columns);
    let made = Array2::from_shape_vec(shape, numbers).map_err(crate::errors::unusable)?;
    frozen(made.into_pyarray(py).into_any())
}

/// An array (n,).
///
/// # Errors
/// If NumPy is not there.
pub fn column<T: Element>(py: Python<'_>, numbers: Vec<T>) -> PyResult<Bound<'_, PyAny>> {
    frozen(numbers.into_pyarray(py).into_any())
}

fn frozen(array: Bound<'_, PyAny>) -> PyResult<Bound<'_, PyAny>> {
    let flags = PyDict::new(array.py());
    flags.set_item("write", false)?;
    array.call_method("setflags", (), Some(&flags))?;
    Ok(array)
}
