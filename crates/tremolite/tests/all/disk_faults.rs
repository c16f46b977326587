//! A disk that is full, goes away or fails once at any moment of a run: the error names a file, and once the disk works again the run goes
//! on to the same bytes.

use crate::held::{files, held_plan, problem};
use crate::ready::Ready;
use std::collections::BTreeMap;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use tremolite::plan::Plan;
use tremolite::simulation::{Built, Ending, Go, Simulation, Start, Stepping};
use tremolite_files::faults::{self, Fault};
use tremolite_results::ResultFolder;

const FAULTS: [Fault; 3] = [Fault::Full, Fault::Gone, Fault::Once];
/// Steps between checkpoints.
const EVERY: u64 = 40;

fn short() -> Plan {
    Plan { duration: 0.005, snapshots: Some(0.002), ..held_plan() }
}

/// Runs to the end, and notes after each checkpoint how many steps it has.
fn run(mut simulation: Simulation, kept: &mut u64) -> Result<(), Box<dyn Error>> {
    while simulation.stage().is_some() {
        simulation.relax(&mut |_| Go::On)?;
    }
    while simulation.step(EVERY)? == Stepping::On {
        assert!(simulation.checkpoint()?.is_none());
        *kept = simulation.taken();
    }
    simulation.finish(Ending::Done, 0.0)?;
    Ok(())
}

fn from_rest(built: &Built, root: &Path, kept: &mut u64) -> Result<(), Box<dyn Error>> {
    let results = ResultFolder::create(Some(root), "run", true)?;
    run(Simulation::new(built, &short(), &results, Start::Rest, Vec::new())?, kept)
}

/// All but what tells of the run itself.
fn results(root: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut files = files(root);
    files.retain(|name, _| !name.ends_with("run.lock") && !name.ends_with("log.txt"));
    files
}

/// An error with all that is behind it.
fn said(error: &dyn Error) -> String {
    match error.source() {
        Some(behind) => format!("{error}: {}", said(behind)),
        None => error.to_string(),
    }
}

/// Moments at which the disk failed and the run went on to the same bytes, at every so many things done to files; with what the errors said.
fn faults_of(every: usize) -> (usize, Vec<String>) {
    let Ready { model, assembly, phase } = Ready::new(problem());
    let built = Built::of(&model, &assembly, &phase);
    let whole = tempfile::tempdir().unwrap();
    let whole = whole.path().join("run");
    from_rest(&built, &whole, &mut 0).unwrap();
    let whole = results(&whole);
    // One disk fails at a time in a process.
    static ONE: Mutex<()> = Mutex::new(());
    let _one = ONE.lock().unwrap_or_else(PoisonError::into_inner);
    let (mut count, mut errors) = (0, Vec::new());
    for fault in FAULTS {
        for after in (0..).step_by(every) {
            let how = format!("{fault:?} after {after}");
            let parent = tempfile::tempdir().unwrap();
            let root = parent.path().join("run");
            let mut kept = 0;
            faults::begin(parent.path(), after, fault);
            let outcome = from_rest(&built, &root, &mut kept);
            if !faults::end() {
                outcome.unwrap_or_else(|why| panic!("{how}: {why}"));
                assert!(results(&root) == whole, "{how}: no fault came, and the results are others");
                break;
            }
            count += 1;
            match outcome {
                Err(why) => {
                    let why = said(&*why);
                    assert!(why.contains(&*parent.path().to_string_lossy()), "{how}: {why}");
                    errors.push(why);
                }
                // What failed was not needed.
                Ok(()) => assert!(fault == Fault::Once, "{how}: the run tells nothing"),
            }
            if !root.join("summary.json").exists() && ResultFolder::goes_on(&root) {
                let folder = ResultFolder::resume(Some(&root), "run").unwrap();
                let resumed = Simulation::new(&built, &short(), &folder, Start::Resume, Vec::new());
                let resumed = resumed.unwrap_or_else(|why| panic!("{how}: {why}"));
                assert!(resumed.taken() >= kept, "{how}: {} of {kept} steps are left", resumed.taken());
                run(resumed, &mut 0).unwrap_or_else(|why| panic!("{how}, going on: {why}"));
            } else {
                assert_eq!(kept, 0, "{how}: the checkpoint is lost");
                from_rest(&built, &root, &mut 0).unwrap_or_else(|why| panic!("{how}, once more: {why}"));
            }
            let other = results(&root);
            assert_eq!(whole.keys().collect::<Vec<_>>(), other.keys().collect::<Vec<_>>(), "{how}");
            for (name, bytes) in &whole {
                assert!(*bytes == other[name], "{how}: {}", name.display());
            }
        }
    }
    (count, errors)
}

/// A sample of what the next does.
#[test]
fn a_run_goes_on_after_the_disk_failed() {
    let (count, errors) = faults_of(211);
    assert!(count > 4 && errors.len() > 3, "{count}, {}", errors.len());
}

#[test]
#[ignore = "minutes; .ci/nightly runs it"]
fn a_run_goes_on_whenever_the_disk_failed() {
    let (count, errors) = faults_of(1);
    println!(
        "{count} moments at which the disk failed, {} of them told, each gone on from to the same bytes",
        errors.len()
    );
    assert!(count > 300);
}
