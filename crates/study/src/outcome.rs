//! What became of a run, by what lies in its folder: nothing else is remembered of it.

use std::fs;
use std::path::{Path, PathBuf};

use tremolite_results::study::RunStatus;
use tremolite_results::{Error, Reliance, ResultFolder, State};

use crate::measure::Results;

/// The folder of a run, `OUT/runs/NAME`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RunFolder(pub PathBuf);

impl RunFolder {
    pub fn new(out: &Path, name: &str) -> RunFolder {
        RunFolder(out.join("runs").join(name))
    }

    /// The case that is run, with its files by absolute paths.
    pub fn case(&self) -> PathBuf {
        self.0.join("case.toml")
    }

    /// The case on one line and hashes of what it reads, by which it is known again whatever folders lie where.
    pub fn bare(&self) -> PathBuf {
        self.0.join("case.line")
    }

    /// Its results.
    pub fn results(&self) -> PathBuf {
        self.0.join("results")
    }

    /// The page of its results, as it is named from the study's folder.
    pub fn page(name: &str) -> String {
        format!("runs/{name}/results/report.html")
    }

    /// What the program said.
    pub fn log(&self) -> PathBuf {
        self.0.join("run.log")
    }

    /// Why the program ended without a result.
    pub fn broken(&self) -> PathBuf {
        self.0.join("broken.txt")
    }

    /// Locked while somebody computes it.
    pub fn lock(&self) -> PathBuf {
        self.0.join("lock")
    }

    /// Tables and summary that are not what the run that ended wrote, in words.
    pub fn damaged(&self) -> Vec<String> {
        match ResultFolder::open_existing(&self.results()).and_then(|results| results.damaged_tables()) {
            Ok(damaged) => damaged,
            // Of no results nothing is damaged.
            Err(Error::NoResults { .. }) => Vec::new(),
            Err(why) => vec![why.to_string()],
        }
    }

    /// Why the summary of a run that ended or was stopped cannot be read; nothing where it can, or there was none.
    pub fn lost_summary(&self) -> Option<String> {
        let results = self.results();
        let summary = results.join("summary.json");
        let was_there = summary.exists() || results.join("SHA256SUMS").exists();
        (was_there && Results::of(&results).is_none())
            .then(|| format!("{}: it cannot be read", summary.display()))
    }

    /// Whether it holds this very case, and not one that has changed since.
    pub fn is_of(&self, bare: &str) -> bool {
        fs::read_to_string(self.bare()).is_ok_and(|kept| kept == bare)
    }
}

/// What became of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    pub status: RunStatus,
    /// Why it did not come to its end.
    pub why: String,
    pub program: String,
    /// Classes of state and reliance, of a run that is done.
    pub classes: (Option<State>, Option<Reliance>),
}

impl Outcome {
    /// Of the run in a folder that is to be of this case.
    pub fn of(folder: &RunFolder, bare: &str) -> Outcome {
        let pending = Outcome::pending();
        if !folder.is_of(bare) {
            return pending;
        }
        if let Ok(why) = fs::read_to_string(folder.broken()) {
            return Outcome { status: RunStatus::Error, why: why.trim().to_owned(), ..pending };
        }
        let results = folder.results();
        let Some(found) = Results::of(&results) else {
            return Outcome { why: folder.lost_summary().unwrap_or_default(), ..pending };
        };
        let status = match found.text("status") {
            "done" => RunStatus::Done,
            // A run that has shaken has books of its energy.
            "failed" if results.join("energy.csv").exists() => RunStatus::Failed,
            "failed" => RunStatus::NotConverged,
            _ => RunStatus::Pending,
        };
        let why = if status == RunStatus::Done { "" } else { found.text("outcome") };
        let classes = match status {
            RunStatus::Done => found.classes(),
            _ => (None, None),
        };
        Outcome { status, why: why.to_owned(), program: found.program().to_owned(), classes }
    }

    /// Of a run that is still to be run.
    pub fn pending() -> Outcome {
        let (why, program, classes) = Default::default();
        Outcome { status: RunStatus::Pending, why, program, classes }
    }

    /// The same, but a run whose tables are not what it wrote, by the checksums beside them, is still to be run. This reads them all.
    pub fn checked(folder: &RunFolder, bare: &str) -> Outcome {
        let found = Outcome::of(folder, bare);
        let damaged = if found.has_ended() { folder.damaged() } else { Vec::new() };
        match damaged.first() {
            Some(first) => Outcome { status: RunStatus::Pending, why: first.clone(), ..found },
            None => found,
        }
    }

    /// Whether nothing is left to do of it.
    pub fn has_ended(&self) -> bool {
        self.status != RunStatus::Pending
    }
}
