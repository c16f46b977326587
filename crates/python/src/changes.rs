//! Values by the paths of their keys, as a script gives them.

use pyo3::prelude::*;
use pyo3::types::PyDict;
use tremolite_case::Change;

/// The changes of a dict: a text stays a text, whatever it looks like.
///
/// # Errors
/// If a value is none that a case can hold.
pub fn of_dict(changes: &Bound<'_, PyDict>) -> PyResult<Vec<Change>> {
    let py = changes.py();
    let written = py.import("tremolite._toml")?.getattr("value")?;
    let change = |(key, value): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        let key: String = key.extract()?;
        let value: String = written.call1((value, key.as_str()))?.extract()?;
        Ok(Change::new(key, value))
    };
    changes.iter().map(change).collect()
}
