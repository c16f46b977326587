//! A machine that loses power at any moment of a run leaves a folder from which the run goes on to the same bytes.

use crate::held::{files, held_plan, problem, through_stages};
use crate::ready::Ready;
use std::collections::{BTreeMap, BTreeSet};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use tremolite::plan::Plan;
use tremolite::simulation::{Built, Ending, Simulation, Start, Stepping};
use tremolite_files::record::{self, Act, Loss};
use tremolite_results::{CHECKPOINTS, ResultFolder};

const LOSSES: [Loss; 4] = [Loss::All, Loss::Contents, Loss::Torn, Loss::Nothing];
/// Steps between checkpoints.
const EVERY: u64 = 40;

fn short() -> Plan {
    Plan { duration: 0.005, snapshots: Some(0.002), ..held_plan() }
}

fn finish(mut simulation: Simulation) {
    while simulation.stage().is_some() {
        simulation.relax(&mut |_| tremolite::simulation::Go::On).unwrap();
    }
    while simulation.step(1000).unwrap() == Stepping::On {}
    simulation.finish(Ending::Done, 0.0).unwrap();
}

/// A run with checkpoints in stages and in the shaking, and all that it did to its files.
struct Recorded {
    built: Built,
    parent: tempfile::TempDir,
    acts: Vec<Act>,
    /// Acts done when a checkpoint was written, and steps that were then taken.
    kept: Vec<(usize, u64)>,
}

impl Recorded {
    fn new() -> Recorded {
        let parent = tempfile::tempdir().unwrap();
        let Ready { model, assembly, phase } = Ready::new(problem());
        let built = Built::of(&model, &assembly, &phase);
        // There is one record in a process.
        static ONE: Mutex<()> = Mutex::new(());
        let _one = ONE.lock().unwrap_or_else(PoisonError::into_inner);
        record::begin(parent.path());
        let results = ResultFolder::create(Some(&parent.path().join("run")), "run", true).unwrap();
        let mut held = Simulation::new(&built, &short(), &results, Start::Rest, Vec::new()).unwrap();
        let mut kept = Vec::new();
        // Stopped in each stage, which writes a checkpoint.
        through_stages(&mut held, &mut |_| kept.push((record::so_far(), 0)));
        while held.step(EVERY).unwrap() == Stepping::On {
            assert_eq!(held.checkpoint().unwrap(), None);
            kept.push((record::so_far(), held.taken()));
        }
        held.finish(Ending::Done, 0.0).unwrap();
        assert!(kept.len() > 6, "{kept:?}");
        let acts = record::end();
        Recorded { built, parent, acts, kept }
    }

    /// What is left after so many acts, and whether the run goes on from there; what it then writes is the whole run's.
    fn replay(&self, count: usize, loss: Loss, seen: &mut BTreeSet<u64>) -> bool {
        let left = tempfile::tempdir().unwrap();
        record::leave(&self.acts[..count], loss, self.parent.path(), left.path()).unwrap();
        let root = left.path().join("run");
        let done = self.kept.iter().rfind(|(acts, _)| *acts <= count);
        if !ResultFolder::goes_on(&root) {
            assert!(done.is_none(), "{loss:?} after {count}: the checkpoint is lost");
            return false;
        }
        // Many moments leave the same.
        let mut all = whole(&root);
        all.retain(|path, _| !path.ends_with("run.lock"));
        if !seen.insert(hash(&all)) {
            return false;
        }
        let how = format!("{loss:?} after {count} of {}", self.acts.len());
        let results = ResultFolder::resume(Some(&root), "run").unwrap();
        let resumed = Simulation::new(&self.built, &short(), &results, Start::Resume, Vec::new());
        let resumed = resumed.unwrap_or_else(|why| panic!("{how}: {why}"));
        let steps = done.map_or(0, |(_, steps)| *steps);
        assert!(resumed.taken() >= steps, "{how}: {} of {steps} steps are left", resumed.taken());
        finish(resumed);
        let [whole, other] = [self.parent.path().join("run"), root].map(|root| {
            let mut files = files(&root);
            files.retain(|name, _| !name.ends_with("run.lock") && !name.ends_with("log.txt"));
            files
        });
        assert_eq!(whole.keys().collect::<Vec<_>>(), other.keys().collect::<Vec<_>>(), "{how}");
        for (name, bytes) in &whole {
            assert!(*bytes == other[name], "{how}: {}", name.display());
        }
        true
    }
}

fn hash(files: &BTreeMap<PathBuf, Vec<u8>>) -> u64 {
    let mut hasher = DefaultHasher::new();
    files.hash(&mut hasher);
    hasher.finish()
}

/// All files below a folder, checkpoints too.
fn whole(root: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut all = files(root);
    for name in CHECKPOINTS.into_iter().chain(["hand-over.bin"]) {
        let path = root.join("checkpoint").join(name);
        all.extend(
            std::fs::read(&path).ok().map(|bytes| (path.strip_prefix(root).unwrap().to_owned(), bytes)),
        );
    }
    all
}

fn replays(every: usize) -> usize {
    let run = Recorded::new();
    let mut seen = BTreeSet::new();
    let moments = (0..run.acts.len()).step_by(every).chain([run.acts.len()]);
    let replays = moments.flat_map(|count| LOSSES.map(|loss| (count, loss)));
    replays.filter(|&(count, loss)| run.replay(count, loss, &mut seen)).count()
}

/// A sample of what the next does.
#[test]
fn a_run_goes_on_after_power_was_lost() {
    assert!(replays(97) > 5);
}

#[test]
#[ignore = "minutes; .ci/nightly runs it"]
fn a_run_goes_on_whenever_power_was_lost() {
    let count = replays(1);
    println!("{count} folders that a loss of power leaves, each gone on from to the same bytes");
    assert!(count > 100);
}

/// What a checkpoint is for where it cannot be read: the one before, then what the earthquake began with.
#[test]
fn a_damaged_checkpoint_falls_back_to_the_one_before() {
    let run = Recorded::new();
    let root = run.parent.path().join("run");
    let checkpoints = CHECKPOINTS.map(|name| root.join("checkpoint").join(name));
    let whole = files(&root);
    let resume = || {
        let results = ResultFolder::open_existing(&root).unwrap();
        Simulation::new(&run.built, &short(), &results, Start::Resume, Vec::new())
    };
    let flip = |path: &Path| {
        let mut bytes = std::fs::read(path).unwrap();
        let middle = bytes.len() / 2;
        bytes[middle] ^= 1;
        std::fs::write(path, bytes).unwrap();
    };
    let steps = run.kept.iter().rev().map(|(_, steps)| *steps).take(2).collect::<Vec<_>>();
    let last = resume().unwrap();
    assert_eq!((last.taken(), last.fallen_back()), (steps[0], None));
    drop(last);
    flip(&checkpoints[0]);
    let earlier = resume().unwrap();
    assert_eq!(earlier.taken(), steps[1]);
    let said = earlier.fallen_back().unwrap();
    assert!(
        said.contains("state.bin: the checksum does not fit") && said.contains("checkpoint before"),
        "{said}"
    );
    drop(earlier);
    std::fs::remove_file(&checkpoints[0]).unwrap();
    assert_eq!(resume().unwrap().taken(), steps[1], "a last one that is missing");
    flip(&checkpoints[1]);
    let begun = resume();
    let begun = begun.unwrap();
    assert_eq!(begun.taken(), 0);
    assert!(begun.fallen_back().unwrap().contains("where the earthquake began"));
    finish(begun);
    assert!(files(&root) == whole);
    flip(&root.join("checkpoint/hand-over.bin"));
    assert!(resume().is_err(), "nothing is left");
}
