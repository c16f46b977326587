//! What a model knows of each of its engine nodes.

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

/// The engine nodes of a model, in the order in which the patches first touch them.
#[derive(Clone, Debug, Default)]
pub struct Nodes {
    /// What each belongs to.
    pub domain: Vec<Domain>,
    /// The level of its step: 0, the finest there is, for all so far.
    pub level: Vec<u8>,
    /// Who advances it: 0, this process, for all so far.
    pub owner: Vec<u32>,
}

impl Nodes {
    /// One more, on the finest level and this process's own.
    pub(crate) fn push(&mut self, domain: Domain) {
        self.domain.push(domain);
        self.level.push(0);
        self.owner.push(0);
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
