//! Levels of steps neither add energy nor take it.
//!
//! With nodes on steps of 1, 2, 4 and 8 times the finest no invariant is known that bounds the motion; the energy of what stands
//! between borders comes and goes with what finer parts take (`energy.csv`, `levels`). Over a long run without any damping its
//! mean must stay. A distorted block is held at its bottom, its levels lie in bands and in blobs, so that borders meet at edges and
//! corners, and it begins with random velocities, so that every mode takes part. Means over the first and the last tenth are compared.

use crate::models::{Solid, distorted};
use crate::simulation::Simulation;
use crate::{Check, Effort, Verification, VerifyError};
use tremolite::{Base, Line, Quadrature};
use tremolite_laws::shapes::hex8::element_frequencies;

const NAME: &str = "levels_energy";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "four levels of steps keep the mean energy of an undamped block, over a million of the finest steps with --full",
    source: "partition of neal1989; conservation of energy",
    from: Effort::Test,
    run,
};

/// The coarsest step over the bound of the elements: what the program allows levels other than the finest.
const SHARE: f64 = 0.8;
/// Steps of the coarsest level from one look to the next.
const EVERY: usize = 5;

fn run(effort: Effort) -> Result<Vec<Check>, VerifyError> {
    let (steps, tolerance) = match effort {
        Effort::Test | Effort::Verify => (20_000, 2e-3),
        Effort::Full => (1_000_000, 1e-4),
    };
    let mut checks = Vec::new();
    for (word, wished) in [("bands", bands as fn([f64; 3]) -> u8), ("blobs", blobs)] {
        let found = energies(wished, SHARE, steps)?;
        let tenth = found.len() / 10;
        let mean = |some: &[f64]| some.iter().sum::<f64>() / some.len() as f64;
        let ratio = mean(&found[found.len() - tenth..]) / mean(&found[..tenth]);
        let overall = mean(&found);
        let scatter = mean(&found.iter().map(|e| (e / overall - 1.0).powi(2)).collect::<Vec<_>>()).sqrt();
        let note = format!(
            "{steps} of the finest steps, the coarsest {SHARE} of the elements' bound; energies scatter by {scatter:.1e} from \
             look to look, and {:.1e} of it is left in a difference of two means of {tenth}; with 1.5 of the bound, bands \
             run away",
            scatter * (2.0 / tenth as f64).sqrt()
        );
        let quantity = format!("mean energy of the last tenth over that of the first, levels in {word}");
        checks.push(Check::new(NAME, quantity, ratio, 1.0, tolerance, "1", note));
    }
    Ok(checks)
}

fn bands([_, _, z]: [f64; 3]) -> u8 {
    (z / 2.0).min(3.0) as u8
}

fn blobs([x, y, z]: [f64; 3]) -> u8 {
    ((2.2 + 1.8 * (1.1 * x).sin() * (0.9 * y + 0.4).cos() + (0.7 * z).sin()).clamp(0.0, 3.9)) as u8
}

/// Kinetic, strain and hourglass energy \[J\] at looks.
fn energies(wished: fn([f64; 3]) -> u8, share: f64, steps: usize) -> Result<Vec<f64>, VerifyError> {
    let rock = Solid { young: 10e9, poisson: 0.25, density: 2700.0 };
    let mut problem = rock.fill(distorted([4.0, 4.0, 8.0], [4, 4, 8], 0.14)?, Quadrature::OnePoint);
    problem.base = Base::Fixed;
    let simulation = Simulation::on_one_level(problem)?.levelled(wished)?;
    let model = &simulation.model;
    let shapes: Vec<_> = (0..model.mesh.elements.len())
        .map(|e| tremolite::hexahedra::hex(&model.mesh, e))
        .collect::<Result<_, _>>()
        .map_err(|error| VerifyError::Setup(error.to_string()))?;
    let omega = element_frequencies(&shapes, rock.moduli(), rock.density, Quadrature::OnePoint);
    let bound = 2.0 / omega.into_iter().fold(0.0, f64::max);
    let mut engine = simulation.engine();
    let random = |n: usize, i: usize| 0.1 * ((3 * n + i) as f64 * 12.9898).sin();
    let mut state = simulation.start(&mut engine, share * bound / 8.0, |n| {
        let held = simulation.phase.inverse_mass[n].0[0] == 0.0;
        [[0.0; 3], [0, 1, 2].map(|i| if held { 0.0 } else { random(n, i) })]
    });
    let mut found = Vec::with_capacity(steps / 8 / EVERY);
    for step in 0..steps / 8 {
        if step % EVERY == 0 {
            let balance = engine.look(&state).snapshot.balance;
            found.push(balance[Line::Kinetic] + balance[Line::Strain] + balance[Line::Hourglass]);
        }
        engine.step(&mut state);
    }
    Ok(found)
}
