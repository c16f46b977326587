//! relaxation.csv: how stages came to rest.

use super::super::observer::{CycleMade, Event, Observer, Setting, Wants};
use crate::error::RunError;
use tremolite_engine::engine::Rest;
use tremolite_engine::state::Memory;
use tremolite_results::{Column, ResultFolder, TableWriter};

/// What is remembered of it: stage, cycle, ratio, motion left, motion.
const MEMORY: &str = "relaxation";
/// Cycles between rows of that.
const EVERY: u64 = 10;

/// Keeps every tenth cycle, and writes them at the end of a stage.
pub struct Relaxation {
    folder: ResultFolder,
}

impl Relaxation {
    pub fn new(setting: &Setting) -> Self {
        Relaxation { folder: setting.folder.clone() }
    }
}

/// Writes all that is remembered.
pub(super) fn write(folder: &ResultFolder, memory: &Memory) -> Result<(), RunError> {
    let columns = [("stage", ""), ("cycle", ""), ("ratio", ""), ("motion_left", "m"), ("motion", "m")];
    let columns = columns.map(|(name, unit)| Column::new(name, unit));
    let mut table = TableWriter::create(&folder.relaxation(), &columns)?;
    let rows = memory.get(MEMORY).map_or(&[][..], Vec::as_slice);
    for row in rows.chunks_exact(columns.len()) {
        table.write(row)?;
    }
    Ok(())
}

impl Observer for Relaxation {
    fn wants(&self) -> Wants {
        Wants { cycles: Some(EVERY), ..Wants::default() }
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        match event {
            Event::Cycle(CycleMade { stage, rest, .. }) => {
                remember(memory, *stage, rest);
                Ok(())
            }
            Event::StageEnds(_) | Event::StagesTaken => write(&self.folder, memory),
            _ => Ok(()),
        }
    }
}

fn remember(memory: &mut Memory, stage: usize, rest: &Rest) {
    let rows = memory.entry(MEMORY.into()).or_default();
    // A cycle that a checkpoint saw just before it was made is told again.
    let row = [stage as f64, rest.cycles as f64, rest.ratio, rest.left, rest.motion];
    if rows.rchunks(row.len()).next().is_none_or(|last| last[..2] != row[..2]) {
        rows.extend(row);
    }
}
