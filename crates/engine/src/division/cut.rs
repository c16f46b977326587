//! Patches cut into runs of equal work, on each level of steps by itself.
//!
//! Ranks wait for one another in every step of the finest level, and of a coarser level only some steps have work. So equal work in all is not
//! enough: a rank that has the fine elements and one that has the coarse ones would wait for each other in turn. Patches of each level are cut
//! by themselves along one order, and of some orders that one is taken which leaves ranks least to wait for, sound and cracked, and to move twice.

use super::works::{MOVED, Works};
use crate::model::Model;
use std::collections::HashMap;
use std::ops::Range;
use tremolite_mesh::order::hilbert_order;

/// What a node costs that two ranks have, beside that both move it: the contributions that are packed, sent and added, in updates of an elastic
/// brick.
const SENT: f64 = 0.5;
/// What a node costs that two ranks have.
pub(super) const SHARED: f64 = MOVED + SENT;

/// Patches with what two ranks share that part them.
pub(super) struct Cut<'a> {
    pub works: &'a Works,
    pub level: Vec<u8>,
    /// The place of each patch in each order that is tried.
    places: Vec<Vec<u32>>,
    /// Patches that have nodes in common with each, and how often those are moved in a step of the coarsest level.
    pub near: Vec<Vec<(u32, f64)>>,
}

impl<'a> Cut<'a> {
    /// `middles` are those of the patches, `touched` the patches of each node.
    pub fn new(model: &Model, works: &'a Works, middles: &[[f64; 3]], touched: &[Vec<u32>]) -> Self {
        let mut orders = vec![hilbert_order(middles)];
        for i in 0..3 {
            let mut order: Vec<u32> = (0..middles.len() as u32).collect();
            order.sort_by(|&a, &b| middles[a as usize][i].total_cmp(&middles[b as usize][i]));
            orders.push(order);
        }
        let place = |order: Vec<u32>| {
            let mut places = vec![0; order.len()];
            (0..).zip(order).for_each(|(place, p)| places[p as usize] = place);
            places
        };
        let coarsest = model.nodes.coarsest();
        let mut near = vec![HashMap::<u32, f64>::new(); middles.len()];
        for (patches, &level) in touched.iter().zip(&model.nodes.level) {
            let often = f64::from(1u32 << (coarsest - level));
            for (k, &p) in patches.iter().enumerate() {
                for &q in &patches[..k] {
                    *near[p as usize].entry(q).or_default() += often;
                    *near[q as usize].entry(p).or_default() += often;
                }
            }
        }
        let sorted = |near: HashMap<u32, f64>| {
            let mut near: Vec<_> = near.into_iter().collect();
            near.sort_unstable_by_key(|(patch, _)| *patch);
            near
        };
        Cut {
            works,
            level: model.patches.iter().map(|patch| patch.level).collect(),
            places: orders.into_iter().map(place).collect(),
            near: near.into_iter().map(sorted).collect(),
        }
    }

    /// Gives some patches to ranks, in halves.
    pub fn among(&self, some: Vec<u32>, ranks: Range<u32>, of: &mut [u32]) {
        if ranks.len() <= 1 {
            some.iter().for_each(|&p| of[p as usize] = ranks.start);
            return;
        }
        let half = ranks.start + ranks.len() as u32 / 2;
        let counts = [half - ranks.start, ranks.end - half].map(f64::from);
        let mut best: Option<(f64, [Vec<u32>; 2])> = None;
        for places in &self.places {
            let halves = self.halves(&some, places, counts);
            let lost = self.lost(&halves, counts);
            if best.as_ref().is_none_or(|(least, _)| lost < *least) {
                best = Some((lost, halves));
            }
        }
        if let Some((_, [first, second])) = best {
            self.among(first, ranks.start..half, of);
            self.among(second, half..ranks.end, of);
        }
    }

    /// Some patches in two parts, for so many ranks each, in an order: those of each level by themselves, so that all up to it are even.
    fn halves(&self, some: &[u32], places: &[u32], [a, b]: [f64; 2]) -> [Vec<u32>; 2] {
        let mut order = some.to_vec();
        order.sort_unstable_by_key(|&p| (self.level[p as usize], places[p as usize]));
        let mut halves = [Vec::new(), Vec::new()];
        for lot in order.chunk_by(|&p, &q| self.level[p as usize] == self.level[q as usize]) {
            let level = self.level[lot[0] as usize];
            let work = |p: &u32| self.works.mean(*p as usize, level);
            let whole: f64 = halves.iter().flatten().chain(lot).map(work).sum();
            let mut sum: f64 = halves[0].iter().map(work).sum();
            // A patch goes where more of it lies.
            let before = lot.iter().take_while(|&p| {
                let work = work(p);
                sum += work;
                sum - 0.5 * work < whole * a / (a + b)
            });
            let (first, second) = lot.split_at(before.count());
            halves[0].extend_from_slice(first);
            halves[1].extend_from_slice(second);
        }
        halves
    }

    /// What each of so many ranks waits, sends and moves twice in a step of the coarsest level.
    fn lost(&self, halves: &[Vec<u32>; 2], counts: [f64; 2]) -> f64 {
        let ranks = counts[0] + counts[1];
        let waited = |case: usize| {
            self.works.by_beat(|level| {
                let work = |half: &Vec<u32>| {
                    half.iter().map(|&p| self.works.up_to(p as usize, level, case)).sum::<f64>()
                };
                let [a, b] = [&halves[0], &halves[1]].map(work);
                (a / counts[0]).max(b / counts[1]) - (a + b) / ranks
            })
        };
        let waited: f64 = self.works.cases().map(|(case, weight)| weight * waited(case)).sum();
        let mut second = vec![false; self.level.len()];
        halves[1].iter().for_each(|&p| second[p as usize] = true);
        let shared =
            halves[0].iter().flat_map(|&p| &self.near[p as usize]).filter(|(q, _)| second[*q as usize]);
        waited + shared.map(|(_, often)| often).sum::<f64>() * SHARED / ranks
    }
}
