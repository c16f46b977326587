//! The reference column against one-dimensional theory: is the motion that comes out the one that was put in?

mod theory;

use super::{Observer, Schedule, Setting, View};
use crate::error::RunError;
use crate::quantities::MEASURES;
use theory::{Layer, surface_velocity};
use tremolite_engine::state::Memory;
use tremolite_laws::parameter::position;

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
    /// The observer, if the model has a homogeneous column and an incident wave.
    pub fn new(setting: &Setting) -> Option<Self> {
        let Setting { model, plan, .. } = *setting;
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
            surface_velocity(&layer, |t| incident.factor * incident.motion.at(t).v[i], dt, plan.duration)
        });
        let peak = predicted.iter().flatten().fold(0.0_f64, |most, v| most.max(v.abs()));
        let top = model.engine_node[top as usize] as usize;
        Some(FreeField { schedule: setting.rows(), top, predicted, dt, peak })
    }
}

/// Whether the material of the reference column has yielded or cracked anywhere.
fn is_damaged(view: &View) -> bool {
    let View { model, assembly, history, .. } = *view;
    (model.user_patches..model.patches.len()).any(|p| {
        let columns = assembly.members[p].part.columns();
        let own = &history.octets[assembly.slices[p].history.clone()];
        MEASURES.iter().any(|measure| {
            position(columns, measure.role).is_some_and(|at| {
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

    fn see(&mut self, view: &View, memory: &mut Memory) -> Result<(), RunError> {
        let found = view.snapshot.velocity[self.top].xyz();
        let damaged = is_damaged(view);
        let place = view.snapshot.time / self.dt;
        let (before, part) = (place as usize, place.fract());
        let memory = memory.entry(MEMORY.into()).or_insert_with(|| vec![0.0; 4]);
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
