//! One rank of several that work on one model: what it exchanges with the others, so that sums, looks and states are those of one process.
//!
//! Every rank holds the whole model and room for the motion of all nodes, of which it knows how those move that its own members push or read. Of
//! parts and what they remember it has its own alone. In steps contributions alone are exchanged; where stages meet, [nodes](Ranks::whole);
//! and where somebody looks or writes, the first rank is [given](Ranks::collect) what all remember for so long.

mod columns;
mod letter;
mod tally;
mod words;

pub use columns::Columns;
pub use letter::{Arrived, Letter, Marks, Wanted};
pub use tally::{Tally, Took};
pub use words::{Tree, Words};

use crate::assembly::{Assembly, Slices};
use crate::division::Division;
use crate::exchange::{Exchange, Halo, To, room};
use crate::model::Model;
use crate::parts::UNKNOWN;
use crate::phase::Phase;
use crate::phase::ours::{Slots, WIDTH};
use crate::soon::soon;
use crate::state::State;
use std::ops::Range;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Instant;
use tremolite_kernels::Line;
use tremolite_laws::Row;

/// So many contributions before they are sent they are asked for: they lie wherever their parts have left them.
const SENT_AHEAD: usize = 16;

/// A rank, and how the model is shared out among all.
pub struct Ranks {
    exchange: Arc<dyn Exchange>,
    pub division: Division,
    /// Whether what a rank does not have is not a number to it.
    poisoned: bool,
    pub tally: Tally,
    /// Room for the numbers of a message, kept from step to step.
    room: Mutex<Vec<f64>>,
}

impl Ranks {
    /// # Panics
    /// If the division is one for another number of ranks.
    pub fn new(exchange: Arc<dyn Exchange>, division: Division) -> Ranks {
        assert_eq!(exchange.ranks(), division.ranks, "the division is for as many ranks as there are");
        Ranks { exchange, division, poisoned: false, tally: Tally::default(), room: Mutex::default() }
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

    /// Whether what a rank does not have is not a number to it.
    pub(crate) fn is_poisoned(&self) -> bool {
        self.poisoned
    }

    fn room(&self) -> MutexGuard<'_, Vec<f64>> {
        self.room.lock().unwrap_or_else(PoisonError::into_inner)
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
        let mut words = words.to_vec();
        self.exchange.start(halo, &mut words);
        self.exchange.finish(halo, &mut words);
        words.truncate(halo.words()[1]);
        words
    }

    /// Begins to exchange contributions.
    pub(crate) fn start(&self, slots: &Slots, contributions: &[Row]) {
        let mut words = self.room();
        let count = WIDTH * slots.send.len();
        let own = room(&mut words, count).as_chunks_mut::<WIDTH>().0;
        for ((k, &slot), word) in slots.send.iter().enumerate().zip(own) {
            if let Some(&later) = slots.send.get(k + SENT_AHEAD) {
                soon(contributions, later as usize);
            }
            let [x, y, z, _] = contributions[slot as usize].0;
            *word = [x, y, z];
        }
        self.exchange.start(&slots.halo, &mut words);
        self.tally.sent(count);
    }

    /// Waits for those of others.
    pub(crate) fn finish(&self, slots: &Slots, contributions: &mut [Row]) {
        let begin = Instant::now();
        let mut words = self.room();
        self.exchange.finish(&slots.halo, &mut words);
        for (&slot, word) in slots.receive.iter().zip(words.as_chunks::<WIDTH>().0) {
            contributions[slot as usize] = Row::new(*word);
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

    /// What members have, each of one rank, member by member, where it is given: `own` has it as this rank holds it.
    pub fn members<T: Words + Clone + Default>(
        &self,
        assembly: &Assembly,
        own: &[T],
        width: usize,
        range: impl Fn(&Slices) -> Range<usize>,
        to: To,
    ) -> Vec<T> {
        let members = || self.division.of_member.iter().enumerate();
        let mut counts = vec![0; self.division.ranks as usize];
        let mut words = Vec::new();
        for (m, &rank) in members() {
            counts[rank as usize] += width * range(&assembly.slices[m]).len();
            if rank == self.rank() {
                own[range(&assembly.held[m])].iter().for_each(|one| one.put(&mut words));
            }
        }
        let words = self.exchange.gather(&words, &counts, to);
        if to == To::First && !self.is_first() {
            return Vec::new();
        }
        let mut all = vec![T::default(); range(&assembly.totals()).end];
        let mut at = starts(&counts);
        for (m, &rank) in members() {
            let all = &mut all[range(&assembly.slices[m])];
            let start = &mut at[rank as usize];
            let end = *start + width * all.len();
            for (one, words) in all.iter_mut().zip(words[*start..end].chunks_exact(width)) {
                *one = T::take(words);
            }
            *start = end;
        }
        all
    }

    /// Gives the first rank what members have, member by member, in pieces of so many numbers at most, unless one member has more. `own`
    /// puts items that this rank holds behind others.
    ///
    /// # Errors
    /// What `each` returns on the first rank; the others know nothing of it.
    pub fn stream<E>(
        &self,
        assembly: &Assembly,
        (width, range): (usize, impl Fn(&Slices) -> Range<usize>),
        at_once: usize,
        own: impl Fn(Range<usize>, &mut Vec<f64>),
        mut each: impl FnMut(&[f64]) -> Result<(), E>,
    ) -> Result<(), E> {
        let of = &self.division.of_member;
        let length = |m: usize| width * range(&assembly.slices[m]).len();
        let mut from = 0;
        while from < of.len() {
            let (mut end, mut sum) = (from, 0);
            while end < of.len() && (end == from || sum + length(end) <= at_once) {
                sum += length(end);
                end += 1;
            }
            let mut counts = vec![0; self.division.ranks as usize];
            let mut words = Vec::new();
            for m in from..end {
                counts[of[m] as usize] += length(m);
                if of[m] == self.rank() {
                    own(range(&assembly.held[m]), &mut words);
                }
            }
            let words = if sum > 0 { self.exchange.gather(&words, &counts, To::First) } else { Vec::new() };
            if self.is_first() && sum > 0 {
                let mut at = starts(&counts);
                let mut all = Vec::with_capacity(sum);
                for m in from..end {
                    let start = &mut at[of[m] as usize];
                    all.extend_from_slice(&words[*start..*start + length(m)]);
                    *start += length(m);
                }
                each(&all)?;
            }
            from = end;
        }
        Ok(())
    }

    /// What some members have, one after another, for all: `own` has it as this rank holds it.
    pub(crate) fn lend<T: Words>(
        &self,
        assembly: &Assembly,
        some: &[u32],
        own: &[T],
        width: usize,
        range: impl Fn(&Slices) -> Range<usize>,
    ) -> Vec<T> {
        let of = |m: u32| self.division.of_member[m as usize];
        let length = |m: u32| range(&assembly.slices[m as usize]).len();
        let each: Vec<u32> = some.iter().flat_map(|&m| std::iter::repeat_n(of(m), length(m))).collect();
        let lent = some.iter().filter(|m| of(**m) == self.rank());
        let lent: Vec<T> =
            lent.flat_map(|&m| own[range(&assembly.held[m as usize])].iter().cloned()).collect();
        if each.is_empty() { Vec::new() } else { self.rows(&each, &lent, width) }
    }

    /// Makes whole what a state has of nodes, and its books. What members remember stays with who evaluates them.
    pub fn whole(&self, model: &Model, state: &mut State, to: To) {
        let State { u, du, datum, held, start, ledger, .. } = state;
        for rows in [u, du, datum, held, start] {
            self.nodes(model, rows, to);
        }
        let width = ledger.width();
        let of_members =
            self.division.of_member.iter().copied().enumerate().map(|(m, rank)| (rank, m..m + 1));
        self.pieces(&mut ledger.members, Line::ALL.len(), of_members, to);
        let of_blocks = self.division.of_block.iter().copied().enumerate();
        let of_blocks = of_blocks.map(|(b, rank)| (rank, width * b..width * (b + 1)));
        self.pieces(&mut ledger.blocks, 1, of_blocks, to);
    }

    /// Gives a state all that members remember, where it is given, for as long as it is looked at or written; what this rank has
    /// itself comes back with [`Columns::give_back`].
    pub fn collect(&self, assembly: &Assembly, state: &mut State, to: To) -> Columns {
        let own = Columns::take(state);
        let Columns { history, overstress, numbers, reference, initial, carried, carried_hourglass } = &own;
        state.history = self.members(assembly, history, 8, |s| s.history.clone(), to);
        state.overstress = self.members(assembly, overstress, 8, |s| s.overstress.clone(), to);
        state.numbers = self.members(assembly, numbers, 1, |s| s.numbers.clone(), to);
        state.reference = self.members(assembly, reference, 4, |s| s.reference.clone(), to);
        state.initial = self.members(assembly, initial, 8, |s| s.initial.clone(), to);
        // Empty on all ranks, or on none that holds a part: a rank says so to who has none.
        if self.agree(u64::from(!carried.is_empty())) > 0 {
            state.carried = self.members(assembly, carried, 4, |s| s.contributions.clone(), to);
            state.carried_hourglass =
                self.members(assembly, carried_hourglass, 4, |s| s.contributions.clone(), to);
        }
        own
    }

    /// Makes what a rank does not have of a state not a number to it, if it is poisoned.
    pub(crate) fn poison(&self, phase: &Phase, state: &mut State) {
        if !self.poisoned {
            return;
        }
        let State { u, du, datum, held, start, ledger, .. } = state;
        for rows in [u, du, datum, held, start] {
            let unknown = (0u32..).zip(rows).filter(|(n, _)| !phase.holds(*n));
            unknown.for_each(|(_, row)| *row = UNKNOWN);
        }
        let width = ledger.width();
        let nan = f64::NAN;
        let others = self.division.of_member.iter().enumerate().filter(|(_, rank)| **rank != self.rank());
        others.for_each(|(m, _)| ledger.members[m].values_mut().for_each(|x| *x = nan));
        for (b, &rank) in self.division.of_block.iter().enumerate() {
            if rank != self.rank() {
                ledger.blocks[width * b..width * (b + 1)].fill(nan);
            }
        }
    }
}

/// Where a member's items of a kind lie.
pub type RangeOf = fn(&Slices) -> Range<usize>;

/// The slices of members that a [column](State::columns) of a state consists of, with numbers of each of its items; none of other columns.
pub fn of_members(column: &str) -> Option<(usize, RangeOf)> {
    Some(match column {
        "history" => (8, |s| s.history.clone()),
        "overstress" => (8, |s| s.overstress.clone()),
        "numbers" => (1, |s| s.numbers.clone()),
        "reference" => (4, |s| s.reference.clone()),
        "initial" => (8, |s| s.initial.clone()),
        "carried" | "carried_hourglass" => (4, |s| s.contributions.clone()),
        _ => return None,
    })
}

/// Where each rank's numbers begin among all.
fn starts(counts: &[usize]) -> Vec<usize> {
    let mut at = 0;
    let start = |&count: &usize| {
        at += count;
        at - count
    };
    counts.iter().map(start).collect()
}
