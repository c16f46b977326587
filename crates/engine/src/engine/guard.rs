//! Stops a run in which energy appears.

use super::{Engine, Snapshot};
use crate::model::Model;
use crate::node_table::Domain;
use crate::phase::Phase;
use crate::state::State;

/// Why a step could not be taken.
#[derive(Clone, Debug, PartialEq)]
pub enum Halt {
    /// More kinetic energy than was ever supplied, or numbers that are not finite.
    Energy { kinetic: f64, supplied: f64, step: u64, time: f64 },
    /// More energy held by elements and motion than was ever supplied.
    Held { held: f64, supplied: f64, step: u64, time: f64 },
}

/// Kinetic energy beyond this multiple of all energy ever supplied stops a run. In a stable run the discrete energy
/// bounds it: at most 2 where all energy sits at the mesh's highest frequency, near 1 for waves the mesh carries. Whoever
/// looks also compares all energy held.
pub(super) const GUARD: f64 = 3.0;
/// What counts as supplied before the wave comes, as a share of the kinetic energy of a model that moves as fast as the wave does at
/// its peak. A record may begin with noise that changes its sign within a few steps: it moves the base before its work is booked,
/// and that work may be negative.
const NOISE: f64 = 1e-6;

/// [`NOISE`] \[J\]; nothing where no wave comes in.
pub(super) fn noise(model: &Model, phase: &Phase) -> f64 {
    let Some(incident) = &model.incident else { return 0.0 };
    let largest = |v: &Vec<f64>| v.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
    let square: f64 = incident.motion.velocity.iter().map(|v| (incident.factor * largest(v)).powi(2)).sum();
    let counted = phase.mass.iter().zip(&model.nodes.domain).filter(|(_, d)| **d == Domain::Model);
    NOISE * 0.5 * counted.map(|(mass, _)| mass).sum::<f64>() * square
}

/// ½v⁻ᵀMv⁻ \[J\]. That of v̂ has in it what the forces are about to do, which is not supplied yet.
pub(super) fn kinetic(model: &Model, phase: &Phase, state: &State) -> f64 {
    let square = |n: usize| state.du[n].0.iter().map(|d| d * d).sum::<f64>() / (state.dt * state.dt);
    model.nodes.of(Domain::Model).map(|n| 0.5 * phase.mass[n] * square(n)).sum()
}

impl Engine {
    /// Whether more energy is held than was ever supplied: what the guard cannot see in every step.
    ///
    /// # Errors
    /// [`Halt::Held`] if so.
    pub fn guard(&self, seen: &Snapshot) -> Result<(), Halt> {
        let &Snapshot { held, supplied, step, time, .. } = seen;
        if held <= GUARD * (supplied + self.noise) {
            return Ok(());
        }
        Err(Halt::Held { held, supplied, step, time })
    }
}
