//! One rank of several that work on one model: what it exchanges with the others, so that sums, looks and states are those of one process.
//!
//! Every rank holds the whole model and room for the whole state, of which it knows what its own members remember and how the nodes move that
//! these push or read. Where a state has to be whole, it is [gathered](Ranks::whole); in steps contributions alone are exchanged.

mod tally;
mod words;

pub use tally::{Tally, Took};
pub use words::{Tree, Words};

use crate::assembly::{Assembly, Slices};
use crate::division::Division;
use crate::exchange::{Exchange, Halo, To};
use crate::model::Model;
use crate::phase::Phase;
use crate::phase::ours::{Slots, WIDTH};
use crate::state::State;
use std::ops::Range;
use std::sync::Arc;
use std::time::Instant;
use tremolite_kernels::Line;
use tremolite_laws::{Octet, Row};

/// A rank, and how the model is shared out among all.
pub struct Ranks {
    exchange: Arc<dyn Exchange>,
    pub division: Division,
    /// Whether what a rank does not have is not a number to it.
    poisoned: bool,
    pub tally: Tally,
}

impl Ranks {
    /// # Panics
    /// If the division is one for another number of ranks.
    pub fn new(exchange: Arc<dyn Exchange>, division: Division) -> Ranks {
        assert_eq!(exchange.ranks(), division.ranks, "the division is for as many ranks as there are");
        Ranks { exchange, division, poisoned: false, tally: Tally::default() }
    }

    /// From now on what a rank does not have is not a number to it: a mode for tests.
    #[must_use]
    pub fn poisoned(mut self) -> Self {
        self.poisoned = true;
        self
    }

    pub fn rank(&self) -> u32 {
        self.exchange.rank()
    }

    /// Whether it is the one that speaks and writes.
    pub fn is_first(&self) -> bool {
        self.rank() == 0
    }

    /// The bits that any rank sets.
    pub fn agree(&self, bits: u64) -> u64 {
        self.exchange.agree(bits)
    }

    /// Numbers of rank 0, for all.
    pub fn from_first(&self, words: &[f64]) -> Vec<f64> {
        let own = if self.is_first() { words } else { &[] };
        let count = self.agree(own.len() as u64) as usize;
        let mut counts = vec![0; self.division.ranks as usize];
        counts[0] = count;
        self.exchange.gather(own, &counts, To::All)
    }

    /// What a rank has of a phase.
    pub fn phase(&self, model: &Model, assembly: &Assembly, phase: &Phase) -> Arc<Phase> {
        Arc::new(phase.of_rank(model, assembly, &self.division, self.rank()))
    }

    /// Sends numbers, and waits for others.
    pub fn halo(&self, halo: &Halo, words: &[f64]) -> Vec<f64> {
        self.exchange.start(halo, words);
        let mut received = vec![0.0; halo.words()[1]];
        self.exchange.finish(halo, &mut received);
        received
    }

    /// Begins to exchange contributions.
    pub(crate) fn start(&self, slots: &Slots, contributions: &[Row]) {
        let mut words = Vec::with_capacity(WIDTH * slots.send.len());
        slots.send.iter().for_each(|&slot| words.extend_from_slice(&contributions[slot as usize].0[..WIDTH]));
        self.exchange.start(&slots.halo, &words);
        self.tally.sent(words.len());
    }

    /// Waits for those of others.
    pub(crate) fn finish(&self, slots: &Slots, contributions: &mut [Row]) {
        let begin = Instant::now();
        let mut words = vec![0.0; WIDTH * slots.receive.len()];
        self.exchange.finish(&slots.halo, &mut words);
        for (&slot, row) in slots.receive.iter().zip(words.chunks_exact(WIDTH)) {
            contributions[slot as usize] = Row::new([row[0], row[1], row[2]]);
        }
        self.tally.waited(begin.elapsed());
    }

    /// The sum of each tree over what its ranks have.
    pub fn sums<T: Words + Default>(
        &self,
        width: usize,
        mut trees: Vec<Tree<T>>,
        plus: impl Fn(T, T) -> T,
    ) -> Vec<T> {
        let mut own = Vec::new();
        let mut counts = vec![0; self.division.ranks as usize];
        for tree in &mut trees {
            tree.grow(self.rank(), &plus);
            for (place, rank) in tree.summits() {
                counts[rank as usize] += width;
                if rank == self.rank() {
                    tree.put(place, &mut own);
                }
            }
        }
        let begin = Instant::now();
        let words = self.exchange.gather(&own, &counts, To::All);
        self.tally.waited(begin.elapsed());
        let mut at = starts(&counts);
        for tree in &mut trees {
            for (place, rank) in tree.summits() {
                let start = &mut at[rank as usize];
                tree.take(place, &words[*start..*start + width]);
                *start += width;
            }
        }
        trees.into_iter().map(|tree| tree.sum(&plus)).collect()
    }

    /// Numbers of an order of things, each of one rank, for all: that rank's `own` in the order.
    pub fn rows<T: Words>(&self, of: &[u32], own: &[T], width: usize) -> Vec<T> {
        let mut words = Vec::new();
        own.iter().for_each(|one| one.put(&mut words));
        let mut counts = vec![0; self.division.ranks as usize];
        of.iter().for_each(|&rank| counts[rank as usize] += width);
        let words = self.exchange.gather(&words, &counts, To::All);
        let mut at = starts(&counts);
        of.iter()
            .map(|&rank| {
                let start = &mut at[rank as usize];
                *start += width;
                T::take(&words[*start - width..*start])
            })
            .collect()
    }

    /// Each rank's number, for all.
    pub fn each(&self, own: f64) -> Vec<f64> {
        self.exchange.gather(&[own], &vec![1; self.division.ranks as usize], To::All)
    }

    /// Brings together what is cut into pieces of one rank each.
    fn pieces<T: Words>(
        &self,
        all: &mut [T],
        width: usize,
        pieces: impl Iterator<Item = (u32, Range<usize>)> + Clone,
        to: To,
    ) {
        if all.is_empty() {
            return;
        }
        let mut counts = vec![0; self.division.ranks as usize];
        let mut own = Vec::new();
        for (rank, range) in pieces.clone() {
            counts[rank as usize] += width * range.len();
            if rank == self.rank() {
                all[range].iter().for_each(|one| one.put(&mut own));
            }
        }
        let words = self.exchange.gather(&own, &counts, to);
        if words.is_empty() {
            return;
        }
        let mut at = starts(&counts);
        for (rank, range) in pieces {
            let start = &mut at[rank as usize];
            let end = *start + width * range.len();
            if rank != self.rank() {
                for (one, words) in all[range].iter_mut().zip(words[*start..end].chunks_exact(width)) {
                    *one = T::take(words);
                }
            }
            *start = end;
        }
    }

    /// Brings together rows of all nodes, each from who adds up there.
    pub fn nodes(&self, model: &Model, rows: &mut [Row], to: To) {
        let blocks = self.division.of_block.iter().copied().zip(&model.nodes.blocks);
        self.pieces(rows, 4, blocks.map(|(rank, block)| (rank, block.nodes.clone())), to);
    }

    /// Brings together what members have, which lies so in their slices.
    pub fn members<T: Words>(
        &self,
        assembly: &Assembly,
        all: &mut [T],
        width: usize,
        range: impl Fn(&Slices) -> Range<usize> + Clone,
        to: To,
    ) {
        self.some_members(assembly, |_| true, all, width, range, to);
    }

    /// The same of those members alone for which `wanted` holds, on all ranks alike.
    pub fn some_members<T: Words>(
        &self,
        assembly: &Assembly,
        wanted: impl Fn(u32) -> bool + Clone,
        all: &mut [T],
        width: usize,
        range: impl Fn(&Slices) -> Range<usize> + Clone,
        to: To,
    ) {
        let members = (0u32..).zip(self.division.of_member.iter().copied()).zip(&assembly.slices);
        let some = members.filter(|((m, _), _)| wanted(*m));
        self.pieces(all, width, some.map(|((_, rank), slices)| (rank, range(slices))), to);
    }

    /// Makes a state whole.
    pub fn whole(&self, model: &Model, assembly: &Assembly, state: &mut State, to: To) {
        let State { u, du, datum, held, start, .. } = state;
        for rows in [u, du, datum, held, start] {
            self.nodes(model, rows, to);
        }
        let State {
            history,
            overstress,
            numbers,
            reference,
            initial,
            carried,
            carried_hourglass,
            ledger,
            ..
        } = state;
        self.members(assembly, history, 8, |s| s.history.clone(), to);
        self.members(assembly, overstress, 8, |s| s.overstress.clone(), to);
        self.members(assembly, numbers, 1, |s| s.numbers.clone(), to);
        self.members(assembly, reference, 4, |s| s.reference.clone(), to);
        self.members(assembly, initial, 8, |s| s.initial.clone(), to);
        self.members(assembly, carried, 4, |s| s.contributions.clone(), to);
        self.members(assembly, carried_hourglass, 4, |s| s.contributions.clone(), to);
        let width = ledger.width();
        let of_members =
            self.division.of_member.iter().copied().enumerate().map(|(m, rank)| (rank, m..m + 1));
        self.pieces(&mut ledger.members, Line::ALL.len(), of_members, to);
        let of_blocks = self.division.of_block.iter().copied().enumerate();
        let of_blocks = of_blocks.map(|(b, rank)| (rank, width * b..width * (b + 1)));
        self.pieces(&mut ledger.blocks, 1, of_blocks, to);
    }

    /// Makes what a rank does not have of a state not a number to it, if it is poisoned.
    pub(crate) fn poison(&self, assembly: &Assembly, phase: &Phase, state: &mut State) {
        if !self.poisoned {
            return;
        }
        let State { u, du, datum, held, start, .. } = state;
        for rows in [u, du, datum, held, start] {
            let unknown = (0u32..).zip(rows).filter(|(n, _)| !phase.holds(*n));
            unknown.for_each(|(_, row)| *row = UNKNOWN);
        }
        let State {
            history,
            overstress,
            numbers,
            reference,
            initial,
            carried,
            carried_hourglass,
            ledger,
            ..
        } = state;
        let width = ledger.width();
        let nan = f64::NAN;
        for ((m, &rank), slices) in self.division.of_member.iter().enumerate().zip(&assembly.slices) {
            if rank == self.rank() {
                continue;
            }
            history[slices.history.clone()].fill(Octet([nan; 8]));
            overstress[slices.overstress.clone()].fill(Octet([nan; 8]));
            numbers[slices.numbers.clone()].fill(nan);
            reference[slices.reference.clone()].fill(UNKNOWN);
            initial[slices.initial.clone()].fill(Octet([nan; 8]));
            for rows in [&mut *carried, &mut *carried_hourglass].into_iter().filter(|rows| !rows.is_empty()) {
                rows[slices.contributions.clone()].fill(UNKNOWN);
            }
            ledger.members[m].values_mut().for_each(|x| *x = nan);
        }
        for (b, &rank) in self.division.of_block.iter().enumerate() {
            if rank != self.rank() {
                ledger.blocks[width * b..width * (b + 1)].fill(nan);
            }
        }
    }
}

/// What is not known; the fourth number is no component.
const UNKNOWN: Row = Row([f64::NAN, f64::NAN, f64::NAN, 0.0]);

/// Where each rank's numbers begin among all.
fn starts(counts: &[usize]) -> Vec<usize> {
    let mut at = 0;
    let start = |&count: &usize| {
        at += count;
        at - count
    };
    counts.iter().map(start).collect()
}
