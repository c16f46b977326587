//! The reference column against one-dimensional theory: is the motion that comes out the one that was put in?

mod theory;

use super::{Observer, Schedule, View};
use crate::model::Model;
use crate::phase::Phase;
use crate::quantities::MEASURES;
use crate::run::RunError;
use crate::state::State;
use theory::{Layer, surface_velocity};

/// Key of what this observer remembers: the largest difference, the largest predicted velocity in the rows and over
/// the run \[m/s\]; 1 if the column has yielded or cracked, else 0.
pub const MEMORY: &str = "free field";

/// Compares the velocity at the column's top with theory, exact for a homogeneous damped column on its dashpots.
pub struct FreeField {
    schedule: Schedule,
    /// Engine node at the column's top.
    top: usize,
    /// Predicted velocity \[m/s\] along x, y, z, every `dt` \[s\].
    predicted: [Vec<f64>; 3],
    dt: f64,
    /// Its largest value over the run \[m/s\].
    peak: f64,
}

/// Samples of the prediction between two of the motion: between them it is linear.
const REFINEMENT: f64 = 8.0;

impl FreeField {
    /// The observer for a run of `duration` \[s\], if the model has a homogeneous column and an incident wave.
    pub fn new(model: &Model, duration: f64, schedule: Schedule) -> Option<Self> {
        let column = &model.bodies[model.user_bodies().len()..];
        let ([body], Some(incident)) = (column, &model.incident) else { return None };
        let height = |n: u32| model.mesh.nodes[n as usize][2];
        let nodes = model.user_nodes as u32..model.mesh.nodes.len() as u32;
        let top = nodes.clone().max_by(|a, b| height(*a).total_cmp(&height(*b)))?;
        let bottom = nodes.min_by(|a, b| height(*a).total_cmp(&height(*b)))?;
        let (p, s) = body.material.moduli().wave_speeds(body.density);
        let dt = incident.motion.dt / REFINEMENT;
        let predicted = [0, 1, 2].map(|i| {
            let layer = Layer {
                height: height(top) - height(bottom),
                speed: if i == 2 { p } else { s },
                band: body.material.band(),
                rayleigh: model.rayleigh,
            };
            surface_velocity(&layer, |t| incident.factor * incident.motion.at(t).v[i], dt, duration)
        });
        let peak = predicted.iter().flatten().fold(0.0_f64, |most, v| most.max(v.abs()));
        let top = model.engine_node[top as usize] as usize;
        Some(FreeField { schedule, top, predicted, dt, peak })
    }
}

/// Whether the material of the reference column has yielded or cracked anywhere.
fn is_damaged(model: &Model, phase: &Phase, state: &State) -> bool {
    (model.user_patches..model.patches.len()).any(|p| {
        let columns = model.bodies[model.patches[p].body].material.info().history;
        let own = &state.history[phase.slices[p].history.clone()];
        MEASURES.iter().any(|measure| {
            let at = columns.iter().position(|c| c.name == measure.column);
            at.is_some_and(|at| {
                own.iter()
                    .skip(at)
                    .step_by(columns.len())
                    .any(|octet| octet.0.iter().any(|x| *x > measure.onset))
            })
        })
    })
}

impl Observer for FreeField {
    fn schedule(&self) -> Schedule {
        self.schedule
    }

    fn see(&mut self, view: &View, state: &mut State) -> Result<(), RunError> {
        let found = view.snapshot.velocity[self.top].xyz();
        let damaged = is_damaged(view.model, view.phase, state);
        let place = state.time() / self.dt;
        let (before, part) = (place as usize, place.fract());
        let memory = state.observers.entry(MEMORY.into()).or_insert_with(|| vec![0.0; 4]);
        for (found, predicted) in found.iter().zip(&self.predicted) {
            let at = |i: usize| predicted.get(i).copied().unwrap_or(0.0);
            let exact = (1.0 - part) * at(before) + part * at(before + 1);
            memory[0] = memory[0].max((found - exact).abs());
            memory[1] = memory[1].max(exact.abs());
        }
        memory[2] = self.peak;
        if damaged {
            memory[3] = 1.0;
        }
        Ok(())
    }
}
