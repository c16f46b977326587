//! A problem made ready to run, and its run.

use crate::VerifyError;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use tremolite::{
    Assembly, Engine, Model, Phase, Problem, Snapshot, StableStep, Stage, State, settle_levels, stable_step,
};
use tremolite_laws::Row;

/// Whether problems run on four levels of steps where their meshes allow. For the whole process, so that a problem's own code need not know.
static FOUR_LEVELS: AtomicBool = AtomicBool::new(false);

/// Has every problem that is made from now on run on up to four levels of steps, in bands from the finest at its top to the coarsest at its
/// bottom, where waves come in: whatever it shows must hold with them as well. Problems of what one level alone has (the scheme to
/// the last digit, its order and invariants) and of stages alone stay as they are. Orders are then told, not judged: a border reflects
/// in proportion to the size of the elements, so two meshes show a mixture of first and second order.
pub fn force_levels() {
    FOUR_LEVELS.store(true, Ordering::Relaxed);
}

/// Whether [`force_levels`] was called.
pub fn levels_are_forced() -> bool {
    FOUR_LEVELS.load(Ordering::Relaxed)
}

/// What coarser elements may have of their bound, over the 0.9 that problems take of it on one level.
const COARSE: f64 = 0.8 / 0.9;

/// A model with its dynamic phase.
pub struct Simulation {
    pub model: Arc<Model>,
    pub assembly: Arc<Assembly>,
    pub phase: Arc<Phase>,
    /// Steps of the finest level in one of the coarsest, which is a step of the engine, that of the coarsest level.
    period: u32,
}

impl Simulation {
    /// On the levels that are forced, else on one.
    ///
    /// # Errors
    /// If the problem is not a model.
    pub fn new(problem: Problem) -> Result<Self, VerifyError> {
        let damped = problem.rayleigh.stiffness > 0.0;
        let simulation = Self::on_one_level(problem)?;
        if damped || !levels_are_forced() {
            return Ok(simulation);
        }
        let (low, high) = simulation.model.mesh.bounds();
        let levelled = simulation
            .levelled(|at| (3.99 * (high[2] - at[2]) / (high[2] - low[2])).clamp(0.0, 3.0) as u8)?;
        let coarsest = levelled.model.nodes.level.iter().copied().max().unwrap_or(0);
        Ok(Simulation { period: 1 << coarsest, ..levelled })
    }

    /// On one level, also where others are forced.
    ///
    /// # Errors
    /// If the problem is not a model.
    pub fn on_one_level(problem: Problem) -> Result<Self, VerifyError> {
        let model = Model::new(problem)?;
        let assembly = Assembly::new(&model)?;
        let phase = Phase::of(&model, &assembly, Stage::Shaking)?;
        Ok(Simulation { model, assembly, phase, period: 1 })
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
        Ok(Simulation { model, assembly, phase, period: 1 })
    }

    /// The stable step \[s\] of the engine, that of the coarsest level.
    pub fn stable(&self) -> f64 {
        self.bound().dt
    }

    /// What bounds the step of the engine, that of the coarsest level.
    pub fn bound(&self) -> StableStep {
        let mut bound = stable_step(&self.model, &self.assembly, &self.phase);
        if self.period > 1 {
            bound.dt *= COARSE;
        }
        bound
    }

    /// The mean velocity \[m/s\] of an engine node over its own last step, and the time of that step's middle \[s\].
    pub fn velocity(&self, state: &State, node: usize) -> ([f64; 3], f64) {
        let own = f64::from(1u32 << self.model.nodes.level.get(node).copied().unwrap_or(0));
        let [x, y, z, _] = state.du[node].0;
        ([x, y, z].map(|du| du / state.dt), state.time() - 0.5 * own * state.dt)
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
        state.dt = dt / f64::from(self.period);
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
