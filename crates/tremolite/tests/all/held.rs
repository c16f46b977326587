//! A simulation that somebody holds writes the bytes of a run, however it is driven and whatever is looked at between.

use crate::bolt_results::{bolted, plan};
use crate::contact::{BANDIS, between};
use crate::ready::Ready;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;
use tremolite::engine::Release;
use tremolite::plan::{PairMonitor, Plan};
use tremolite::quantities::Field;
use tremolite::run::{Control, run};
use tremolite::simulation::{Built, Ending, Go, Simulation, StageEnd, Start, Stepping};
use tremolite::stages::PlannedStage;
use tremolite::{Problem, RunError, Side};
use tremolite_results::{ResultFolder, Table};

/// Two bodies with a weak joint between them, bolts from the second stage on, free-field sides, two stages, then a pulse.
pub fn problem() -> Problem {
    let mut problem = bolted();
    let weak: Vec<_> =
        BANDIS.iter().map(|&(key, x)| (key, if key == "cohesion" { 5e3 } else { x })).collect();
    problem.interfaces = vec![between(&problem, [1, 0], "bandis", &weak)];
    problem.sides = [Side::FreeField; 2];
    problem
}

/// Stages need not come near to rest.
pub fn held_plan() -> Plan {
    let release = Release { cycles: 60, tolerance: [2e-2, 2e-1], ..Release::default() };
    let soon = |stage| PlannedStage { release, ..stage };
    Plan {
        stages: plan().stages.into_iter().map(soon).collect(),
        duration: 0.03,
        fields: Field::ALL.to_vec(),
        pairs: vec![PairMonitor { name: "pair".into(), point: [6.0, 5.0, 6.0], interface: 0 }],
        snapshots: Some(0.01),
        ..plan()
    }
}

fn simulation(folder: &Path, start: Start) -> Simulation {
    let Ready { model, assembly, phase } = Ready::new(problem());
    let results = match start {
        Start::Rest => ResultFolder::create(Some(folder), "held", true).unwrap(),
        _ => ResultFolder::open_existing(folder).unwrap(),
    };
    Simulation::new(&Built::of(&model, &assembly, &phase), &held_plan(), &results, start, Vec::new()).unwrap()
}

/// All files of a folder but checkpoints, which hold wall-clock chances.
pub fn files(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut files = BTreeMap::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(next) = folders.pop() {
        for entry in std::fs::read_dir(next).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.extend((path.file_name().unwrap() != "checkpoint").then_some(path));
            } else {
                files.insert(path.strip_prefix(folder).unwrap().to_owned(), std::fs::read(&path).unwrap());
            }
        }
    }
    files
}

fn assert_same(whole: &Path, other: &Path, how: &str) {
    let [whole, other] = [whole, other].map(files);
    let names: Vec<_> = whole.keys().collect();
    assert_eq!(names, other.keys().collect::<Vec<_>>(), "{how}");
    assert!(names.len() > 15, "{names:?}");
    for (name, bytes) in &whole {
        assert!(*bytes == other[name], "{how}: {}", name.display());
    }
}

/// Through all stages; `between` is called while one is stopped half-way, and after each.
pub fn through_stages(simulation: &mut Simulation, between: &mut dyn FnMut(&mut Simulation)) {
    while let Some(stage) = simulation.stage() {
        let mut cycles = 0;
        let mut watch = |_: &tremolite::simulation::Cycle| {
            cycles += 1;
            if cycles == 37 { Go::Stop } else { Go::On }
        };
        assert_eq!(simulation.relax(&mut watch).unwrap(), StageEnd::Stopped);
        between(simulation);
        assert_eq!(simulation.stage(), Some(stage));
        assert!(matches!(simulation.relax(&mut |_| Go::On).unwrap(), StageEnd::AtRest(_)));
        between(simulation);
    }
}

fn to_the_end(simulation: &mut Simulation, steps: u64, between: &mut dyn FnMut(&mut Simulation, u64)) {
    for calls in 0.. {
        match simulation.step(steps).unwrap() {
            Stepping::On => between(simulation, calls),
            Stepping::Done => return,
            failed @ (Stepping::Failed { .. } | Stepping::Astray { .. }) => panic!("{failed:?}"),
        }
    }
}

#[test]
fn however_it_is_driven_a_simulation_writes_the_bytes_of_a_run() {
    let parent = tempfile::tempdir().unwrap();
    let folder = |name: &str| parent.path().join(name);
    let mut control = Control { stop: &AtomicBool::new(false), progress: &mut |_| {} };
    let outcome = run(simulation(&folder("whole"), Start::Rest), &mut control).unwrap();
    assert_eq!(outcome.ending, Ending::Done);
    let slip = outcome.state.observers.len();
    assert!(slip > 10 && outcome.quiet.is_some_and(|drift| drift < 1e-12), "{:?}", outcome.quiet);

    // Seven steps at a time, with unplanned looks and checkpoints between them, from the stages on.
    let mut looked = simulation(&folder("looked"), Start::Rest);
    assert!(matches!(looked.step(7), Err(RunError::StageLeft(stage)) if stage == "start"));
    through_stages(&mut looked, &mut |held| {
        let (phase, look) = held.look().unwrap();
        assert!(look.snapshot.energy.iter().all(|energy| energy.held().is_finite()));
        assert_eq!(look.snapshot.displacement.len(), phase.master.len());
    });
    assert!(matches!(looked.relax(&mut |_| Go::On), Err(RunError::NoStageLeft)));
    to_the_end(&mut looked, 7, &mut |held, calls| {
        let look = held.look().unwrap().1;
        if calls % 50 == 0 {
            assert_eq!(held.checkpoint().unwrap(), None);
            assert_eq!(look.snapshot.time, held.time());
            let again = held.look().unwrap().1;
            assert_eq!(look.snapshot.balance, again.snapshot.balance);
            assert!(look.history == again.history && look.numbers == again.numbers);
        }
    });
    assert_eq!(looked.step(7).unwrap(), Stepping::Done, "nothing comes behind the end");
    let at_end = looked.look().unwrap().1.snapshot;
    let finished = looked.finish(Ending::Done, 0.0).unwrap();
    assert_eq!(at_end.balance, finished.balance);
    // As text, since what nothing is known of is not a number.
    assert!(format!("{:?}", finished.state) == format!("{:?}", outcome.state), "all that is remembered");
    assert_same(&folder("whole"), &folder("looked"), "seven at a time, looked at");

    // Two in one process, one after the other for some steps, on pools of their own.
    let mut pair = ["first", "second"].map(|name| simulation(&folder(name), Start::Rest));
    let pools = [1, 2].map(|n| rayon::ThreadPoolBuilder::new().num_threads(n).build().unwrap());
    pair.iter_mut().for_each(|one| through_stages(one, &mut |_| {}));
    let mut left = [true; 2];
    while left.contains(&true) {
        for (k, one) in pair.iter_mut().enumerate() {
            left[k] &= pools[k].install(|| one.step(3 + 8 * k as u64).unwrap()) == Stepping::On;
        }
    }
    for (mut one, name) in pair.into_iter().zip(["first", "second"]) {
        one.finish(Ending::Done, 0.0).unwrap();
        assert_same(&folder("whole"), &folder(name), name);
    }

    // Gone on beyond a checkpoint, back to it, dropped, and taken up again.
    let mut back = simulation(&folder("back"), Start::Rest);
    through_stages(&mut back, &mut |_| {});
    assert_eq!(back.step(333).unwrap(), Stepping::On);
    assert_eq!(back.checkpoint().unwrap(), None);
    let there = back.look().unwrap().1.snapshot;
    assert_eq!(back.step(444).unwrap(), Stepping::On);
    back.restore().unwrap();
    assert_eq!(back.taken(), 333);
    let again = back.look().unwrap().1.snapshot;
    assert!(there.velocity == again.velocity && there.balance == again.balance, "what was seen there");
    assert_eq!(back.step(100).unwrap(), Stepping::On);
    drop(back);
    let mut resumed = simulation(&folder("back"), Start::Resume);
    assert_eq!(resumed.taken(), 333);
    to_the_end(&mut resumed, 1000, &mut |_, _| {});
    resumed.finish(Ending::Done, 0.0).unwrap();
    assert_same(&folder("whole"), &folder("back"), "back to a checkpoint");
}

/// A checkpoint of a state in which energy has appeared would be resumed from for ever.
#[test]
fn a_state_that_the_guard_does_not_pass_is_in_no_checkpoint() {
    let parent = tempfile::tempdir().unwrap();
    let folder = parent.path().join("unstable");
    let Ready { model, assembly, phase } = Ready::new({
        let mut problem = problem();
        // Far beyond the stable step, which counts joints at their stiffest.
        problem.time_step.given = Some(2.5 * Ready::new(self::problem()).stable());
        problem
    });
    let results = ResultFolder::create(Some(&folder), "unstable", true).unwrap();
    let plan = held_plan();
    let mut held =
        Simulation::new(&Built::of(&model, &assembly, &phase), &plan, &results, Start::Rest, Vec::new())
            .unwrap();
    through_stages(&mut held, &mut |_| {});
    assert_eq!(held.step(1).unwrap(), Stepping::On);
    assert_eq!(held.checkpoint().unwrap(), None);
    let file = results.checkpoint().join("state.bin");
    let before = std::fs::read(&file).unwrap();
    let mut refused = 0;
    let failed = loop {
        match held.step(1).unwrap() {
            Stepping::On => match held.checkpoint().unwrap() {
                None => assert_eq!(refused, 0, "once energy has appeared it stays"),
                Some(_) => refused += 1,
            },
            other => break other,
        }
    };
    assert!(matches!(failed, Stepping::Failed { .. }), "{failed:?}");
    assert_eq!(held.step(5).unwrap(), failed, "it has ended");
    assert!(std::fs::read(&file).unwrap() != before, "those that pass are written");
    let mut resumed =
        Simulation::new(&Built::of(&model, &assembly, &phase), &plan, &results, Start::Resume, Vec::new())
            .unwrap();
    assert!(resumed.taken() < held.taken() && resumed.look().is_ok());
}

/// What is unstable at a few nodes grows while little was supplied; rows are too few to see that.
#[test]
fn the_guard_watches_whatever_rows_are_written() {
    let halts = [1, 10].map(|rows| {
        let Ready { model, assembly, phase } = Ready::new({
            let mut problem = problem();
            problem.time_step.given = Some(1.6 * Ready::new(self::problem()).stable());
            problem
        });
        let folder = tempfile::tempdir().unwrap();
        let results = ResultFolder::create(Some(folder.path()), "unstable", true).unwrap();
        let plan = Plan { histories: 0.03 / f64::from(rows), ..held_plan() };
        let mut held =
            Simulation::new(&Built::of(&model, &assembly, &phase), &plan, &results, Start::Rest, Vec::new())
                .unwrap();
        through_stages(&mut held, &mut |_| {});
        match held.step(u64::MAX).unwrap() {
            Stepping::Failed { halt, .. } => {
                assert!(halt.found > halt.supplied && halt.found.is_finite(), "{halt:?}");
                let table = Table::read(&results.energy()).unwrap();
                let error = table.column("error").unwrap();
                assert!(error.iter().all(|e| e.abs() < halt.found), "{error:?} {halt:?}");
                halt.time
            }
            ended => panic!("{ended:?}"),
        }
    });
    assert!(halts.iter().all(|time| *time < 0.02), "long before the end, where the one row is: {halts:?}");
}
