//! Relaxation before the shaking: statics by the same parts as the earthquake.

use crate::contact::between;
use std::sync::Arc;
use tremolite::engine::{Release, Rest};
use tremolite::parts::loads::Load;
use tremolite::{Assembly, Body, Engine, Model, Phase, Problem, Quadrature, Side, Stage, State, elastic};
use tremolite_laws::{Isa, Moduli};
use tremolite_mesh::boxes::{BoxSpec, Distortion};

const DENSITY: f64 = 2500.0;
const GRAVITY: f64 = 9.81;

/// The weight of a problem's elements, as loads on their nodes.
fn weight(problem: &mut Problem) {
    let mut forces = std::collections::BTreeMap::<u32, f64>::new();
    for body in &problem.bodies {
        for &e in &body.elements {
            let hex = tremolite::hexahedra::hex(&problem.mesh, e as usize).unwrap();
            let nodes = tremolite::hexahedra::hex_nodes(&problem.mesh, e as usize);
            for (node, volume) in nodes.into_iter().zip(hex.corner_volumes) {
                *forces.entry(node).or_default() -= body.density * GRAVITY * volume;
            }
        }
    }
    let forces = forces.into_iter().map(|(node, force)| (node, [0.0, 0.0, force])).collect();
    problem.loads = vec![Load { forces, factor: Arc::new(|_| 1.0) }];
}

/// Layered ground of 6 × 4 × 20 m under its own weight.
fn ground(distorted: f64, isa: Isa) -> Problem {
    let mut spec = BoxSpec::uniform([0.0; 3], [6.0, 4.0, 20.0], [3, 2, 10]);
    spec.distortion =
        (distorted > 0.0).then_some(Distortion { fraction: distorted, seed: 11, periodic: [false; 2] });
    let mesh = spec.mesh().unwrap();
    let centre = |e: u32| tremolite::hexahedra::centroid(&mesh, e)[2];
    let (lower, upper): (Vec<u32>, Vec<u32>) =
        (0..mesh.elements.len() as u32).partition(|&e| centre(e) < 8.0);
    let body = |name: &str, elements, young| Body {
        name: name.into(),
        elements,
        material: elastic(Moduli::from_young_poisson(young, 0.25)),
        density: DENSITY,
        quadrature: Quadrature::OnePoint,
        viscosity: 0.0,
    };
    let bodies = vec![body("lower", lower, 10e9), body("upper", upper, 2e9)];
    let mut problem = Problem::new(mesh, bodies);
    problem.sides = [Side::Roller; 2];
    problem.isa = isa;
    weight(&mut problem);
    problem
}

struct Relaxed {
    model: Arc<Model>,
    assembly: Arc<Assembly>,
    state: State,
    rest: Result<Rest, Rest>,
}

fn relax(problem: Problem, release: Release) -> Relaxed {
    let model = Model::new(problem).unwrap();
    let assembly = Assembly::new(&model).unwrap();
    let phase = Phase::of(&model, &assembly, Stage::Before(0)).unwrap();
    let mut state = assembly.rest();
    let rest = Engine::new(&model, &assembly, &phase).relax(&mut state, &release);
    Relaxed { model, assembly, state, rest }
}

/// Settlement \[m\] of the layered column at a height, exact at nodes: ∫ ρg(H − z)/(λ + 2μ) dz.
fn settlement(z: f64) -> f64 {
    let modulus = |young: f64| {
        let m = Moduli::from_young_poisson(young, 0.25);
        m.lambda + 2.0 * m.mu
    };
    let part = |from: f64, to: f64, young: f64| {
        DENSITY * GRAVITY / modulus(young) * (20.0 * (to - from) - 0.5 * (to * to - from * from))
    };
    part(0.0, z.min(8.0), 10e9) + if z > 8.0 { part(8.0, z, 2e9) } else { 0.0 }
}

#[test]
fn layered_ground_settles_under_its_weight_as_the_integral_says() {
    let relaxed = relax(ground(0.0, Isa::best()), Release::default());
    let rest = relaxed.rest.unwrap();
    let top = settlement(20.0);
    let mut worst = 0.0_f64;
    for (n, u) in relaxed.state.u.iter().enumerate() {
        let [_, _, z] = relaxed.model.mesh.nodes[relaxed.model.mesh_node[n] as usize];
        worst = worst.max((u.0[2] + settlement(z)).abs()).max(u.0[0].abs()).max(u.0[1].abs());
    }
    assert!(worst < 1e-3 * top, "{worst} of {top} m, {rest:?}");
    assert!(rest.cycles < 1500 && rest.ratio < 1e-5 && (rest.motion - top).abs() < 1e-3 * top, "{rest:?}");
    assert_eq!(relaxed.state.du.iter().filter(|du| du.0 != [0.0; 4]).count(), 0);

    // Ten times nearer, ten times better: the tolerance is what is left, not the mesh.
    let closer = Release { tolerance: [1e-8, 1e-6], ..Release::default() };
    let relaxed = relax(ground(0.0, Isa::best()), closer);
    let found = relaxed.state.u.iter().map(|u| u.0[2]).fold(0.0, f64::min);
    assert!((found + top).abs() < 1e-6 * top, "{found} {top}");
}

#[test]
fn what_is_let_go_of_a_load_moves_that_share_and_the_rest_stays_held() {
    let close = Release { tolerance: [1e-9, 1e-7], ..Release::default() };
    let whole = relax(ground(0.2, Isa::best()), close).state;
    let part = relax(ground(0.2, Isa::best()), Release { share: 0.3, ..close });
    let top = settlement(20.0);
    for (whole, part) in whole.u.iter().zip(&part.state.u) {
        for i in 0..3 {
            assert!((0.3 * whole.0[i] - part.0[i]).abs() < 1e-6 * top);
        }
    }
    let held = |state: &State| state.held.iter().map(|h| h.0[2]).sum::<f64>();
    let weight = DENSITY * GRAVITY * 6.0 * 4.0 * 20.0;
    assert!((held(&part.state) - 0.7 * weight).abs() < 1e-9 * weight && held(&whole) == 0.0);
    // Nothing let go, nothing moves.
    let none = relax(ground(0.2, Isa::best()), Release { share: 0.0, ..close }).state;
    assert!(none.u.iter().all(|u| u.0 == [0.0; 4]));
}

#[test]
fn bits_of_a_relaxation_do_not_depend_on_threads_or_the_instruction_set_or_a_stop() {
    let release = Release { most: 150, ..Release::default() };
    let one = |isa, threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| relax(ground(0.2, isa), release).state)
    };
    let scalar = one(Isa::Scalar, 1);
    assert!(scalar.relaxing.cycle == 150 && scalar.u.iter().any(|u| u.0[2] < 0.0));
    for isa in Isa::ALL.into_iter().filter(|isa| isa.available()) {
        assert!(scalar == one(isa, 2), "{}", isa.name());
    }
}

/// What presses on a joint is the weight above it, and the closure is the law's.
#[test]
fn a_joint_carries_the_weight_above_it() {
    let mut problem = ground(0.0, Isa::best());
    let bandis = [
        ("normal_stiffness", 5e9),
        ("max_closure", 1e-3),
        ("friction_coefficient", 0.6),
        ("pressure_for_step", 10e6),
    ];
    problem.interfaces = vec![between(&problem, [0, 1], "bandis", &bandis)];
    let close = Release { tolerance: [1e-7, 1e-5], ..Release::default() };
    let relaxed = relax(problem, close);
    let rest = relaxed.rest.unwrap();
    // Loads at nodes that are split act on the second side: half a layer of the lower block's weight is there as well.
    let pressure = DENSITY * GRAVITY * 13.0;
    let gap = -pressure / (5e9 + pressure / 1e-3);
    for k in 0..relaxed.model.seams[0].pairs.len() {
        let seen = relaxed.assembly.contacts[0].seen(&relaxed.state.history, k);
        assert!((seen.pressure - pressure).abs() < 1e-4 * pressure, "{seen:?} {rest:?}");
        assert!((seen.gap - gap).abs() < 1e-4 * gap.abs() && seen.state == 1, "{seen:?}");
    }
}

#[test]
fn what_cannot_come_to_rest_says_how_far_it_is() {
    let far = Release { most: 40, ..Release::default() };
    let rest = relax(ground(0.0, Isa::best()), far).rest.unwrap_err();
    assert!(rest.cycles == 40 && rest.motion > 0.0, "{rest:?}");
    // A slab that nothing holds up falls for ever.
    let mut problem = ground(0.0, Isa::best());
    problem.bodies[0].elements.retain(|&e| tremolite::hexahedra::centroid(&problem.mesh, e)[2] < 6.0);
    weight(&mut problem);
    let fall = relax(problem, Release { most: 2000, ..Release::default() }).rest.unwrap_err();
    assert!(fall.motion > 1.0 && fall.ratio > 1e-5, "{fall:?}");
}
