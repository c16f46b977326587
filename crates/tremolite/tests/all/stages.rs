//! One assembly through the stages: what is active changes, the state's layout does not.

use crate::block::block;
use crate::ready::Ready;
use tremolite::phase::Drive;
use tremolite::{Assembly, Engine, Life, Line, Model, Phase, Stage, State, laws, stable_step};
use tremolite_laws::{Row, Values};

const BEFORE: Stage = Stage::Before(0);

/// Names and lengths of the state's columns.
fn layout(state: &mut State) -> Vec<(String, usize)> {
    use tremolite::state::Column;
    let length = |column: &Column| match column {
        Column::Count(_) => 1,
        Column::Numbers(values) => values.len(),
        Column::Rows(rows) => rows.len(),
        Column::Octets(octets) => octets.len(),
        Column::Scalars(values) => values.len(),
    };
    state.columns().iter().map(|(name, _, column)| (name.clone(), length(column))).collect()
}

/// The slab is installed with the shaking: before it pushes nothing, weighs nothing and holds nothing, and the state is
/// the same vectors.
#[test]
fn a_body_that_is_born_with_the_shaking_is_absent_before_and_no_column_moves() {
    let model = Model::new(block([6, 5, 14])).unwrap();
    let mut assembly = Assembly::new(&model).unwrap();
    for (member, patch) in assembly.members.iter_mut().zip(&model.patches[..model.user_patches]) {
        if model.bodies[patch.body].name == "slab" {
            member.life = Life::SHAKING;
        }
    }
    let before = Phase::of(&model, &assembly, BEFORE).unwrap();
    let shaking = Phase::of(&model, &assembly, Stage::Shaking).unwrap();
    let mass = |phase: &Phase| model.counted.clone().map(|n| phase.mass[n]).sum::<f64>();
    let slab: f64 = model.bodies[1]
        .elements
        .iter()
        .map(|&e| 2700.0 * tremolite::hexahedra::hex(&model.mesh, e as usize).unwrap().volume)
        .sum();
    assert!((mass(&shaking) - mass(&before) - slab).abs() < 1e-9 * mass(&shaking));
    assert!(before.counted_elements + model.bodies[1].elements.len() == shaking.counted_elements);

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
        engine.step(&mut state).unwrap();
    }
    let snapshot = engine.observe(&mut state);
    assert!(snapshot.balance[Line::Strain] > 0.0);
    let moved = |n: usize| state.u[n] != first[n];
    assert!(model.counted.clone().any(moved));
    let alone: Vec<usize> =
        model.counted.clone().filter(|&n| before.master[n] as usize == n && before.mass[n] == 0.0).collect();
    assert!(!alone.is_empty() && !alone.iter().any(|&n| moved(n)), "nodes of the slab alone sleep");
    for &element in &model.bodies[1].elements {
        let slot = shaking.element_slot[element as usize].unwrap();
        assert_eq!(snapshot.energy[slot.element as usize].held(), 0.0);
        assert!(before.element_slot[element as usize].is_none());
    }

    // Into the earthquake: the same state, its time counted anew.
    let dt = 0.9 * stable_step(&model, &assembly, &shaking).dt;
    state.begin(dt);
    assert_eq!((state.step, state.steps(), state.time()), (200, 0, 0.0));
    assert_eq!(layout(&mut state), columns);
    let mut engine = Engine::new(&model, &assembly, &shaking);
    let (u, still) = (state.u.clone(), vec![Row::ZERO; state.u.len()]);
    engine.start(&mut state, u, &still);
    for _ in 0..100 {
        engine.step(&mut state).unwrap();
    }
    assert_eq!((state.step, state.time()), (300, 100.0 * dt));
    assert_eq!(layout(&mut state), columns);
    assert!(alone.iter().all(|&n| shaking.mass[n] > 0.0));
}

#[test]
fn supports_before_the_shaking_are_a_fixed_base_and_rollers_and_absorb_nothing() {
    let mut problem = block([5, 4, 6]);
    problem.sides = [tremolite::Side::Viscous; 2];
    let ready = Ready::new(problem);
    let before = Phase::of(&ready.model, &ready.assembly, BEFORE).unwrap();
    assert_eq!((before.drive, ready.phase.drive), (Drive::Quasistatic, Drive::Dynamic));
    assert!(before.dashpots.is_empty() && !ready.phase.dashpots.is_empty());
    for n in ready.model.counted.clone() {
        let [x, y, z] = ready.model.mesh.nodes[ready.model.mesh_node[n] as usize];
        let free = |phase: &Phase| phase.inverse_mass[n].xyz().map(|w| w > 0.0);
        let base = z == 0.0;
        let held = [base || x == 0.0 || x == 12.0, base || y == 0.0 || y == 10.0, base];
        assert_eq!(free(&before), held.map(|held| !held), "({x}, {y}, {z})");
        assert_eq!(free(&ready.phase), [true; 3]);
    }
}

/// Concrete whose strength grows with the rate, pulled quickly: while time stands still for the law it cracks at its
/// static strength, though the scheme makes the same steps.
#[test]
fn time_stands_still_for_laws_before_the_shaking_while_the_scheme_goes_on() {
    let values = Values::default()
        .with("young", 25e9)
        .with("poisson", 0.17)
        .with("tensile_strength", 1.2e6)
        .with("cohesion", 2e6)
        .with("friction_angle", 0.8)
        .with("residual_tension", 0.1);
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
            let snapshot = engine.observe(&mut state);
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
