//! Dispersion of plane waves on a regular mesh.
//!
//! Along an axis of a mesh of bricks the hexahedron with lumped mass and the scheme of the method give
//! sin(½ωΔt) = (cΔt/h) sin(½kh), c = c_p or c_s: a plane wave moves each layer of nodes as one, so hourglass patterns
//! are not excited, the mean strain is the difference over h, and the row sums of the mass are those of a bar. As
//! Δt → 0 the phase speed is c sin(½kh)/(½kh).
//!
//! A block with one wavelength along z, its opposite faces tied, starts in cos kz at rest; the standing wave's
//! frequency is that of the recurrence through the projections of u on cos kz. Two elements across leave the wave free
//! to leave its plane; it must not.

use crate::convergence::Oscillation;
use crate::models::{QUADRATURES, Solid, column};
use crate::simulation::Simulation;
use crate::{Check, Effort, Verification, VerifyError};
use std::f64::consts::TAU;
use tremolite::{Quadrature, Side};

const NAME: &str = "dispersion";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "plane P and S waves obey sin(½ωΔt) = (cΔt/h) sin(½kh)",
    source: "dispersion relation of lumped linear elements and central differences (Hughes 2000, chapter 9)",
    from: Effort::Test,
    run,
};

const ROCK: Solid = Solid { young: 10e9, poisson: 0.25, density: 2700.0 };
/// Elements a wavelength.
const PER_WAVE: [u32; 6] = [4, 6, 8, 10, 15, 20];
/// Side of an element \[m\].
const SIZE: f64 = 2.0;

/// What a standing wave shows.
struct Wave {
    /// Computed frequency \[rad/s\] and the relation's.
    found: f64,
    exact: f64,
    /// Computed phase speed over c, the error of Δt taken out.
    speed_ratio: f64,
    /// Largest displacement that is not the plane wave's, over its amplitude.
    stray: f64,
}

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let (p, s) = ROCK.speeds();
    let mut checks = Vec::new();
    for (quadrature, word) in QUADRATURES {
        for (speed, axis, letter) in [(p, 2, "P"), (s, 0, "S")] {
            let waves: Vec<Wave> =
                PER_WAVE.iter().map(|&m| standing(quadrature, speed, axis, m)).collect::<Result<_, _>>()?;
            let worst = |pick: &dyn Fn(&Wave) -> f64| waves.iter().map(pick).fold(0.0, f64::max);
            let error = worst(&|w| (w.found / w.exact - 1.0).abs());
            let note =
                "the relation is exact for this mesh and scheme; round-off of acos near 1 and of 400 steps";
            let quantity =
                format!("frequency of {letter} waves, {word}: largest relative error, 4 to 20 elements");
            checks.push(Check::new(NAME, quantity, error, 0.0, 1e-9, "1", note));
            let quantity = format!("displacement off the plane {letter} wave, {word}");
            let note =
                "exactly zero but for round-off, which hourglass modes must not amplify over 400 steps";
            checks.push(Check::new(NAME, quantity, worst(&|w| w.stray), 0.0, 1e-11, "1", note));
            if quadrature == Quadrature::OnePoint {
                for (wave, m) in waves.iter().zip(PER_WAVE) {
                    let half = 0.5 * TAU / f64::from(m);
                    let quantity = format!("phase speed of {letter} waves over c, {m} elements a wavelength");
                    let note = "four digits of sin(½kh)/(½kh)";
                    checks.push(Check::new(
                        NAME,
                        quantity,
                        wave.speed_ratio,
                        half.sin() / half,
                        5e-5,
                        "1",
                        note,
                    ));
                }
            }
        }
    }
    Ok(checks)
}

fn standing(quadrature: Quadrature, speed: f64, axis: usize, elements: u32) -> Result<Wave, VerifyError> {
    let mut problem = ROCK.fill(column(SIZE, elements, 2)?, quadrature);
    problem.sides = [Side::Periodic; 2];
    let layer = problem.mesh.nodes.len() as u32 / (elements + 1);
    problem.ties = (0..layer).map(|n| (n, n + elements * layer)).collect();
    let simulation = Simulation::on_one_level(problem)?;
    let dt = 0.9 * simulation.stable();
    let k = TAU / (SIZE * f64::from(elements));
    let shape: Vec<f64> =
        (0..simulation.model.mesh_node.len()).map(|n| (k * simulation.position(n)[2]).cos()).collect();
    let mut engine = simulation.engine();
    let mut state = simulation.start(&mut engine, dt, |n| {
        let mut u = [0.0; 3];
        u[axis] = shape[n];
        [u, [0.0; 3]]
    });
    let square: f64 = shape.iter().map(|x| x * x).sum();
    let (mut q, mut stray) = (Vec::new(), 0.0f64);
    for _ in 0..400 {
        let amplitude = shape.iter().zip(&state.u).map(|(x, u)| x * u.0[axis]).sum::<f64>() / square;
        q.push(amplitude);
        for (x, u) in shape.iter().zip(&state.u) {
            for i in 0..3 {
                let plane = if i == axis { amplitude * x } else { 0.0 };
                stray = stray.max((u.0[i] - plane).abs());
            }
        }
        engine.step(&mut state);
    }
    let angle = Oscillation::fit_undamped(&q).angle();
    let courant = speed * dt / SIZE;
    Ok(Wave {
        found: angle / dt,
        exact: 2.0 / dt * (courant * (0.5 * k * SIZE).sin()).asin(),
        speed_ratio: 2.0 / dt * (0.5 * angle).sin() / (speed * k),
        stray,
    })
}
