//! What was computed, and how fast.

use indexmap::IndexMap;
use serde::{Deserialize, Serialize};

use super::Wave;
use crate::{MaterialFacts, Said, StageSummary, number};

/// What was computed, and how fast.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Computed {
    /// Wall-clock time of the whole run (s), resumed parts included.
    #[serde(with = "number", default = "number::absent")]
    pub wall_seconds: f64,
    /// Element updates per second of wall-clock time in the dynamic steps.
    #[serde(with = "number", default = "number::absent")]
    pub element_updates_per_second: f64,
    /// The model's size and time step.
    pub model: ModelFacts,
    /// Material, by its name in the case → what it is and what is made of it.
    pub materials: IndexMap<String, MaterialFacts>,
    /// The motion that went in.
    pub motion: MotionFacts,
    /// `base`, `x`, `y`, `top` → the boundary there while the ground shakes, by its word in a case; empty without an earthquake.
    #[serde(skip_serializing_if = "IndexMap::is_empty")]
    pub boundaries: IndexMap<String, String>,
    /// The stress before anything was done, in the middle of what is excavated first, else of the model; none in files of older versions.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub initial_stress: Option<InitialStress>,
    /// Lining → its extent; of linings of which section forces are taken.
    #[serde(skip_serializing_if = "IndexMap::is_empty")]
    pub linings: IndexMap<String, LiningExtent>,
    /// `pressure` and `earthquake` → where the pressure of the water comes from and what becomes of it in the earthquake, by their words in
    /// a case; empty without water.
    #[serde(skip_serializing_if = "IndexMap::is_empty")]
    pub water: IndexMap<String, String>,
    /// Program and machine.
    pub run: RunFacts,
    /// Stages before the earthquake, in their order; the first is the initial equilibrium.
    pub stages: Vec<StageSummary>,
}

/// How far a lining extends along x, y and z (m).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct LiningExtent {
    /// Between its inner faces: width, length and height of what it encloses. Of a lining without a floor the height is that from the foot
    /// of its walls.
    pub clear: [f64; 3],
    /// Between its outer faces.
    pub outer: [f64; 3],
}

/// The size of the model and its time step.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ModelFacts {
    /// Group → number of elements. Groups may overlap.
    pub groups: IndexMap<String, u64>,
    /// Number of elements.
    pub elements: u64,
    /// Number of nodes.
    pub nodes: u64,
    /// Steps done, of the finest level.
    pub steps: u64,
    /// Elements by level of steps, the finest first: those of level l make steps of 2^l times the finest. Absent where all make
    /// the same.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub elements_of_level: Vec<u64>,
    /// Time step (s), of the finest level.
    #[serde(with = "number", default = "number::absent")]
    pub time_step: f64,
    /// What sets the time step, in words: which element, boundary or damping.
    pub step_set_by: String,
    /// The same as a pattern.
    #[serde(skip_serializing_if = "Said::is_empty")]
    pub step_set_by_message: Said,
    /// Simulated time (s).
    #[serde(with = "number", default = "number::absent")]
    pub duration: f64,
}

/// The motion that went in at the base.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct MotionFacts {
    /// `outcrop`, `incident`, `within` or `surface`.
    pub kind: String,
    /// Factor from the given to the incident motion (an outcrop motion is halved); no number where it was deconvolved.
    #[serde(with = "number", default = "number::absent")]
    pub factor: f64,
    /// Axis of the model (`x`, `y`, `z`) → largest acceleration of the incident motion, by size (m/s²).
    #[serde(deserialize_with = "number::deserialize_map")]
    pub peak_acceleration: IndexMap<String, f64>,
    /// The same of the motion given; empty in files of other versions.
    #[serde(deserialize_with = "number::deserialize_map", skip_serializing_if = "IndexMap::is_empty")]
    pub given_peak_acceleration: IndexMap<String, f64>,
    /// Axis of the model → where its record came from, in words.
    pub source: IndexMap<String, String>,
    /// The spectrum that the design calls for of the motion given, horizontal, with 5 % damping.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub target: Option<TargetSpectrum>,
    /// How it was deconvolved, where it was.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub deconvolved: Option<Deconvolved>,
    /// Plane waves at angles that carry it; none where one rises straight up.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub waves: Vec<Wave>,
    /// By how much these come later than in the record, so that nothing moves before (s).
    #[serde(skip_serializing_if = "no_lead")]
    pub lead: f64,
}

fn no_lead(lead: &f64) -> bool {
    *lead == 0.0
}

/// A response spectrum: periods (s), ascending, and the acceleration at each (m/s²).
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct TargetSpectrum {
    pub period: Vec<f64>,
    pub sa: Vec<f64>,
}

/// How the wave that comes in was deconvolved from a record on or within layered ground.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Deconvolved {
    /// Of the record, below the surface of the ground (m).
    pub depth: f64,
    /// Corner of the model, `xmin-ymin`, whose own ground it is; empty for the layers of motion.site.
    pub corner: String,
    /// By how much the record comes later to its place than in its file (s).
    pub lead: f64,
    /// Up to which frequency the record was wanted (Hz).
    pub band: f64,
    /// Up to which frequency the incident wave is the record's (Hz); no number where nothing was left out.
    #[serde(with = "number", default = "number::absent")]
    pub reach: f64,
    /// The largest share of ∫a² dt of a component that was left out above.
    pub left_out: f64,
    /// Motion at the place of the record over that of the incident wave, at rest.
    pub at_rest: f64,
    /// The least of the same among what is let through, along the axes that move, and its frequency (Hz).
    pub least: f64,
    pub least_at: f64,
    /// What layers that soften came to, with the others, from the surface down; empty where none does.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub soil: Vec<SoilLayer>,
}

/// A layer of soil under the record of its surface.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct SoilLayer {
    /// m
    pub thickness: f64,
    /// Of shear waves, with the modulus that it is left with (m/s).
    pub shear_wave_velocity: f64,
    /// Largest shear strain in its middle.
    pub strain: f64,
    /// Shear modulus over that of small strain, and the ratio to critical damping, of 0.65 of that strain.
    pub modulus: f64,
    pub damping: f64,
}

/// The program and the machine.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct RunFacts {
    /// Name and version of the program.
    pub program: String,
    /// The command line.
    pub command: String,
    /// When the run started, ISO 8601.
    pub started: String,
    /// Number of threads.
    pub threads: u64,
    /// `scalar`, `avx2` or `avx512`.
    pub instruction_set: String,
    /// How often the run was resumed from a checkpoint.
    pub resumed: u64,
}

/// The initial stress at one place.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct InitialStress {
    /// m
    pub at: [f64; 3],
    /// xx, yy, zz, xy, yz, zx (Pa), total, tension positive.
    pub stress: [f64; 6],
}
