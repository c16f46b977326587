//! What a run remembers of the stages that are done.
//!
//! Each column has a key of its own that also says where its monitor is: a run that begins with another's rest may have other
//! monitors, of which nothing is known in the stages.

use super::moved;
use crate::observers::{Cell, Seen, View, cells};
use crate::plan::Plan;
use crate::point_stress::mean;
use indexmap::IndexMap;
use std::collections::BTreeSet;
use tremolite_engine::Model;
use tremolite_engine::engine::Rest;
use tremolite_engine::hexahedra::hex;
use tremolite_engine::state::{Memory, State};
use tremolite_results::{Said, StageSummary};

/// Numbers of each stage, one behind the other: those of [`Rested::own`].
const MEMORY: &str = "stages";
const OWN: usize = 6;

/// A stage that came to rest.
pub(super) struct Rested<'a> {
    pub rest: &'a Rest,
    /// ∫Γ dV \[m³\].
    pub plastic_volume: f64,
    /// What the monitors see.
    pub monitors: Seen,
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
                changed_said: planned.changed.clone(),
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
            }
        })
        .collect()
}

/// What the initial stress does before anything is excavated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beginning {
    /// Pairs of interfaces that are there from the start, and how many of them it brings beyond their strength.
    pub pairs: usize,
    pub beyond: usize,
    /// Σ V|σ − σ₀| over Σ V|σ₀|, with σ the stress at the initial equilibrium; not a number without initial stress.
    pub change: f64,
    /// The largest |σ − σ₀| of an element over its |σ₀|, or the mean of that where it is less, as at the surface; and the element.
    pub largest_change: (f64, u32),
    /// The element across which, or across a pair beside which, motion differs most.
    pub uneven_at: u32,
    /// What is out of balance before anything moves, over all contributions.
    pub imbalance: f64,
}

/// Keys of what is remembered of it.
const BEGINNING: &str = "initial equilibrium";
const IMBALANCE: &str = "imbalance of the initial stress";

/// Remembers what is out of balance before anything moves.
pub(super) fn remember_imbalance(memory: &mut Memory, ratio: f64) {
    memory.insert(IMBALANCE.into(), vec![ratio]);
}

/// Key of the largest difference of motion \[m\] across an element or a pair, stage by stage.
const UNEVEN: &str = "uneven motion of stages";

/// Where motion differs most over a short way.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Uneven {
    /// Between two corners of an element, or the two nodes of a pair \[m\].
    pub difference: f64,
    /// That element, or one beside that pair.
    pub element: u32,
}

impl Uneven {
    /// Of what a stage moved.
    pub fn of(view: &View, state: &State) -> Self {
        let model = view.model;
        let moved = |node: u32| {
            let node = model.engine_node[node as usize] as usize;
            let (now, before) = (state.u[node], state.start[node]);
            [0, 1, 2].map(|i| now.0[i] - before.0[i])
        };
        let apart = |a: [f64; 3], b: [f64; 3]| (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt();
        let mut most = Uneven::default();
        let mut count = |difference: f64, element: u32| {
            if difference > most.difference {
                most = Uneven { difference, element };
            }
        };
        let standing = (0u32..).zip(&view.phase.element_slot).filter(|(_, slot)| slot.is_some());
        for (e, _) in standing {
            let corners: Vec<[f64; 3]> =
                model.mesh.elements[e as usize].nodes().iter().map(|&n| moved(n)).collect();
            for (k, &a) in corners.iter().enumerate() {
                corners[..k].iter().for_each(|&b| count(apart(a, b), e));
            }
        }
        for seam in model.user_seams() {
            for (pair, _) in
                seam.pairs.iter().zip(&seam.lives).filter(|(_, life)| life.holds(view.phase.stage))
            {
                let [a, b] = pair.nodes.map(moved);
                let beside = pair.corners.first().map(|(f, _)| seam.faces[*f as usize][1].element);
                beside.into_iter().for_each(|e| count(apart(a, b), e));
            }
        }
        most
    }

    pub fn remember(&self, memory: &mut Memory) {
        memory.entry(UNEVEN.into()).or_default().push(self.difference);
    }
}

/// The largest difference of motion \[m\] over a short way, of the initial equilibrium and of the stages behind it.
pub(crate) fn uneven(memory: &Memory) -> Option<(f64, f64)> {
    let (first, others) = memory.get(UNEVEN)?.split_first()?;
    Some((*first, others.iter().copied().fold(0.0, f64::max)))
}

impl Beginning {
    pub(super) fn of(view: &View, uneven: Uneven) -> Self {
        let (mut pairs, mut beyond) = (0, 0);
        for (seam, contacts) in view.model.user_seams().iter().zip(&view.assembly.contacts) {
            for pair in (0..seam.pairs.len()).filter(|&k| !seam.lives[k].is_later()) {
                let seen = contacts.seen(view.history.octets, pair);
                pairs += 1;
                beyond += usize::from(seen.has_slid || seen.has_opened);
            }
        }
        let (mut changed, mut whole, mut volume) = (0.0, 0.0, 0.0);
        let mut of_elements = Vec::new();
        for (e, slot) in (0u32..).zip(&view.phase.element_slot) {
            let (Some(slot), Some(before)) = (slot, view.model.initial.get(e as usize)) else { continue };
            let Ok(hex) = hex(&view.model.mesh, e as usize) else { continue };
            let points = &view.snapshot.stress[slot.point as usize..][..slot.points as usize];
            let now = mean(&slot.places, points);
            let change = size([0, 1, 2, 3, 4, 5].map(|c| now[c] - before[c]));
            changed += hex.volume * change;
            whole += hex.volume * size(*before);
            volume += hex.volume;
            of_elements.push((e, change, size(*before)));
        }
        let share = |&(e, change, before): &(u32, f64, f64)| (change / before.max(whole / volume), e);
        let largest = of_elements.iter().map(share).max_by(|a, b| a.0.total_cmp(&b.0));
        Beginning {
            pairs,
            beyond,
            change: changed / whole,
            largest_change: largest.unwrap_or((f64::NAN, 0)),
            uneven_at: uneven.element,
            imbalance: f64::NAN,
        }
    }

    pub(super) fn remember(&self, memory: &mut Memory) {
        let Beginning { pairs, beyond, change, largest_change: (largest, at), uneven_at, .. } = *self;
        let row = [pairs as f64, beyond as f64, change, largest, f64::from(at), f64::from(uneven_at)];
        memory.insert(BEGINNING.into(), row.to_vec());
    }

    /// What was remembered; none before the initial equilibrium.
    pub fn recall(memory: &Memory) -> Option<Self> {
        let imbalance = memory.get(IMBALANCE).and_then(|kept| kept.first().copied()).unwrap_or(f64::NAN);
        match memory.get(BEGINNING)?[..] {
            [pairs, beyond, change, largest, at, uneven_at] => Some(Beginning {
                pairs: pairs as usize,
                beyond: beyond as usize,
                change,
                largest_change: (largest, at as u32),
                uneven_at: uneven_at as u32,
                imbalance,
            }),
            _ => None,
        }
    }
}

/// √(σ:σ).
fn size(s: [f64; 6]) -> f64 {
    let [xx, yy, zz, xy, yz, zx] = s.map(|x| x * x);
    (xx + yy + zz + 2.0 * (xy + yz + zx)).sqrt()
}
