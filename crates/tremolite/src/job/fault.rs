//! What is said of a case before it runs: why it cannot, and what is unusual though it can.

use std::collections::HashSet;
use std::path::PathBuf;
use tremolite_case::{Case, Diagnostic, Report, Side};
use tremolite_engine::ModelError;

/// What is unusual of a case that can be run all the same.
#[derive(Clone, Debug, PartialEq)]
pub enum Remark {
    /// What one look at it found, as warnings at their places.
    Problems(Report),
    /// The folder from which a result folder's case names its files.
    Files(PathBuf),
    /// A sentence on what is not as the run of that result folder read it.
    Changed(String),
}

impl Remark {
    /// What one look found; nothing where that was nothing.
    pub(super) fn of(case: &Case, problems: &[Diagnostic]) -> Option<Remark> {
        (!problems.is_empty()).then(|| Remark::Problems(case.report(once(problems.to_vec())).as_warnings()))
    }

    /// The text for the terminal; with ANSI colours only if asked.
    pub fn render(&self, colour: bool) -> String {
        match self {
            Remark::Problems(report) => report.render(colour),
            Remark::Files(folder) => {
                format!("the files of this case are looked for from {}", folder.display())
            }
            Remark::Changed(what) => format!("warning: {what}"),
        }
    }
}

/// Problems without those whose text an earlier one has: what holds of several stages is told once, at the first.
pub(super) fn once(problems: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let mut told = HashSet::new();
    let first = |problem: &Diagnostic| told.insert((problem.message.clone(), problem.remedy.clone()));
    problems.into_iter().filter(first).collect()
}

/// Why a case is no job.
#[derive(Debug, thiserror::Error)]
#[error("{why}")]
pub struct Fault {
    /// What was found unusual before, in the order in which it is to be told.
    pub remarks: Vec<Remark>,
    pub why: Why,
}

/// The reason of a [`Fault`].
#[derive(Debug, thiserror::Error)]
pub enum Why {
    /// Problems at their places in the case, with the paths of their keys.
    #[error(transparent)]
    Case(Box<Report>),
    /// What is about no place of the case.
    #[error(transparent)]
    Model(ModelError),
    /// It would never end: \[s\] of the stable step, and what sets that, in words.
    #[error(
        "the run would take {steps:.1e} steps: the stable step is {stable:.1e} s, set by {set_by}; look at the units of stiffness, \
         density and size there"
    )]
    Endless { steps: f64, stable: f64, set_by: String },
}

impl From<Report> for Why {
    fn from(report: Report) -> Why {
        Why::Case(Box::new(report))
    }
}

impl Why {
    /// Why a case is no model, at its interface or boundary where it is about one.
    pub(super) fn refused(case: &Case, error: ModelError) -> Why {
        let sides = &case.dynamic.sides;
        let named = |name: &str| case.interfaces.iter().find(|interface| interface.name.value == name);
        let (span, otherwise) = match &error {
            ModelError::Periodic { low, .. } => {
                (sides[usize::from(low.starts_with('y'))].span.clone(), "choose another kind of sides")
            }
            ModelError::FreeField(_) => {
                let free = sides.iter().find(|side| side.value == Side::FreeField).unwrap_or(&sides[0]);
                (free.span.clone(), "choose another kind of sides")
            }
            ModelError::Top { .. } => (case.dynamic.top.span.clone(), "write top = \"free\""),
            _ => match error.interface().and_then(named) {
                Some(interface) => (interface.span.clone(), "see `tremolite list interfaces`"),
                None => return Why::Model(error),
            },
        };
        let text = error.to_string();
        let (message, remedy) = text.split_once("; ").unwrap_or((&text, otherwise));
        case.report(vec![Diagnostic::new(span, message, remedy)]).into()
    }
}
