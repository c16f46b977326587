//! A problem made ready to run in one phase.

use std::sync::Arc;
use tremolite::{Assembly, Engine, Model, Phase, Problem, Stage, State, settle_levels, stable_step};

/// A model with its parts and what of them is active.
pub struct Ready {
    pub model: Arc<Model>,
    pub assembly: Arc<Assembly>,
    pub phase: Arc<Phase>,
}

impl Ready {
    /// The shaking of a problem.
    pub fn new(problem: Problem) -> Self {
        let model = Model::new(problem).unwrap();
        let assembly = Assembly::new(&model).unwrap();
        let phase = Phase::of(&model, &assembly, Stage::Shaking).unwrap();
        Ready { model, assembly, phase }
    }

    /// The same with levels of steps as near to those wished for at each place as may be.
    pub fn levelled(self, wished: impl Fn([f64; 3]) -> u8) -> Self {
        let wished = self.model.mesh.nodes.iter().map(|&at| wished(at)).collect();
        let model = self.model.at_levels(&settle_levels(&self.model, &self.phase, wished));
        let assembly = self.assembly.again(&model).unwrap();
        let phase = Phase::of(&model, &assembly, Stage::Shaking).unwrap();
        Ready { model, assembly, phase }
    }

    /// The stable step \[s\].
    pub fn stable(&self) -> f64 {
        stable_step(&self.model, &self.assembly, &self.phase).dt
    }

    /// A state at rest with this share of the stable step.
    pub fn rest(&self, safety: f64) -> State {
        let mut state = self.assembly.rest();
        state.dt = safety * self.stable();
        state
    }

    pub fn engine(&self) -> Engine {
        Engine::new(&self.model, &self.assembly, &self.phase)
    }
}
