//! `study.json`: the runs of a study with what came out of them, and the curves fitted to them. The page of a study is made of it
//! alone; `study.csv` holds the same runs as a table.

use std::fs;
use std::path::Path;

use indexmap::IndexMap;
use serde::{Deserialize, Serialize};

use crate::{Error, Reliance, Said, State, replace_file};

/// A study.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Study {
    pub title: String,
    /// The language of the page, `en` or `zh`; empty in files of other versions.
    pub language: String,
    /// The study file, as it was named.
    pub file: String,
    /// The case, as the study names it.
    pub case: String,
    /// Keys of the case that differ from run to run.
    pub parameters: Vec<StudyColumn>,
    /// Measures of intensity; the first is that of the levels, where there are any.
    pub intensities: Vec<StudyColumn>,
    /// Numbers taken from the results.
    pub measures: Vec<StudyColumn>,
    /// In the order of the plan.
    pub runs: Vec<StudyRun>,
    /// Whether levels of a record rise until a limit is exceeded.
    pub rises: bool,
    /// Results over records, by the codes' rules; only where there are several records.
    pub over_records: Vec<OverRecords>,
    /// What one key changes; only of studies of one at a time and of rows.
    pub tornados: Vec<Tornado>,
    /// How ranks of keys and results go together; only of random samples.
    pub influences: Vec<Influence>,
    pub fragilities: Vec<StudyFragility>,
}

/// A column of numbers or words.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct StudyColumn {
    pub name: String,
    /// Of its numbers; nothing for words, or where it is not known.
    pub unit: Option<String>,
    /// The unit that it is told in, as SI numbers are divided by `shown_factor`; empty for numbers that are told as they are.
    pub shown: String,
    pub shown_factor: f64,
}

/// How a run ended.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum RunStatus {
    /// At its end.
    Done,
    /// The guard stopped it in its earthquake.
    Failed,
    /// A stage before the earthquake did not come to rest.
    #[serde(rename = "not_converged")]
    NotConverged,
    /// The program refused its case, or was ended.
    Error,
    /// Not yet at its end.
    #[default]
    Pending,
    /// A lower level of its record was beyond the limit.
    NotNeeded,
}

impl RunStatus {
    /// As it is written.
    pub fn word(self) -> &'static str {
        match self {
            RunStatus::Done => "done",
            RunStatus::Failed => "failed",
            RunStatus::NotConverged => "not_converged",
            RunStatus::Error => "error",
            RunStatus::Pending => "pending",
            RunStatus::NotNeeded => "not-needed",
        }
    }
}

/// A run of a study.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct StudyRun {
    /// Its folder in `runs`.
    pub name: String,
    /// What its sample is called for people.
    pub title: String,
    /// Number of its sample.
    pub sample: usize,
    /// Number of the sample that it is to be set beside.
    pub beside: Option<usize>,
    pub record: Option<String>,
    /// The level of intensity, as it is written.
    pub level: Option<String>,
    /// What its motion is multiplied by.
    pub factor: Option<f64>,
    /// One a parameter, as it is written in the case; nothing where the case's value stays.
    pub values: Vec<Option<String>>,
    /// One a measure of intensity, SI.
    pub intensities: Vec<Option<f64>>,
    /// One a measure, SI.
    pub measures: Vec<Option<f64>>,
    pub status: RunStatus,
    /// Why it has no results.
    pub why: String,
    /// The program that ran it.
    pub program: String,
    /// Its page, from the study's folder; empty where there is none, and in files of older versions.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub page: String,
    /// Limits of acceptance of its case, by their keys, beside what was found; empty where it gives none, has no results, or the study goes on.
    #[serde(skip_serializing_if = "IndexMap::is_empty")]
    pub limits: IndexMap<String, StudyLimit>,
    /// Class of its state and of its reliance, as in summary.json; none where it has no results, and in files of older versions.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub state: Option<State>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reliance: Option<Reliance>,
}

/// A limit of acceptance of a run, and whether it is met.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct StudyLimit {
    /// SI.
    pub limit: f64,
    /// What was found, SI; none where that is not known or has no bound.
    pub found: Option<f64>,
    /// None where the results do not tell.
    pub met: Option<bool>,
    /// Of both; `1` for shares.
    pub unit: String,
}

/// Results over records of one sample at one level.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct OverRecords {
    pub sample: usize,
    pub title: String,
    pub level: Option<String>,
    pub measure: String,
    /// Records that have the result, of `of`.
    pub records: usize,
    pub of: usize,
    pub mean: f64,
    pub largest: f64,
    /// The value by the codes: the largest of three to six records, the mean of seven and more.
    pub by_code: Option<f64>,
}

/// How a result changes as one key does.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Tornado {
    pub measure: String,
    /// The run that the others stand beside, where there are several such; else empty.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub beside: String,
    /// Of that run, or of the case as it is.
    pub base: f64,
    /// The widest first.
    pub bars: Vec<TornadoBar>,
}

/// A key, and the results at its values.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct TornadoBar {
    pub name: String,
    /// Least result, with the value of the key.
    pub low: (String, f64),
    /// Largest result.
    pub high: (String, f64),
}

/// How a key and a result go together over a random sample.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Influence {
    pub parameter: String,
    pub measure: String,
    /// Spearman's correlation of ranks, of the runs of one record and level; the mean over these.
    pub rank: f64,
    pub runs: usize,
}

/// A fragility curve, or why there is none. Intensities are in the unit `unit`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct StudyFragility {
    pub measure: String,
    pub above: f64,
    /// The measure of intensity.
    pub by: String,
    pub unit: String,
    /// SI value of the unit.
    pub unit_value: f64,
    /// `binomial` or `truncated`.
    pub method: String,
    pub fit: Option<StudyFit>,
    /// Why there is no curve; and the same as a pattern, empty in files of other versions.
    pub no_curve: String,
    #[serde(skip_serializing_if = "Said::is_empty")]
    pub no_curve_message: Said,
    pub bounds: Option<StudyBounds>,
    /// Why there are no bounds.
    pub no_bounds: String,
    /// Shares of runs beyond the limit, by level; of rising levels shares of records up to an intensity.
    pub shares: Vec<Share>,
    /// Intensity and probability.
    pub curve: Vec<[f64; 2]>,
    /// Runs that are counted: of these beyond the limit, of these stopped by the guard.
    pub counted: usize,
    pub exceeded: usize,
    pub stopped_counted: usize,
    /// Runs that are in no sum, by how they ended.
    pub left_out: Vec<(String, usize)>,
}

/// A lognormal curve.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct StudyFit {
    pub theta: f64,
    pub beta: f64,
    /// Of ln θ and β.
    pub covariance: [[f64; 2]; 2],
    pub log_likelihood: f64,
}

/// Bounds of nine tenths of all samples of a bootstrap over records.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct StudyBounds {
    pub theta: [f64; 2],
    pub beta: [f64; 2],
    /// Of the probability at each point of the curve.
    pub band: Vec<[f64; 2]>,
    pub clusters: usize,
    pub samples: usize,
    /// Samples without a curve, which are in no bound.
    pub without: usize,
}

/// Runs at one intensity.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Share {
    pub intensity: f64,
    pub exceeded: usize,
    pub of: usize,
    /// Of rising levels that are not all run as high: the probability by the product limit, which counts a series up to where it was run.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub probability: Option<f64>,
}

impl Share {
    /// The probability that it says.
    pub fn probability(&self) -> f64 {
        self.probability.unwrap_or(self.exceeded as f64 / self.of.max(1) as f64)
    }
}

impl Study {
    /// Reads a `study.json`.
    ///
    /// # Errors
    /// [`Error::Io`]; [`Error::Format`] for what is none.
    pub fn read(path: &Path) -> Result<Study, Error> {
        let text = fs::read(path).map_err(Error::io(path, "read this file"))?;
        serde_json::from_slice(&text).map_err(|e| Error::format(path, Some(e.line()), e.to_string()))
    }

    /// Writes it, whole or not at all.
    ///
    /// # Errors
    /// [`Error::Io`].
    pub fn write(&self, path: &Path) -> Result<(), Error> {
        let mut text = serde_json::to_vec_pretty(self).unwrap_or_default();
        text.push(b'\n');
        replace_file(path, &text)
    }
}
