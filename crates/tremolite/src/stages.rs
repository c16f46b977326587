//! Stages before the shaking: what is changed in each, and how the model comes to rest.

use crate::seepage::StageFlow;
use std::sync::Arc;
use tremolite_engine::engine::{Relaxed, Release, Rest};
use tremolite_engine::{Assembly, Engine, Model, ModelError, Phase, Stage, State};
use tremolite_results::Said;

/// A stage as a plan has it. The first of all is the equilibrium of what is there at the start.
#[derive(Clone, Debug, PartialEq)]
pub struct PlannedStage {
    pub name: String,
    pub release: Release,
    /// What changes, for people: groups that go, groups that begin, and a phrase for each other change.
    pub excavated: Vec<String>,
    pub installed: Vec<String>,
    pub changed: Vec<Said>,
    /// Steady seepage from here on, where it differs from that before.
    pub flow: Option<StageFlow>,
}

impl PlannedStage {
    /// A stage that lets everything go.
    pub fn new(name: impl Into<String>) -> Self {
        PlannedStage {
            name: name.into(),
            release: Release::default(),
            excavated: Vec::new(),
            installed: Vec::new(),
            changed: Vec::new(),
            flow: None,
        }
    }
}

/// What flows in a stage, by its number.
pub fn flow_in(stages: &[PlannedStage], stage: usize) -> Option<&StageFlow> {
    stages.iter().take(stage.saturating_add(1)).rev().find_map(|stage| stage.flow.as_ref())
}

/// Why stages did not come to rest.
#[derive(Debug)]
pub enum Unsettled {
    Model(ModelError),
    /// The stage's number, and how it ended.
    Stage(usize, Relaxed),
}

/// A model at rest after some stages, from the state at the start.
///
/// # Errors
/// At the first stage that does not come to rest.
pub fn settle(
    model: &Arc<Model>,
    assembly: &Arc<Assembly>,
    stages: &[PlannedStage],
) -> Result<(State, Vec<Rest>), Unsettled> {
    let mut state = assembly.rest();
    let mut rests = Vec::new();
    for (k, stage) in stages.iter().enumerate() {
        let phase = Phase::of(model, assembly, Stage::Before(k as u16)).map_err(Unsettled::Model)?;
        let mut engine = Engine::new(model, assembly, &phase);
        match engine.relax_watched(&mut state, &stage.release, &mut |_, _| true) {
            Relaxed::AtRest(rest) => rests.push(rest),
            other => return Err(Unsettled::Stage(k, other)),
        }
    }
    Ok((state, rests))
}
