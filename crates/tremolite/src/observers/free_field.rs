//! The reference column against one-dimensional theory: is the motion that comes out the one that was put in?

use super::{Observer, Schedule, View};
use crate::model::Model;
use crate::run::RunError;
use crate::state::State;

/// Key of what this observer remembers: the largest difference and the largest predicted velocity \[m/s\].
pub const MEMORY: &str = "free field";

/// Compares the velocity at the column's top with 2 v_i(t − H/c) e^{−ωH/2c}, exact for a homogeneous column under
/// vertical incidence (ω: Rayleigh's, to first order).
pub struct FreeField {
    schedule: Schedule,
    /// Engine node at the column's top.
    top: usize,
    height: f64,
    /// c_s, c_s, c_p.
    speeds: [f64; 3],
}

impl FreeField {
    /// The observer, if the model has a homogeneous column, no stiffness-proportional damping and an incident wave.
    pub fn new(model: &Model, schedule: Schedule) -> Option<Self> {
        let column = &model.bodies[model.user_bodies().len()..];
        let ([body], 0.0, Some(_)) = (column, model.rayleigh.stiffness, &model.incident) else { return None };
        let height = |n: u32| model.mesh.nodes[n as usize][2];
        let nodes = model.user_nodes as u32..model.mesh.nodes.len() as u32;
        let top = nodes.clone().max_by(|a, b| height(*a).total_cmp(&height(*b)))?;
        let bottom = nodes.min_by(|a, b| height(*a).total_cmp(&height(*b)))?;
        let (p, s) = body.material.moduli().wave_speeds(body.density);
        Some(FreeField {
            schedule,
            top: model.engine_node[top as usize] as usize,
            height: height(top) - height(bottom),
            speeds: [s, s, p],
        })
    }
}

impl Observer for FreeField {
    fn schedule(&self) -> Schedule {
        self.schedule
    }

    fn see(&mut self, view: &View, state: &mut State) -> Result<(), RunError> {
        let Some(incident) = &view.model.incident else { return Ok(()) };
        let found = view.snapshot.velocity[self.top].xyz();
        let time = state.time();
        let memory = state.observers.entry(MEMORY.into()).or_insert_with(|| vec![0.0; 2]);
        for i in 0..3 {
            let delay = self.height / self.speeds[i];
            let decay = (-0.5 * view.model.rayleigh.mass * delay).exp();
            let exact = 2.0 * incident.factor * incident.motion.at(time - delay).v[i] * decay;
            memory[0] = memory[0].max((found[i] - exact).abs());
            memory[1] = memory[1].max(exact.abs());
        }
        Ok(())
    }
}
