//! What one of several ranks has of a phase.
//!
//! A rank evaluates its own members and moves all nodes that they push or read, with those that these follow: masters of what is tied, and leaders.
//! So several ranks move the same node, to the same bits, since each adds up the same contributions in the order of parts; and one
//! message a step does, of the single contributions that others need. Sums of contributions would not do: they would be other bits.

use super::beats::{Border, Drifting};
use super::{Beat, ElementSlot, Phase};
use crate::assembly::Assembly;
use crate::division::Division;
use crate::exchange::Halo;
use crate::free_field::Leader;
use crate::model::Model;
use crate::parts::UNKNOWN;
use std::collections::BTreeMap;
use tremolite_laws::Row;

/// What a rank has of a phase besides its beats.
#[derive(Clone, Debug, Default)]
pub struct Ours {
    /// Members that are there and that it evaluates, ascending.
    pub members: Vec<u32>,
    /// Whether it moves each node.
    pub holds: Vec<bool>,
    /// Blocks of which it moves a node, ascending.
    pub blocks: Vec<u32>,
    /// What is exchanged in each beat.
    pub halos: Vec<Slots>,
    /// Contributions of others that it receives, which lie behind its own.
    pub received: usize,
}

/// Numbers of a row that are exchanged; the fourth is none.
pub const WIDTH: usize = 3;

/// Contributions that are exchanged.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Slots {
    pub halo: Halo,
    /// Which, rank by rank.
    pub send: Vec<u32>,
    pub receive: Vec<u32>,
    /// Which members of the beat have some to send, by their place in it: they are evaluated first.
    pub early: Vec<bool>,
}

/// What a rank moves and sends.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Traffic {
    /// Nodes that it moves, those that others move as well included.
    pub nodes: usize,
    /// Ranks that it sends contributions to.
    pub neighbours: usize,
    /// Bytes that it sends them in a step of the finest level, in the mean.
    pub bytes: f64,
}

/// No member: a contribution of none that is there.
const NOBODY: u32 = u32::MAX;

impl Phase {
    /// What a rank has of it.
    #[must_use]
    pub fn of_rank(&self, model: &Model, assembly: &Assembly, division: &Division, rank: u32) -> Self {
        let of = |m: u32| division.of_member[m as usize];
        let holders = self.holders(model, assembly, division);
        let holds: Vec<bool> = holders.iter().map(|all| all.contains(&rank)).collect();
        let of_blocks = (0u32..).zip(&model.nodes.blocks);
        let blocks: Vec<u32> = of_blocks
            .filter(|(_, block)| holds[block.nodes.clone()].contains(&true))
            .map(|(b, _)| b)
            .collect();
        let mut has = vec![false; model.nodes.blocks.len()];
        blocks.iter().for_each(|&b| has[b as usize] = true);
        // What drifts elsewhere is left out, and what drifts here as well as elsewhere is booked once.
        let mut borders = Vec::new();
        let mut before = vec![0];
        for border in &self.borders {
            let n = border.node as usize;
            if holds[n] {
                let block = model.nodes.blocks.partition_point(|block| block.nodes.end <= n);
                let counts = border.counts && division.of_block[block] == rank;
                borders.push(Border { counts, ..border.clone() });
            }
            before.push(borders.len());
        }
        let drifting = |beat: &Beat| {
            let own = beat.drifting.iter().map(|one| Drifting {
                borders: before[one.borders.start]..before[one.borders.end],
                ..one.clone()
            });
            own.filter(|one| !one.borders.is_empty()).collect()
        };
        let beats: Vec<Beat> = self
            .beats
            .iter()
            .map(|beat| Beat {
                coarsest: beat.coarsest,
                active: beat.active.iter().copied().filter(|&m| of(m) == rank).collect(),
                passes: beat.passes.iter().map(|pass| pass.of_rank(&has, &division.of_block, rank)).collect(),
                given: beat.given.clone(),
                tied: beat.tied.iter().copied().filter(|&(node, _)| holds[node as usize]).collect(),
                drifting: drifting(beat),
            })
            .collect();
        let mut of_slot = vec![NOBODY; assembly.totals().contributions.end];
        for &m in &self.active {
            of_slot[assembly.slices[m as usize].contributions.clone()].fill(m);
        }
        let whole = Whole { phase: self, model, division, holders, of_slot };
        let mut halos: Vec<Slots> = (0..beats.len()).map(|k| whole.slots(k, &beats[k], rank)).collect();
        let members: Vec<u32> = self.active.iter().copied().filter(|&m| of(m) == rank).collect();
        // From here on contributions are numbered as they lie on this rank.
        let own = assembly.held_totals().contributions.end;
        let mut place = vec![u32::MAX; assembly.totals().contributions.end];
        for &m in &members {
            let [all, held] =
                [&assembly.slices, &assembly.held].map(|all| all[m as usize].contributions.clone());
            all.zip(held).for_each(|(slot, held)| place[slot] = held as u32);
        }
        let mut received = 0;
        for &slot in halos.iter().flat_map(|slots| &slots.receive) {
            if place[slot as usize] == u32::MAX {
                place[slot as usize] = (own + received) as u32;
                received += 1;
            }
        }
        // What it does not know is not a number.
        let unknown = (own + received) as u32;
        let now = |slot: &mut u32| *slot = place[*slot as usize].min(unknown);
        halos.iter_mut().flat_map(|slots| slots.send.iter_mut().chain(&mut slots.receive)).for_each(now);
        // Nodes that it does not move have no contributions here, so that nobody moves them.
        let (mut start, mut slot, mut slot_account) = (vec![0], Vec::new(), Vec::new());
        for (n, holds) in holds.iter().enumerate() {
            if *holds {
                let all = self.start[n] as usize..self.start[n + 1] as usize;
                slot.extend_from_slice(&self.slot[all.clone()]);
                slot_account.extend_from_slice(&self.slot_account[all]);
            }
            start.push(slot.len() as u32);
        }
        slot.iter_mut().for_each(now);
        let mut pushes = self.pushes.clone();
        pushes.iter_mut().for_each(|push| now(&mut push.slot));
        let ours = Ours { members, holds, blocks, halos, received };
        let element_slot =
            self.element_slot.iter().map(|slot| held(slot.as_ref()?, assembly, division, rank));
        let element_slot = element_slot.collect();
        Phase {
            beats,
            start,
            slot,
            slot_account,
            borders,
            pushes,
            element_slot,
            ours: Some(ours),
            ..self.clone()
        }
    }

    /// Room for the contributions of all parts; on a rank for its own, for those that it receives, and one that is not a number for all
    /// others.
    pub(crate) fn room(&self, assembly: &Assembly) -> Vec<Row> {
        let mut room = vec![Row::ZERO; assembly.held_totals().contributions.end];
        if let Some(ours) = &self.ours {
            room.resize(room.len() + ours.received, Row::ZERO);
            room.push(UNKNOWN);
        }
        room
    }

    /// What each rank moves and sends.
    pub fn traffic(&self, model: &Model, assembly: &Assembly, division: &Division) -> Vec<Traffic> {
        let holders = self.holders(model, assembly, division);
        let mut of_slot = vec![0; assembly.totals().contributions.end];
        for &m in &self.active {
            of_slot[assembly.slices[m as usize].contributions.clone()].fill(division.of_member[m as usize]);
        }
        let mut all = vec![Traffic::default(); division.ranks as usize];
        holders.iter().flatten().for_each(|&rank| all[rank as usize].nodes += 1);
        let share = |level: u8| if self.beats.len() > 1 { 1.0 / f64::from(1u32 << level) } else { 1.0 };
        let mut sent: BTreeMap<(u32, u32), f64> = BTreeMap::new();
        let mut send = |slot: u32, to: u32, share: f64| {
            let from = of_slot[slot as usize];
            if from != to {
                *sent.entry((from, to)).or_default() += share;
            }
        };
        for (n, holders) in holders.iter().enumerate() {
            for &slot in &self.slot[self.start[n] as usize..self.start[n + 1] as usize] {
                holders.iter().for_each(|&to| send(slot, to, share(model.nodes.level[n])));
            }
        }
        for border in self.borders.iter().filter(|border| border.counts) {
            let n = border.node as usize;
            let block = model.nodes.blocks.partition_point(|block| block.nodes.end <= n);
            for push in self.pushes(border) {
                send(push.slot, division.of_block[block], share(push.level) - share(border.level));
            }
        }
        for ((from, _), slots) in sent {
            let own = &mut all[from as usize];
            own.neighbours += 1;
            own.bytes += (8 * WIDTH) as f64 * slots;
        }
        all
    }

    /// The ranks that move each node.
    fn holders(&self, model: &Model, assembly: &Assembly, division: &Division) -> Vec<Vec<u32>> {
        let mut holders: Vec<Vec<u32>> = vec![Vec::new(); self.master.len()];
        for (block, &rank) in model.nodes.blocks.iter().zip(&division.of_block) {
            block.nodes.clone().for_each(|n| holders[n].push(rank));
        }
        for &m in &self.active {
            let (member, rank) = (&assembly.members[m as usize], division.of_member[m as usize]);
            for &node in member.part.nodes().iter().chain(&member.reads.nodes) {
                add(&mut holders[node as usize], rank);
            }
        }
        let follows = self.dashpots.iter().flat_map(|(node, dashpot)| {
            let leaders = dashpot.follows.iter().filter_map(|follow| match follow.leader {
                Leader::Node(leader) => Some(leader),
                Leader::Given(_) => None,
            });
            leaders.map(|leader| (*node, leader))
        });
        let links: Vec<(u32, u32)> = self.tied.iter().copied().chain(follows).collect();
        loop {
            let mut grown = false;
            for &(from, to) in &links {
                for rank in holders[from as usize].clone() {
                    grown |= add(&mut holders[to as usize], rank);
                }
            }
            if !grown {
                return holders;
            }
        }
    }
}

/// Where the results of an element lie on a rank; nothing of another's.
fn held(slot: &ElementSlot, assembly: &Assembly, division: &Division, rank: u32) -> Option<ElementSlot> {
    let m = slot.member as usize;
    let (all, held) = (&assembly.slices[m], &assembly.held[m]);
    (division.of_member[m] == rank).then(|| ElementSlot {
        point: slot.point - all.points.start as u32 + held.points.start as u32,
        element: slot.element - all.elements.start as u32 + held.elements.start as u32,
        ..*slot
    })
}

/// Adds a rank to some, unless it is among them.
fn add(all: &mut Vec<u32>, rank: u32) -> bool {
    let new = !all.contains(&rank);
    if new {
        all.push(rank);
    }
    new
}

/// A phase as all ranks see it.
struct Whole<'a> {
    phase: &'a Phase,
    model: &'a Model,
    division: &'a Division,
    /// The ranks that move each node.
    holders: Vec<Vec<u32>>,
    /// The member whose each contribution is.
    of_slot: Vec<u32>,
}

impl Whole<'_> {
    /// What a rank exchanges in a beat, which is `own` of that rank: what all parts evaluated do to nodes at their own times, for all that
    /// move them; and what they do to nodes that drift, for who adds up there.
    fn slots(&self, number: usize, own: &Beat, rank: u32) -> Slots {
        let Whole { phase, model, division, holders, of_slot } = self;
        let beat = &phase.beats[number];
        let one = phase.beats.len() == 1;
        let ranks = division.ranks as usize;
        let (mut send, mut receive) = (vec![Vec::new(); ranks], vec![Vec::new(); ranks]);
        let mut sends = vec![false; division.of_member.len()];
        let mut pass = |slot: u32, to: u32| {
            let member = of_slot[slot as usize];
            let from = division.of_member[member as usize];
            if from == to {
                return;
            }
            if from == rank {
                send[to as usize].push(slot);
                sends[member as usize] = true;
            } else if to == rank {
                receive[from as usize].push(slot);
            }
        };
        for (n, holders) in holders.iter().enumerate() {
            if one || model.nodes.level[n] <= beat.coarsest {
                for &slot in &phase.slot[phase.start[n] as usize..phase.start[n + 1] as usize] {
                    holders.iter().for_each(|&to| pass(slot, to));
                }
            }
        }
        for drifting in &beat.drifting {
            for border in phase.borders[drifting.borders.clone()].iter().filter(|border| border.counts) {
                let pushes = phase.pushes(border).iter().filter(|push| push.level <= beat.coarsest);
                pushes.for_each(|push| pass(push.slot, division.of_block[drifting.block]));
            }
        }
        let words = |all: &[Vec<u32>]| all.iter().map(|one| WIDTH * one.len()).collect::<Vec<_>>();
        Slots {
            halo: Halo::new(words(&send).into_iter(), words(&receive).into_iter()),
            send: send.concat(),
            receive: receive.concat(),
            early: own.active.iter().map(|&m| sends[m as usize]).collect(),
        }
    }
}
