//! Several ranks write the bytes of one process: threads that exchange messages, of which each knows nothing but what it has.

use crate::block::{block, pulse};
use crate::bolts_bits;
use crate::contact::{BANDIS, between, jointed};
use crate::damage::{concrete, hall_of};
use crate::outside_part::on_springs;
use crate::poison::OneSided;
use crate::ready::Ready;
use crate::rims_cavern::cavern;
use crate::staged::stiffened;
use crate::waves_at_angles::two_waves;
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use tremolite::engine::Release;
use tremolite::observers::{Event, Observer, OwnObservers, Setting, Wants, Which};
use tremolite::plan::{BoltMonitor, Monitor, PairMonitor, Plan};
use tremolite::quantities::Field;
use tremolite::ranks::Took;
use tremolite::simulation::{Built, Cycle, Ending, Go, Simulation, StageEnd, Start, Stepping};
use tremolite::stages::PlannedStage;
use tremolite::state::Memory;
use tremolite::strength::JudgedBy;
use tremolite::{
    Base, Division, Incident, Life, Loopback, Member, Prescribed, Problem, Quadrature, Ranks, RunError, Side,
    Stage,
};
use tremolite_laws::Isa;
use tremolite_mesh::locate::Locator;
use tremolite_results::{PageWish, ResultFolder};
use tremolite_sections::{Code, Grade, Rule};

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
    own: fn() -> OwnObservers,
}

impl Case {
    fn new(problem: Problem, stages: &[&str], duration: f64) -> Self {
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
    fn among(
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
const ALL: [How; 16] = {
    let mut all = [how(1, 1, false); 16];
    let mut k = 0;
    while k < 16 {
        all[k] = how([1, 2, 3, 7][k / 4], 1 + k % 2, k / 2 % 2 == 1);
        k += 1;
    }
    all
};
const SOME: [How; 3] = [how(2, 2, false), how(3, 1, true), how(7, 1, false)];

/// What a run leaves: its files, and the state at its end as text, since what nothing is known of is not a number.
pub struct Files(pub BTreeMap<PathBuf, Vec<u8>>, String);

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
fn shaken(mut problem: Problem) -> Problem {
    problem.incident = Some(Incident { motion: pulse(), factor: 2.0 });
    problem.patch_elements = Some(24);
    problem
}

/// Ground under initial stress with a layer that cracks, a joint that slides, anchors with friction, bars that yield, a pit that is dug, and
/// a free field.
pub fn pit_problem() -> Problem {
    pit_of(bolts_bits::bolted(Isa::best()))
}

pub fn pit_of(bolted: Problem) -> Problem {
    let mut problem = shaken(bolted);
    problem.bodies[1].material = concrete(5e3, "effective");
    let law: Vec<_> = BANDIS.iter().map(|&(key, x)| (key, if key == "cohesion" { 1e3 } else { x })).collect();
    problem.interfaces = vec![between(&problem, [1, 0], "bandis", &law)];
    problem.sides = [Side::FreeField; 2];
    problem.initial = vec![[-1e5, -1e5, -2e5, 0.0, 0.0, 3e5]; problem.mesh.elements.len()];
    problem
}

fn pit() -> Case {
    pit_case(pit_problem())
}

pub fn pit_case(problem: Problem) -> Case {
    let mut case = Case::new(problem, &["start", "bolts", "pit"], 0.012);
    case.plan.bolts = vec![BoltMonitor { name: "anchor".into(), point: [3.0, 3.0, 10.0], set: 0 }];
    case.plan.pairs = vec![PairMonitor { name: "pair".into(), point: [6.0, 5.0, 6.0], interface: 0 }];
    case
}

/// The same with water that falls as the pit is dug: in pores of what does not crack, whose grains give way, and in the joint. Undrained it
/// cannot leave these pores in the shaking.
fn wet_pit(levels: bool, undrained: bool) -> Case {
    let dry = pit();
    let mut problem = pit_problem();
    problem.interfaces[0].water = Some(0.6);
    let spell = |from: u16, level: f64| {
        let p = |z: f64| 5e3 * (level - z).max(0.0);
        let centre = |e: usize| p(tremolite::hexahedra::centroid(&problem.mesh, e as u32)[2]);
        tremolite::water::Spell {
            from: Stage::Before(from),
            elements: (0..problem.mesh.elements.len()).map(centre).collect(),
            nodes: problem.mesh.nodes.iter().map(|x| p(x[2])).collect(),
        }
    };
    let mut biot = vec![0.7; problem.mesh.elements.len()];
    problem.bodies[1].elements.iter().for_each(|&e| biot[e as usize] = 0.0);
    let modulus = if undrained { vec![2e9; biot.len()] } else { Vec::new() };
    problem.water = tremolite::Water { biot, modulus, spells: vec![spell(0, 12.0), spell(2, 6.0)] };
    let ready = Ready::new(problem);
    let ready = if levels { ready.levelled(|[_, _, z]| (z / 3.0) as u8) } else { ready };
    Case::of(ready, Plan { water: true, ..dry.plan })
}

#[test]
fn water_in_pores_and_joints_gives_the_same_on_several_ranks_with_levels_or_without() {
    let [dry, wet, undrained] = [pit(), wet_pit(false, false), wet_pit(false, true)].map(|case| case.alone());
    assert!(dry.1 != wet.1, "water changes something");
    assert!(wet.1 != undrained.1, "so does it if it cannot leave");
    for (levels, undrained) in [(false, false), (false, true), (true, true)] {
        wet_pit(levels, undrained)
            .holds(&format!("wet pit, levels {levels}, undrained {undrained}"), &SOME[..2]);
    }
}

#[test]
fn a_run_with_water_goes_on_where_it_was_stopped_in_the_stage_that_changes_it() {
    let case = wet_pit(false, true);
    let whole = case.alone();
    let parent = tempfile::tempdir().unwrap();
    let results = ResultFolder::create(Some(&parent.path().join("parts")), "ranks", true).unwrap();
    let stop = |folder: &ResultFolder, ranks: Option<Arc<Ranks>>| {
        let mut simulation = case.simulation(folder, Start::Rest, ranks);
        for _ in 0..2 {
            assert!(matches!(simulation.relax(&mut |_| Go::On).unwrap(), StageEnd::AtRest(_)));
        }
        let mut stop = |cycle: &Cycle| if cycle.cycle > 10 { Go::Stop } else { Go::On };
        assert_eq!(simulation.relax(&mut stop).unwrap(), StageEnd::Stopped);
        String::new()
    };
    case.in_folder(how(2, 1, false), &results, &stop);
    let state = through(case.simulation(&results, Start::Resume, None));
    same("resumed with water", &whole, &files(results.root(), state));
}

#[test]
fn any_number_of_ranks_and_threads_writes_the_files_of_one_process() {
    pit().holds("pit", &ALL);
}

/// Machines of a cluster may differ in the instructions that they have.
#[test]
fn ranks_with_unlike_instruction_sets_write_the_files_of_one_process() {
    let cases = [Isa::best(), Isa::Scalar].map(|isa| pit_case(pit_of(bolts_bits::bolted(isa))));
    assert!(Isa::best() != Isa::Scalar || !cfg!(target_arch = "x86_64"), "there are two to compare");
    let whole = cases[0].alone();
    let drive = |folder: &ResultFolder, ranks: Option<Arc<Ranks>>| {
        let own = ranks.as_ref().map_or(0, |ranks| ranks.rank() as usize % 2);
        through(cases[own].simulation(folder, Start::Rest, ranks))
    };
    same("unlike instruction sets", &whole, &cases[0].among(how(3, 1, false), drive).0);
}

#[test]
fn all_sides_and_bases_give_the_same_on_several_ranks() {
    let springs = Base::ViscousSpring { normal: 1.33, tangential: 0.67, distance: Some(20.0) };
    for (k, side) in Side::EXAMPLES.into_iter().enumerate() {
        let base = [Base::Free, Base::Fixed, Base::Viscous, springs][(k + 2) % 4];
        for base in [base, springs] {
            let mut problem = shaken(block([4, 4, 5]));
            problem.base = base;
            problem.sides = [side, Side::EXAMPLES[(k + 1) % Side::EXAMPLES.len()]];
            problem.patch_elements = Some(8);
            problem.ties = vec![(3, 40)];
            // With ξ ≠ 0 products with the stiffness are exchanged besides.
            problem.rayleigh.stiffness = if k % 2 == 0 { 1e-5 } else { 0.0 };
            if matches!(base, Base::Free | Base::Fixed) {
                // With the wave that they do not let in the guard leaves as much to noise as such loads do at first.
                problem.loads = vec![tremolite::parts::loads::Load {
                    forces: vec![(7, [1e5, 2e5, -1e5]), (60, [2e5, 0.0, 1e5])],
                    factor: Arc::new(|t: f64| (300.0 * t).cos()),
                }];
            }
            // Ground at the corners is no column where it is held.
            if tremolite::Model::new(problem.clone()).is_err() {
                continue;
            }
            let [first, second, third] = SOME;
            let ways = if k % 2 == 0 { [first, second] } else { [third, second] };
            Case::new(problem, &[], 0.012).holds(&format!("{side:?} {base:?}"), &ways);
        }
    }
}

#[test]
fn waves_at_angles_give_the_same_on_several_ranks_with_levels_or_without() {
    for levels in [false, true] {
        let mut problem = shaken(block([6, 5, 10]));
        let (low, high) = problem.mesh.bounds();
        assert_eq!(low, [0.0; 3]);
        let field = two_waves(high, &problem.bodies[0], problem.top);
        problem.incident = None;
        problem.free_field = Some(Arc::new(field));
        problem.sides = [Side::FreeField; 2];
        problem.base = Base::ViscousSpring { normal: 1.33, tangential: 0.67, distance: Some(20.0) };
        let plan = plan(&problem, &[], 0.012);
        let ready = Ready::new(problem);
        let ready = if levels { ready.levelled(|[_, _, z]| (z / 3.0) as u8) } else { ready };
        Case::of(ready, plan).holds(&format!("waves at angles, {levels}"), &SOME[..2]);
    }
}

#[test]
fn materials_that_change_take_over_from_other_ranks() {
    for quadrature in [Quadrature::OnePoint, Quadrature::Full] {
        let mut problem = stiffened(quadrature, 0.17);
        problem.patch_elements = Some(8);
        problem.base = Base::Viscous;
        problem.incident = Some(Incident { motion: pulse(), factor: 2.0 });
        Case::new(problem, &["start", "stiffer", "loaded"], 0.012).holds("changed material", &SOME);
    }
}

#[test]
fn pairs_freed_at_rims_are_told_the_stress_beside_them_by_other_ranks() {
    let stages = ["start", "first", "second", "third", "fourth", "last"];
    let mut problem = cavern(false);
    problem.patch_elements = Some(16);
    Case::new(problem, &stages, 0.02).holds("cavern with a fault", &[how(3, 1, false), how(2, 2, true)]);
}

#[test]
fn levels_of_steps_exchange_what_their_step_moves() {
    let upwards = |[_, _, z]: [f64; 3]| (z / 3.0) as u8;
    let blobs = |[x, y, z]: [f64; 3]| {
        ((1.3 * x).sin() * (0.9 * y).cos() * 2.0 + (0.7 * z).sin() + 2.5).clamp(0.0, 3.0) as u8
    };
    let wishes: [fn([f64; 3]) -> u8; 2] = [upwards, blobs];
    for (k, wished) in wishes.into_iter().enumerate() {
        for side in [Side::FreeField, Side::Periodic] {
            let mut problem = shaken(block([6, 5, 14]));
            problem.sides = [side; 2];
            problem.rayleigh.mass = 3.0;
            let plan = plan(&problem, &[], 0.012);
            let ready = Ready::new(problem).levelled(wished);
            assert_eq!(ready.phase.beats.len(), 4 - usize::from(k > 1));
            Case::of(ready, plan).holds(&format!("levels {k}, {side:?}"), &SOME);
        }
    }
    let mut problem = shaken(jointed(Isa::best()));
    problem.patch_elements = Some(32);
    let plan = plan(&problem, &[], 0.01);
    Case::of(Ready::new(problem).levelled(upwards), plan).holds("levels through joints", &SOME[..2]);
}

/// Who judges sections glances at every step at linings, whose elements and bars are on several ranks.
#[test]
fn judged_sections_see_in_every_step_what_other_ranks_have() {
    let mut problem = shaken(hall_of(0.6e6, "effective"));
    problem.patch_elements = Some(4);
    let mut case = Case::new(problem, &[], 0.012);
    let elements = case.built.model.mesh.groups["hall.lining"].clone();
    let rule = Rule {
        code: Code::En,
        grade: Grade::of(Code::En, "C30/37").unwrap(),
        concrete_factor: 1.5,
        steel_factor: 1.15,
        compression_factor: 0.8,
        tension_factor: 0.8,
        resistance_factor: 1.0,
        tension: true,
    };
    let (code, grade) = ("en".into(), "C30/37".into());
    case.plan.sections = vec![JudgedBy { elements, code, grade, rule, dynamic: 1.0, bar_diameter: None }];
    assert!(case.alone().0.contains_key(Path::new("utilisation.csv")), "some sections are judged");
    case.holds("judged sections", &SOME);
}

/// Follows two nodes in every step, and remembers the sum of what it is told.
struct Follower(Vec<usize>);

impl Observer for Follower {
    fn wants(&self) -> Wants {
        Wants { steps: Which::some(self.0.iter().copied()), ..Wants::default() }
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        if let Event::Step(step) = event {
            let sums = memory.entry("follower".into()).or_insert_with(|| vec![0.0; 2]);
            for &node in &self.0 {
                sums[0] += step.u[node].0[0];
                sums[1] += step.du[node].0[2];
            }
        }
        Ok(())
    }
}

#[test]
fn parts_and_observers_of_a_programs_own_have_a_rank() {
    let mut problem = on_springs(1e8);
    problem.patch_elements = Some(24);
    problem.loads = vec![tremolite::parts::loads::Load {
        forces: vec![(7, [1e5, 2e5, -1e5])],
        factor: Arc::new(|t: f64| (300.0 * t).sin()),
    }];
    let mut case = Case::new(problem, &[], 0.02);
    case.own = || {
        let make = |setting: &Setting| {
            let last = setting.model.nodes.len() - 1;
            Ok(setting.shakes().then(|| Box::new(Follower(vec![3, last])) as Box<dyn Observer>))
        };
        vec![Arc::new(make)]
    };
    case.holds("springs of a program's own", &SOME);
}

#[test]
fn nodes_that_stages_move_tell_all_ranks_their_reaction() {
    let mut problem = block([4, 4, 5]);
    problem.patch_elements = Some(8);
    problem.bed = tremolite::Bed::NONE;
    problem.incident = None;
    let top = |z: f64| -> Vec<(u32, u8)> {
        let elements = (0u32..).zip(&problem.mesh.elements);
        let corners = |element: &tremolite_mesh::Element| -> u8 {
            let corners = element.nodes().iter().enumerate();
            let there = corners.filter(|(_, n)| (problem.mesh.nodes[**n as usize][2] - z).abs() < 1e-9);
            there.map(|(k, _)| 1 << k).sum()
        };
        elements.map(|(e, element)| (e, corners(element))).filter(|(_, corners)| *corners > 0).collect()
    };
    let mut moved = Vec::new();
    for (k, way) in (0u16..).zip([0.0, -1e-4, -2e-4]) {
        let life = Life { born: Stage::Before(k), gone: Some(Stage::Before(k + 1)) };
        let one = |name: &str, z: f64, to| Prescribed { name: name.into(), corners: top(z), to, life };
        moved.push(one("plate", 14.0, [Some(0.0), Some(0.0), Some(way)]));
        moved.push(one("floor", 0.0, [Some(0.0); 3]));
    }
    problem.prescribed = moved;
    problem.sides = [Side::Free; 2];
    Case::new(problem, &["start", "pressed", "more"], 0.0).holds("specimen", &SOME);
}

/// Stopped in a stage and in the shaking on some ranks, gone on with on others and in one process; and begun with another's rest.
#[test]
fn a_run_goes_on_with_other_ranks_and_takes_over_from_other_ranks() {
    let case = pit();
    let whole = case.alone();
    let parent = tempfile::tempdir().unwrap();
    let results = ResultFolder::create(Some(&parent.path().join("parts")), "ranks", true).unwrap();
    // Any rank may ask for a stop, and all do it together.
    let in_stage = |folder: &ResultFolder, ranks: Option<Arc<Ranks>>| {
        let last = ranks.as_ref().is_none_or(|ranks| ranks.rank() + 1 == ranks.division.ranks);
        let mut simulation = case.simulation(folder, Start::Rest, ranks);
        assert!(matches!(simulation.relax(&mut |_| Go::On).unwrap(), StageEnd::AtRest(_)));
        let mut stop = |cycle: &Cycle| if last && cycle.cycle > 10 { Go::Stop } else { Go::On };
        assert_eq!(simulation.relax(&mut stop).unwrap(), StageEnd::Stopped);
        String::new()
    };
    case.in_folder(how(2, 1, false), &results, &in_stage);
    let in_shaking = |folder: &ResultFolder, ranks: Option<Arc<Ranks>>| {
        let mut simulation = case.simulation(folder, Start::Resume, ranks);
        while simulation.stage().is_some() {
            simulation.relax(&mut |_| Go::On).unwrap();
        }
        assert_eq!(simulation.step(11).unwrap(), Stepping::On);
        assert_eq!(simulation.checkpoint().unwrap(), None);
        String::new()
    };
    case.in_folder(how(3, 1, true), &results, &in_shaking);
    let more = |folder: &ResultFolder, ranks| {
        let mut simulation = case.simulation(folder, Start::Resume, ranks);
        assert_eq!(simulation.taken(), 11);
        assert_eq!(simulation.step(5).unwrap(), Stepping::On);
        assert_eq!(simulation.checkpoint().unwrap(), None);
        simulation.step(3).unwrap();
        String::new()
    };
    case.in_folder(how(7, 1, false), &results, &more);
    let state = through(case.simulation(&results, Start::Resume, None));
    same("resumed", &whole, &files(results.root(), state));

    // What two ranks came to is the beginning of three.
    let from = ResultFolder::open_existing(results.root()).unwrap();
    let begin = |folder: &ResultFolder, ranks: Option<Arc<Ranks>>| {
        through(case.simulation(folder, Start::From(&from), ranks))
    };
    let folder = ResultFolder::create(Some(&parent.path().join("from")), "ranks", true).unwrap();
    let begun = begin(&folder, None);
    let begun = files(folder.root(), begun);
    same("begun with another's rest", &begun, &case.among(how(3, 2, false), begin).0);
}

/// Both ends of the block are on different ranks: it is so long that it is cut across.
#[test]
fn what_a_part_did_not_name_its_rank_does_not_have() {
    let far = |named: bool| {
        let mut problem = shaken(block([3, 3, 24]));
        problem.patch_elements = Some(8);
        problem.base = Base::Viscous;
        problem.parts = vec![Arc::new(move |_: &_, engine_node: &[u32]| {
            let [first, .., last] = engine_node else { panic!("a mesh has nodes") };
            let part = OneSided { nodes: [*first], other: *last, named };
            Member::new("one-sided", Box::new(part))
        })];
        Case::new(problem, &[], 0.006)
    };
    for named in [true, false] {
        let case = far(named);
        let whole = case.alone();
        let start = |folder: &ResultFolder, ranks| through(case.simulation(folder, Start::Rest, ranks));
        let other = catch_unwind(AssertUnwindSafe(|| case.among(how(3, 1, false), start).0));
        assert_eq!(other.is_ok_and(|other| other.1 == whole.1), named);
    }
}

/// The division's own counts are what is sent.
#[test]
fn what_is_exchanged_is_what_the_division_says() {
    let mut problem = shaken(block([6, 5, 14]));
    problem.sides = [Side::FreeField; 2];
    let case = Case::new(problem, &[], 0.012);
    let took = case.holds("counted", &[how(3, 1, false)]);
    let Built { model, assembly, phase, .. } = &case.built;
    let division = Division::even(model, assembly, 3);
    for (rank, took) in (0..).zip(took) {
        let own = phase.of_rank(model, assembly, &division, rank);
        let bytes = 8 * own.ours.as_ref().unwrap().halos[0].halo.words()[0] as u64;
        assert!(bytes > 0 && took.bytes == bytes * took.halos, "{rank}: {took:?}, {bytes}");
    }
    assert!(division.imbalance < 1.2, "{:?}", division.weights);
}

/// In each step of the finest level ranks have about as much to do, though the finest elements are all at one end.
#[test]
fn ranks_are_even_on_each_level_of_steps() {
    let mut problem = shaken(block([6, 5, 14]));
    problem.patch_elements = Some(8);
    let Ready { model, assembly, phase } = Ready::new(problem).levelled(|[_, _, z]| (z / 3.0) as u8);
    assert_eq!(phase.beats.len(), 4);
    for ranks in [2, 3, 4] {
        let division = Division::even(&model, &assembly, ranks);
        assert!(division.imbalance < 1.2, "{ranks} ranks: {}", division.imbalance);
        for beat in 0..phase.beats.len() {
            let elements = |rank: u32| {
                let own = phase.of_rank(&model, &assembly, &division, rank);
                let active = own.beats[beat].active.iter();
                active.map(|&m| assembly.members[m as usize].part.elements().0).sum::<usize>() as f64
            };
            let each: Vec<f64> = (0..ranks).map(elements).collect();
            let mean = each.iter().sum::<f64>() / f64::from(ranks);
            assert!(each.iter().all(|own| *own < 1.3 * mean), "{ranks} ranks, levels to {beat}: {each:?}");
        }
    }
}
