//! What became of bolts, group by group.

use serde::{Deserialize, Serialize};

use crate::number;

/// One group of bolts over the run. A bolt counts under every heading that it comes under.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct BoltSummary {
    /// Those that are there, and bars that were given; of these, how many are shorter than given since they ran into a void or
    /// out of the model, and how many were left out since their head lies in nothing.
    pub bolts: u64,
    pub given: u64,
    pub shortened: u64,
    pub left_out: u64,
    /// Places where one crosses an interface.
    pub crossings: u64,
    /// Length of all (m), and the segments they were cut into.
    #[serde(with = "number", default = "number::absent")]
    pub length: f64,
    pub segments: u64,
    /// The stage that places them, `earthquake` for the shaking, and whether the run came to it.
    pub placed: String,
    pub there: bool,
    /// Whether they slide along a bond; else they follow what they lie in.
    pub bonded: bool,
    /// Whether they are reinforcement, of which each row of elements has a chain: how many there are then says nothing.
    pub bars: bool,
    /// Smallest force at which one yields (N); NaN for never. Tension they were placed with (N).
    #[serde(with = "number", default = "number::absent")]
    pub yield_force: f64,
    #[serde(with = "number", default = "number::absent")]
    pub pretension: f64,
    /// The largest force of any stage and step.
    pub largest: BoltPeak,
    /// Largest force over the force at which it yields, of any stage and step; 0 where none ever does.
    #[serde(with = "number", default = "number::absent")]
    pub force_over_yield: f64,
    /// Bolts that have yielded, that broke, whose bond slid, that an excavation has cut, and of the last those of which
    /// nothing is left.
    pub yielded: u64,
    pub broken: u64,
    pub slid: u64,
    pub cut: u64,
    pub gone: u64,
    /// Largest slip of any step (m).
    #[serde(with = "number", default = "number::absent")]
    pub max_slip: f64,
}

/// A largest force with its place.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct BoltPeak {
    /// N, tension positive.
    #[serde(with = "number", default = "number::absent")]
    pub force: f64,
    /// The bolt's number in its group, from 1; 0 where none carried anything. Its place (m).
    pub bolt: u64,
    pub at: [f64; 3],
    /// The stage, or `earthquake`, and then when (s), to a row of the histories.
    pub stage: String,
    #[serde(with = "number", default = "number::absent")]
    pub time: f64,
}

/// A monitor on a bolt: the segment nearest to its point.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct BoltPlace {
    /// The group, and the bolt's number in it, from 1.
    pub group: String,
    pub bolt: u64,
    /// Middle of the segment (m), and its distance from the head along the bolt (m).
    pub at: [f64; 3],
    #[serde(with = "number", default = "number::absent")]
    pub from_head: f64,
}
