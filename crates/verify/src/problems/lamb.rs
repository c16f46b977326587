//! Lamb's problem: a vertical point load on the surface of a half-space.
//!
//! For ν = ¼ and a load Z that acts from t = 0 on, the surface at the distance r moves along the load by
//! w = Z/(πμr) W(τ), τ = c_s t/r (Pekeris 1955):
//!
//! - W = 0 for τ < 1/√3,
//! - W = (1/32) \[6 − √3/√(τ² − ¼) − a/√(γ² − τ²) + b/√(τ² − p²)\] for 1/√3 < τ < 1,
//! - W = (1/16) \[6 − a/√(γ² − τ²)\] for 1 < τ < γ,
//! - W = 3/8 for τ > γ, the static value (1 − ν)/2 of Boussinesq,
//!
//! a, b = √(3√3 ± 5), γ² = (3 + √3)/4 (the Rayleigh wave), p² = (3 − √3)/4. The integral ∫W dτ is elementary and
//! bounded, so the answer to a smooth load Z g(t) is (Z/(πμr)) (r/c_s) ∫ I(c_s(t − s)/r) g″(s) ds, I = ∫W.
//!
//! The load is g = t/T − sin(2πt/T)/(2π): the spectrum of g′ is zero at 2/T and below 3 % beyond, so the shortest
//! wavelength is ½ c_s T. A quarter of the half-space is modelled, rollers on the planes of symmetry, the other sides
//! so far that nothing comes back from them in time.

use crate::convergence::order;
use crate::models::{QUADRATURES, Solid, nodes_at_level};
use crate::simulation::{Simulation, whole_steps};
use crate::{Check, Effort, Verification, VerifyError};
use std::f64::consts::{PI, TAU};
use std::sync::Arc;
use tremolite::parts::loads::Load;
use tremolite::{Base, Quadrature};
use tremolite_mesh::boxes::BoxSpec;

const NAME: &str = "lamb";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "point load on a half-space: vertical surface motion with P, S and Rayleigh waves",
    source: "Pekeris 1955, PNAS 41:469-480, nu = 1/4",
    from: Effort::Verify,
    run,
};

const GROUND: Solid = Solid { young: 10e9, poisson: 0.25, density: 2700.0 };
/// Distance \[m\] of the farthest receiver.
const FAR: f64 = 100.0;
/// Load \[N\].
const LOAD: f64 = 1e9;

/// τ of the Rayleigh wave.
fn gamma() -> f64 {
    (0.75 + 0.25 * 3f64.sqrt()).sqrt()
}

/// I(τ) = ∫₀^τ W dτ.
fn integral(tau: f64) -> f64 {
    let (root, gamma) = (3f64.sqrt(), gamma());
    let (a, b) = ((3.0 * root + 5.0).sqrt(), (3.0 * root - 5.0).sqrt());
    let p = (0.75 - 0.25 * root).sqrt();
    let first =
        |x: f64| (6.0 * x - root * (2.0 * x).acosh() - a * (x / gamma).asin() + b * (x / p).acosh()) / 32.0;
    let second = |x: f64| (6.0 * x - a * (x / gamma).asin()) / 16.0;
    let start = 1.0 / root;
    let mut sum = 0.0;
    if tau > start {
        sum += first(tau.min(1.0)) - first(start);
    }
    if tau > 1.0 {
        sum += second(tau.min(gamma)) - second(1.0);
    }
    sum + 0.375 * (tau - gamma).max(0.0)
}

/// The load's rise over `rise` \[s\].
fn ramp(t: f64, rise: f64) -> f64 {
    let x = (t / rise).clamp(0.0, 1.0);
    x - (TAU * x).sin() / TAU
}

/// Displacement \[m\] along the load at the distance `r` \[m\].
fn exact(r: f64, t: f64, rise: f64) -> f64 {
    let (_, speed) = GROUND.speeds();
    let panels = 2000;
    let step = rise / f64::from(panels);
    // g″ vanishes at both ends of the rise, so the sum is the trapezoidal rule.
    let sum: f64 = (1..panels)
        .map(|i| f64::from(i) * step)
        .map(|s| integral(speed * (t - s) / r) * (TAU * s / rise).sin() * TAU / (rise * rise) * step)
        .sum();
    LOAD / (PI * GROUND.moduli().mu * speed) * sum
}

fn run(effort: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    let coarse = errors(Quadrature::OnePoint, 16)?;
    let fine = errors(Quadrature::OnePoint, 32)?;
    report(&mut checks, &fine, Some(&coarse), 32, "one-point");
    let mut finest = (&coarse, &fine, 2.0);
    let finer;
    if effort == Effort::Full {
        let (quadrature, word) = QUADRATURES[1];
        report(&mut checks, &errors(quadrature, 32)?, None, 32, word);
        finer = errors(Quadrature::OnePoint, 48)?;
        finest = (&fine, &finer, 1.5);
        report(&mut checks, &finer, Some(&fine), 48, "one-point");
    }
    let worst = |e: &[(String, f64)]| e.iter().map(|(_, e)| *e).fold(0.0, f64::max);
    let p = order(worst(finest.0), worst(finest.1), finest.2);
    let note =
        "order 2 for smooth waves; the pulse's highest components are not yet small in kh at 10 elements";
    checks.push(Check::new(NAME, "order in h of the largest error", p, 2.0, 0.5, "1", note).with_order(p));
    Ok(checks)
}

fn report(
    checks: &mut Vec<Check>,
    errors: &[(String, f64)],
    coarse: Option<&[(String, f64)]>,
    elements: u32,
    word: &str,
) {
    for (i, (place, error)) in errors.iter().enumerate() {
        let wave = f64::from(elements) * 10.0 / 32.0;
        let quantity = format!("error of displacement over its peak, r = {place}, h = R/{elements}, {word}");
        let note = format!("5 % at {wave} elements a shortest wavelength: (kh)²/24 = 1.6 % a radian at 10");
        let check = Check::new(NAME, quantity, *error, 0.0, 0.05, "1", note);
        checks.push(match coarse {
            Some(coarse) => {
                check.with_order(order(coarse[i].1, *error, if elements == 48 { 1.5 } else { 2.0 }))
            }
            None => check,
        });
    }
}

/// Largest errors over the peaks at some receivers, with elements of `FAR`/`elements`.
fn errors(quadrature: Quadrature, elements: u32) -> Result<Vec<(String, f64)>, VerifyError> {
    let (p, s) = GROUND.speeds();
    let h = FAR / f64::from(elements);
    // Ten elements of FAR/32 in the shortest wavelength ½ c_s T.
    let rise = 20.0 * FAR / 32.0 / s;
    let end = gamma() * FAR / s + 1.1 * rise;
    // From the source to a side and back to the farthest receiver, and the same by way of the base.
    let travel = p * end;
    let side = (0.5 * (travel + FAR) / h).ceil() as u32 + 1;
    let deep = ((0.5 * travel).hypot(0.5 * FAR) / h).ceil() as u32 + 1;
    let (width, depth) = (h * f64::from(side), h * f64::from(deep));
    let mesh = BoxSpec::uniform([0.0, 0.0, -depth], [width, width, 0.0], [side, side, deep]).mesh()?;
    let corner = side as usize + 1;
    let corner = (corner * corner * deep as usize) as u32;

    let planes = [0, 1].map(|axis| nodes_at_level(&mesh, axis, 0.0));
    let mut problem = GROUND.fill(mesh, quadrature);
    for (axis, nodes) in planes.into_iter().enumerate() {
        let mut held = [false; 3];
        held[axis] = true;
        problem.held.extend(nodes.into_iter().map(|n| (n, held)));
    }
    problem.base = Base::Viscous;
    let factor = Arc::new(move |t: f64| ramp(t, rise));
    problem.loads = vec![Load { forces: vec![(corner, [0.0, 0.0, -0.25 * LOAD])], factor }];
    let simulation = Simulation::new(problem)?;
    let (steps, dt) = whole_steps(end, 0.9 * simulation.stable());

    let half = 0.5 * FAR;
    let places = [("R/2", [half, 0.0]), ("R", [FAR, 0.0]), ("R/√2 across", [half, half])];
    let mut receivers = Vec::new();
    for (name, [x, y]) in places {
        receivers.push((name, x.hypot(y), simulation.node([x, y, 0.0])?, 0.0f64, 0.0f64));
    }
    simulation.run_from_rest(dt, steps, |state| {
        for (_, r, node, error, peak) in &mut receivers {
            let w = exact(*r, state.time(), rise);
            *error = error.max((-state.u[*node].0[2] - w).abs());
            *peak = peak.max(w.abs());
        }
    })?;
    Ok(receivers.into_iter().map(|(name, _, _, error, peak)| (name.to_owned(), error / peak)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The integrand of Cagniard's solution, from the half-space's Rayleigh function: W(τ) is −1/π times its integral
    /// over the slowness x from 1/√3 to τ, with the weight x/√(τ² − x²).
    fn cagniard(x: f64) -> f64 {
        let a = (x * x - 1.0 / 3.0).max(0.0).sqrt();
        let square = 1.0 - 2.0 * x * x;
        if x < 1.0 {
            let b = (1.0 - x * x).sqrt();
            a * square.powi(2) / (square.powi(4) + 16.0 * (x * x * a * b).powi(2))
        } else {
            a / (square.powi(2) - 4.0 * x * x * a * (x * x - 1.0).sqrt())
        }
    }

    #[test]
    fn the_closed_form_is_the_integral_of_cagniards_solution() {
        let x0 = 1.0 / 3f64.sqrt();
        for tau in [0.6, 0.75, 0.9, 0.99, 1.04, 1.06] {
            let n = 20_000;
            // x = x₀ + (τ − x₀) sin²: the square root at the end disappears.
            let w: f64 = (0..n)
                .map(|i| {
                    let angle = (f64::from(i) + 0.5) / f64::from(n) * 0.5 * PI;
                    let (sine, cosine) = angle.sin_cos();
                    let x = x0 + (tau - x0) * sine * sine;
                    let dx = 2.0 * (tau - x0) * sine * cosine * 0.5 * PI / f64::from(n);
                    -cagniard(x) * x / (tau * tau - x * x).sqrt() * dx / PI
                })
                .sum();
            let e = 1e-5;
            let closed = (integral(tau + e) - integral(tau - e)) / (2.0 * e);
            assert!((closed - w).abs() < 1e-6 * (1.0 + w.abs()), "τ = {tau}: {closed} against {w}");
        }
    }

    #[test]
    fn after_the_rayleigh_wave_the_load_is_static() {
        let rise = 0.01;
        let (_, s) = GROUND.speeds();
        let w = exact(FAR, gamma() * FAR / s + 1.01 * rise, rise);
        let boussinesq = LOAD * 0.75 / (2.0 * PI * GROUND.moduli().mu * FAR);
        assert!((w / boussinesq - 1.0).abs() < 1e-6, "{w} against {boussinesq}");
        assert_eq!(exact(FAR, FAR / (3f64.sqrt() * s) * 0.999, rise), 0.0);
    }
}
