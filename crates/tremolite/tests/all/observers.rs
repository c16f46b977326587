//! Observers: they see what they want and nothing else, of stages and shaking in one stream, and what they remember outlives a stop.

use crate::block::block;
use crate::bolts_bits;
use crate::contact::{BANDIS, between};
use crate::damage::{concrete, hall_of};
use crate::held::files;
use crate::ready::Ready;
use std::collections::BTreeMap;
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};
use tremolite::engine::Release;
use tremolite::observers::{
    CycleMade, Event, Observer, OwnObservers, RunTable, Schedule, Setting, StageSeen, Wants, Which, observers,
};
use tremolite::plan::{BoltMonitor, Monitor, PairMonitor, Plan};
use tremolite::quantities::Field;
use tremolite::simulation::{Built, Ending, Go, Simulation, StageEnd, Start, Stepping};
use tremolite::stages::PlannedStage;
use tremolite::state::Memory;
use tremolite::{Base, Incident, Interface, Problem, RunError, Side};
use tremolite_laws::Isa;
use tremolite_mesh::locate::Locator;
use tremolite_motion::{Motion, Sample, ricker_velocity};
use tremolite_results::{Column, PageWish, ResultFolder};

/// Stages need not come near to rest.
fn plan(problem: &Problem, stages: &[&str], monitors: &[(&str, [f64; 3])]) -> Plan {
    let locator = Locator::new(&problem.mesh, None);
    let release = Release { cycles: 20, tolerance: [2e-2, 2e-1], ..Release::default() };
    let monitor = |&(name, point): &(&str, [f64; 3])| Monitor {
        name: str::to_owned(name),
        point,
        location: locator.locate(point, 1e-6).unwrap(),
    };
    Plan {
        page: PageWish::default(),
        boundaries: Default::default(),
        target: None,
        title: "observed".into(),
        stages: stages.iter().map(|&name| PlannedStage { release, ..PlannedStage::new(name) }).collect(),
        duration: 0.03,
        recorded: None,
        waves: None,
        histories: 0.002,
        snapshots: Some(0.02),
        fields: Field::ALL.to_vec(),
        field_elements: 250_000,
        checkpoint: None,
        monitors: monitors.iter().map(monitor).collect(),
        pairs: Vec::new(),
        bolts: Vec::new(),
        bars: 0,
        water: false,
        relatives: Vec::new(),
        sections: Vec::new(),
    }
}

/// A pulse of 60 Hz that comes at once.
fn early() -> Motion {
    let v = ricker_velocity(60.0, 0.012, 0.1);
    let all = |x: f64| [x, 0.5 * x, -0.7 * x];
    Motion::sampled(5e-4, 0.1, |t| {
        let s = v(t);
        Sample { a: all(s.a), v: all(s.v), u: all(s.u) }
    })
    .unwrap()
}

fn weak(problem: &Problem) -> Interface {
    let law: Vec<_> = BANDIS.iter().map(|&(key, x)| (key, if key == "cohesion" { 1e3 } else { x })).collect();
    between(problem, [1, 0], "bandis", &law)
}

/// Two bodies that slide on each other.
fn joint() -> (Problem, Plan) {
    let mut problem = block([4, 4, 5]);
    problem.interfaces = vec![weak(&problem)];
    problem.base = Base::Viscous;
    problem.incident = Some(Incident { motion: early(), factor: 2.0 });
    let plan = plan(&problem, &[], &[]);
    (problem, plan)
}

/// Ground with a layer that cracks and a joint that slides, under initial stress, a pit that is dug, anchors and bars, and a free field.
fn pit() -> (Problem, Plan) {
    let mut problem = bolts_bits::bolted(Isa::best());
    problem.bodies[1].material = concrete(5e3, "effective");
    problem.interfaces = vec![weak(&problem)];
    problem.sides = [Side::FreeField; 2];
    problem.incident = Some(Incident { motion: early(), factor: 2.0 });
    problem.initial = vec![[-1e5, -1e5, -2e5, 0.0, 0.0, 3e5]; problem.mesh.elements.len()];
    problem.mesh.points.insert("floor".into(), [6.0, 5.0, 10.0]);
    let plan =
        plan(&problem, &["start", "bolts", "pit"], &[("floor", [6.3, 5.1, 11.0]), ("deep", [2.0, 3.0, 3.1])]);
    let bolts = vec![BoltMonitor { name: "anchor".into(), point: [3.0, 3.0, 10.0], set: 0 }];
    let pairs = vec![PairMonitor { name: "pair".into(), point: [6.0, 5.0, 6.0], interface: 0 }];
    (problem, Plan { bolts, pairs, relatives: vec![[0, 1]], ..plan })
}

/// A hall whose lining cracks.
fn hall() -> (Problem, Plan) {
    let mut problem = hall_of(0.02e6, "effective");
    problem.sides = [Side::FreeField; 2];
    let plan = plan(&problem, &[], &[("crown", [8.0, 1.5, 9.4])]);
    (problem, Plan { duration: 0.1, histories: 0.01, snapshots: Some(0.05), ..plan })
}

fn through(mut simulation: Simulation) -> Memory {
    while simulation.stage().is_some() {
        assert!(matches!(simulation.relax(&mut |_| Go::On).unwrap(), StageEnd::AtRest(_)));
    }
    assert_eq!(simulation.step(u64::MAX).unwrap(), Stepping::Done);
    simulation.finish(Ending::Done, 0.0).unwrap().state.observers
}

/// Files and memory that a run leaves.
type Left = (BTreeMap<PathBuf, Vec<u8>>, String);

fn run(ready: &Ready, plan: &Plan, observers: OwnObservers, poisoned: bool) -> Left {
    let folder = tempfile::tempdir().unwrap();
    let results = ResultFolder::create(Some(folder.path()), "observed", true).unwrap();
    let Ready { model, assembly, phase } = ready;
    let simulation =
        Simulation::new(&Built::of(model, assembly, phase), plan, &results, Start::Rest, Vec::new()).unwrap();
    let simulation = simulation.observed_by(observers);
    let memory = through(if poisoned { simulation.poisoned() } else { simulation });
    (files(folder.path()), format!("{memory:?}"))
}

/// An observer that wants something else.
struct Changed<'c> {
    observer: Box<dyn Observer>,
    change: &'c (dyn Fn(Wants) -> Wants + Send + Sync),
}

impl Observer for Changed<'_> {
    fn wants(&self) -> Wants {
        (self.change)(self.observer.wants())
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        self.observer.told(event, memory)
    }
}

/// A list of observers of which one wants something else.
fn changed(
    mut makers: OwnObservers,
    which: usize,
    change: impl Fn(Wants) -> Wants + Send + Sync + 'static,
) -> OwnObservers {
    let make = makers[which].clone();
    let change: &'static _ = Box::leak(Box::new(change));
    makers[which] = Arc::new(move |setting: &Setting| {
        let made = make(setting)?;
        Ok(made.map(|observer| Box::new(Changed { observer, change }) as Box<dyn Observer>))
    });
    makers
}

/// Kinds of things that are wanted, and whether one of them is left out at either end of the list, or else all of the kind.
type Kind = (&'static str, fn(&mut Wants) -> &mut Which, bool);
const KINDS: [Kind; 5] = [
    ("nodes", |wants| &mut wants.nodes, true),
    ("elements", |wants| &mut wants.elements, false),
    ("histories", |wants| &mut wants.histories, false),
    ("members", |wants| &mut wants.members, false),
    ("nodes of steps", |wants| &mut wants.steps, true),
];

/// How many of each kind an observer of a list wants at most in any stage or the shaking.
fn wanted(ready: &Ready, plan: &Plan) -> Vec<[usize; 5]> {
    let most = Arc::new(Mutex::new(vec![[0; 5]; observers().len()]));
    let recorded = (0..observers().len()).fold(observers(), |makers, which| {
        let most = most.clone();
        changed(makers, which, move |mut wants| {
            for ((_, of, _), most) in KINDS.iter().zip(&mut most.lock().unwrap()[which]) {
                *most = match of(&mut wants) {
                    Which::Nothing => *most,
                    Which::Some(all) => all.len().max(*most),
                    Which::All => usize::MAX,
                };
            }
            wants
        })
    });
    run(ready, plan, recorded, false);
    let most = most.lock().unwrap();
    most.clone()
}

#[test]
fn what_observers_want_is_all_that_they_see_and_none_does_without_what_it_wants() {
    // What was left out, and whether any run showed it.
    let mut tried: BTreeMap<(usize, &str, bool), bool> = BTreeMap::new();
    let mut reads = false;
    for (what, (problem, plan)) in [("hall", hall()), ("joint", joint()), ("pit", pit())] {
        let ready = Ready::new(problem);
        let whole = run(&ready, &plan, observers(), false);
        let poisoned = run(&ready, &plan, observers(), true);
        for (file, bytes) in &whole.0 {
            assert!(*bytes == poisoned.0[file], "{what}: {} shows what nobody named", file.display());
        }
        assert!(whole.1 == poisoned.1, "{what}: something is remembered that nobody named");
        for (which, counts) in wanted(&ready, &plan).into_iter().enumerate() {
            let unread = |wants| Wants { reads_kept: false, ..wants };
            // Fields are among those who see all.
            if !reads && counts[..2] == [usize::MAX; 2] {
                reads = run(&ready, &plan, changed(observers(), which, unread), true) != whole;
            }
            for ((kind, of, one), count) in KINDS.into_iter().zip(counts) {
                let ends: &[bool] = match count {
                    0 => &[],
                    usize::MAX => &[true],
                    _ if one => &[true, false],
                    _ => &[true],
                };
                for &first in ends {
                    let shown = tried.entry((which, kind, first)).or_default();
                    if *shown {
                        continue;
                    }
                    let less = move |mut wants: Wants| {
                        match of(&mut wants) {
                            Which::Some(all) if one => {
                                let end = if first { 0 } else { all.len().saturating_sub(1) };
                                all.drain(end..(end + 1).min(all.len()));
                            }
                            all => *all = Which::Nothing,
                        }
                        wants
                    };
                    let makers = changed(observers(), which, less);
                    let left = catch_unwind(AssertUnwindSafe(|| run(&ready, &plan, makers, true)));
                    *shown = !left.is_ok_and(|left| left == whole);
                }
            }
        }
    }
    assert!(reads, "who reads what others keep does without saying so");
    let without: Vec<_> = tried.iter().filter(|(_, shown)| !**shown).map(|(what, _)| what).collect();
    assert!(without.is_empty(), "these do without what they want: {without:?}");
    assert!(tried.len() > 30, "{}", tried.len());
}

/// Counts what it is told, adds up the motion of a node in cycles, stages, steps and looks, and writes the looks.
struct Counts {
    schedule: Schedule,
    node: u32,
    table: RunTable,
}

const COUNTS: &str = "counts";

impl Counts {
    fn new(setting: &Setting) -> Result<Self, RunError> {
        let path = setting.folder.root().join("counts.csv");
        let columns = [Column::new("time", "s"), Column::new("way", "m")];
        let table = RunTable::new(&path, &columns, setting.memory)?;
        Ok(Counts { schedule: setting.rows(), node: 40, table })
    }
}

impl Observer for Counts {
    fn wants(&self) -> Wants {
        let node = Which::Some(vec![self.node]);
        Wants { cycles: Some(7), steps: node.clone(), nodes: node, ..Wants::looks(self.schedule) }
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        let node = self.node as usize;
        let kept = memory.entry(COUNTS.into()).or_insert_with(|| vec![0.0; 8]);
        match event {
            // A stage that goes on after a stop begins again.
            Event::StageBegins(stage) => kept[1] = *stage as f64,
            Event::Cycle(CycleMade { rest, .. }) => kept[2] += rest.ratio,
            Event::StageEnds(StageSeen { stage, at_rest, u, view, .. }) => {
                assert!(*at_rest && kept[1] == *stage as f64);
                kept[3] += u[node].0[2] + view.snapshot.displacement[node].0[2];
            }
            Event::StagesTaken => unreachable!("no other run"),
            Event::Look(view) => {
                kept[4] += 1.0;
                let row = [view.snapshot.time, view.snapshot.displacement[node].0[0]];
                self.table.write(&row, memory)?;
            }
            Event::Glance(_) => unreachable!("not wished"),
            Event::Step(step) => kept[5] += step.du[node].0[0].abs(),
            Event::End { time } => kept[6] = *time,
        }
        Ok(())
    }
}

#[test]
fn an_observer_from_outside_sees_stages_and_shaking_and_its_memory_outlives_stops() {
    let (problem, plan) = pit();
    let Ready { model, assembly, phase } = Ready::new(problem);
    let held = |folder: &Path, start| {
        let results = match start {
            Start::Rest => ResultFolder::create(Some(folder), "observed", true).unwrap(),
            _ => ResultFolder::open_existing(folder).unwrap(),
        };
        let own: OwnObservers = vec![Arc::new(|setting: &Setting| {
            Ok(Some(Box::new(Counts::new(setting)?) as Box<dyn Observer>))
        })];
        Simulation::new(&Built::of(&model, &assembly, &phase), &plan, &results, start, own)
            .unwrap()
            .poisoned()
    };
    let [whole, parts] = [0; 2].map(|_| tempfile::tempdir().unwrap());
    let memory = through(held(whole.path(), Start::Rest));
    let kept = memory[COUNTS].clone();
    assert!(kept[2..].iter().take(5).all(|x| x.is_finite() && *x != 0.0), "{kept:?}");
    assert!(kept[1] == 2.0 && kept[4] == 16.0 && (kept[6] - 0.03).abs() < 1e-9, "{kept:?}");

    // Stopped within a stage, between two of them, and in the shaking.
    let mut first = held(parts.path(), Start::Rest);
    let mut cycles = 0;
    let stop = |cycles: &mut u64| {
        *cycles += 1;
        if *cycles == 45 { Go::Stop } else { Go::On }
    };
    assert_eq!(first.relax(&mut |_| stop(&mut cycles)).unwrap(), StageEnd::Stopped);
    drop(first);
    let mut second = held(parts.path(), Start::Resume);
    assert!(matches!(second.relax(&mut |_| Go::On).unwrap(), StageEnd::AtRest(_)));
    assert_eq!(second.checkpoint().unwrap(), None);
    drop(second);
    let mut third = held(parts.path(), Start::Resume);
    while third.stage().is_some() {
        third.relax(&mut |_| Go::On).unwrap();
    }
    assert_eq!(third.step(100).unwrap(), Stepping::On);
    assert_eq!(third.checkpoint().unwrap(), None);
    drop(third);
    assert_eq!(through(held(parts.path(), Start::Resume))[COUNTS], kept);
    let [whole, parts] = [whole, parts].map(|folder| files(folder.path()));
    assert!(whole.len() > 15 && whole.contains_key(Path::new("counts.csv")));
    for (file, bytes) in &whole {
        assert!(*bytes == parts[file], "{}", file.display());
    }
}

#[test]
fn a_table_that_was_changed_since_its_checkpoint_is_named_and_nothing_goes_on_with_it() {
    let (problem, plan) = pit();
    let Ready { model, assembly, phase } = Ready::new(problem);
    let built = Built::of(&model, &assembly, &phase);
    let held = |folder: &Path, start| {
        let results = match start {
            Start::Rest => ResultFolder::create(Some(folder), "observed", true).unwrap(),
            _ => ResultFolder::open_existing(folder).unwrap(),
        };
        let own: OwnObservers = vec![Arc::new(|setting: &Setting| {
            Ok(Some(Box::new(Counts::new(setting)?) as Box<dyn Observer>))
        })];
        Simulation::new(&built, &plan, &results, start, own)
    };
    let [whole, parts] = [0; 2].map(|_| tempfile::tempdir().unwrap());
    through(held(whole.path(), Start::Rest).unwrap());

    let mut first = held(parts.path(), Start::Rest).unwrap();
    while first.stage().is_some() {
        first.relax(&mut |_| Go::On).unwrap();
    }
    assert_eq!(first.step(100).unwrap(), Stepping::On);
    assert_eq!(first.checkpoint().unwrap(), None);
    assert_eq!(first.step(50).unwrap(), Stepping::On);
    drop(first);
    let tables = ["monitors", "energy", "damage", "interfaces", "free_field", "bolts", "counts"];
    for table in tables {
        let path = parts.path().join(format!("{table}.csv"));
        let sound = fs::read(&path).unwrap();
        // A digit of the first row.
        let row = sound.iter().position(|b| *b == b'\n').unwrap();
        let digit = row + sound[row..].iter().position(u8::is_ascii_digit).unwrap();
        let mut changed = sound.clone();
        changed[digit] ^= 1;
        fs::write(&path, &changed).unwrap();
        let told = held(parts.path(), Start::Resume).map(drop).unwrap_err().to_string();
        assert!(told.contains(&format!("{table}.csv: changed since the checkpoint")), "{told}");
        assert_eq!(fs::read(&path).unwrap(), changed, "{table}");
        fs::write(&path, &sound).unwrap();
    }
    // What the state holds is written again; and what came later is no matter.
    for table in ["stages.csv", "relaxation.csv", "motion.csv", "monitors.columns.json", "bolts.csv"] {
        assert!(parts.path().join(table).exists(), "{table}");
    }
    fs::write(parts.path().join("stages.csv"), "stage,name\n0,other\n").unwrap();
    fs::write(parts.path().join("monitors.columns.json"), "[]").unwrap();
    ["relaxation.csv", "motion.csv"]
        .iter()
        .for_each(|table| fs::remove_file(parts.path().join(table)).unwrap());
    let path = parts.path().join("monitors.csv");
    let later = fs::read(&path).unwrap();
    fs::write(&path, [&later[..], b"9,9"].concat()).unwrap();
    through(held(parts.path(), Start::Resume).unwrap());
    let [whole, parts] = [whole, parts].map(|folder| files(folder.path()));
    for (file, bytes) in &whole {
        assert!(*bytes == parts[file], "{}", file.display());
    }
}

/// Follows every step, and fails at one.
struct Stumbles {
    at: u64,
    made: u64,
}

impl Observer for Stumbles {
    fn wants(&self) -> Wants {
        Wants { steps: Which::some([0]), ..Wants::default() }
    }

    fn told(&mut self, event: &Event, _: &mut Memory) -> Result<(), RunError> {
        self.made += u64::from(matches!(event, Event::Step(_)));
        match self.made == self.at {
            true => Err(RunError::Io { path: "table.csv".into(), source: std::io::Error::other("no room") }),
            false => Ok(()),
        }
    }
}

#[test]
fn where_an_observer_of_steps_fails_nothing_goes_on_but_from_a_checkpoint() {
    let (problem, plan) = joint();
    let Ready { model, assembly, phase } = Ready::new(problem);
    let folder = tempfile::tempdir().unwrap();
    let results = ResultFolder::create(Some(folder.path()), "observed", true).unwrap();
    let fails = Arc::new(|_: &Setting| Ok(Some(Box::new(Stumbles { at: 30, made: 0 }) as Box<dyn Observer>)));
    let mut held =
        Simulation::new(&Built::of(&model, &assembly, &phase), &plan, &results, Start::Rest, vec![fails])
            .unwrap();
    assert_eq!(held.step(20).unwrap(), Stepping::On);
    assert_eq!(held.checkpoint().unwrap(), None);
    assert!(matches!(held.step(20), Err(RunError::Io { .. })));
    assert!(matches!(held.step(1), Err(RunError::Spoiled(30))));
    assert!(matches!(held.checkpoint(), Err(RunError::Spoiled(30))));
    held.restore().unwrap();
    assert_eq!(held.step(5).unwrap(), Stepping::On);
    assert_eq!(held.taken(), 25);
}

/// Fails at a step, as where a disk is full.
struct Full(u64);

impl Observer for Full {
    fn wants(&self) -> Wants {
        Wants::looks(Schedule { every: self.0, last: None })
    }

    fn told(&mut self, event: &Event, _: &mut Memory) -> Result<(), RunError> {
        match event {
            Event::Look(view) if view.snapshot.step == self.0 => {
                Err(RunError::Io { path: "table.csv".into(), source: std::io::Error::other("no room") })
            }
            _ => Ok(()),
        }
    }
}

#[test]
fn where_an_observer_fails_nothing_goes_on_but_from_a_checkpoint() {
    let (problem, plan) = joint();
    let Ready { model, assembly, phase } = Ready::new(problem);
    let folder = tempfile::tempdir().unwrap();
    let results = ResultFolder::create(Some(folder.path()), "observed", true).unwrap();
    let fails = Arc::new(|_: &Setting| Ok(Some(Box::new(Full(30)) as Box<dyn Observer>)));
    let mut held =
        Simulation::new(&Built::of(&model, &assembly, &phase), &plan, &results, Start::Rest, vec![fails])
            .unwrap();
    assert_eq!(held.step(20).unwrap(), Stepping::On);
    assert_eq!(held.checkpoint().unwrap(), None);
    assert!(matches!(held.step(20), Err(RunError::Io { .. })));
    assert!(matches!(held.step(20), Err(RunError::Spoiled(30))));
    assert!(matches!(held.checkpoint(), Err(RunError::Spoiled(30))));
    held.restore().unwrap();
    assert_eq!(held.step(5).unwrap(), Stepping::On);
    assert_eq!(held.taken(), 25);
}
