//! Stages of a run: each is relaxed, looked at and written, so that what is done stays done.

use super::beside::Beside;
use super::kept::{self, Rested};
use super::moved::MovedNodes;
use super::{Control, Progress, TELL};
use crate::checkpoint;
use crate::error::RunError;
use crate::history::History;
use crate::observers::{
    BoltForces, BoltGrid, FieldGrid, InterfaceGrid, SectionForces, View, at_rest, columns,
};
use crate::places;
use crate::plan::Plan;
use crate::quantities::Field;
use crate::stages::PlannedStage;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::time::Instant;
use tremolite_engine::engine::{Relaxed, Rest};
use tremolite_engine::hexahedra::hex;
use tremolite_engine::state::{Memory, State};
use tremolite_engine::{Assembly, Engine, Model, Phase, Snapshot, Stage};
use tremolite_laws::{Role, Row};
use tremolite_results::{Column, Pvd, ResultFolder, Said, TableWriter, said, write_stages};

/// What is remembered of how stages came to rest: stage, cycle, ratio, motion left, motion.
const RELAXATION: &str = "relaxation";
/// Cycles between rows of that.
const EVERY: u64 = 10;
/// Motion to the initial equilibrium, in the file of that stage.
const INITIAL_MOTION: &str = "initial_motion";

/// How the stages ended.
pub(super) enum Before {
    Done,
    Stopped,
    /// What a stage moves snapped back: the stage, and what was let go at once of what was held \[J\].
    SnappedBack {
        stage: usize,
        lost: f64,
        held: f64,
    },
    /// In this stage, with a place.
    Failed {
        stage: usize,
        relaxed: Relaxed,
        place: Said,
    },
}

/// A run's stages.
pub(super) struct Stages<'a> {
    pub model: &'a Arc<Model>,
    pub assembly: &'a Arc<Assembly>,
    pub plan: &'a Plan,
    pub folder: &'a ResultFolder,
    pub fingerprint: u64,
}

impl Stages<'_> {
    /// Brings a state through the stages that are left.
    pub fn run(&self, state: &mut State, control: &mut Control) -> Result<Before, RunError> {
        let Stages { model, assembly, plan, .. } = *self;
        let first = state.stage as usize;
        for (k, planned) in plan.stages.iter().enumerate().skip(first) {
            let phase = Phase::of(model, assembly, Stage::Before(k as u16))?;
            let mut engine = Engine::new(model, assembly, &phase);
            match self.relax(k, planned, &mut engine, state, control)? {
                Relaxed::AtRest(rest) => {
                    let moved = MovedNodes::of(model, &mut engine, state);
                    if let Some((lost, held)) = moved.snapped_back(&mut state.observers, k, &rest) {
                        self.give_up(k, &phase, &mut engine, state)?;
                        self.write(state)?;
                        return Ok(Before::SnappedBack { stage: k, lost, held });
                    }
                    moved.remember(&mut state.observers, k, &rest);
                    self.look(k, &phase, &mut engine, state, &rest)?;
                    self.write(state)?;
                }
                Relaxed::Stopped(_) => return Ok(Before::Stopped),
                relaxed => {
                    // What it looks like where it was given up.
                    self.give_up(k, &phase, &mut engine, state)?;
                    self.write(state)?;
                    let place = place(model, &phase, &relaxed);
                    return Ok(Before::Failed { stage: k, relaxed, place });
                }
            }
        }
        Ok(Before::Done)
    }

    fn relax(
        &self,
        stage: usize,
        planned: &PlannedStage,
        engine: &mut Engine,
        state: &mut State,
        control: &mut Control,
    ) -> Result<Relaxed, RunError> {
        let (mut told, mut kept) = (Instant::now(), Instant::now());
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
            let now = Instant::now();
            // Before the first cycle nothing is known of the balance.
            if rest.cycles > 0 && now - told >= TELL {
                told = now;
                (control.progress)(Progress {
                    stage: Some(stage),
                    share: (stage as f64 + share(rest, planned, start_ratio)) / self.plan.stages.len() as f64,
                    cycle,
                    ratio: rest.ratio,
                    ..Progress::default()
                });
            }
            let stop = control.stop.load(Ordering::Relaxed);
            let due = self.plan.checkpoint.is_some_and(|every| (now - kept).as_secs_f64() >= every);
            if stop || due {
                if let Err(e) = checkpoint::write(&self.folder.checkpoint(), state, self.fingerprint) {
                    failed = Some(e);
                    return false;
                }
                kept = now;
            }
            !stop
        });
        match failed {
            Some(e) => Err(e.into()),
            None => Ok(relaxed),
        }
    }

    /// Remembers how a stage ended, and writes what stands then.
    fn look(
        &self,
        stage: usize,
        phase: &Phase,
        engine: &mut Engine,
        state: &mut State,
        rest: &Rest,
    ) -> Result<(), RunError> {
        let model = self.model;
        let snapshot = still(engine, state);
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
        kept::remember(model, self.plan, &mut state.observers, &rested);
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
        let snapshot = still(engine, state);
        let last = ("motion_of_last_cycle", "m", state.du.as_slice());
        self.fields(stage, &self.view(phase, &snapshot, state), &state.observers, &[last])
    }

    fn view<'v>(&'v self, phase: &'v Phase, snapshot: &'v Snapshot, state: &'v State) -> View<'v> {
        let Stages { model, assembly, plan, .. } = *self;
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
        let grid = FieldGrid::of(self.model, view.phase);
        grid.write(&folder.join(&name), stage as f64, view, memory, more)?;
        list(&self.folder.stages_pvd(), stage, &format!("stages/{name}"))?;
        if self.plan.fields.contains(&Field::Interface) && !self.model.user_seams().is_empty() {
            let folder = self.folder.interface_fields();
            std::fs::create_dir_all(&folder)
                .map_err(|source| RunError::Io { path: folder.clone(), source })?;
            let name = format!("stage-{stage:03}.vtu");
            InterfaceGrid::of(self.model, view.phase.stage).write(&folder.join(&name), stage as f64, view)?;
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
    pub fn write(&self, state: &State) -> Result<(), RunError> {
        let Stages { model, plan, folder, .. } = *self;
        write_stages(&folder.stages(), &columns(plan)[1..], &kept::summaries(model, plan, &state.observers))?;
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
fn still(engine: &mut Engine, state: &State) -> Snapshot {
    let mut snapshot = engine.look(state).snapshot;
    snapshot.velocity.fill(Row::ZERO);
    snapshot.acceleration.fill(Row::ZERO);
    snapshot
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
