//! Patches given from the rank with most work to others, once all were cut into halves: what halves of halves left uneven adds up.

use super::cut::{Cut, SHARED};
use super::works::Works;

/// Patches that are given on at most, for each rank and level.
const MOVES: usize = 8;
/// A move is made if it saves more than this of all work, so that no rounding is taken for a saving.
const SAVES: f64 = 1e-9;

/// Gives patches one by one from the rank with most work on some level to another, as long as that lessens what ranks wait, send and move twice.
pub(super) fn even_out(cut: &Cut, ranks: u32, of: &mut [u32]) {
    let mut loads = Loads::new(cut.works, ranks, of);
    let mut own: Vec<Vec<u32>> = vec![Vec::new(); ranks as usize];
    (0u32..).zip(&*of).for_each(|(p, &rank)| own[rank as usize].push(p));
    let least = -SAVES * loads.mean.iter().sum::<f64>();
    for _ in 0..MOVES * ranks as usize * cut.works.levels() {
        let mut best: Option<(f64, u32, u32)> = None;
        for level in 0..cut.works.levels() as u8 {
            let (busiest, idlest) = loads.extremes(level);
            for &p in own[busiest as usize].iter().filter(|&&p| cut.level[p as usize] <= level) {
                let mut others: Vec<u32> =
                    cut.near[p as usize].iter().map(|(q, _)| of[*q as usize]).collect();
                others.sort_unstable();
                others.dedup();
                if others == [busiest] {
                    continue;
                }
                others.push(idlest);
                for to in others.into_iter().filter(|&to| to != busiest) {
                    let change =
                        loads.change(p, busiest, to) + shared(cut, of, p, to) * SHARED / f64::from(ranks);
                    if change < best.map_or(least, |(change, ..)| change) {
                        best = Some((change, p, to));
                    }
                }
            }
        }
        let Some((_, p, to)) = best else { return };
        let from = std::mem::replace(&mut of[p as usize], to);
        own[from as usize].retain(|&other| other != p);
        own[to as usize].push(p);
        loads.give(p, from, to);
    }
}

/// Nodes that two ranks have more once a patch goes to another rank, as often as they are moved.
fn shared(cut: &Cut, of: &[u32], p: u32, to: u32) -> f64 {
    let from = of[p as usize];
    let more = |rank: u32| f64::from(u8::from(rank == from)) - f64::from(u8::from(rank == to));
    cut.near[p as usize].iter().map(|(q, often)| often * more(of[*q as usize])).sum()
}

/// Work of each rank, by what has cracked and by the levels that are due.
struct Loads<'a> {
    works: &'a Works,
    ranks: usize,
    /// By case, level and rank.
    all: Vec<f64>,
    /// The same in the mean over the cases, by level and rank.
    mean: Vec<f64>,
    /// The three ranks with most work, by case and level.
    most: Vec<[(f64, u32); 3]>,
}

impl<'a> Loads<'a> {
    fn new(works: &'a Works, ranks: u32, of: &[u32]) -> Self {
        let ranks = ranks as usize;
        let sets = works.cases().count() * works.levels();
        let (all, mean) = (vec![0.0; sets * ranks], vec![0.0; works.levels() * ranks]);
        let mut loads = Loads { works, ranks, all, mean, most: vec![[(0.0, u32::MAX); 3]; sets] };
        (0u32..).zip(of).for_each(|(p, &rank)| loads.add(p, rank, 1.0));
        loads.order();
        loads
    }

    fn add(&mut self, p: u32, rank: u32, sign: f64) {
        let Loads { works, ranks, all, mean, .. } = self;
        for level in 0..works.levels() {
            for (case, _) in works.cases() {
                all[(case * works.levels() + level) * *ranks + rank as usize] +=
                    sign * works.up_to(p as usize, level as u8, case);
            }
            mean[level * *ranks + rank as usize] += sign * works.mean(p as usize, level as u8);
        }
    }

    fn order(&mut self) {
        for (most, loads) in self.most.iter_mut().zip(self.all.chunks_exact(self.ranks)) {
            *most = [(f64::NEG_INFINITY, u32::MAX); 3];
            for (rank, &load) in (0u32..).zip(loads) {
                if let Some(place) = most.iter().position(|(other, _)| load > *other) {
                    most[place..].rotate_right(1);
                    most[place] = (load, rank);
                }
            }
        }
    }

    fn give(&mut self, p: u32, from: u32, to: u32) {
        self.add(p, from, -1.0);
        self.add(p, to, 1.0);
        self.order();
    }

    /// The ranks with most and least work in the mean over the cases.
    fn extremes(&self, level: u8) -> (u32, u32) {
        let loads = &self.mean[usize::from(level) * self.ranks..][..self.ranks];
        let [mut most, mut least] = [0; 2];
        for (rank, load) in loads.iter().enumerate() {
            if *load > loads[most] {
                most = rank;
            }
            if *load < loads[least] {
                least = rank;
            }
        }
        (most as u32, least as u32)
    }

    /// What more time a step of the coarsest level takes once a patch has gone from one rank to another.
    fn change(&self, p: u32, from: u32, to: u32) -> f64 {
        let mut change = 0.0;
        for (case, weight) in self.works.cases() {
            change += weight
                * self.works.by_beat(|level| {
                    let at = case * self.works.levels() + usize::from(level);
                    let load = |rank: u32| self.all[at * self.ranks + rank as usize];
                    let work = self.works.up_to(p as usize, level, case);
                    let beside = self.most[at].iter().find(|(_, rank)| *rank != from && *rank != to);
                    let beside = beside.map_or(f64::NEG_INFINITY, |(load, _)| *load);
                    beside.max(load(from) - work).max(load(to) + work) - self.most[at][0].0
                });
        }
        change
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::division::{middles, touched};
    use crate::{Assembly, Body, Model, Problem, Quadrature, elastic};
    use tremolite_laws::Moduli;
    use tremolite_mesh::boxes::BoxSpec;

    /// Whatever patch goes from whatever rank to another: what that is said to change is the difference of what all of it costs.
    #[test]
    fn a_move_changes_what_ranks_share_and_wait_for_as_it_is_said_to() {
        let mesh = BoxSpec::uniform([0.0; 3], [32.0, 16.0, 8.0], [32, 16, 8]).mesh().unwrap();
        let body = |name: &str, elements: std::ops::Range<u32>, quadrature: Quadrature| {
            let material = elastic(Moduli::from_young_poisson(1e9, 0.25));
            Body {
                name: name.into(),
                elements: elements.collect(),
                material,
                density: 2500.0,
                quadrature,
                viscosity: 0.0,
            }
        };
        let bodies =
            vec![body("below", 0..2048, Quadrature::OnePoint), body("above", 2048..4096, Quadrature::Full)];
        let model = Model::new(Problem::new(mesh, bodies)).unwrap();
        let assembly = Assembly::new(&model).unwrap();
        let touched = touched(&model);
        let works = Works::new(&model, &assembly, &touched);
        let cut = Cut::new(&model, &works, &middles(&model), &touched);
        let patches = model.patches.len() as u32;
        assert!(patches > 8, "{patches}");
        let ranks = 3;
        let of: Vec<u32> = (0..patches).map(|p| p * p % ranks).collect();
        let between = |of: &[u32]| -> f64 {
            let parted = |on: &[u32]| {
                let pairs = (0..on.len()).flat_map(|k| (0..k).map(move |j| (j, k)));
                pairs.filter(|&(j, k)| of[on[j] as usize] != of[on[k] as usize]).count()
            };
            touched.iter().map(|on| parted(on) as f64).sum()
        };
        let waits = |of: &[u32]| -> f64 {
            let mut all = vec![0.0; ranks as usize];
            (0..).zip(of).for_each(|(p, &rank)| all[rank as usize] += works.up_to(p, 0, Works::SOUND));
            all.iter().copied().fold(0.0, f64::max)
        };
        let loads = Loads::new(&works, ranks, &of);
        for p in 0..patches {
            for to in (0..ranks).filter(|&to| to != of[p as usize]) {
                let mut then = of.clone();
                then[p as usize] = to;
                let [exact, said] = [between(&then) - between(&of), shared(&cut, &of, p, to)];
                assert_eq!(exact, said, "patch {p} to {to}");
                let [exact, said] = [waits(&then) - waits(&of), loads.change(p, of[p as usize], to)];
                assert!((exact - said).abs() < 1e-9 * waits(&of), "patch {p} to {to}: {exact} {said}");
            }
        }
    }
}
