//! Levels of steps: the same motion as with one, with fewer evaluations, and books that close.

use crate::block::block;
use crate::contact::{BANDIS, between, jointed};
use crate::ready::Ready;
use tremolite::engine::{Engine, prove};
use tremolite::{
    Base, Body, Line, Problem, Quadrature, Rayleigh, Side, Snapshot, Stage, State, elastic, find_levels,
    finer_levels,
};
use tremolite_laws::{Isa, Moduli, Row};
use tremolite_mesh::boxes::{Axis, BoxSpec};

/// Coarser upwards: all four levels in a block of 14 m.
fn upwards([_, _, z]: [f64; 3]) -> u8 {
    (z / 3.0) as u8
}

/// Levels in blobs, so that each borders on others in all directions.
fn blobs([x, y, z]: [f64; 3]) -> u8 {
    ((1.3 * x).sin() * (0.9 * y).cos() * 2.0 + (0.7 * z).sin() + 2.5).clamp(0.0, 3.0) as u8
}

/// Mixed sides, a base with springs and Rayleigh's ω.
fn shaken(side: Side) -> Problem {
    let mut problem = block([6, 5, 14]);
    problem.sides = [side; 2];
    problem.rayleigh = Rayleigh { mass: 3.0, stiffness: 0.0 };
    problem.patch_elements = Some(32);
    problem
}

/// Runs to a time with so many of the coarsest steps; looks with it.
fn run(engine: &mut Engine, mut state: State, end: f64) -> (State, Vec<Snapshot>) {
    let mut seen = Vec::new();
    let span = engine.phase().span() as f64;
    while state.time() < end - 0.5 * span * state.dt {
        seen.push(engine.look(&state).snapshot);
        engine.step(&mut state);
    }
    seen.push(engine.look(&state).snapshot);
    (state, seen)
}

/// A state with the step that brings `coarse` of the coarsest to the end.
fn rest(ready: &Ready, end: f64, coarse: u32) -> State {
    let mut state = ready.assembly.rest();
    state.dt = end / f64::from(coarse) / ready.phase.span() as f64;
    state
}

/// How far the balance is from closing, its scheme's part apart, over the largest energy; and the line of the levels over the same.
fn books(seen: &[Snapshot]) -> [f64; 2] {
    let most = |of: &dyn Fn(&Snapshot) -> f64| seen.iter().map(|s| of(s).abs()).fold(0.0, f64::max);
    let all = most(&|s| s.supplied).max(most(&|s| s.held));
    [most(&|s| s.balance[Line::Error] - s.scheme) / all, most(&|s| s.balance[Line::Levels]) / all]
}

/// Distance of two motions.
fn apart(a: &[Row], b: &[Row]) -> f64 {
    let square = |(a, b): (&Row, &Row)| (0..3).map(|i| (a.0[i] - b.0[i]).powi(2)).sum::<f64>();
    a.iter().zip(b).map(square).sum::<f64>().sqrt()
}

#[test]
fn the_motion_is_that_of_one_level_to_second_order() {
    let ways =
        [(Side::FreeField, blobs as fn([f64; 3]) -> u8), (Side::Periodic, upwards), (Side::Viscous, blobs)];
    for (side, wished) in ways {
        let ready = Ready::new(shaken(side)).levelled(wished);
        assert_eq!(ready.phase.beats.len(), 4, "{side:?}");
        assert!(!ready.phase.borders.is_empty());
        assert!(ready.phase.evaluated_elements < 0.75 * ready.phase.counted_elements as f64);
        let one = Ready::new(shaken(side));
        let (end, stable) = (0.16, one.stable());
        let fewest = (end / (0.75 * stable)).ceil() as u32;
        let of = |ready: &Ready, times: u32| {
            let (state, seen) = run(&mut ready.engine(), rest(ready, end, times * fewest), end);
            let nodes = &ready.model.engine_node[..ready.model.user.nodes];
            let u: Vec<Row> = nodes.iter().map(|&n| state.u[n as usize]).collect();
            (u, books(&seen))
        };
        let [(first, [open, _]), (second, [_, coarse]), (third, [_, fine])] =
            [1, 2, 4].map(|times| of(&ready, times));
        let order = (apart(&first, &second) / apart(&second, &third)).log2();
        assert!((1.9..2.1).contains(&order), "{side:?}: order {order:.2}");
        assert!((3.5..4.5).contains(&(coarse / fine)), "{side:?}: levels {coarse:e} {fine:e}");
        // ω leaves something of the second order open, in levels no more than with the coarsest step throughout.
        let (_, [closes, _]) = of(&one, 1);
        assert!(open < closes && closes < 1e-5, "{side:?}: {open:e} {closes:e}");

        let (exact, _) = of(&one, 8);
        let error = apart(&third, &exact) / apart(&exact, &vec![Row::ZERO; exact.len()]);
        assert!(error < 1e-3, "{side:?}: {error:e}");
    }
}

/// Without ω the scheme keeps an energy exactly, and what levels take is all that it loses.
#[test]
fn the_balance_closes_to_round_off_with_what_levels_take() {
    for side in [Side::FreeField, Side::Viscous, Side::Roller] {
        let mut problem = shaken(side);
        problem.rayleigh.mass = 0.0;
        let ready = Ready::new(problem).levelled(blobs);
        let fewest = (0.16 / (0.75 * ready.stable())).ceil() as u32;
        let (_, seen) = run(&mut ready.engine(), rest(&ready, 0.16, fewest), 0.16);
        let [open, levels] = books(&seen);
        assert!(open < 1e-12, "{side:?}: the balance misses {open:e}");
        assert!(levels > 1e6 * open && levels < 1e-2, "{side:?}: levels take {levels:e}");
        let bodies = |s: &Snapshot| s.bodies.iter().map(|body| body.error().abs()).fold(0.0, f64::max);
        let worst = seen.iter().map(bodies).fold(0.0, f64::max) / seen.last().unwrap().supplied;
        assert!(worst < 1e-12, "{side:?}: a body's books miss {worst:e}");
    }
}

#[test]
fn bits_depend_neither_on_threads_nor_on_instructions_nor_on_where_a_run_stops() {
    let end = 0.05;
    let bits = |isa: Isa, threads: usize, stop: bool| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let mut problem = shaken(Side::FreeField);
            problem.isa = isa;
            let ready = Ready::new(problem).levelled(blobs);
            let mut state = rest(&ready, end, 60);
            let mut engine = ready.engine();
            if stop {
                (0..7).for_each(|_| engine.step(&mut state));
                engine = ready.engine();
            }
            let (state, seen) = run(&mut engine, state, end);
            (state, seen.last().map(|seen| (seen.balance, seen.stress.clone())))
        })
    };
    let first = bits(Isa::Scalar, 1, false);
    assert!(first.0.u.iter().any(|u| u.0[0].abs() > 1e-6));
    for (isa, threads, stop) in [(Isa::Scalar, 2, true), (Isa::best(), 1, true), (Isa::best(), 4, false)] {
        assert!(first == bits(isa, threads, stop), "{} {threads} {stop}", isa.name());
    }
}

#[test]
fn parts_know_of_other_levels_only_what_they_name() {
    for side in [Side::FreeField, Side::Periodic] {
        let ready = Ready::new(shaken(side)).levelled(blobs);
        let run = |mut engine: Engine| run(&mut engine, rest(&ready, 0.01, 12), 0.01).0;
        assert!(run(ready.engine()) == run(ready.engine().poisoned()), "{side:?}");
    }
}

/// A bar of 40 × 1 × 1 m, pulled by its ends, which are held.
fn bar() -> Problem {
    let mesh = BoxSpec::uniform([0.0; 3], [40.0, 1.0, 1.0], [40, 1, 1]).mesh().unwrap();
    let elements: Vec<u32> = (0..mesh.elements.len() as u32).collect();
    let ends = (0u32..).zip(&mesh.nodes).filter(|(_, x)| x[0] < 1e-9 || x[0] > 40.0 - 1e-9);
    let held = ends.map(|(n, _)| (n, [true; 3])).collect();
    let body = Body {
        name: "bar".into(),
        elements,
        material: elastic(Moduli::from_young_poisson(1e10, 0.0)),
        density: 2500.0,
        quadrature: Quadrature::OnePoint,
        viscosity: 0.0,
    };
    let mut problem = Problem::new(mesh, vec![body]);
    problem.held = held;
    problem
}

#[test]
fn a_bar_under_tension_stays_at_rest_across_borders() {
    let wished = |[x, ..]: [f64; 3]| ((x / 3.0) as u8 % 7).min(6 - (x / 3.0) as u8 % 7);
    let ready = Ready::new(bar()).levelled(wished);
    assert_eq!(ready.phase.beats.len(), 4);
    let mut state = ready.assembly.rest();
    state.dt = 0.1 * ready.stable();
    // 10 MPa.
    let at = |&n: &u32| Row::new([1e-3 * ready.model.mesh.nodes[n as usize][0], 0.0, 0.0]);
    let u: Vec<Row> = ready.model.mesh_node.iter().map(at).collect();
    let mut engine = ready.engine();
    engine.start(&mut state, u.clone(), &vec![Row::ZERO; u.len()]);
    (0..2000).for_each(|_| engine.step(&mut state));
    let moved = state.u.iter().zip(&u).map(|(a, b)| (a.0[0] - b.0[0]).abs()).fold(0.0, f64::max);
    // A strain of 1e-3 over an element of 1 m.
    assert!(moved < 1e-9 * 1e-3, "{moved:e}");
}

/// Undamped, what is in it stays: with steps of 0.75 of the coarsest elements' bound at any time some 10⁴ fine steps on.
#[test]
fn energy_neither_grows_nor_fades_and_too_long_steps_are_found() {
    let ready = Ready::new(bar()).levelled(|[x, ..]| (x / 6.0) as u8 % 4);
    let stable = ready.stable();
    let energies = |share: f64| {
        let mut state = ready.assembly.rest();
        state.dt = share * stable / 8.0;
        let noise = |n: usize, i: usize| ((7 * n + 3 * i) as f64 * 1.618).fract() - 0.5;
        let held = |n: usize| ready.phase.inverse_mass[n].0[0] == 0.0;
        let v: Vec<Row> = (0..state.u.len())
            .map(|n| if held(n) { Row::ZERO } else { Row::new([0, 1, 2].map(|i| noise(n, i))) })
            .collect();
        let mut engine = ready.engine();
        engine.start(&mut state, vec![Row::ZERO; v.len()], &v);
        let mut all = Vec::new();
        for step in 0..2500 {
            if step % 5 == 0 {
                let seen = engine.look(&state).snapshot;
                all.push(
                    seen.balance[Line::Kinetic] + seen.balance[Line::Strain] + seen.balance[Line::Hourglass],
                );
                if engine.guard(&seen).is_err() {
                    return None;
                }
            }
            engine.step(&mut state);
        }
        let mean = |all: &[f64]| all.iter().sum::<f64>() / all.len() as f64;
        Some(mean(&all[450..]) / mean(&all[..50]))
    };
    let kept = energies(0.75).unwrap();
    println!("energy of the last tenth over that of the first: {kept:.6}");
    assert!((kept - 1.0).abs() < 0.01, "{kept}");
    assert_eq!(energies(1.1), None, "the guard halts what is unstable");
}

/// Two halves with a joint between them, whose pairs lie on different levels along it.
#[test]
fn joints_between_levels_slide_as_with_one() {
    let end = 0.03;
    let slid = |levels: bool, fine: f64| {
        let mut ready = Ready::new(jointed(Isa::best()));
        if levels {
            ready = ready.levelled(blobs);
            assert!(ready.phase.beats.len() > 2);
        }
        let stable = ready.stable();
        let mut state = ready.assembly.rest();
        state.dt = end / (end / (0.7 * stable)).ceil() / fine;
        let (state, seen) = run(&mut ready.engine(), state, end);
        let [open, _] = books(&seen);
        let nodes = &ready.model.engine_node[..ready.model.user.nodes];
        let u: Vec<Row> = nodes.iter().map(|&n| state.u[n as usize]).collect();
        (u, open)
    };
    // What laws of joints book goes by the step: that of the coarsest level is the measure.
    let ((one, _), (_, closes), (many, open)) = (slid(false, 8.0), slid(false, 1.0), slid(true, 8.0));
    let most = one.iter().map(|u| u.0[0].abs().max(u.0[2].abs())).fold(0.0, f64::max);
    let far = one.iter().zip(&many).flat_map(|(a, b)| (0..3).map(|i| (a.0[i] - b.0[i]).abs()));
    let far = far.fold(0.0, f64::max) / most;
    println!("joint: {far:.2e} apart, balance {closes:.1e} {open:.1e}");
    assert!(far < 0.02, "{far:e}");
    assert!(open < 2.0 * closes, "{open:e} {closes:e}");
}

/// Level ground between free-field sides moves as its vertical edge does at each depth, where columns have several levels as well: sides,
/// slabs, columns and ground have the same levels, so nothing but round-off is sent back.
#[test]
fn free_field_sides_lead_level_ground_with_several_levels_in_a_column() {
    for levels in [false, true] {
        let mesh = BoxSpec::uniform([0.0; 3], [12.0, 10.0, 14.0], [6, 5, 14]).mesh().unwrap();
        let mut problem = shaken(Side::FreeField);
        problem.bodies.truncate(1);
        problem.bodies[0].elements = (0..mesh.elements.len() as u32).collect();
        problem.mesh = mesh;
        let mut ready = Ready::new(problem);
        let stable = ready.stable();
        if levels {
            ready = ready.levelled(upwards);
            assert_eq!(ready.phase.beats.len(), 4);
        }
        let mut state = ready.assembly.rest();
        state.dt = 0.75 * stable / 8.0;
        let mut engine = ready.engine();
        let (mut most, mut apart) = (0.0_f64, 0.0_f64);
        while state.time() < 0.3 {
            let look = |n: u32| state.u[ready.model.engine_node[n as usize] as usize].0;
            for layer in 0..15 {
                // Nodes of the mesh lie layer by layer.
                let mut all = (0..42).map(|k| look(42 * layer + k));
                let first = all.next().unwrap();
                most = most.max(first[0].abs());
                for u in all {
                    apart = (0..3).map(|i| (u[i] - first[i]).abs()).fold(apart, f64::max);
                }
            }
            engine.step(&mut state);
        }
        println!("levels {levels}: ground differs from its edge by {:.1e} of the peak", apart / most);
        assert!(most > 1e-3 && apart < 1e-11 * most, "{levels}: {apart:e} of {most:e}");
    }
}

/// A joint whose bond holds is smooth: its closure is Bandis' hyperbola, and it keeps the order of the rest.
#[test]
fn a_joint_that_holds_keeps_second_order() {
    let mut problem = shaken(Side::Viscous);
    problem.base = Base::Viscous;
    let bond = |&(key, x): &(&'static str, f64)| (key, if key == "cohesion" { 2e7 } else { x });
    let numbers: Vec<_> = BANDIS.iter().map(bond).collect();
    let mut joint = between(&problem, [1, 0], "bandis", &numbers);
    joint.viscosity = 0.0;
    problem.interfaces = vec![joint];
    let ready = Ready::new(problem).levelled(blobs);
    assert_eq!(ready.phase.beats.len(), 4);
    let end = 0.16;
    let fewest = (end / (0.75 * ready.stable())).ceil() as u32;
    let [first, second, third] = [1, 2, 4].map(|times| {
        let (state, _) = run(&mut ready.engine(), rest(&ready, end, times * fewest), end);
        let nodes = &ready.model.engine_node[..ready.model.user.nodes];
        let closed = |k: usize| ready.assembly.contacts[0].seen(&state.history, k).pressure;
        let most = (0..ready.model.seams[0].pairs.len()).map(closed).fold(0.0, f64::max);
        assert!(most > 1e5, "the joint carries {most} Pa");
        nodes.iter().map(|&n| state.u[n as usize]).collect::<Vec<Row>>()
    });
    let order = (apart(&first, &second) / apart(&second, &third)).log2();
    println!("order with a joint: {order:.3}");
    assert!((1.9..2.1).contains(&order), "order {order:.2}");
}

/// An elastic bar flies to and fro between two walls on joints that just keep ω_c Δt = 0.8, which lie on a level beside finer ones. With
/// the default dashpots and viscosity its impacts make no more energy than those of one level with the pairs' own step. Without any they make
/// more, which is shown.
#[test]
fn a_hundred_bounces_between_walls_gain_no_more_than_with_one_level() {
    const LENGTH: f64 = 12.0;
    let (young, density): (f64, f64) = (1e10, 2500.0);
    let step = 0.75 / (young / density).sqrt();
    // Pairs step twice as long as the finest of four levels. A node's mass at an end is ρ/8, the area of its pair a quarter.
    let stiffness = 0.25 * density * (0.8 / (step / 4.0)).powi(2);
    let problem = |damping: f64| {
        let mesh = BoxSpec::uniform([-1.0, 0.0, 0.0], [LENGTH + 1.0, 1.0, 1.0], [LENGTH as u32 + 2, 1, 1]);
        let mesh = mesh.mesh().unwrap();
        let wall = |e: &u32| !(0.0..LENGTH).contains(&tremolite::hexahedra::centroid(&mesh, *e)[0]);
        let (walls, bar): (Vec<u32>, Vec<u32>) = (0..mesh.elements.len() as u32).partition(wall);
        let end = |x: f64| !(-0.5..=LENGTH + 0.5).contains(&x);
        let held = (0u32..).zip(&mesh.nodes).map(|(n, x)| (n, [end(x[0]), true, true])).collect();
        let body = |name: &str, elements| Body {
            name: name.into(),
            elements,
            material: elastic(Moduli::from_young_poisson(young, 0.0)),
            density,
            quadrature: Quadrature::OnePoint,
            viscosity: 0.0,
        };
        let mut problem = Problem::new(mesh.clone(), vec![body("walls", walls), body("bar", bar)]);
        problem.held = held;
        let mut joint = between(
            &problem,
            [0, 1],
            "coulomb",
            &[("normal_stiffness", stiffness), ("friction_coefficient", 0.0)],
        );
        (joint.damping, joint.viscosity) = (damping, 6.0 * damping);
        problem.interfaces = vec![joint];
        problem
    };
    let gain = |ready: &Ready, dt: f64, way: f64| {
        let speed = 1.0;
        let mut state = ready.assembly.rest();
        state.dt = dt;
        let bar: Vec<usize> = {
            let mut nodes: Vec<usize> = ready.model.bodies[1]
                .elements
                .iter()
                .flat_map(|&e| ready.model.mesh.elements[e as usize].nodes().to_vec())
                .map(|n| ready.model.engine_node[n as usize] as usize)
                .collect();
            nodes.sort_unstable();
            nodes.dedup();
            nodes
        };
        let mut v = vec![Row::ZERO; state.u.len()];
        bar.iter().for_each(|&n| v[n] = Row::new([speed, 0.0, 0.0]));
        let mut engine = ready.engine();
        let mut u0 = vec![Row::ZERO; v.len()];
        bar.iter().for_each(|&n| u0[n] = Row::new([way, 0.0, 0.0]));
        engine.start(&mut state, u0, &v);
        let mass: f64 = bar.iter().map(|&n| ready.phase.mass[n]).sum();
        let (mut bounces, mut way, mut most, mut begin) = (0, 1.0, 0.0_f64, None);
        // Looked at whenever all levels of either have their own times.
        let every = (step / dt).round() as u64 / ready.phase.span();
        while bounces < 100 {
            assert!(state.time() < 3.0, "{bounces} bounces");
            let seen = engine.look(&state).snapshot;
            let begin = *begin.get_or_insert(seen.held);
            most = most.max(seen.held / begin - 1.0);
            let momentum: f64 = bar.iter().map(|&n| ready.phase.mass[n] * seen.velocity[n].0[0]).sum();
            if momentum * way < -0.1 * mass * speed {
                (bounces, way) = (bounces + 1, -way);
            }
            (0..every).for_each(|_| engine.step(&mut state));
        }
        most
    };
    // The last number is where the bar begins [m].
    let both = |damping: f64, way: f64| {
        let one = gain(&Ready::new(problem(damping)), step / 4.0, way);
        let levels = Ready::new(problem(damping)).levelled(|[x, ..]| match (x - 0.5 * LENGTH).abs() {
            far if far > 5.2 => 1,
            far if far > 3.2 => 0,
            far if far > 2.2 => 1,
            far if far > 1.2 => 2,
            _ => 3,
        });
        assert_eq!(levels.phase.beats.len(), 4);
        let pair = levels.assembly.members.iter().find(|member| member.name.contains("joint")).unwrap();
        assert_eq!(pair.level, 1);
        let many = gain(&levels, step / 8.0, way);
        println!("damping {damping}: a hundred bounces gain {one:.3} with one level, {many:.3} with four");
        [one, many]
    };
    for way in [0.0, 1e-4] {
        let [one, many] = both(0.01, way);
        assert!(many <= one + 1e-3 && one < 0.02, "{one} {many}");
    }
    let [one, many] = both(0.0, 0.0);
    assert!(one < many && many < 1.0, "undamped: {one} {many}");
}

/// Borders are tried before a run: steps that the bounds of elements allow pass, one part with too long ones is found, and finer levels
/// there pass again.
#[test]
fn a_planted_instability_is_found_and_finer_levels_mend_it() {
    let coarse_slab = |[_, _, z]: [f64; 3]| if (z - 7.0).abs() < 4.0 { 3 } else { 1 };
    let right = Ready::new(shaken(Side::FreeField)).levelled(coarse_slab);
    // Of the finest level, that the coarsest elements still allow.
    let dt = 0.8 * right.stable() / 8.0;
    let proof = prove(&right.model, &right.assembly, &right.phase, dt);
    assert!(proof.tried > 10 && proof.grown.is_empty(), "{proof:?}");
    // Elements of the slab set the step: what is too long for them is not so for the others.
    let proof = prove(&right.model, &right.assembly, &right.phase, 1.15 * right.stable() / 8.0);
    assert!(!proof.grown.is_empty());
    let slab = |m: &u32| right.assembly.members[*m as usize].name.starts_with("slab");
    assert!(proof.grown.iter().any(slab), "{:?}", proof.grown);
    let levels = finer_levels(&right.model, &right.assembly, &right.phase, &proof.grown);
    let finer = (0..)
        .zip(&right.model.mesh_node)
        .filter(|&(n, &of)| levels.of_node(of) < right.model.nodes.level[n as usize]);
    assert!(finer.count() > 0);
}

/// What a border sends back of a pulse that crosses it, by how many elements the pulse is long.
#[test]
fn a_border_sends_back_little_of_what_crosses_it() {
    let reflected = |long: f64| {
        let (length, middle) = (400.0, 200.0);
        let mesh = BoxSpec::uniform([0.0; 3], [length, 1.0, 1.0], [400, 1, 1]).mesh().unwrap();
        let mut problem = bar();
        problem.bodies[0].elements = (0..mesh.elements.len() as u32).collect();
        problem.mesh = mesh;
        problem.held = (0..problem.mesh.nodes.len() as u32).map(|n| (n, [false, true, true])).collect();
        // From the finest to the coarsest, by three borders of which each is met by the pulse.
        let ready = Ready::new(problem).levelled(|[x, ..]| if x < middle { 0 } else { 3 });
        assert_eq!(ready.phase.beats.len(), 4);
        let speed = (1e10_f64 / 2500.0).sqrt();
        let mut state = ready.assembly.rest();
        state.dt = 0.75 * ready.stable() / 8.0;
        let pulse = |x: f64| {
            let s = (x - 100.0) / long;
            if s.abs() < 0.5 { (std::f64::consts::PI * s).cos().powi(4) } else { 0.0 }
        };
        let slope = |x: f64| (pulse(x + 1e-4) - pulse(x - 1e-4)) / 2e-4;
        let x = |n: usize| ready.model.mesh.nodes[ready.model.mesh_node[n] as usize][0];
        let rows = |of: &dyn Fn(f64) -> f64| -> Vec<Row> {
            (0..ready.model.mesh_node.len()).map(|n| Row::new([of(x(n)), 0.0, 0.0])).collect()
        };
        let mut engine = ready.engine();
        engine.start(&mut state, rows(&pulse), &rows(&|x| -speed * slope(x)));
        while state.time() < 170.0 / speed {
            engine.step(&mut state);
        }
        // By then it is at 270 m, and what came back at 130 m at the furthest.
        let back = (0..state.u.len()).filter(|&n| x(n) < middle - 5.0);
        back.map(|n| state.u[n].0[0].abs()).fold(0.0, f64::max)
    };
    let found = [10.0, 20.0, 40.0].map(reflected);
    println!("reflected of pulses of 10, 20 and 40 elements: {found:?}");
    assert!(found[0] < 1.5e-2 && found[1] < 6e-3 && found[2] < 3e-3, "{found:?}");
}

/// A border through a thin plate would weaken it in bending: its nodes step together through the thickness, those of a thick one need not.
#[test]
fn no_border_lies_along_a_thin_body() {
    let apart = |elements: u32, quadrature: Quadrature| {
        let mesh =
            BoxSpec::uniform([0.0; 3], [8.0, 8.0, f64::from(elements)], [8, 8, elements]).mesh().unwrap();
        let body = Body {
            name: "plate".into(),
            elements: (0..mesh.elements.len() as u32).collect(),
            material: elastic(Moduli::from_young_poisson(25e9, 0.2)),
            density: 2500.0,
            quadrature,
            viscosity: 0.0,
        };
        // Finest below, or at the edges: the first runs along the plate, the second across it.
        let differ = |wished: fn([f64; 3]) -> u8| {
            let ready = Ready::new(Problem::new(mesh.clone(), vec![body.clone()])).levelled(wished);
            let level = |n: usize| ready.model.nodes.level[n];
            (1..ready.model.mesh_node.len()).any(|n| level(n) != level(0))
        };
        [differ(|[_, _, z]| u8::from(z > 0.5)), differ(|[x, ..]| u8::from(x > 4.5))]
    };
    assert_eq!(apart(2, Quadrature::Full), [false, true]);
    assert_eq!(apart(3, Quadrature::Full), [false, true]);
    assert_eq!(apart(4, Quadrature::Full), [true, true]);
    assert_eq!(apart(2, Quadrature::OnePoint), [true, true]);
}

/// Level ground whose layers become thinner towards the surface, from 5 m to 0.1 m, with these sides along x and y.
fn thin_at_the_surface(sides: [Side; 2]) -> Problem {
    let mut mesh = BoxSpec::uniform([0.0, 0.0, -40.0], [40.0, 10.0, 0.0], [8, 2, 14]);
    mesh.z = Axis::Graded { from: -40.0, to: 0.0, elements: 14, ratio: 0.7 };
    let mesh = mesh.mesh().unwrap();
    let mut problem = shaken(sides[0]);
    problem.bodies.truncate(1);
    problem.bodies[0].elements = (0..mesh.elements.len() as u32).collect();
    problem.mesh = mesh;
    problem.sides = sides;
    problem
}

const BESIDE: [[Side; 2]; 4] = [
    [Side::FreeField, Side::Periodic],
    [Side::Periodic, Side::Periodic],
    [Side::FreeField, Side::FreeField],
    [Side::Viscous, Side::Roller],
];

/// With the levels that a run would have.
fn found(problem: Problem) -> (Ready, f64) {
    let one = Ready::new(problem);
    let dt = 0.8 * one.stable();
    let levels = find_levels(&one.model, &one.assembly, &one.phase, dt, 4).unwrap();
    let model = one.model.at_levels(&levels);
    let assembly = one.assembly.again(&model).unwrap();
    let phase = tremolite::Phase::of(&model, &assembly, Stage::Shaking).unwrap();
    (Ready { model, assembly, phase }, dt)
}

#[test]
fn elements_outside_the_model_step_within_their_own_bound() {
    for sides in BESIDE {
        let (ready, dt) = found(thin_at_the_surface(sides));
        let (model, mut outside, mut coarsest) = (&ready.model, 0, 0);
        for (e, element) in model.mesh.elements.iter().enumerate() {
            assert!(model.stands(e, Stage::Shaking), "{sides:?}: element {e}");
            let level = element.nodes().iter().map(|&n| model.engine_node[n as usize] as usize);
            let finest = level.map(|n| model.nodes.level[n]).min().unwrap();
            let share = f64::from(1 << finest) * dt * model.elements.frequencies[e] / 2.0;
            // On the finest level the stable step of the whole rules, which is no shorter than any element's own.
            let most = if finest == 0 { 1.0 } else { 0.8 };
            assert!(share < most + 1e-9, "{sides:?}: element {e} steps {share:.2} of its bound");
            outside += usize::from(e >= model.user.elements);
            coarsest = coarsest.max(finest);
        }
        assert!(outside > 0 && coarsest == 3, "{sides:?}: {outside} elements outside, levels to {coarsest}");
    }
}

#[test]
fn ground_outside_the_model_moves_under_several_levels_as_under_one() {
    for sides in BESIDE {
        let end = 0.25;
        let moved = |ready: &Ready, dt: f64| {
            let span = ready.phase.span() as f64;
            let mut state = ready.assembly.rest();
            state.dt = end / (end / (dt * span)).ceil() / span;
            let (state, _) = run(&mut ready.engine(), state, end);
            let outside = ready.model.user.nodes..ready.model.mesh.nodes.len();
            outside.map(|n| state.u[ready.model.engine_node[n] as usize]).collect::<Vec<Row>>()
        };
        let (many, dt) = found(thin_at_the_surface(sides));
        let one = moved(&Ready::new(thin_at_the_surface(sides)), dt);
        let error = apart(&moved(&many, dt), &one) / apart(&one, &vec![Row::ZERO; one.len()]);
        println!("{sides:?}: ground outside is {error:.1e} apart");
        assert!(error < 1e-2, "{sides:?}: {error:e}");
    }
}
