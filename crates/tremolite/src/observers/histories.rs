//! monitors.csv: histories of points, and of pairs of them.
//!
//! Acceleration is that between rows: one step's value out of many would be a sample of what rings far above the rows' own
//! Nyquist frequency, and alias.

use super::{Observer, Schedule, Setting, View};
use crate::error::RunError;
use crate::plan::{Monitor, PairMonitor, Plan};
use crate::quantities::{MONITOR, PAIR, RELATIVE, nearest_stress, stress_at};
use tremolite_engine::model::Model;
use tremolite_engine::state::Memory;
use tremolite_laws::Row;
use tremolite_laws::sym3::principal_values;
use tremolite_mesh::Shape;
use tremolite_results::{Column, TableWriter};

/// Key of what this observer remembers: the bytes written, the time of the last row \[s\] and the monitors' velocities
/// there \[m/s\].
const MEMORY: &str = "histories";

/// Writes a row for all monitors.
pub struct Histories {
    schedule: Schedule,
    table: TableWriter,
    /// Interface and pair of each of the plan's.
    pairs: Vec<(usize, usize)>,
}

/// The columns of monitors.csv.
pub fn columns(plan: &Plan) -> Vec<Column> {
    let mut columns = vec![Column::new("time", "s")];
    for monitor in &plan.monitors {
        columns.extend(MONITOR.iter().map(|q| Column::new(format!("{}.{}", monitor.name, q.name), q.unit)));
    }
    for [a, b] in &plan.relatives {
        let pair = format!("{}-{}", plan.monitors[*a].name, plan.monitors[*b].name);
        columns.extend(RELATIVE.iter().map(|q| Column::new(format!("{pair}.{}", q.name), q.unit)));
    }
    for pair in &plan.pairs {
        columns.extend(PAIR.iter().map(|q| Column::new(format!("{}.{}", pair.name, q.name), q.unit)));
    }
    columns
}

impl Histories {
    /// Starts the table, or goes on with it where the state left it.
    ///
    /// # Errors
    /// If the file cannot be written, or is shorter than the state remembers.
    pub fn new(setting: &Setting) -> Result<Self, RunError> {
        let (path, columns) = (setting.folder.monitors(), columns(setting.plan));
        let table = match setting.memory.get(MEMORY) {
            Some(memory) => TableWriter::resume(&path, &columns, memory[0] as u64)?,
            None => TableWriter::create(&path, &columns)?,
        };
        let nearest = |pair: &PairMonitor| {
            (pair.interface, setting.model.seams[pair.interface].nearest(&setting.model.mesh, pair.point))
        };
        let pairs = setting.plan.pairs.iter().map(nearest).collect();
        Ok(Histories { schedule: setting.rows(), table, pairs })
    }
}

/// A nodal field at a monitor: the shape functions' values times the corners' rows.
pub(super) fn interpolate(model: &Model, monitor: &Monitor, rows: &[Row]) -> [f64; 3] {
    let nodes = model.mesh.elements[monitor.location.element as usize].nodes();
    let mut sum = [0.0; 3];
    for (&node, weight) in nodes.iter().zip(monitor.location.weights) {
        let row = rows[model.engine_node[node as usize] as usize];
        for i in 0..3 {
            sum[i] += weight * row.0[i];
        }
    }
    sum
}

/// Stress at a monitor \[Pa\].
fn stress(view: &View, monitor: &Monitor) -> [f64; 6] {
    let View { model, phase, snapshot, history, .. } = *view;
    let element = monitor.location.element as usize;
    // The natural coordinates of other shapes are not those of the collapsed hexahedron.
    let natural = match model.mesh.elements[element].shape {
        Shape::Hex8 => monitor.location.natural,
        _ => [0.0; 3],
    };
    phase.element_slot[element].map_or([f64::NAN; 6], |slot| {
        let first = slot.point as usize;
        let points = &snapshot.stress[first..first + slot.points as usize];
        if history.is_damaged(&slot) { nearest_stress(points, natural) } else { stress_at(points, natural) }
    })
}

impl Observer for Histories {
    fn schedule(&self) -> Schedule {
        self.schedule
    }

    fn see(&mut self, view: &View, memory: &mut Memory) -> Result<(), RunError> {
        let View { model, assembly, plan, snapshot, history, .. } = *view;
        let last = memory.get(MEMORY).cloned();
        let mut kept = vec![0.0, snapshot.time];
        let mut row = vec![snapshot.time];
        let mut displacements = Vec::with_capacity(plan.monitors.len());
        for (k, monitor) in plan.monitors.iter().enumerate() {
            let u = interpolate(model, monitor, &snapshot.displacement);
            let v = interpolate(model, monitor, &snapshot.velocity);
            displacements.push(u);
            row.extend(u);
            row.extend(v);
            row.extend([0, 1, 2].map(|i| match &last {
                Some(last) => (v[i] - last[2 + 3 * k + i]) / (snapshot.time - last[1]),
                None => 0.0,
            }));
            kept.extend(v);
            let stress = stress(view, monitor);
            row.extend(stress);
            row.extend(principal_values(&stress));
        }
        for [a, b] in &plan.relatives {
            let d = [0, 1, 2].map(|i| displacements[*a][i] - displacements[*b][i]);
            row.extend(d);
            row.push((d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt());
        }
        for (pair, &(seam, nearest)) in plan.pairs.iter().zip(&self.pairs) {
            debug_assert_eq!(pair.interface, seam);
            let seen = assembly.contacts[seam].seen(history.octets, nearest);
            let [slip1, slip2] = seen.slip;
            let [shear1, shear2] = seen.shear.map(|t| -t);
            row.extend([seen.gap, slip1, slip2, seen.pressure, shear1, shear2, f64::from(seen.state)]);
        }
        self.table.write(&row)?;
        kept[0] = self.table.bytes_written() as f64;
        memory.insert(MEMORY.into(), kept);
        Ok(())
    }
}
