//! What interfaces did.

use serde::{Deserialize, Serialize};

use crate::{MaterialValue, number};

/// One interface over the run.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct InterfaceSummary {
    /// Its law, the number of its pairs, and of nodes at which it ends inside the model, closed.
    pub law: String,
    /// The law's parameters; of what was left to be chosen the origin is derived.
    pub values: Vec<MaterialValue>,
    pub pairs: u64,
    pub ends: u64,
    /// Area (m²).
    #[serde(with = "number", default = "number::absent")]
    pub area: f64,
    /// Normal stiffness of the closed, unloaded interface (Pa/m), and whether the program chose it.
    #[serde(with = "number", default = "number::absent")]
    pub normal_stiffness: f64,
    pub chosen: bool,
    /// Closure at a pressure of 1 MPa (m).
    #[serde(with = "number", default = "number::absent")]
    pub closure_at_1_mpa: f64,
    /// Pressure from which on the law is straight for the sake of the step (Pa); NaN where it never is.
    #[serde(with = "number", default = "number::absent")]
    pub straight_from: f64,
    /// Areas that slid and that opened in any step (m²).
    #[serde(with = "number", default = "number::absent")]
    pub ever_slid: f64,
    #[serde(with = "number", default = "number::absent")]
    pub ever_opened: f64,
    /// Areas that slide and are open at the end (m²).
    #[serde(with = "number", default = "number::absent")]
    pub sliding: f64,
    #[serde(with = "number", default = "number::absent")]
    pub open: f64,
    /// Extremes over all pairs whose bond is broken, and of pressure over all, and over all steps (m, m, Pa), with the places
    /// of the first two (m).
    pub max_gap: PairPeak,
    pub max_slip: PairPeak,
    #[serde(with = "number", default = "number::absent")]
    pub max_pressure: f64,
    /// Energy that the time step found at impacts, or lost (J).
    #[serde(with = "number", default = "number::absent")]
    pub impact_gain: f64,
}

/// An extreme over pairs and steps, with its place.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct PairPeak {
    /// The value (m).
    #[serde(with = "number", default = "number::absent")]
    pub value: f64,
    /// Number of the pair's node, and its place (m); zeros where nothing slid or opened.
    pub node: u64,
    pub at: [f64; 3],
}

/// A monitor on an interface: the pair nearest to its point.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct PairPlace {
    pub interface: String,
    /// Number of the pair's node, and its place (m); zeros where nothing slid or opened.
    pub node: u64,
    pub at: [f64; 3],
    /// m, out of the first side into the second, and the tangents along which slip and shear are counted.
    pub normal: [f64; 3],
    pub tangents: [[f64; 3]; 2],
}
