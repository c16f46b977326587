//! What the initial stress does before anything is excavated, and where stages move unevenly.

use super::super::interfaces::pairs;
use super::super::observer::{CycleMade, Event, Observer, Setting, StageSeen, View, Wants, Which};
use crate::error::RunError;
use crate::point_stress::mean;
use tremolite_engine::hexahedra::hex;
use tremolite_engine::state::Memory;

/// Keeps it.
pub struct Begins {
    pairs: Which,
}

impl Begins {
    pub fn new(setting: &Setting) -> Self {
        Begins { pairs: pairs(setting.assembly) }
    }
}

impl Observer for Begins {
    fn wants(&self) -> Wants {
        Wants {
            cycles: Some(1),
            nodes: Which::All,
            elements: Which::All,
            members: self.pairs.clone(),
            ..Wants::default()
        }
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        match event {
            // Before anything has moved.
            Event::Cycle(CycleMade { stage: 0, rest, freed: false }) if rest.cycles == 1 => {
                memory.insert(IMBALANCE.into(), vec![rest.unreleased]);
            }
            Event::StageEnds(seen) if seen.at_rest => {
                let uneven = Uneven::of(seen);
                if seen.stage == 0 {
                    Beginning::of(&seen.view, uneven).remember(memory);
                }
                uneven.remember(memory);
            }
            _ => {}
        }
        Ok(())
    }
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

/// Key of the largest difference of motion \[m\] across an element or a pair, stage by stage.
const UNEVEN: &str = "uneven motion of stages";

/// Where motion differs most over a short way.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Uneven {
    /// Between two corners of an element, or the two nodes of a pair \[m\].
    difference: f64,
    /// That element, or one beside that pair.
    element: u32,
}

impl Uneven {
    /// Of what a stage moved.
    fn of(seen: &StageSeen) -> Self {
        let StageSeen { view, u, start, .. } = seen;
        let model = view.model;
        let moved = |node: u32| {
            let node = model.engine_node[node as usize] as usize;
            let (now, before) = (u[node], start[node]);
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

    fn remember(&self, memory: &mut Memory) {
        memory.entry(UNEVEN.into()).or_default().push(self.difference);
    }
}

/// The largest difference of motion \[m\] over a short way, of the initial equilibrium and of the stages behind it.
pub fn uneven(memory: &Memory) -> Option<(f64, f64)> {
    let (first, others) = memory.get(UNEVEN)?.split_first()?;
    Some((*first, others.iter().copied().fold(0.0, f64::max)))
}

impl Beginning {
    fn of(view: &View, uneven: Uneven) -> Self {
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
            let (Some(slot), Some(before)) = (slot, view.model.elements.initial.get(e as usize)) else {
                continue;
            };
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

    fn remember(&self, memory: &mut Memory) {
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
