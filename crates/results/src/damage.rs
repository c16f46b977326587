//! What became of structures: damage by group of elements, cracks, and findings in words.

use indexmap::IndexMap;
use serde::{Deserialize, Serialize};

use crate::{Said, number};

/// How badly a structure fared.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Severity {
    /// Nothing was damaged.
    #[default]
    Undamaged,
    /// Something cracked or yielded.
    Damaged,
    /// Cracks run through its thickness; of bolts, some broke.
    Through,
}

/// What became of a group of elements that is no part of another.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Finding {
    /// By which scripts and translations know it: snake case, once in a summary.
    pub id: String,
    /// The group.
    pub group: String,
    /// How badly it fared.
    pub severity: Severity,
    /// What matters most, to be read after the group's name: 'cracked in 20 % of its volume'.
    pub headline: String,
    /// The same as a pattern; empty in files of other versions.
    #[serde(skip_serializing_if = "Said::is_empty")]
    pub headline_message: Said,
    /// The rest, in sentences; may be empty.
    pub text: String,
    /// The same as a pattern.
    #[serde(skip_serializing_if = "Said::is_empty")]
    pub text_message: Said,
    /// What it says, by name, SI units; shares are of the group's volume.
    #[serde(deserialize_with = "number::deserialize_map")]
    pub numbers: IndexMap<String, f64>,
}

impl Finding {
    /// A finding without numbers. Its texts are patterns, as those of [`TrustLine`](crate::TrustLine).
    pub fn new(id: String, group: &str, severity: Severity, headline: Said, text: Said) -> Self {
        Finding {
            id,
            group: group.into(),
            severity,
            headline: headline.to_string(),
            headline_message: headline,
            text: text.to_string(),
            text_message: text,
            numbers: IndexMap::new(),
        }
    }

    /// The same finding with one of the numbers that it says.
    pub fn with(mut self, name: &str, value: f64) -> Self {
        self.numbers.insert(name.into(), value);
        self
    }

    /// The same finding with the place of something \[m\], a number a coordinate: `NAME_x`.
    pub fn with_place(self, name: &str, [x, y, z]: [f64; 3]) -> Self {
        self.with(&format!("{name}_x"), x).with(&format!("{name}_y"), y).with(&format!("{name}_z"), z)
    }
}

/// How far the elements of a group are damaged at the end of a run.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct GroupDamage {
    /// Volume of the group's elements (m³).
    #[serde(with = "number", default = "number::absent")]
    pub volume: f64,
    /// Measure of damage, by the name of its field (`d_tension`, `plastic_shear_strain`) → what was found.
    pub measures: IndexMap<String, Damaged>,
    /// How wide cracks are, and whether they run through; none where the law knows no cracks.
    pub cracks: Option<Cracks>,
}

/// Which way a crack of a lining runs, by its normal in the lining's own frame: round the ring, along the axis, through the thickness.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum CrackDirection {
    /// Along the cavern: its normal lies round the ring. Bars round the ring cross it.
    Longitudinal,
    /// Round the ring: its normal lies along the axis. Bars along the axis cross it.
    Ring,
    /// Parallel to the wall: its normal lies within 45° of the thickness. No bar of the section crosses it.
    Parallel,
    /// Where walls meet, and where a lining has no thickness by its shape: there is no frame. It counts as one that crosses bars.
    Unplaced,
}

impl CrackDirection {
    /// All there are.
    pub const ALL: [CrackDirection; 4] = [
        CrackDirection::Longitudinal,
        CrackDirection::Ring,
        CrackDirection::Parallel,
        CrackDirection::Unplaced,
    ];

    /// The column of `damage.csv` with the widest crack so far that runs this way.
    pub const fn column(self) -> &'static str {
        match self {
            CrackDirection::Longitudinal => "crack_longitudinal",
            CrackDirection::Ring => "crack_ring",
            CrackDirection::Parallel => "crack_parallel",
            CrackDirection::Unplaced => "crack_unplaced",
        }
    }

    /// What that column means.
    pub const fn meaning(self) -> &'static str {
        match self {
            CrackDirection::Longitudinal => {
                "widest crack so far along the cavern, across the bars round the ring"
            }
            CrackDirection::Ring => "widest crack so far round the ring, across the bars along the axis",
            CrackDirection::Parallel => {
                "widest crack so far parallel to the wall, which no bar of the section crosses"
            }
            CrackDirection::Unplaced => {
                "widest crack so far where walls meet, which counts as one across bars"
            }
        }
    }

    /// Whether bars of the section cross it: all but those parallel to the wall.
    pub fn crosses_bars(self) -> bool {
        self != CrackDirection::Parallel
    }

    /// Its number in the field `crack_direction`, where 0 is no crack.
    pub const fn number(self) -> u8 {
        1 + self as u8
    }
}

/// Cracks of one direction in a group of elements.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Opened {
    /// Which way they run.
    pub direction: CrackDirection,
    /// Widest opening over the run (m).
    #[serde(with = "number", default = "number::absent")]
    pub opening: f64,
    /// When and where it was; none if nothing cracked so.
    pub widest: Option<Onset>,
    /// Widest opening at the end (m), of whichever crack.
    #[serde(with = "number", default = "number::absent")]
    pub left: f64,
}

impl Default for Opened {
    fn default() -> Self {
        Opened { direction: CrackDirection::Unplaced, opening: f64::NAN, widest: None, left: f64::NAN }
    }
}

/// The cracks of a group of elements.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Cracks {
    /// Widest opening over the run (m).
    #[serde(with = "number", default = "number::absent")]
    pub opening: f64,
    /// When and where it was; none if nothing cracked.
    pub widest: Option<Onset>,
    /// Widest opening at the end (m), of whichever crack; no number in files of older versions.
    #[serde(with = "number", default = "number::absent", skip_serializing_if = "number::is_absent")]
    pub left: f64,
    /// The same by the direction in which cracks run; empty in files of older versions.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub directions: Vec<Opened>,
    /// Stacks of elements through the group's thickness.
    pub stacks: u64,
    /// How many of them are cracked through.
    pub through: u64,
    /// Of the elements of those the one that opened widest, with its centre (m).
    pub through_at: Option<Place>,
}

impl Cracks {
    /// Opening (m) beyond which pieces are loose: some hundredths of strain in elements of some decimetres, which is
    /// past what small strains and any reinforcement would hold.
    pub const LOOSE: f64 = 0.02;

    /// The widest crack of those that cross bars: all but those parallel to the wall. None in files of older versions, which do not tell
    /// directions.
    pub fn across(&self) -> Option<&Opened> {
        let crosses = |of: &&Opened| of.direction.crosses_bars();
        self.directions.iter().filter(crosses).max_by(|a, b| a.opening.total_cmp(&b.opening))
    }

    /// The widest crack parallel to the wall; none in files of older versions.
    pub fn parallel(&self) -> Option<&Opened> {
        self.directions.iter().find(|of| of.direction == CrackDirection::Parallel)
    }

    /// Whether a crack opened beyond [`Cracks::LOOSE`]; its width then means little.
    pub fn is_loose(&self) -> bool {
        self.opening > Self::LOOSE
    }
}

/// An element and its centre.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Place {
    /// The element, by its number in the mesh.
    pub element: u64,
    /// Its centre (m).
    pub at: [f64; 3],
}

/// One measure of damage in a group of elements.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Damaged {
    /// Threshold as one writes it (`0.5`) → volume in which the measure is above it (m³).
    #[serde(deserialize_with = "number::deserialize_map")]
    pub beyond: IndexMap<String, f64>,
    /// Largest value in the group.
    #[serde(with = "number", default = "number::absent")]
    pub largest: f64,
    /// Where it first rose above zero; none if it never did.
    pub first: Option<Onset>,
    /// How many times the strength was its static one where it was damaged, 1 of a law that is the same at any rate; none where nothing was damaged,
    /// of measures that know no strength, and in files of older versions.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rate: Option<RateFactor>,
}

/// How many times the strength of concrete was its static one when points of a group were first damaged, since they were strained fast.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct RateFactor {
    /// Largest at a point.
    #[serde(with = "number", default = "number::absent")]
    pub largest: f64,
    /// Its element.
    pub at: Place,
    /// Mean over the volume that is damaged.
    #[serde(with = "number", default = "number::absent")]
    pub mean: f64,
    /// Largest at a point of the element in which damage began ([`Damaged::first`]); no number where that is not known.
    #[serde(with = "number", default = "number::absent", skip_serializing_if = "number::is_absent")]
    pub first: f64,
}

impl Default for RateFactor {
    fn default() -> Self {
        RateFactor { largest: f64::NAN, at: Place::default(), mean: f64::NAN, first: f64::NAN }
    }
}

/// Where and when something began.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Onset {
    /// First time seen (s).
    #[serde(with = "number", default = "number::absent")]
    pub time: f64,
    /// The element, by its number in the mesh.
    pub element: u64,
    /// Its centre (m).
    pub at: [f64; 3],
}
