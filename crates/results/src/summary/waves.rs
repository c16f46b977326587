//! Plane waves at angles that shook a model.

use serde::{Deserialize, Serialize};

use crate::number;

/// A plane wave at an angle.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Wave {
    /// `P`, `SV` or `SH`.
    #[serde(rename = "type")]
    pub kind: String,
    /// θ of its way from the vertical in the rock of the base (rad).
    pub angle: f64,
    /// ψ of its way in plan, clockwise from north (rad).
    pub azimuth: f64,
    /// Its way along x, y, z of the model, of length 1.
    pub way: [f64; 3],
    /// What it moves, likewise.
    pub polarisation: [f64; 3],
    /// What it is the sum of.
    pub parts: Vec<WavePart>,
    /// With which the field goes along the ground (m/s); no number where it comes straight up.
    #[serde(with = "number", default = "number::absent")]
    pub apparent_velocity: f64,
    /// Whether it comes at some time; beyond a critical angle something runs ahead of it.
    pub arrives: bool,
}

/// What a component of the record is times in a wave.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct WavePart {
    /// `east`, `north` or `up`.
    pub component: String,
    /// Negative where the wave is opposite.
    pub factor: f64,
    /// By how much it is turned in phase (rad), not 0 beyond a critical angle alone.
    pub phase: f64,
}
