//! What a run remembers of the stages that are done.
//!
//! Each column has a key of its own that also says where its monitor is: a run that begins with another's rest may have other
//! monitors, of which nothing is known in the stages.

use crate::observers::{View, columns};
use crate::plan::Plan;
use crate::quantities::{MONITOR, PAIR, RELATIVE};
use indexmap::IndexMap;
use std::collections::BTreeSet;
use tremolite_engine::Model;
use tremolite_engine::engine::Rest;
use tremolite_engine::state::Memory;
use tremolite_results::StageSummary;

/// Numbers of each stage, one behind the other: those of [`Rested::own`].
const MEMORY: &str = "stages";
const OWN: usize = 6;

/// A stage that came to rest.
pub(super) struct Rested<'a> {
    pub rest: &'a Rest,
    /// ∫Γ dV \[m³\].
    pub plastic_volume: f64,
    /// Of the monitors, in the order of monitors.csv without the time.
    pub monitors: Vec<f64>,
    /// Motion \[m\] since the initial equilibrium at each of [`walls`].
    pub walls: Vec<[f64; 3]>,
}

impl Rested<'_> {
    fn own(&self) -> [f64; OWN] {
        let Rested { rest, plastic_volume, .. } = self;
        [rest.cycles as f64, rest.ratio, rest.left, rest.motion, *plastic_volume, rest.unreleased]
    }
}

/// Remembers how a stage ended.
pub(super) fn remember(model: &Model, plan: &Plan, memory: &mut Memory, rested: &Rested) {
    let mut add = |key: String, values: &[f64]| memory.entry(key).or_default().extend(values);
    add(MEMORY.into(), &rested.own());
    for (key, value) in keys(plan).into_iter().zip(&rested.monitors) {
        add(key, &[*value]);
    }
    for ((name, _), motion) in walls(model).into_iter().zip(&rested.walls) {
        add(wall_key(name), motion);
    }
}

/// Where the numbers of each monitor's columns are kept, in the order of monitors.csv without the time.
fn keys(plan: &Plan) -> Vec<String> {
    let at = |k: usize| plan.monitors[k].point;
    let of_monitors = (0..plan.monitors.len()).map(|k| (format!("{:?}", at(k)), MONITOR.len()));
    let of_relatives =
        plan.relatives.iter().map(|[a, b]| (format!("{:?} {:?}", at(*a), at(*b)), RELATIVE.len()));
    let of_pairs = plan.pairs.iter().map(|pair| (format!("{:?} {}", pair.point, pair.interface), PAIR.len()));
    let places = of_monitors
        .chain(of_relatives)
        .chain(of_pairs)
        .flat_map(|(place, count)| std::iter::repeat_n(place, count));
    let columns = &columns(plan)[1..];
    columns.iter().zip(places).map(|(column, place)| format!("{MEMORY} {} {place}", column.name)).collect()
}

fn wall_key(name: &str) -> String {
    format!("{MEMORY} wall {name}")
}

/// The mesh's named points, each with the nearest engine node of what stands from the start to the end.
pub(super) fn walls(model: &Model) -> Vec<(&str, usize)> {
    let throughout = (0..model.user_elements).filter(|&e| {
        model.body_of[e].is_some() && !model.lives[e].is_later() && model.lives[e].gone.is_none()
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
pub(super) fn summaries(model: &Model, plan: &Plan, memory: &Memory) -> Vec<StageSummary> {
    let (columns, keys, walls) = (columns(plan), keys(plan), walls(model));
    let rows = memory.get(MEMORY).map_or(&[][..], Vec::as_slice);
    rows.chunks_exact(OWN)
        .zip(&plan.stages)
        .enumerate()
        .map(|(k, (row, planned))| {
            let mut monitors: IndexMap<String, IndexMap<String, Option<f64>>> = IndexMap::new();
            for (column, key) in columns[1..].iter().zip(&keys) {
                let (monitor, quantity) = column.name.rsplit_once('.').unwrap_or((&column.name, ""));
                let value = memory.get(key).and_then(|values| values.get(k).copied());
                let of = monitors.entry(monitor.to_owned()).or_default();
                of.insert(quantity.to_owned(), value.filter(|v| v.is_finite()));
            }
            let motion = |name: &str| Some(*memory.get(&wall_key(name))?.as_chunks::<3>().0.get(k)?);
            StageSummary {
                name: planned.name.clone(),
                excavated: planned.excavated.clone(),
                installed: planned.installed.clone(),
                changed: planned.changed.clone(),
                release: planned.release.share,
                tolerance: planned.release.tolerance[0],
                cycles: row[0] as u64,
                ratio: row[1],
                motion_left: row[2],
                largest_motion: row[3],
                plastic_volume: row[4],
                held: row[5],
                monitors,
                walls: walls
                    .iter()
                    .filter_map(|(name, _)| Some(((*name).to_owned(), motion(name)?)))
                    .collect(),
            }
        })
        .collect()
}

/// Pairs of interfaces that are there from the start, and how many of them the initial stress brings beyond their strength.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Yielded {
    pub pairs: usize,
    pub beyond: usize,
}

/// Key of what is remembered of them.
const YIELDED: &str = "pairs beyond their strength at the start";

impl Yielded {
    pub(super) fn of(view: &View) -> Self {
        let mut found = Yielded { pairs: 0, beyond: 0 };
        for (seam, contacts) in view.model.seams.iter().zip(&view.assembly.contacts) {
            for pair in (0..seam.pairs.len()).filter(|&k| !seam.lives[k].is_later()) {
                let seen = contacts.seen(view.history.octets, pair);
                found.pairs += 1;
                found.beyond += usize::from(seen.has_slid || seen.has_opened);
            }
        }
        found
    }

    pub(super) fn remember(&self, memory: &mut Memory) {
        if self.pairs > 0 {
            memory.insert(YIELDED.into(), vec![self.pairs as f64, self.beyond as f64]);
        }
    }

    /// What was remembered; none where no pair is there from the start.
    pub fn recall(memory: &Memory) -> Option<Self> {
        match memory.get(YIELDED)?[..] {
            [pairs, beyond] => Some(Yielded { pairs: pairs as usize, beyond: beyond as usize }),
            _ => None,
        }
    }
}
