//! What goes wrong, as Python's exceptions: words and remedy, before anything is computed.

use pyo3::create_exception;
use pyo3::exceptions::{PyException, PyKeyboardInterrupt, PyUserWarning};
use pyo3::prelude::*;
use std::fmt::Display;
use tremolite::job::{Fault, Why};
use tremolite_case::{Diagnostic, Report};

create_exception!(tremolite, Error, PyException, "What this package refuses, or could not do.");
create_exception!(
    tremolite,
    CaseError,
    Error,
    "A case that cannot be run, with all that is wrong: `problems` is a list of `Problem`, empty where it is about no key."
);
create_exception!(
    tremolite,
    RunError,
    Error,
    "A run that could not go on. What was computed before is kept."
);
create_exception!(
    tremolite,
    Stopped,
    PyKeyboardInterrupt,
    "Ctrl-C stopped a run in good order: a checkpoint is in its folder `out`, to be gone on with by `resume=True`."
);
create_exception!(
    tremolite,
    CaseWarning,
    PyUserWarning,
    "What is unusual of a case that can be run all the same."
);
create_exception!(
    tremolite,
    RunWarning,
    PyUserWarning,
    "A run that ended for a physical or numerical reason; its results until then are kept."
);

/// One thing that is wrong or unusual: `key` (the path that `Case.with_` takes, empty where it is about the whole case), `line` and
/// `column` in the case's text (from 1; None where it comes from a change), `message`, `remedy`.
#[pyclass(frozen, module = "tremolite", get_all)]
pub struct Problem {
    key: String,
    line: Option<usize>,
    column: Option<usize>,
    message: String,
    remedy: String,
}

#[pymethods]
impl Problem {
    fn __repr__(&self) -> String {
        let line = self.line.map_or_else(String::new, |line| format!("line {line}, "));
        let key = if self.key.is_empty() { "case" } else { &self.key };
        format!("<{line}{key}: {}; {}>", self.message, self.remedy)
    }
}

impl Problem {
    fn of(report: &Report, problem: &Diagnostic) -> Self {
        let at = problem.set.is_none() && !report.source.is_empty();
        let (line, column) = at.then(|| report.position(problem)).unzip();
        let (message, remedy) = (problem.message.clone(), problem.remedy.clone());
        Problem { key: problem.key.clone(), line, column, message, remedy }
    }

    /// All problems of a report.
    pub fn all(report: &Report) -> Vec<Problem> {
        report.problems.iter().map(|problem| Problem::of(report, problem)).collect()
    }
}

/// A case's problems as an exception.
pub fn refused(py: Python<'_>, report: &Report) -> PyErr {
    with_problems(py, &report.render(false), Problem::all(report))
}

/// Why a case is no job, as an exception.
pub fn no_job(py: Python<'_>, fault: &Fault) -> PyErr {
    match &fault.why {
        Why::Case(report) => refused(py, report),
        why => with_problems(py, &why.to_string(), Vec::new()),
    }
}

fn with_problems(py: Python<'_>, text: &str, problems: Vec<Problem>) -> PyErr {
    let error = CaseError::new_err(text.to_owned());
    match error.value(py).setattr("problems", problems) {
        Ok(()) => error,
        Err(other) => other,
    }
}

/// A run that could not go on.
pub fn failed(why: impl Display) -> PyErr {
    RunError::new_err(why.to_string())
}

/// What cannot be used as it is given.
pub fn unusable(why: impl Display) -> PyErr {
    Error::new_err(why.to_string())
}

/// Ctrl-C, once the checkpoint is written; any other exception of a signal handler as it is.
pub fn stopped(py: Python<'_>, interrupt: PyErr, out: &std::path::Path) -> PyErr {
    if !interrupt.is_instance_of::<PyKeyboardInterrupt>(py) {
        return interrupt;
    }
    let error =
        Stopped::new_err(format!("stopped; a checkpoint is in {}: go on with resume=True", out.display()));
    match error.value(py).setattr("out", out) {
        Ok(()) => error,
        Err(other) => other,
    }
}

pub fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    let py = module.py();
    module.add("Error", py.get_type::<Error>())?;
    module.add("CaseError", py.get_type::<CaseError>())?;
    module.add("RunError", py.get_type::<RunError>())?;
    module.add("Stopped", py.get_type::<Stopped>())?;
    module.add("CaseWarning", py.get_type::<CaseWarning>())?;
    module.add("RunWarning", py.get_type::<RunWarning>())
}
