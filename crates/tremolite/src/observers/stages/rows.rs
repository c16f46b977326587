//! stages.csv: what monitors see at the end of each stage, and what else is remembered of those that are done.
//!
//! Each column has a key of its own that also says where its monitor is: a run that begins with another's rest may have other
//! monitors, of which nothing is known in the stages.

use super::super::histories::{at_rest, monitored};
use super::super::observer::{Event, Observer, Setting, StageSeen, View, Wants, Which};
use super::super::rows::{Cell, Seen, cells};
use crate::error::RunError;
use crate::moved;
use crate::plan::{Monitor, Plan};
use crate::seepage::StageFlow;
use indexmap::IndexMap;
use std::collections::BTreeSet;
use std::sync::Arc;
use tremolite_engine::Model;
use tremolite_engine::engine::Rest;
use tremolite_engine::hexahedra::hex;
use tremolite_engine::state::Memory;
use tremolite_laws::Role;
use tremolite_results::{Column, ResultFolder, Said, StageSummary, write_stages};

/// Numbers of each stage, one behind the other: those of [`Rested::own`].
const MEMORY: &str = "stages";
const OWN: usize = 6;

/// Keeps how stages ended, and writes what monitors see there.
pub struct StageRows {
    sees: Wants,
    folder: ResultFolder,
    model: Arc<Model>,
    plan: Arc<Plan>,
}

impl StageRows {
    pub fn new(setting: &Setting) -> Self {
        let Setting { folder, model, assembly, phase, plan, .. } = *setting;
        let standing = |m: &Monitor| model.standing_at(m.location.element as usize, phase.stage);
        let mut sees = monitored(model, assembly, plan, standing);
        if let Which::Some(nodes) = &sees.nodes {
            let monitors = nodes.iter().map(|&node| node as usize);
            sees.nodes = Which::some(monitors.chain(walls(model).into_iter().map(|(_, node)| node)));
        }
        // What has yielded is added up over all.
        sees.elements = Which::All;
        StageRows { sees, folder: folder.clone(), model: model.clone(), plan: plan.clone() }
    }
}

impl Observer for StageRows {
    fn wants(&self) -> Wants {
        self.sees.clone()
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        let StageRows { folder, model, plan, .. } = self;
        match event {
            Event::StageEnds(seen) => {
                if seen.at_rest {
                    remember(model, plan, memory, &Rested::of(seen));
                }
            }
            Event::StagesTaken => {}
            _ => return Ok(()),
        }
        write(folder, model, plan, memory)
    }
}

/// Writes the rows of all stages that are done.
pub(super) fn write(
    folder: &ResultFolder,
    model: &Model,
    plan: &Plan,
    memory: &Memory,
) -> Result<(), RunError> {
    let columns: Vec<Column> = cells(plan).into_iter().map(|cell| cell.column).collect();
    Ok(write_stages(&folder.stages(), &columns, &summaries(model, plan, memory))?)
}

/// A stage that came to rest.
struct Rested<'a> {
    rest: &'a Rest,
    /// ∫Γ dV \[m³\].
    plastic_volume: f64,
    /// What the monitors see.
    monitors: Seen,
    /// Motion \[m\] since the initial equilibrium at each of [`walls`].
    walls: Vec<[f64; 3]>,
}

impl<'a> Rested<'a> {
    fn of(seen: &StageSeen<'a>) -> Self {
        let StageSeen { rest, view, .. } = seen;
        let motion = |node: usize| view.snapshot.displacement[node].xyz();
        let walls = walls(view.model).into_iter().map(|(_, node)| motion(node)).collect();
        Rested { rest, plastic_volume: plastic_volume(view), monitors: at_rest(seen), walls }
    }

    fn own(&self) -> [f64; OWN] {
        let Rested { rest, plastic_volume, .. } = self;
        [rest.cycles as f64, rest.ratio, rest.left, rest.motion, *plastic_volume, rest.unreleased]
    }
}

/// Remembers how a stage ended.
fn remember(model: &Model, plan: &Plan, memory: &mut Memory, rested: &Rested) {
    let mut add = |key: String, values: &[f64]| memory.entry(key).or_default().extend(values);
    add(MEMORY.into(), &rested.own());
    for cell in cells(plan) {
        add(key(&cell), &[cell.value(&rested.monitors)]);
    }
    for ((name, _), motion) in walls(model).into_iter().zip(&rested.walls) {
        add(wall_key(name), motion);
    }
}

/// Where the numbers of a monitor's column are kept.
fn key(cell: &Cell) -> String {
    format!("{MEMORY} {} {}", cell.column.name, cell.place)
}

fn wall_key(name: &str) -> String {
    format!("{MEMORY} wall {name}")
}

/// The mesh's named points, each with the nearest engine node of what stands from the start to the end.
fn walls(model: &Model) -> Vec<(&str, usize)> {
    let throughout = (0..model.user.elements).filter(|&e| {
        model.elements.body_of[e].is_some()
            && !model.elements.lives[e].is_later()
            && model.elements.lives[e].gone.is_none()
    });
    let nodes: BTreeSet<u32> = throughout.flat_map(|e| model.mesh.elements[e].nodes().to_vec()).collect();
    let nearest = |at: &[f64; 3]| {
        let square = |n: &u32| -> f64 {
            let x = model.mesh.nodes[*n as usize];
            (0..3).map(|i| (x[i] - at[i]).powi(2)).sum()
        };
        nodes.iter().min_by(|a, b| square(a).total_cmp(&square(b))).copied()
    };
    model
        .mesh
        .points
        .iter()
        .filter_map(|(name, at)| Some((name.as_str(), model.engine_node[nearest(at)? as usize] as usize)))
        .collect()
}

/// The stages that are done, from what is remembered of them.
pub fn summaries(model: &Model, plan: &Plan, memory: &Memory) -> Vec<StageSummary> {
    let (cells, walls) = (cells(plan), walls(model));
    let rows = memory.get(MEMORY).map_or(&[][..], Vec::as_slice);
    rows.chunks_exact(OWN)
        .zip(&plan.stages)
        .enumerate()
        .map(|(k, (row, planned))| {
            let mut monitors: IndexMap<String, IndexMap<String, Option<f64>>> = IndexMap::new();
            for cell in &cells {
                let value = memory.get(&key(cell)).and_then(|values| values.get(k).copied());
                let of = monitors.entry(cell.column.subject.name().unwrap_or_default()).or_default();
                of.insert(cell.column.quantity.clone(), value.filter(|v| v.is_finite()));
            }
            let motion = |name: &str| Some(*memory.get(&wall_key(name))?.as_chunks::<3>().0.get(k)?);
            StageSummary {
                name: planned.name.clone(),
                excavated: planned.excavated.clone(),
                installed: planned.installed.clone(),
                changed: planned.changed.iter().map(Said::to_string).collect(),
                changed_message: planned.changed.clone(),
                release: planned.release.share,
                tolerance: planned.release.tolerance[0],
                cycles: row[0] as u64,
                ratio: row[1],
                motion_left: row[2],
                largest_motion: row[3],
                plastic_volume: row[4],
                held: row[5],
                monitors,
                moved: moved::recall(model, memory, k),
                walls: walls
                    .iter()
                    .filter_map(|(name, _)| Some(((*name).to_owned(), motion(name)?)))
                    .collect(),
                seepage: planned.flow.as_ref().map(StageFlow::summary),
            }
        })
        .collect()
}

/// ∫Γ dV over what stands \[m³\].
fn plastic_volume(view: &View) -> f64 {
    let slots = view.phase.element_slot.iter().enumerate().filter_map(|(e, slot)| Some((e, (*slot)?)));
    slots
        .filter_map(|(e, slot)| {
            let column = view.history.with_role(&slot, Role::PlasticShear)?;
            let hex = hex(&view.model.mesh, e).ok()?;
            let values = view.history.values(&slot, column).zip(slot.places.quadrature.shares());
            let mean: f64 = values.map(|(value, share)| share * value).sum();
            Some(hex.volume * mean)
        })
        // A sum of nothing is −0.
        .fold(0.0, |sum, volume| sum + volume)
}
