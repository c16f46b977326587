//! Damping over a band: free decay of a column, mode by mode.
//!
//! Three Maxwell bodies (`emmerich1987`) give the damping ratio ½ Im M/Re M and the stiffness Re M at each
//! frequency. A column on a fixed base with tied sides is set off in the mode sin((2k − 1)πz/(2H)), which stays a mode
//! since the bodies are everywhere the same; frequency and ratio are those of the root of s² + ω_n² M(s) = 0. The first
//! cycles are passed over, while the bodies settle.

use crate::convergence::Oscillation;
use crate::models::{Solid, column, law};
use crate::simulation::Simulation;
use crate::{Check, Effort, Verification, VerifyError};
use std::f64::consts::{PI, TAU};
use tremolite::{Base, Quadrature, Side};
use tremolite_laws::Material;
use tremolite_laws::Values;
use tremolite_laws::band::Band;
use tremolite_laws::materials::Elastic;

const NAME: &str = "band_damping";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "three Maxwell bodies damp column modes across a band by the target ratio",
    source: "`emmerich1987`, modulus of the generalised Maxwell body",
    from: Effort::Test,
    run,
};

const ROCK: Solid = Solid { young: 10e9, poisson: 0.25, density: 2700.0 };
const LAYERS: u32 = 60;
/// Side of an element \[m\].
const SIZE: f64 = 2.5;
const TARGET: f64 = 0.03;
const BAND: [f64; 2] = [0.5, 20.0];
/// Frequency at which the moduli are meant \[Hz\].
const REFERENCE: f64 = 3.0;
/// Cycles passed over, and cycles measured.
const CYCLES: [f64; 2] = [5.0, 4.0];

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let band = Band::fit(TARGET, BAND, REFERENCE).map_err(|e| VerifyError::Setup(e.to_string()))?;
    let (_, speed) = ROCK.speeds();
    let mut checks = Vec::new();
    for quadrature in [Quadrature::OnePoint, Quadrature::Full] {
        for mode in [1, 2, 4] {
            let undamped =
                2.0 * speed / SIZE * (f64::from(2 * mode - 1) * PI / f64::from(4 * LAYERS)).sin() / TAU;
            let [exact, ratio] = band.oscillation(undamped);
            let found = decay(band, quadrature, mode, exact)?;
            let kind = if quadrature == Quadrature::Full { "full" } else { "one-point" };
            checks.push(Check::new(
                NAME,
                format!("damping ratio at {exact:.2} Hz, {kind}"),
                found.damping_ratio(),
                ratio,
                0.005 * ratio,
                "1",
                "0.5 %: scheme and bodies err by shares of order (ωΔt)², here up to 0.2 %",
            ));
            checks.push(Check::new(
                NAME,
                format!("damping ratio at {exact:.2} Hz against the target, {kind}"),
                found.damping_ratio(),
                TARGET,
                0.15 * TARGET,
                "1",
                "15 %: three bodies over a factor of 40 in frequency",
            ));
        }
    }
    Ok(checks)
}

fn decay(band: Band, quadrature: Quadrature, mode: u32, f: f64) -> Result<Oscillation, VerifyError> {
    let mut problem = ROCK.fill(column(SIZE, LAYERS, 1)?, quadrature);
    let values = Values::default().with("young", ROCK.young).with("poisson", ROCK.poisson);
    problem.bodies[0].material = (law(Elastic::NAME)?.build_banded)(&values, band)
        .map_err(|_| VerifyError::Setup("the elastic law refuses its values".into()))?;
    problem.base = Base::Fixed;
    problem.sides = [Side::Periodic; 2];
    let simulation = Simulation::new(problem)?;
    let height = SIZE * f64::from(LAYERS);
    let dt = 0.9 * simulation.stable();
    let mut engine = simulation.engine();
    let mut state = simulation.start(&mut engine, dt, |n| {
        let shape = (f64::from(2 * mode - 1) * PI * simulation.position(n)[2] / (2.0 * height)).sin();
        [[0.0; 3], [1e-2 * shape, 0.0, 0.0]]
    });
    let top = simulation.node([0.0, 0.0, height])?;
    let steps = CYCLES.map(|c| (c / (f * dt)) as usize);
    let mut q = Vec::new();
    for step in 0..steps[0] + steps[1] {
        engine.step(&mut state);
        if step >= steps[0] {
            q.push(state.u[top].0[0]);
        }
    }
    Ok(Oscillation::fit(&q))
}
