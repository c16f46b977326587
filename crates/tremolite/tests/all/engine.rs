//! The step's promises: bits, rest, balance, ties.

use crate::block::block;
use crate::ready::Ready;
use tremolite::Domain;
use tremolite::{Incident, Line, Problem, Side, State};
use tremolite_laws::{Isa, Row};
use tremolite_motion::{Motion, ricker_velocity};

fn pool<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(work)
}

/// State and observed balance after some steps, observing on the way.
fn run(problem: Problem, steps: u64) -> (State, Vec<u64>, usize) {
    let ready = Ready::new(problem);
    let mut state = ready.rest(0.9);
    let mut engine = ready.engine();
    let mut balances = Vec::new();
    for step in 0..steps {
        if step % 40 == 39 {
            let snapshot = engine.look(&state).snapshot;
            balances.extend(snapshot.balance.iter().map(|(_, x)| x.to_bits()));
            balances.extend(snapshot.stress.iter().flatten().map(|x| x.to_bits()));
        }
        engine.step(&mut state);
    }
    (state, balances, ready.model.patches.len())
}

#[test]
fn bits_do_not_depend_on_the_number_of_threads() {
    for stiffness in [0.0, 1e-5] {
        let shaken = || {
            let mut problem = block([10, 9, 12]);
            problem.rayleigh.stiffness = stiffness;
            problem.patch_elements = Some(16);
            run(problem, 120)
        };
        let (one, balances, patches) = pool(1, shaken);
        assert!(patches >= 50, "{patches} patches are too few to prove anything");
        assert!(one.u.iter().any(|u| u.0[0].abs() > 1e-4), "the block moves");
        for threads in [2, 3, 7] {
            let (other, others, _) = pool(threads, shaken);
            assert!(one == other, "{threads} threads");
            assert!(balances == others, "{threads} threads: what observers see");
        }
    }
}

#[test]
fn bits_do_not_depend_on_the_instruction_set() {
    let shaken = |isa| {
        let mut problem = block([8, 7, 10]);
        problem.isa = isa;
        run(problem, 120)
    };
    let (scalar, balances, _) = shaken(Isa::Scalar);
    for isa in Isa::ALL.into_iter().filter(|isa| isa.available()) {
        let (other, others, _) = shaken(isa);
        assert!(scalar == other, "{}", isa.name());
        assert!(balances == others, "{}", isa.name());
    }
}

#[test]
fn without_input_everything_stays_at_rest_exactly() {
    let mut problem = block([5, 4, 6]);
    problem.incident = None;
    let (state, ..) = run(problem, 200);
    assert!(state.u.iter().chain(&state.du).all(|r| r.0 == [0.0; 4]));
}

#[test]
fn periodic_sides_move_as_one() {
    let ready = Ready::new(block([6, 5, 7]));
    let mut state = ready.rest(0.9);
    let mut engine = ready.engine();
    for _ in 0..150 {
        engine.step(&mut state);
    }
    let model = &ready.model;
    let find = |x: f64, y: f64, z: f64| {
        let near = |p: &[f64; 3]| (p[0] - x).abs() + (p[1] - y).abs() + (p[2] - z).abs() < 1e-9;
        let mesh_node = model.mesh.nodes[..model.user.nodes].iter().position(near).unwrap();
        state.u[model.engine_node[mesh_node] as usize]
    };
    let corners =
        [find(0.0, 0.0, 14.0), find(12.0, 0.0, 14.0), find(0.0, 10.0, 14.0), find(12.0, 10.0, 14.0)];
    assert!(corners[0].0[0].abs() > 1e-5);
    assert!(corners.iter().all(|c| *c == corners[0]));
}

/// What is found less what was put in, over all that was put in, goes with Δt²: it is the difference of the scheme's
/// own energy, which is kept exactly, from the physical one.
#[test]
fn energy_balance_closes_with_the_second_order_of_the_step() {
    for sides in Side::EXAMPLES {
        let error = |safety: f64| {
            let mut problem = block([6, 5, 7]);
            problem.sides = [sides; 2];
            problem.rayleigh.mass = 3.0;
            let ready = Ready::new(problem);
            let mut state = ready.rest(safety);
            let mut engine = ready.engine();
            let (mut worst, mut supplied) = (0.0_f64, 0.0);
            while state.time() < 0.3 {
                let seen = engine.look(&state).snapshot;
                worst = worst.max(seen.balance[Line::Error].abs());
                supplied = f64::max(supplied, seen.supplied);
                engine.step(&mut state);
            }
            worst / supplied
        };
        let (coarse, fine) = (error(0.4), error(0.1));
        let order = (coarse / fine).log2() / 2.0;
        assert!(coarse < 0.01, "{sides:?}: {coarse:e}");
        assert!((order - 2.0).abs() < 0.1, "{sides:?}: order {order:.2} from {coarse:e} to {fine:e}");
    }
}

#[test]
fn nodes_that_a_problem_ties_move_as_one() {
    let mut problem = block([4, 3, 5]);
    let at = |x: f64, y: f64| {
        let near = |p: &[f64; 3]| (p[0] - x).abs() + (p[1] - y).abs() + (p[2] - 14.0).abs() < 1e-9;
        problem.mesh.nodes.iter().position(near).unwrap() as u32
    };
    let (a, b) = (at(0.0, 0.0), at(12.0, 10.0));
    problem.sides = [Side::Free; 2];
    let moved = |problem: Problem| {
        let ready = Ready::new(problem);
        let mut state = ready.rest(0.9);
        let mut engine = ready.engine();
        (0..200).for_each(|_| engine.step(&mut state));
        [a, b].map(|n| state.u[ready.model.engine_node[n as usize] as usize])
    };
    let [free_a, free_b] = moved(problem.clone());
    assert_ne!(free_a, free_b);
    problem.ties = vec![(a, b)];
    let [tied_a, tied_b] = moved(problem);
    assert_eq!(tied_a, tied_b);
    assert_ne!(tied_a, Row::ZERO);
}

#[test]
fn held_components_do_what_they_say() {
    let mut problem = block([4, 3, 5]);
    problem.sides = [Side::Roller, Side::Fixed];
    let ready = Ready::new(problem);
    let mut state = ready.rest(0.9);
    let mut engine = ready.engine();
    for _ in 0..200 {
        engine.step(&mut state);
    }
    let model = &ready.model;
    let mut slid = 0.0_f64;
    for (node, u) in state.u.iter().enumerate().take(model.nodes.of(Domain::Model).count()) {
        let [x, y, _] = model.mesh.nodes[model.mesh_node[node] as usize];
        if y == 0.0 || y == 10.0 {
            assert_eq!(*u, Row::ZERO);
        } else if x == 0.0 || x == 12.0 {
            assert_eq!(u.0[0], 0.0);
            slid = slid.max(u.0[2].abs());
        }
    }
    assert!(slid > 1e-6, "a roller slides");
}

/// A record may begin with noise that changes its sign within a few steps: what it does to the base before its work is booked is
/// no instability.
#[test]
fn noise_at_the_beginning_of_a_record_halts_nothing() {
    let longest = Ready::new(block([2, 2, 3])).rest(0.9).dt;
    for part in [0.5, 1.0, 1.5, 2.0, 3.0, 6.0] {
        let dt = part * longest;
        let pulse = ricker_velocity(12.0, 0.2, 0.3);
        let mut acceleration: Vec<f64> = (0..600).map(|k| pulse(f64::from(k) * dt).a).collect();
        for (k, a) in acceleration.iter_mut().enumerate().take(12) {
            *a = 1e-9 * [0.3, -1.0, 0.2, 0.9, -0.8][k % 5];
        }
        let motion =
            Motion::from_acceleration(dt, [acceleration.clone(), vec![0.0; 600], acceleration]).unwrap();
        let mut problem = block([2, 2, 3]);
        problem.incident = Some(Incident { motion, factor: 1.0 });
        let ready = Ready::new(problem);
        let (mut state, mut engine) = (ready.rest(0.9), ready.engine());
        for step in 0..200 {
            let seen = engine.look(&state).snapshot;
            engine.guard(&seen).unwrap_or_else(|halt| panic!("step {step}, {part} steps a sample: {halt:?}"));
            engine.step(&mut state);
        }
    }
}
