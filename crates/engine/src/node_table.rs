//! What a model knows of each of its engine nodes.

use std::ops::Range;

/// What an element or a node belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Domain {
    /// What the user meshed: all that results and the balance are about.
    Model,
    /// Ground outside a free-field side.
    Slab,
    /// Ground at the ends of slabs, or a reference column.
    Column,
}

/// Nodes that are worked on and added up together: of those of one level that a patch touches first, the ones that no other patch
/// touches, or the others. A model has the same blocks in all phases, so that sums over its nodes are the same bits wherever they are made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Block {
    pub domain: Domain,
    /// The level of its nodes ([`Nodes::level`]).
    pub level: u8,
    pub nodes: Range<usize>,
}

/// The engine nodes of a model, in the order in which the patches first touch them; of each patch those first that no other touches.
#[derive(Clone, Debug, Default)]
pub struct Nodes {
    /// All nodes, ascending.
    pub blocks: Vec<Block>,
    /// What each belongs to.
    pub domain: Vec<Domain>,
    /// The level of its step in the shaking: that of level l is 2^l steps of the finest, 0.
    pub level: Vec<u8>,
}

impl Nodes {
    /// One more block.
    pub(crate) fn push(&mut self, domain: Domain, level: u8, count: usize) {
        if count == 0 {
            return;
        }
        let nodes = self.len()..self.len() + count;
        self.domain.resize(nodes.end, domain);
        self.level.resize(nodes.end, level);
        self.blocks.push(Block { domain, level, nodes });
    }

    /// The coarsest level of all.
    pub fn coarsest(&self) -> u8 {
        self.level.iter().copied().max().unwrap_or(0)
    }

    /// Number of all.
    pub fn len(&self) -> usize {
        self.domain.len()
    }

    pub fn is_empty(&self) -> bool {
        self.domain.is_empty()
    }

    /// Whether a node is the model's own, so that its energy is in the balance.
    pub fn counts(&self, node: usize) -> bool {
        self.domain[node] == Domain::Model
    }

    /// The nodes of a domain, ascending.
    pub fn of(&self, domain: Domain) -> impl Iterator<Item = usize> + Clone + '_ {
        self.domain.iter().enumerate().filter(move |(_, d)| **d == domain).map(|(n, _)| n)
    }
}
