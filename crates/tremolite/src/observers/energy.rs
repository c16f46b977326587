//! energy.csv: the balance over time.

use super::RunTable;
use super::observer::{Event, Observer, Schedule, Setting, View, Wants};
use crate::error::RunError;
use tremolite_engine::Body;
use tremolite_engine::state::Memory;
use tremolite_kernels::Line;
use tremolite_laws::Role;
use tremolite_laws::parameter::position;
use tremolite_results::Column;

/// Key of what this observer remembers: the largest error of all rows beyond the scheme's own part of it and what
/// is in the books of bodies that dissipate; and by body the largest of all rows that is in theirs \[J\].
pub const MEMORY: &str = "energy balance";

/// Writes a row of the energy balance.
pub struct Energy {
    schedule: Schedule,
    table: RunTable,
}

impl Energy {
    /// Starts the table, or goes on with it where the state left it.
    ///
    /// # Errors
    /// If the file cannot be written, or is not what the state remembers.
    pub fn new(setting: &Setting) -> Result<Self, RunError> {
        let mut columns = vec![Column::new("time", "s")];
        columns.extend(setting.assembly.lines().map(|line| Column::new(line.name(), "J")));
        let table = RunTable::new(&setting.folder.energy(), &columns, setting.memory)?;
        Ok(Energy { schedule: setting.rows(), table })
    }
}

impl Observer for Energy {
    fn wants(&self) -> Wants {
        Wants::looks(self.schedule)
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        match event {
            Event::Look(view) => self.see(view, memory),
            _ => Ok(()),
        }
    }
}

impl Energy {
    fn see(&mut self, view: &View, memory: &mut Memory) -> Result<(), RunError> {
        let balance = &view.snapshot.balance;
        let mut row = vec![view.snapshot.time];
        row.extend(view.assembly.lines().map(|line| balance[line]));
        self.table.write(&row, memory)?;
        // The work done on a body that has gone nowhere is energy that the balance misses.
        let errors = of_bodies(view);
        let beyond = (balance[Line::Error] - view.snapshot.scheme + errors.iter().sum::<f64>()).abs();
        let kept = memory.get(MEMORY).map_or(&[][..], Vec::as_slice);
        let now = std::iter::once(beyond).chain(errors.into_iter().map(f64::abs));
        let most = now.enumerate().map(|(k, now)| match kept.get(k) {
            Some(most) if !now.is_nan() => most.max(now),
            _ => now,
        });
        let most = most.collect();
        memory.insert(MEMORY.into(), most);
        Ok(())
    }
}

/// By body of the user, the work on it that is in none of its lines \[J\], of those whose laws book what they dissipate: damage that
/// jumps within a step leaves some.
fn of_bodies(view: &View) -> Vec<f64> {
    let dissipates = |body: &Body| position(body.material.info().history, Role::Dissipated).is_some();
    let bodies = view.model.user_bodies().iter().zip(&view.snapshot.bodies);
    bodies.map(|(body, books)| if dissipates(body) { books.error() } else { 0.0 }).collect()
}
