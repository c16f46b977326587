//! A law at a point, along a path.

use crate::arrays::{column, rows};
use crate::errors::{refused, unusable};
use numpy::{PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::collections::BTreeSet;
use std::path::Path;
use tremolite_case::{LawFile, LawKind};
use tremolite_kernels::follow;
use tremolite_laws::interface_path::{Across, InterfacePath};
use tremolite_laws::materials::MATERIALS;
use tremolite_laws::path::{self, Control, PathError};
use tremolite_laws::{Column, Isa};

/// A law with its parameters, checked as in a case.
#[pyclass(frozen, module = "tremolite")]
pub struct LawCore {
    law: LawFile,
}

#[pymethods]
impl LawCore {
    /// A law from the text of a law file: one `[material]` or one `[interface]`.
    #[new]
    fn new(py: Python<'_>, text: &str) -> PyResult<Self> {
        match LawFile::parse(Path::new("law.toml"), text, MATERIALS) {
            Ok(law) => Ok(LawCore { law }),
            Err(report) => Err(refused(py, &report)),
        }
    }

    /// Whether it is the law of an interface.
    #[getter]
    fn interface(&self) -> bool {
        self.law.kind == LawKind::Interface
    }

    /// Its numbers in SI, defaults filled in.
    #[getter]
    fn parameters<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let made = PyDict::new(py);
        for name in self.law.parameters.0.keys() {
            if let Some(number) = self.law.parameters.optional(name) {
                made.set_item(name, number)?;
            } else if let Some(word) = self.law.parameters.word(name) {
                made.set_item(name, word)?;
            }
        }
        Ok(made)
    }

    /// What is unusual about them, a sentence each.
    #[getter]
    fn warnings(&self) -> Vec<String> {
        let LawFile { law, parameters, .. } = &self.law;
        match self.law.kind {
            LawKind::Material => follow::warnings(&law.value, parameters),
            LawKind::Interface => follow::interface_warnings(&law.value, parameters),
        }
    }

    /// Follows a material along time (n,) [s] and values (n, 6), strain or where `by_stress` stress [Pa]: a dict with `strain`, `stress`,
    /// `history`, `units` and the rows of `jumps`.
    fn follow<'py>(
        &self,
        py: Python<'py>,
        time: PyReadonlyArray1<'py, f64>,
        values: PyReadonlyArray2<'py, f64>,
        by_stress: [bool; 6],
    ) -> PyResult<Bound<'py, PyDict>> {
        let path = path::Path {
            time: time.as_array().to_vec(),
            values: values.as_array().rows().into_iter().map(|x| [0, 1, 2, 3, 4, 5].map(|c| x[c])).collect(),
            control: by_stress.map(|stress| if stress { Control::Stress } else { Control::Strain }),
            size: self.law.size.as_ref().map(|size| size.value),
        };
        let LawFile { law, parameters, .. } = &self.law;
        let response =
            py.detach(|| follow::follow(&law.value, parameters, &path, Isa::best())).map_err(|e| told(&e))?;
        let jumps: BTreeSet<i64> = response.between.iter().filter(|b| b.jump).map(|b| b.row as i64).collect();
        let made = remembered(py, response.columns, response.history)?;
        made.set_item("strain", rows(py, response.strain)?)?;
        made.set_item("stress", rows(py, response.stress)?)?;
        made.set_item("jumps", column(py, jumps.into_iter().collect())?)?;
        Ok(made)
    }

    /// Follows an interface along values (n, 3): gap [m], or pressure [Pa] where `by_pressure`, and both slips [m]: a dict with `gap`,
    /// `slip`, `pressure`, `shear`, `history` and `units`.
    fn follow_interface<'py>(
        &self,
        py: Python<'py>,
        values: PyReadonlyArray2<'py, f64>,
        by_pressure: bool,
    ) -> PyResult<Bound<'py, PyDict>> {
        let values: Vec<[f64; 3]> =
            values.as_array().rows().into_iter().map(|x| [x[0], x[1], x[2]]).collect();
        let path = InterfacePath {
            time: (0..values.len()).map(|row| row as f64).collect(),
            values,
            across: if by_pressure { Across::Pressure } else { Across::Gap },
        };
        let LawFile { law, parameters, .. } = &self.law;
        let response = py
            .detach(|| follow::follow_interface(&law.value, parameters, &path, Isa::best()))
            .map_err(|e| told(&e))?;
        let made = remembered(py, response.columns, response.history)?;
        made.set_item("gap", column(py, response.gap)?)?;
        made.set_item("slip", rows(py, response.slip)?)?;
        made.set_item("pressure", column(py, response.pressure)?)?;
        made.set_item("shear", rows(py, response.shear)?)?;
        Ok(made)
    }
}

/// A dict with what a law remembers, by name, with units.
fn remembered<'py>(
    py: Python<'py>,
    columns: &[Column],
    history: Vec<Vec<f64>>,
) -> PyResult<Bound<'py, PyDict>> {
    let (values, units) = (PyDict::new(py), PyDict::new(py));
    for (head, numbers) in columns.iter().zip(history) {
        values.set_item(head.name, column(py, numbers)?)?;
        units.set_item(head.name, head.unit)?;
    }
    let made = PyDict::new(py);
    made.set_item("history", values)?;
    made.set_item("units", units)?;
    Ok(made)
}

fn told(error: &PathError) -> PyErr {
    match error {
        PathError::SizeMissing => unusable(
            "the law softens over displacement or by a fracture energy and needs the element's extent; give size=\"0.5 m\"",
        ),
        error => unusable(error),
    }
}

pub fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<LawCore>()
}
