//! Ground that is dug into, with all that cracks, slides, yields and gets wet, on several ranks: at once, stopped and gone on with by others.

use crate::bolts_bits;
use crate::contact::{BANDIS, between};
use crate::damage::concrete;
use crate::ranks::{ALL, Case, SOME, files, how, same, shaken, through};
use crate::ready::Ready;
use std::sync::Arc;
use tremolite::plan::{BoltMonitor, PairMonitor, Plan};
use tremolite::simulation::{Cycle, Go, StageEnd, Start, Stepping};
use tremolite::{Problem, Ranks, Side, Stage};
use tremolite_laws::Isa;
use tremolite_results::ResultFolder;

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
