//! Several ranks write the bytes of one process: threads that exchange messages, of which each knows nothing but what it has.

use crate::block::pulse;
use crate::ready::Ready;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use tremolite::engine::Release;
use tremolite::observers::OwnObservers;
use tremolite::plan::{Monitor, Plan};
use tremolite::quantities::Field;
use tremolite::ranks::Took;
use tremolite::simulation::{Built, Ending, Go, Simulation, StageEnd, Start, Stepping};
use tremolite::stages::PlannedStage;
use tremolite::{Division, Incident, Loopback, Problem, Ranks};
use tremolite_mesh::locate::Locator;
use tremolite_results::{PageWish, ResultFolder};

/// Stages that need not come near to rest, and a short pulse.
pub fn plan(problem: &Problem, stages: &[&str], duration: f64) -> Plan {
    let locator = Locator::new(&problem.mesh, None);
    let release = Release { cycles: 20, tolerance: [2e-2, 2e-1], most: 3000, ..Release::default() };
    let middle = |share: [f64; 3]| {
        let of =
            |i: usize, f: fn(f64, f64) -> f64, x: f64| problem.mesh.nodes.iter().map(|n| n[i]).fold(x, f);
        [0, 1, 2].map(|i| {
            let [low, high] = [of(i, f64::min, f64::INFINITY), of(i, f64::max, f64::NEG_INFINITY)];
            low + share[i] * (high - low)
        })
    };
    let monitor = |(name, share): (&str, [f64; 3])| {
        let point = middle(share);
        Some(Monitor { name: name.into(), point, location: locator.locate(point, 1e-6)? })
    };
    let places = [("low", [0.1, 0.2, 0.1]), ("high", [0.9, 0.7, 0.95]), ("side", [0.97, 0.4, 0.6])];
    Plan {
        page: PageWish::default(),
        title: "ranks".into(),
        stages: stages.iter().map(|&name| PlannedStage { release, ..PlannedStage::new(name) }).collect(),
        duration,
        boundaries: Default::default(),
        target: None,
        recorded: None,
        waves: None,
        histories: 0.002,
        snapshots: Some(0.01),
        fields: Field::ALL.to_vec(),
        field_elements: 250_000,
        checkpoint: None,
        monitors: places.into_iter().filter_map(monitor).collect(),
        pairs: Vec::new(),
        bolts: Vec::new(),
        sections: Vec::new(),
        bars: 0,
        water: false,
        relatives: vec![[0, 1]],
    }
}

/// A model, what is done with it, and observers of a program's own.
pub struct Case {
    pub built: Built,
    pub plan: Plan,
    pub own: fn() -> OwnObservers,
}

impl Case {
    pub fn new(problem: Problem, stages: &[&str], duration: f64) -> Self {
        let plan = plan(&problem, stages, duration);
        Case::of(Ready::new(problem), plan)
    }

    pub fn of(Ready { model, assembly, phase }: Ready, plan: Plan) -> Self {
        Case { built: Built::of(&model, &assembly, &phase), plan, own: Vec::new }
    }

    pub fn simulation(&self, folder: &ResultFolder, start: Start, ranks: Option<Arc<Ranks>>) -> Simulation {
        Simulation::among(&self.built, &self.plan, folder, start, (self.own)(), ranks).unwrap()
    }

    /// In one process.
    pub fn alone(&self) -> Files {
        let folder = tempfile::tempdir().unwrap();
        let results = ResultFolder::create(Some(folder.path()), "ranks", true).unwrap();
        let state = through(self.simulation(&results, Start::Rest, None));
        files(folder.path(), state)
    }

    /// Of others, those that leave the same files and state.
    pub fn as_this<'a>(&self, others: &'a [(&'a str, Case)]) -> Vec<&'a str> {
        let own = self.alone();
        let same = |other: &Files| own.0 == other.0 && own.1 == other.1;
        others.iter().filter(|(_, other)| same(&other.alone())).map(|(name, _)| *name).collect()
    }

    /// On ranks that are threads, each with so many threads of its own.
    pub fn among(
        &self,
        how: How,
        drive: impl Fn(&ResultFolder, Option<Arc<Ranks>>) -> String + Sync,
    ) -> (Files, Vec<Took>) {
        let folder = tempfile::tempdir().unwrap();
        let results = ResultFolder::create(Some(folder.path()), "ranks", true).unwrap();
        let (state, took) = self.in_folder(how, &results, &drive);
        (files(folder.path(), state), took)
    }

    pub fn in_folder(
        &self,
        How { ranks, threads, scattered }: How,
        results: &ResultFolder,
        drive: &(impl Fn(&ResultFolder, Option<Arc<Ranks>>) -> String + Sync),
    ) -> (String, Vec<Took>) {
        let Built { model, assembly, .. } = &self.built;
        let division = match scattered {
            true => Division::scattered(model, assembly, ranks),
            false => Division::even(model, assembly, ranks),
        };
        let all = std::thread::scope(|scope| {
            let spawn = |exchange: Loopback| {
                let division = division.clone();
                scope.spawn(move || {
                    let ranks = Arc::new(Ranks::new(Arc::new(exchange), division).poisoned());
                    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
                    let state = pool.install(|| drive(results, Some(ranks.clone())));
                    (state, ranks.tally.took())
                })
            };
            let threads: Vec<_> = Loopback::ranks(ranks).into_iter().map(spawn).collect();
            threads.into_iter().map(|thread| thread.join().map_err(|_| "a rank is gone")).collect::<Vec<_>>()
        });
        let all: Vec<(String, Took)> = all.into_iter().map(Result::unwrap).collect();
        let took = all.iter().map(|(_, took)| *took).collect();
        (all.into_iter().next().unwrap().0, took)
    }

    /// The files of one process, from several.
    pub fn holds(&self, what: &str, ways: &[How]) -> Vec<Took> {
        let whole = self.alone();
        assert!(whole.0.len() > 8, "{what}: {:?}", whole.0.keys());
        let mut last = Vec::new();
        for &how in ways {
            let start = |folder: &ResultFolder, ranks| through(self.simulation(folder, Start::Rest, ranks));
            let (other, took) = self.among(how, start);
            same(&format!("{what}, {how:?}"), &whole, &other);
            last = took;
        }
        last
    }
}

/// Ranks, threads of each, and whether patches are dealt out one by one.
#[derive(Clone, Copy, Debug)]
pub struct How {
    ranks: u32,
    threads: usize,
    scattered: bool,
}

pub const fn how(ranks: u32, threads: usize, scattered: bool) -> How {
    How { ranks, threads, scattered }
}

/// All that the program promises, and three that stand for it.
pub const ALL: [How; 16] = {
    let mut all = [how(1, 1, false); 16];
    let mut k = 0;
    while k < 16 {
        all[k] = how([1, 2, 3, 7][k / 4], 1 + k % 2, k / 2 % 2 == 1);
        k += 1;
    }
    all
};
pub const SOME: [How; 3] = [how(2, 2, false), how(3, 1, true), how(7, 1, false)];

/// What a run leaves: its files, and the state at its end as text, since what nothing is known of is not a number.
pub struct Files(pub BTreeMap<PathBuf, Vec<u8>>, pub String);

/// All files; of checkpoints what the shaking begins with alone, since the others are written when the clock says so.
pub fn files(folder: &Path, state: String) -> Files {
    let mut files = crate::held::files(folder);
    let hand_over = Path::new("checkpoint/hand-over.bin");
    if let Ok(bytes) = std::fs::read(folder.join(hand_over)) {
        files.insert(hand_over.to_owned(), bytes);
    }
    Files(files, state)
}

pub fn same(what: &str, whole: &Files, other: &Files) {
    assert_eq!(whole.0.keys().collect::<Vec<_>>(), other.0.keys().collect::<Vec<_>>(), "{what}");
    for (name, bytes) in &whole.0 {
        assert!(*bytes == other.0[name], "{what}: {}", name.display());
    }
    assert!(whole.1 == other.1, "{what}: the state at the end");
}

/// To the end of a plan; the state there as text.
pub fn through(mut simulation: Simulation) -> String {
    while simulation.stage().is_some() {
        assert!(matches!(simulation.relax(&mut |_| Go::On).unwrap(), StageEnd::AtRest(_)));
    }
    assert_eq!(simulation.step(u64::MAX).unwrap(), Stepping::Done);
    format!("{:?}", simulation.finish(Ending::Done, 0.0).unwrap().state)
}

/// A pulse at once.
pub fn shaken(mut problem: Problem) -> Problem {
    problem.incident = Some(Incident { motion: pulse(), factor: 2.0 });
    problem.patch_elements = Some(24);
    problem
}
