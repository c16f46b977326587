//! A soft layer on rock: all echoes of a vertical S wave.
//!
//! A layer of thickness H and speed V_s on a half-space of speed V_r and the same density (impedance ratio
//! α = V_s/V_r, R = (1 − α)/(1 + α)) answers the outcrop motion u_o(t), twice the incident wave at the interface, with
//! u_s(t) = 2/(1 + α) Σ_m (−R)^m u_o(t − (2m + 1)H/V_s) at its surface (Kramer 1996, section 7.2; Roesset 1970). The
//! model has a slab of rock under the layer, of thickness D, so the wave that enters at its base comes D/V_r later; the
//! base must take all that the layer returns.
//!
//! The leading error is the layer's dispersion, δu = s V_s⁻³ h²/24 |u‴| over the path s, summed over all echoes:
//! Σ (2m + 1) R^m = (1 + R)/(1 − R)².

use crate::convergence::order;
use crate::models::{SIDES, Solid};
use crate::simulation::{Simulation, whole_steps};
use crate::{Check, Effort, Verification, VerifyError};
use std::f64::consts::PI;
use tremolite::{Base, Incident, Quadrature, Side};
use tremolite_mesh::boxes::{Axis, BoxSpec};
use tremolite_motion::{Motion, Scalar};

const NAME: &str = "layered_column";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "soft layer on rock under an S pulse: the surface motion with all echoes",
    source: "closed form of an undamped layer on an elastic half-space (Kramer 1996, section 7.2)",
    from: Effort::Test,
    run,
};

/// Thickness of the layer and of the rock below it in the model \[m\].
const LAYER: f64 = 200.0;
const ROCK: f64 = 100.0;
const SPEEDS: [f64; 2] = [1000.0, 2300.0];
const DENSITY: f64 = 2752.3;
/// Peak frequency \[Hz\] and centre \[s\] of the outcrop's displacement, a Ricker wavelet of 1 m.
const FREQUENCY: f64 = 2.5;
const CENTRE: f64 = 0.6;
const END: f64 = 4.0;

/// Impedance ratio α and reflection R.
fn contrast() -> (f64, f64) {
    let alpha = SPEEDS[0] / SPEEDS[1];
    (alpha, (1.0 - alpha) / (1.0 + alpha))
}

/// The outcrop motion: displacement (1 − 2τ²) exp(−τ²), τ = πf(t − t₀), and its derivatives.
fn outcrop(t: f64) -> Scalar {
    let k = PI * FREQUENCY;
    let tau = k * (t - CENTRE);
    let bell = (-tau * tau).exp();
    let square = tau * tau;
    Scalar {
        u: (1.0 - 2.0 * square) * bell,
        v: k * tau * (4.0 * square - 6.0) * bell,
        a: k * k * (-8.0 * square * square + 24.0 * square - 6.0) * bell,
    }
}

/// Displacement of the surface \[m\], time counted from the outcrop's at the interface.
fn surface(t: f64) -> f64 {
    let (alpha, r) = contrast();
    let echoes = (0..40).map(|m| (-r).powi(m) * outcrop(t - f64::from(2 * m + 1) * LAYER / SPEEDS[0]).u);
    2.0 / (1.0 + alpha) * echoes.sum::<f64>()
}

fn run(effort: Effort) -> Result<Vec<Check>, VerifyError> {
    let fine = if effort == Effort::Full { 2.5 } else { 5.0 };
    let (alpha, r) = contrast();
    let e = 1e-3;
    let third =
        (0..1200).map(|i| f64::from(i) * e).map(|t| (outcrop(t + e).a - outcrop(t - e).a) / (2.0 * e));
    let third = third.fold(0.0, |m: f64, x| m.max(x.abs()));
    let bound = |h: f64| {
        let path = LAYER * (1.0 + r) / (1.0 - r).powi(2);
        2.0 / (1.0 + alpha) * path * h * h / (24.0 * SPEEDS[0].powi(3)) * third
    };
    let springs = Base::ViscousSpring { normal: 1.33, tangential: 0.67, distance: None };
    let kinds = [
        (Base::Viscous, Quadrature::OnePoint, "viscous base"),
        (Base::Viscous, Quadrature::Full, "viscous base, full"),
        (springs, Quadrature::OnePoint, "viscous-spring base"),
    ];
    let mut checks = Vec::new();
    for &(sides, with) in SIDES {
        let coarse = error(2.0 * fine, Base::Viscous, sides, Quadrature::OnePoint)?;
        for (base, quadrature, kind) in kinds {
        let error = error(fine, base, sides, quadrature)?;
        let note = format!("bound of the leading term, elements of {fine} m; the peak is 1.39 m");
        let quantity = format!("largest error of the surface's displacement, {kind}{with}");
        let check = Check::new(NAME, quantity, error, 0.0, bound(fine), "m", note);
        let p = order(coarse, error, 2.0);
        checks.push(check.with_order(p));
        if kind == "viscous base" {
            let note = "order 2 in h, Δt ∝ h, less (kh)²/10 at three times the peak frequency, that is 0.06";
            let quantity = format!("order in h of the surface's displacement{with}");
            checks.push(Check::new(NAME, quantity, p, 2.0, 0.1, "1", note));
        }
        }
    }
    Ok(checks)
}

/// Largest error \[m\] with elements of height `h` \[m\].
fn error(h: f64, base: Base, sides: Side, quadrature: Quadrature) -> Result<f64, VerifyError> {
    let layers = ((LAYER + ROCK) / h).round() as u32;
    let across = Axis::uniform(0.0, h, 1);
    let z = Axis::uniform(-LAYER - ROCK, 0.0, layers);
    let mesh = BoxSpec { x: across.clone(), y: across, z, distortion: None }.mesh()?;
    let (rock, soil): (Vec<u32>, Vec<u32>) =
        (0..layers).partition(|&e| tremolite::hexahedra::centroid(&mesh, e)[2] < -LAYER);
    let [soft, stiff] = SPEEDS.map(|speed| Solid::from_shear_speed(speed, 0.25, DENSITY));
    let bodies = vec![stiff.body("rock", rock, quadrature), soft.body("layer", soil, quadrature)];
    let mut problem = tremolite::Problem::new(mesh, bodies);
    problem.sides = [sides; 2];
    problem.base = base;
    let delay = ROCK / SPEEDS[1];
    let motion = Motion::sampled(1e-3, END, |t| outcrop(t).along([1.0, 0.0, 0.0]))?;
    problem.incident = Some(Incident { motion, factor: 0.5 });
    let simulation = Simulation::new(problem)?;
    let top = simulation.node([0.0, 0.0, 0.0])?;
    let (steps, dt) = whole_steps(END, 0.9 * simulation.stable());
    let mut worst = 0.0f64;
    simulation.run_from_rest(dt, steps, |state| {
        worst = worst.max((state.u[top].0[0] - surface(state.time() - delay)).abs());
    })?;
    Ok(worst)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values of the same closed form worked out elsewhere, checked against a Fourier synthesis.
    #[test]
    fn the_closed_form_has_its_tabulated_values() {
        for (t, exact) in [
            (0.6, -0.4651447353682689),
            (0.8, 1.3944716367755186),
            (0.95, -0.539847545472917),
            (1.2, -0.5506883894256472),
            (1.6, 0.21693785037979962),
            (3.2, 0.0052245992310596245),
        ] {
            assert!((surface(t) - exact).abs() < 1e-12, "{t}: {} against {exact}", surface(t));
        }
    }

    #[test]
    fn the_outcrop_motion_is_its_own_derivative() {
        let e = 1e-5;
        for i in 0..120 {
            let t = 0.01 * f64::from(i);
            let (a, b, c) = (outcrop(t - e), outcrop(t), outcrop(t + e));
            assert!(
                ((c.u - a.u) / (2.0 * e) - b.v).abs() < 1e-6 && ((c.v - a.v) / (2.0 * e) - b.a).abs() < 1e-4
            );
        }
    }
}
