//! `summary.json`: the verdict, what was computed, its peaks, and how far it can be trusted.

mod case;
mod computed;
mod conclusion;
mod monitors;
mod parts;
mod path;
mod soundness;
mod waves;

use std::fs;
use std::path::Path;

use serde::{Deserialize, Serialize};

pub use case::{CaseFacts, Defaulted, Input, PageWish};
pub use computed::{
    Computed, Deconvolved, InitialStress, LiningExtent, ModelFacts, MotionFacts, RunFacts, SoilLayer,
    TargetSpectrum,
};
pub use conclusion::{Conclusion, Status};
pub use monitors::{MonitorFacts, Synchrony};
pub use parts::PartFacts;
pub use path::check_summary_path;
pub use soundness::Soundness;
pub use waves::{Wave, WavePart};

use crate::{Error, replace_file};

/// All of `summary.json`, in the order of the file, where the fields of all parts stand beside each other. Units are SI. Objects
/// keep the order in which they were filled.
///
/// A field that a file lacks reads as empty, zero or NaN, so that summaries of other versions can
/// be reported on; unknown fields are passed over.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Summary {
    /// The case's title.
    pub title: String,
    /// How the run ended and what became of each structure.
    #[serde(flatten)]
    pub conclusion: Conclusion,
    /// What was computed, and how fast.
    #[serde(flatten)]
    pub computed: Computed,
    /// Where the monitors are, and their peaks.
    #[serde(flatten)]
    pub monitors: MonitorFacts,
    /// What became of groups of elements, interfaces and bolts.
    #[serde(flatten)]
    pub parts: PartFacts,
    /// How far the run can be trusted.
    #[serde(flatten)]
    pub soundness: Soundness,
    /// What the case asked for and left open, and what it was read from.
    #[serde(flatten)]
    pub case: CaseFacts,
}

/// What is read beside the parts.
#[derive(Default, Deserialize)]
#[serde(default)]
struct Title {
    title: String,
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
        Summary::parse(&text)
            .map_err(|e| Error::format(path, Some(e.line()), format!("not a summary of a run: {e}")))
    }

    /// Each part passes over the fields of the others. Read as one, flattened parts would come out of a buffer that has
    /// forgotten the lines, which faults must name.
    fn parse(text: &[u8]) -> serde_json::Result<Self> {
        let Title { title } = serde_json::from_slice(text)?;
        Ok(Summary {
            title,
            conclusion: serde_json::from_slice(text)?,
            computed: serde_json::from_slice(text)?,
            monitors: serde_json::from_slice(text)?,
            parts: serde_json::from_slice(text)?,
            soundness: serde_json::from_slice(text)?,
            case: serde_json::from_slice(text)?,
        })
    }

    /// Lines of the trust report that were judged.
    pub fn judged(&self) -> usize {
        self.soundness.checks.iter().filter(|line| !line.not_applicable).count()
    }

    /// Lines of the trust report that did not pass.
    pub fn warnings(&self) -> usize {
        self.soundness.checks.iter().filter(|line| !line.pass).count()
    }
}
