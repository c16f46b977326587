//! Motion above the band of what comes in, beside interfaces: what slides may feed vibrations at the mesh's own frequencies.
//!
//! Friction follows the pressure, so pairs that slide can drive a body that rings; every piece obeys its law, the balance closes,
//! and the body slides too far. So the acceleration of the nodes of pairs is parted at [`ABOVE`] times the highest frequency of
//! the motion (99.9 % of its energy lies below), by a Butterworth filter of fourth order, step by step. An interval between two rows counts
//! at a pair that slides at an end of it, where it and those beside it are closed at both ends, between elements that have not cracked:
//! what hits and what breaks rings as well.

use super::interfaces::pairs;
use super::observer::{Event, Observer, Setting, Stepped, View, Wants, Which};
use crate::error::RunError;
use crate::plan::Plan;
use crate::setup::facts::ENERGY_SHARE;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use tremolite_engine::model::Model;
use tremolite_engine::phase::beats::span;
use tremolite_engine::state::Memory;
use tremolite_laws::Role;
use tremolite_mesh::order::hilbert_order;
use tremolite_motion::{Band, Filter, Section, highest_frequency};

/// Key of what this observer remembers: [`SUMS`] numbers of each interface, then [`EACH`] of each pair that it follows.
const MEMORY: &str = "ringing";
/// The band above begins at this many times the highest frequency that comes in.
const ABOVE: f64 = 2.0;
/// Pairs followed of an interface, at most: others lie evenly between them.
const MOST: usize = 128;
/// Damage in tension beyond which an element has cracked.
const CRACKED: f64 = 0.5;
/// Sections of the filter.
const SECTIONS: usize = 2;
/// Numbers of a component of motion: the velocity of the last step, and two of each section.
const COMPONENT: usize = 1 + 2 * SECTIONS;
/// Numbers of a pair: squares above the band and below since the last row, whether it slid in that row ([`LEFT_OUT`] where it does not
/// count), then its two nodes'.
const EACH: usize = 3 + 6 * COMPONENT;
/// Numbers of an interface: squares above and below, and steps, by the shares of the pairs that count; steps since the last row.
const SUMS: usize = 4;

/// What is known of an interface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ringing {
    /// Root mean squares of the acceleration above the band and below \[m/s²\], over the area and time that count.
    pub above: f64,
    pub below: f64,
    /// Share of area and time that counts.
    pub counted: f64,
    /// Where the band above begins \[Hz\].
    pub corner: f64,
}

impl Ringing {
    /// What was seen at an interface of the user's after some steps; nothing where no wave comes in or nothing was followed.
    pub fn of(model: &Model, plan: &Plan, memory: &Memory, interface: usize, steps: u64) -> Option<Self> {
        let kept = memory.get(MEMORY)?.get(SUMS * interface..SUMS * (interface + 1))?;
        let &[above, below, counted, _] = kept else { return None };
        let mean = |sum: f64| if counted > 0.0 { (sum / counted).sqrt() } else { 0.0 };
        let [above, below] = [above, below].map(mean);
        Some(Ringing { above, below, counted: counted / steps as f64, corner: corner(model, plan)? })
    }
}

/// Where the band above begins \[Hz\].
fn corner(model: &Model, plan: &Plan) -> Option<f64> {
    Some(ABOVE * highest_frequency(plan.shaken_by(model)?, ENERGY_SHARE)?)
}

/// A pair that is followed.
struct Followed {
    /// Its number among those of the interface, and those that share a face with it, itself included.
    pair: usize,
    beside: Vec<usize>,
    nodes: [usize; 2],
    /// Elements on both sides.
    elements: Vec<u32>,
    /// Of the area that is followed of its interface.
    share: f64,
}

/// Follows pairs of interfaces through every step.
pub struct Rings {
    wants: Wants,
    /// By level of steps, as far as nodes that are followed have such.
    sections: Vec<Vec<Section>>,
    followed: Vec<Followed>,
    /// By interface, which of them are its own.
    of: Vec<Range<usize>>,
}

impl Rings {
    /// Nothing without interfaces, where no wave comes in, or where steps are too long for the band.
    pub fn new(setting: &Setting) -> Option<Self> {
        let Setting { model, dt, .. } = *setting;
        if model.user_seams().is_empty() {
            return None;
        }
        let corner = corner(model, setting.plan)?;
        let (mut of, mut followed) = (Vec::new(), Vec::new());
        for seam in model.user_seams() {
            let first = followed.len();
            let lasting: Vec<usize> = seam.lasting().collect();
            let places: Vec<[f64; 3]> = lasting.iter().map(|&k| seam.place(&model.mesh, k)).collect();
            let chosen: Vec<usize> = spread(&places, MOST).into_iter().map(|k| lasting[k]).collect();
            let area: f64 = chosen.iter().map(|&k| seam.pairs[k].area).sum();
            let mut of_face: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
            for &k in &lasting {
                seam.pairs[k].corners.iter().for_each(|(f, _)| of_face.entry(*f).or_default().push(k));
            }
            followed.extend(chosen.into_iter().map(|pair| {
                let shape = &seam.pairs[pair];
                let faces = shape.corners.iter().map(|(face, _)| *face as usize);
                let beside: BTreeSet<usize> = shape
                    .corners
                    .iter()
                    .filter_map(|(face, _)| of_face.get(face))
                    .flatten()
                    .copied()
                    .collect();
                Followed {
                    pair,
                    beside: beside.into_iter().collect(),
                    nodes: shape.nodes.map(|node| model.engine_node[node as usize] as usize),
                    elements: faces.flat_map(|face| seam.faces[face].map(|face| face.element)).collect(),
                    share: shape.area / area,
                }
            }));
            of.push(first..followed.len());
        }
        let wants = Wants {
            elements: Which::some(followed.iter().flat_map(|f| &f.elements).map(|&e| e as usize)),
            members: pairs(setting.assembly),
            steps: Which::some(followed.iter().flat_map(|f| f.nodes)),
            ..Wants::looks(setting.rows())
        };
        let level = |f: &Followed| f.nodes.map(|n| model.nodes.level[n]).into_iter().max();
        let coarsest = followed.iter().filter_map(level).max().unwrap_or(0);
        let design = |level: u8| {
            let filter = Filter::design(Band::High(corner), span(level) as f64 * dt).ok()?;
            Some(filter.sections().to_vec())
        };
        let sections = (0..=coarsest).map(design).collect::<Option<Vec<_>>>()?;
        Some(Rings { wants, sections, followed, of })
    }

    /// What is remembered of interfaces, and of pairs.
    fn kept<'m>(&self, memory: &'m mut Memory) -> (&'m mut [f64], &'m mut [f64]) {
        let sums = SUMS * self.of.len();
        let kept =
            memory.entry(MEMORY.into()).or_insert_with(|| vec![0.0; sums + EACH * self.followed.len()]);
        kept.split_at_mut(sums)
    }

    /// Squares of what the filter lets through of a node's acceleration in a step, and of the rest.
    fn squares(&self, velocity: [f64; 3], (level, dt): (u8, f64), own: &mut [f64]) -> [f64; 2] {
        let mut squares = [0.0; 2];
        for (v, own) in velocity.into_iter().zip(own.chunks_exact_mut(COMPONENT)) {
            let acceleration = (v - own[0]) / dt;
            own[0] = v;
            let mut x = acceleration;
            for (Section { b, a }, z) in
                self.sections[usize::from(level)].iter().zip(own[1..].chunks_exact_mut(2))
            {
                let y = b[0] * x + z[0];
                z[0] = b[1] * x - a[0] * y + z[1];
                z[1] = b[2] * x - a[1] * y;
                x = y;
            }
            squares[0] += x * x;
            squares[1] += (acceleration - x) * (acceleration - x);
        }
        squares
    }
}

impl Observer for Rings {
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

impl Rings {
    fn see(&mut self, view: &View, memory: &mut Memory) -> Result<(), RunError> {
        let View { assembly, history, phase, .. } = *view;
        let cracked = |element: &u32| {
            let Some(slot) = &phase.element_slot[*element as usize] else { return false };
            let damage = history.with_role(slot, Role::TensionDamage);
            damage.is_some_and(|column| history.values(slot, column).any(|d| d > CRACKED))
        };
        let (sums, pairs) = self.kept(memory);
        for ((of, contacts), sums) in self.of.iter().zip(&assembly.contacts).zip(sums.chunks_exact_mut(SUMS))
        {
            let steps = std::mem::take(&mut sums[3]);
            for (followed, own) in
                self.followed[of.clone()].iter().zip(pairs[EACH * of.start..].chunks_exact_mut(EACH))
            {
                let state = |pair: usize| contacts.seen(history.octets, pair).state;
                let out = followed.beside.iter().any(|&pair| state(pair) == OPEN)
                    || followed.elements.iter().any(cracked);
                let slides = state(followed.pair) == SLIDES;
                let now = if out { LEFT_OUT } else { f64::from(u8::from(slides)) };
                let counts = now != LEFT_OUT && own[2] != LEFT_OUT && (slides || own[2] > 0.0);
                if counts {
                    let more = [own[0], own[1], steps].map(|x| followed.share * x);
                    sums.iter_mut().zip(more).for_each(|(sum, more)| *sum += more);
                }
                own[..3].copy_from_slice(&[0.0, 0.0, now]);
            }
        }
        Ok(())
    }

    fn stepped(&mut self, stepped: &Stepped, memory: &mut Memory) {
        let Stepped { du, dt, .. } = *stepped;
        let (sums, pairs) = self.kept(memory);
        sums.chunks_exact_mut(SUMS).for_each(|sums| sums[3] += 1.0);
        for (followed, own) in self.followed.iter().zip(pairs.chunks_exact_mut(EACH)) {
            let (found, nodes) = own.split_at_mut(3);
            for (node, own) in followed.nodes.iter().zip(nodes.chunks_exact_mut(3 * COMPONENT)) {
                let Some(step) = stepped.own([*node]) else { continue };
                let level = stepped.model.nodes.level[*node];
                let squares = self.squares(du[*node].xyz().map(|d| d / dt), (level, step), own);
                // As many steps of the finest level as it stands for.
                let weight = 0.5 * span(level) as f64;
                found.iter_mut().zip(squares).for_each(|(sum, more)| *sum += weight * more);
            }
        }
    }
}

/// So many of some places, evenly spread: every so-many-th on a curve through all, whatever order they are given in.
fn spread(places: &[[f64; 3]], most: usize) -> Vec<usize> {
    let along = hilbert_order(places).into_iter().map(|k| k as usize);
    along.step_by(places.len().div_ceil(most).max(1)).collect()
}

/// States of a pair.
const SLIDES: u8 = 2;
const OPEN: u8 = 3;
/// In place of whether a pair slides.
const LEFT_OUT: f64 = -1.0;

#[cfg(test)]
mod tests {
    use super::spread;

    /// Of a wall of 12 × 9 places at most 30, the same ones in whatever order, and none further than two places from one of them.
    #[test]
    fn what_is_followed_goes_by_places_and_not_by_numbers() {
        let wall: Vec<[f64; 3]> = (0..108).map(|k| [1.0, f64::from(k % 12), f64::from(k / 12)]).collect();
        let chosen = |places: &[[f64; 3]]| {
            let mut found: Vec<[i32; 2]> =
                spread(places, 30).iter().map(|&k| [places[k][1] as i32, places[k][2] as i32]).collect();
            found.sort_unstable();
            found
        };
        let own = chosen(&wall);
        assert_eq!(own.len(), 27);
        let shuffled: Vec<[f64; 3]> = (0..108).map(|k| wall[k * 35 % 108]).collect();
        assert_eq!(chosen(&shuffled), own);
        let near =
            |x: &[f64; 3]| own.iter().any(|[y, z]| (x[1] as i32 - y).abs().max((x[2] as i32 - z).abs()) <= 2);
        assert!(wall.iter().all(near), "{own:?}");
        assert_eq!(spread(&wall, 200).len(), 108);
        assert!(spread(&[], 30).is_empty());
    }
}
