//! Stages of a run: each is relaxed, looked at and written, so that what is done stays done.

use super::Simulation;
use crate::checkpoint;
use crate::error::RunError;
use crate::history::History;
use crate::moved::MovedNodes;
use crate::observers::{Audience, Event, StageSeen, View};
use crate::places;
use crate::stages::PlannedStage;
use std::sync::Arc;
use tremolite_engine::engine::{Look, Relaxed, Rest};
use tremolite_engine::state::State;
use tremolite_engine::{Engine, Model, Phase, Stage};
use tremolite_laws::Row;
use tremolite_results::{Said, said};

/// A cycle of a stage's relaxation, before the next.
#[derive(Clone, Copy, Debug)]
pub struct Cycle {
    pub stage: usize,
    /// The number of the next cycle.
    pub cycle: u64,
    /// How near to rest the last one left the model; nothing is known before the first, of cycle 0.
    pub rest: Rest,
    /// How far the stage is, from 0 to 1: a guess.
    pub share: f64,
}

/// What to do before a cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Go {
    On,
    /// Write a checkpoint, and go on.
    Checkpoint,
    /// Write one, and stop.
    Stop,
}

/// How a stage ended.
#[derive(Clone, Debug, PartialEq)]
pub enum StageEnd {
    AtRest(Rest),
    /// It was told to stop, and goes on from there another time.
    Stopped,
    /// It did not come to rest: how it ended, and where most moves.
    Restless {
        relaxed: Relaxed,
        place: Said,
    },
    /// What it moves snapped back: what was let go at once of what was held \[J\].
    SnappedBack {
        lost: f64,
        held: f64,
    },
}

impl Simulation {
    /// Brings the stage that comes next to rest and tells observers. `watch` is asked before every cycle.
    ///
    /// # Errors
    /// If no stage is left, or a file cannot be written.
    pub fn relax(&mut self, watch: &mut dyn FnMut(&Cycle) -> Go) -> Result<StageEnd, RunError> {
        let stage = self.stage().ok_or(RunError::NoStageLeft)?;
        let phase = Phase::of(&self.model, &self.assembly, Stage::Before(stage as u16))?;
        let mut engine = Engine::among(&self.model, &self.assembly, &phase, self.ranks.as_ref());
        let mut audience = self.audience(&phase, &self.state)?;
        let mut state = std::mem::take(&mut self.state);
        let relaxed = self.relax_state(stage, &mut engine, &mut audience, &mut state, watch);
        let end = relaxed.and_then(|relaxed| {
            self.end_stage(stage, relaxed, &phase, &mut engine, &mut audience, &mut state)
        });
        self.state = state;
        let end = end?;
        // A last stage that failed is nothing to begin with.
        if matches!(end, StageEnd::AtRest(_)) {
            self.hand_over_begins()?;
        }
        Ok(end)
    }

    /// Keeps the state that the shaking begins with, once all stages are done.
    pub(super) fn hand_over_begins(&mut self) -> Result<(), RunError> {
        if self.stage().is_none() && self.state.carried.is_empty() {
            let mut state = std::mem::take(&mut self.state);
            self.nodes_whole(&mut state);
            let synced = if self.writes() { self.folder.sync() } else { Ok(()) };
            let written = synced.map_err(RunError::from).and_then(|()| {
                let (folder, among) = (self.folder.checkpoint(), self.among_ranks());
                Ok(checkpoint::write_hand_over(&folder, &mut state, self.fingerprint, &among)?)
            });
            self.state = state;
            written?;
        }
        Ok(())
    }

    fn end_stage(
        &self,
        stage: usize,
        relaxed: Relaxed,
        phase: &Phase,
        engine: &mut Engine,
        audience: &mut Audience,
        state: &mut State,
    ) -> Result<StageEnd, RunError> {
        let (Relaxed::AtRest(rest)
        | Relaxed::Stopped(rest)
        | Relaxed::Restless(rest)
        | Relaxed::Torn(rest, _)) = relaxed;
        let end = match relaxed {
            Relaxed::AtRest(rest) => {
                let moved = MovedNodes::of(&self.model, engine, state);
                match moved.snapped_back(&mut state.observers, stage, &rest) {
                    Some((lost, held)) => StageEnd::SnappedBack { lost, held },
                    None => {
                        moved.remember(&mut state.observers, stage, &rest);
                        StageEnd::AtRest(rest)
                    }
                }
            }
            Relaxed::Stopped(_) => return Ok(StageEnd::Stopped),
            relaxed => StageEnd::Restless { relaxed, place: place(&self.model, phase, &relaxed) },
        };
        let at_rest = matches!(end, StageEnd::AtRest(_));
        let snapshot = still(engine, state).snapshot;
        let own = self.whole(state);
        let mut memory = std::mem::take(&mut state.observers);
        let Simulation { model, assembly, plan, .. } = self;
        let history = History::new(assembly, &state.history);
        let view =
            View { model, assembly, phase, plan, snapshot: &snapshot, history, numbers: &state.numbers };
        let State { u, start, du: last, reference, .. } = &*state;
        let seen = StageSeen { stage, at_rest, rest: &rest, view, u, start, last, reference };
        let told = audience.tell(&Event::StageEnds(seen), &mut memory);
        state.observers = memory;
        own.give_back(state);
        engine.own(state);
        told.map(|()| end)
    }

    fn relax_state(
        &mut self,
        stage: usize,
        engine: &mut Engine,
        audience: &mut Audience,
        state: &mut State,
        watch: &mut dyn FnMut(&Cycle) -> Go,
    ) -> Result<Relaxed, RunError> {
        let plan = self.plan.clone();
        let planned = &plan.stages[stage];
        audience.tell(&Event::StageBegins(stage), &mut state.observers)?;
        let mut failed = None;
        let mut start_ratio = f64::NAN;
        let relaxed = engine.relax_watched(state, &planned.release, &mut |state, rest| {
            let cycle = state.relaxing.cycle;
            if rest.cycles > 0 {
                let freed = state.relaxing.freed > 0;
                if let Err(e) = audience.cycle(stage, rest, freed, &mut state.observers) {
                    failed = Some(e);
                    return false;
                }
            }
            if cycle == planned.release.cycles {
                start_ratio = rest.ratio;
            }
            let share = share(rest, planned, start_ratio);
            let go = watch(&Cycle { stage, cycle, rest: *rest, share });
            let [stop, keep] = self.agreed(go == Go::Stop, go == Go::Checkpoint);
            if (stop || keep)
                && let Err(e) = self.keep(state)
            {
                failed = Some(e);
                return false;
            }
            !stop
        });
        match failed {
            Some(e) => Err(e),
            None => Ok(relaxed),
        }
    }

    /// What is seen of the stage that goes on or ended last. Nothing in it has a velocity.
    pub(super) fn look_at_stage(&mut self) -> Result<(Arc<Phase>, Look), RunError> {
        let next = self.state.stage;
        let now = if self.state.relaxing.cycle > 0 { next } else { next.saturating_sub(1) };
        let stage = if self.plan.stages.is_empty() { Stage::Shaking } else { Stage::Before(now as u16) };
        let phase = Phase::of(&self.model, &self.assembly, stage)?;
        let mut engine = Engine::among(&self.model, &self.assembly, &phase, self.ranks.as_ref());
        let look = still(&mut engine, &self.state);
        Ok((phase, look))
    }
}

/// What is seen of a state of a stage. Nothing in it has a velocity.
fn still(engine: &mut Engine, state: &State) -> Look {
    let mut look = engine.look(state);
    look.snapshot.velocity.fill(Row::ZERO);
    look.snapshot.acceleration.fill(Row::ZERO);
    look
}

/// How far a stage is, from 0 to 1: a guess, by the ramp and then by the decades that the ratio has fallen.
fn share(rest: &Rest, planned: &PlannedStage, start: f64) -> f64 {
    let release = &planned.release;
    let ramp = 0.4 * (rest.cycles as f64 / release.cycles.max(1) as f64).min(1.0);
    let decades = (start / rest.ratio).ln() / (start / release.tolerance[0]).ln();
    let fallen =
        if rest.cycles > release.cycles && decades.is_finite() { decades.clamp(0.0, 1.0) } else { 0.0 };
    ramp + 0.6 * fallen
}

/// Where a relaxation that failed moves most.
fn place(model: &Model, phase: &Phase, relaxed: &Relaxed) -> Said {
    let element = match relaxed {
        Relaxed::Torn(_, element) => Some(*element),
        Relaxed::AtRest(rest) | Relaxed::Stopped(rest) | Relaxed::Restless(rest) => {
            let node = model.mesh_node[rest.fastest as usize];
            let holds = |e: &usize| model.mesh.elements[*e].nodes().contains(&node);
            let slots = phase.element_slot.iter().enumerate();
            slots.filter(|(_, slot)| slot.is_some()).map(|(e, _)| e).find(holds).map(|e| e as u32)
        }
    };
    element.map_or_else(|| said!("no element"), |element| places::element_at(model, element))
}
