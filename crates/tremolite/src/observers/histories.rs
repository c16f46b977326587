//! monitors.csv: histories of points, and of pairs of them; and what the same monitors see at the end of a stage.
//!
//! Acceleration is that between rows: one step's value out of many would be a sample of what rings far above the rows' own
//! Nyquist frequency, and alias.

use super::RunTable;
use super::observer::{Event, Observer, Schedule, Setting, StageSeen, View, Wants, Which};
use super::rows::{Cell, Seen, cells};
use crate::error::RunError;
use crate::plan::{BoltMonitor, Monitor, PairMonitor, Plan};
use crate::point_stress::{nearest_stress, stress_at};
use crate::quantities::{MonitorSeen, Moved};
use crate::support::look;
use tremolite_engine::assembly::Assembly;
use tremolite_engine::bolts::SegmentSeen;
use tremolite_engine::hexahedra::hex_nodes;
use tremolite_engine::member::Kind;
use tremolite_engine::model::Model;
use tremolite_engine::state::Memory;
use tremolite_kernels::contact::PairSeen;
use tremolite_kernels::{Points, Quadrature};
use tremolite_laws::Row;
use tremolite_laws::shapes::hex8::elastic_stress;
use tremolite_laws::sym3::principal_values;
use tremolite_mesh::Shape;
use tremolite_results::Column;

/// Key of what this observer remembers: the time of the last row \[s\], the monitors' velocities there \[m/s\]
/// and their stresses in the first row \[Pa\].
const MEMORY: &str = "histories";

/// Writes a row for all monitors.
pub struct Histories {
    schedule: Schedule,
    sees: Wants,
    table: RunTable,
    cells: Vec<Cell>,
    /// The pair of each monitor on an interface.
    pairs: Vec<usize>,
    /// Bolt and segment of each of the plan's; none where its group has no bolt.
    bolts: Vec<Option<(usize, usize)>>,
}

impl Histories {
    /// Starts the table, or goes on with it where the state left it.
    ///
    /// # Errors
    /// If the file cannot be written, or is not what the state remembers.
    pub fn new(setting: &Setting) -> Result<Self, RunError> {
        let cells = cells(setting.plan);
        let of_cells = cells.iter().map(|cell| cell.column.clone());
        let columns: Vec<Column> = std::iter::once(Column::new("time", "s")).chain(of_cells).collect();
        let table = RunTable::new(&setting.folder.monitors(), &columns, setting.memory)?;
        let pairs = setting.plan.pairs.iter().map(|pair| nearest(setting.model, pair)).collect();
        let bolts = setting.plan.bolts.iter().map(|bolt| segment(setting.model, bolt)).collect();
        let standing = |monitor: &Monitor| Some(monitor.location.element as usize);
        let sees = monitored(setting.model, setting.assembly, setting.plan, standing);
        Ok(Histories { schedule: setting.rows(), sees, table, cells, pairs, bolts })
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

/// What all monitors see, each of the element that stands where it is; none where nothing does.
pub(super) fn monitored(
    model: &Model,
    assembly: &Assembly,
    plan: &Plan,
    standing: impl Fn(&Monitor) -> Option<usize>,
) -> Wants {
    let elements: Vec<usize> = plan.monitors.iter().filter_map(standing).collect();
    let seen = |kind: Kind| match kind {
        Kind::Pairs(seam) => plan.pairs.iter().any(|pair| pair.interface == seam as usize),
        Kind::Bolts(set) => plan.bolts.iter().any(|bolt| bolt.set == set as usize),
        _ => false,
    };
    Wants {
        nodes: Which::corners(model, elements.iter().map(|&e| e as u32)),
        elements: Which::some(elements),
        members: Which::members(assembly, seen),
        ..Wants::default()
    }
}

/// What monitors see of a model at rest before the shaking: displacements since the initial equilibrium, of elements that begin
/// with a stage since then.
pub(super) fn at_rest(seen: &StageSeen) -> Seen {
    let view = &seen.view;
    let View { model, plan, .. } = *view;
    let of_bolt = |bolt: &BoltMonitor| segment_seen(view, bolt, segment(model, bolt));
    let of_pair = |pair: &PairMonitor| pair_seen(view, pair, nearest(model, pair));
    Seen {
        monitors: plan.monitors.iter().map(|monitor| still(seen, monitor)).collect(),
        pairs: plan.pairs.iter().map(of_pair).collect(),
        bolts: plan.bolts.iter().map(of_bolt).collect(),
    }
}

/// A monitor of a model at rest.
fn still(seen: &StageSeen, monitor: &Monitor) -> Option<MonitorSeen> {
    let view = &seen.view;
    let View { model, assembly, phase, snapshot, .. } = *view;
    let element = model.standing_at(monitor.location.element as usize, phase.stage)?;
    let slot = phase.element_slot[element]?;
    let member = &assembly.members[slot.member as usize];
    // What takes over from another material does not begin anew.
    let takes_over = model.patches[slot.patch as usize].takes_over;
    let reference = &seen.reference[assembly.slices[slot.member as usize].reference.clone()];
    let mut u = [0.0; 3];
    for (&node, weight) in model.mesh.elements[element].nodes().iter().zip(monitor.location.weights) {
        let node = model.engine_node[node as usize];
        let mut own = snapshot.displacement[node as usize].xyz();
        if !reference.is_empty() && !takes_over {
            let place = member.part.nodes().iter().position(|n| *n == node);
            let zero = place.map_or([0.0; 3], |k| reference[k].xyz());
            own = [0, 1, 2].map(|i| seen.u[node as usize].0[i] - zero[i]);
        }
        (0..3).for_each(|i| u[i] += weight * own[i]);
    }
    let stress = stress(view, monitor, element);
    let principal = principal_values(&stress);
    let moved = Moved { u, v: [0.0; 3], a: [0.0; 3], s1_elastic: principal[0] };
    Some(MonitorSeen { moved, stress, principal, pore: pore(view, element) })
}

/// The pair that a monitor looks at.
fn nearest(model: &Model, pair: &PairMonitor) -> usize {
    model.seams[pair.interface].nearest(&model.mesh, pair.point)
}

/// What a pair does; nothing where it is not there.
fn pair_seen(view: &View, pair: &PairMonitor, nearest: usize) -> Option<PairSeen> {
    let View { model, assembly, phase, history, .. } = *view;
    let there = model.seams[pair.interface].lives[nearest].holds(phase.stage);
    there.then(|| assembly.contacts[pair.interface].seen(history.octets, nearest))
}

/// The bolt and the segment that a monitor looks at.
fn segment(model: &Model, monitor: &BoltMonitor) -> Option<(usize, usize)> {
    model.bolts[monitor.set].nearest(monitor.point)
}

/// What a segment does; nothing where none is placed yet.
fn segment_seen(view: &View, monitor: &BoltMonitor, segment: Option<(usize, usize)>) -> Option<SegmentSeen> {
    let placed = view.model.bolts[monitor.set].kind.born <= view.phase.stage;
    let (bolt, segment) = segment.filter(|_| placed)?;
    look(view.assembly, view.numbers)(monitor.set, bolt).get(segment).copied()
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
    let Some(body) = model.elements.body_of.get(element).copied().flatten().map(|b| &model.bodies[b]) else {
        return [f64::NAN; 6];
    };
    let nodes = hex_nodes(&model.mesh, element).map(|n| model.engine_node[n as usize] as usize);
    let Ok(hex) = model.elements.shape(&model.mesh, element as u32) else { return [f64::NAN; 6] };
    let stress = elastic_stress(&hex, body.material.relaxed(), body.quadrature, &nodes.map(displacement));
    let quadrature = if stress.len() == 1 { Quadrature::OnePoint } else { Quadrature::Full };
    stress_at(&Points { quadrature, axis: 0 }, &stress, natural(model, monitor, element))
}

/// Stress of the first row at the monitor of this number \[Pa\]; none before that row.
pub(super) fn first_stress(memory: &Memory, plan: &Plan, monitor: usize) -> Option<[f64; 6]> {
    let first = 1 + 3 * plan.monitors.len();
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

/// Pressure in the pores of an element that stands \[Pa\].
fn pore(view: &View, element: usize) -> f64 {
    let slot = view.phase.element_slot[element];
    slot.and_then(|slot| view.snapshot.pore.get(slot.element as usize).copied()).unwrap_or(0.0)
}

impl Observer for Histories {
    fn wants(&self) -> Wants {
        Wants { looks: Some(self.schedule), ..self.sees.clone() }
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        match event {
            Event::Look(view) => self.see(view, memory),
            _ => Ok(()),
        }
    }
}

impl Histories {
    fn see(&mut self, view: &View, memory: &mut Memory) -> Result<(), RunError> {
        let View { model, plan, snapshot, .. } = *view;
        let last = memory.get(MEMORY).cloned();
        let mut kept = vec![snapshot.time];
        let mut seen = Seen::default();
        let mut first = Vec::with_capacity(6 * plan.monitors.len());
        for (k, monitor) in plan.monitors.iter().enumerate() {
            let u = interpolate(model, monitor, &snapshot.displacement);
            let v = interpolate(model, monitor, &snapshot.velocity);
            let a = [0, 1, 2].map(|i| match &last {
                Some(last) => (v[i] - last[1 + 3 * k + i]) / (snapshot.time - last[0]),
                None => 0.0,
            });
            kept.extend(v);
            let stress = stress(view, monitor, monitor.location.element as usize);
            let start = match &last {
                Some(last) => [0, 1, 2, 3, 4, 5].map(|c| last[1 + 3 * plan.monitors.len() + 6 * k + c]),
                None => stress,
            };
            first.extend(start);
            let change = elastic_change(model, monitor, |n| snapshot.displacement[n].xyz());
            let s1_elastic = principal_values(&[0, 1, 2, 3, 4, 5].map(|c| start[c] + change[c]))[0];
            let (principal, moved) = (principal_values(&stress), Moved { u, v, a, s1_elastic });
            let pore = pore(view, monitor.location.element as usize);
            seen.monitors.push(Some(MonitorSeen { moved, stress, principal, pore }));
        }
        kept.extend(first);
        let pairs = plan.pairs.iter().zip(&self.pairs);
        seen.pairs = pairs.map(|(pair, nearest)| pair_seen(view, pair, *nearest)).collect();
        let bolts = plan.bolts.iter().zip(&self.bolts);
        seen.bolts = bolts.map(|(monitor, segment)| segment_seen(view, monitor, *segment)).collect();
        let values = self.cells.iter().map(|cell| cell.value(&seen));
        let row: Vec<f64> = std::iter::once(snapshot.time).chain(values).collect();
        self.table.write(&row, memory)?;
        memory.insert(MEMORY.into(), kept);
        Ok(())
    }
}
