//! A case with what a script gives beside it, made into a job.

use crate::arrays::column;
use crate::away::{Desk, away, pool};
use crate::case as python;
use crate::errors::{CaseWarning, no_job, refused, unusable};
use crate::fields::{ByElement, Fields};
use crate::mesh;
use indexmap::IndexMap;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::ffi::CString;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use tremolite::job::{Fault, Given, Inputs, Job, Loaded};
use tremolite_case::Case;
use tremolite_laws::materials::MATERIALS;

/// A job, and all that it is made of.
#[derive(Clone)]
pub struct Made {
    pub job: Arc<Job>,
    /// With its changes, before materials are divided by element.
    pub case: Case,
    pub inputs: Inputs,
    pub fields: Fields,
}

/// Why a case with its fields is no job.
enum Refusal {
    Case(Box<Fault>),
    Fields(String),
}

impl From<Fault> for Refusal {
    fn from(fault: Fault) -> Self {
        Refusal::Case(Box::new(fault))
    }
}

impl Made {
    /// Builds a job with the interpreter released, and warns of what is unusual.
    ///
    /// # Errors
    /// All that is wrong with the case and what is given beside it.
    pub fn build(
        py: Python<'_>,
        case: &Case,
        given: &Given,
        fields: Fields,
        threads: Option<usize>,
    ) -> PyResult<Self> {
        let pool = pool(threads)?;
        let changed = case.parse_with(&given.changes, MATERIALS).map_err(|report| refused(py, &report))?;
        let (divided, groups) = divided(py, &changed, &given.inputs, &fields)?;
        let inputs = Inputs { groups, ..given.inputs.clone() };
        let whole = Given { changes: Vec::new(), inputs, ..given.clone() };
        let work = || -> Result<Job, Refusal> {
            let mut loaded = Loaded::of(&divided, &whole)?;
            fields.put(&mut loaded.setup).map_err(Refusal::Fields)?;
            Ok(Job::of_loaded(loaded)?)
        };
        let back = away(py, &pool, &Desk::default(), &AtomicBool::new(false), work)?;
        if let Some(interrupt) = back.interrupt {
            return Err(interrupt);
        }
        let job = back.result.map_err(|refusal| match refusal {
            Refusal::Case(fault) => no_job(py, &fault),
            Refusal::Fields(words) => unusable(words),
        })?;
        let warning = py.get_type::<CaseWarning>();
        for said in job.said() {
            let text = CString::new(said.replace('\0', " ")).unwrap_or_default();
            PyErr::warn(py, &warning, &text, 1)?;
        }
        Ok(Made { case: changed, job: Arc::new(job), inputs: given.inputs.clone(), fields })
    }

    /// What is given beside the case.
    pub fn given(&self) -> Given {
        Given { inputs: self.inputs.clone(), ..Given::default() }
    }
}

/// A case whose materials are divided by what a script gives by element, with the groups of the pieces; the case itself where it gives nothing.
fn divided(
    py: Python<'_>,
    case: &Case,
    inputs: &Inputs,
    fields: &Fields,
) -> PyResult<(Case, IndexMap<String, Vec<u32>>)> {
    if fields.parameters.is_empty() {
        return Ok((case.clone(), IndexMap::new()));
    }
    let values = PyDict::new(py);
    for (name, ByElement { values: all, classes }) in &fields.parameters {
        values.set_item(name, (column(py, all.to_vec())?, *classes))?;
    }
    let whole = Bound::new(py, python::Case { case: case.clone() })?;
    let mesh = mesh::of_case(py, case, inputs)?;
    let said = py.import("tremolite._by_element")?.call_method1("_divided", (whole, mesh, values))?;
    let (made, groups): (Bound<'_, python::Case>, Vec<(String, Vec<u32>)>) = said.extract()?;
    Ok((made.get().case.clone(), groups.into_iter().collect()))
}
