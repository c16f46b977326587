//! bolts.csv: what bolts carry at the end of each stage, and as the ground shakes.

use super::observer::{Event, Observer, Schedule, Setting, StageSeen, View, Wants, Which};
use super::run_table;
use crate::error::RunError;
use crate::plan::Plan;
use crate::support::{BoltSeen, look, seen, word};
use std::path::PathBuf;
use std::sync::Arc;
use tremolite_engine::assembly::Assembly;
use tremolite_engine::bolts::{BoltSet, SegmentState};
use tremolite_engine::member::Kind;
use tremolite_engine::state::Memory;
use tremolite_engine::{Model, Stage};
use tremolite_results::{BoltPeak, BoltRow, BoltWriter, EARTHQUAKE, ResultFolder};

/// Rows at the ends of stages, [`EACH`] numbers each behind the stage's.
const STAGES: &str = "bolts of stages";
/// By group, the largest force of any stage and step, as [`PEAK`] numbers.
const PEAKS: &str = "largest forces of bolts";

/// A row in numbers: group, bolt, force, its share of yield, slip, state, place, largest force, length cut off.
const EACH: usize = 11;
/// Largest force, its share of yield (each the largest there was), stage (−1 for the shaking), time, bolt, place.
const PEAK: usize = 8;
/// Bars of a group from which on it is told by the one that carries most: more are reinforcement, and would be a file of
/// gigabytes.
pub const MOST: usize = 4000;

/// Looks at all bolts with the rows of histories, and writes them with field files.
pub struct BoltForces {
    schedule: Schedule,
    bolts: Which,
    written: Schedule,
    path: PathBuf,
    table: BoltWriter,
}

impl BoltForces {
    /// Starts the table with the rows of the stages, or goes on with it where the state left it; nothing without bolts.
    ///
    /// # Errors
    /// If the file cannot be written, or is not what the state remembers.
    pub fn new(setting: &Setting) -> Result<Option<Self>, RunError> {
        let Setting { folder, model, plan, steps, memory, .. } = *setting;
        if model.bolts.is_empty() {
            return Ok(None);
        }
        let path = folder.bolts();
        let table = match run_table::known(&path, memory) {
            Some(extent) => BoltWriter::resume(&path, extent)?,
            None => BoltWriter::create(&path, &rows_of_stages(&model.bolts, plan, memory))?,
        };
        let written = Schedule { every: steps.snapshots.unwrap_or(steps.total), last: Some(steps.total) };
        Ok(Some(BoltForces {
            schedule: setting.rows(),
            bolts: bolts(setting.assembly),
            written,
            path,
            table,
        }))
    }

    /// Of each group the largest force so far, and the largest share of yield.
    pub fn peaks(sets: &[BoltSet], plan: &Plan, memory: &Memory) -> Vec<(BoltPeak, f64)> {
        let kept = memory.get(PEAKS).map_or(&[][..], Vec::as_slice);
        let of = |(set, peak): (&BoltSet, &[f64])| {
            let &[force, over, stage, time, bolt, x, y, z] = peak else { return (BoltPeak::default(), 0.0) };
            let number = set.bolts.get(bolt as usize).map_or(0, |bolt| u64::from(bolt.bar) + 1);
            let loaded = force != 0.0;
            let peak = BoltPeak {
                force,
                bolt: if loaded { number } else { 0 },
                at: [x, y, z],
                stage: if loaded { stage_name(plan, stage) } else { String::new() },
                time,
            };
            (peak, over)
        };
        let nothing = || vec![0.0; PEAK * sets.len()];
        let all = if kept.len() == PEAK * sets.len() { kept.to_vec() } else { nothing() };
        sets.iter().zip(all.chunks_exact(PEAK)).map(of).collect()
    }
}

/// Keeps what bolts do at the end of each stage, and writes it.
pub struct BoltsOfStages {
    bolts: Which,
    folder: ResultFolder,
    model: Arc<Model>,
    plan: Arc<Plan>,
}

impl BoltsOfStages {
    /// Nothing without bolts.
    pub fn new(setting: &Setting) -> Option<Self> {
        let Setting { folder, model, assembly, plan, .. } = *setting;
        let found = || BoltsOfStages {
            bolts: bolts(assembly),
            folder: folder.clone(),
            model: model.clone(),
            plan: plan.clone(),
        };
        (!model.bolts.is_empty()).then(found)
    }

    fn remember(memory: &mut Memory, stage: usize, seen: &[Vec<BoltSeen>]) {
        let rows = memory.entry(STAGES.into()).or_default();
        for row in rows_of(seen) {
            rows.push(stage as f64);
            rows.extend(row);
        }
        follow(seen, stage as f64, f64::NAN, memory);
    }
}

impl Observer for BoltsOfStages {
    fn wants(&self) -> Wants {
        Wants { members: self.bolts.clone(), ..Wants::default() }
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        match event {
            Event::StageEnds(StageSeen { stage, at_rest, view, .. }) => {
                if *at_rest {
                    BoltsOfStages::remember(memory, *stage, &at(view));
                }
            }
            Event::StagesTaken => {}
            _ => return Ok(()),
        }
        BoltWriter::create(&self.folder.bolts(), &rows_of_stages(&self.model.bolts, &self.plan, memory))?;
        Ok(())
    }
}

/// The members that bolts are in.
pub(super) fn bolts(assembly: &Assembly) -> Which {
    Which::members(assembly, |kind| matches!(kind, Kind::Bolts(_)))
}

/// What all bolts do.
fn at(view: &View) -> Vec<Vec<BoltSeen>> {
    seen(&view.model.bolts, view.phase.stage, &look(view.assembly, view.numbers))
}

/// −1 stands for the shaking.
fn stage_name(plan: &Plan, stage: f64) -> String {
    match stage {
        s if s < 0.0 => EARTHQUAKE.into(),
        s => plan.stages.get(s as usize).map(|stage| stage.name.clone()).unwrap_or_default(),
    }
}

/// Follows the largest forces.
fn follow(seen: &[Vec<BoltSeen>], stage: f64, time: f64, memory: &mut Memory) {
    let kept = memory.entry(PEAKS.into()).or_default();
    kept.resize(PEAK * seen.len(), 0.0);
    for (bolts, kept) in seen.iter().zip(kept.chunks_exact_mut(PEAK)) {
        for (b, bolt) in bolts.iter().enumerate() {
            kept[1] = kept[1].max(bolt.largest_over_yield);
            if bolt.largest_force.abs() > kept[0].abs() {
                let [x, y, z] = bolt.largest_place;
                let over = kept[1];
                kept.copy_from_slice(&[bolt.largest_force, over, stage, time, b as f64, x, y, z]);
            }
        }
    }
}

/// A row for each bolt; of a group of more than [`MOST`] for the one that carries most of what it can.
fn rows_of(seen: &[Vec<BoltSeen>]) -> Vec<[f64; EACH]> {
    let row = |set: usize, b: usize, bolt: &BoltSeen| {
        let BoltSeen { force, place: [x, y, z], over_yield, slip, state, largest_force, cut_off, .. } = *bolt;
        let state = f64::from(state as u8);
        [set as f64, b as f64, force, over_yield, slip, state, x, y, z, largest_force, cut_off]
    };
    let mut rows = Vec::new();
    for (set, bolts) in seen.iter().enumerate() {
        let all = || bolts.iter().enumerate();
        if bolts.len() <= MOST {
            rows.extend(all().map(|(b, bolt)| row(set, b, bolt)));
        } else {
            let load = |bolt: &BoltSeen| (bolt.over_yield, bolt.force.abs());
            let more = |a: &(usize, &BoltSeen), b: &(usize, &BoltSeen)| {
                let ((over_a, force_a), (over_b, force_b)) = (load(a.1), load(b.1));
                over_a.total_cmp(&over_b).then(force_a.total_cmp(&force_b))
            };
            rows.extend(all().max_by(more).map(|(b, bolt)| row(set, b, bolt)));
        }
    }
    rows
}

/// Rows at most \[rows\] that are written of sets in a stage.
pub fn count(sets: &[BoltSet], stage: Stage) -> usize {
    let there = sets.iter().filter(|set| set.kind.born <= stage);
    there.map(|set| if set.bolts.len() > MOST { 1 } else { set.bolts.len() }).sum()
}

fn rows_of_stages(sets: &[BoltSet], plan: &Plan, memory: &Memory) -> Vec<BoltRow> {
    let kept = memory.get(STAGES).map_or(&[][..], Vec::as_slice);
    let row = |kept: &[f64]| told(sets, &kept[1..], &stage_name(plan, kept[0]), f64::NAN);
    kept.chunks_exact(1 + EACH).filter_map(row).collect()
}

/// A row in words; none of a bolt that the model lacks.
fn told(sets: &[BoltSet], row: &[f64], stage: &str, time: f64) -> Option<BoltRow> {
    let &[set, bolt, max_force, force_over_yield, max_slip, state, x, y, z, largest_force, cut_off] = row
    else {
        return None;
    };
    const STATES: [SegmentState; 5] = [
        SegmentState::Elastic,
        SegmentState::Slid,
        SegmentState::Yielded,
        SegmentState::Broken,
        SegmentState::CutOff,
    ];
    let set = sets.get(set as usize)?;
    Some(BoltRow {
        bolt: set.bolts.get(bolt as usize)?.bar + 1,
        name: set.kind.name.clone(),
        time,
        max_force,
        force_over_yield,
        max_slip,
        state: word(*STATES.get(state as usize)?).into(),
        stage: stage.into(),
        place: [x, y, z],
        largest_force,
        cut_off,
    })
}

impl Observer for BoltForces {
    fn wants(&self) -> Wants {
        Wants { members: self.bolts.clone(), ..Wants::looks(self.schedule) }
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        match event {
            Event::Look(view) => self.see(view, memory),
            _ => Ok(()),
        }
    }
}

impl BoltForces {
    fn see(&mut self, view: &View, memory: &mut Memory) -> Result<(), RunError> {
        let View { model, snapshot, .. } = *view;
        let seen = at(view);
        follow(&seen, -1.0, snapshot.time, memory);
        if self.written.due(snapshot.step) {
            let row = |row: [f64; EACH]| told(&model.bolts, &row, EARTHQUAKE, snapshot.time);
            self.table.write(&rows_of(&seen).into_iter().filter_map(row).collect::<Vec<_>>())?;
        }
        run_table::remember(&self.path, self.table.extent(), memory);
        Ok(())
    }
}

#[cfg(test)]
mod tests;
