//! Second order in Δt, with and without damping.
//!
//! On a fixed mesh the semi-discrete equations M ü + C u̇ + K u = 0 with Rayleigh's C = ωM + ξK have the exact solution
//! Σ φ_i q_i(t): each mode (λ_i = ω_i², c_i = ω + ξλ_i) is a damped oscillator,
//! q = e^{−½ct} \[q₀ cos ω_d t + (q̇₀ + ½c q₀) sin(ω_d t)/ω_d\], ω_d² = λ − ¼c².
//! The mesh is a small distorted block on a fixed base; the start is a static deflection under random forces, with
//! the velocity of another. Errors at a fixed time are measured in the norm of M (displacement and v̂ of (21)).

use crate::convergence::order;
use crate::models::{Solid, distorted};
use crate::simulation::{Simulation, whole_steps};
use crate::stiffness::Assembled;
use crate::{Check, Effort, Verification, VerifyError};
use tremolite::{Base, Quadrature, Rayleigh};

const NAME: &str = "time_order";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "order 2 in the time step, undamped and with both Rayleigh terms",
    source: "exact solution of the semi-discrete equations by modes",
    from: Effort::Test,
    run,
};

const ROCK: Solid = Solid { young: 10e9, poisson: 0.25, density: 2700.0 };

fn block(rayleigh: Rayleigh) -> Result<Simulation, VerifyError> {
    let mut problem = ROCK.fill(distorted([1.0, 1.0, 3.0], [1, 1, 3], 0.12)?, Quadrature::Full);
    problem.base = Base::Fixed;
    problem.rayleigh = rayleigh;
    Simulation::on_one_level(problem)
}

/// A deflection \[m\] by unknown under forces without symmetry.
fn deflection(system: &Assembled, seed: f64) -> Result<Vec<f64>, VerifyError> {
    let forces: Vec<f64> = (0..system.mass.len()).map(|i| 1e6 * (seed * (i * i + 1) as f64).sin()).collect();
    system.stiffness.solve(&forces)
}

/// Displacement and velocity of the modal solution at `t` \[s\].
fn exact(system: &Assembled, rayleigh: Rayleigh, start: [&[f64]; 2], t: f64) -> [Vec<f64>; 2] {
    let n = system.mass.len();
    let (lambda, shapes) = system.modes();
    let mut out = [vec![0.0; n], vec![0.0; n]];
    for (lambda, shape) in lambda.iter().zip(shapes.values.chunks_exact(n)) {
        let [q0, p0] = start.map(|x| (0..n).map(|i| shape[i] * system.mass[i] * x[i]).sum::<f64>());
        let half = 0.5 * (rayleigh.mass + rayleigh.stiffness * lambda);
        let wd = (lambda - half * half).sqrt();
        let b = (p0 + half * q0) / wd;
        let (sine, cosine) = (wd * t).sin_cos();
        let decay = (-half * t).exp();
        let q = decay * (q0 * cosine + b * sine);
        let p = decay * wd * (b * cosine - q0 * sine) - half * q;
        for i in 0..n {
            out[0][i] += shape[i] * q;
            out[1][i] += shape[i] * p;
        }
    }
    out
}

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let undamped = block(Rayleigh::default())?;
    let system = Assembled::new(&undamped);
    let (lambda, _) = system.modes();
    let (lowest, highest) = (lambda[0].sqrt(), lambda[lambda.len() - 1].sqrt());
    // A tenth of critical in the lowest mode; three tenths in the highest.
    let mass = Rayleigh { mass: 0.2 * lowest, stiffness: 0.0 };
    let stiffness = Rayleigh { mass: 0.0, stiffness: 0.6 / highest };
    let end = 2.0 * std::f64::consts::TAU / lowest;
    let mut checks = Vec::new();
    for (rayleigh, word) in [
        (Rayleigh::default(), "undamped"),
        (mass, "damping ∝ mass"),
        (stiffness, "damping ∝ stiffness"),
        (Rayleigh { mass: mass.mass, stiffness: stiffness.stiffness }, "both dampings"),
    ] {
        let simulation = block(rayleigh)?;
        let stable = simulation.stable();
        let u0 = deflection(&system, 1.3)?;
        // A velocity of the size that the lowest mode's motion has.
        let v0: Vec<f64> = deflection(&system, 2.9)?.into_iter().map(|u| u * lowest).collect();
        let reference = exact(&system, rayleigh, [&u0, &v0], end);
        let errors =
            |divide: f64| errors(&simulation, &system, [&u0, &v0], end, 0.8 * stable / divide, &reference);
        let (coarse, fine) = (errors(16.0)?, errors(32.0)?);
        for (k, what) in ["displacement", "velocity"].into_iter().enumerate() {
            let p = order(coarse[k], fine[k], 2.0);
            let note = format!(
                "steps of 1/20 and 1/40 of the stable one, error {:.1e} at the finer: small enough for the highest \
                 modes, whose phase error over the run must be below one, to be in the range of the order as well",
                fine[k]
            );
            let quantity = format!("order in Δt of {what}, {word}");
            checks.push(Check::new(NAME, quantity, p, 2.0, 0.05, "1", note).with_order(p));
        }
    }
    Ok(checks)
}

/// Errors of displacement and velocity at `end`, in the norm of M over the reference's.
fn errors(
    simulation: &Simulation,
    system: &Assembled,
    start: [&[f64]; 2],
    end: f64,
    most: f64,
    reference: &[Vec<f64>; 2],
) -> Result<[f64; 2], VerifyError> {
    let (steps, dt) = whole_steps(end, most);
    let [u0, v0] = start.map(|x| system.spread(simulation, x));
    let mut engine = simulation.engine();
    let mut state = simulation.start(&mut engine, dt, |n| [u0[n], v0[n]]);
    for _ in 0..steps {
        engine.step(&mut state);
    }
    let velocity = engine.look(&state).snapshot.velocity;
    let found = [system.gather(&state.u), system.gather(&velocity)];
    Ok([0, 1].map(|k| {
        let norm = |x: &dyn Fn(usize) -> f64| {
            system.mass.iter().enumerate().map(|(i, m)| m * x(i) * x(i)).sum::<f64>()
        };
        (norm(&|i| found[k][i] - reference[k][i]) / norm(&|i| reference[k][i])).sqrt()
    }))
}
