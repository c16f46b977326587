//! Where the monitors are, their peaks, and how far they move in step.

use indexmap::IndexMap;
use serde::{Deserialize, Serialize};

use crate::{Peaks, number};

/// Where the monitors are, and their peaks.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct MonitorFacts {
    /// Monitor → position (m), of the node or point that was used.
    pub monitor_positions: IndexMap<String, [f64; 3]>,
    /// Monitor → quantity → peaks.
    #[serde(rename = "monitors")]
    pub peaks: IndexMap<String, IndexMap<String, Peaks>>,
    /// Pair of monitors as `A-B` → quantity → peaks of the difference A − B.
    pub relative: IndexMap<String, IndexMap<String, Peaks>>,
    /// Component of displacement (`ux`) → how far the monitors move in step along it, but for those on broken elements and those
    /// that move less than a hundredth of the most; empty without two.
    #[serde(skip_serializing_if = "IndexMap::is_empty")]
    pub synchrony: IndexMap<String, Synchrony>,
    /// Monitors on elements that tension had broken through when the run ended: they show how loose pieces move.
    #[serde(rename = "monitors_on_broken_elements", skip_serializing_if = "Vec::is_empty")]
    pub on_broken_elements: Vec<String>,
}

/// How far any two monitors move in step along a component, of the displacements in monitors.csv.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Synchrony {
    /// The least correlation coefficient of two monitors (Pearson, 1: the same course), and of which, as `A-B`.
    #[serde(with = "number", default = "number::absent")]
    pub correlation: f64,
    pub least_of: String,
    /// The longest time (s) by which the second of two monitors comes later than the first (earlier, if negative) where their
    /// courses fit best, within half a second, and of which two.
    #[serde(with = "number", default = "number::absent")]
    pub lag: f64,
    pub latest_of: String,
}
