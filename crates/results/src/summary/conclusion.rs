//! How a run ended, and what became of its structures, in words.

use serde::{Deserialize, Serialize};

use crate::{Finding, Judgement, Reliance, Said, State};

/// How a run ended.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Status {
    /// It reached its end.
    Done,
    /// It ended for a physical or numerical reason; the results so far are kept.
    Failed,
    /// A signal stopped it; a checkpoint was written.
    #[default]
    Stopped,
}

/// How the run ended and what became of each structure.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Conclusion {
    /// How the run ended.
    pub status: Status,
    /// The outcome in a few sentences, for people: that of the run, both classes, then that of each structure.
    pub verdict: String,
    /// Whether the lining withstands, with the reasons.
    pub state: Judgement<State>,
    /// How far the results can be used, with the reasons.
    pub reliance: Judgement<Reliance>,
    /// How the run went: the first part of the verdict.
    pub outcome: String,
    /// The same as a pattern; empty in files of other versions.
    #[serde(skip_serializing_if = "Said::is_empty")]
    pub outcome_message: Said,
    /// What became of each structure: the second part.
    pub findings: Vec<Finding>,
}
