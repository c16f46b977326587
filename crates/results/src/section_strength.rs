//! What the sections of a lining use of their strength, as summary.json says.

use serde::{Deserialize, Serialize};

use crate::number;

/// A lining whose sections were judged by a code.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct SectionStrength {
    /// The code, as the case names it.
    pub code: String,
    /// Grade of the concrete, as the case names it; empty where strengths were given.
    pub grade: String,
    /// Design strengths of the concrete (Pa): f_cd and f_ctd, static.
    #[serde(with = "number", default = "number::absent")]
    pub compression: f64,
    #[serde(with = "number", default = "number::absent")]
    pub tension: f64,
    /// Stress at which the bars yield (Pa), not divided by γ_s, the largest of all; no number without bars.
    #[serde(with = "number", default = "number::absent")]
    pub steel: f64,
    /// γ_c, γ_s, α_cc, α_ct, γ_d and the factor of strength while the ground shakes.
    pub factors: Factors,
    /// Stations in all, and those with bars.
    pub stations: u64,
    pub reinforced: u64,
    /// Whether plain sections count their tensile strength.
    pub plain_tension: bool,
    /// Whether the lining's own law cracks or yields: the utilisation is then a cross-check, since what has cracked carries no more
    /// than it can.
    pub yields: bool,
    /// Stations whose utilisation was above 1, at any time; those by thrust and moment, and those by shear.
    pub beyond: u64,
    pub beyond_bending: u64,
    pub beyond_shear: u64,
    /// Stations of which no share of thrust and moment, or of shear, was borne at some time, so that their utilisation was infinite; the
    /// largest tension N (N/m) there, at the end of a stage or in a step.
    pub unborne: u64,
    #[serde(with = "number", default = "number::absent", skip_serializing_if = "number::is_absent")]
    pub unborne_thrust: f64,
    /// Most of thrust and moment, and of shear; none where nothing was judged.
    pub bending: Option<Used>,
    pub shear: Option<Used>,
    /// The widest crack that is left in a section with bars; none where the case gives no diameter, or nothing has bars.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub crack: Option<LastingCrack>,
    /// What the sections bear while the ground shakes (before it, where it does not), by kind of section, the most frequent first.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub borders: Vec<Border>,
}

/// A crack of a reinforced section under the thrust and moment of the end.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct LastingCrack {
    /// w_k (m); no number where bars yield, which has no width.
    #[serde(with = "number", default = "number::absent")]
    pub width: f64,
    /// σ_s of the bars next to the face that opens (Pa) and s_r,max (m).
    pub stress: f64,
    pub spacing: f64,
    /// The station, as in utilisation.csv, and its place (m).
    pub station: u32,
    pub at: [f64; 3],
    /// N (N/m) and M (N m/m) at the end.
    pub forces: [f64; 2],
    /// Sections with bars for which the clause has no width: a face without bars opens, or the bars cannot hold the forces.
    pub without: u64,
}

/// The line round all N and M that a kind of section bears.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Border {
    /// m
    pub thickness: f64,
    /// Area (m² a metre) of bars nearer to the intrados and nearer to the extrados.
    pub bars: [f64; 2],
    /// From the intrados, and from the extrados, to the middle of the bars next to it (m); no number without bars there.
    #[serde(deserialize_with = "number::deserialize_pair")]
    pub depths: [f64; 2],
    pub stations: u64,
    /// N (N/m) and M (N m/m), closed.
    pub line: Vec<[f64; 2]>,
}

/// Factors of a code, as the case has them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Factors {
    pub gamma_c: f64,
    pub gamma_s: f64,
    pub alpha_cc: f64,
    pub alpha_ct: f64,
    pub gamma_d: f64,
    pub dynamic: f64,
}

/// A station at the time at which it used most.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Used {
    /// Utilisation; no number where it was infinite.
    #[serde(with = "number", default = "number::absent")]
    pub value: f64,
    /// The station, as in utilisation.csv, and its place (m).
    pub station: u32,
    pub at: [f64; 3],
    /// A stage's name; empty for the shaking.
    pub stage: String,
    /// Time in the shaking (s); no number for stages.
    #[serde(with = "number", default = "number::absent")]
    pub time: f64,
    /// N (N/m), M (N m/m), Q (N/m) there and then.
    pub forces: [f64; 3],
    /// V_Rd (N/m) beside that N and M; no number where the code has no clause, and in files of older versions.
    #[serde(with = "number", default = "number::absent", skip_serializing_if = "number::is_absent")]
    pub resistance: f64,
    /// Where in the lining: `crown`, `haunch`, `wall`, `foot` or `floor`; empty in files of older versions.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub part: String,
}
