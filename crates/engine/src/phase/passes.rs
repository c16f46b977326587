//! The order in which the nodes of a phase are advanced.

use crate::free_field::Leader;
use crate::model::Model;
use crate::node_table::Domain;
use crate::phase::Dashpot;
use std::ops::Range;

/// A block ([`crate::node_table::Block`]) as it is advanced.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Turn {
    /// Its number among the model's.
    pub block: usize,
    pub nodes: Range<usize>,
    /// Whether its nodes are the model's own, so that their energy is in the balance; on one of several ranks, whether that rank books it.
    pub counts: bool,
    /// The level of its nodes.
    pub level: u8,
    /// Which of [`Phase::leaders`](crate::Phase::leaders) are among them.
    pub leaders: Range<usize>,
}

/// Blocks that may be advanced side by side. Passes follow one another.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Pass {
    /// Ascending.
    pub turns: Vec<Turn>,
    /// Which of them a thread takes together: blocks and nodes without a gap.
    pub shares: Vec<Range<usize>>,
}

/// Nodes that a thread takes together, unless one block has more: less would not be worth handing over.
const SHARE: usize = 1024;

impl Pass {
    /// Number of its nodes.
    pub fn nodes(&self) -> usize {
        self.turns.iter().map(|turn| turn.nodes.len()).sum()
    }

    /// Its blocks of levels up to this one.
    pub fn up_to(&self, coarsest: u8) -> Self {
        self.of(|turn| turn.level <= coarsest)
    }

    /// Those of its blocks that are wanted.
    pub fn of(&self, wanted: impl Fn(&Turn) -> bool) -> Self {
        let mut pass = Pass::default();
        self.turns.iter().filter(|turn| wanted(turn)).for_each(|turn| pass.push(turn.clone()));
        pass
    }

    /// Its blocks of which a rank has nodes (`has`, by block), whose energy is booked by the rank that the block is of alone.
    pub fn of_rank(&self, has: &[bool], of_block: &[u32], rank: u32) -> Self {
        let mut pass = self.of(|turn| has[turn.block]);
        pass.turns.iter_mut().for_each(|turn| turn.counts &= of_block[turn.block] == rank);
        pass
    }

    /// Its blocks on one level.
    pub fn level(mut self) -> Self {
        self.turns.iter_mut().for_each(|turn| turn.level = 0);
        self
    }

    fn push(&mut self, turn: Turn) {
        let at = self.turns.len();
        let fits = |share: &&mut Range<usize>| {
            let (first, last) = (&self.turns[share.start], &self.turns[share.end - 1]);
            (last.block + 1, last.nodes.end) == (turn.block, turn.nodes.start)
                && turn.nodes.end - first.nodes.start <= SHARE
        };
        match self.shares.last_mut().filter(fits) {
            Some(share) => share.end = at + 1,
            None => self.shares.push(at..at + 1),
        }
        self.turns.push(turn);
    }
}

/// The leaders that some dashpots follow, in the order in which they are advanced, and the passes of all nodes: columns, slabs,
/// the model where slabs stand outside it, else all at once.
pub fn passes<'d>(model: &Model, dashpots: impl Iterator<Item = &'d Dashpot>) -> (Vec<Leader>, Vec<Pass>) {
    let order: &[&[Domain]] = match model.outside.slabs.is_empty() {
        true => &[&[Domain::Model, Domain::Column]],
        false => &[&[Domain::Column], &[Domain::Slab], &[Domain::Model]],
    };
    let rank = |leader: Leader| match leader {
        Leader::Given(_) => None,
        Leader::Node(node) => order.iter().position(|of| of.contains(&model.nodes.domain[node as usize])),
    };
    let mut leaders: Vec<Leader> =
        dashpots.flat_map(|dashpot| &dashpot.follows).map(|follow| follow.leader).collect();
    leaders.sort_unstable_by_key(|&leader| (rank(leader), leader));
    leaders.dedup();
    let mut passes = Vec::new();
    let mut next = leaders.iter().take_while(|leader| matches!(leader, Leader::Given(_))).count();
    for domains in order {
        let mut pass = Pass::default();
        for (block, of) in model.nodes.blocks.iter().enumerate() {
            if !domains.contains(&of.domain) {
                continue;
            }
            let led =
                |leader: &&Leader| matches!(leader, Leader::Node(n) if of.nodes.contains(&(*n as usize)));
            let count = leaders[next..].iter().take_while(led).count();
            pass.push(Turn {
                block,
                nodes: of.nodes.clone(),
                counts: of.domain == Domain::Model,
                level: of.level,
                leaders: next..next + count,
            });
            next += count;
        }
        passes.push(pass);
    }
    (leaders, passes)
}
