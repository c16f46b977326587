//! A forked child of a process that has computed: its threads and locks did not come along.

use crate::errors::unusable;
use pyo3::PyResult;
use std::process;
use std::sync::OnceLock;

/// The process in which something was first computed.
static COMPUTED_IN: OnceLock<u32> = OnceLock::new();

/// Refuses to compute in a child of a process that has.
pub fn refuse_child() -> PyResult<()> {
    if *COMPUTED_IN.get_or_init(process::id) == process::id() {
        return Ok(());
    }
    Err(unusable(
        "this process was forked from one that has computed, whose threads did not come along; start processes with \
         multiprocessing.get_context(\"spawn\")",
    ))
}
