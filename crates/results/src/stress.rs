//! The largest stresses of groups of elements.

use serde::{Deserialize, Serialize};

use crate::number;

/// Stresses of a group over the run, sampled with the histories: in elements of several points at the fibre (extrapolated to their
/// corners) as long as these are intact, else at integration points. Of the earthquake alone.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct GroupStress {
    /// Whether the group is no part of another of the same material.
    pub whole: bool,
    /// Largest principal stress, tension positive.
    pub s1: StressPeak,
    /// Smallest principal stress.
    pub s3: StressPeak,
}

/// An extreme with its time and place.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct StressPeak {
    /// Stress (Pa).
    #[serde(with = "number", default = "number::absent")]
    pub value: f64,
    /// When (s).
    #[serde(with = "number", default = "number::absent")]
    pub time: f64,
    /// The element's number and centre (m).
    pub element: u64,
    pub at: [f64; 3],
}
