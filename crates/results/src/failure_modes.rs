//! Modes of failure of a lining, and what judges each.

use serde::{Deserialize, Serialize};

/// What judges a mode of failure.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum JudgedBy {
    /// The lining's own law: it cracks or yields.
    Law,
    /// The utilisation of its sections by `[[section]]`.
    Section,
    /// Neither.
    #[default]
    #[serde(rename = "none")]
    Nothing,
}

/// What judges the modes of failure of a lining.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct FailureModes {
    /// The law's word in a case.
    pub law: String,
    /// Thrust and moment, tension included.
    pub thrust_moment: JudgedBy,
    /// Shear across the thickness. A law in layered elements does not show it.
    pub shear: JudgedBy,
    /// Stations at which section forces are taken.
    pub stations: u64,
}
