//! What a study file holds, read.

use std::ops::Range;
use std::path::{Path, PathBuf};

use super::{Checks, Design, FailedRun, Keep, SampleKind, Setting, Take};
use crate::{Spanned, key_path};

/// A rank correlation between two varied keys.
#[derive(Clone, Debug, PartialEq)]
pub struct Correlation {
    pub between: [Spanned<String>; 2],
    /// Between −1 and 1.
    pub rank: Spanned<f64>,
}

/// A run that is written out.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    pub name: Spanned<String>,
    /// The row that it is to be set beside.
    pub beside: Option<Spanned<String>>,
    pub set: Vec<Setting>,
}

/// How samples are chosen.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    pub kind: Spanned<SampleKind>,
    /// Number of samples, of latin-hypercube and sobol; 0 of the others.
    pub count: u32,
    /// From 1.
    pub seed: u32,
    /// The table of values.
    pub file: Option<Spanned<PathBuf>>,
    /// Shares of a distribution at which one-at-a-time and grid take its values.
    pub quantiles: Vec<f64>,
}

/// A record in place of the case's.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordEntry {
    pub name: Spanned<String>,
    /// Keys of `[motion]` with their values as TOML.
    pub(super) entries: Vec<(String, String)>,
    /// Files that it names, as written; relative to the study's folder.
    pub files: Vec<Spanned<PathBuf>>,
    /// Its header.
    pub span: Range<usize>,
}

/// How strong motions are made.
#[derive(Clone, Debug, PartialEq)]
pub struct Scale {
    /// The intensity measure, as written.
    pub measure: Spanned<String>,
    /// The spectrum that `target(…)` is over, as written: words or a file from the study's folder; that of the case where it is left out.
    pub target: Option<Spanned<String>>,
    pub levels: Levels,
    pub design: Design,
}

/// Which levels of intensity.
#[derive(Clone, Debug, PartialEq)]
pub enum Levels {
    /// The same for all records, as written.
    Stripes(Vec<Spanned<String>>),
    /// Rising for each record until it is beyond a limit.
    Ida(Ida),
}

/// Incremental dynamic analysis.
#[derive(Clone, Debug, PartialEq)]
pub struct Ida {
    pub first: Spanned<String>,
    pub step: Spanned<String>,
    /// Number of levels at most.
    pub most: u32,
    /// The measure that ends it.
    pub until: Spanned<String>,
    /// Its value beyond which it ends.
    pub above: f64,
}

/// A column of the table of results.
#[derive(Clone, Debug, PartialEq)]
pub struct Measure {
    pub name: Spanned<String>,
    pub of: MeasureOf,
    /// The SI unit of a number of summary.json, where the study says it.
    pub unit: Option<String>,
    /// Taken where the files hold no such number.
    pub otherwise: Option<f64>,
    /// It stays empty where the text at this path of summary.json lists one of these names.
    pub unless: Option<(Spanned<String>, Vec<String>)>,
}

/// Where a measure is found.
#[derive(Clone, Debug, PartialEq)]
pub enum MeasureOf {
    /// In summary.json, by its path, over another number there.
    Summary { path: Spanned<String>, over: Option<Spanned<String>> },
    /// How many checks of the run.
    Checks(Checks),
    /// In a column of a table.
    Column { table: Spanned<String>, column: Spanned<String>, take: Take },
}

/// A fragility curve for each of several limits.
#[derive(Clone, Debug, PartialEq)]
pub struct Fragility {
    pub measure: Spanned<String>,
    /// Rising.
    pub above: Vec<f64>,
    /// The intensity measure, as written; nothing: that of `[scale]`.
    pub by: Option<Spanned<String>>,
    pub failed: FailedRun,
    /// Number of samples of the bootstrap over records.
    pub bootstrap: u32,
    pub span: Range<usize>,
}

/// How a study is run, which changes no result.
#[derive(Clone, Debug, PartialEq)]
pub struct RunWish {
    pub at_once: Option<u32>,
    pub threads: Option<u32>,
    pub keep: Keep,
    /// Whether runs that are equal before the earthquake share what comes before it.
    pub share: bool,
}

impl RecordEntry {
    /// The keys of `[motion]` that it brings, with their values as TOML; `place` says how a file is to be named.
    pub fn motion(&self, place: impl Fn(&Path) -> PathBuf) -> Vec<(String, String)> {
        let placed = |file: &Path| key_path::quoted(&place(file).to_string_lossy().replace('\\', "/"));
        let named = |file: &Path| key_path::quoted(&file.to_string_lossy());
        let value = |(key, value): &(String, String)| {
            let file = self.files.iter().find(|file| match key.as_str() {
                "file" => true,
                // A component names its file on one line, as it is written here.
                _ => value.contains(&format!("file = {}", named(&file.value))),
            });
            let value = file
                .map_or_else(|| value.clone(), |f| value.replacen(&named(&f.value), &placed(&f.value), 1));
            // Turned alone: the ground stays as the case has it.
            let key = if key == "model_x_azimuth" { "x_azimuth" } else { key };
            (key.to_owned(), value)
        };
        self.entries.iter().map(value).collect()
    }
}
