//! Free-field sides: a model of level ground moves as its columns do, whatever its ground does.

use crate::block::pulse;
use crate::ready::Ready;
use std::sync::Arc;
use tremolite::{AnyMaterial, Base, Body, Incident, Problem, Quadrature, Rayleigh, Side, elastic, laws};
use tremolite_laws::band::Band;
use tremolite_laws::{Moduli, Values};
use tremolite_mesh::Mesh;
use tremolite_mesh::boxes::BoxSpec;

/// Level ground of three layers, graded in plan and in height, under a pulse along x, y and z, with free-field sides.
fn ground(material: impl Fn(usize) -> Arc<dyn AnyMaterial>, quadrature: Quadrature) -> Problem {
    let mesh = graded();
    let layer = |e: u32| {
        let z = tremolite::hexahedra::centroid(&mesh, e)[2];
        usize::from(z > 5.0) + usize::from(z > 9.0)
    };
    let body = |k: usize| Body {
        name: format!("layer {k}"),
        elements: (0..mesh.elements.len() as u32).filter(|&e| layer(e) == k).collect(),
        material: material(k),
        density: [2700.0, 2400.0, 2000.0][k],
        quadrature,
        viscosity: 0.0,
    };
    let bodies = (0..3).map(body).collect();
    let mut problem = Problem::new(mesh.clone(), bodies);
    problem.base = Base::ViscousSpring { normal: 1.33, tangential: 0.67, distance: Some(10.0) };
    problem.sides = [Side::FreeField; 2];
    problem.incident = Some(Incident { motion: pulse(), factor: 0.5 });
    problem
}

fn graded() -> Mesh {
    let lines = |length: f64, n: u32, power: f64| -> Vec<f64> {
        (0..=n).map(|i| length * (f64::from(i) / f64::from(n)).powf(power)).collect()
    };
    let mut mesh = BoxSpec::uniform([0.0; 3], [12.0, 10.0, 14.0], [5, 4, 14]).mesh().unwrap();
    let (x, y) = (lines(12.0, 5, 1.2), lines(10.0, 4, 0.85));
    for node in &mut mesh.nodes {
        node[0] = x[(node[0] / 2.4).round() as usize];
        node[1] = y[(node[1] / 2.5).round() as usize];
        node[2] += 0.2 * (node[2] * std::f64::consts::PI / 14.0).sin();
    }
    mesh
}

fn moduli(layer: usize) -> Moduli {
    Moduli::from_young_poisson([2e9, 1e9, 0.4e9][layer], [0.25, 0.3, 0.2][layer])
}

/// Largest difference of any node's velocity from that of its level in the columns, over the peak.
fn against_columns(problem: Problem, steps: u64) -> f64 {
    let ready = Ready::new(problem);
    let model = &ready.model;
    let node = |n: u32| model.mesh.nodes[n as usize];
    let levels: Vec<(usize, usize)> = model
        .counted
        .clone()
        .map(|n| {
            let z = node(model.mesh_node[n])[2];
            let beside = (model.of_slabs.end..model.mesh_node.len())
                .find(|&c| (node(model.mesh_node[c])[2] - z).abs() < 1e-9)
                .unwrap();
            (n, beside)
        })
        .collect();
    let mut engine = ready.engine();
    let mut state = ready.rest(0.9);
    let (mut peak, mut worst) = (0.0_f64, 0.0_f64);
    for _ in 0..steps {
        engine.step(&mut state).unwrap();
        for &(n, c) in &levels {
            for i in 0..3 {
                peak = peak.max(state.du[n].0[i].abs());
                worst = worst.max((state.du[n].0[i] - state.du[c].0[i]).abs());
            }
        }
    }
    worst / peak
}

#[test]
fn level_ground_moves_as_its_columns() {
    let rock = |k: usize| elastic(moduli(k));
    let yielding = |k: usize| {
        let values = Values::default()
            .with("young", moduli(k).young())
            .with("poisson", moduli(k).poisson())
            .with("cohesion", [1e5, 2e4, 1e4][k])
            .with("friction_angle", 0.5)
            .with("tensile_strength", 1e4);
        let law = laws().into_iter().find(|law| law.info.name == "mohr-coulomb").unwrap();
        (law.build)(&values).unwrap()
    };
    let banded = |k: usize| {
        let values = Values::default().with("young", moduli(k).young()).with("poisson", moduli(k).poisson());
        let law = laws().into_iter().find(|law| law.info.name == "elastic").unwrap();
        (law.build_banded)(&values, Band::fit(0.04, [1.0, 40.0], 12.0).unwrap()).unwrap()
    };
    let steps = 500;
    for quadrature in [Quadrature::OnePoint, Quadrature::Full] {
        let elastic = against_columns(ground(rock, quadrature), steps);
        let plastic = against_columns(ground(yielding, quadrature), steps);
        let band = against_columns(ground(banded, quadrature), steps);
        let mut damped = ground(rock, quadrature);
        damped.rayleigh = Rayleigh { mass: 2.0, stiffness: 1e-4 };
        let rayleigh = against_columns(damped, steps);
        eprintln!("{quadrature:?} {elastic:e} {plastic:e} {band:e} {rayleigh:e}");
        for found in [elastic, plastic, band, rayleigh] {
            assert!(found < 1e-10, "{quadrature:?}: {elastic:e} {plastic:e} {band:e} {rayleigh:e}");
        }
    }
}
