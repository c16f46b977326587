//! A block that slides on a shaken base.
//!
//! A rigid block with Coulomb's friction μ follows its base as long as the base's acceleration stays below μg. While it slides
//! its velocity changes by μg a second, so that the velocity of the base against the block, ẋ, changes by a ∓ μg.
//! - A pulse a = Ag for t₀: V = Agt₀, the block slides by D = V²/(2μg) (1 − μ/A) and stands again at V/(μg).
//! - a = Ag sin 2πft: it first slips at asin(μ/A)/(2πf). Between events x is a closed form; the events are its roots, by
//!   bisection. With A = 0.5, μ = 0.2, f = 2 Hz it slides without rest from then on, each way in turn.
//!
//! **Model.** In axes that move with the base: the base is held, and the force −ma(t) acts on the block, which starts where its
//! weight rests on the joint. All nodes of the block move as one, so that it is rigid as the theory's. An elastic block without
//! damping rocks on the joint, friction feeds that at some frequencies until corners hop, and it slides on by a few per cent:
//! with energy balanced, but that is another problem.
//!
//! **Errors.** The joint's shear spring, ω_t² = k_t A/m, must be stretched before friction is all there: the velocity gained
//! until then is of the order μg/ω_t, and the order in 1/ω_t is 1.

use crate::convergence::order;
use crate::joints::{joint, together};
use crate::models::Solid;
use crate::simulation::{Simulation, whole_steps};
use crate::{Check, Effort, Verification, VerifyError};
use std::f64::consts::PI;
use std::sync::Arc;
use tremolite::parts::loads::Load;
use tremolite::{Quadrature};
use tremolite_mesh::boxes::BoxSpec;

const NAME: &str = "sliding_block";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "a block slides on a shaken base: pulses of acceleration, and a sine",
    source: "the rigid block's motion in closed form, derived in the problem",
    from: Effort::Test,
    run,
};

const GRAVITY: f64 = 9.81;
const BLOCK: Solid = Solid { young: 1e9, poisson: 0.0, density: 2500.0 };
const LENGTH: f64 = 1.0;
const HEIGHT: f64 = 0.1;
const ELEMENTS: u32 = 4;
/// Share of the friction at which slip is taken to begin: all pairs are at their limit at one instant alone.
const SLIPS: f64 = 0.99;

/// The base's acceleration.
#[derive(Clone, Copy)]
enum Shaking {
    /// Ag until t₀.
    Pulse { amplitude: f64, until: f64 },
    /// Ag sin 2πft.
    Sine { amplitude: f64, frequency: f64 },
}

impl Shaking {
    /// At a time \[m/s²\]; at the pulse's end the mean, as a sum over steps needs it.
    fn acceleration(self, t: f64, dt: f64) -> f64 {
        match self {
            Shaking::Pulse { amplitude, until } => {
                let share = (0.5 + (until - t) / dt).clamp(0.0, 1.0);
                amplitude * GRAVITY * share
            }
            Shaking::Sine { amplitude, frequency } => amplitude * GRAVITY * (2.0 * PI * frequency * t).sin(),
        }
    }
}

/// Times \[s\] and places x \[m\] at which the base's velocity against the block changes its sign, and x at the end.
#[derive(Default)]
struct Motion {
    /// Where the force reaches [`SLIPS`] of friction.
    slip: f64,
    turns: Vec<[f64; 2]>,
    end: f64,
}

/// The rigid block under a sine that never leaves it at rest once it slides.
fn rigid_sine(amplitude: f64, frequency: f64, friction: f64, end: f64) -> Motion {
    let w = 2.0 * PI * frequency;
    let slips = |share: f64| (share * friction / amplitude).asin() / w;
    let mut motion = Motion { slip: slips(SLIPS), ..Motion::default() };
    let (mut from, mut place, mut sign) = (slips(1.0), 0.0, 1.0);
    loop {
        let speed = |t: f64| {
            GRAVITY * (amplitude / w * ((w * from).cos() - (w * t).cos()) - sign * friction * (t - from))
        };
        let moved = |t: f64| {
            let s = t - from;
            let sines = ((w * t).sin() - (w * from).sin()) / (w * w);
            GRAVITY * (amplitude * ((w * from).cos() * s / w - sines) - 0.5 * sign * friction * s * s)
        };
        // The velocity first grows; half a period on it has passed zero.
        let (mut low, mut high) = (from + 0.05 / frequency, from + 0.75 / frequency);
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            if sign * speed(middle) > 0.0 { low = middle } else { high = middle }
        }
        if low > end {
            motion.end = place + moved(end);
            return motion;
        }
        place += moved(low);
        motion.turns.push([low, place]);
        (from, sign) = (low, -sign);
    }
}

/// A run with ω_t \[rad/s\] up to `end` \[s\]; x at the end is the mean over the last `rest` \[s\].
fn slide(shaking: Shaking, friction: f64, shear: f64, end: f64, rest: f64) -> Result<Motion, VerifyError> {
    let width = LENGTH / f64::from(ELEMENTS);
    let layer = |low: f64, high: f64| {
        BoxSpec::uniform([0.0, 0.0, low], [LENGTH, width, high], [ELEMENTS, 1, 1]).mesh()
    };
    let base = layer(-HEIGHT, 0.0)?;
    let mesh = together(&base, &layer(0.0, HEIGHT)?);
    let first = base.nodes.len() as u32;
    let block = first..mesh.nodes.len() as u32;
    let mut problem = BLOCK.fill(mesh, Quadrature::OnePoint);
    let tangential = shear * shear * BLOCK.density * HEIGHT;
    let normal = 2.5 * tangential;
    let numbers = [("normal_stiffness", normal), ("shear_stiffness", tangential), ("friction_coefficient", friction)];
    let sides = [(0..ELEMENTS).collect(), (ELEMENTS..2 * ELEMENTS).collect()];
    problem.interfaces = vec![joint(sides, "coulomb", &numbers, &[])?];
    problem.ties = block.clone().skip(1).map(|n| (first, n)).collect();
    problem.held = (0..first).map(|n| (n, [true; 3])).collect();
    let area = width * width / 4.0;
    let mass = |n: u32| {
        let x = problem.mesh.nodes[n as usize][0];
        let inner = x > 1e-6 && x < LENGTH - 1e-6;
        BLOCK.density * HEIGHT / 2.0 * area * if inner { 2.0 } else { 1.0 }
    };
    let masses: Vec<(u32, f64)> = block.map(|n| (n, mass(n))).collect();
    let along = |direction: [f64; 3]| masses.iter().map(|&(n, m)| (n, direction.map(|d| d * m))).collect();

    // The step divides a pulse, whose end it must meet.
    let trial = Simulation::new(problem.clone())?;
    let most = trial.bound().to_run(0.9);
    let (_, dt) = whole_steps(if let Shaking::Pulse { until, .. } = shaking { until } else { end }, most);
    problem.loads = vec![
        Load { forces: along([0.0, 0.0, -GRAVITY]), factor: Arc::new(|_| 1.0) },
        Load { forces: along([-1.0, 0.0, 0.0]), factor: Arc::new(move |t| shaking.acceleration(t, dt)) },
    ];
    let simulation = Simulation::new(problem)?;

    let weight = BLOCK.density * HEIGHT * GRAVITY;
    let mut engine = simulation.engine();
    let mut state = simulation.start(&mut engine, dt, |node| {
        let own = simulation.model.mesh_node[node] >= first;
        [[0.0, 0.0, if own { -weight / normal } else { 0.0 }], [0.0; 3]]
    });
    let node = simulation.model.engine_node[first as usize] as usize;
    let mut motion = Motion::default();
    let (mut sum, mut count, mut before, mut sign) = (0.0, 0.0, 0.0, 1.0);
    while state.time() < end - 0.5 * dt {
        engine.step(&mut state);
        let (velocity, t) = simulation.velocity(&state, node);
        let (x, v) = (-state.u[node].0[0], -velocity[0]);
        if motion.slip == 0.0 {
            let (seam, contacts) = (&simulation.model.seams[0], &simulation.assembly.contacts[0]);
            let force = |k: usize| {
                let seen = contacts.seen(&state.history, k);
                seam.pairs[k].normal_area * seen.shear[0]
            };
            let share = (0..seam.pairs.len()).map(force).sum::<f64>().abs() / (friction * weight * LENGTH * width);
            if share > SLIPS {
                motion.slip = state.time() - dt;
            }
        } else if x > 3.0 * friction * GRAVITY / (shear * shear) && sign * v <= 0.0 {
            let at = t - dt * v / (v - before);
            motion.turns.push([at, x]);
            sign = -sign;
        }
        before = v;
        if state.time() > end - rest - 0.5 * dt {
            (sum, count) = (sum + x, count + 1.0);
        }
    }
    motion.end = sum / count;
    Ok(motion)
}

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    let mut compare = |quantity: String, [coarse, fine]: [f64; 2], exact: f64, unit| {
        let note = "1 %, the first-order error in 1/ω_t, halved with it as the order shows";
        let p = order((coarse - exact).abs(), (fine - exact).abs(), 2.0);
        checks.push(Check::new(NAME, quantity, fine, exact, 0.01 * exact, unit, note).with_order(p));
        p
    };
    let mut orders = Vec::new();
    for (amplitude, friction, until) in [(0.5, 0.2, 0.2), (0.5, 0.1, 0.5)] {
        let stop = amplitude * until / friction;
        let distance = 0.5 * GRAVITY * friction * stop * stop * (1.0 - friction / amplitude);
        let run = |shear| slide(Shaking::Pulse { amplitude, until }, friction, shear, stop + 0.1, 0.05);
        let (coarse, fine) = (run(1000.0)?, run(2000.0)?);
        let of = |what: &str| format!("{what} of a pulse of {amplitude} g, {until} s, μ = {friction}");
        let p = compare(of("slip"), [coarse.end, fine.end], distance, "m");
        orders.push((of("slip"), p));
        let stops = [&coarse, &fine].map(|motion| motion.turns.first().map_or(f64::NAN, |turn| turn[0]));
        compare(of("stop"), stops, stop, "s");
    }
    let (amplitude, frequency, friction, end) = (0.5, 2.0, 0.2, 2.5);
    let exact = rigid_sine(amplitude, frequency, friction, end);
    let run = |shear| slide(Shaking::Sine { amplitude, frequency }, friction, shear, end, 1e-6);
    let (coarse, fine) = (run(4000.0)?, run(8000.0)?);
    let of = |what: String| format!("{what} of a sine of {amplitude} g, {frequency} Hz, μ = {friction}");
    compare(of("time of 99 % of friction".into()), [coarse.slip, fine.slip], exact.slip, "s");
    for (k, turn) in exact.turns.iter().enumerate() {
        let both = [&coarse, &fine].map(|motion| motion.turns.get(k).copied().unwrap_or([f64::NAN; 2]));
        compare(of(format!("time of turn {}", k + 1)), both.map(|turn| turn[0]), turn[0], "s");
        let p = compare(of(format!("x at turn {}", k + 1)), both.map(|turn| turn[1]), turn[1], "m");
        if k == 1 {
            orders.push((of("x at turn 2".into()), p));
        }
    }
    compare(of("x at the end".into()), [coarse.end, fine.end], exact.end, "m");
    for (quantity, p) in orders {
        let note = "the velocity gained while the spring is stretched, μg/ω_t; the next term is 1/ω_t of it";
        let quantity = format!("order in 1/ω_t of the {quantity}");
        checks.push(Check::new(NAME, quantity, p, 1.0, 0.1, "1", note).with_order(p));
    }
    Ok(checks)
}
