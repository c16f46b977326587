//! damage.csv: how damage grows, group by group.

use super::observer::{Event, Observer, Schedule, Setting, View, Wants, Which};
use super::{Cracks, RunTable};
use crate::error::RunError;
use crate::groups::{Group, groups};
use crate::quantities::{MEASURES, Measure, SHARE_OF_VOLUME};
use std::collections::{BTreeSet, HashMap};
use tremolite_engine::hexahedra::hex;
use tremolite_engine::model::Model;
use tremolite_engine::phase::{ElementSlot, Phase};
use tremolite_engine::state::Memory;
use tremolite_laws::parameter::position;
use tremolite_laws::{Column as Kept, Role};
use tremolite_results::{Column, CrackDirection, Subject};

/// An element with the volumes of its points \[m³\].
struct Cell {
    slot: ElementSlot,
    volumes: Vec<f64>,
    /// Its row of what is remembered of cracks by direction, if its law has any.
    row: Option<usize>,
}

/// A whole group.
struct Part {
    cells: Vec<Cell>,
    /// Members that they are in.
    members: Vec<u32>,
    volume: f64,
    /// What its law keeps, by column.
    measures: Vec<(&'static Kept, Measure)>,
    cracks: bool,
}

/// Writes, for each group that is no part of another, the share of its volume in which each measure of damage is above
/// the value that counts, and the widest crack so far, of all and of each direction.
pub struct Growth {
    schedule: Schedule,
    elements: Which,
    table: RunTable,
    parts: Vec<Part>,
}

impl Growth {
    /// Starts the table, or goes on with it where the state left it; nothing if no law of the model can be damaged.
    ///
    /// # Errors
    /// If the file cannot be written, or is not what the state remembers.
    pub fn new(setting: &Setting) -> Result<Option<Self>, RunError> {
        let Setting { model, assembly, phase, .. } = *setting;
        let groups = groups(model);
        let whole: Vec<&Group> = groups.iter().filter(|g| g.whole).collect();
        let rows = Cracks::rows(assembly, phase);
        let parts: Vec<Part> = whole.iter().map(|group| part(model, phase, &rows, group)).collect();
        let mut columns = vec![Column::new("time", "s")];
        for (group, part) in whole.iter().zip(&parts) {
            // A header is one word.
            let name = group
                .name
                .replace(", ", "+")
                .replace(|c: char| c.is_whitespace() || ",\"'[]".contains(c), "_");
            let subject = Subject::Group(name);
            let share = |c: &Kept| Column::of(subject.clone(), c.name, SHARE_OF_VOLUME);
            columns.extend(part.measures.iter().map(|(c, _)| share(c)));
            if part.cracks {
                columns.push(Column::of(subject.clone(), "crack_opening", "m"));
                columns.extend(CrackDirection::ALL.map(|d| Column::of(subject.clone(), d.column(), "m")));
            }
        }
        if parts.is_empty() {
            return Ok(None);
        }
        let table = RunTable::new(&setting.folder.damage(), &columns, setting.memory)?;
        let elements = Which::some(whole.iter().flat_map(|group| &group.elements).map(|&e| e as usize));
        Ok(Some(Growth { schedule: setting.rows(), elements, table, parts }))
    }
}

fn part(model: &Model, phase: &Phase, rows: &HashMap<u32, usize>, group: &Group) -> Part {
    let mut cells = Vec::new();
    for &element in &group.elements {
        let (Some(slot), Ok(hex)) =
            (phase.element_slot[element as usize], hex(&model.mesh, element as usize))
        else {
            continue;
        };
        let volumes = slot.places.weights(&hex);
        cells.push(Cell { slot, volumes, row: rows.get(&element).copied() });
    }
    let members: BTreeSet<u32> = cells.iter().map(|cell: &Cell| cell.slot.member).collect();
    let history = group.body.material.info().history;
    let measure = |m: &Measure| position(history, m.role).map(|at| (&history[at], *m));
    Part {
        volume: cells.iter().flat_map(|c| &c.volumes).sum(),
        measures: MEASURES.iter().filter_map(measure).collect(),
        cracks: position(history, Role::CrackWidth).is_some(),
        members: members.into_iter().collect(),
        cells,
    }
}

impl Observer for Growth {
    fn wants(&self) -> Wants {
        Wants { histories: self.elements.clone(), ..Wants::looks(self.schedule) }
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        match event {
            Event::Look(view) => self.see(view, memory),
            _ => Ok(()),
        }
    }
}

impl Growth {
    fn see(&mut self, view: &View, memory: &mut Memory) -> Result<(), RunError> {
        let View { history, snapshot, .. } = *view;
        let mut row = vec![snapshot.time];
        for part in &self.parts {
            for (_, measure) in &part.measures {
                let mut damaged = 0.0;
                let beyond = history.beyond(&part.members, measure.role, measure.counts);
                for cell in part.cells.iter().filter(|cell| beyond[cell.slot.element as usize]) {
                    let Some(column) = history.with_role(&cell.slot, measure.role) else { continue };
                    let values = history.values(&cell.slot, column);
                    let beyond = values.zip(&cell.volumes).filter(|(value, _)| *value > measure.counts);
                    damaged += beyond.map(|(_, volume)| volume).sum::<f64>();
                }
                row.push(damaged / part.volume);
            }
            if part.cracks {
                let widest = memory.get(Cracks::OPENING);
                let of_cell = |cell: &Cell| widest.map_or(0.0, |w| w[cell.slot.element as usize]);
                row.push(part.cells.iter().map(of_cell).fold(0.0, f64::max));
                let remembered = Cracks::remembered(memory);
                let mut each = [0.0_f64; CrackDirection::ALL.len()];
                for own in part.cells.iter().filter_map(|cell| cell.row) {
                    let opened = Cracks::opened(remembered, own);
                    each.iter_mut().zip(opened).for_each(|(most, of)| *most = most.max(of.widest));
                }
                row.extend(each);
            }
        }
        self.table.write(&row, memory)
    }
}
