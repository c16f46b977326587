//! Plane waves that meet a joint at right angles.
//!
//! A wave f(t) comes from below to a joint of the stiffness k per area; g goes back and h on. With Z = ρc the traction of the
//! two halves is Z(g′ − f′) and −Zh′, both equal to k(h − f − g). So g = f − h and
//!
//! h′ + αh = αf, α = 2k/Z,
//!
//! which passes T = 1/(1 + iωZ/2k) of a harmonic wave and returns 1 − T, |1 − T| = |T| ωZ/2k. The pulse here is a Ricker
//! wavelet of velocity; h is that equation's solution, step by step with f as a parabola, to 10⁻⁹.
//!
//! Without a bond the joint carries compression alone. A pulse that only compresses keeps h < f + g, as h follows a rising f,
//! and passes by the same equation; one that only pulls opens it, and comes back as from a free surface, g = f.
//!
//! **Errors.** A row of lumped masses with half a mass at its end has the impedance Z cos(½κh) at the wave number κ, and an
//! increment over Δt is short of the velocity by (ωΔt)²/24. A path s delays a wave by δu = s h²(1 − C²)/(24c³) |u‴|
//! ([`super::incident_pulse`]). The joint passes or returns all of a wave at most: so twice the terms of impedance and delay
//! bound the error of the pulse's velocities. All this is of ground without viscosity; what the interface's own takes of a wave
//! stands beside.

use crate::convergence::order;
use crate::joints::joint;
use crate::models::{Solid, column};
use crate::simulation::{Simulation, whole_steps};
use crate::{Check, Effort, Verification, VerifyError};
use std::f64::consts::PI;
use tremolite::{Interface, Quadrature, Side};
use tremolite_motion::ricker_velocity;

const NAME: &str = "interface_waves";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "P and S waves through a joint: |T| = 1/√(1 + (ωZ/2k)²), the pulse itself; closed it passes, open it returns",
    source: "d'Alembert's solution on both sides of a spring, derived in the problem",
    from: Effort::Test,
    run,
};

const ROCK: Solid = Solid { young: 10e9, poisson: 0.25, density: 2700.0 };
/// Wavelength at the pulse's frequency \[m\].
const WAVELENGTH: f64 = 100.0;
/// Lengths of wave below and above the joint, from its place to the pulse's centre at the start, and run through.
/// Observed 1.5 lengths from the joint, where coming and going do not overlap; after 5 periods more exp(−αt) is below 3·10⁻⁵
/// at ωZ/2k = 3, and nothing is back from the ends, not even what little the row sends down at the start.
const LOW: f64 = 9.0;
const HIGH: f64 = 5.0;
const START: f64 = 3.0;
const PLACE: f64 = 1.5;
const RUN: f64 = START + PLACE + 5.0;
/// Peak velocity \[m/s\].
const PEAK: f64 = 0.1;
/// Elements a wavelength of the finer mesh.
const FINE: u32 = 40;

/// A vertical wave: its speed \[m/s\] and the axis of its motion.
#[derive(Clone, Copy)]
struct Wave {
    letter: &'static str,
    speed: f64,
    axis: usize,
}

impl Wave {
    fn frequency(&self) -> f64 {
        self.speed / WAVELENGTH
    }

    fn impedance(&self) -> f64 {
        ROCK.density * self.speed
    }
}

/// What is sent.
#[derive(Clone, Copy)]
enum Pulse {
    /// Velocity of both signs.
    Ricker,
    /// Velocity of one sign: V exp(−τ²), τ = πft.
    Bell(f64),
}

impl Pulse {
    /// Displacement \[m\] and velocity \[m/s\]; the peak passes at t = 0.
    fn at(self, frequency: f64, t: f64) -> [f64; 2] {
        match self {
            Pulse::Ricker => {
                let s = ricker_velocity(frequency, 0.0, PEAK)(t);
                [s.u, s.v]
            }
            Pulse::Bell(sign) => {
                let tau = PI * frequency * t;
                [sign * PEAK * integral_of_bell(tau) / (PI * frequency), sign * PEAK * (-tau * tau).exp()]
            }
        }
    }
}

/// ∫ exp(−x²) dx from −∞, by its series; beyond 5 less than 10⁻¹¹ is left.
fn integral_of_bell(x: f64) -> f64 {
    if x.abs() > 5.0 {
        return if x > 0.0 { PI.sqrt() } else { 0.0 };
    }
    // x Σ (2x²)^n/(1·3·…·(2n + 1)) · exp(−x²): all terms of one sign.
    let (mut term, mut sum) = (x, 0.0);
    for n in 1..200 {
        sum += term;
        term *= 2.0 * x * x / f64::from(2 * n + 1);
    }
    0.5 * PI.sqrt() + sum * (-x * x).exp()
}

/// What a run shows.
struct Outcome {
    /// Largest error of the velocities above and below over the peak.
    error: f64,
    /// |T| and |R| at the pulse's frequency.
    passed: f64,
    returned: f64,
    /// Largest velocity above over the peak.
    above: f64,
    /// Leading terms of the error.
    leading: f64,
}

/// A pulse through a joint of ωZ/2k = `ratio`; with `bond` it holds in tension. Elements beside it have this artificial viscosity.
fn through(
    wave: Wave,
    law: &str,
    ratio: f64,
    bond: bool,
    pulse: Pulse,
    n: u32,
    viscosity: f64,
) -> Result<Outcome, VerifyError> {
    let h = WAVELENGTH / f64::from(n);
    let [low, high] = [LOW, HIGH].map(|lengths| (lengths * f64::from(n)) as u32);
    let omega = 2.0 * PI * wave.frequency();
    let stiffness = omega * wave.impedance() / (2.0 * ratio);
    let mut problem = ROCK.fill(column(h, low + high, 1)?, Quadrature::OnePoint);
    let (below, above): (Vec<u32>, Vec<u32>) = (0..low + high).partition(|&e| e < low);
    let strength = if bond { 0.9 * stiffness } else { 0.0 };
    let numbers: Vec<(&str, f64)> = match law {
        // k_t of this law is k_n/2 at ν = 0; its hyperbola is straight to 10⁻⁴ m/T.
        "bandis" => {
            let normal = if wave.axis == 2 { stiffness } else { 2.0 * stiffness };
            vec![("normal_stiffness", normal), ("max_closure", 1e3), ("closure_floor", 1.0), ("poisson", 0.0)]
        }
        _ => vec![("normal_stiffness", stiffness), ("shear_stiffness", stiffness)],
    };
    let strengths = [("cohesion", strength), ("friction_coefficient", 0.5)];
    let numbers: Vec<_> = numbers.into_iter().chain(strengths).collect();
    let joint = joint([below, above], law, &numbers, &[])?;
    problem.interfaces = vec![Interface { viscosity, ..joint }];
    problem.sides = [Side::Periodic; 2];
    let simulation = Simulation::new(problem)?;
    let (steps, dt) = whole_steps(RUN * WAVELENGTH / wave.speed, 0.9 * simulation.stable());

    // The peak meets the joint at t₀.
    let (level, t0) = (LOW * WAVELENGTH, START * WAVELENGTH / wave.speed);
    let f = |t: f64| pulse.at(wave.frequency(), t - t0);
    let alpha = 2.0 * stiffness / wave.impedance();
    let passes = bond || matches!(pulse, Pulse::Bell(sign) if sign > 0.0);
    let exact = Spring::new(f, if passes { alpha } else { 0.0 }, steps as f64 * dt, dt / 8.0);
    let place = PLACE * WAVELENGTH;
    let delay = place / wave.speed;
    let [low, high] = [level - place, level + place].map(|z| simulation.node([0.0, 0.0, z]));
    let (low, high) = (low?, high?);

    let mut engine = simulation.engine();
    let mut state = simulation.start(&mut engine, dt, |node| {
        let [u, v] = f((level - simulation.position(node)[2]) / wave.speed);
        let (mut motion, here) = ([[0.0; 3]; 2], simulation.position(node)[2] <= level);
        // All of the pulse is below; a bell has moved what it has left.
        if here {
            (motion[0][wave.axis], motion[1][wave.axis]) = (u, v);
        }
        motion
    });
    let mut out = Outcome { error: 0.0, passed: 0.0, returned: 0.0, above: 0.0, leading: 0.0 };
    let mut sums = [[0.0; 2]; 3];
    for _ in 0..steps {
        engine.step(&mut state);
        let [(u, t), (v, above)] = [low, high].map(|node| simulation.velocity(&state, node));
        let [u, v] = [u[wave.axis], v[wave.axis]];
        let incident = f(t + delay)[1];
        let ([g, _], [_, h]) = (exact.velocities(t - delay), exact.velocities(above - delay));
        out.error = out.error.max((u - incident - g).abs()).max((v - h).abs());
        out.above = out.above.max(v.abs());
        // Below, all is coming before t₀ and going after it.
        let [coming, back] = if t > t0 { [0.0, u] } else { [u, 0.0] };
        for (sum, x) in sums.iter_mut().zip([coming, v, back]) {
            sum[0] += x * (omega * t).cos();
            sum[1] += x * (omega * t).sin();
        }
    }
    let [sent, passed, returned] = sums.map(|[c, s]: [f64; 2]| c.hypot(s));
    out.passed = passed / sent;
    out.returned = returned / sent;
    // v″ and v‴ of the pulse by differences.
    let e = 1e-3 / wave.frequency();
    for i in -1500..1500 {
        let [a, b, c, d] = [-1.5, -0.5, 0.5, 1.5].map(|k| pulse.at(wave.frequency(), (f64::from(i) + k) * e)[1]);
        let (second, third) = ((a - b - c + d) / (2.0 * e * e), (d - 3.0 * c + 3.0 * b - a) / e.powi(3));
        let (cell, courant) = (h / wave.speed, wave.speed * dt / h);
        let delay = (START + PLACE) / wave.frequency() * cell * cell * (1.0 - courant * courant) / 24.0;
        out.leading = out.leading.max(delay * third.abs() + cell * cell / 8.0 * second.abs());
    }
    for x in [&mut out.leading, &mut out.error, &mut out.above] {
        *x /= PEAK;
    }
    Ok(out)
}

/// g′ and h′ over time.
struct Spring<F> {
    f: F,
    alpha: f64,
    step: f64,
    h: Vec<f64>,
}

impl<F: Fn(f64) -> [f64; 2]> Spring<F> {
    /// The solution up to a time, by steps of `step` in which f is a parabola.
    fn new(f: F, alpha: f64, end: f64, step: f64) -> Self {
        let count = (end / step).ceil() as usize + 1;
        let mut h = vec![0.0; count + 1];
        let q = alpha * step;
        // Moments ∫₀¹ q exp(−q(1 − s)) s^m ds, m = 0, 1, 2.
        let m0 = -(-q).exp_m1();
        let m1 = if q > 0.0 { 1.0 - m0 / q } else { 0.0 };
        let m2 = if q > 0.0 { 1.0 - 2.0 * m1 / q } else { 0.0 };
        for i in 0..count {
            let t = step * i as f64;
            let [a, b, c] = [t, t + 0.5 * step, t + step].map(|t| f(t)[0]);
            // f = a + (4b − 3a − c) s + 2(a − 2b + c) s².
            let forced = a * m0 + (4.0 * b - 3.0 * a - c) * m1 + 2.0 * (a - 2.0 * b + c) * m2;
            h[i + 1] = h[i] * (-q).exp() + forced;
        }
        Spring { f, alpha, step, h }
    }

    /// g′ and h′ at a time.
    fn velocities(&self, t: f64) -> [f64; 2] {
        if t <= 0.0 {
            return [0.0; 2];
        }
        let at = t / self.step;
        let (i, s) = (at as usize, at.fract());
        let [u, v] = (self.f)(t);
        let h = (1.0 - s) * self.h[i] + s * self.h[i + 1];
        let passed = self.alpha * (u - h);
        [v - passed, passed]
    }
}

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let (p, s) = ROCK.speeds();
    let mut checks = Vec::new();
    for wave in [Wave { letter: "P", speed: p, axis: 2 }, Wave { letter: "S", speed: s, axis: 0 }] {
        let letter = wave.letter;
        for (law, ratio) in [("coulomb", 0.3), ("coulomb", 1.0), ("coulomb", 3.0), ("bandis", 1.0)] {
            let run = |n, viscosity| through(wave, law, ratio, true, Pulse::Ricker, n, viscosity);
            let (fine, coarse) = (run(FINE, 0.0)?, run(FINE / 2, 0.0)?);
            let of = |what: &str| format!("{letter}: {what}, ωZ/2k = {ratio}, {law}");
            let exact = 1.0 / ratio.hypot(1.0);
            for (what, found, exact) in
                [("passed", [coarse.passed, fine.passed], exact), ("returned", [coarse.returned, fine.returned], ratio * exact)]
            {
                let note = "(κh)²(1/8 + 1/24), 0.4 % at 40 elements a wavelength: errors of Z and of ω in Δt; |T| and |R| go by a part of them";
                let p = order((found[0] - exact).abs(), (found[1] - exact).abs(), 2.0);
                let near = (2.0 * PI / f64::from(FINE)).powi(2) / 6.0;
                checks.push(Check::new(NAME, of(what), found[1], exact, near * exact, "1", note).with_order(p));
                let note = "cos(½κh): order 2, Δt ∝ h; the next term is (κh)²/48 of it";
                let quantity = of(&format!("order in h of what is {what}"));
                checks.push(Check::new(NAME, quantity, p, 2.0, 0.1, "1", note).with_order(p));
            }
            let (viscous, coarser) = (run(FINE, Interface::VISCOSITY)?, run(FINE / 2, Interface::VISCOSITY)?);
            for (what, of_run) in [("passed", (|o| o.passed) as fn(&Outcome) -> f64), ("returned", |o| o.returned)] {
                let [change, before] =
                    [[&viscous, &fine], [&coarser, &coarse]].map(|[a, b]| (of_run(a) - of_run(b)).abs());
                let note = "b(κh)²: what a wave loses in two layers of elements whose modulus is M(1 + ibκh); of order 2";
                let most = Interface::VISCOSITY * (2.0 * PI / f64::from(FINE)).powi(2);
                let quantity = of(&format!("what the interface's viscosity takes of what is {what}"));
                let check = Check::new(NAME, quantity, change, 0.0, most, "1", note);
                checks.push(check.with_order(order(before, change, 2.0)));
            }
            let note = "twice the leading terms of the row and of its end";
            let quantity = of("error of velocities over the peak");
            let check = Check::new(NAME, quantity, fine.error, 0.0, 2.0 * fine.leading, "1", note);
            checks.push(check.with_order(order(coarse.error, fine.error, 2.0)));
        }
        if wave.axis != 2 {
            continue;
        }
        // Without a bond.
        let ratio = 0.1;
        let [pressed, pulled] = [1.0, -1.0].map(|sign| through(wave, "coulomb", ratio, false, Pulse::Bell(sign), FINE, 0.0));
        let (pressed, pulled) = (pressed?, pulled?);
        let of = |what: &str| format!("{letter}: {what}, no bond, ωZ/2k = {ratio}");
        let note = "twice the leading terms of the row and of its end";
        for (outcome, word) in [(&pressed, "compression"), (&pulled, "tension")] {
            let quantity = of(&format!("error of velocities of a {word} pulse over the peak"));
            checks.push(Check::new(NAME, quantity, outcome.error, 0.0, 2.0 * outcome.leading, "1", note));
        }
        let note = "the open joint carries nothing: but for what the row's ringing presses, 1e-6";
        checks.push(Check::new(NAME, of("what passes of a tension pulse over its peak"), pulled.above, 0.0, 1e-6, "1", note));
    }
    Ok(checks)
}
