//! Runs as a whole: files, resuming, stopping.

use crate::block::block;
use crate::contact::jointed;
use crate::ready::Ready;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use tremolite::observers::Extremes;
use tremolite::parts::loads::Load;
use tremolite::plan::{Monitor, PairMonitor, Plan};
use tremolite::quantities::{Field, MONITOR, RELATIVE};
use tremolite::run::{Control, run};
use tremolite::simulation::{Built, Ending, Outcome, Simulation, Start};
use tremolite::{Base, Bed, Halt, Life, Line, Prescribed, Problem, Side, Stage, elastic};
use tremolite_laws::{Isa, Moduli};
use tremolite_mesh::locate::Locator;
use tremolite_results::{Pvd, ResultFolder, Table};

fn plan(problem: &Problem) -> Plan {
    let locator = Locator::new(&problem.mesh, None);
    let monitor = |name: &str, point| Monitor {
        name: name.into(),
        point,
        location: locator.locate(point, 1e-6).unwrap(),
    };
    Plan {
        page: tremolite_results::PageWish::default(),
        boundaries: Default::default(),
        target: None,
        title: "block".into(),
        stages: Vec::new(),
        duration: 0.12,
        recorded: None,
        waves: None,
        histories: 0.002,
        snapshots: Some(0.02),
        fields: Field::ALL.to_vec(),
        field_elements: 250_000,
        checkpoint: None,
        monitors: vec![monitor("top", [6.3, 5.1, 14.0]), monitor("slab", [6.0, 5.0, 7.0])],
        pairs: (0..problem.interfaces.len())
            .map(|interface| PairMonitor { name: "pair".into(), point: [6.0, 5.0, 6.0], interface })
            .collect(),
        bolts: Vec::new(),
        bars: 0,
        water: false,
        relatives: vec![[0, 1]],
        sections: Vec::new(),
    }
}

/// Runs on `threads` threads into `folder`; stops when `stop_at` of 1 is reached.
pub fn go(problem: Problem, folder: &Path, threads: usize, resume: bool, stop_at: Option<u64>) -> Outcome {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(|| {
        let plan = plan(&problem);
        let Ready { model, assembly, phase } = Ready::new(problem);
        let results = if resume {
            ResultFolder::open_existing(folder).unwrap()
        } else {
            ResultFolder::create(Some(folder), "block", true).unwrap()
        };
        let stop = AtomicBool::new(false);
        let mut tell = |p: tremolite::run::Progress| {
            if stop_at.is_some_and(|at| p.step >= at) {
                stop.store(true, Ordering::Relaxed);
            }
        };
        let mut control = Control { stop: &stop, progress: &mut tell };
        Simulation::new(
            &Built::of(&model, &assembly, &phase),
            &plan,
            &results,
            if resume { Start::Resume } else { Start::Rest },
            Vec::new(),
        )
        .and_then(|simulation| run(simulation, &mut control))
        .unwrap()
    })
}

/// What must not show where a run was stopped.
const FILES: [&str; 7] = [
    "monitors.csv",
    "energy.csv",
    "free_field.csv",
    "spectra.csv",
    "depth.csv",
    "fields.pvd",
    "fields/000006.vtu",
];

#[test]
fn a_stopped_run_resumes_to_the_same_bytes_with_other_threads() {
    let folder = tempfile::tempdir().unwrap();
    let (whole, parts) = (folder.path().join("whole"), folder.path().join("parts"));
    let problem = || {
        let mut problem = block([12, 12, 16]);
        problem.time_step.given = Some(2e-5);
        problem
    };
    let outcome = go(problem(), &whole, 1, false, None);
    assert_eq!(outcome.ending, Ending::Done);
    // The first progress is told after 0.2 s: some way into the run.
    let outcome = go(problem(), &parts, 2, false, Some(1));
    assert_eq!(outcome.ending, Ending::Stopped);
    assert!(outcome.taken > 0 && outcome.taken < outcome.steps.total, "stopped at {}", outcome.taken);
    let resumed = go(problem(), &parts, 3, true, None);
    assert_eq!(resumed.ending, Ending::Done);
    assert_eq!(resumed.taken_here + outcome.taken, resumed.steps.total);
    for file in FILES {
        let bytes = |folder: &Path| std::fs::read(folder.join(file)).unwrap();
        assert!(bytes(&whole) == bytes(&parts), "{file}");
    }
    // The checkpoint of another model is refused, whatever it differs in.
    type Change = (&'static str, fn(&mut Problem));
    let changes: [Change; 10] = [
        ("damping", |p| p.rayleigh.mass = 0.5),
        ("a law's parameter", |p| p.bodies[1].material = elastic(Moduli::from_young_poisson(5e9, 0.18))),
        ("viscosity", |p| p.bodies[1].viscosity = 0.01),
        ("sides", |p| p.sides[1] = Side::Viscous),
        ("springs", |p| p.base = Base::ViscousSpring { normal: 1.3, tangential: 0.67, distance: Some(20.0) }),
        ("ties", |p| p.ties.push((0, 1))),
        ("the record's step", |p| p.incident.as_mut().unwrap().motion.dt *= 1.3),
        ("what holds it before", |p| p.bed = Bed::NONE),
        ("what is moved before", |p| {
            let life = Life { born: Stage::Before(0), gone: Some(Stage::Shaking) };
            let corners = vec![(0, 1)];
            p.prescribed.push(Prescribed { name: "pushed".into(), corners, to: [Some(1e-3); 3], life });
        }),
        ("a load", |p| {
            let factor = Arc::new(|t: f64| t);
            p.loads.push(Load { forces: vec![(0, [1.0, 0.0, 0.0])], factor });
        }),
    ];
    for (what, change) in changes {
        let mut other = problem();
        change(&mut other);
        let plan = plan(&other);
        let Ready { model, assembly, phase } = Ready::new(other);
        let stop = AtomicBool::new(false);
        let mut control = Control { stop: &stop, progress: &mut |_| {} };
        let results = ResultFolder::open_existing(&parts).unwrap();
        let refused = Simulation::new(
            &Built::of(&model, &assembly, &phase),
            &plan,
            &results,
            Start::Resume,
            Vec::new(),
        )
        .and_then(|simulation| run(simulation, &mut control));
        assert!(refused.is_err_and(|e| e.to_string().contains("another model or plan")), "{what}");
    }
}

/// Joints that open and slide: what pairs remember goes with the checkpoint.
#[test]
fn a_run_with_joints_resumes_to_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let (whole, parts) = (folder.path().join("whole"), folder.path().join("parts"));
    let problem = || {
        let mut problem = jointed(Isa::best());
        problem.time_step.given = Some(4e-6);
        problem
    };
    let outcome = go(problem(), &whole, 1, false, None);
    assert_eq!(outcome.ending, Ending::Done);
    let outcome = go(problem(), &parts, 2, false, Some(1));
    assert_eq!(outcome.ending, Ending::Stopped);
    assert!(outcome.taken > 0 && outcome.taken < outcome.steps.total, "stopped at {}", outcome.taken);
    assert_eq!(go(problem(), &parts, 2, true, None).ending, Ending::Done);
    let files = ["monitors.csv", "energy.csv", "interfaces.csv", "interfaces.pvd", "interfaces/000006.vtu"];
    for file in files {
        let bytes = |folder: &Path| std::fs::read(folder.join(file)).unwrap();
        assert!(bytes(&whole) == bytes(&parts), "{file}");
    }
    let table = Table::read(&whole.join("interfaces.csv")).unwrap();
    for quantity in ["joint.ever_slid", "joint.ever_opened", "joint.max_slip", "joint.max_gap"] {
        let last = *table.column(quantity).unwrap().last().unwrap();
        assert!(last > 0.0, "{quantity} {last}");
    }
    let monitors = Table::read(&whole.join("monitors.csv")).unwrap();
    assert!(monitors.column("pair.state").unwrap().contains(&3.0));
}

#[test]
fn a_step_thirty_per_cent_too_large_is_stopped_by_the_guard_with_the_element_named_and_results_kept() {
    let folder = tempfile::tempdir().unwrap();
    let mut problem = block([6, 5, 7]);
    let stable = Ready::new(problem.clone()).stable();
    problem.time_step.given = Some(1.3 * stable);
    let outcome = go(problem, folder.path(), 2, false, None);
    let Ending::Failed { halt, place } = &outcome.ending else {
        panic!("the run must be stopped, not {:?}", outcome.ending);
    };
    let Halt { found, supplied, step, .. } = halt;
    assert!(found > supplied);
    let place = place.to_string();
    assert!(place.starts_with("element ") && place.contains("of '"), "{place}");
    assert!(*step < outcome.steps.total);
    // What was computed before is there, and readable.
    let table = Table::read(&folder.path().join("monitors.csv")).unwrap();
    assert!(table.rows() >= 1 && !table.cut);
    assert_eq!(table.columns[1].header(), "top.ux [m]");
    assert!(!Pvd::read(&folder.path().join("fields.pvd")).unwrap().snapshots().is_empty());
}

#[test]
fn histories_have_the_columns_and_times_of_the_plan() {
    let folder = tempfile::tempdir().unwrap();
    let mut problem = block([4, 4, 5]);
    // The longest one is longer than an interval of rows.
    assert!(Ready::new(problem.clone()).stable() > 0.002);
    problem.time_step.given = Some(0.002);
    let outcome = go(problem, folder.path(), 1, false, None);
    let table = Table::read(&folder.path().join("monitors.csv")).unwrap();
    assert_eq!(table.rows(), 61);
    for (i, t) in table.column("time").unwrap().iter().enumerate() {
        assert!((t - 0.002 * i as f64).abs() < 1e-12);
    }
    assert_eq!(table.columns.len(), 1 + 2 * MONITOR.len() + RELATIVE.len());
    let (top, slab) = (table.column("top.ux").unwrap(), table.column("slab.ux").unwrap());
    let pair = table.column("top-slab.ux").unwrap();
    assert!((0..61).all(|i| pair[i] == top[i] - slab[i]));
    assert!(top.iter().any(|u| u.abs() > 1e-4));
    // Velocity is the derivative of displacement.
    let v = table.column("top.vx").unwrap();
    let most = v.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    for i in 1..60 {
        let derivative = (top[i + 1] - top[i - 1]) / 0.004;
        assert!((v[i] - derivative).abs() < 0.03 * most);
    }
    // Acceleration is the change of velocity between rows, and no row is beyond what single steps reached.
    let a = table.column("top.ax").unwrap();
    assert_eq!(a[0], 0.0);
    let plan = plan(&block([4, 4, 5]));
    let extremes = |quantity| Extremes::of(&outcome.state.observers, &plan, "top", quantity).unwrap();
    for i in 1..61 {
        assert!((a[i] - (v[i] - v[i - 1]) / 0.002).abs() < 1e-9 * most / 0.002);
        assert!(a[i] <= extremes("ax").max && a[i] >= extremes("ax").min);
        assert!(top[i] <= extremes("ux").max && top[i] >= extremes("ux").min);
    }
    // The scheme keeps its own energy, which differs from the physical one by (ωΔt/2)² at most; 25 Hz ends the pulse.
    let share = (std::f64::consts::PI * 25.0 * outcome.dt).powi(2);
    // A step's velocity is the mean over it, which cuts a peak by a sixth of that.
    let largest = extremes("vx").max.max(-extremes("vx").min);
    assert!((largest / most - 1.0).abs() < share / 3.0, "{largest} {most}");
    assert!(outcome.balance[Line::Error].abs() < share * outcome.state.ledger.supplied);
    let energy = Table::read(&folder.path().join("energy.csv")).unwrap();
    assert_eq!(energy.columns.last().unwrap().header(), "error [J]");
}
