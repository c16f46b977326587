//! Bolts in whole models: what they feel of the ground, and what they do to it.

use std::sync::Arc;
use tremolite::engine::Release;
use tremolite::stages::{PlannedStage, settle};
use tremolite::{
    Assembly, Bar, Body, Bolts, Bond, Engine, Model, Phase, Problem, Quadrature, Side, Stage, State, elastic,
    stable_step,
};
use tremolite_engine::bolts::{SegmentSeen, SegmentState};
use tremolite_kernels::Line;
use tremolite_laws::{Moduli, Row};
use tremolite_mesh::boxes::{BoxSpec, Distortion};

const AREA: f64 = 4.909e-4;
pub const STEEL: f64 = 200e9;
const HEAD: [f64; 3] = [0.3, 0.4, 0.2];
const TAIL: [f64; 3] = [5.6, 4.9, 5.3];

pub fn bolts(bars: &[[[f64; 3]; 2]]) -> Bolts {
    let bar = |points: &[[f64; 3]; 2]| Bar { points: points.to_vec(), areas: vec![AREA] };
    Bolts {
        name: "bolts".into(),
        bars: bars.iter().map(bar).collect(),
        young: STEEL,
        yields: f64::INFINITY,
        breaks: f64::INFINITY,
        bond: None,
        pretension: 0.0,
        free_length: 0.0,
        plates: [false; 2],
        born: Stage::Before(0),
    }
}

pub fn bond(segment: f64) -> Bond {
    Bond { stiffness: 1e8, strength: 50e3, friction: 0.0, perimeter: 0.0785, segment }
}

/// A cube of 6 m of distorted elements.
fn cube(elements: u32, quadrature: Quadrature) -> Problem {
    let mut spec = BoxSpec::uniform([0.0; 3], [6.0; 3], [elements; 3]);
    spec.distortion = Some(Distortion { fraction: 0.2, seed: 11, periodic: [false; 2] });
    let mesh = spec.mesh().unwrap();
    let body = Body {
        name: "rock".into(),
        elements: (0..mesh.elements.len() as u32).collect(),
        material: elastic(Moduli::from_young_poisson(10e9, 0.25)),
        density: 2700.0,
        quadrature,
        viscosity: 0.0,
    };
    Problem::new(mesh, vec![body])
}

pub struct Built {
    pub model: Arc<Model>,
    pub assembly: Arc<Assembly>,
}

impl Built {
    pub fn new(problem: Problem) -> Built {
        let model = Model::new(problem).unwrap();
        let assembly = Assembly::new(&model).unwrap();
        Built { model, assembly }
    }

    /// Displacements that are a function of place.
    fn displaced(&self, u: impl Fn([f64; 3]) -> [f64; 3]) -> State {
        let mut state = self.assembly.rest();
        for (row, &node) in state.u.iter_mut().zip(&self.model.mesh_node) {
            *row = Row::new(u(self.model.mesh.nodes[node as usize]));
        }
        state
    }

    fn observed(&self, state: &mut State) -> Vec<SegmentSeen> {
        let phase = Phase::of(&self.model, &self.assembly, Stage::Before(0)).unwrap();
        Engine::new(&self.model, &self.assembly, &phase).finish(state);
        self.assembly.bolts[0].seen(&state.numbers, 0)
    }
}

/// A gradient without any symmetry.
const GRADIENT: [[f64; 3]; 3] =
    [[1.1e-3, -0.3e-3, 0.2e-3], [0.5e-3, -0.7e-3, 0.4e-3], [-0.6e-3, 0.1e-3, 0.9e-3]];

fn linear(x: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| 0.01 + (0..3).map(|j| GRADIENT[i][j] * x[j]).sum::<f64>())
}

fn uniform_force() -> f64 {
    let length = (0..3).map(|i| (TAIL[i] - HEAD[i]).powi(2)).sum::<f64>().sqrt();
    let t = [0, 1, 2].map(|i| (TAIL[i] - HEAD[i]) / length);
    let strain: f64 = (0..3).map(|i| (0..3).map(|j| t[i] * GRADIENT[i][j] * t[j]).sum::<f64>()).sum();
    STEEL * AREA * strain
}

#[test]
fn uniform_strain_gives_the_same_force_in_every_segment_of_distorted_elements() {
    for quadrature in [Quadrature::OnePoint, Quadrature::Full] {
        let mut problem = cube(5, quadrature);
        problem.bolts = vec![bolts(&[[HEAD, TAIL]])];
        let built = Built::new(problem);
        let seen = built.observed(&mut built.displaced(linear));
        assert!(seen.len() > 6, "{}", seen.len());
        let exact = uniform_force();
        for segment in &seen {
            assert!((segment.force / exact - 1.0).abs() < 1e-11, "{segment:?} {exact}");
        }
    }
}

/// Between plates a bar without slip to speak of; in the middle of a long bond the same.
#[test]
fn a_bonded_bar_between_plates_carries_uniform_strain_exactly() {
    let mut problem = cube(5, Quadrature::OnePoint);
    let mut kind = bolts(&[[HEAD, TAIL]]);
    kind.bond = Some(bond(0.1));
    kind.plates = [true; 2];
    problem.bolts = vec![kind];
    let built = Built::new(problem);
    let seen = built.observed(&mut built.displaced(linear));
    let exact = uniform_force();
    assert!(seen.len() > 80);
    for segment in &seen {
        assert!((segment.force / exact - 1.0).abs() < 1e-10, "{segment:?} {exact}");
        assert!(segment.slip.abs() < 1e-14);
    }
}

/// What bolts do to the ground has no resultant and no moment.
#[test]
fn forces_on_the_ground_are_in_balance_bolt_by_bolt() {
    for bonded in [false, true] {
        let mut problem = cube(4, Quadrature::OnePoint);
        let mut kind = bolts(&[[HEAD, TAIL]]);
        kind.bond = bonded.then(|| bond(0.3));
        problem.bolts = vec![kind];
        let built = Built::new(problem);
        let (member, slices) = built.assembly.named("bolts").unwrap();
        let wave =
            |x: [f64; 3]| [1e-3 * (x[0] + x[1] * x[2]).sin(), 2e-3 * (x[1] - x[2]).cos(), 1e-3 * x[0] * x[2]];
        let mut state = built.displaced(wave);
        let mut out = vec![Row::ZERO; member.part.nodes().len()];
        let (motion, own) = slices.own(&mut state);
        let tick = tremolite_kernels::Tick { time: 0.0, dt: 0.0, step: 0 };
        member.part.forces(&tick, &motion, own, &mut out, &mut Default::default());
        let (mut force, mut moment, mut size) = ([0.0; 3], [0.0; 3], 0.0);
        for (row, &node) in out.iter().zip(member.part.nodes()) {
            let x = built.model.mesh.nodes[built.model.mesh_node[node as usize] as usize];
            let f = row.xyz();
            size += f.iter().map(|f| f.abs()).sum::<f64>();
            for i in 0..3 {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                force[i] += f[i];
                moment[i] += x[j] * f[k] - x[k] * f[j];
            }
        }
        assert!(size > 1e4);
        assert!(
            force.iter().chain(&moment).all(|sum| sum.abs() < 1e-12 * size),
            "{force:?} {moment:?} {size}"
        );
    }
}

#[test]
fn bolts_move_no_element_in_uniform_strain_but_by_their_own_stress() {
    // Forces at inner nodes: a bar that runs through from end to end leaves them alone under uniform strain.
    let mut problem = cube(4, Quadrature::OnePoint);
    problem.bolts = vec![bolts(&[[[0.0, 2.3, 2.9], [6.0, 3.4, 2.2]]])];
    let built = Built::new(problem);
    let (member, slices) = built.assembly.named("bolts").unwrap();
    let mut state = built.displaced(linear);
    let mut out = vec![Row::ZERO; member.part.nodes().len()];
    let (motion, own) = slices.own(&mut state);
    let tick = tremolite_kernels::Tick { time: 0.0, dt: 0.0, step: 0 };
    member.part.forces(&tick, &motion, own, &mut out, &mut Default::default());
    let mut inner = 0;
    for (row, &node) in out.iter().zip(member.part.nodes()) {
        let x = built.model.mesh.nodes[built.model.mesh_node[node as usize] as usize];
        if x[0] > 1e-9 && x[0] < 6.0 - 1e-9 {
            inner += 1;
            assert!(row.xyz().iter().all(|f| f.abs() < 1e-11 * STEEL * AREA * 1e-3), "{x:?} {row:?}");
        }
    }
    assert!(inner > 10);
}

pub fn close() -> PlannedStage {
    let release = Release { tolerance: [1e-9, 1e-7], ..Release::default() };
    PlannedStage { release, ..PlannedStage::new("stage") }
}

/// A bar in rock that is held, pulled at the end of its free length: N = P cosh-like, sinh(β(L − x))/sinh(βL).
#[test]
fn a_pull_out_within_the_strength_of_the_bond_is_the_elastic_solution() {
    let mut errors = Vec::new();
    for segment in [0.2, 0.1, 0.05] {
        let mut problem = cube(4, Quadrature::OnePoint);
        problem.held = (0..problem.mesh.nodes.len() as u32).map(|n| (n, [true; 3])).collect();
        problem.sides = [Side::Roller; 2];
        let mut kind = bolts(&[[[3.1, 2.9, 0.1], [3.1, 2.9, 5.1]]]);
        kind.bond = Some(bond(segment));
        (kind.free_length, kind.plates, kind.pretension) = (2.0, [true, false], 20e3);
        problem.bolts = vec![kind];
        let built = Built::new(problem);
        let (state, _) = settle(&built.model, &built.assembly, &[close()]).unwrap();
        let seen = built.assembly.bolts[0].seen(&state.numbers, 0);
        let set = &built.model.bolts[0];
        let beta = (1e8f64 / (STEEL * AREA)).sqrt();
        let mut error: f64 = 0.0;
        for (seen, of) in seen.iter().zip(&set.bolts[0].segments) {
            let [a, b] = of.points.map(|p| set.bolts[0].points[p as usize].at - 2.0);
            let middle = 0.5 * (a + b);
            let exact =
                if of.free { 20e3 } else { 20e3 * (beta * (3.0 - middle)).sinh() / (beta * 3.0).sinh() };
            error = error.max((seen.force - exact).abs() / 20e3);
            assert_eq!(seen.state, SegmentState::Elastic);
        }
        errors.push(error);
    }
    eprintln!("{errors:?}");
    assert!(errors[2] < 1e-3, "{errors:?}");
    assert!(errors.windows(2).all(|e| e[1] < 0.35 * e[0]), "{errors:?}");
}

/// The rock of a bond moves at once by more than all of its sliders hold, and the free length before it yields: how many passes
/// that takes grows with the segments.
#[test]
fn a_bond_of_many_segments_that_slides_all_at_once_settles() {
    for segment in [0.1, 0.02] {
        let mut problem = cube(6, Quadrature::OnePoint);
        let mut kind = bolts(&[[[3.1, 2.9, 0.1], [3.1, 2.9, 5.9]]]);
        kind.bond = Some(bond(segment));
        (kind.free_length, kind.plates, kind.yields) = (2.0, [true, false], 80e6);
        problem.bolts = vec![kind];
        let built = Built::new(problem);
        let seen = built.observed(&mut built.displaced(|_| [0.0; 3]));
        for by in [0.6e-3, 1.5e-3, 5e-3] {
            let mut state = built.displaced(|x| [0.0, 0.0, if x[2] > 1.5 { by } else { 0.0 }]);
            let now = built.observed(&mut state);
            let (rest, passes) = built.assembly.bolts[0].unsettled(&state.numbers, 0);
            assert!(
                rest < 1e-3,
                "{segment} m, {by} m: {rest} N after {passes} passes of {} segments",
                seen.len()
            );
            let yields = now[0].yields_at;
            assert!(now.iter().all(|seen| seen.force <= yields) && now[0].force <= yields);
        }
    }
}

/// Rock strained at random by what a shaking would do: bonds slide, the bar yields, and every step's work is in a line.
#[test]
fn work_on_a_sliding_yielding_and_breaking_bolt_is_in_its_lines() {
    let mut most_passes = 0;
    for seed in 1..40u64 {
        let mut problem = cube(3, Quadrature::OnePoint);
        let mut kind = bolts(&[[HEAD, TAIL]]);
        // From stiff to soft, from strong to weak, coarse and fine.
        let segment = if seed % 4 == 0 { 0.04 } else { 0.15 };
        let strength = [50e3, 300e3, 2e3][seed as usize % 3];
        kind.bond = Some(Bond { strength, stiffness: [1e8, 1e10][seed as usize % 2], ..bond(segment) });
        kind.plates = [seed % 2 == 0, seed % 3 == 0];
        kind.yields = [120e6, 20e6, 400e6][seed as usize % 3];
        kind.breaks = if seed % 5 == 0 { 4e-3 } else { f64::INFINITY };
        problem.bolts = vec![kind];
        let built = Built::new(problem);
        let (member, slices) = built.assembly.named("bolts").unwrap();
        let mut state = built.assembly.rest();
        let mut seed = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let mut random = || {
            seed ^= seed << 13;
            seed ^= seed >> 7;
            seed ^= seed << 17;
            (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        };
        let nodes = member.part.nodes().to_vec();
        let tick = tremolite_kernels::Tick { time: 0.0, dt: 0.0, step: 0 };
        let mut before = vec![Row::ZERO; nodes.len()];
        let (mut work, mut spent, mut broken) = (0.0, [0.0; 2], 0);
        for step in 0..400 {
            let size = if step % 50 == 0 { 6e-3 } else { 3e-4 };
            let increments: Vec<Row> =
                nodes.iter().map(|_| Row::new([0; 3].map(|_| size * random()))).collect();
            for (&n, d) in nodes.iter().zip(&increments) {
                for i in 0..3 {
                    state.u[n as usize].0[i] += d.0[i];
                }
            }
            let mut out = vec![Row::ZERO; nodes.len()];
            let (motion, own) = slices.own(&mut state);
            member.part.forces(&tick, &motion, own, &mut out, &mut Default::default());
            for ((a, b), d) in before.iter().zip(&out).zip(&increments) {
                work += (0..3).map(|i| 0.5 * (a.0[i] + b.0[i]) * d.0[i]).sum::<f64>();
            }
            // Whichever way the chain was balanced: no resultant, and what bonds give is what tension loses.
            let size: f64 = out.iter().flat_map(|row| row.xyz()).map(f64::abs).sum();
            let resultant =
                (0..3).map(|i| out.iter().map(|row| row.0[i]).sum::<f64>().abs()).fold(0.0, f64::max);
            assert!(resultant <= 1e-9 * size.max(1.0), "step {step}: {resultant} of {size} N");
            before = out;
            let lines = member.part.energy(&motion_of(&state), slices.kept(&state.kept()));
            let held: f64 =
                [Line::Bolts, Line::BoltFriction, Line::BoltPlastic].iter().map(|&l| lines[l]).sum();
            let scale = lines[Line::Bolts] + lines[Line::BoltFriction] + lines[Line::BoltPlastic];
            assert!((work - held).abs() <= 1e-9 * scale, "step {step}: {work} {lines:?}");
            let seen = built.assembly.bolts[0].seen(&state.numbers, 0);
            let now_broken = seen.iter().filter(|s| s.state == SegmentState::Broken).count();
            let now = [lines[Line::BoltFriction], lines[Line::BoltPlastic]];
            for (now, then) in now.iter().zip(&mut spent) {
                // A step from compression to beyond the break is all work given out by the trapezoidal rule.
                assert!(
                    now_broken > broken || *now >= *then - 1e-9 * scale,
                    "step {step}: {now} after {then}"
                );
                *then = *now;
            }
            broken = now_broken;
            let (rest, passes) = built.assembly.bolts[0].unsettled(&state.numbers, 0);
            assert!(rest < 1e-4, "step {step}: {rest} N after {passes} passes");
            most_passes = most_passes.max(passes);
        }
        assert!(spent[0] + spent[1] > 0.0);
    }
    eprintln!("{most_passes} passes at most");
    assert!(most_passes > 7, "the sweep was never asked");
}

fn motion_of(state: &State) -> tremolite_kernels::Motion<'_> {
    tremolite_kernels::Motion::new(&state.u, &state.du)
}

#[test]
fn bolts_do_not_bound_the_step() {
    let step = |bolted: bool| {
        let mut problem = cube(6, Quadrature::OnePoint);
        if bolted {
            let bars: Vec<[[f64; 3]; 2]> = (0..16)
                .map(|k| {
                    let (x, y) = (0.7 + 1.5 * f64::from(k % 4), 0.7 + 1.5 * f64::from(k / 4));
                    [[x, y, 0.0], [x + 0.2, y - 0.1, 6.0]]
                })
                .collect();
            problem.bolts = vec![bolts(&bars)];
        }
        let built = Built::new(problem);
        let phase = Phase::of(&built.model, &built.assembly, Stage::Shaking).unwrap();
        stable_step(&built.model, &built.assembly, &phase).dt
    };
    let [bare, bolted] = [step(false), step(true)];
    eprintln!("{bare} {bolted} {}", bolted / bare);
    assert!(bolted <= bare * (1.0 + 1e-6) && bolted > 0.98 * bare, "{bare} {bolted}");
}

/// σ across the bar −5 and −3 MPa, along it −9 MPa: a pressure of 4 MPa on the bond, whose strength is that times perimeter and tan φ.
#[test]
fn a_bond_with_friction_slides_at_what_presses_on_it_across_the_bar() {
    let mut problem = cube(4, Quadrature::OnePoint);
    problem.held = (0..problem.mesh.nodes.len() as u32).map(|n| (n, [true; 3])).collect();
    problem.sides = [Side::Roller; 2];
    problem.initial = vec![[-5e6, -3e6, -9e6, 1e5, 2e5, -3e5]; problem.mesh.elements.len()];
    let mut kind = bolts(&[[[3.1, 2.9, 0.1], [3.1, 2.9, 5.1]]]);
    kind.bond = Some(Bond { strength: 20e3, friction: 0.7, ..bond(0.05) });
    (kind.free_length, kind.plates, kind.pretension) = (1.0, [true, false], 400e3);
    problem.bolts = vec![kind];
    let built = Built::new(problem);
    let (state, _) = settle(&built.model, &built.assembly, &[close()]).unwrap();
    let seen = built.assembly.bolts[0].seen(&state.numbers, 0);
    let segments = &built.model.bolts[0].bolts[0].segments;
    let exact = 20e3 + 0.0785 * 0.7 * 4e6;
    let mut slid = 0;
    // Between the middles of segments that slid at both ends and are as long.
    for k in 2..seen.len() - 1 {
        let [a, b] = [k, k + 1].map(|k| segments[k].length);
        if seen[k + 1].state == SegmentState::Slid
            && seen[k + 2..].iter().any(|s| s.state == SegmentState::Slid)
        {
            let slope = (seen[k].force - seen[k + 1].force) / (0.5 * (a + b));
            assert!((slope / exact - 1.0).abs() < 1e-9, "{slope} {exact}");
            slid += 1;
        }
    }
    assert!(slid > 10, "{slid}");
}
