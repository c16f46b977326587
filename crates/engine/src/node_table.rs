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

/// Nodes that are worked on and added up together: of those that a patch touches first, the ones that no other patch touches, or the
/// others. A model has the same blocks in all phases, so that sums over its nodes are the same bits wherever they are made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Block {
    pub domain: Domain,
    pub nodes: Range<usize>,
}

/// The engine nodes of a model, in the order in which the patches first touch them; of each patch those first that no other touches.
#[derive(Clone, Debug, Default)]
pub struct Nodes {
    /// All nodes, ascending.
    pub blocks: Vec<Block>,
    /// What each belongs to.
    pub domain: Vec<Domain>,
    /// The level of its step: 0, the finest there is, for all so far.
    pub level: Vec<u8>,
    /// Who advances it: 0, this process, for all so far.
    pub owner: Vec<u32>,
}

impl Nodes {
    /// One more block, on the finest level and this process's own.
    pub(crate) fn push(&mut self, domain: Domain, count: usize) {
        if count == 0 {
            return;
        }
        let nodes = self.len()..self.len() + count;
        self.domain.resize(nodes.end, domain);
        self.level.resize(nodes.end, 0);
        self.owner.resize(nodes.end, 0);
        self.blocks.push(Block { domain, nodes });
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
