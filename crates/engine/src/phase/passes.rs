//! The order in which the nodes of a phase are advanced.

use crate::model::Model;
use crate::node_table::Domain;
use crate::phase::Dashpot;
use std::ops::Range;

/// Nodes a block: the unit of threads and of sums, whatever the number of threads.
pub const BLOCK: usize = 2048;

/// Nodes that one thread advances.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Block {
    pub nodes: Range<usize>,
    /// Whether they are the model's own, so that their energy is in the balance.
    pub counts: bool,
    /// Which of [`Phase::leaders`](crate::Phase::leaders) are among them.
    pub leaders: Range<usize>,
}

/// Blocks that may be advanced side by side. Passes follow one another.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Pass {
    /// Ascending.
    pub blocks: Vec<Block>,
}

impl Pass {
    /// Number of its nodes.
    pub fn nodes(&self) -> usize {
        self.blocks.iter().map(|block| block.nodes.len()).sum()
    }
}

/// The leaders that some dashpots follow, in the order in which they are advanced, and the passes of all nodes: columns, slabs,
/// the model where slabs stand outside it, else all at once.
pub fn passes<'d>(model: &Model, dashpots: impl Iterator<Item = &'d Dashpot>) -> (Vec<u32>, Vec<Pass>) {
    let order: &[&[Domain]] = match model.slabs.is_empty() {
        true => &[&[Domain::Model, Domain::Column]],
        false => &[&[Domain::Column], &[Domain::Slab], &[Domain::Model]],
    };
    let rank = |node: u32| order.iter().position(|of| of.contains(&model.nodes.domain[node as usize]));
    let mut leaders: Vec<u32> =
        dashpots.flat_map(|dashpot| &dashpot.follows).map(|follow| follow.leader).collect();
    leaders.sort_unstable_by_key(|&node| (rank(node), node));
    leaders.dedup();
    let mut passes = Vec::new();
    let mut next = 0;
    for domains in order {
        let mut pass = Pass::default();
        for &domain in *domains {
            for nodes in blocks(&mut model.nodes.of(domain)) {
                let count = leaders[next..].iter().take_while(|&&n| nodes.contains(&(n as usize))).count();
                pass.blocks.push(Block {
                    nodes,
                    counts: domain == Domain::Model,
                    leaders: next..next + count,
                });
                next += count;
            }
        }
        passes.push(pass);
    }
    (leaders, passes)
}

/// Ascending nodes cut where their numbers jump, and into blocks.
fn blocks(nodes: &mut dyn Iterator<Item = usize>) -> Vec<Range<usize>> {
    let mut blocks: Vec<Range<usize>> = Vec::new();
    for node in nodes {
        match blocks.last_mut() {
            Some(last) if last.end == node && last.len() < BLOCK => last.end += 1,
            _ => blocks.push(node..node + 1),
        }
    }
    blocks
}
