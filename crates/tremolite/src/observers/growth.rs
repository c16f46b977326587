//! damage.csv: how damage grows, group by group.

use super::{Cracks, Observer, Schedule, View};
use crate::damage::{Group, groups};
use crate::history;
use crate::model::{Model, hex};
use crate::phase::{ElementSlot, Phase};
use crate::quantities::{MEASURES, Measure};
use crate::run::RunError;
use crate::state::State;
use std::path::Path;
use tremolite_results::{Column, TableWriter};

/// Key of what this observer remembers: the bytes written.
const MEMORY: &str = "growth";

/// An element with the volumes of its points \[m³\].
struct Cell {
    slot: ElementSlot,
    volumes: Vec<f64>,
}

/// A whole group.
struct Part {
    cells: Vec<Cell>,
    volume: f64,
    measures: Vec<Measure>,
    cracks: bool,
}

/// Writes, for each group that is no part of another, the share of its volume in which each measure of damage is above
/// the value that counts, and the widest crack so far.
pub struct Growth {
    schedule: Schedule,
    table: TableWriter,
    parts: Vec<Part>,
}

impl Growth {
    /// Starts the table, or goes on with it where the state left it; nothing if no law of the model can be damaged.
    ///
    /// # Errors
    /// If the file cannot be written, or is shorter than the state remembers.
    pub fn new(
        path: &Path,
        model: &Model,
        phase: &Phase,
        schedule: Schedule,
        state: &State,
    ) -> Result<Option<Self>, RunError> {
        let groups = groups(model);
        let whole: Vec<&Group> = groups.iter().filter(|g| g.whole).collect();
        let parts: Vec<Part> = whole.iter().map(|group| part(model, phase, group)).collect();
        let mut columns = vec![Column::new("time", "s")];
        for (group, part) in whole.iter().zip(&parts) {
            // A header is one word.
            let name = group
                .name
                .replace(", ", "+")
                .replace(|c: char| c.is_whitespace() || ",\"'[]".contains(c), "_");
            columns.extend(part.measures.iter().map(|m| Column::new(format!("{name}.{}", m.column), "")));
            if part.cracks {
                columns.push(Column::new(format!("{name}.crack_opening"), "m"));
            }
        }
        if parts.is_empty() {
            return Ok(None);
        }
        let table = match state.observers.get(MEMORY) {
            Some(memory) => TableWriter::resume(path, &columns, memory[0] as u64)?,
            None => TableWriter::create(path, &columns)?,
        };
        Ok(Some(Growth { schedule, table, parts }))
    }
}

fn part(model: &Model, phase: &Phase, group: &Group) -> Part {
    let mut cells = Vec::new();
    for &element in group.elements {
        let (Some(slot), Ok(hex)) =
            (phase.element_slot[element as usize], hex(&model.mesh, element as usize))
        else {
            continue;
        };
        let volumes = if slot.points == 8 { hex.weights.to_vec() } else { vec![hex.volume] };
        cells.push(Cell { slot, volumes });
    }
    let has = |name: &str| cells.iter().any(|c| history::position(model, &c.slot, name).is_some());
    Part {
        volume: cells.iter().flat_map(|c| &c.volumes).sum(),
        measures: MEASURES.iter().filter(|m| has(m.column)).copied().collect(),
        cracks: has("crack_size"),
        cells,
    }
}

impl Observer for Growth {
    fn schedule(&self) -> Schedule {
        self.schedule
    }

    fn see(&mut self, view: &View, state: &mut State) -> Result<(), RunError> {
        let View { model, phase, .. } = *view;
        let mut row = vec![state.time()];
        for part in &self.parts {
            for measure in &part.measures {
                let mut damaged = 0.0;
                for cell in &part.cells {
                    let Some(column) = history::position(model, &cell.slot, measure.column) else { continue };
                    let values = history::values(model, phase, state, &cell.slot, column);
                    let beyond = values.zip(&cell.volumes).filter(|(value, _)| *value > measure.counts);
                    damaged += beyond.map(|(_, volume)| volume).sum::<f64>();
                }
                row.push(damaged / part.volume);
            }
            if part.cracks {
                let widest = state.observers.get(Cracks::OPENING);
                let of_cell = |cell: &Cell| widest.map_or(0.0, |w| w[cell.slot.element as usize]);
                row.push(part.cells.iter().map(of_cell).fold(0.0, f64::max));
            }
        }
        self.table.write(&row)?;
        state.observers.insert(MEMORY.into(), vec![self.table.bytes_written() as f64]);
        Ok(())
    }
}
