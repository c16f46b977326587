//! monitors.csv: histories of points, and of pairs of them.
//!
//! Acceleration is that between rows: one step's value out of many would be a sample of what rings far above the rows' own
//! Nyquist frequency, and alias.

use super::{Observer, Schedule, Setting, View};
use crate::error::RunError;
use crate::plan::{BoltMonitor, Monitor, PairMonitor, Plan};
use crate::point_stress::{nearest_stress, stress_at};
use crate::quantities::{BOLT, MONITOR, PAIR, RELATIVE};
use crate::support::{look, over_yield};
use tremolite_engine::hexahedra::{hex, hex_nodes};
use tremolite_engine::model::Model;
use tremolite_engine::state::{Memory, State};
use tremolite_kernels::contact::PairSeen;
use tremolite_kernels::{Points, Quadrature};
use tremolite_laws::Row;
use tremolite_laws::shapes::hex8::elastic_stress;
use tremolite_laws::sym3::principal_values;
use tremolite_mesh::Shape;
use tremolite_results::{Column, TableWriter};

/// Key of what this observer remembers: the bytes written, the time of the last row \[s\], the monitors' velocities there \[m/s\]
/// and their stresses in the first row \[Pa\].
const MEMORY: &str = "histories";

/// Writes a row for all monitors.
pub struct Histories {
    schedule: Schedule,
    table: TableWriter,
    /// Interface and pair of each of the plan's.
    pairs: Vec<(usize, usize)>,
    /// Bolt and segment of each of the plan's; none where its group has no bolt.
    bolts: Vec<Option<(usize, usize)>>,
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
    for bolt in &plan.bolts {
        columns.extend(BOLT.iter().map(|q| Column::new(format!("{}.{}", bolt.name, q.name), q.unit)));
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
        let bolts = setting.plan.bolts.iter().map(|bolt| segment(setting.model, bolt)).collect();
        Ok(Histories { schedule: setting.rows(), table, pairs, bolts })
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

/// A row of all columns but the time for a model at rest before the shaking: displacements since the initial equilibrium, of
/// elements that begin with a stage since then; not a number where nothing stands.
pub fn at_rest(view: &View, state: &State) -> Vec<f64> {
    let View { model, assembly, phase, plan, history, .. } = *view;
    let mut row = Vec::new();
    let mut displacements = Vec::with_capacity(plan.monitors.len());
    for monitor in &plan.monitors {
        let standing = model.standing_at(monitor.location.element as usize, phase.stage);
        let slot = standing.and_then(|element| Some((element, phase.element_slot[element]?)));
        let Some((element, slot)) = slot else {
            displacements.push([f64::NAN; 3]);
            row.extend([f64::NAN; MONITOR.len()]);
            continue;
        };
        let member = &assembly.members[slot.member as usize];
        // What takes over from another material does not begin anew.
        let takes_over = model.patches[slot.patch as usize].takes_over;
        let reference = &state.reference[assembly.slices[slot.member as usize].reference.clone()];
        let mut u = [0.0; 3];
        for (&node, weight) in model.mesh.elements[element].nodes().iter().zip(monitor.location.weights) {
            let node = model.engine_node[node as usize];
            let mut own = state.shown(node as usize).xyz();
            if !reference.is_empty() && !takes_over {
                let place = member.part.nodes().iter().position(|n| *n == node);
                let zero = place.map_or([0.0; 3], |k| reference[k].xyz());
                own = [0, 1, 2].map(|i| state.u[node as usize].0[i] - zero[i]);
            }
            (0..3).for_each(|i| u[i] += weight * own[i]);
        }
        displacements.push(u);
        row.extend(u);
        // Velocity and acceleration.
        row.extend([0.0; 6]);
        let stress = stress(view, monitor, element);
        row.extend(stress);
        row.extend(principal_values(&stress));
        row.push(principal_values(&stress)[0]);
    }
    row.extend(differences(plan, &displacements));
    for pair in &plan.pairs {
        let seam = &model.seams[pair.interface];
        let nearest = seam.nearest(&model.mesh, pair.point);
        if seam.lives[nearest].holds(phase.stage) {
            row.extend(of_pair(assembly.contacts[pair.interface].seen(history.octets, nearest)));
        } else {
            row.extend([f64::NAN; PAIR.len()]);
        }
    }
    for monitor in &plan.bolts {
        row.extend(of_bolt(view, monitor, segment(model, monitor)));
    }
    row
}

/// The bolt and the segment that a monitor looks at.
fn segment(model: &Model, monitor: &BoltMonitor) -> Option<(usize, usize)> {
    model.bolts[monitor.set].nearest(monitor.point)
}

/// The columns of a segment; not a number where none is placed yet.
fn of_bolt(view: &View, monitor: &BoltMonitor, segment: Option<(usize, usize)>) -> [f64; BOLT.len()] {
    let placed = view.model.bolts[monitor.set].kind.born <= view.phase.stage;
    let seen = segment.filter(|_| placed).and_then(|(bolt, segment)| {
        look(view.assembly, view.numbers)(monitor.set, bolt).get(segment).copied()
    });
    seen.map_or([f64::NAN; BOLT.len()], |seen| {
        [seen.force, over_yield(seen.force, &seen), seen.slip, f64::from(seen.state as u8)]
    })
}

/// The columns of pairs of monitors.
fn differences(plan: &Plan, displacements: &[[f64; 3]]) -> Vec<f64> {
    let of = |[a, b]: &[usize; 2]| {
        let d = [0, 1, 2].map(|i| displacements[*a][i] - displacements[*b][i]);
        [d[0], d[1], d[2], (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt()]
    };
    plan.relatives.iter().flat_map(of).collect()
}

/// The columns of a pair.
fn of_pair(seen: PairSeen) -> [f64; 7] {
    let ([slip1, slip2], [shear1, shear2]) = (seen.slip, seen.shear.map(|t| -t));
    [seen.gap, slip1, slip2, seen.pressure, shear1, shear2, f64::from(seen.state)]
}

/// A monitor's natural coordinates in an element as a hexahedron: those of other shapes are not the collapsed one's.
fn natural(model: &Model, monitor: &Monitor, element: usize) -> [f64; 3] {
    match model.mesh.elements[element].shape {
        Shape::Hex8 => monitor.location.natural,
        _ => [0.0; 3],
    }
}

/// C:Δε at a monitor \[Pa\], with the strain since the start of shaking: displacements \[m\] by engine node since then.
pub(super) fn elastic_change(
    model: &Model,
    monitor: &Monitor,
    displacement: impl Fn(usize) -> [f64; 3],
) -> [f64; 6] {
    let element = monitor.location.element as usize;
    let Some(body) = model.body_of.get(element).copied().flatten().map(|b| &model.bodies[b]) else {
        return [f64::NAN; 6];
    };
    let nodes = hex_nodes(&model.mesh, element).map(|n| model.engine_node[n as usize] as usize);
    let Ok(hex) = hex(&model.mesh, element) else { return [f64::NAN; 6] };
    let stress = elastic_stress(&hex, body.material.relaxed(), body.quadrature, &nodes.map(displacement));
    let quadrature = if stress.len() == 1 { Quadrature::OnePoint } else { Quadrature::Full };
    stress_at(&Points { quadrature, axis: 0 }, &stress, natural(model, monitor, element))
}

/// Stress of the first row at the monitor of this number \[Pa\]; none before that row.
pub(super) fn first_stress(memory: &Memory, plan: &Plan, monitor: usize) -> Option<[f64; 6]> {
    let first = 2 + 3 * plan.monitors.len();
    memory.get(MEMORY)?[first..].as_chunks::<6>().0.get(monitor).copied()
}

/// Stress at a monitor \[Pa\], in what stands there.
fn stress(view: &View, monitor: &Monitor, element: usize) -> [f64; 6] {
    let View { model, phase, snapshot, history, .. } = *view;
    let natural = natural(model, monitor, element);
    phase.element_slot[element].map_or([f64::NAN; 6], |slot| {
        let first = slot.point as usize;
        let points = &snapshot.stress[first..first + slot.points as usize];
        match history.is_damaged(&slot) {
            true => nearest_stress(&slot.places, points, natural),
            false => stress_at(&slot.places, points, natural),
        }
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
        let mut first = Vec::with_capacity(6 * plan.monitors.len());
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
            let stress = stress(view, monitor, monitor.location.element as usize);
            row.extend(stress);
            row.extend(principal_values(&stress));
            let start = match &last {
                Some(last) => [0, 1, 2, 3, 4, 5].map(|c| last[2 + 3 * plan.monitors.len() + 6 * k + c]),
                None => stress,
            };
            first.extend(start);
            let change = elastic_change(model, monitor, |n| snapshot.displacement[n].xyz());
            row.push(principal_values(&[0, 1, 2, 3, 4, 5].map(|c| start[c] + change[c]))[0]);
        }
        kept.extend(first);
        row.extend(differences(plan, &displacements));
        for (pair, &(seam, nearest)) in plan.pairs.iter().zip(&self.pairs) {
            debug_assert_eq!(pair.interface, seam);
            row.extend(of_pair(assembly.contacts[seam].seen(history.octets, nearest)));
        }
        for (monitor, segment) in plan.bolts.iter().zip(&self.bolts) {
            row.extend(of_bolt(view, monitor, *segment));
        }
        self.table.write(&row)?;
        kept[0] = self.table.bytes_written() as f64;
        memory.insert(MEMORY.into(), kept);
        Ok(())
    }
}
