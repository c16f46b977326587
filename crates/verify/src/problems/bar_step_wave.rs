//! A step of traction at the end of a bar.
//!
//! A bar of impedance ρc, c = √(E/ρ) (ν = 0), gets the pressure σ₀ at one end at t = 0. Behind the front, at x < ct,
//! the particle velocity is v = σ₀/(ρc) and the stress −σ₀. A fixed far end doubles the stress and stops the motion; a
//! free one doubles the velocity and cancels the stress (Graff 1975, chapter 2; d'Alembert's solution).
//!
//! A scheme without dissipation rings behind a front. In the equation that central differences solve,
//! u_tt = c²(u_xx + (h²/12)(1 − C²) u_xxxx) with the Courant number C, a step becomes the integral of an Airy function
//! of the width (h²t)^{1/3}, whose ringing decays as x^{−3/4}: means behind the front converge quickly, and the error in
//! L₁ as h^{2/3} · (h^{−2/3})^{1/4} = h^{1/2}.

use crate::convergence::order;
use crate::models::{QUADRATURES, Solid, nodes_at_level, shared};
use crate::simulation::{Simulation, whole_steps};
use crate::{Check, Effort, Verification, VerifyError};
use tremolite::{Quadrature, Snapshot};
use tremolite_mesh::boxes::BoxSpec;

const NAME: &str = "bar_step_wave";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "step traction on a bar: v = σ₀/(ρc), doubled at a fixed end, cancelled at a free one",
    source: "d'Alembert's solution (Graff 1975, chapter 2)",
    from: Effort::Test,
    run,
};

const BAR: Solid = Solid { young: 10e9, poisson: 0.0, density: 2752.3 };
/// Length \[m\] and pressure \[Pa\].
const LENGTH: f64 = 100.0;
const PRESSURE: f64 = 1e6;

/// A bar of `elements`, loaded at z = 0, at one time.
struct Bar {
    simulation: Simulation,
    snapshot: Snapshot,
}

impl Bar {
    /// The bar when the front has travelled `lengths` of it.
    fn at(elements: u32, quadrature: Quadrature, fixed: bool, lengths: f64) -> Result<Self, VerifyError> {
        let h = LENGTH / f64::from(elements);
        let mesh = BoxSpec::uniform([0.0; 3], [h, h, LENGTH], [1, 1, elements]).mesh()?;
        let [loaded, far] = [0.0, LENGTH].map(|z| nodes_at_level(&mesh, 2, z));
        let mut problem = BAR.fill(mesh, quadrature);
        problem.loads = vec![shared(&loaded, [0.0, 0.0, PRESSURE * h * h], |_| 1.0)];
        if fixed {
            problem.held = far.into_iter().map(|n| (n, [true; 3])).collect();
        }
        let simulation = Simulation::new(problem)?;
        let speed = (BAR.young / BAR.density).sqrt();
        let (steps, dt) = whole_steps(lengths * LENGTH / speed, 0.9 * simulation.stable());
        let snapshot = simulation.run_from_rest(dt, steps, |_| {})?;
        Ok(Bar { simulation, snapshot })
    }

    /// Means of velocity \[m/s\] and stress \[Pa\] along the bar between two places.
    fn means(&self, from: f64, to: f64) -> [f64; 2] {
        let (mut v, mut s) = ((0.0, 0.0), (0.0, 0.0));
        for (n, row) in self.snapshot.velocity.iter().enumerate() {
            if (from..=to).contains(&self.simulation.position(n)[2]) {
                v = (v.0 + row.0[2], v.1 + 1.0);
            }
        }
        let mesh = &self.simulation.model.mesh;
        for (e, slot) in self.simulation.phase.element_slot.iter().enumerate() {
            let z = tremolite::hexahedra::centroid(mesh, e as u32)[2];
            if let (Some(slot), true) = (slot, (from..=to).contains(&z)) {
                for point in 0..slot.points {
                    s = (s.0 + self.snapshot.stress[slot.point as usize + usize::from(point)][2], s.1 + 1.0);
                }
            }
        }
        [v.0 / v.1, s.0 / s.1]
    }

    /// ∫|v − v_exact| dz over that of v_exact, the front at `front`.
    fn error(&self, front: f64, v: f64) -> f64 {
        let mut sum = 0.0;
        for (n, row) in self.snapshot.velocity.iter().enumerate() {
            let z = self.simulation.position(n)[2];
            sum += (row.0[2] - if z < front { v } else { 0.0 }).abs();
        }
        sum / self.snapshot.velocity.len() as f64 * LENGTH / (front * v)
    }
}

fn run(effort: Effort) -> Result<Vec<Check>, VerifyError> {
    let v = PRESSURE / (BAR.density * BAR.young).sqrt();
    let fine = if effort == Effort::Full { 800 } else { 400 };
    let mut checks = Vec::new();
    let mut compare = |what: &str, value: f64, exact: f64, scale: f64, unit, word: &str| {
        let note =
            "0.5 %: ringing of 30 % at most with waves of a few elements, over a window of 100 and more";
        let quantity = format!("{what}, {word}");
        checks.push(Check::new(NAME, quantity, value, exact, 0.005 * scale, unit, note));
    };
    for (quadrature, word) in QUADRATURES {
        let bar = Bar::at(fine, quadrature, true, 0.75)?;
        let [speed, stress] = bar.means(0.2 * LENGTH, 0.6 * LENGTH);
        compare("velocity behind the front", speed, v, v, "m/s", word);
        compare("stress behind the front", stress, -PRESSURE, PRESSURE, "Pa", word);
        let [speed, stress] = bar.means(0.85 * LENGTH, LENGTH);
        compare("velocity ahead of the front", speed, 0.0, v, "m/s", word);
        compare("stress ahead of the front", stress, 0.0, PRESSURE, "Pa", word);
        for (fixed, end, factors) in [(true, "fixed", [0.0, -2.0]), (false, "free", [2.0, 0.0])] {
            let bar = Bar::at(fine, quadrature, fixed, 1.6)?;
            let [speed, stress] = bar.means(0.6 * LENGTH, LENGTH);
            compare(&format!("velocity after the {end} end"), speed, factors[0] * v, v, "m/s", word);
            compare(
                &format!("stress after the {end} end"),
                stress,
                factors[1] * PRESSURE,
                PRESSURE,
                "Pa",
                word,
            );
        }
    }
    let error = |n| Bar::at(n, Quadrature::OnePoint, true, 0.75).map(|bar| bar.error(0.75 * LENGTH, v));
    let (coarse, fine) = (error(fine / 2)?, error(fine)?);
    let p = order(coarse, fine, 2.0);
    let note = format!(
        "1/2 by the Airy ringing, approached from below: with the front's own share the error is ℓ (4 (L/ℓ)^1/4 − b), \
         ℓ the ringing's width, b of order 1, L/ℓ some 100; error {fine:.2e}"
    );
    checks.push(Check::new(NAME, "order in h of the error in L1", p, 0.5, 0.1, "1", note).with_order(p));
    Ok(checks)
}
