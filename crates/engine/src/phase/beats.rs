//! What takes part in a step, by the coarsest level that has an own step there.

use super::passes::Pass;
use crate::assembly::Assembly;
use crate::free_field::Leader;
use crate::model::Model;
use std::ops::Range;

/// What takes part in steps at which levels up to one have their own times.
#[derive(Clone, Debug, Default)]
pub struct Beat {
    /// The coarsest level that has an own time.
    pub coarsest: u8,
    /// Members that are evaluated, ascending.
    pub active: Vec<u32>,
    /// Nodes that are advanced, leaders first.
    pub passes: Vec<Pass>,
    /// Those of a given free field that somebody who is advanced follows: places in [`Phase::leaders`](crate::Phase::leaders).
    pub given: Vec<u32>,
    /// (tied node, master) of those that are advanced.
    pub tied: Vec<(u32, u32)>,
    /// Nodes between their own times that move all the same, by block.
    pub drifting: Vec<Drifting>,
}

/// Nodes of a block that drift.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Drifting {
    /// The number of the block.
    pub block: usize,
    pub nodes: Range<usize>,
    /// Which of [`Phase::borders`](crate::Phase::borders) they are.
    pub borders: Range<usize>,
}

/// A node with longer steps than a part has that pushes or reads it: it goes on in all steps of the finest level.
#[derive(Clone, Debug, PartialEq)]
pub struct Border {
    pub node: u32,
    /// Its level, at least 1.
    pub level: u8,
    /// Whether it is the model's own, so that work on it is in the balance; on one of several ranks, whether that rank books it.
    pub counts: bool,
    /// Which of [`Phase::pushes`](crate::Phase::pushes) are contributions of such parts to it.
    pub pushes: Range<u32>,
}

/// A contribution of a part with shorter steps than the node that it pushes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Push {
    pub slot: u32,
    /// The part's level.
    pub level: u8,
    /// Its account, [`NO_ACCOUNT`](super::NO_ACCOUNT) if it has none.
    pub account: u16,
}

/// Steps of the finest level in one of a level.
pub fn span(level: u8) -> u64 {
    1 << level
}

/// Where nodes and parts of a phase meet, to see when they do.
pub struct Meeting<'a> {
    pub model: &'a Model,
    pub assembly: &'a Assembly,
    pub active: &'a [u32],
    pub master: &'a [u32],
    pub start: &'a [u32],
    pub slot: &'a [u32],
    pub slot_account: &'a [u16],
    pub tied: &'a [(u32, u32)],
    pub leaders: &'a [Leader],
    /// Of all levels.
    pub passes: Vec<Pass>,
}

impl Meeting<'_> {
    /// Nodes that drift, ascending, and what pushes them meanwhile.
    pub fn borders(&self) -> (Vec<Border>, Vec<Push>) {
        let Meeting { model, assembly, active, master, start, slot, slot_account, tied, .. } = self;
        let level = &model.nodes.level;
        if model.nodes.coarsest() == 0 {
            return (Vec::new(), Vec::new());
        }
        let mut drifts = vec![false; level.len()];
        // Whose each contribution is.
        let mut of_slot = vec![u8::MAX; assembly.totals().contributions.end];
        for &m in *active {
            let (member, slices) = (&assembly.members[m as usize], &assembly.slices[m as usize]);
            of_slot[slices.contributions.clone()].fill(member.level);
            for &node in member.part.nodes().iter().chain(&member.reads.nodes) {
                for n in [node, master[node as usize]] {
                    drifts[n as usize] |= level[n as usize] > member.level;
                }
            }
        }
        // What moves as one drifts as one.
        for &(node, of) in *tied {
            drifts[of as usize] |= drifts[node as usize];
        }
        for &(node, of) in *tied {
            drifts[node as usize] = drifts[of as usize];
        }
        let mut all = Vec::new();
        let border = |n: usize| {
            let first = all.len() as u32;
            let pushes = (start[n] as usize..start[n + 1] as usize).map(|at| Push {
                slot: slot[at],
                level: of_slot[slot[at] as usize],
                account: slot_account[at],
            });
            all.extend(pushes.filter(|push| push.level < level[n]));
            let pushes = first..all.len() as u32;
            Border { node: n as u32, level: level[n], counts: model.nodes.counts(n), pushes }
        };
        let borders = (0..level.len()).filter(|&n| drifts[n]).map(border).collect();
        (borders, all)
    }

    /// What takes part in every step where there is one level.
    pub fn one(self) -> Beat {
        let Meeting { active, tied, leaders, passes, .. } = self;
        let given = leaders.iter().take_while(|leader| matches!(leader, Leader::Given(_)));
        Beat {
            coarsest: 0,
            active: active.to_vec(),
            given: (0..given.count() as u32).collect(),
            passes: passes.into_iter().map(Pass::level).collect(),
            tied: tied.to_vec(),
            drifting: Vec::new(),
        }
    }

    /// What takes part in steps, by the coarsest level that does.
    pub fn beats(self, borders: &[Border]) -> Vec<Beat> {
        let Meeting { model, assembly, active, tied, leaders, passes, .. } = self;
        let level = |n: u32| model.nodes.level[n as usize];
        let of = |coarsest: u8| {
            let given = (0u32..).zip(leaders).take_while(|(_, leader)| matches!(leader, Leader::Given(_)));
            let given = given.filter(|(_, leader)| level(leader.node()) <= coarsest).map(|(place, _)| place);
            let mut drifting: Vec<Drifting> = Vec::new();
            let mut block = 0;
            for (b, border) in borders.iter().enumerate().filter(|(_, border)| border.level > coarsest) {
                let n = border.node as usize;
                while model.nodes.blocks[block].nodes.end <= n {
                    block += 1;
                }
                match drifting.last_mut().filter(|last| last.block == block) {
                    Some(last) => last.borders.end = b + 1,
                    None => {
                        let nodes = model.nodes.blocks[block].nodes.clone();
                        drifting.push(Drifting { block, nodes, borders: b..b + 1 });
                    }
                }
            }
            Beat {
                coarsest,
                active: active
                    .iter()
                    .copied()
                    .filter(|&m| assembly.members[m as usize].level <= coarsest)
                    .collect(),
                passes: passes.iter().map(|pass| pass.up_to(coarsest)).collect(),
                given: given.collect(),
                tied: tied.iter().copied().filter(|&(node, _)| level(node) <= coarsest).collect(),
                drifting,
            }
        };
        (0..=model.nodes.coarsest()).map(of).collect()
    }
}
