//! One file a command.

pub mod bench;
pub mod check;
pub mod law;
pub mod list;
pub mod mesh;
pub mod motion;
pub mod new;
pub mod report;
mod room;
pub mod run;
pub mod study;
pub mod verify;

use crate::exit::Failure;
use crate::terminal::tell;
use std::path::Path;
use tremolite::job::{Fault, Given, Job, Loaded, Why};
use tremolite::laws;
use tremolite_case::Change;
use tremolite_laws::{Isa, LawInfo};

/// What the command line gives beside a case: the values of `set` (KEY=VALUE) at their keys, and an instruction set.
pub fn given(set: &[String], isa: Isa) -> Result<Given, Failure> {
    let change = |text: &String| Change::of_option("--set", text);
    let changes: Vec<Change> = set.iter().map(change).collect::<Result<_, _>>().map_err(Failure::input)?;
    Ok(Given { changes, isa, ..Given::default() })
}

/// Reads a case and builds what it asks for; what is unusual goes to the terminal.
pub fn load(path: &Path, given: &Given) -> Result<Loaded, Failure> {
    let loaded = Loaded::read(path, given).map_err(|fault| refused(fault, 0))?;
    tell(&loaded.remarks());
    Ok(loaded)
}

/// The job of a case whose remarks have been told; its own are not yet.
pub fn modelled(loaded: Loaded) -> Result<Job, Failure> {
    let told = loaded.remarks().len();
    Job::of_loaded(loaded).map_err(|fault| refused(fault, told))
}

/// Why a case is no job. What was found unusual before goes to the terminal, but for what has been `told`.
fn refused(fault: Fault, told: usize) -> Failure {
    tell(&fault.remarks[told..]);
    let failure = match &fault.why {
        Why::Case(report) => Failure::case(report),
        why => Failure::input(why),
    };
    Failure { remarks: fault.remarks, ..failure }
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
