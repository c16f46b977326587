//! The compiled half of the Python package `tremolite`: what computes and what reads files. What a user imports, with its
//! documentation, is in `python/tremolite`.
//!
//! Importing it starts no thread and sets no signal handler. Whatever computes does so on a pool of its own, while the interpreter is
//! released; whoever waits for it is asked to run callbacks, and looks for Ctrl-C.

mod arrays;
mod away;
mod case;
mod changes;
mod errors;
mod fields;
mod force;
mod fork;
mod job;
mod law;
mod look;
mod made;
mod mesh;
mod motion;
mod record;
mod report;
mod simulation;
mod soft_ground;
mod study;
mod tables;
mod target;
mod teller;
mod toml_dict;
mod watch;

use pyo3::prelude::*;
use std::ffi::OsString;

/// Runs the command `tremolite`; the first argument is the program's name, `again` what starts the command in another process. Returns the
/// status to end with.
#[pyfunction]
fn command(py: Python<'_>, arguments: Vec<OsString>, again: Vec<OsString>) -> u8 {
    py.detach(|| tremolite_cli::run(arguments, again))
}

#[pymodule]
fn _tremolite(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    errors::add(module)?;
    module.add_class::<errors::Problem>()?;
    module.add_class::<case::Case>()?;
    module.add_class::<job::Job>()?;
    module.add_class::<simulation::Simulation>()?;
    module.add_class::<simulation::Stages>()?;
    module.add_class::<simulation::StageEnd>()?;
    module.add_class::<look::Look>()?;
    module.add_class::<watch::Beginning>()?;
    module.add_function(wrap_pyfunction!(command, module)?)?;
    law::add(module)?;
    mesh::add(module)?;
    motion::add(module)?;
    report::add(module)?;
    soft_ground::add(module)?;
    study::add(module)?;
    target::add(module)?;
    tables::add(module)
}
