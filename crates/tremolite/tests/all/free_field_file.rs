//! free_field.csv, and what the free field's checks are told.

use crate::ready::Ready;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use tremolite::observers::FreeFieldSeen;
use tremolite::plan::Plan;
use tremolite::run::{Control, run};
use tremolite::simulation::{Built, Simulation, Start};
use tremolite::state::Memory;
use tremolite::{
    AnyMaterial, Base, Body, Incident, Model, Problem, Quadrature, Rayleigh, Side, Top, elastic, laws,
};
use tremolite_laws::band::Band;
use tremolite_laws::{Moduli, Values};
use tremolite_mesh::boxes::BoxSpec;
use tremolite_motion::{Motion, ricker_velocity};
use tremolite_results::{ResultFolder, Table};

/// 30 m of soil on 20 m of rock, `layers` elements in all (a multiple of 5), under a pulse of 8 Hz along all three axes.
pub fn ground(layers: u32) -> Problem {
    let mesh = BoxSpec::uniform([0.0; 3], [4.0, 4.0, 50.0], [2, 2, layers]).mesh().unwrap();
    let (rock, soil): (Vec<u32>, Vec<u32>) =
        (0..mesh.elements.len() as u32).partition(|&e| tremolite::hexahedra::centroid(&mesh, e)[2] < 20.0);
    let body = |name: &str, elements, young, density| Body {
        name: name.into(),
        elements,
        material: elastic(Moduli::from_young_poisson(young, 0.25)),
        density,
        quadrature: Quadrature::OnePoint,
        viscosity: 0.0,
    };
    let bodies = vec![body("rock", rock, 5e9, 2600.0), body("soil", soil, 1e9, 2000.0)];
    let mut problem = Problem::new(mesh, bodies);
    problem.base = Base::Viscous;
    problem.sides = [Side::Periodic; 2];
    let pulse = ricker_velocity(8.0, 0.15, 0.2);
    let motion = Motion::sampled(1e-3, 0.8, |t| pulse(t).along([1.0, 0.5, -0.7])).unwrap();
    problem.incident = Some(Incident { motion, factor: 0.5 });
    problem
}

/// Material of the soil with a law of the list; with damping over a band if there is one.
pub fn soil(law: &str, values: &Values, band: Option<Band>) -> Arc<dyn AnyMaterial> {
    let law = laws().into_iter().find(|known| known.info.name == law).unwrap();
    let made = band.map_or_else(|| (law.build)(values), |band| (law.build_banded)(values, band));
    made.unwrap_or_else(|_| panic!("{}", law.info.name))
}

/// free_field.csv of a run, and what was seen.
fn shaken(problem: Problem, folder: &Path) -> (Table, FreeFieldSeen) {
    let (results, model, memory) = outcome(problem, folder);
    let seen = FreeFieldSeen::of(&model, &memory).unwrap();
    (Table::read(&results.free_field()).unwrap(), seen)
}

/// The results of a run, its model, and what its observers remember.
pub fn outcome(problem: Problem, folder: &Path) -> (ResultFolder, Arc<Model>, Memory) {
    let plan = Plan {
        page: tremolite_results::PageWish::default(),
        boundaries: Default::default(),
        target: None,
        title: "ground".into(),
        stages: Vec::new(),
        duration: 0.7,
        recorded: None,
        waves: None,
        histories: 0.005,
        snapshots: None,
        fields: Vec::new(),
        field_elements: 250_000,
        checkpoint: None,
        monitors: Vec::new(),
        pairs: Vec::new(),
        bolts: Vec::new(),
        bars: 0,
        water: false,
        relatives: Vec::new(),
        sections: Vec::new(),
    };
    let Ready { model, assembly, phase } = Ready::new(problem);
    let results = ResultFolder::create(Some(folder), "ground", true).unwrap();
    let stop = AtomicBool::new(false);
    let mut control = Control { stop: &stop, progress: &mut |_| {} };
    let outcome =
        Simulation::new(&Built::of(&model, &assembly, &phase), &plan, &results, Start::Rest, Vec::new())
            .and_then(|simulation| run(simulation, &mut control))
            .unwrap();
    (results, model, outcome.state.observers)
}

fn error(problem: Problem) -> f64 {
    let folder = tempfile::tempdir().unwrap();
    let (_, seen) = shaken(problem, folder.path());
    seen.columns[0].theory.unwrap().error()
}

#[test]
fn a_layered_column_comes_to_theory_with_order_two_whatever_its_damping_and_top() {
    let values = Values::default().with("young", 1e9).with("poisson", 0.25);
    type Change = Box<dyn Fn(&mut Problem)>;
    let changes: [(&str, Change); 5] = [
        ("undamped", Box::new(|_| ())),
        ("viscous top", Box::new(|p| p.top = Top::Viscous)),
        ("Rayleigh", Box::new(|p| p.rayleigh = Rayleigh { mass: 0.5, stiffness: 3e-4 })),
        (
            "band",
            Box::new(move |p| {
                let band = Band::fit(0.03, [0.5, 20.0], 3.0).unwrap();
                p.bodies[1].material = soil("elastic", &values, Some(band));
            }),
        ),
        (
            "springs",
            Box::new(|p| {
                p.base = Base::ViscousSpring { normal: 1.33, tangential: 0.67, distance: Some(50.0) }
            }),
        ),
    ];
    for (word, change) in changes {
        let of = |layers| {
            let mut problem = ground(layers);
            change(&mut problem);
            error(problem)
        };
        let (coarse, fine) = (of(50), of(100));
        let order = (coarse / fine).log2();
        // The soil's row of lumped masses is late by (kh)²/24 of its phase, kh = 0.056 at the pulse's peak frequency for the finer
        // mesh and the phase up and down 6.7: 0.09 %, and twice that for what lies above the peak.
        assert!(fine < 0.002 && (order - 2.0).abs() < 0.1, "{word}: {coarse} {fine}, order {order}");
    }
    // The same check fails for a mesh that cannot carry the wave.
    assert!(error(ground(5)) > 0.05);
}

#[test]
fn a_row_holds_what_columns_and_the_model_do_and_what_theory_says() {
    let folder = tempfile::tempdir().unwrap();
    let (table, seen) = shaken(ground(50), folder.path());
    let names: Vec<&str> = table.columns.iter().map(|column| column.name.as_str()).collect();
    assert_eq!(names[..4], ["time", "reference.top.vx", "reference.top.vx_theory", "reference.top.vy"]);
    assert_eq!(names[7..9], ["reference.base.vx", "reference.base.vx_theory"]);
    assert_eq!(
        names[13..],
        ["", "xmin-ymin.", "xmax-ymin.", "xmin-ymax.", "xmax-ymax."]
            .iter()
            .flat_map(|corner| ["surface", "base"].map(|at| format!("{corner}{at}")))
            .flat_map(|at| ["x", "y", "z"].map(|i| format!("model.{at}.v{i}")))
            .collect::<Vec<_>>()
    );
    assert!(names[1..].iter().all(|name| table.unit(name) == Some("m/s")) && table.rows() == 141);
    // Pages and scripts find in it what was written.
    let read = tremolite_results::FreeField::of(table.clone());
    assert_eq!(read.columns[0].base.theory[2], table.column("reference.base.vz_theory").unwrap());
    assert_eq!(read.model.unwrap().top.measured[0], table.column("model.surface.vx").unwrap());
    let peak = seen.columns[0].peak;
    for (model, column) in [
        ("model.surface.v", "reference.top.v"),
        ("model.base.v", "reference.base.v"),
        ("model.xmax-ymin.surface.v", "reference.top.v"),
        ("model.xmin-ymax.base.v", "reference.base.v"),
    ] {
        for axis in ["x", "y", "z"] {
            let of = |name: &str| table.column(&format!("{name}{axis}")).unwrap().to_vec();
            let (model, column) = (of(model), of(column));
            assert!(model.iter().zip(&column).all(|(a, b)| (a - b).abs() < 1e-10 * peak), "{axis}");
            assert!(model.iter().any(|v| v.abs() > 0.1 * peak), "{axis}: nothing moves");
        }
    }
    // A theory that is not beside its measured column would err by all of it.
    let [found, exact] =
        ["reference.base.vz", "reference.base.vz_theory"].map(|name| table.column(name).unwrap());
    let worst = found.iter().zip(exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(worst < 0.01 * peak, "{worst}");
}

#[test]
fn theory_ends_where_the_column_yields() {
    let values = Values::default()
        .with("young", 1e9)
        .with("poisson", 0.25)
        .with("cohesion", 2e4)
        .with("friction_angle", 0.3)
        .with("dilation_angle", 0.0)
        .with("tensile_strength", 2e4);
    let folder = tempfile::tempdir().unwrap();
    let mut problem = ground(25);
    problem.bodies[1].material = soil("mohr-coulomb", &values, None);
    let (table, seen) = shaken(problem, folder.path());
    let exact = table.column("reference.top.vx_theory").unwrap();
    let first = exact.iter().position(|v| v.is_nan()).unwrap();
    assert!(seen.columns[0].damaged && first > 10, "{first}");
    assert!(exact[first..].iter().all(|v| v.is_nan()));
    assert!(table.column("reference.top.vx").unwrap().iter().all(|v| v.is_finite()));
}

#[test]
fn each_end_of_each_slab_is_compared_with_theory_and_with_its_own_corner() {
    let folder = tempfile::tempdir().unwrap();
    let (_, one) = shaken(ground(25), folder.path());
    let mut problem = ground(25);
    problem.sides = [Side::FreeField; 2];
    let (table, seen) = shaken(problem, folder.path());
    let mut names: Vec<&str> = seen.columns.iter().map(|column| column.name.as_str()).collect();
    names.sort_unstable();
    let ends = [
        "xmax-ymax",
        "xmax-ymin",
        "xmin-ymax",
        "xmin-ymin",
        "ymax-xmax",
        "ymax-xmin",
        "ymin-xmax",
        "ymin-xmin",
    ];
    assert_eq!(names, ends);
    assert_eq!(table.columns.len(), 1 + 8 * 12 + 5 * 6);
    for column in &seen.columns {
        let [theory, alone] = [column.theory, one.columns[0].theory].map(|theory| theory.unwrap().error());
        assert!((theory - alone).abs() < 1e-9, "{}: {theory} {alone}", column.name);
        assert!(column.peak > 0.1 && column.corners.iter().all(|d| *d < 1e-10 * column.peak), "{column:?}");
    }
}

#[test]
fn columns_of_unlike_ground_have_theories_of_their_own() {
    let folder = tempfile::tempdir().unwrap();
    // Wide enough for waves of the four to stay apart.
    const WIDE: f64 = 60.0;
    let mut problem = ground(100);
    for node in &mut problem.mesh.nodes {
        (node[0], node[1]) = (node[0] * WIDE / 4.0, node[1] * WIDE / 4.0);
    }
    let soil = problem.bodies.pop().unwrap();
    let quarter = |e: &u32| {
        let [x, y, _] = tremolite::hexahedra::centroid(&problem.mesh, *e);
        usize::from(x > WIDE / 2.0) + 2 * usize::from(y > WIDE / 2.0)
    };
    for (k, young) in [1e9, 2e9, 3e9, 4e9].into_iter().enumerate() {
        problem.bodies.push(Body {
            name: format!("soil {k}"),
            elements: soil.elements.iter().copied().filter(|e| quarter(e) == k).collect(),
            material: elastic(Moduli::from_young_poisson(young, 0.25)),
            ..soil.clone()
        });
    }
    problem.sides = [Side::Viscous; 2];
    let (table, seen) = shaken(problem, folder.path());
    let names: Vec<&str> = seen.columns.iter().map(|column| column.name.as_str()).collect();
    let corners = ["xmin-ymin", "xmax-ymin", "xmin-ymax", "xmax-ymax"];
    assert_eq!(names, corners.map(|corner| format!("reference-{corner}")));
    for column in &seen.columns {
        let error = column.theory.unwrap().error();
        assert!(error < 0.002, "{}: {error}", column.name);
    }
    let of = |name: &str| table.column(&format!("{name}.top.vx_theory")).unwrap();
    let (one, other) = (of(&seen.columns[0].name), of(&seen.columns[seen.columns.len() - 1].name));
    assert!(one.iter().zip(other).any(|(a, b)| (a - b).abs() > 0.1 * seen.columns[0].peak));
    // Dashpots at the sides drain the wave, which the model's own corners show.
    assert!(seen.columns.iter().any(|column| column.corners[0] > 0.1 * column.peak));
    // Each corner beside its own column says what the check says, but for what lies between rows: theirs are 5 ms apart and the
    // pulse goes up to some 20 Hz, so a peak is missed by at most 1 − cos(π · 20 Hz · 5 ms) of it, 5 %.
    let at = |name: String| table.column(&name).unwrap();
    for (column, corner) in seen.columns.iter().zip(corners) {
        for (checked, [own, model]) in column.corners.into_iter().zip([["top", "surface"], ["base", "base"]])
        {
            let apart = ["x", "y", "z"].map(|axis| {
                let column = at(format!("{}.{own}.v{axis}", column.name));
                let model = at(format!("model.{corner}.{model}.v{axis}"));
                column.iter().zip(model).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
            });
            let share = apart.into_iter().fold(0.0, f64::max) / checked;
            assert!((0.95..=1.0).contains(&share), "{corner} {model}: {share} of {checked}");
        }
    }
    // Their mean is none of them.
    for place in ["surface.vx", "base.vz"] {
        let mean = at(format!("model.{place}"));
        let each = corners.map(|corner| at(format!("model.{corner}.{place}")));
        let peak = seen.columns[0].peak;
        for (row, mean) in mean.iter().enumerate() {
            let four: f64 = each.iter().map(|values| values[row]).sum();
            assert!((four / 4.0 - mean).abs() < 1e-9 * peak, "{place}");
        }
        let apart = each[0].iter().zip(mean).any(|(a, b)| (a - b).abs() > 0.01 * peak);
        assert!(apart, "{place}: the corners move alike, and nothing is shown");
    }
}
