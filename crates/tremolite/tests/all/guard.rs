//! The guard where far more energy comes free than was supplied: a block falls as its bond breaks.

use crate::contact::between;
use std::sync::Arc;
use tremolite::engine::Release;
use tremolite::parts::loads::Load;
use tremolite::{
    Assembly, Bed, Body, Engine, Found, Line, Model, Phase, Problem, Quadrature, Stage, State, elastic,
    stable_step,
};
use tremolite_laws::Moduli;
use tremolite_mesh::boxes::BoxSpec;

const GRAVITY: f64 = 9.81;
const DENSITY: f64 = 2500.0;
/// Of the block that hangs \[m\].
const HEIGHT: f64 = 2.0;
const AREA: f64 = 4.0;
const MASS: f64 = DENSITY * HEIGHT * AREA;

/// A block that hangs on a bond of 1.06 times its weight, pulled down by a tenth of its weight for 10 ms.
fn hanging() -> Problem {
    let mesh = BoxSpec::uniform([0.0, 0.0, -HEIGHT], [2.0, 2.0, HEIGHT], [2, 2, 4]).mesh().unwrap();
    let body = |name: &str, elements| Body {
        name: name.into(),
        elements,
        material: elastic(Moduli::from_young_poisson(20e9, 0.2)),
        density: DENSITY,
        quadrature: Quadrature::Full,
        viscosity: 0.0,
    };
    let bodies = vec![body("roof", (8..16).collect()), body("block", (0..8).collect())];
    let nodes = |wanted: &dyn Fn(f64) -> bool| -> Vec<u32> {
        (0..mesh.nodes.len() as u32).filter(|&n| wanted(mesh.nodes[n as usize][2])).collect()
    };
    let (held, pulled) = (nodes(&|z| z > HEIGHT - 0.1), nodes(&|z| z < 0.1 - HEIGHT));
    let mut problem = Problem::new(mesh, bodies);
    problem.held = held.into_iter().map(|n| (n, [true; 3])).collect();
    let pull = 0.1 * MASS * GRAVITY / pulled.len() as f64;
    problem.loads = vec![Load {
        forces: pulled.into_iter().map(|n| (n, [0.0, 0.0, -pull])).collect(),
        factor: Arc::new(|t: f64| if t < 0.01 { (t / 0.01 * std::f64::consts::PI).sin() } else { 0.0 }),
    }];
    problem.gravity = GRAVITY;
    problem.bed = Bed::NONE;
    let bond = 1.06 * MASS * GRAVITY / AREA;
    let numbers = [
        ("normal_stiffness", 20e9),
        ("max_closure", 2e-3),
        ("cohesion", 1e6),
        ("tensile_strength", bond),
        ("friction_coefficient", 0.7),
    ];
    problem.interfaces = vec![between(&problem, [0, 1], "bandis", &numbers)];
    problem
}

/// From rest under the weight; steps of this share of the stable one.
fn at_rest(share: f64) -> (Arc<Model>, Engine, State) {
    let model = Model::new(hanging()).unwrap();
    let assembly = Assembly::new(&model).unwrap();
    let mut state = assembly.rest();
    let phase = Phase::of(&model, &assembly, Stage::Before(0)).unwrap();
    let release = Release { cycles: 20, tolerance: [1e-9, 1e-6], ..Release::default() };
    Engine::new(&model, &assembly, &phase).relax(&mut state, &release).unwrap();
    for pair in 0..9 {
        let pressure = assembly.contacts[0].seen(&state.history, pair).pressure;
        assert!(
            (-pressure * AREA / (MASS * GRAVITY) - 1.0).abs() < 0.03,
            "the bond bears the weight: {pressure}"
        );
    }
    let phase = Phase::of(&model, &assembly, Stage::Shaking).unwrap();
    let dt = share * stable_step(&model, &assembly, &phase).dt;
    let mut engine = Engine::new(&model, &assembly, &phase);
    engine.hand_over(&mut state, dt);
    (model, engine, state)
}

/// What falls by its weight alone gains gt, and its energy is that of the bond and the weight, not of the load.
#[test]
fn a_block_whose_bond_breaks_falls_and_the_guard_lets_it() {
    for share in [0.9, 0.45] {
        let (model, mut engine, mut state) = at_rest(share);
        let (mut looks, mut suspected) = (0, false);
        let speed = |state: &State| {
            let falls = |n: &usize| model.mesh.nodes[model.mesh_node[*n] as usize][2] < -1e-9;
            let nodes: Vec<usize> = (0..model.mesh_node.len()).filter(falls).collect();
            nodes.iter().map(|&n| -state.du[n].0[2] / state.dt).sum::<f64>() / nodes.len() as f64
        };
        let mut last = (0.0, 0.0);
        while state.time() < 0.1 {
            engine.step(&mut state);
            if engine.watches(&state) {
                suspected |= engine.watch(&state).is_err();
                let before = state.ledger.freed;
                engine.watch_or_look(&mut state).unwrap_or_else(|halt| panic!("{halt:?}"));
                looks += u32::from(state.ledger.freed > before);
            }
            if state.time() < 0.05 {
                last = (state.time(), speed(&state));
            }
        }
        let seen = engine.finish(&mut state);
        let gained = (speed(&state) - last.1) / (state.time() - last.0);
        assert!((gained / GRAVITY - 1.0).abs() < 1e-3, "{gained}");
        assert!(suspected && (1..=12).contains(&looks), "{looks}");
        assert!(seen.balance[Line::Kinetic] > 100.0 * seen.supplied);
        assert!(seen.balance[Line::Error].abs() < 1e-3 * seen.balance[Line::Kinetic]);
    }
}

/// The same block with steps that are too long, which gain energy from nothing.
#[test]
fn what_is_unstable_is_stopped_where_a_bond_breaks_too() {
    let (_, mut engine, mut state) = at_rest(1.3);
    let halt = loop {
        assert!(state.time() < 0.1, "it must be stopped");
        engine.step(&mut state);
        if engine.watches(&state)
            && let Err(halt) = engine.watch_or_look(&mut state)
        {
            break halt;
        }
    };
    assert_eq!(halt.what, Found::Held);
    assert!(halt.found > 3.0 * halt.supplied && halt.time < 0.05, "{halt:?}");
}
