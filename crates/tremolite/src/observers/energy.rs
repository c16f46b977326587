//! energy.csv: the balance over time.

use super::{Observer, Schedule, Setting, View};
use crate::error::RunError;
use tremolite_engine::state::Memory;
use tremolite_kernels::Line;
use tremolite_results::{Column, TableWriter};

/// Key of what this observer remembers: the bytes written, and the largest error of all rows beyond the scheme's own part of
/// it \[J\].
pub const MEMORY: &str = "energy";

/// Writes a row of the energy balance.
pub struct Energy {
    schedule: Schedule,
    table: TableWriter,
}

impl Energy {
    /// Starts the table, or goes on with it where the state left it.
    ///
    /// # Errors
    /// If the file cannot be written, or is shorter than the state remembers.
    pub fn new(setting: &Setting) -> Result<Self, RunError> {
        let mut columns = vec![Column::new("time", "s")];
        columns.extend(setting.assembly.lines().map(|line| Column::new(line.name(), "J")));
        let path = setting.folder.energy();
        let table = match setting.memory.get(MEMORY) {
            Some(memory) => TableWriter::resume(&path, &columns, memory[0] as u64)?,
            None => TableWriter::create(&path, &columns)?,
        };
        Ok(Energy { schedule: setting.rows(), table })
    }
}

impl Observer for Energy {
    fn schedule(&self) -> Schedule {
        self.schedule
    }

    fn see(&mut self, view: &View, memory: &mut Memory) -> Result<(), RunError> {
        let balance = &view.snapshot.balance;
        let mut row = vec![view.snapshot.time];
        row.extend(view.assembly.lines().map(|line| balance[line]));
        self.table.write(&row)?;
        let beyond = (balance[Line::Error] - view.snapshot.scheme).abs();
        let most = memory.get(MEMORY).map_or(0.0, |kept| kept[1]);
        let most = if beyond.is_nan() { beyond } else { most.max(beyond) };
        memory.insert(MEMORY.into(), vec![self.table.bytes_written() as f64, most]);
        Ok(())
    }
}
