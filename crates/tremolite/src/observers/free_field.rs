//! free_field.csv: columns of ground against one-dimensional theory, and the model itself beside them. Is the motion that comes
//! out the one that was put in?
//!
//! For each column the velocity at its top and base is written as it was computed, and as theory has it for its layers
//! ([`LayeredColumn`]): exact in frequency with all damping but artificial viscosity. There is none where an interface runs through the
//! column, and none any more from the row on in which its rock has yielded or cracked; beside the surface of ground that can yield stands
//! an equivalent-linear column, of the one column that stands for the free field ([`yielding`]). `model.xmin-ymin` …
//! are the model itself at the upper and lower ends of its four vertical edges, the places farthest from what it holds;
//! `model.surface` and `model.base` are the means over the four, which no single column need have: errors of opposite sign
//! cancel in them, and unlike ground stands apart from them. `A.free_field` is the free field at the level of the monitor A, with
//! which that compares: in the column that stands for the corner of the model nearest to it.

mod columns;
mod given;
pub mod levels;
mod seen;
mod yielding;

pub use given::AtCorners;
pub use seen::{ColumnSeen, FreeFieldSeen, Theory};
pub use yielding::{NoColumn, YieldingSeen};

use super::RunTable;
use super::observer::{Event, Observer, Setting, Stepped, View, Wants, Which};
use crate::error::RunError;
use crate::layered_column::{Layer, LayeredColumn};
use crate::plan::{Monitor, Plan};
use crate::quantities::MEASURES;
use columns::{ENDS, Watched, edges, watched};
use levels::Height;
pub use seen::most;
use std::ops::Range;
use tremolite_engine::column::{Column as Ground, corner_name};
use tremolite_engine::model::Model;
use tremolite_engine::state::Memory;
use tremolite_laws::parameter::position;
use tremolite_results::{Column, Subject};
use yielding::Yielding;

/// Compares and writes velocities at the rows of the histories.
pub struct FreeField {
    wants: Wants,
    table: RunTable,
    /// Behind the time.
    cells: Vec<Cell>,
    columns: Vec<Watched>,
    /// Of each column, which of the predictions.
    theory: Vec<Option<usize>>,
    /// Of columns of unlike ground.
    predictions: Vec<Predicted>,
    /// Beside ground that can yield.
    yielding: Option<Yielding>,
    /// Engine nodes of the model itself, by [`ENDS`] and corner.
    edges: [[usize; 4]; 2],
    /// The free field at the level of each monitor, and of the place of a record; empty without columns.
    beside: Vec<(Subject, Height)>,
}

/// What theory says of a column.
struct Predicted {
    /// Along x, y, z.
    columns: [LayeredColumn; 3],
    /// Velocity \[m/s\] along x, y, z, by [`ENDS`], every `dt` \[s\].
    velocity: [[Vec<f64>; 2]; 3],
    dt: f64,
    /// Its largest value over the run \[m/s\].
    peak: f64,
}

/// Samples of the prediction between two of the motion: between them it is linear.
pub const REFINEMENT: f64 = 8.0;
const AXES: [&str; 3] = ["x", "y", "z"];
/// Behind a velocity of the equivalent-linear column.
const EQUIVALENT: &str = "_equivalent";

impl FreeField {
    /// The observer, if a wave comes in.
    ///
    /// # Errors
    /// If the file cannot be written, or is shorter than the state remembers.
    pub fn new(setting: &Setting) -> Result<Option<Self>, RunError> {
        let model = setting.model;
        if model.boundaries.incident.is_none() {
            return Ok(None);
        }
        let columns = watched(model);
        let mut predictions: Vec<Predicted> = Vec::new();
        let theory: Vec<Option<usize>> = model
            .outside
            .columns
            .iter()
            .map(|column| {
                let layered = layered(model, column)?;
                let known = predictions.iter().position(|known| known.columns == layered);
                known.or_else(|| {
                    predictions.push(Predicted::of(setting, layered)?);
                    Some(predictions.len() - 1)
                })
            })
            .collect();
        let monitors = setting.plan.monitors.iter();
        let of_monitor =
            |monitor: &Monitor| Some((Subject::Monitor(monitor.name.clone()), height(model, monitor)?));
        let mut beside: Vec<(Subject, Height)> = monitors.filter_map(of_monitor).collect();
        // A file has no two columns of one name.
        let record = super::recorded::place(model, setting.plan)
            .filter(|_| beside.iter().all(|(of, _)| of.name() != Subject::Record.name()));
        beside.extend(record.map(|height| (Subject::Record, height)));
        let yielding = Yielding::of(setting);
        let softened = yielding.as_ref().filter(|of| of.found.is_ok()).map(|of| of.column);
        let cells = cells(&columns, &theory, softened, &beside);
        let of_cells = cells.iter().map(|cell| cell.column.clone());
        let header: Vec<Column> = std::iter::once(Column::new("time", "s")).chain(of_cells).collect();
        let table = RunTable::new(&setting.folder.free_field(), &header, setting.memory)?;
        let edges = edges(model, &columns);
        let ends = || columns.iter().flat_map(|column: &Watched| column.ends);
        let corners = columns.iter().flat_map(|column| column.corners.iter().flatten().copied());
        let heights = beside.iter().flat_map(|(_, height)| height.nodes());
        let bodies = |patch: usize| columns.iter().any(|c| c.bodies.contains(&model.patches[patch].body));
        let wants = Wants {
            nodes: Which::some(ends().chain(edges.iter().flatten().copied()).chain(heights)),
            members: Which::members(setting.assembly, |kind| kind.patch().is_some_and(bodies)),
            steps: Which::some(ends().chain(corners)),
            ..Wants::looks(setting.rows())
        };
        Ok(Some(FreeField { wants, table, cells, columns, theory, predictions, yielding, edges, beside }))
    }
}

/// The free field at the level of a monitor, in the column nearest to it.
fn height(model: &Model, monitor: &Monitor) -> Option<Height> {
    let [x, y, z] = levels::place(model, &monitor.location);
    let (column, _) = levels::nearest(model, [x, y])?;
    Height::of(&levels::levels(model, &model.outside.columns[column]), z)
}

/// Which of the model's columns stands for the free field as a whole, and at which corner: that nearest to the middle of the
/// monitors, the first without any.
pub fn chosen(model: &Model, plan: &Plan) -> Option<(usize, usize)> {
    let places: Vec<[f64; 3]> = plan.monitors.iter().map(|m| levels::place(model, &m.location)).collect();
    let (low, high) = model.faces.bounds;
    let mean = |i: usize| match places.len() {
        0 => 0.5 * (low[i] + high[i]),
        count => places.iter().map(|at| at[i]).sum::<f64>() / count as f64,
    };
    levels::nearest(model, [mean(0), mean(1)])
}

/// A column of free_field.csv, and whose velocity along which axis stands in it.
struct Cell {
    column: Column,
    whose: Whose,
    axis: usize,
}

/// Whose velocity, by number; ends as in [`ENDS`].
#[derive(Clone, Copy)]
enum Whose {
    Column {
        column: usize,
        end: usize,
    },
    Theory {
        column: usize,
        end: usize,
    },
    /// Of the surface of the equivalent-linear column.
    Softened,
    Mean {
        end: usize,
    },
    Edge {
        corner: usize,
        end: usize,
    },
    Beside(usize),
}

/// The cells of free_field.csv behind the time.
fn cells(
    columns: &[Watched],
    theory: &[Option<usize>],
    softened: Option<usize>,
    beside: &[(Subject, Height)],
) -> Vec<Cell> {
    let mut cells = Vec::new();
    let mut add = |subject: &Subject, place: &str, behind: &str, axis: usize, whose: Whose| {
        let quantity = format!("{place}.v{}{behind}", AXES[axis]);
        cells.push(Cell { column: Column::of(subject.clone(), quantity, "m/s"), whose, axis });
    };
    for (column, (watched, theory)) in columns.iter().zip(theory).enumerate() {
        let subject = Subject::Column(watched.name.clone());
        for (end, place) in ENDS.into_iter().enumerate() {
            for axis in 0..AXES.len() {
                add(&subject, place, "", axis, Whose::Column { column, end });
                if theory.is_some() {
                    add(&subject, place, "_theory", axis, Whose::Theory { column, end });
                }
                if softened == Some(column) && end == 0 && axis < 2 {
                    add(&subject, place, EQUIVALENT, axis, Whose::Softened);
                }
            }
        }
    }
    let means = (Subject::Model, [0, 1].map(|end| Whose::Mean { end }));
    let edges = (0..4)
        .map(|corner| (Subject::Edge(corner_name(corner)), [0, 1].map(|end| Whose::Edge { corner, end })));
    for (subject, ends) in std::iter::once(means).chain(edges) {
        for (place, whose) in ["surface", "base"].into_iter().zip(ends) {
            (0..AXES.len()).for_each(|axis| add(&subject, place, "", axis, whose));
        }
    }
    for (k, (subject, _)) in beside.iter().enumerate() {
        (0..AXES.len()).for_each(|axis| add(subject, "free_field", "", axis, Whose::Beside(k)));
    }
    cells
}

/// A column's layers as waves along x, y and z see them; none where an interface parts it.
pub fn layered(model: &Model, column: &Ground) -> Option<[LayeredColumn; 3]> {
    let along = |axis: usize| {
        let layers = column.layers.iter().map(|layer| {
            let (body, thickness) = (&model.bodies[layer.body], layer.top - layer.bottom);
            Layer::of(body, layer.element, &model.water, thickness, axis, model.scheme.rayleigh)
        });
        LayeredColumn::new(layers, model.boundaries.top)
    };
    if column.parted {
        return None;
    }
    Some([along(0)?, along(1)?, along(2)?])
}

impl Predicted {
    /// None for a wave that is zero.
    fn of(setting: &Setting, columns: [LayeredColumn; 3]) -> Option<Self> {
        let incident = setting.model.boundaries.incident.as_ref()?;
        let dt = incident.motion.dt / REFINEMENT;
        let velocity = [0, 1, 2].map(|i| {
            let wave = |t| incident.factor * incident.motion.at(t).v[i];
            columns[i].velocities(wave, dt, setting.plan.duration)
        });
        let peak = velocity.iter().flatten().flatten().fold(0.0_f64, |most, v| most.max(v.abs()));
        (peak > 0.0).then_some(Predicted { columns, velocity, dt, peak })
    }

    /// Velocity \[m/s\] along an axis at one of [`ENDS`].
    fn at(&self, axis: usize, end: usize, time: f64) -> f64 {
        linear(&self.velocity[axis][end], time / self.dt)
    }
}

/// Between values, linear; 0 beyond them.
fn linear(values: &[f64], place: f64) -> f64 {
    let (before, part) = (place as usize, place.fract());
    let of = |i: usize| values.get(i).copied().unwrap_or(0.0);
    (1.0 - part) * of(before) + part * of(before + 1)
}

/// Whether the material of some bodies has yielded or cracked anywhere.
fn is_damaged(view: &View, bodies: &Range<usize>) -> bool {
    let View { model, assembly, history, .. } = *view;
    let patches = assembly.of_patch.iter().zip(&model.patches);
    patches.filter(|(_, patch)| bodies.contains(&patch.body)).any(|(&member, _)| {
        let columns = assembly.members[member as usize].part.columns();
        let own = &history.octets[assembly.slices[member as usize].history.clone()];
        MEASURES.iter().any(|measure| {
            position(columns, measure.role).is_some_and(|at| {
                own.iter()
                    .skip(at)
                    .step_by(columns.len())
                    .any(|octet| octet.0.iter().any(|x| *x > measure.onset))
            })
        })
    })
}

impl Observer for FreeField {
    fn wants(&self) -> Wants {
        self.wants.clone()
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        match event {
            Event::Look(view) => self.see(view, memory),
            Event::Step(step) => {
                self.stepped(step, memory);
                Ok(())
            }
            _ => Ok(()),
        }
    }
}

impl FreeField {
    fn see(&mut self, view: &View, memory: &mut Memory) -> Result<(), RunError> {
        let names = || self.columns.iter().map(|column| column.name.clone());
        let mut seen = FreeFieldSeen::named(memory, names()).unwrap_or_else(|| FreeFieldSeen {
            columns: names().map(|name| ColumnSeen { name, ..ColumnSeen::default() }).collect(),
        });
        let velocity = |node: usize| view.snapshot.velocity[node].xyz();
        // By column, end and axis; not a number where the rock has yielded.
        let mut exact = vec![[[f64::NAN; 3]; 2]; self.columns.len()];
        let of_columns = self.columns.iter().zip(&self.theory).zip(&mut seen.columns).zip(&mut exact);
        for (((column, theory), seen), exact) in of_columns {
            seen.damaged |= is_damaged(view, &column.bodies);
            let Some(predicted) = theory.map(|k| &self.predictions[k]) else { continue };
            let theory = seen.theory.get_or_insert(Theory { peak: predicted.peak, ..Theory::default() });
            if seen.damaged {
                continue;
            }
            for (end, node) in column.ends.into_iter().enumerate() {
                for (axis, found) in velocity(node).into_iter().enumerate() {
                    let value = predicted.at(axis, end, view.snapshot.time);
                    exact[end][axis] = value;
                    theory.difference[end] = most(theory.difference[end], (found - value).abs());
                    theory.seen = theory.seen.max(value.abs());
                }
            }
        }
        let softened = self.yielding.as_ref().and_then(|of| {
            let surface = velocity(self.columns[of.column].ends[0]);
            of.see(memory, view.snapshot.time, surface);
            of.at(view.snapshot.time)
        });
        let value = |cell: &Cell| match cell.whose {
            Whose::Softened => softened.map_or(f64::NAN, |of| of[cell.axis]),
            Whose::Column { column, end } => velocity(self.columns[column].ends[end])[cell.axis],
            Whose::Theory { column, end } => exact[column][end][cell.axis],
            Whose::Mean { end } => {
                self.edges[end].iter().map(|&node| velocity(node)[cell.axis]).sum::<f64>() / 4.0
            }
            Whose::Edge { corner, end } => velocity(self.edges[end][corner])[cell.axis],
            Whose::Beside(k) => self.beside[k].1.at(&view.snapshot.velocity)[cell.axis],
        };
        let mut row = vec![view.snapshot.time];
        row.extend(self.cells.iter().map(value));
        self.table.write(&row, memory)?;
        seen.keep(memory);
        Ok(())
    }

    /// The corners in every step: rows may be too few to show the wave.
    fn stepped(&mut self, step: &Stepped, memory: &mut Memory) {
        let velocity = |node: usize| step.du[node].xyz().map(|d| d / step.dt);
        for (column, [surface, base, peak]) in self.columns.iter().zip(FreeFieldSeen::every_step(memory)) {
            for ((end, corners), difference) in
                column.ends.into_iter().zip(&column.corners).zip([surface, base])
            {
                let free = velocity(end);
                for i in 0..3 {
                    *peak = peak.max(free[i].abs());
                    for &corner in corners {
                        *difference = most(*difference, (velocity(corner)[i] - free[i]).abs());
                    }
                }
            }
        }
    }
}
