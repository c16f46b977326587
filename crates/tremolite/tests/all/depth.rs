//! depth.csv: peaks along depth against theory and against monitors in the ground.

use crate::ready::Ready;
use std::f64::consts::TAU;
use std::path::Path;
use std::sync::atomic::AtomicBool;
use tremolite::observers::Extremes;
use tremolite::plan::{Monitor, Plan};
use tremolite::run::{Control, run};
use tremolite::simulation::{Built, Outcome, Simulation, Start};
use tremolite::{Base, Body, Incident, Problem, Quadrature, Side, elastic, laws};
use tremolite_laws::{Moduli, Values};
use tremolite_mesh::boxes::BoxSpec;
use tremolite_mesh::locate::Locator;
use tremolite_motion::{Motion, Sample};
use tremolite_results::{ResultFolder, Table};

/// Depth of the ground \[m\] and its speed of shear waves \[m/s\].
const HEIGHT: f64 = 60.0;
const SPEED: f64 = 400.0;
/// Of the wave that comes in: its velocity \[m/s\] and frequency \[Hz\], a wavelength of 80 m.
const INCIDENT: f64 = 0.1;
const HERTZ: f64 = 5.0;
const SECONDS: f64 = 1.6;

/// Ground without end under a train of shear waves along x and y that begins smoothly, and what is watched in it, in m above the base.
pub fn ground(layers: u32) -> Problem {
    let mesh = BoxSpec::uniform([0.0; 3], [4.0, 4.0, HEIGHT], [2, 2, layers]).mesh().unwrap();
    let density = 2000.0;
    let rock = Body {
        name: "rock".into(),
        elements: (0..mesh.elements.len() as u32).collect(),
        material: elastic(Moduli::from_young_poisson(2.5 * density * SPEED * SPEED, 0.25)),
        density,
        quadrature: Quadrature::OnePoint,
        viscosity: 0.0,
    };
    let mut problem = Problem::new(mesh, vec![rock]);
    problem.base = Base::Viscous;
    problem.sides = [Side::Periodic; 2];
    // v = (1 − e^(−(t/T)³)) sin ωt grows to the whole within 0.6 s.
    let omega = TAU * HERTZ;
    let velocity = move |t: f64| (1.0 - (-(t / 0.3).powi(3)).exp()) * (omega * t).sin();
    let dt = 1e-3;
    let mut u = 0.0;
    let samples: Vec<Sample> = (0..=2000)
        .map(|k| {
            let t = f64::from(k) * dt;
            if k > 0 {
                u += 0.5 * dt * (velocity(t - dt) + velocity(t));
            }
            let a = (velocity(t + 1e-6) - velocity(t - 1e-6)) / 2e-6;
            Sample { a: [a, 0.4 * a, 0.0], v: [velocity(t), 0.4 * velocity(t), 0.0], u: [u, 0.4 * u, 0.0] }
        })
        .collect();
    let motion = Motion::sampled(dt, 2.0, |t| samples[(t / dt).round() as usize]).unwrap();
    problem.incident = Some(Incident { motion, factor: INCIDENT });
    problem
}

/// Monitors at some heights above the base \[m\].
pub fn plan(problem: &Problem, heights: &[f64], seconds: f64) -> Plan {
    let locator = Locator::new(&problem.mesh, None);
    let monitor = |z: &f64| Monitor {
        name: format!("at{z}"),
        point: [1.3, 2.6, *z],
        location: locator.locate([1.3, 2.6, *z], 1e-6).unwrap(),
    };
    Plan {
        page: tremolite_results::PageWish::default(),
        boundaries: Default::default(),
        target: None,
        title: "ground".into(),
        stages: Vec::new(),
        duration: seconds,
        recorded: None,
        waves: None,
        histories: 0.005,
        snapshots: None,
        fields: Vec::new(),
        field_elements: 250_000,
        checkpoint: None,
        monitors: heights.iter().map(monitor).collect(),
        pairs: Vec::new(),
        bolts: Vec::new(),
        bars: 0,
        water: false,
        relatives: Vec::new(),
        sections: Vec::new(),
    }
}

pub fn shaken(problem: Problem, plan: &Plan, folder: &Path) -> (ResultFolder, Outcome) {
    let Ready { model, assembly, phase } = Ready::new(problem);
    let results = ResultFolder::create(Some(folder), "ground", true).unwrap();
    let stop = AtomicBool::new(false);
    let mut control = Control { stop: &stop, progress: &mut |_| {} };
    let outcome =
        Simulation::new(&Built::of(&model, &assembly, &phase), plan, &results, Start::Rest, Vec::new())
            .and_then(|simulation| run(simulation, &mut control))
            .unwrap();
    (results, outcome)
}

fn depth(layers: u32) -> Table {
    let folder = tempfile::tempdir().unwrap();
    let problem = ground(layers);
    let plan = plan(&problem, &[], SECONDS);
    let (results, _) = shaken(problem, &plan, folder.path());
    Table::read(&results.depth()).unwrap()
}

fn column<'t>(table: &'t Table, name: &str) -> &'t [f64] {
    table.column(name).unwrap_or_else(|| panic!("{name}"))
}

#[test]
fn peaks_along_depth_stand_as_the_wave_does_under_a_free_surface() {
    // What goes up and what comes back stand as 2 v_i |cos kd|, their strain as 2 v_i/c |sin kd|. While the train grows what comes
    // back is up to 0.3 s younger than what goes up, 0.63 of it, and the two together reach 0.52 of the whole where 0.6 of it
    // stands: below that it may be the beginning that is largest.
    let k = TAU * HERTZ / SPEED;
    let worst = |layers: u32| {
        let table = depth(layers);
        let (down, element) = (column(&table, "depth"), HEIGHT / f64::from(layers));
        assert_eq!(down.len(), layers as usize + 1);
        let mut worst = 0.0_f64;
        for (row, d) in down.iter().enumerate() {
            assert!((d - element * row as f64).abs() < 1e-9, "a row a level, from the top down");
            assert!((column(&table, "z")[row] - (HEIGHT - d)).abs() < 1e-9);
            let (standing, strained) = ((k * d).cos().abs(), (k * (d + 0.5 * element)).sin().abs());
            for (axis, share) in [("x", 1.0), ("y", 0.4)] {
                let of = |name: &str| column(&table, &format!("free_field.{name}"))[row];
                let whole = 2.0 * INCIDENT * share;
                if standing > 0.6 {
                    worst = worst.max((of(&format!("v{axis}")) / whole - standing).abs());
                    worst = worst.max((of(&format!("a{axis}")) / (whole * TAU * HERTZ) - standing).abs());
                }
                if strained > 0.6 && row + 1 < down.len() {
                    worst = worst.max((of(&format!("g{axis}z")) * SPEED / whole - strained).abs());
                }
                assert!(of("vz") < 1e-12 && (of("ezz").is_nan() || of("ezz") <= 1e-12));
            }
        }
        let lowest = column(&table, "free_field.gxz");
        assert!(lowest[layers as usize].is_nan() && lowest[0] > 0.0);
        worst
    };
    let (coarse, fine) = (worst(20), worst(40));
    // Lumped masses make k (1 + (kh)²/24) of k: at kd = 3π/2 and h = 1.5 m a phase of 0.27 %, of which cos and sin show 0.8 at
    // most; four times that for 3 m. Rows miss 1 − cos(π · 5 Hz · 5 ms) of accelerations, 0.3 %, and their means 0.1 %.
    assert!(fine < 0.0065 && coarse < 0.013, "{coarse} {fine}");
}

#[test]
fn theory_stands_beside_every_level_and_meshes_come_to_it_with_order_two() {
    let worst = |layers: u32| {
        let table = depth(layers);
        let mut worst = 0.0_f64;
        for name in ["ux", "vx", "ax", "gxz", "uy", "vy", "ay", "gyz"] {
            let found = column(&table, &format!("free_field.{name}"));
            let exact = column(&table, &format!("free_field.{name}_theory"));
            let most = exact.iter().copied().filter(|x| x.is_finite()).fold(0.0, f64::max);
            assert!(most > 0.0, "{name}");
            let pairs = found.iter().zip(exact).filter(|(a, b)| a.is_finite() || b.is_finite());
            worst = pairs.map(|(a, b)| (a - b).abs() / most).fold(worst, f64::max);
        }
        worst
    };
    let (coarse, fine) = (worst(20), worst(40));
    let order = (coarse / fine).log2();
    // The phase of 0.058 % a radian up and down through 3π/2 each, where the motion changes most along depth.
    assert!(fine < 0.0055 && (order - 2.0).abs() < 0.3, "{coarse} {fine}, order {order}");
}

#[test]
fn a_monitor_in_the_ground_has_the_peaks_of_its_level_and_the_edge_those_of_the_column() {
    let folder = tempfile::tempdir().unwrap();
    let problem = ground(20);
    // On levels: 3 m apart.
    let heights = [60.0, 45.0, 12.0];
    let plan = plan(&problem, &heights, SECONDS);
    let (results, outcome) = shaken(problem, &plan, folder.path());
    let (table, monitors) =
        (Table::read(&results.depth()).unwrap(), Table::read(&results.monitors()).unwrap());
    for name in ["ux", "uy", "vx", "vy", "ax", "ay"] {
        let (own, edge) =
            (column(&table, &format!("free_field.{name}")), column(&table, &format!("model.{name}")));
        let most = own.iter().copied().fold(0.0, f64::max);
        assert!(own.iter().zip(edge).all(|(a, b)| (a - b).abs() < 1e-9 * most), "{name}");
    }
    for z in heights {
        let row = column(&table, "z").iter().position(|level| (level - z).abs() < 1e-9).unwrap();
        let rows = |name: &str| {
            column(&monitors, &format!("at{z}.{name}")).iter().fold(0.0_f64, |most, x| most.max(x.abs()))
        };
        let peak = |name: &str| column(&table, &format!("free_field.{name}"))[row];
        for name in ["ax", "ay"] {
            let (peak, rows) = (peak(name), rows(name));
            assert!((peak - rows).abs() < 1e-9 * peak && peak > 0.1, "{z} {name}: {peak} {rows}");
        }
        for name in ["vx", "vy"] {
            let (peak, rows) = (peak(name), rows(name));
            let of = Extremes::of(&outcome.state.observers, &plan, &format!("at{z}"), name).unwrap();
            let most = of.max.max(-of.min);
            assert!((peak - most).abs() < 1e-9 * most, "{z} {name}: {peak} {most}");
            // Rows miss at most 1 − cos(π · 5 Hz · 5 ms) of a peak, 0.3 %; a step's mean is a little below its middle.
            assert!((0.995..=1.002).contains(&(rows / peak)), "{z} {name}: {rows} {peak}");
        }
    }
}

#[test]
fn where_the_ground_yields_there_is_no_theory_along_depth() {
    let folder = tempfile::tempdir().unwrap();
    let mut problem = ground(20);
    let values = Values::default()
        .with("young", 2.5 * 2000.0 * SPEED * SPEED)
        .with("poisson", 0.25)
        .with("cohesion", 2e4)
        .with("friction_angle", 0.3)
        .with("dilation_angle", 0.0)
        .with("tensile_strength", 2e4);
    let law = laws().into_iter().find(|known| known.info.name == "mohr-coulomb").unwrap();
    problem.bodies[0].material = (law.build)(&values).unwrap_or_else(|_| panic!());
    let plan = plan(&problem, &[], 0.5);
    let (results, _) = shaken(problem, &plan, folder.path());
    let table = Table::read(&results.depth()).unwrap();
    assert!(table.columns.iter().all(|column| !column.name.ends_with("_theory")));
    assert!(column(&table, "free_field.gxz")[0] > 0.0);
}

#[test]
fn without_a_wave_there_are_neither_peaks_along_depth_nor_spectra() {
    let folder = tempfile::tempdir().unwrap();
    let mut problem = ground(10);
    problem.incident = None;
    problem.base = Base::Fixed;
    let plan = plan(&problem, &[30.0], 0.05);
    let (results, _) = shaken(problem, &plan, folder.path());
    assert!(results.monitors().exists() && !results.depth().exists() && !results.spectra().exists());
}
