//! How a command ends: 0 done, 1 failed for a physical or numerical reason, 2 bad input, 3 stopped by a signal.

use std::fmt::Display;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Code {
    Done = 0,
    Failed = 1,
    BadInput = 2,
    Stopped = 3,
}

/// What went wrong, in words, and the status to end with.
#[derive(Debug)]
pub struct Failure {
    pub code: Code,
    pub message: String,
}

impl Failure {
    /// The input cannot be used; nothing was computed.
    pub fn input(message: impl Display) -> Failure {
        Failure { code: Code::BadInput, message: format!("error: {message}") }
    }

    /// A computation or a file failed on the way.
    pub fn failed(message: impl Display) -> Failure {
        Failure { code: Code::Failed, message: format!("error: {message}") }
    }

    /// A report of a case, which has its own form.
    pub fn case(report: &tremolite_case::Report) -> Failure {
        Failure { code: Code::BadInput, message: report.render(crate::terminal::colour()) }
    }
}

pub type Outcome = Result<Code, Failure>;
