//! Stops a run in which energy appears.

use super::{Engine, Snapshot};
use crate::model::Model;
use crate::phase::Phase;
use crate::ranks::Wanted;
use crate::state::{Ledger, State};
use crate::sums::over_nodes;
use std::ops::Range;
use tremolite_kernels::Line;

/// Where the guard finds more energy than it can be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Found {
    /// In the motion, and in what elements and joints store beyond what they did at rest.
    Held,
    /// In no line of the balance.
    InNoLine,
    /// Given where levels of steps meet.
    AtLevels,
}

/// Why a run cannot go on: far more energy is found than was ever supplied, or numbers are not finite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Halt {
    pub what: Found,
    /// How much of it \[J\].
    pub found: f64,
    /// J
    pub supplied: f64,
    /// Where that was seen.
    pub step: u64,
    pub time: f64,
}

/// Steps between looks of the guard. In so many, motion that is unstable by a hundredth of the step grows some tenfold.
const EVERY: u64 = 8;
/// Energy held beyond this multiple of all that was ever supplied stops a run. In a stable run the discrete energy bounds it: at
/// most 2 where all energy sits at the mesh's highest frequency, near 1 for waves that the mesh carries.
const GUARD: f64 = 3.0;
/// What counts as supplied before the wave comes, as a share of the kinetic energy of a model that moves as fast as the wave does at
/// its peak. A record may begin with noise that changes its sign within a few steps: it moves the base before its work is booked,
/// and that work may be negative.
const NOISE: f64 = 1e-6;

/// [`NOISE`] \[J\]; nothing where no wave comes in.
pub(super) fn noise(model: &Model, phase: &Phase) -> f64 {
    let square = model.boundaries.waves().peak_square();
    if square == 0.0 {
        return 0.0;
    }
    let one = |nodes: Range<usize>| -> f64 {
        nodes.filter(|&n| model.nodes.counts(n)).map(|n| phase.mass[n]).sum()
    };
    NOISE * 0.5 * over_nodes(&model.nodes, one, |a, b| a + b) * square
}

impl Engine {
    /// ½v⁻ᵀMv⁻ \[J\]. That of v̂ has in it what the forces are about to do, which is not supplied yet.
    pub(super) fn kinetic(&self, state: &State) -> f64 {
        let Engine { model, phase, .. } = self;
        let square = |n: usize| state.du[n].0.iter().map(|d| d * d).sum::<f64>() / (state.dt * state.dt);
        let one = |nodes: Range<usize>| -> f64 {
            nodes.filter(|&n| model.nodes.counts(n)).map(|n| 0.5 * phase.mass[n] * square(n)).sum()
        };
        self.over_nodes(1, one, |a, b| a + b)
    }

    /// Whether the guard watches a state: every few steps, whatever is looked at and when.
    pub fn watches(&self, state: &State) -> bool {
        state.steps().is_multiple_of(EVERY)
    }

    /// Whether a run may go on from a state that the guard [watches](Engine::watches), by its motion alone: that has less than three
    /// times all energy supplied and what came free of what was stored at rest. What is unstable at a few nodes grows within a few
    /// steps, while little was supplied; later it may be no more than a strong earthquake brings.
    ///
    /// # Errors
    /// The halt, if not. A joint or concrete that breaks under the load at rest frees what it stored, and more than was supplied yet:
    /// [`Engine::watch_or_look`] tells the two apart.
    pub fn watch(&self, state: &State) -> Result<(), Halt> {
        let (found, &Ledger { supplied, freed, .. }) = (self.kinetic(state), &state.ledger);
        // Written so that what is not a number halts as well.
        match found <= GUARD * (supplied + self.noise + freed) {
            true => Ok(()),
            false => {
                Err(Halt { what: Found::Held, found, supplied, step: state.steps(), time: state.time() })
            }
        }
    }

    /// The same, where too much motion is held against the [whole balance](Engine::guard) before it halts a run: what elements and
    /// joints store less than at rest may be in it. That is remembered, so that such a look is seldom needed.
    ///
    /// # Errors
    /// The halt that the balance tells.
    pub fn watch_or_look(&mut self, state: &mut State) -> Result<(), Halt> {
        if self.watch(state).is_ok() {
            return Ok(());
        }
        let seen = self.look_at(state, &Wanted::default()).snapshot;
        self.guard(&seen)?;
        state.ledger.freed = state.ledger.freed.max(self.kinetic(state) - seen.held);
        Ok(())
    }

    /// Whether a run may go on from what is seen: less than three times all energy supplied is held, and no more than that is in no
    /// line of the balance, nor was given where levels of steps meet. The second tells what is unstable at a few nodes: sides then give
    /// energy with which it is let go again.
    ///
    /// # Errors
    /// The halt, if not.
    pub fn guard(&self, seen: &Snapshot) -> Result<(), Halt> {
        let &Snapshot { held, supplied, step, time, scheme, ref balance, .. } = seen;
        let known = supplied + self.noise;
        let halt = |what, found| Err(Halt { what, found, supplied, step, time });
        let (unknown, at_borders) = (balance[Line::Error] - scheme, -balance[Line::Levels]);
        // Written so that what is not a number halts as well.
        match (held <= GUARD * known, unknown <= known, at_borders <= known) {
            (true, true, true) => Ok(()),
            (false, ..) => halt(Found::Held, held),
            (true, false, _) => halt(Found::InNoLine, unknown),
            (true, true, false) => halt(Found::AtLevels, at_borders),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Assembly, Body, Incident, Problem, Quadrature, Stage, elastic};
    use tremolite_laws::Moduli;
    use tremolite_mesh::boxes::BoxSpec;
    use tremolite_motion::{Motion, Sample};

    /// 24 m³ of 2,500 kg/m³ beside half an outcrop's motion of 0.6 m/s along x and 0.8 m/s along z at most.
    #[test]
    fn what_counts_as_supplied_is_a_millionth_of_the_model_at_the_waves_peak() {
        let mesh = BoxSpec::uniform([0.0; 3], [4.0, 3.0, 2.0], [2, 3, 1]).mesh().unwrap();
        let material = elastic(Moduli::from_young_poisson(1e9, 0.25));
        let quadrature = Quadrature::OnePoint;
        let body = Body {
            name: "rock".into(),
            elements: (0..6).collect(),
            material,
            density: 2500.0,
            quadrature,
            viscosity: 0.0,
        };
        let mut problem = Problem::new(mesh, vec![body]);
        let found = |problem: &Problem| {
            let model = Model::new(problem.clone()).unwrap();
            let assembly = Assembly::new(&model).unwrap();
            noise(&model, &Phase::of(&model, &assembly, Stage::Shaking).unwrap())
        };
        assert_eq!(found(&problem), 0.0);
        problem.base = crate::Base::Viscous;
        let sample = |t: f64| {
            let v = if (t - 0.05).abs() < 1e-6 { [0.6, 0.0, -0.8] } else { [0.0; 3] };
            Sample { a: [0.0; 3], v, u: [0.0; 3] }
        };
        let motion = Motion::sampled(0.01, 0.1, sample).unwrap();
        problem.incident = Some(Incident { motion, factor: 0.5 });
        let exact = 1e-6 * 0.5 * 24.0 * 2500.0 * 0.25;
        assert!((found(&problem) / exact - 1.0).abs() < 1e-12, "{} {exact}", found(&problem));
    }
}
