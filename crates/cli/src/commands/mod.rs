//! One file a command.

pub mod bench;
pub mod check;
pub mod law;
pub mod list;
pub mod mesh;
pub mod motion;
pub mod new;
pub mod report;
pub mod run;
pub mod verify;

use crate::exit::Failure;
use std::path::Path;
use tremolite::setup::{Setup, setup};
use tremolite::{Law, laws};
use tremolite_case::Case;
use tremolite_laws::{Isa, LawInfo};

/// Reads a case and builds what it asks for; warnings go to the terminal.
pub fn load(path: &Path, isa: Isa) -> Result<(Case, Setup), Failure> {
    let laws: Vec<Law> = laws();
    let case = Case::read(path, &infos()).map_err(|r| Failure::case(&r))?;
    if !case.warnings.is_empty() {
        let report = case.report(case.warnings.clone()).as_warnings();
        crate::terminal::say(&report.render(crate::terminal::colour()));
    }
    let setup = setup(&case, &laws, isa).map_err(|r| Failure::case(&r))?;
    if !setup.warnings.is_empty() {
        let report = case.report(setup.warnings.clone()).as_warnings();
        crate::terminal::say(&report.render(crate::terminal::colour()));
    }
    Ok((case, setup))
}

/// Descriptions of all laws a case may name.
pub fn infos() -> Vec<LawInfo> {
    laws().iter().map(|l| l.info).collect()
}

/// A pool of `threads` threads, or of all.
pub fn pool(threads: Option<usize>) -> Result<rayon::ThreadPool, Failure> {
    let threads = threads.unwrap_or_else(crate::machine::threads);
    if !(1..=4096).contains(&threads) {
        return Err(Failure::input("--threads is between 1 and 4096"));
    }
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().map_err(Failure::failed)
}
