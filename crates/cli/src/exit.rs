//! How a command ends: 0 done, 1 failed for a physical or numerical reason, 2 bad input, 3 stopped by a signal.

use serde_json::{Value, json};
use std::fmt::Display;
use tremolite::job::{Remark, diagnostics};
use tremolite_case::Report;

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
    /// Problems of a case at their places; nothing where the failure is about none.
    pub report: Option<Box<Report>>,
    /// What was found unusual before.
    pub remarks: Vec<Remark>,
}

impl Failure {
    /// The input cannot be used; nothing was computed.
    pub fn input(message: impl Display) -> Failure {
        Failure::of(Code::BadInput, format!("error: {message}"))
    }

    /// A computation or a file failed on the way.
    pub fn failed(message: impl Display) -> Failure {
        Failure::of(Code::Failed, format!("error: {message}"))
    }

    /// A report of a case, which has its own form.
    pub fn case(report: &Report) -> Failure {
        let message = report.render(crate::terminal::colour());
        Failure { report: Some(Box::new(report.clone())), ..Failure::of(Code::BadInput, message) }
    }

    /// One whose words are complete.
    pub fn of(code: Code, message: String) -> Failure {
        Failure { code, message, report: None, remarks: Vec::new() }
    }

    /// The object that a command with --json prints in place of its results.
    pub fn json(&self) -> Value {
        let refused = match &self.report {
            Some(report) => diagnostics(report),
            None => {
                let message = self.message.strip_prefix("error: ").unwrap_or(&self.message);
                vec![json!({
                    "key": "", "line": null, "column": null, "set": null, "message": message, "remedy": "",
                })]
            }
        };
        let findings = self.remarks.iter().filter_map(|remark| match remark {
            Remark::Problems(report) => Some(diagnostics(report)),
            _ => None,
        });
        let file = self.report.as_ref().map(|report| report.file.display().to_string());
        json!({ "file": file, "refused": refused, "findings": findings.flatten().collect::<Vec<_>>() })
    }
}

pub type Outcome = Result<Code, Failure>;
