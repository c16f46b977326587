//! TOML as Python's own values.

use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use toml::de::{DeTable, DeValue};

/// A table as a dict.
pub fn dict<'py>(py: Python<'py>, table: &DeTable<'_>) -> PyResult<Bound<'py, PyDict>> {
    let made = PyDict::new(py);
    let mut entries: Vec<_> = table.iter().collect();
    // As they stand in the text.
    entries.sort_by_key(|(key, _)| key.span().start);
    for (key, entry) in entries {
        made.set_item(key.get_ref().as_ref(), value(py, entry.get_ref())?)?;
    }
    Ok(made)
}

fn value<'py>(py: Python<'py>, value: &DeValue<'_>) -> PyResult<Bound<'py, PyAny>> {
    match value {
        DeValue::String(text) => text.as_ref().into_bound_py_any(py),
        DeValue::Integer(number) => {
            i64::from_str_radix(number.as_str(), number.radix()).unwrap_or_default().into_bound_py_any(py)
        }
        DeValue::Float(number) => number.as_str().parse::<f64>().unwrap_or(f64::NAN).into_bound_py_any(py),
        DeValue::Boolean(truth) => truth.into_bound_py_any(py),
        DeValue::Datetime(date) => date.to_string().into_bound_py_any(py),
        DeValue::Array(entries) => {
            let list = PyList::empty(py);
            for entry in entries {
                list.append(self::value(py, entry.get_ref())?)?;
            }
            Ok(list.into_any())
        }
        DeValue::Table(table) => Ok(dict(py, table)?.into_any()),
    }
}
