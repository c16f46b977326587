//! One assembly through the stages: what is active changes, the state's layout does not.

use crate::block::block;
use crate::ready::Ready;
use std::sync::Arc;
use tremolite::Domain;
use tremolite::checkpoint::Among;
use tremolite::phase::Drive;
use tremolite::{Assembly, Base, Engine, Life, Line, Model, Phase, Side, Stage, State, laws, stable_step};
use tremolite_laws::{Row, Value, Values};

const BEFORE: Stage = Stage::Before(0);

/// Names and lengths of the state's columns.
fn layout(state: &mut State) -> Vec<(String, usize)> {
    use tremolite::state::StateColumn;
    let length = |column: &StateColumn| match column {
        StateColumn::Count(_) => 1,
        StateColumn::Numbers(values) => values.len(),
        StateColumn::Rows(rows) | StateColumn::SomeRows(rows) => rows.len(),
        StateColumn::Octets(octets) => octets.len(),
        StateColumn::Scalars(values) => values.len(),
    };
    state.columns().iter().map(|(name, _, column)| (name.clone(), length(column))).collect()
}

/// The slab is installed with the shaking: before it pushes nothing, weighs nothing and holds nothing, and the state is
/// the same vectors.
#[test]
fn a_body_that_is_born_with_the_shaking_is_absent_before_and_no_column_moves() {
    // Of so many layers the distorted slab has not everywhere the same, so the ground differs between corners.
    let mut problem = block([6, 5, 14]);
    problem.base = Base::Viscous;
    let model = Model::new(problem).unwrap();
    let mut assembly = Assembly::new(&model).unwrap();
    for member in &mut Arc::get_mut(&mut assembly).unwrap().members {
        if member.counted && member.name == "slab" {
            member.life = Life::SHAKING;
        }
    }
    let before = Phase::of(&model, &assembly, BEFORE).unwrap();
    let shaking = Phase::of(&model, &assembly, Stage::Shaking).unwrap();
    let mass = |phase: &Phase| model.nodes.of(Domain::Model).map(|n| phase.mass[n]).sum::<f64>();
    let slab: f64 = model.bodies[1]
        .elements
        .iter()
        .map(|&e| 2700.0 * tremolite::hexahedra::hex(&model.mesh, e as usize).unwrap().volume)
        .sum();
    assert!((mass(&shaking) - mass(&before) - slab).abs() < 1e-9 * mass(&shaking));
    assert_eq!(before.counted_elements + model.bodies[1].elements.len(), shaking.counted_elements);
    assert_eq!(shaking.counted_elements, model.user.elements, "the column's do not count");

    // The rock below is pressed down on its fixed base; above the gap nothing holds, and the slab's inner nodes stay.
    let mut state = assembly.rest();
    let columns = layout(&mut state);
    state.dt = 0.9 * stable_step(&model, &assembly, &before).dt;
    let mut engine = Engine::new(&model, &assembly, &before);
    let push = |n: usize| {
        let [x, _, z] = model.mesh.nodes[model.mesh_node[n] as usize];
        Row::new([0.0, 0.0, if z < 5.0 { -1e-4 * z * (1.0 + 0.1 * x) } else { 0.0 }])
    };
    let (u, still) = ((0..state.u.len()).map(push).collect(), vec![Row::ZERO; state.u.len()]);
    engine.start(&mut state, u, &still);
    let first = state.u.clone();
    for _ in 0..200 {
        engine.step(&mut state);
    }
    let snapshot = engine.look(&state).snapshot;
    assert!(snapshot.balance[Line::Strain] > 0.0);
    let moved = |n: usize| state.u[n] != first[n];
    assert!(model.nodes.of(Domain::Model).any(moved));
    let alone: Vec<usize> = model
        .nodes
        .of(Domain::Model)
        .filter(|&n| before.master[n] as usize == n && before.mass[n] == 0.0)
        .collect();
    assert!(!alone.is_empty() && !alone.iter().any(|&n| moved(n)), "nodes of the slab alone sleep");
    for &element in &model.bodies[1].elements {
        let slot = shaking.element_slot[element as usize].unwrap();
        assert_eq!(snapshot.energy[slot.element as usize].held(), 0.0);
        assert!(before.element_slot[element as usize].is_none());
    }

    // Into the earthquake: the same state, its time counted anew.
    let dt = 0.2 * stable_step(&model, &assembly, &shaking).dt;
    state.begin(dt);
    assert_eq!((state.step, state.steps(), state.time()), (200, 0, 0.0));
    assert_eq!(layout(&mut state), columns);
    let mut engine = Engine::new(&model, &assembly, &shaking);
    let (u, still) = (state.u.clone(), vec![Row::ZERO; state.u.len()]);
    engine.start(&mut state, u, &still);
    // The balance begins anew with what is held: nothing of the stage's books is left in it.
    let snapshot = engine.look(&state).snapshot;
    let held = snapshot.balance[Line::Initial];
    assert!(held > 0.0 && snapshot.balance[Line::Error].abs() < 1e-9 * held, "{:?}", snapshot.balance);
    assert_eq!((snapshot.step, snapshot.time), (0, 0.0));
    for _ in 0..100 {
        engine.step(&mut state);
    }
    let error = engine.look(&state).snapshot.balance[Line::Error];
    // ⅛Δt²aᵀMa of the scheme: with all energy at the mesh's highest frequency (ωΔt/2)² of it, 0.04 here.
    assert!(error.abs() < 0.04 * held, "{error:e} of {held:e} J");
    assert_eq!((state.step, state.time()), (300, 100.0 * dt));
    assert_eq!(layout(&mut state), columns);
    assert!(alone.iter().all(|&n| shaking.mass[n] > 0.0));
}

/// Before the shaking, whatever the sides are in it: a fixed base, the column's too, rollers, nothing that absorbs; single
/// nodes stay held, and time is 0.
#[test]
fn supports_before_the_shaking_are_a_fixed_base_and_rollers_and_absorb_nothing() {
    for side in Side::EXAMPLES {
        let mut problem = block([5, 4, 6]);
        problem.sides = [side; 2];
        let top = |x: &[f64; 3]| x[2] == 14.0;
        let single = problem.mesh.nodes.iter().position(top).unwrap() as u32;
        problem.held = vec![(single, [false, false, true])];
        let ready = Ready::new(problem);
        let before = Phase::of(&ready.model, &ready.assembly, BEFORE).unwrap();
        assert_eq!((before.drive, ready.phase.drive), (Drive::Quasistatic, Drive::Dynamic));
        assert!(before.dashpots.is_empty() && !ready.phase.dashpots.is_empty());
        let mut state = ready.rest(0.9);
        state.step = 7;
        let tick = before.tick(&state);
        assert_eq!((tick.time, tick.dt), (0.0, 0.0));
        assert!(ready.phase.tick(&state).time > 0.0);
        let springs = |m: &u32| ready.assembly.members[*m as usize].name == "springs of the base";
        assert!(!before.active.iter().any(springs) && ready.phase.active.iter().any(springs));
        let columns = &ready.model.outside.columns;
        let of = |node: u32| before.master[ready.model.engine_node[node as usize] as usize] as usize;
        for n in 0..ready.model.mesh_node.len() {
            let mesh_node = ready.model.mesh_node[n];
            let [x, y, z] = ready.model.mesh.nodes[mesh_node as usize];
            let master = before.master[n] as usize;
            let held = before.inverse_mass[master].xyz().map(|w| w == 0.0);
            let base = z == 0.0;
            let on = [x == 0.0 || x == 12.0, y == 0.0 || y == 10.0];
            let expected = if n >= ready.model.nodes.of(Domain::Model).count() {
                if side == Side::FreeField && !base {
                    // The ends of slabs rest on rollers of their own.
                    assert!(!held[2]);
                    continue;
                }
                let rings = || columns.iter().flat_map(|column| &column.rings);
                assert!(side == Side::FreeField || rings().any(|ring| master == of(ring[0])));
                [base; 3]
            } else {
                match side.before() {
                    Side::Periodic => [base, base, base || mesh_node == single],
                    Side::Fixed => [base || on[0] || on[1]; 3],
                    _ => [base || on[0], base || on[1], base],
                }
            };
            // The held node and what is tied to it.
            let expected = if master == of(single) { [expected[0], expected[1], true] } else { expected };
            assert_eq!(held, expected, "{side:?}: ({x}, {y}, {z})");
        }
    }
}

/// Concrete whose strength grows with the rate, pulled quickly: while time stands still for the law it cracks at its
/// static strength, though the scheme makes the same steps.
#[test]
fn time_stands_still_for_laws_before_the_shaking_while_the_scheme_goes_on() {
    let mut values = Values::default()
        .with("young", 25e9)
        .with("poisson", 0.17)
        .with("tensile_strength", 1.2e6)
        .with("cohesion", 2e6)
        .with("friction_angle", 0.8)
        .with("residual_tension", 0.1);
    for (key, word) in [("evolution", "residual"), ("split", "effective")] {
        values.0.insert(key.into(), Value::Word(word.into()));
    }
    let concrete = laws().into_iter().find(|l| l.info.name == "concrete-damage").unwrap();
    let strength = |stage: Stage| {
        let mut problem = block([3, 3, 4]);
        for body in &mut problem.bodies {
            body.material = (concrete.build)(&values).unwrap();
        }
        problem.incident = None;
        let model = Model::new(problem).unwrap();
        let assembly = Assembly::new(&model).unwrap();
        let phase = Phase::of(&model, &assembly, stage).unwrap();
        let mut state = assembly.rest();
        state.dt = 1e-5;
        let mut engine = Engine::new(&model, &assembly, &phase);
        // All points are strained alike, 10 per second along z; s1 peaks where they crack.
        let mut most = 0.0_f64;
        for step in 0..12 {
            let strain = 10.0 * f64::from(step) * state.dt;
            state.u = (0..state.u.len())
                .map(|n| {
                    let z = model.mesh.nodes[model.mesh_node[n] as usize][2];
                    Row::new([0.0, 0.0, strain * z])
                })
                .collect();
            let snapshot = engine.look(&state).snapshot;
            let slots = phase.element_slot.iter().flatten();
            let first = slots.map(|slot| snapshot.stress[slot.point as usize][2]).fold(0.0, f64::max);
            most = most.max(first);
            state.step += 1;
        }
        most
    };
    let (before, shaking) = (strength(BEFORE), strength(Stage::Shaking));
    assert!(shaking > 1.05 * before, "{before:e} {shaking:e} Pa");
}

/// Rock that has yielded and cracked before: what it spent then is no part of the balance that begins.
#[test]
fn what_was_spent_before_a_start_is_neither_in_the_balance_nor_its_error() {
    let values = Values::default()
        .with("young", 1e9)
        .with("poisson", 0.25)
        .with("cohesion", 2e4)
        .with("friction_angle", 0.7)
        .with("dilation_angle", 0.0)
        .with("tensile_strength", 1e4);
    let rock = laws().into_iter().find(|l| l.info.name == "mohr-coulomb").unwrap();
    let mut problem = block([5, 4, 6]);
    problem.bodies.iter_mut().for_each(|body| body.material = (rock.build)(&values).unwrap());
    let ready = Ready::new(problem);
    let mut state = ready.rest(0.5);
    let mut engine = ready.engine();
    while state.time() < 0.2 {
        engine.step(&mut state);
    }
    let spent = engine.look(&state).snapshot.balance[Line::Dissipated];
    let dt = state.dt;
    state.begin(dt);
    let mut engine = ready.engine();
    let (u, still) = (state.u.clone(), vec![Row::ZERO; state.u.len()]);
    engine.start(&mut state, u, &still);
    let balance = engine.look(&state).snapshot.balance;
    let held = balance[Line::Initial];
    assert!(spent > 0.0 && held > 0.0);
    assert!(balance[Line::Dissipated].abs() < 1e-9 * spent, "{balance:?}");
    assert!(balance[Line::Error].abs() < 1e-9 * (held + spent), "{balance:?}");
}

#[test]
fn a_checkpoint_keeps_the_step_at_which_the_earthquake_began() {
    let folder = tempfile::tempdir().unwrap();
    let ready = Ready::new(block([3, 3, 4]));
    let mut state = ready.rest(0.9);
    let mut engine = ready.engine();
    (0..5).for_each(|_| engine.step(&mut state));
    let dt = state.dt;
    state.begin(dt);
    (0..3).for_each(|_| engine.step(&mut state));
    tremolite::checkpoint::write(folder.path(), &mut state, 1, &Among(None)).unwrap();
    let mut read = ready.rest(0.9);
    tremolite::checkpoint::read(folder.path(), &mut read, 1, &Among(None)).unwrap();
    assert!(read == state);
    assert_eq!((read.step, read.steps(), read.time()), (8, 3, 3.0 * dt));
}
