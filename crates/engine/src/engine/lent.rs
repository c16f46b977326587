//! What members of other ranks remember, of elements from which a rank's own take over.

use super::Engine;
use crate::assembly::Slices;
use crate::state::State;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use tremolite_laws::{Octet, Row};

/// Memory of some members, and where it lies.
#[derive(Default)]
pub(super) struct Lent {
    pub history: Vec<Octet>,
    pub reference: Vec<Row>,
    pub initial: Vec<Octet>,
    pub slices: HashMap<usize, Slices>,
}

impl Engine {
    /// What ranks lend one another as the phase's stage begins; nothing in one process.
    pub(super) fn lent(&self, state: &State) -> Lent {
        let Engine { model, assembly, phase, ranks: Some(ranks), .. } = self else { return Lent::default() };
        let of = &ranks.division.of_member;
        let begins =
            phase.active.iter().map(|&m| (m, &assembly.members[m as usize])).filter(|(_, member)| {
                let takes_over = member.kind.patch().is_some_and(|patch| model.patches[patch].takes_over);
                takes_over && member.life.born == phase.stage && member.life.is_later()
            });
        let mut readers: BTreeMap<u32, BTreeSet<u32>> = BTreeMap::new();
        for (m, member) in begins {
            for &element in &member.reads.elements {
                readers.entry(element).or_default().insert(of[m as usize]);
            }
        }
        let elsewhere = |e: &u32, owner: u32| {
            readers.get(e).is_some_and(|readers| readers.iter().any(|&reader| reader != owner))
        };
        let patches = model.patches.iter().zip(&assembly.of_patch);
        let mut some: Vec<u32> = patches
            .filter(|(patch, m)| patch.elements.iter().any(|e| elsewhere(e, of[**m as usize])))
            .map(|(_, &m)| m)
            .collect();
        some.sort_unstable();
        let mut last = Slices::default();
        let mut slices = HashMap::new();
        for &m in &some {
            last = last.followed_by(&assembly.slices[m as usize]);
            slices.insert(m as usize, last.clone());
        }
        Lent {
            history: ranks.lend(assembly, &some, &state.history, 8, |s| s.history.clone()),
            reference: ranks.lend(assembly, &some, &state.reference, 4, |s| s.reference.clone()),
            initial: ranks.lend(assembly, &some, &state.initial, 8, |s| s.initial.clone()),
            slices,
        }
    }
}
