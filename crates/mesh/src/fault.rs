//! What a reader finds wrong.

use std::path::PathBuf;

/// What a reader finds wrong; [`read`](crate::read()) adds the file.
#[derive(Debug)]
pub(crate) struct Fault {
    /// None if it is the file that was asked for, not one included there.
    pub file: Option<PathBuf>,
    /// Counted from 1; none if the whole file is meant.
    pub line: Option<usize>,
    pub problem: String,
}

impl Fault {
    /// A fault in a line.
    pub(crate) fn at(line: usize, problem: impl Into<String>) -> Self {
        Fault { file: None, line: Some(line), problem: problem.into() }
    }

    /// A fault of the whole file.
    pub(crate) fn whole(problem: impl Into<String>) -> Self {
        Fault { file: None, line: None, problem: problem.into() }
    }
}
