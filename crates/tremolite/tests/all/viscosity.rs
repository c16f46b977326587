//! Artificial viscosity: it damps an element's highest mode by its share, bounds the step as it says, and books what it takes.

use crate::block::block;
use crate::contact::jointed;
use crate::ready::Ready;
use tremolite::engine::viscous_share;
use tremolite::parts::{Kept, Scratch};
use tremolite::{Base, Body, Problem, Quadrature, Side, elastic, laws, stable_step, sure_step};
use tremolite_kernels::Line;
use tremolite_laws::{Moduli, Octet, Row, Value, Values};
use tremolite_mesh::boxes::{BoxSpec, Distortion};

const QUADRATURES: [Quadrature; 2] = [Quadrature::OnePoint, Quadrature::Full];

/// A box of free elements, moved at random.
fn shaken(elements: [u32; 3], quadrature: Quadrature, viscosity: f64) -> Ready {
    let mut spec = BoxSpec::uniform([0.0; 3], elements.map(f64::from), elements);
    spec.distortion = Some(Distortion { fraction: 0.1, seed: 3, periodic: [false; 2] });
    let mesh = spec.mesh().unwrap();
    let body = Body {
        name: "box".into(),
        elements: (0..mesh.elements.len() as u32).collect(),
        material: elastic(Moduli::from_young_poisson(1e9, 0.2)),
        density: 2500.0,
        quadrature,
        viscosity,
    };
    Ready::new(Problem::new(mesh, vec![body]))
}

fn random(n: usize) -> Row {
    Row::new([1.0, 2.0, 3.0].map(|i: f64| (12.9898 * (n as f64 + 64.0 * i)).sin()))
}

/// Kinetic energy over the first after so many steps, or none if the guard stops them there.
fn left_after(ready: &Ready, factor: f64, steps: usize) -> Option<f64> {
    let mut state = ready.rest(factor);
    let velocities: Vec<Row> = (0..state.u.len()).map(random).collect();
    let mut engine = ready.engine();
    let at_rest = state.u.clone();
    engine.start(&mut state, at_rest, &velocities);
    let supplied = state.ledger.supplied;
    for _ in 0..steps {
        engine.step(&mut state);
    }
    let seen = engine.look(&state).snapshot;
    engine.guard(&seen).ok()?;
    Some(seen.balance[Line::Kinetic] / supplied)
}

#[test]
fn the_step_is_what_viscosity_leaves_and_no_longer() {
    for quadrature in QUADRATURES {
        // One element moves in its highest mode: the share of the step is exact.
        let one = shaken([1, 1, 1], quadrature, 0.3).stable();
        let undamped = shaken([1, 1, 1], quadrature, 0.0).stable();
        assert!(
            (one / undamped / viscous_share(0.3) - 1.0).abs() < 2e-3,
            "{quadrature:?}: {one} of {undamped}"
        );
        let many = shaken([4, 4, 4], quadrature, 0.3);
        assert!(left_after(&many, 0.999, 4000).is_some(), "{quadrature:?}: stable");
        // The estimate is on the safe side of the many elements' own limit.
        assert!(
            left_after(&many, 1.03, 20_000).is_none(),
            "{quadrature:?}: the guard stops what is too long"
        );
    }
}

#[test]
fn the_highest_mode_of_an_element_is_damped_by_the_share() {
    for quadrature in QUADRATURES {
        let ready = shaken([1, 1, 1], quadrature, 0.06);
        let mut state = ready.rest(0.01);
        let (dt, omega) = (state.dt, 2.0 / shaken([1, 1, 1], quadrature, 0.0).stable());
        // The mode by power iteration with the model's own forces: M⁻¹K w from a small displacement.
        let plain = shaken([1, 1, 1], quadrature, 0.0);
        let mut mode: Vec<Row> = (0..8).map(random).collect();
        for _ in 0..2000 {
            let mut probe = plain.rest(0.01);
            let mut engine = plain.engine();
            let still = vec![Row::ZERO; 8];
            engine.start(&mut probe, mode.clone(), &still);
            let a = engine.look(&probe).snapshot.acceleration;
            let size = a.iter().flat_map(|r| r.0).fold(0.0_f64, |m, x| m.max(x.abs()));
            mode = a.iter().map(|r| Row(r.0.map(|x| -x / size))).collect();
        }
        let velocity: Vec<Row> = mode.iter().map(|r| Row(r.0.map(|x| 1e-3 * x))).collect();
        let mut engine = ready.engine();
        let at_rest = state.u.clone();
        engine.start(&mut state, at_rest, &velocity);
        let total = |b: &tremolite_kernels::Lines| b[Line::Kinetic] + b[Line::Strain] + b[Line::Hourglass];
        let before = total(&engine.look(&state).snapshot.balance);
        // Ten periods.
        let steps = (10.0 * std::f64::consts::TAU / omega / dt).round() as usize;
        for _ in 0..steps {
            engine.step(&mut state);
        }
        let balance = engine.look(&state).snapshot.balance;
        let ratio = -(total(&balance) / before).ln() / (2.0 * omega * dt * steps as f64);
        // Forces at v⁻ lag half a step: order 1, ωΔt/2 = 1 %.
        assert!((ratio / 0.06 - 1.0).abs() < 0.02, "{quadrature:?}: {ratio}");
        let taken = balance[Line::Viscosity] / before;
        assert!((taken - (1.0 - total(&balance) / before)).abs() < 1e-4, "{quadrature:?}: {taken}");
    }
}

/// ξK is elements' alone: with the springs of the base in it the free field was damped by 1.6 %.
#[test]
fn stiffness_proportional_damping_acts_on_elements_alone() {
    let ready = Ready::new(block([4, 4, 5]));
    let w: Vec<Row> = (0..ready.model.mesh_node.len()).map(random).collect();
    let (mut of_elements, mut of_others) = (0, 0);
    for member in &ready.assembly.members {
        let mut out = vec![Row::new([1.0; 3]); member.part.nodes().len()];
        let history = vec![Octet::ZERO; member.part.state_sizes().history];
        let kept = Kept { history: &history, numbers: &[], reference: &[], initial: &[] };
        member.part.damping_times(&w, kept, &w, &mut out, &mut Scratch::default());
        let still = out.iter().all(|row| row.xyz() == [0.0; 3]);
        if member.part.elements().0 > 0 {
            of_elements += 1;
            assert!(!still, "{}", member.name);
        } else {
            of_others += 1;
            assert!(still, "{}", member.name);
        }
    }
    assert!(of_elements > 0 && of_others > 0);
}

/// Concrete that is loaded fast is stronger: uncracked beyond its static strength it carries all of ξK. Asked with an update
/// at Δt = 0, in which there is no rate, it read as cracked.
#[test]
fn uncracked_concrete_beyond_its_static_strength_is_damped_as_if_elastic() {
    let mut values = Values::default()
        .with("young", 25e9)
        .with("poisson", 0.17)
        .with("tensile_strength", 1.2e6)
        .with("cohesion", 2e6)
        .with("friction_angle", 0.8);
    for (key, word) in [("rate", "ceb"), ("evolution", "residual"), ("split", "effective")] {
        values.0.insert(key.into(), Value::Word(word.into()));
    }
    let law = laws().into_iter().find(|law| law.info.name == "concrete-damage").unwrap();
    let mesh = BoxSpec::uniform([0.0; 3], [1.0; 3], [1; 3]).mesh().unwrap();
    let body = Body {
        name: "concrete".into(),
        elements: vec![0],
        material: (law.build)(&values).unwrap(),
        density: 2500.0,
        quadrature: Quadrature::Full,
        viscosity: 0.0,
    };
    let ready = Ready::new(Problem::new(mesh, vec![body]));
    let mut state = ready.rest(0.5);
    let height = |node: usize| ready.model.mesh.nodes[ready.model.mesh_node[node] as usize][2];
    // Up to 1.05 of the static threshold within 5 ms: the rate factor is 1.10.
    let steps = (5e-3 / state.dt) as usize;
    let mut engine = ready.engine();
    for step in 1..=steps {
        let strain = 1.05 * 1.2e6 / 25e9 * step as f64 / steps as f64;
        state.u = (0..8).map(|n| Row::new([0.0, 0.0, strain * height(n)])).collect();
        engine = ready.engine();
        engine.finish(&mut state);
    }
    drop(engine);
    assert!(
        state.history.iter().step_by(law.info.history.len()).all(|d| d.0[0] == 0.0),
        "nothing has cracked"
    );
    let w: Vec<Row> = (0..8).map(random).collect();
    let part = &ready.assembly.members[0].part;
    let [mut damped, mut elastic] = [vec![Row::ZERO; 8], vec![Row::ZERO; 8]];
    let rows: Vec<Row> = state.u.clone();
    part.damping_times(
        &rows,
        ready.assembly.slices[0].kept(&state.kept()),
        &w,
        &mut damped,
        &mut Scratch::default(),
    );
    part.stiffness_times(&w, &mut elastic, &mut Scratch::default());
    for (damped, elastic) in damped.iter().zip(&elastic) {
        for i in 0..3 {
            assert!((damped.0[i] - elastic.0[i]).abs() < 1e-12 * 25e9, "{damped:?} {elastic:?}");
        }
    }
}

/// 2/ω of single elements, with viscosity and springs, bounds the stable step from below; in a box of like elements closely.
#[test]
fn the_step_that_single_elements_are_sure_of_is_no_longer_than_the_stable_one() {
    let sure = |ready: &Ready| {
        let sure = sure_step(&ready.model, &ready.assembly, &ready.phase).unwrap();
        sure / stable_step(&ready.model, &ready.assembly, &ready.phase).dt
    };
    for quadrature in QUADRATURES {
        for (elements, viscosity) in [([1, 1, 1], 0.0), ([1, 1, 1], 0.3), ([5, 5, 5], 0.0), ([5, 5, 5], 0.3)]
        {
            let share = sure(&shaken(elements, quadrature, viscosity));
            assert!((0.7..=1.0).contains(&share), "{quadrature:?} {elements:?} {viscosity}: {share}");
        }
    }
    let springs = Base::ViscousSpring { normal: 200.0, tangential: 100.0, distance: Some(1.0) };
    let on_springs = Problem { base: springs, sides: [Side::Periodic; 2], ..block([4, 4, 5]) };
    let fixed = Problem { base: Base::Fixed, incident: None, ..jointed(tremolite_laws::Isa::best()) };
    for problem in [on_springs, fixed] {
        for stiffness in [0.0, 3e-4] {
            let mut problem = problem.clone();
            problem.rayleigh.stiffness = stiffness;
            let base = problem.base;
            let share = sure(&Ready::new(problem));
            assert!((0.2..=1.0).contains(&share), "{base:?} {stiffness}: {share}");
        }
    }
}
