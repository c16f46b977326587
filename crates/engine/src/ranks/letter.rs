//! Many things that ranks have, in one message: what the first rank is shown of a look.

use super::{Ranks, Words, starts};
use crate::assembly::{Assembly, Slices};
use crate::exchange::To;
use crate::model::Model;
use std::ops::Range;
use tremolite_laws::Row;

/// Which of some that are numbered from 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Marks {
    All,
    /// By number, whether it is one of them.
    Some(Vec<bool>),
}

impl Default for Marks {
    fn default() -> Self {
        Marks::Some(Vec::new())
    }
}

impl Marks {
    pub fn has(&self, one: usize) -> bool {
        match self {
            Marks::All => true,
            Marks::Some(marks) => marks.get(one).copied().unwrap_or(false),
        }
    }

    /// Adds one to `Some`.
    pub fn mark(&mut self, one: usize) {
        if let Marks::Some(marks) = self {
            if marks.len() <= one {
                marks.resize(one + 1, false);
            }
            marks[one] = true;
        }
    }

    /// Adds others.
    pub fn join(&mut self, others: &Marks) {
        match (&mut *self, others) {
            (Marks::All, _) => {}
            (_, Marks::All) => *self = Marks::All,
            (Marks::Some(own), Marks::Some(others)) => {
                if own.len() < others.len() {
                    own.resize(others.len(), false);
                }
                own.iter_mut().zip(others).for_each(|(own, other)| *own |= other);
            }
        }
    }
}

/// What the first of several ranks is shown in a look; the same on all ranks.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Wanted {
    /// Blocks of nodes whose motion it sees.
    pub blocks: Marks,
    /// Members of which it sees stresses, energies and all that they remember.
    pub members: Marks,
    /// Members of which it sees what laws remember at points.
    pub histories: Marks,
}

impl Wanted {
    pub const ALL: Wanted = Wanted { blocks: Marks::All, members: Marks::All, histories: Marks::All };

    /// Adds what others want.
    pub fn join(&mut self, others: &Wanted) {
        self.blocks.join(&others.blocks);
        self.members.join(&others.members);
        self.histories.join(&others.histories);
    }
}

/// Numbers that each rank writes for one message, thing after thing.
pub struct Letter<'r> {
    ranks: &'r Ranks,
    counts: Vec<usize>,
    own: Vec<f64>,
}

/// A letter as it arrived: things are taken out of it in the order in which they were put in.
pub struct Arrived<'r> {
    ranks: &'r Ranks,
    words: Vec<f64>,
    at: Vec<usize>,
}

impl Ranks {
    /// An empty letter.
    pub fn letter(&self) -> Letter<'_> {
        Letter { ranks: self, counts: vec![0; self.division.ranks as usize], own: Vec::new() }
    }

    fn blocks_of<'a>(
        &'a self,
        model: &'a Model,
        wanted: &'a Marks,
    ) -> impl Iterator<Item = (u32, Range<usize>)> {
        let blocks = self.division.of_block.iter().zip(&model.nodes.blocks).enumerate();
        blocks.filter(|(b, _)| wanted.has(*b)).map(|(_, (&rank, block))| (rank, block.nodes.clone()))
    }

    fn members_of<'a>(&'a self, wanted: &'a Marks) -> impl Iterator<Item = (u32, usize)> {
        let members = self.division.of_member.iter().enumerate();
        members.filter(|(m, _)| wanted.has(*m)).map(|(m, &rank)| (rank, m))
    }
}

impl<'r> Letter<'r> {
    /// Numbers of nodes of some blocks, each from who adds up there.
    pub fn nodes<T: Words>(&mut self, model: &Model, wanted: &Marks, rows: &[T], width: usize) {
        for (rank, nodes) in self.ranks.blocks_of(model, wanted) {
            self.counts[rank as usize] += width * nodes.len();
            if rank == self.ranks.rank() {
                rows[nodes].iter().for_each(|row| row.put(&mut self.own));
            }
        }
    }

    /// What some members have, where `own` has it as this rank holds it.
    pub fn members<T: Words>(
        &mut self,
        (assembly, wanted): (&Assembly, &Marks),
        own: &[T],
        width: usize,
        range: impl Fn(&Slices) -> Range<usize>,
    ) {
        for (rank, m) in self.ranks.members_of(wanted) {
            self.counts[rank as usize] += width * range(&assembly.slices[m]).len();
            if rank == self.ranks.rank() {
                own[range(&assembly.held[m])].iter().for_each(|one| one.put(&mut self.own));
            }
        }
    }

    /// Sends it to the first rank, and gives it back there; nobody is told where there is nothing in it.
    pub fn send(self) -> Option<Arrived<'r>> {
        let Letter { ranks, counts, own } = self;
        if counts.iter().all(|&count| count == 0) {
            return ranks.is_first().then(|| Arrived { ranks, words: Vec::new(), at: counts });
        }
        let words = ranks.exchange.gather(&own, &counts, To::First);
        ranks.is_first().then(|| Arrived { ranks, words, at: starts(&counts) })
    }
}

impl Arrived<'_> {
    fn next(&mut self, rank: u32, count: usize) -> &[f64] {
        let start = self.at[rank as usize];
        self.at[rank as usize] += count;
        &self.words[start..start + count]
    }

    pub fn nodes(&mut self, model: &Model, wanted: &Marks, rows: &mut [Row]) {
        let ranks = self.ranks;
        for (rank, nodes) in ranks.blocks_of(model, wanted) {
            let words = self.next(rank, 4 * nodes.len());
            if rank > 0 {
                rows[nodes].iter_mut().zip(words.chunks_exact(4)).for_each(|(row, w)| *row = Row::take(w));
            }
        }
    }

    /// Numbers of nodes.
    pub fn numbers_of_nodes(&mut self, model: &Model, wanted: &Marks, numbers: &mut [f64]) {
        let ranks = self.ranks;
        for (rank, nodes) in ranks.blocks_of(model, wanted) {
            numbers[nodes.clone()].copy_from_slice(self.next(rank, nodes.len()));
        }
    }

    /// What some members have, laid where all members' lies in one process.
    pub fn members<T: Words>(
        &mut self,
        (assembly, wanted): (&Assembly, &Marks),
        all: &mut [T],
        width: usize,
        range: impl Fn(&Slices) -> Range<usize>,
    ) {
        let ranks = self.ranks;
        for (rank, m) in ranks.members_of(wanted) {
            let range = range(&assembly.slices[m]);
            let words = self.next(rank, width * range.len());
            all[range].iter_mut().zip(words.chunks_exact(width)).for_each(|(one, w)| *one = T::take(w));
        }
    }
}
