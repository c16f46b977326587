//! `summary.json`: the verdict, what was computed, its peaks, and how far it can be trusted.

use std::fs;
use std::path::Path;

use indexmap::IndexMap;
use serde::{Deserialize, Serialize};

use crate::{
    BoltPlace, BoltSummary, Error, Fact, Finding, GroupDamage, GroupStress, InterfaceSummary, MaterialFacts,
    PairPlace, Peaks, Said, StageSummary, TrustLine, number, replace_file,
};

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

/// All of `summary.json`. Units are SI. Objects keep the order in which they were filled.
///
/// A field that a file lacks reads as empty, zero or NaN, so that summaries of other versions can
/// be reported on; unknown fields are passed over.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Summary {
    /// The case's title.
    pub title: String,
    /// How the run ended.
    pub status: Status,
    /// The outcome in a few sentences, for people: that of the run, then that of each structure.
    pub verdict: String,
    /// How the run went: the first part of the verdict.
    pub outcome: String,
    /// The same as a pattern; empty in files of other versions.
    #[serde(skip_serializing_if = "Said::is_empty")]
    pub outcome_said: Said,
    /// What became of each structure: the second part.
    pub findings: Vec<Finding>,
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
    /// Program and machine.
    pub run: RunFacts,
    /// Stages before the earthquake, in their order; the first is the initial equilibrium.
    pub stages: Vec<StageSummary>,
    /// Monitor → position (m), of the node or point that was used.
    pub positions: IndexMap<String, [f64; 3]>,
    /// Monitor → quantity → peaks.
    pub monitors: IndexMap<String, IndexMap<String, Peaks>>,
    /// Pair of monitors as `A-B` → quantity → peaks of the difference A − B.
    pub relative: IndexMap<String, IndexMap<String, Peaks>>,
    /// Component of displacement (`ux`) → how far the monitors move in step along it, but for those on broken elements and those
    /// that move less than a hundredth of the most; empty without two.
    #[serde(skip_serializing_if = "IndexMap::is_empty")]
    pub synchrony: IndexMap<String, Synchrony>,
    /// Monitors on elements that tension had broken through when the run ended: they show how loose pieces move.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub monitors_on_broken_elements: Vec<String>,
    /// Group of elements → its largest stresses; groups may overlap.
    pub stress: IndexMap<String, GroupStress>,
    /// Group of elements → how far it is damaged or yielded; groups whose laws know neither are left out, and groups
    /// may overlap.
    pub damage: IndexMap<String, GroupDamage>,
    /// Interface → what it did.
    pub interfaces: IndexMap<String, InterfaceSummary>,
    /// Monitor on an interface → its pair.
    pub pairs: IndexMap<String, PairPlace>,
    /// Group of bolts → what became of them.
    pub bolts: IndexMap<String, BoltSummary>,
    /// Monitor on a bolt → its segment.
    pub bolt_monitors: IndexMap<String, BoltPlace>,
    /// Line of the energy balance → its value at the end (J).
    #[serde(deserialize_with = "number::deserialize_map")]
    pub energy: IndexMap<String, f64>,
    /// Each a number against its limit; every check is here, those that do not apply with the reason.
    pub trust: Vec<TrustLine>,
    /// How the page is to be set.
    pub report: PageWish,
    /// What was unusual about the case before the run, a sentence each with what to do.
    pub before: Vec<String>,
    /// What is true by construction, for people to know.
    pub facts: Vec<Fact>,
    /// What the run read: mesh, records, case.
    pub inputs: Vec<Input>,
    /// Version of the program.
    pub version: String,
    /// What the case left out and the program chose.
    pub defaulted: Vec<Defaulted>,
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
    /// Steps done.
    pub steps: u64,
    /// Time step (s).
    #[serde(with = "number", default = "number::absent")]
    pub time_step: f64,
    /// What sets the time step, in words: which element, boundary or damping.
    pub step_set_by: String,
    /// The same as a pattern.
    #[serde(skip_serializing_if = "Said::is_empty")]
    pub step_set_by_said: Said,
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
    /// Axis of the model → where its record came from, in words.
    pub source: IndexMap<String, String>,
    /// How it was deconvolved, where it was.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub deconvolved: Option<Deconvolved>,
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
}

/// How the case wants its page set.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct PageWish {
    /// `en` or `zh`.
    pub language: String,
    /// Whether the page holds the model in three dimensions.
    pub view: bool,
}

impl Default for PageWish {
    fn default() -> Self {
        PageWish { language: "en".into(), view: true }
    }
}

/// A file that the run read.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Input {
    /// As the case names it; `case` for the case itself.
    pub name: String,
    /// Where it lay.
    pub path: String,
    /// SHA-256 of its bytes, in hexadecimal digits.
    pub hash: String,
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

/// A key that the case left out.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Defaulted {
    /// The key with its tables, `dynamic.damping.ratio`.
    pub key: String,
    /// The value used, as one would write it in the case, unit included.
    pub value: String,
}

impl Defaulted {
    /// A key and the value used for it.
    pub fn new(key: impl Into<String>, value: impl Into<String>) -> Self {
        Defaulted { key: key.into(), value: value.into() }
    }
}

impl Summary {
    /// Writes the file, replacing an old one whole. Numbers that are not finite become `null`.
    ///
    /// # Errors
    /// [`Error::Io`].
    pub fn write(&self, path: &Path) -> Result<(), Error> {
        let mut text =
            serde_json::to_vec_pretty(self).map_err(|e| Error::format(path, None, e.to_string()))?;
        text.push(b'\n');
        replace_file(path, &text)
    }

    /// Reads the file.
    ///
    /// # Errors
    /// [`Error::Io`]; [`Error::Format`] with the line if it is not JSON of this form.
    pub fn read(path: &Path) -> Result<Self, Error> {
        let text = fs::read(path).map_err(Error::io(path, "read this file"))?;
        serde_json::from_slice(&text)
            .map_err(|e| Error::format(path, Some(e.line()), format!("not a summary of a run: {e}")))
    }

    /// Lines of the trust report that were judged.
    pub fn judged(&self) -> usize {
        self.trust.iter().filter(|line| !line.not_applicable).count()
    }

    /// Lines of the trust report that did not pass.
    pub fn warnings(&self) -> usize {
        self.trust.iter().filter(|line| !line.pass).count()
    }
}
