//! Stages of a run: each is relaxed, looked at and written, so that what is done stays done.

use super::Simulation;
use super::beside::Beside;
use super::kept::{self, Rested};
use super::moved::MovedNodes;
use crate::checkpoint;
use crate::error::RunError;
use crate::history::History;
use crate::observers::{BoltForces, BoltGrid, FieldGrid, InterfaceGrid, SectionForces, View, at_rest, cells};
use crate::places;
use crate::quantities::Field;
use crate::stages::PlannedStage;
use std::path::Path;
use std::sync::Arc;
use tremolite_engine::engine::{Look, Relaxed, Rest};
use tremolite_engine::hexahedra::hex;
use tremolite_engine::state::{Memory, State};
use tremolite_engine::{Engine, Model, Phase, Snapshot, Stage};
use tremolite_laws::{Role, Row};
use tremolite_results::{Column, Pvd, Said, TableWriter, said, write_stages};

/// What is remembered of how stages came to rest: stage, cycle, ratio, motion left, motion.
const RELAXATION: &str = "relaxation";
/// Cycles between rows of that.
const EVERY: u64 = 10;
/// Motion to the initial equilibrium, in the file of that stage.
const INITIAL_MOTION: &str = "initial_motion";

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
    /// Brings the stage that comes next to rest, looks at it and writes what stands then. `watch` is asked before every cycle.
    ///
    /// # Errors
    /// If no stage is left, or a file cannot be written.
    pub fn relax(&mut self, watch: &mut dyn FnMut(&Cycle) -> Go) -> Result<StageEnd, RunError> {
        let stage = self.stage().ok_or(RunError::NoStageLeft)?;
        let phase = Phase::of(&self.model, &self.assembly, Stage::Before(stage as u16))?;
        let mut engine = Engine::new(&self.model, &self.assembly, &phase);
        let mut state = std::mem::take(&mut self.state);
        let relaxed = self.relax_state(stage, &mut engine, &mut state, watch);
        let end = relaxed.and_then(|relaxed| self.end_stage(stage, relaxed, &phase, &mut engine, &mut state));
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
            checkpoint::write_hand_over(&self.folder.checkpoint(), &mut self.state, self.fingerprint)?;
        }
        Ok(())
    }

    fn end_stage(
        &self,
        stage: usize,
        relaxed: Relaxed,
        phase: &Phase,
        engine: &mut Engine,
        state: &mut State,
    ) -> Result<StageEnd, RunError> {
        let end = match relaxed {
            Relaxed::AtRest(rest) => {
                let moved = MovedNodes::of(&self.model, engine, state);
                if let Some((lost, held)) = moved.snapped_back(&mut state.observers, stage, &rest) {
                    self.give_up(stage, phase, engine, state)?;
                    StageEnd::SnappedBack { lost, held }
                } else {
                    moved.remember(&mut state.observers, stage, &rest);
                    self.look_at_rest(stage, phase, engine, state, &rest)?;
                    StageEnd::AtRest(rest)
                }
            }
            Relaxed::Stopped(_) => return Ok(StageEnd::Stopped),
            relaxed => {
                // What it looks like where it was given up.
                self.give_up(stage, phase, engine, state)?;
                StageEnd::Restless { relaxed, place: place(&self.model, phase, &relaxed) }
            }
        };
        self.write_tables(state)?;
        Ok(end)
    }

    fn relax_state(
        &self,
        stage: usize,
        engine: &mut Engine,
        state: &mut State,
        watch: &mut dyn FnMut(&Cycle) -> Go,
    ) -> Result<Relaxed, RunError> {
        let planned = &self.plan.stages[stage];
        let mut failed = None;
        let mut start_ratio = f64::NAN;
        let relaxed = engine.relax_watched(state, &planned.release, &mut |state, rest| {
            let cycle = state.relaxing.cycle;
            if rest.cycles > 0 && rest.cycles.is_multiple_of(EVERY) {
                remember(&mut state.observers, stage, rest);
            }
            if stage == 0 && rest.cycles == 1 && state.relaxing.freed == 0 {
                kept::remember_imbalance(&mut state.observers, rest.unreleased);
            }
            if cycle == planned.release.cycles {
                start_ratio = rest.ratio;
            }
            let share = share(rest, planned, start_ratio);
            let go = watch(&Cycle { stage, cycle, rest: *rest, share });
            if go != Go::On
                && let Err(e) = checkpoint::write(&self.folder.checkpoint(), state, self.fingerprint)
            {
                failed = Some(e);
                return false;
            }
            go != Go::Stop
        });
        match failed {
            Some(e) => Err(e.into()),
            None => Ok(relaxed),
        }
    }

    /// What is seen of the stage that goes on or ended last. Nothing in it has a velocity.
    pub(super) fn look_at_stage(&mut self) -> Result<(Arc<Phase>, Look), RunError> {
        let next = self.state.stage;
        let now = if self.state.relaxing.cycle > 0 { next } else { next.saturating_sub(1) };
        let stage = if self.plan.stages.is_empty() { Stage::Shaking } else { Stage::Before(now as u16) };
        let phase = Phase::of(&self.model, &self.assembly, stage)?;
        let look = still(&mut Engine::new(&self.model, &self.assembly, &phase), &self.state);
        Ok((phase, look))
    }

    /// Remembers how a stage ended, and writes what stands then.
    fn look_at_rest(
        &self,
        stage: usize,
        phase: &Phase,
        engine: &mut Engine,
        state: &mut State,
        rest: &Rest,
    ) -> Result<(), RunError> {
        let model = &*self.model;
        let snapshot = still(engine, state).snapshot;
        let view = self.view(phase, &snapshot, state);
        let monitors = at_rest(&view, state);
        let walls = kept::walls(model).into_iter().map(|(_, node)| state.shown(node).xyz()).collect();
        let rested = Rested { rest, plastic_volume: plastic_volume(&view), monitors, walls };
        let sections = SectionForces::of(model);
        let forces = sections.at(&view);
        let bolts = BoltForces::at(&view);
        let beside = Beside::of(&view, &state.observers, stage == 0);
        let uneven = kept::Uneven::of(&view, state);
        let beginning = (stage == 0).then(|| kept::Beginning::of(&view, uneven));
        // Displacements count from here; what it took to get here is told beside them.
        let since_start = |(now, before): (&Row, &Row)| Row([0, 1, 2, 3].map(|i| now.0[i] - before.0[i]));
        let motion: Vec<Row> = state.u.iter().zip(&state.start).map(since_start).collect();
        let motion = [(INITIAL_MOTION, "m", motion.as_slice())];
        self.fields(stage, &view, &state.observers, if stage == 0 { &motion } else { &[] })?;
        kept::remember(model, &self.plan, &mut state.observers, &rested);
        uneven.remember(&mut state.observers);
        if let Some(beginning) = beginning {
            beginning.remember(&mut state.observers);
        }
        beside.into_iter().for_each(|(key, values)| _ = state.observers.insert(key.into(), values));
        sections.remember(&mut state.observers, forces);
        BoltForces::remember(&mut state.observers, stage, &bolts);
        Ok(())
    }

    /// Writes where a stage was given up: with the motion of the last cycle, which shows what falls.
    fn give_up(
        &self,
        stage: usize,
        phase: &Phase,
        engine: &mut Engine,
        state: &mut State,
    ) -> Result<(), RunError> {
        let snapshot = still(engine, state).snapshot;
        let last = ("motion_of_last_cycle", "m", state.du.as_slice());
        self.fields(stage, &self.view(phase, &snapshot, state), &state.observers, &[last])
    }

    fn view<'v>(&'v self, phase: &'v Phase, snapshot: &'v Snapshot, state: &'v State) -> View<'v> {
        let Simulation { model, assembly, plan, .. } = self;
        let history = History { assembly, octets: &state.history };
        View { model, assembly, phase, plan, snapshot, history, numbers: &state.numbers }
    }

    fn fields(
        &self,
        stage: usize,
        view: &View,
        memory: &Memory,
        more: &[(&str, &str, &[Row])],
    ) -> Result<(), RunError> {
        let folder = self.folder.stage_fields();
        std::fs::create_dir_all(&folder).map_err(|source| RunError::Io { path: folder.clone(), source })?;
        let name = format!("{stage:03}.vtu");
        let grid = FieldGrid::of(&self.model, view.phase);
        grid.write(&folder.join(&name), stage as f64, view, memory, more)?;
        list(&self.folder.stages_pvd(), stage, &format!("stages/{name}"))?;
        if self.plan.fields.contains(&Field::Interface) && !self.model.user_seams().is_empty() {
            let folder = self.folder.interface_fields();
            std::fs::create_dir_all(&folder)
                .map_err(|source| RunError::Io { path: folder.clone(), source })?;
            let name = format!("stage-{stage:03}.vtu");
            InterfaceGrid::of(&self.model, view.phase.stage).write(
                &folder.join(&name),
                stage as f64,
                view,
            )?;
            // The list begins anew with the earthquake.
            list(&self.folder.interfaces_pvd(), stage, &format!("interfaces/{name}"))?;
        }
        let bolts = BoltGrid::of(&self.model.bolts, view.phase.stage);
        if !bolts.is_empty() {
            let folder = self.folder.bolt_fields();
            std::fs::create_dir_all(&folder)
                .map_err(|source| RunError::Io { path: folder.clone(), source })?;
            let name = format!("stage-{stage:03}.vtu");
            bolts.write(&folder.join(&name), stage as f64, view)?;
            list(&self.folder.bolts_pvd(), stage, &format!("bolts/{name}"))?;
        }
        Ok(())
    }

    /// Writes the tables of the stages whole, from what is remembered.
    pub(super) fn write_stages(&self) -> Result<(), RunError> {
        self.write_tables(&self.state)
    }

    fn write_tables(&self, state: &State) -> Result<(), RunError> {
        let Simulation { model, plan, folder, .. } = self;
        let columns: Vec<Column> = cells(plan).into_iter().map(|cell| cell.column).collect();
        write_stages(&folder.stages(), &columns, &kept::summaries(model, plan, &state.observers))?;
        let columns = [("stage", ""), ("cycle", ""), ("ratio", ""), ("motion_left", "m"), ("motion", "m")];
        let columns = columns.map(|(name, unit)| Column::new(name, unit));
        let mut table = TableWriter::create(&folder.relaxation(), &columns)?;
        let rows = state.observers.get(RELAXATION).map_or(&[][..], Vec::as_slice);
        for row in rows.chunks_exact(columns.len()) {
            table.write(row)?;
        }
        BoltForces::write(model, folder, plan, &state.observers)?;
        SectionForces::of(model).write(folder, plan, &state.observers)
    }
}

/// Adds a stage's file to a list; one that a stopped run had written already is written again.
fn list(path: &Path, stage: usize, file: &str) -> Result<(), RunError> {
    let mut list = match path.exists() && stage > 0 {
        true => Pvd::resume(path, stage as f64 - 0.5)?,
        false => Pvd::create(path)?,
    };
    Ok(list.add(stage as f64, file)?)
}

/// What is seen of a state of a stage. Nothing in it has a velocity.
fn still(engine: &mut Engine, state: &State) -> Look {
    let mut look = engine.look(state);
    look.snapshot.velocity.fill(Row::ZERO);
    look.snapshot.acceleration.fill(Row::ZERO);
    look
}

fn remember(memory: &mut Memory, stage: usize, rest: &Rest) {
    let rows = memory.entry(RELAXATION.into()).or_default();
    // A cycle that a checkpoint saw just before it was made is told again.
    let row = [stage as f64, rest.cycles as f64, rest.ratio, rest.left, rest.motion];
    if rows.rchunks(row.len()).next().is_none_or(|last| last[..2] != row[..2]) {
        rows.extend(row);
    }
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

/// ∫Γ dV over what stands \[m³\].
fn plastic_volume(view: &View) -> f64 {
    let slots = view.phase.element_slot.iter().enumerate().filter_map(|(e, slot)| Some((e, (*slot)?)));
    slots
        .filter_map(|(e, slot)| {
            let column = view.history.with_role(&slot, Role::PlasticShear)?;
            let hex = hex(&view.model.mesh, e).ok()?;
            let values = view.history.values(&slot, column).zip(slot.places.quadrature.shares());
            let mean: f64 = values.map(|(value, share)| share * value).sum();
            Some(hex.volume * mean)
        })
        // A sum of nothing is −0.
        .fold(0.0, |sum, volume| sum + volume)
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
