//! How a run ends: its results, or why it was broken off.

use super::{Simulation, refused};
use crate::away::Back;
use crate::errors::{RunWarning, failed, stopped};
use pyo3::prelude::*;
use std::ffi::CString;
use std::path::Path;
use tremolite::RunError;
use tremolite::simulation::{Ending, Outcome};

impl Simulation {
    /// The results of what has ended, or why it was broken off.
    pub(super) fn ended<'py>(
        &self,
        py: Python<'py>,
        back: Back<Result<Outcome, RunError>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let page = py.detach(|| tremolite_report::write(&self.out));
        if let Some(raised) = self.asker.desk.raised() {
            // Ctrl-C while a script's code ran.
            let in_order = back.result.is_ok_and(|outcome| outcome.ending == Ending::Stopped);
            return Err(if in_order { stopped(py, raised, &self.out) } else { raised });
        }
        let outcome = back.result.map_err(|why| refused(&why))?;
        if let Some(interrupt) = back.interrupt {
            return match outcome.ending {
                Ending::Stopped => Err(stopped(py, interrupt, &self.out)),
                // It came as the run ended.
                _ => Err(interrupt),
            };
        }
        page.map_err(failed)?;
        let result = result(py, &self.out)?;
        if !matches!(outcome.ending, Ending::Done | Ending::Stopped) {
            let verdict: String = result.getattr("verdict")?.extract()?;
            let text = CString::new(verdict.replace('\0', " ")).unwrap_or_default();
            PyErr::warn(py, &py.get_type::<RunWarning>(), &text, 1)?;
        }
        Ok(result)
    }
}

/// The results in a folder.
fn result<'py>(py: Python<'py>, root: &Path) -> PyResult<Bound<'py, PyAny>> {
    py.import("tremolite._results")?.getattr("Result")?.call1((root,))
}
