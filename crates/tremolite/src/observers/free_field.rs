//! free_field.csv: columns of ground against one-dimensional theory, and the model itself beside them. Is the motion that comes
//! out the one that was put in?
//!
//! For each column the velocity at its top and base is written as it was computed, and as theory has it for its layers
//! ([`LayeredColumn`]): exact in frequency with all damping but artificial viscosity. There is none where an interface runs through the
//! column, and none any more from the row on in which its rock has yielded or cracked. `model.xmin-ymin` …
//! are the model itself at the upper and lower ends of its four vertical edges, the places farthest from what it holds;
//! `model.surface` and `model.base` are the means over the four, which no single column need have: errors of opposite sign
//! cancel in them, and unlike ground stands apart from them. `A.free_field` is the free field at the level of the monitor A, with
//! which that compares: in the column that stands for the corner of the model nearest to it.

mod columns;
pub mod levels;
mod seen;

pub use seen::{ColumnSeen, FreeFieldSeen, Theory};

use super::{Observer, Schedule, Setting, Stepped, View};
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
use tremolite_results::{Column, TableWriter};

/// Compares and writes velocities at the rows of the histories.
pub struct FreeField {
    schedule: Schedule,
    table: TableWriter,
    columns: Vec<Watched>,
    /// Of each column, which of the predictions.
    theory: Vec<Option<usize>>,
    /// Of columns of unlike ground.
    predictions: Vec<Predicted>,
    /// Engine nodes of the model itself, by [`ENDS`] and corner.
    edges: [[usize; 4]; 2],
    /// The free field at the level of each monitor; empty without columns.
    beside: Vec<(String, Height)>,
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

/// What stands for the place of a record that was deconvolved, as if it were a monitor.
const RECORD: &str = "record";
/// Samples of the prediction between two of the motion: between them it is linear.
pub const REFINEMENT: f64 = 8.0;
const AXES: [&str; 3] = ["x", "y", "z"];

impl FreeField {
    /// The observer, if a wave comes in.
    ///
    /// # Errors
    /// If the file cannot be written, or is shorter than the state remembers.
    pub fn new(setting: &Setting) -> Result<Option<Self>, RunError> {
        let model = setting.model;
        if model.incident.is_none() {
            return Ok(None);
        }
        let columns = watched(model);
        let mut predictions: Vec<Predicted> = Vec::new();
        let theory: Vec<Option<usize>> = model
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
        let named = |monitor: &Monitor| Some((monitor.name.clone(), height(model, monitor)?));
        let mut beside: Vec<(String, Height)> = setting.plan.monitors.iter().filter_map(named).collect();
        // A file has no two columns of one name.
        let record = super::recorded::place(model, setting.plan)
            .filter(|_| beside.iter().all(|(monitor, _)| monitor != RECORD));
        beside.extend(record.map(|height| (RECORD.to_owned(), height)));
        let (path, header) = (setting.folder.free_field(), header(&columns, &theory, &beside));
        let names = columns.iter().map(|column| column.name.clone());
        let table = match FreeFieldSeen::named(setting.memory, names) {
            Some(seen) => TableWriter::resume(&path, &header, seen.bytes)?,
            None => TableWriter::create(&path, &header)?,
        };
        let edges = edges(model, &columns);
        Ok(Some(FreeField { schedule: setting.rows(), table, columns, theory, predictions, edges, beside }))
    }
}

/// The free field at the level of a monitor, in the column nearest to it.
fn height(model: &Model, monitor: &Monitor) -> Option<Height> {
    let [x, y, z] = levels::place(model, &monitor.location);
    let (column, _) = levels::nearest(model, [x, y])?;
    Height::of(&levels::levels(model, &model.columns[column]), z)
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

/// The columns of free_field.csv.
fn header(columns: &[Watched], theory: &[Option<usize>], beside: &[(String, Height)]) -> Vec<Column> {
    let mut header = vec![Column::new("time", "s")];
    for (column, theory) in columns.iter().zip(theory) {
        for end in ENDS {
            for axis in AXES {
                header.push(Column::new(format!("{}.{end}.v{axis}", column.name), "m/s"));
                if theory.is_some() {
                    header.push(Column::new(format!("{}.{end}.v{axis}_theory", column.name), "m/s"));
                }
            }
        }
    }
    let corners = (0..4).map(|corner| format!("model.{}", corner_name(corner)));
    for place in std::iter::once("model".to_owned()).chain(corners) {
        for end in ["surface", "base"] {
            header.extend(AXES.map(|axis| Column::new(format!("{place}.{end}.v{axis}"), "m/s")));
        }
    }
    for (monitor, _) in beside {
        header.extend(AXES.map(|axis| Column::new(format!("{monitor}.free_field.v{axis}"), "m/s")));
    }
    header
}

/// A column's layers as waves along x, y and z see them; none where an interface parts it.
pub fn layered(model: &Model, column: &Ground) -> Option<[LayeredColumn; 3]> {
    let along = |axis: usize| {
        let layers = column.layers.iter().map(|layer| {
            Layer::of(&model.bodies[layer.body], layer.top - layer.bottom, axis, model.rayleigh)
        });
        LayeredColumn::new(layers, model.top)
    };
    if column.parted {
        return None;
    }
    Some([along(0)?, along(1)?, along(2)?])
}

impl Predicted {
    /// None for a wave that is zero.
    fn of(setting: &Setting, columns: [LayeredColumn; 3]) -> Option<Self> {
        let incident = setting.model.incident.as_ref()?;
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
        let place = time / self.dt;
        let (before, part) = (place as usize, place.fract());
        let of = |i: usize| self.velocity[axis][end].get(i).copied().unwrap_or(0.0);
        (1.0 - part) * of(before) + part * of(before + 1)
    }
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
    fn schedule(&self) -> Schedule {
        self.schedule
    }

    fn see(&mut self, view: &View, memory: &mut Memory) -> Result<(), RunError> {
        let names = || self.columns.iter().map(|column| column.name.clone());
        let mut seen = FreeFieldSeen::named(memory, names()).unwrap_or_else(|| FreeFieldSeen {
            bytes: 0,
            columns: names().map(|name| ColumnSeen { name, ..ColumnSeen::default() }).collect(),
        });
        let velocity = |node: usize| view.snapshot.velocity[node].xyz();
        let mut row = vec![view.snapshot.time];
        for ((column, theory), seen) in self.columns.iter().zip(&self.theory).zip(&mut seen.columns) {
            seen.damaged |= is_damaged(view, &column.bodies);
            let predicted = theory.map(|k| &self.predictions[k]);
            if let Some(predicted) = predicted {
                seen.theory.get_or_insert(Theory { peak: predicted.peak, ..Theory::default() });
            }
            for (end, node) in column.ends.into_iter().enumerate() {
                for (axis, found) in velocity(node).into_iter().enumerate() {
                    row.push(found);
                    let (Some(predicted), Some(theory)) = (predicted, &mut seen.theory) else { continue };
                    if seen.damaged {
                        row.push(f64::NAN);
                        continue;
                    }
                    let exact = predicted.at(axis, end, view.snapshot.time);
                    row.push(exact);
                    theory.difference[end] = most(theory.difference[end], (found - exact).abs());
                    theory.seen = theory.seen.max(exact.abs());
                }
            }
        }
        for nodes in &self.edges {
            let mean = |i: usize| nodes.iter().map(|&node| velocity(node)[i]).sum::<f64>() / 4.0;
            row.extend([0, 1, 2].map(mean));
        }
        for corner in 0..4 {
            row.extend(self.edges.iter().flat_map(|nodes| velocity(nodes[corner])));
        }
        row.extend(self.beside.iter().flat_map(|(_, height)| height.at(&view.snapshot.velocity)));
        self.table.write(&row)?;
        seen.bytes = self.table.bytes_written();
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
