//! A cracked element carries no damping: two halves that fly apart keep their momentum.

use crate::ready::Ready;
use tremolite::{Base, Body, Problem, Quadrature, Rayleigh, Side, elastic, laws};
use tremolite_laws::band::Band;
use tremolite_laws::{Moduli, Row, Values};
use tremolite_mesh::boxes::BoxSpec;

/// How damping is given.
#[derive(Clone, Copy, Debug)]
enum Damping {
    Stiffness,
    Band,
}

/// Three unit cubes on top of one another, the middle one of concrete. Momentum over mass \[m/s\] of the upper half
/// after the first crack has run through and at the end, when the halves were sent apart at 2 m/s.
fn upper_half(quadrature: Quadrature, damping: Damping) -> [f64; 2] {
    let mesh = BoxSpec::uniform([0.0; 3], [1.0, 1.0, 3.0], [1, 1, 3]).mesh().unwrap();
    let values = Values::default()
        .with("young", 25e9)
        .with("poisson", 0.17)
        .with("tensile_strength", 1.2e6)
        .with("cohesion", 2e6)
        .with("friction_angle", 0.8);
    let concrete = laws().into_iter().find(|l| l.info.name == "concrete-damage").unwrap();
    let material = match damping {
        Damping::Stiffness => (concrete.build)(&values),
        Damping::Band => (concrete.build_banded)(&values, Band::fit(0.05, [5.0, 200.0], 30.0).unwrap()),
    };
    let middle = |e: &u32| (tremolite::hexahedra::centroid(&mesh, *e)[2] - 1.5).abs() < 0.1;
    let body = |name: &str, elements: Vec<u32>, material, quadrature| Body {
        name: name.into(),
        elements,
        material,
        density: 2700.0,
        quadrature,
    };
    let bodies = vec![
        body("weak", (0..3).filter(middle).collect(), material.unwrap(), quadrature),
        body(
            "strong",
            (0..3).filter(|e| !middle(e)).collect(),
            elastic(Moduli::from_young_poisson(25e9, 0.17)),
            Quadrature::OnePoint,
        ),
    ];
    let mut problem = Problem::new(mesh, bodies);
    problem.base = Base::Free;
    problem.sides = [Side::Free; 2];
    let stiffness = if matches!(damping, Damping::Stiffness) { 1e-5 } else { 0.0 };
    problem.rayleigh = Rayleigh { mass: 0.0, stiffness };
    let ready = Ready::new(problem);
    let (model, phase) = (&ready.model, &ready.phase);
    let mut state = ready.rest(0.5);
    let above = |node: usize| model.mesh.nodes[model.mesh_node[node] as usize][2] > 1.5;
    let velocity = |node: usize| Row::new([0.0, 0.0, if above(node) { 1.0 } else { -1.0 }]);
    let velocities: Vec<Row> = (0..state.u.len()).map(velocity).collect();
    let mut engine = ready.engine();
    let at_rest = state.u.clone();
    engine.start(&mut state, at_rest, &velocities);
    let mut momentum = |steps: usize| {
        for _ in 0..steps {
            engine.step(&mut state).unwrap();
        }
        let rows = state.du.iter().enumerate().filter(|(n, _)| above(*n));
        let sum = rows
            .fold([0.0; 2], |s, (n, du)| [s[0] + phase.mass[n] * du.0[2] / state.dt, s[1] + phase.mass[n]]);
        sum[0] / sum[1]
    };
    let early = momentum(400);
    [early, momentum(4000)]
}

#[test]
fn halves_that_fly_apart_keep_their_momentum() {
    for quadrature in [Quadrature::OnePoint, Quadrature::Full] {
        for damping in [Damping::Stiffness, Damping::Band] {
            let [early, late] = upper_half(quadrature, damping);
            // What the crack takes on its way is no matter here; then nothing pulls any more.
            assert!(early > 0.9 && early < 1.0, "{quadrature:?}, {damping:?}: {early}");
            assert!((late - early).abs() < 1e-9, "{quadrature:?}, {damping:?}: {early} {late}");
        }
    }
}
