//! How much memory a process holds of a model while it runs: counted, not measured.

use crate::assembly::Assembly;
use crate::phase::Phase;
use crate::state::State;
use tremolite_laws::Row;

/// Bytes that a process holds, but for the mesh and what else a model is made of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Bytes {
    /// Shapes of elements, pairs and bolts. This and the next two are, on one of several ranks, of its own parts.
    pub parts: usize,
    /// What these remember, and what they did at the hand-over.
    pub memory: usize,
    /// What they push with, those of others that are received included.
    pub pushes: usize,
    /// How all nodes move and what they weigh, and where all parts push, whoever has them: about the same on every rank.
    pub everywhere: usize,
}

impl Bytes {
    /// What ranks share.
    pub fn shared(&self) -> usize {
        self.parts + self.memory + self.pushes
    }
}

pub(crate) fn bytes(assembly: &Assembly, phase: &Phase, state: &State, pushes: [&[Row]; 2]) -> Bytes {
    let own = assembly.members.iter().enumerate().filter(|(m, _)| assembly.has(*m));
    let State { u, du, datum, held, start, history, overstress, numbers, reference, initial, .. } = state;
    let State { carried, carried_hourglass, .. } = state;
    let octets = size_of_val(&history[..]) + size_of_val(&overstress[..]) + size_of_val(&initial[..]);
    let rows = size_of_val(&reference[..]) + size_of_val(&carried[..]) + size_of_val(&carried_hourglass[..]);
    let of_members: usize = assembly
        .members
        .iter()
        .map(|member| {
            let places = size_of_val(member.part.nodes()) + size_of_val(&member.reads.nodes[..]);
            places + size_of_val(&member.masses[..]) + size_of_val(&member.springs[..])
        })
        .sum();
    let Phase { master, mass, inverse_mass, start: first, slot, account, others, slot_account, .. } = phase;
    let of_nodes = [u, du, datum, held, start, inverse_mass].map(|rows| size_of_val(&rows[..]));
    let of_phase = size_of_val(&master[..])
        + size_of_val(&mass[..])
        + size_of_val(&first[..])
        + size_of_val(&slot[..])
        + size_of_val(&account[..])
        + size_of_val(&others[..])
        + size_of_val(&slot_account[..]);
    Bytes {
        // Where parts push is counted of all.
        parts: own.map(|(_, member)| member.part.bytes() - size_of_val(member.part.nodes())).sum::<usize>()
            + assembly.begins_with(),
        memory: octets + rows + size_of_val(&numbers[..]),
        pushes: pushes.map(size_of_val).iter().sum(),
        everywhere: of_nodes.iter().sum::<usize>() + of_phase + of_members,
    }
}
