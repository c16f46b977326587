//! Interfaces in whole models: the patch test, equal bits, and the books.

use crate::block::block;
use crate::ready::Ready;
use tremolite::{Base, Body, Interface, Line, Problem, Quadrature, Side, State, elastic, interface_laws};
use tremolite_laws::{Isa, Moduli, Row, Values};
use tremolite_mesh::boxes::{BoxSpec, Distortion};

/// An interface of a law of the list between the elements of two bodies.
pub fn between(problem: &Problem, bodies: [usize; 2], law: &str, numbers: &[(&str, f64)]) -> Interface {
    let law = interface_laws().into_iter().find(|known| known.info.name == law).unwrap();
    let mut values = Values::default();
    for parameter in law.info.parameters {
        match parameter.need {
            tremolite_laws::Need::Number(x) => values = values.with(parameter.name, x),
            tremolite_laws::Need::Word(word) => {
                values.0.insert(parameter.name.into(), tremolite_laws::Value::Word(word.into()));
            }
            _ => {}
        }
    }
    let values = numbers.iter().fold(values, |values, (name, x)| values.with(name, *x));
    let sides = bodies.map(|b| problem.bodies[b].elements.clone());
    Interface::new("joint", sides, law, values)
}

pub const BANDIS: &[(&str, f64)] = &[
    ("normal_stiffness", 20e9),
    ("max_closure", 2e-3),
    ("cohesion", 0.2e6),
    ("friction_coefficient", 0.7),
    ("pressure_for_step", 10e6),
];

const YOUNG: f64 = 10e9;
const POISSON: f64 = 0.25;

/// Two distorted blocks on one another, turned and sheared so that the joint is oblique.
fn two_blocks(turned: bool) -> Problem {
    let mut spec = BoxSpec::uniform([0.0, 0.0, -2.0], [3.0, 2.0, 2.0], [3, 2, 4]);
    spec.distortion = Some(Distortion { fraction: 0.15, seed: 5, periodic: [false; 2] });
    let mut mesh = spec.mesh().unwrap();
    let level = |z: f64| if z.abs() < 0.4 { 0.0 } else { z };
    let (lower, upper): (Vec<u32>, Vec<u32>) =
        (0..mesh.elements.len() as u32).partition(|&e| tremolite::hexahedra::centroid(&mesh, e)[2] < 0.0);
    let (sin, cos) = 0.6_f64.sin_cos();
    for x in &mut mesh.nodes {
        x[2] = level(x[2]);
        if turned {
            let [a, b, c] = *x;
            let (a, c) = (cos * a - sin * c, sin * a + cos * c);
            *x = [a + 0.2 * b, cos * b - sin * c, sin * b + cos * c];
        }
    }
    let body = |name: &str, elements: Vec<u32>| Body {
        name: name.into(),
        elements,
        material: elastic(Moduli::from_young_poisson(YOUNG, POISSON)),
        density: 2700.0,
        quadrature: Quadrature::Full,
        viscosity: 0.0,
    };
    let bodies = vec![body("lower", lower), body("upper", upper)];
    let mut problem = Problem::new(mesh, bodies);
    problem.interfaces = vec![between(&problem, [0, 1], "bandis", BANDIS)];
    problem
}

/// Strain of a stress in an isotropic solid, as a matrix.
fn strain(stress: [[f64; 3]; 3], young: f64, nu: f64) -> [[f64; 3]; 3] {
    let trace = stress[0][0] + stress[1][1] + stress[2][2];
    let unit = |i: usize, j: usize| f64::from(u8::from(i == j));
    std::array::from_fn(|i| {
        std::array::from_fn(|j| ((1.0 + nu) * stress[i][j] - nu * trace * unit(i, j)) / young)
    })
}

fn apply(m: &[[f64; 3]; 3], x: [f64; 3]) -> [f64; 3] {
    m.map(|row| row[0] * x[0] + row[1] * x[1] + row[2] * x[2])
}

/// A uniform stress in both blocks, with just the gap and slip across the joint that carry it, leaves no force at any inner
/// node: the patch test across a joint.
#[test]
fn a_joint_square_or_oblique_passes_the_patch_test() {
    let stress = [[-3e6, 0.4e6, 0.2e6], [0.4e6, -2e6, -0.3e6], [0.2e6, -0.3e6, -4e6]];
    for turned in [false, true] {
        let ready = Ready::new(two_blocks(turned));
        let pairs = &ready.model.seams[0].pairs;
        assert_eq!(pairs.len(), 4 * 3);
        let (k, t) = (20e9, 2e-3);
        let m = pairs[0].normal;
        let normals: Vec<_> = pairs.iter().map(|pair| pair.normal).collect();
        assert!(normals.iter().all(|n| (0..3).all(|i| (n[i] - m[i]).abs() < 1e-12)), "{normals:?}");
        // Traction on the upper side is p m + t, and equals −σ m there.
        let traction = apply(&stress, m).map(|x| -x);
        let p = (0..3).map(|i| traction[i] * m[i]).sum::<f64>();
        assert!(p > 0.0);
        let gap = -p / (k + p / t);
        let shear_stiffness = k / (1.0 + gap / t).powi(2) / 2.5;
        let jump: [f64; 3] = std::array::from_fn(|i| gap * m[i] - (traction[i] - p * m[i]) / shear_stiffness);

        let mut state = ready.rest(0.5);
        let lower: Vec<u32> = ready.model.bodies[0].elements.clone();
        let mut below = vec![false; ready.model.mesh_node.len()];
        for &e in &lower {
            for &n in ready.model.mesh.elements[e as usize].nodes() {
                below[ready.model.engine_node[n as usize] as usize] = true;
            }
        }
        for (n, u) in state.u.iter_mut().enumerate() {
            let x = ready.model.mesh.nodes[ready.model.mesh_node[n] as usize];
            let own = apply(&strain(stress, YOUNG, POISSON), x);
            *u = Row::new(if below[n] { own } else { std::array::from_fn(|i| own[i] + jump[i]) });
        }
        let snapshot = ready.engine().finish(&mut state);
        let exterior: Vec<u32> = tremolite_mesh::topology::exterior_faces(&two_blocks(turned).mesh, None)
            .into_iter()
            .flat_map(|face| two_blocks(turned).mesh.face_nodes(face).collect::<Vec<_>>())
            .map(|n| ready.model.mesh.node_id(n as usize) as u32)
            .collect();
        let mut inner = 0;
        for (n, a) in snapshot.acceleration.iter().enumerate() {
            let id = ready.model.mesh.node_id(ready.model.mesh_node[n] as usize) as u32;
            if exterior.contains(&id) {
                continue;
            }
            inner += 1;
            let force = ready.phase.mass[n] * a.xyz().iter().fold(0.0_f64, |most, x| most.max(x.abs()));
            assert!(force < 1e-9 * 4e6, "turned {turned}: {force} N at node {id}");
        }
        assert!(inner > 3, "{inner} inner nodes, those of the joint among them");
        let history = &state.history;
        let seen = ready.assembly.contacts[0].seen(history, 0);
        assert!((seen.pressure - p).abs() < 1e-9 * p && seen.state == 0);
    }
}

/// The shaken block with a joint on both faces of its slab, through periodic sides.
pub fn jointed(isa: Isa) -> Problem {
    let mut problem = block([8, 7, 10]);
    problem.base = Base::Viscous;
    problem.isa = isa;
    let weak: Vec<_> =
        BANDIS.iter().map(|&(key, x)| (key, if key == "cohesion" { 5e3 } else { x })).collect();
    problem.interfaces = vec![between(&problem, [1, 0], "bandis", &weak)];
    problem
}

fn shaken(problem: Problem, steps: u64) -> (Ready, State) {
    let ready = Ready::new(problem);
    let mut state = ready.rest(0.9);
    let mut engine = ready.engine();
    for step in 0..steps {
        if step % 40 == 39 {
            engine.look(&state);
        }
        engine.step(&mut state);
    }
    drop(engine);
    (ready, state)
}

#[test]
fn bits_of_joints_do_not_depend_on_threads_or_the_instruction_set() {
    let (ready, scalar) = shaken(jointed(Isa::Scalar), 400);
    let totals = ready.assembly.contacts[0].totals(&ready.model.seams[0], &scalar.history);
    assert!(totals.ever_slid > 0.0 && totals.ever_opened > 0.0, "{totals:?}");
    for isa in Isa::ALL.into_iter().filter(|isa| isa.available()) {
        let (_, other) = shaken(jointed(isa), 400);
        assert!(scalar == other, "{}", isa.name());
    }
    for threads in [1, 3] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let (_, other) = pool.install(|| shaken(jointed(Isa::best()), 400));
        assert!(scalar == other, "{threads} threads");
    }
}

/// What one side is given the other loses, to the last bit: on a pair alone.
#[test]
fn the_two_sides_of_a_pair_are_pushed_by_opposite_bits() {
    let ready = Ready::new(two_blocks(true));
    let (member, slices) = ready
        .assembly
        .members
        .iter()
        .zip(&ready.assembly.slices)
        .find(|(m, _)| m.name.contains("joint"))
        .unwrap();
    let nodes = member.part.nodes();
    let mut u = vec![Row::ZERO; ready.model.mesh_node.len()];
    for (n, u) in u.iter_mut().enumerate() {
        let x = n as f64;
        *u = Row::new([1e-6 * x.sin(), 1e-6 * (2.0 * x).cos(), -1e-6 * (3.0 * x).sin()]);
    }
    let mut history = vec![tremolite_laws::Octet::ZERO; slices.history.len()];
    let mut out = vec![Row::ZERO; nodes.len()];
    let du = vec![Row::ZERO; u.len()];
    let own = tremolite::parts::Own {
        history: &mut history,
        overstress: &mut [],
        numbers: &mut [],
        reference: &mut [],
        initial: &[],
    };
    let motion = tremolite::parts::Motion::new(&u, &du);
    let tick = tremolite::parts::Tick { time: 0.0, dt: 1e-5, step: 0 };
    member.part.forces(&tick, &motion, own, &mut out, &mut tremolite::parts::Scratch::default());
    // Every node of this plane joint is in one pair.
    for pair in &ready.model.seams[0].pairs {
        let at = |node: u32| nodes.iter().position(|&n| n == ready.model.engine_node[node as usize]).unwrap();
        let [a, b] = pair.nodes.map(|n| out[at(n)].xyz());
        assert!(a.iter().zip(b).all(|(a, b)| *a == -b && *a != 0.0), "{a:?} {b:?}");
    }
}

#[test]
fn a_joint_that_sides_hold_apart_keeps_its_books() {
    let (ready, state) = shaken(jointed(Isa::best()), 400);
    let snapshot = ready.engine().look(&state).snapshot;
    let balance = &snapshot.balance;
    let input = balance[Line::Input];
    assert!(balance[Line::Friction] > 0.01 * input && balance[Line::Interface] >= 0.0, "{balance:?}");
    let error = (balance[Line::Error] - snapshot.scheme).abs();
    assert!(error < 0.02 * input, "{error} of {input}");
    assert_eq!(ready.model.boundaries.sides, [Side::Periodic; 2]);
}
