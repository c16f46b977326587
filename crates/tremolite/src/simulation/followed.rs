//! Nodes that observers follow step by step, on several ranks: the first is told of them by who moves them.

use crate::observers::Which;
use tremolite_engine::exchange::Halo;
use tremolite_engine::state::State;
use tremolite_engine::{Model, Ranks};
use tremolite_laws::Row;

/// What is told in every step.
pub(super) struct Followed {
    halo: Halo,
    send: Vec<u32>,
    receive: Vec<u32>,
}

/// Numbers a node: u, its increment, and u at t = 0.
const WIDTH: usize = 9;

impl Followed {
    /// Nothing where nobody follows a node.
    pub fn of(model: &Model, ranks: &Ranks, which: &Which) -> Option<Self> {
        let nodes: Vec<u32> = match which {
            Which::Nothing => return None,
            Which::Some(nodes) => nodes.clone(),
            Which::All => (0..model.nodes.len() as u32).collect(),
        };
        let count = ranks.division.ranks as usize;
        let mut of_ranks = vec![Vec::new(); count];
        for node in nodes {
            let block = model.nodes.blocks.partition_point(|block| block.nodes.end <= node as usize);
            of_ranks[ranks.division.of_block[block] as usize].push(node);
        }
        of_ranks[0].clear();
        let own = std::mem::take(&mut of_ranks[ranks.rank() as usize]);
        let send = (0..count).map(|to| if to == 0 { WIDTH * own.len() } else { 0 });
        let receive = |from: usize| if ranks.is_first() { WIDTH * of_ranks[from].len() } else { 0 };
        let halo = Halo::new(send, (0..count).map(receive));
        let receive = if ranks.is_first() { of_ranks.concat() } else { Vec::new() };
        Some(Followed { halo, send: own, receive })
    }

    /// Tells the first rank.
    pub fn tell(&self, ranks: &Ranks, state: &mut State) {
        let mut words = Vec::with_capacity(WIDTH * self.send.len());
        for &node in &self.send {
            let node = node as usize;
            let datum = state.datum.get(node).copied().unwrap_or(Row::ZERO);
            [state.u[node], state.du[node], datum].iter().for_each(|row| words.extend(row.xyz()));
        }
        let told = ranks.halo(&self.halo, &words);
        for (&node, words) in self.receive.iter().zip(told.chunks_exact(WIDTH)) {
            let node = node as usize;
            let row = |k: usize| Row::new([words[k], words[k + 1], words[k + 2]]);
            (state.u[node], state.du[node]) = (row(0), row(3));
            if let Some(datum) = state.datum.get_mut(node) {
                *datum = row(6);
            }
        }
    }
}
