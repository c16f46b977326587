//! A pulse that comes up from below, is reflected by the ground surface and leaves through the base.
//!
//! In a homogeneous half-space a vertically incident wave u_inc(t), stated at the depth H of the base, gives
//! u(z, t) = u_inc(t − (H − d)/c) + u_inc(t − (H + d)/c) at the depth d: twice the incident motion at the surface, and
//! nothing is left once the reflected pulse has passed the base (d'Alembert; Kramer 1996, section 7.2). Sides are
//! periodic; the base absorbs by dashpots alone (Lysmer & Kuhlemeyer 1969) or with springs on the scattered motion,
//! which a vertical wave in layered ground must not feel.
//!
//! Tolerances come from the leading terms of the error. At the frequency w the row of lumped masses delays a wave by
//! the phase s w³h²(1 − C²)/(24c³) over the path s, that is by δu = s h²(1 − C²)/(24c³) |u‴|, and its end meets the
//! dashpot with the impedance ρc cos(½kh), that is δu = h²/(16c²) |u″|.

use crate::convergence::order;
use crate::models::{SIDES, Solid, column};
use crate::simulation::{Simulation, whole_steps};
use crate::{Check, Effort, Verification, VerifyError};
use tremolite::{Base, Incident, Quadrature, Side};
use tremolite_motion::{Motion, ricker_velocity};

const NAME: &str = "incident_pulse";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "vertical SV and P pulses: twice the incident motion at the surface, absorbed by the base",
    source: "d'Alembert's solution for a half-space (Kramer 1996, section 7.2); Lysmer & Kuhlemeyer 1969",
    from: Effort::Test,
    run,
};

const ROCK: Solid = Solid { young: 10e9, poisson: 0.25, density: 2700.0 };
/// Height of the column \[m\].
const HEIGHT: f64 = 100.0;
/// Peak velocity of the incident pulse \[m/s\].
const PEAK: f64 = 0.1;

const SPRINGS: Base = Base::ViscousSpring { normal: 1.33, tangential: 0.67, distance: None };

/// A vertical wave: its speed and its polarisation. One wavelength at the pulse's frequency fills the column.
#[derive(Clone, Copy)]
struct Wave {
    letter: &'static str,
    speed: f64,
    along: [f64; 3],
}

impl Wave {
    fn frequency(&self) -> f64 {
        self.speed / HEIGHT
    }

    /// Centre of the pulse \[s\].
    fn centre(&self) -> f64 {
        1.5 / self.frequency()
    }

    /// Displacement \[m\] and velocity \[m/s\] of the incident wave.
    fn incident(&self, t: f64) -> [f64; 2] {
        let s = ricker_velocity(self.frequency(), self.centre(), PEAK)(t);
        [s.u, s.v]
    }

    /// Both at a depth \[m\] and time \[s\].
    fn exact(&self, depth: f64, t: f64) -> [f64; 2] {
        let up = self.incident(t - (HEIGHT - depth) / self.speed);
        let down = self.incident(t - (HEIGHT + depth) / self.speed);
        [up[0] + down[0], up[1] + down[1]]
    }
}

/// What a run shows.
struct Outcome {
    /// Largest error of displacement and of velocity at surface, middle and base, over the incident peak of each.
    error: [f64; 2],
    /// Largest velocity of the surface over the incident peak.
    surface: f64,
    /// Largest velocity anywhere after all has passed, over the incident peak.
    late: f64,
    /// Displacements of the surface along the wave.
    history: Vec<f64>,
    /// Leading terms of the errors, as in the module's text.
    leading: [f64; 2],
}

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let (p, s) = ROCK.speeds();
    let mut checks = Vec::new();
    for wave in [
        Wave { letter: "SV", speed: s, along: [0.6, 0.8, 0.0] },
        Wave { letter: "P", speed: p, along: [0.0, 0.0, 1.0] },
    ] {
        for &(sides, with) in SIDES {
            checks.extend(risen(wave, sides, with)?);
        }
    }
    Ok(checks)
}

fn risen(wave: Wave, sides: Side, with: &str) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    let coarse = rise(wave, Base::Viscous, sides, Quadrature::OnePoint, 40, None)?;
    let fine = rise(wave, Base::Viscous, sides, Quadrature::OnePoint, 80, None)?;
    let full = rise(wave, Base::Viscous, sides, Quadrature::Full, 80, None)?;
    // As many steps: the estimate of the stable step has other last digits with springs.
    let steps = fine.history.len() as u64 - 1;
    let springs = rise(wave, SPRINGS, sides, Quadrature::OnePoint, 80, Some(steps))?;
    let letter = wave.letter;
    let note = "twice the leading terms of dispersion and of the base, 80 elements a wavelength of the peak";
    for (outcome, word) in [(&fine, "viscous base"), (&full, "viscous base, full")] {
        for (k, what) in ["displacement", "velocity"].into_iter().enumerate() {
            let p = (word == "viscous base").then(|| order(coarse.error[k], fine.error[k], 2.0));
            let quantity = format!("{letter}: error of {what} over the incident peak, {word}{with}");
            let check = Check::new(NAME, quantity, outcome.error[k], 0.0, 2.0 * outcome.leading[k], "1", note);
            checks.push(p.into_iter().fold(check, Check::with_order));
        }
    }
    let quantity = format!("{letter}: surface velocity over the incident peak{with}");
    checks.push(Check::new(NAME, quantity, fine.surface, 2.0, 2.0 * fine.leading[1], "1", note));
    let quantity = format!("{letter}: velocity left behind over the incident peak{with}");
    let note = "0.5 %; the base reflects (kh)²/16 of a wave, 0.04 % at the peak frequency and 0.35 % at three times it";
    let check = Check::new(NAME, quantity, fine.late, 0.0, 0.005, "1", note);
    checks.push(check.with_order(order(coarse.late, fine.late, 2.0)));
    let p = order(coarse.error[0], fine.error[0], 2.0);
    let quantity = format!("{letter}: order in h of displacement{with}");
    let note = "all leading terms are of order 2 in h, Δt ∝ h; the next are (kh)²/10 of them, 0.06 at 2 f";
    checks.push(Check::new(NAME, quantity, p, 2.0, 0.1, "1", note).with_order(p));
    let differ = fine.history.iter().zip(&springs.history).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let largest = fine.history.iter().copied().map(f64::abs).fold(0.0, f64::max);
    let quantity = format!("{letter}: effect of the base's springs on the surface's displacement{with}");
    let note = "the reference column moves as the model does, so the springs act on round-off";
    checks.push(Check::new(NAME, quantity, differ / largest, 0.0, 1e-9, "1", note));
    Ok(checks)
}

/// In so many steps, or as many as the stable step asks for.
fn rise(
    wave: Wave,
    base: Base,
    sides: Side,
    quadrature: Quadrature,
    layers: u32,
    steps: Option<u64>,
) -> Result<Outcome, VerifyError> {
    let h = HEIGHT / f64::from(layers);
    let pulse = ricker_velocity(wave.frequency(), wave.centre(), PEAK);
    let period = 1.0 / wave.frequency();
    let passed = wave.centre() + 2.0 * HEIGHT / wave.speed + 1.5 * period;
    let end = passed + 2.0 * period;
    let mut problem = ROCK.fill(column(h, layers, 2)?, quadrature);
    problem.sides = [sides; 2];
    problem.base = base;
    // The outcrop motion: the engine must halve it.
    let motion = Motion::sampled(0.002 * period, end, |t| {
        let mut s = pulse(t);
        (s.a, s.v, s.u) = (2.0 * s.a, 2.0 * s.v, 2.0 * s.u);
        s.along(wave.along)
    })?;
    problem.incident = Some(Incident { motion, factor: 0.5 });
    let simulation = Simulation::new(problem)?;
    let (steps, dt) = match steps {
        Some(steps) => (steps, end / steps as f64),
        None => whole_steps(end, 0.9 * simulation.stable()),
    };

    let depths = [0.0, 0.5 * HEIGHT, HEIGHT];
    let nodes = [0, 1, 2].map(|k| simulation.node([h, h, HEIGHT - depths[k]]));
    let [top, middle, bottom] = nodes;
    let nodes = [top?, middle?, bottom?];
    let along = |row: [f64; 4]| (0..3).map(|i| row[i] * wave.along[i]).sum::<f64>();
    let (mut error, mut surface, mut late) = ([0.0f64; 2], 0.0f64, 0.0f64);
    let mut history = Vec::new();
    simulation.run_from_rest(dt, steps, |state| {
        for (depth, &node) in depths.into_iter().zip(&nodes) {
            let (v, half) = simulation.velocity(state, node);
            let (u, v) = (along(state.u[node].0), along([v[0], v[1], v[2], 0.0]));
            error[0] = error[0].max((u - wave.exact(depth, state.time())[0]).abs());
            error[1] = error[1].max((v - wave.exact(depth, half)[1]).abs());
            if half > passed {
                late = late.max(v.abs());
            }
        }
        surface = surface.max(along(state.du[nodes[0]].0).abs() / state.dt);
        history.push(along(state.u[nodes[0]].0));
    })?;

    // Largest derivatives of the pulse, from differences of its acceleration, and its largest displacement.
    let e = 1e-3 * period;
    let (mut peak, mut d) = (0.0f64, [0.0f64; 4]);
    for i in 0..3000 {
        let t = f64::from(i) * e;
        let [a, b, c] = [pulse(t - e).a, pulse(t).a, pulse(t + e).a];
        let derivatives = [b, (c - a) / (2.0 * e), b, (c - 2.0 * b + a) / (e * e)];
        peak = peak.max(pulse(t).u.abs());
        for (d, x) in d.iter_mut().zip(derivatives) {
            *d = d.max(x.abs());
        }
    }
    let courant = wave.speed * dt / h;
    let delay = 2.0 * HEIGHT * h * h * (1.0 - courant * courant) / (24.0 * wave.speed.powi(3));
    let ends = h * h / (16.0 * wave.speed * wave.speed);
    // Of displacement: u‴ = a′ and u″ = a; of velocity: v‴ = a″ and v″ = a′.
    let leading = [(delay * d[1] + ends * d[0]) / peak, (delay * d[3] + ends * d[1]) / PEAK];
    let error = [error[0] / peak, error[1] / PEAK];
    Ok(Outcome { error, surface: surface / PEAK, late: late / PEAK, history, leading })
}
