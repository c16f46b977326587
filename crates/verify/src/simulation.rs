//! A problem made ready to run, and its run.

use crate::VerifyError;
use std::sync::Arc;
use tremolite::{
    Assembly, Engine, Model, Phase, Problem, Snapshot, Stage, State, settle_levels, stable_step,
};
use tremolite_laws::Row;

/// A model with its dynamic phase.
pub struct Simulation {
    pub model: Arc<Model>,
    pub assembly: Arc<Assembly>,
    pub phase: Arc<Phase>,
}

impl Simulation {
    /// # Errors
    /// If the problem is not a model.
    pub fn new(problem: Problem) -> Result<Self, VerifyError> {
        let model = Model::new(problem)?;
        let assembly = Assembly::new(&model)?;
        let phase = Phase::of(&model, &assembly, Stage::Shaking)?;
        Ok(Simulation { model, assembly, phase })
    }

    /// The same with these levels of steps by place, as far as levels may lie side by side.
    ///
    /// # Errors
    /// If the model cannot be cut by them.
    pub fn levelled(&self, wished: impl Fn([f64; 3]) -> u8) -> Result<Self, VerifyError> {
        let wished = self.model.mesh.nodes.iter().map(|&at| wished(at)).collect();
        let model = self.model.at_levels(&settle_levels(&self.model, &self.phase, wished));
        let assembly = self.assembly.again(&model)?;
        let phase = Phase::of(&model, &assembly, Stage::Shaking)?;
        Ok(Simulation { model, assembly, phase })
    }

    /// The stable step \[s\].
    pub fn stable(&self) -> f64 {
        stable_step(&self.model, &self.assembly, &self.phase).dt
    }

    pub fn engine(&self) -> Engine {
        Engine::new(&self.model, &self.assembly, &self.phase)
    }

    /// Coordinates \[m\] of an engine node.
    pub fn position(&self, node: usize) -> [f64; 3] {
        self.model.mesh.nodes[self.model.mesh_node[node] as usize]
    }

    /// The engine node at a point.
    ///
    /// # Errors
    /// If there is none.
    pub fn node(&self, at: [f64; 3]) -> Result<usize, VerifyError> {
        let (low, high) = self.model.mesh.bounds();
        let near = 1e-6 * (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max);
        (0..self.model.mesh_node.len())
            .find(|&n| self.position(n).iter().zip(&at).all(|(x, y)| (x - y).abs() < near))
            .ok_or(VerifyError::NoNode(at[0], at[1], at[2]))
    }

    /// A state with given displacement \[m\] and velocity \[m/s\] at each engine node, started as (25)–(27).
    pub fn start(&self, engine: &mut Engine, dt: f64, initial: impl Fn(usize) -> [[f64; 3]; 2]) -> State {
        let mut state = self.assembly.rest();
        state.dt = dt;
        let nodes = 0..self.model.mesh_node.len();
        let u = nodes.clone().map(|n| Row::new(initial(n)[0])).collect();
        let v: Vec<Row> = nodes.map(|n| Row::new(initial(n)[1])).collect();
        engine.start(&mut state, u, &v);
        state
    }

    /// Runs from rest over `steps` of `dt` \[s\]; `see` gets the state at every step from 0 on.
    ///
    /// # Errors
    /// If the run becomes unstable.
    pub fn run_from_rest(
        &self,
        dt: f64,
        steps: u64,
        mut see: impl FnMut(&State),
    ) -> Result<Snapshot, VerifyError> {
        let mut engine = self.engine();
        let mut state = self.start(&mut engine, dt, |_| [[0.0; 3]; 2]);
        see(&state);
        for _ in 0..steps {
            engine.step(&mut state);
            see(&state);
        }
        Ok(engine.look(&state).snapshot)
    }
}

/// Steps and step \[s\] that reach `end` \[s\] exactly with at most `most` \[s\] a step.
pub fn whole_steps(end: f64, most: f64) -> (u64, f64) {
    let steps = (end / most).ceil().max(1.0);
    (steps as u64, end / steps)
}
