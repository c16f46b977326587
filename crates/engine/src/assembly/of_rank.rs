//! What one of several ranks has of an assembly.

use super::{Assembly, KEPT, slices};
use crate::division::Division;
use crate::member::Member;
use tremolite_laws::Row;

impl Assembly {
    /// What one of several ranks has of it: its own parts, and of those of others where they push alone. An assembly of a rank stays as it is.
    #[must_use]
    pub fn of_rank(&self, division: &Division, rank: u32) -> Self {
        if self.own.is_some() {
            return self.clone();
        }
        let own: Vec<bool> = division.of_member.iter().map(|&of| of == rank).collect();
        let members: Vec<Member> = self
            .members
            .iter()
            .zip(&own)
            .map(|(member, own)| if *own { member.clone() } else { member.absent() })
            .collect();
        let held = slices(&members, |m| own[m]);
        let mut initial = Vec::with_capacity(held.last().map_or(0, |s| s.initial.end));
        for (slices, _) in self.slices.iter().zip(&own).filter(|(_, own)| **own) {
            initial.extend_from_slice(&self.initial[slices.initial.clone()]);
        }
        let mut contacts = self.contacts.clone();
        for contacts in &mut contacts {
            let ranges =
                contacts.members.iter().map(|&m| own[m as usize].then(|| held[m as usize].history.clone()));
            contacts.held = ranges.collect();
        }
        Assembly {
            members,
            slices: self.slices.clone(),
            held,
            own: Some(own),
            of_patch: self.of_patch.clone(),
            contacts,
            values: self.values.clone(),
            bolts: self.bolts.clone(),
            accounts: self.accounts.clone(),
            account: self.account.clone(),
            base: self.base.clone(),
            initial,
            ..*self
        }
    }

    /// Ends contributions that are kept, on a rank ([`KEPT`]).
    pub(crate) fn close(&self, rows: &mut Vec<Row>) {
        if self.own.is_some() {
            rows.push(KEPT);
        }
    }
}
