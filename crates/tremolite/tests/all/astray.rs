//! Runs that end although their energy balances: a node that runs away, a joint that closes beyond its law; the same on several ranks.

use crate::block::block;
use crate::contact::between;
use crate::ranks::{Case, files, how, same};
use crate::runs::go;
use std::sync::{Arc, Mutex};
use tremolite::parts::loads::Load;
use tremolite::simulation::{Ending, Simulation, Start, Stepping};
use tremolite::{Base, Problem};
use tremolite_results::{Pvd, ResultFolder, Table};

/// A pressure \[Pa\] on the top of the block, 14 m up, that comes within 20 ms; upwards where it is negative. A little of it is there from the
/// beginning: the guard of energies takes what comes from nothing for noise.
fn pressed(mut problem: Problem, pressure: f64) -> Problem {
    let nodes = &problem.mesh.nodes;
    let top: Vec<u32> =
        (0..nodes.len() as u32).filter(|&n| (nodes[n as usize][2] - 14.0).abs() < 1e-6).collect();
    let each = -pressure * 120.0 / top.len() as f64;
    problem.loads.push(Load {
        forces: top.into_iter().map(|n| (n, [0.0, 0.0, each])).collect(),
        factor: Arc::new(|time| (0.05 + time / 0.02).min(1.0)),
    });
    problem
}

/// Why a run of this problem was ended, with what it left sound until then.
fn ended(problem: Problem) -> String {
    let folder = tempfile::tempdir().unwrap();
    let outcome = go(problem, folder.path(), 2, false, None);
    let Ending::Astray { why } = &outcome.ending else {
        panic!("it must be ended, not {:?}", outcome.ending)
    };
    assert!(outcome.taken < outcome.steps.total);
    let table = Table::read(&folder.path().join("monitors.csv")).unwrap();
    assert!(table.rows() >= 1 && !table.cut);
    let last = *table.column("time").unwrap().last().unwrap();
    assert!(last <= outcome.taken as f64 * outcome.dt && last > 0.0, "rows until then: {last}");
    assert!(!Pvd::read(&folder.path().join("fields.pvd")).unwrap().snapshots().is_empty());
    why.to_string()
}

/// A wave that the free base does not let in: the guard of energies leaves as much to noise as the load does at first.
fn carried_off() -> Problem {
    let mut problem = block([4, 4, 5]);
    problem.base = Base::Free;
    problem.incident.iter_mut().for_each(|incident| incident.factor = 1e3);
    pressed(problem, -300e6)
}

/// A joint on top of the slab that may close by so much \[m\].
fn closing(closure: f64) -> Problem {
    let mut problem = block([4, 4, 5]);
    problem.base = Base::Fixed;
    let numbers = [
        ("normal_stiffness", 20e9),
        ("max_closure", closure),
        ("cohesion", 0.2e6),
        ("friction_coefficient", 0.7),
        ("pressure_for_step", 10e6),
    ];
    problem.interfaces = vec![between(&problem, [1, 0], "bandis", &numbers)];
    pressed(problem, 40e6)
}

#[test]
fn what_moves_further_than_the_model_is_long_ends_the_run_and_is_named() {
    let why = ended(carried_off());
    assert!(
        why.starts_with("element ") && why.contains("further than the model is long, 1.400e1 m"),
        "{why}"
    );
}

#[test]
fn a_joint_that_closes_beyond_its_law_ends_the_run_and_its_pair_is_named() {
    // The curve goes straight from 12 MPa and comes to the largest closure at 28 MPa.
    let why = ended(closing(0.2e-3));
    assert!(
        why.starts_with("interface 'joint' at node ")
            && why.contains("beyond the largest closure of its law, 2.000e-4 m"),
        "{why}"
    );
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(
        go(closing(8e-3), folder.path(), 2, false, None).ending,
        Ending::Done,
        "one that may close by more goes on"
    );
}

/// Every rank is told the same, at the same time, and the first leaves the files and the state of one process.
#[test]
fn several_ranks_end_where_one_process_does_with_the_same_words() {
    for problem in [carried_off as fn() -> Problem, || closing(0.2e-3)] {
        let mut problem = problem();
        problem.patch_elements = Some(12);
        let case = Case::new(problem, &[], 0.12);
        let told = Mutex::new(Vec::new());
        let through = |mut simulation: Simulation| {
            let stepped = simulation.step(u64::MAX).unwrap();
            let Stepping::Astray { why } = stepped else { panic!("it must be ended, not {stepped:?}") };
            told.lock().unwrap().push((simulation.time(), why.to_string()));
            format!("{:?}", simulation.finish(Ending::Astray { why }, 0.0).unwrap().state)
        };
        let folder = tempfile::tempdir().unwrap();
        let results = ResultFolder::create(Some(folder.path()), "ranks", true).unwrap();
        let alone = files(folder.path(), through(case.simulation(&results, Start::Rest, None)));
        for how in [how(1, 2, false), how(2, 1, false), how(3, 1, true)] {
            let start = |folder: &ResultFolder, ranks| through(case.simulation(folder, Start::Rest, ranks));
            let (among, _) = case.among(how, start);
            same(&format!("{how:?}"), &alone, &among);
        }
        let told = told.into_inner().unwrap();
        assert!(told.len() == 1 + 1 + 2 + 3 && told.iter().all(|one| *one == told[0]), "{told:?}");
    }
}
