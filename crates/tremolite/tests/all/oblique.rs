//! A free field that is given in advance: plane waves at an angle go through a box as if it were not there.

use crate::ready::Ready;
use std::f64::consts::PI;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use tremolite::free_field::GivenField;
use tremolite::{Base, Body, Problem, Quadrature, Side, elastic};
use tremolite_kernels::Line;
use tremolite_laws::Moduli;
use tremolite_mesh::boxes::BoxSpec;

const DENSITY: f64 = 2500.0;
const SHEAR: f64 = 800.0;
/// Poisson's ratio 1/4: c_p = √3 c_s.
const PRESSURE: f64 = 1_385.640_646_055_101_7;
/// m
pub const SIZE: [f64; 3] = [40.0, 32.0, 48.0];
/// Wave length over the speed \[s\].
const PERIOD: f64 = 0.1;

/// u = a f(t − (x − x₀)·n/c), with a pulse that has three continuous derivatives.
#[derive(Clone, Copy)]
struct Wave {
    direction: [f64; 3],
    polarisation: [f64; 3],
    speed: f64,
    /// Where it is at time 0.
    start: [f64; 3],
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn unit(v: [f64; 3]) -> [f64; 3] {
    v.map(|x| x / dot(v, v).sqrt())
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Of a wave \[m/s\]: of 4 sin³ cos the largest is 3√3/4.
const PEAK_VELOCITY: f64 = 1e-3 * 1.299_038_105_676_658 * PI / PERIOD;

/// The pulse and its rate.
fn pulse(s: f64) -> [f64; 2] {
    if !(0.0..PERIOD).contains(&s) {
        return [0.0; 2];
    }
    let (sin, cos) = (PI * s / PERIOD).sin_cos();
    [1e-3 * sin.powi(4), 1e-3 * 4.0 * sin.powi(3) * cos * PI / PERIOD]
}

impl Wave {
    /// Up through the corner of the box that it meets first.
    fn up(direction: [f64; 3], polarisation: [f64; 3], speed: f64) -> Self {
        let direction = unit(direction);
        let start = [0, 1, 2].map(|i| if direction[i] > 0.0 { 0.0 } else { SIZE[i] });
        Wave { direction, polarisation: unit(polarisation), speed, start }
    }

    /// Sent back by the surface, for motion along it and across the direction (SH).
    fn reflected(self) -> Self {
        let mirror = |[x, y, z]: [f64; 3]| [x, y, 2.0 * SIZE[2] - z];
        let [x, y, z] = self.direction;
        Wave { direction: [x, y, -z], start: mirror(self.start), ..self }
    }

    fn pulse(&self, at: [f64; 3], time: f64) -> [f64; 2] {
        let ahead = [0, 1, 2].map(|i| at[i] - self.start[i]);
        pulse(time - dot(ahead, self.direction) / self.speed)
    }

    fn displacement(&self, at: [f64; 3], time: f64) -> [f64; 3] {
        self.polarisation.map(|a| a * self.pulse(at, time)[0])
    }

    /// λ tr ε + 2 G ε of ε = −f′/c sym(a ⊗ n).
    fn stress(&self, at: [f64; 3], time: f64) -> [f64; 6] {
        let rate = -self.pulse(at, time)[1] / self.speed;
        let [a, n] = [self.polarisation, self.direction];
        let shear = DENSITY * SHEAR * SHEAR;
        let lame = DENSITY * PRESSURE * PRESSURE - 2.0 * shear;
        [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)].map(|(i, j)| {
            let volume = if i == j { lame * dot(a, n) } else { 0.0 };
            rate * (volume + shear * (a[i] * n[j] + a[j] * n[i]))
        })
    }
}

/// Some waves, of which a test may leave out what the boundaries ask for.
#[derive(Clone)]
struct Waves {
    waves: Vec<Wave>,
    displaced: bool,
    stressed: bool,
    moving: bool,
}

impl Waves {
    fn new(waves: &[Wave]) -> Self {
        Waves { waves: waves.to_vec(), displaced: true, stressed: true, moving: true }
    }

    fn exact(&self, at: [f64; 3], time: f64) -> [f64; 3] {
        let add = |sum: [f64; 3], wave: &Wave| {
            let u = wave.displacement(at, time);
            [0, 1, 2].map(|i| sum[i] + u[i])
        };
        self.waves.iter().fold([0.0; 3], add)
    }
}

impl GivenField for Waves {
    fn displacement(&self, at: [f64; 3], time: f64) -> [f64; 3] {
        if self.displaced { self.exact(at, time) } else { [0.0; 3] }
    }

    fn stress(&self, at: [f64; 3], time: f64) -> [f64; 6] {
        let mut sum = [0.0; 6];
        for wave in self.waves.iter().filter(|_| self.stressed) {
            sum.iter_mut().zip(wave.stress(at, time)).for_each(|(sum, s)| *sum += s);
        }
        sum
    }

    fn velocity(&self, at: [f64; 3], time: f64, dt: f64) -> [f64; 3] {
        let [before, after] = [time - dt, time + dt].map(|time| self.exact(at, time));
        if self.moving { [0, 1, 2].map(|i| (after[i] - before[i]) / (2.0 * dt)) } else { [0.0; 3] }
    }

    fn peak_velocity(&self) -> f64 {
        self.waves.len() as f64 * PEAK_VELOCITY
    }
}

/// Homogeneous rock with elements of `size`, driven on all boundaries.
pub fn rock(size: f64, top: tremolite::Top) -> Problem {
    let cells = SIZE.map(|length| (length / size).round() as u32);
    let mesh = BoxSpec::uniform([0.0; 3], SIZE, cells).mesh().unwrap();
    let body = Body {
        name: "rock".into(),
        elements: (0..mesh.elements.len() as u32).collect(),
        material: elastic(Moduli::from_young_poisson(2.5 * DENSITY * SHEAR * SHEAR, 0.25)),
        density: DENSITY,
        quadrature: Quadrature::OnePoint,
        viscosity: 0.0,
    };
    let mut problem = Problem::new(mesh, vec![body]);
    problem.base = Base::ViscousSpring { normal: 1.33, tangential: 0.67, distance: Some(30.0) };
    problem.sides = [Side::FreeField; 2];
    problem.top = top;
    problem
}

/// What a run left.
struct Found {
    /// Largest difference of any node from the waves, at any time, over the largest displacement.
    error: f64,
    /// Energy that the balance misses over that which came in.
    missed: f64,
    /// Whether the guard would have stopped it.
    halted: bool,
}

/// Halving the elements leaves a quarter of the error, as near as two meshes tell. (Elements of 1 m leave 1/3.8 of it with the
/// surface and 1/3.4 without, where edges of the box err by h² ln 1/h.)
fn converges(top: tremolite::Top, field: &Waves, duration: f64) {
    let runs = [4.0, 2.0].map(|size| run(rock(size, top), field, duration));
    let [coarse, fine] = [0, 1].map(|k| runs[k].error);
    assert!(coarse > 3.6 * fine && fine < 3e-3, "{coarse:e} {fine:e}");
    for Found { missed, halted, .. } in runs {
        assert!(missed < 1e-12 && !halted, "{missed:e} {halted}");
    }
}

fn run(mut problem: Problem, field: &Waves, duration: f64) -> Found {
    problem.free_field = Some(Arc::new(field.clone()));
    let ready = Ready::new(problem);
    let mut engine = ready.engine();
    let mut state = ready.rest(0.8);
    let nodes: Vec<(usize, [f64; 3])> =
        (0..state.u.len()).map(|n| (n, ready.model.mesh.nodes[ready.model.mesh_node[n] as usize])).collect();
    let (mut peak, mut worst, mut halted) = (0.0_f64, 0.0_f64, false);
    while state.time() < duration {
        engine.step(&mut state);
        if engine.watches(&state) {
            halted |= engine.watch(&state).is_err();
        }
        for &(n, at) in &nodes {
            let exact = field.exact(at, state.time());
            for (found, exact) in state.u[n].0.iter().zip(exact) {
                peak = peak.max(exact.abs());
                worst = worst.max((found - exact).abs());
            }
        }
    }
    let snapshot = engine.finish(&mut state);
    let missed = (snapshot.balance[Line::Error] - snapshot.scheme).abs() / state.ledger.supplied;
    Found { error: worst / peak, missed, halted }
}

/// Largest difference of any node from a field over its largest displacement, until a time \[s\], with this share of the stable
/// step; at times that all nodes have.
pub fn worst(ready: &Ready, safety: f64, field: &dyn Fn([f64; 3], f64) -> [f64; 3], duration: f64) -> f64 {
    let mut engine = ready.engine();
    let mut state = ready.rest(safety);
    let (mut peak, mut worst) = (0.0_f64, 0.0_f64);
    let mut step = 0;
    while state.time() < duration {
        engine.step(&mut state);
        step += 1;
        if step % 8 != 0 {
            continue;
        }
        for n in 0..state.u.len() {
            let exact = field(ready.model.mesh.nodes[ready.model.mesh_node[n] as usize], state.time());
            for (found, exact) in state.u[n].xyz().into_iter().zip(exact) {
                peak = peak.max(exact.abs());
                worst = worst.max((found - exact).abs());
            }
        }
    }
    worst / peak
}

/// A pressure wave and a shear wave, both at an angle to every axis.
fn oblique() -> [Wave; 2] {
    let (p, s) = ([0.5, -0.4, 0.8], [-0.3, 0.6, 0.7]);
    [Wave::up(p, p, PRESSURE), Wave::up(s, cross(s, [0.2, 0.1, 1.0]), SHEAR)]
}

#[test]
fn waves_at_an_angle_go_through_a_box_with_order_two() {
    let field = Waves::new(&oblique());
    converges(tremolite::Top::Viscous, &field, 0.25);
}

#[test]
fn a_shear_wave_at_an_angle_comes_back_from_the_surface() {
    let wave = Wave::up([0.6, 0.0, 0.8], [0.0, 1.0, 0.0], SHEAR);
    let field = Waves::new(&[wave, wave.reflected()]);
    converges(tremolite::Top::Free, &field, 0.3);
}

#[test]
fn a_field_that_could_not_come_in_is_refused() {
    for base in [Base::Free, Base::Fixed] {
        let mut problem = rock(8.0, tremolite::Top::Free);
        problem.base = base;
        problem.free_field = Some(Arc::new(Waves::new(&oblique())));
        let refused = tremolite::Model::new(problem).err().unwrap().to_string();
        assert!(refused.contains("let it absorb"), "{refused}");
    }
}

#[test]
fn what_a_boundary_asks_for_counts() {
    let whole = Waves::new(&oblique());
    let error = |field: &Waves| run(rock(4.0, tremolite::Top::Viscous), field, 0.15).error;
    let right = error(&whole);
    for (name, less) in [
        ("displacement", Waves { displaced: false, ..whole.clone() }),
        ("stress", Waves { stressed: false, ..whole.clone() }),
        ("velocity", Waves { moving: false, ..whole.clone() }),
    ] {
        let found = error(&less);
        assert!(found > 3.0 * right, "{name}: {found} for {right}");
    }
}

/// A field at rest that counts at how many places it is asked for stresses.
#[derive(Default)]
struct Counting(AtomicUsize);

impl GivenField for Counting {
    fn displacement(&self, _: [f64; 3], _: f64) -> [f64; 3] {
        [0.0; 3]
    }

    fn stress(&self, _: [f64; 3], _: f64) -> [f64; 6] {
        self.0.fetch_add(1, Ordering::Relaxed);
        [0.0; 6]
    }

    fn peak_velocity(&self) -> f64 {
        0.0
    }
}

/// A boundary is cut into pieces that lie together, since both of two neighbours ask for what lies between them.
#[test]
fn points_of_faces_are_hardly_ever_asked_for_twice() {
    let cells = [40, 40, 4];
    let mut problem = rock(8.0, tremolite::Top::Free);
    problem.mesh = BoxSpec::uniform([0.0; 3], cells.map(f64::from), cells).mesh().unwrap();
    problem.bodies[0].elements = (0..problem.mesh.elements.len() as u32).collect();
    let field = Arc::new(Counting::default());
    problem.free_field = Some(field.clone());
    let ready = Ready::new(problem);
    let mut engine = ready.engine();
    let mut state = ready.rest(0.8);
    let before = field.0.load(Ordering::Relaxed);
    engine.step(&mut state);
    let asked = field.0.load(Ordering::Relaxed) - before;
    // 2 × 2 points a face, of the base and of four sides.
    let points = 4 * (40 * 40 + 4 * 40 * 4);
    assert!(asked >= points && 10 * asked < 12 * points, "{asked} of {points}");
}
