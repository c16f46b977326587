//! A case with what a script gives beside it, made into a job.

use crate::away::{Desk, away, pool};
use crate::errors::{CaseWarning, no_job, unusable};
use crate::fields::Fields;
use pyo3::prelude::*;
use std::ffi::CString;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use tremolite::job::{Fault, Given, Inputs, Job, Loaded};
use tremolite_case::Case;

/// A job, and all that it is made of.
#[derive(Clone)]
pub struct Made {
    pub job: Arc<Job>,
    /// With its changes.
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
        let work = || -> Result<Job, Refusal> {
            let mut loaded = Loaded::of(case, given)?;
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
        Ok(Made { case: job.case.clone(), job: Arc::new(job), inputs: given.inputs.clone(), fields })
    }

    /// What is given beside the case.
    pub fn given(&self) -> Given {
        Given { inputs: self.inputs.clone(), ..Given::default() }
    }
}
