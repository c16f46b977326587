//! Free decay with Rayleigh damping.
//!
//! C = ωM + ξK damps the mode of frequency ω_n by the ratio ζ = ω/(2ω_n) + ½ξω_n. A column on a fixed base with tied
//! sides, sheared or compressed in the mode sin((2k − 1)πz/(2H)), is let go; the ratio is that of the oscillation
//! through the computed displacements of the top. The shape is an exact mode of the row of lumped masses too, with
//! ω_n = (2c/h) sin((2k − 1)πh/(4H)).

use crate::convergence::Oscillation;
use crate::models::{Solid, column};
use crate::simulation::Simulation;
use crate::{Check, Effort, Verification, VerifyError};
use std::f64::consts::PI;
use tremolite::{Base, Quadrature, Rayleigh, Side};

const NAME: &str = "damping_ratio";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "free decay of column modes gives the ratio ω/(2ω_n) + ½ξω_n",
    source: "modal analysis of C = ωM + ξK, wang2018 (19)",
    from: Effort::Test,
    run,
};

const ROCK: Solid = Solid { young: 10e9, poisson: 0.25, density: 2700.0 };
const LAYERS: u32 = 40;
/// Side of an element \[m\].
const SIZE: f64 = 2.5;

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let (p, s) = ROCK.speeds();
    // 5 % in the first mode of shear, each way.
    let first = frequency(s, 1);
    let (omega, xi) = (0.1 * first, 0.1 / first);
    let mut checks = Vec::new();
    for (speed, axis, wave) in [(s, 0, "shear"), (p, 2, "compression")] {
        for (rayleigh, word) in [
            (Rayleigh { mass: omega, stiffness: 0.0 }, "ω"),
            (Rayleigh { mass: 0.0, stiffness: xi }, "ξ"),
            (Rayleigh { mass: omega, stiffness: xi }, "ω and ξ"),
        ] {
            for mode in [1, 2] {
                let w = frequency(speed, mode);
                let exact = rayleigh.mass / (2.0 * w) + 0.5 * rayleigh.stiffness * w;
                let found = decay(rayleigh, axis, mode, w)?;
                let note =
                    format!("1 %: the scheme errs by (ω_nΔt)²/6 of ζ, here far below; ω_n = {w:.2} rad/s");
                let quantity = format!("damping ratio by {word}, mode {mode} of {wave}");
                checks.push(Check::new(NAME, quantity, found, exact, 0.01 * exact, "1", note));
            }
        }
    }
    Ok(checks)
}

/// ω_n \[rad/s\] of mode `mode` of the lumped column.
fn frequency(speed: f64, mode: u32) -> f64 {
    2.0 * speed / SIZE * (f64::from(2 * mode - 1) * PI / f64::from(4 * LAYERS)).sin()
}

/// Damping ratio of the computed decay.
fn decay(rayleigh: Rayleigh, axis: usize, mode: u32, w: f64) -> Result<f64, VerifyError> {
    let mut problem = ROCK.fill(column(SIZE, LAYERS, 1)?, Quadrature::OnePoint);
    problem.base = Base::Fixed;
    problem.sides = [Side::Periodic; 2];
    problem.rayleigh = rayleigh;
    let simulation = Simulation::new(problem)?;
    let height = SIZE * f64::from(LAYERS);
    let dt = 0.9 * simulation.stable();
    let mut engine = simulation.engine();
    let mut state = simulation.start(&mut engine, dt, |n| {
        let mut u = [0.0; 3];
        u[axis] = 1e-3 * (f64::from(2 * mode - 1) * PI * simulation.position(n)[2] / (2.0 * height)).sin();
        [u, [0.0; 3]]
    });
    let top = simulation.node([0.0, 0.0, height])?;
    let mut q = vec![state.u[top].0[axis]];
    for _ in 0..(3.0 * 2.0 * PI / (w * dt)) as usize {
        engine.step(&mut state);
        q.push(state.u[top].0[axis]);
    }
    Ok(Oscillation::fit(&q).damping_ratio())
}
