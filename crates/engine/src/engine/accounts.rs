//! The work on the elements of each body, node by node.

use super::gather::dot;
use crate::phase::{NO_ACCOUNT, Phase, SEVERAL};
use tremolite_laws::Row;

/// Books the work against the forces of elements node by node. Nodes of an account follow one another: its sum stays in a
/// register until another's turn comes.
pub(super) struct Accounts<'a> {
    phase: &'a Phase,
    contributions: &'a [Row],
    /// By account.
    sums: &'a mut [f64],
    current: u16,
    sum: f64,
}

impl<'a> Accounts<'a> {
    /// Books onto these sums.
    pub fn new(phase: &'a Phase, contributions: &'a [Row], sums: &'a mut [f64]) -> Self {
        Accounts { phase, contributions, sums, current: NO_ACCOUNT, sum: 0.0 }
    }

    /// Books half the work of `twice`, two increments, against the parts' force at a node.
    #[inline(always)]
    pub fn book(&mut self, node: usize, force: Row, twice: Row) {
        let account = self.phase.account[node];
        if account != self.current {
            self.turn(account);
        }
        let others = self.phase.others[node];
        let own = if others > 0 { self.own(node, force, others) } else { force };
        self.sum += 0.5 * dot(own, twice);
        if account == SEVERAL {
            self.book_several(node, twice);
        }
    }

    /// What of a node's force is of elements, where so many other parts push it as well.
    #[inline]
    fn own(&self, node: usize, force: Row, others: u8) -> Row {
        let end = self.phase.start[node + 1] as usize;
        let others = &self.phase.slot[end - usize::from(others)..end];
        others.iter().fold(force, |mut own, &slot| {
            let row = &self.contributions[slot as usize];
            (0..3).for_each(|i| own.0[i] -= row.0[i]);
            own
        })
    }

    /// The sums by account.
    pub fn sums(&mut self) -> &mut [f64] {
        self.sums
    }

    #[cold]
    fn turn(&mut self, account: u16) {
        if let Some(sum) = self.sums.get_mut(self.current as usize) {
            *sum += self.sum;
        }
        (self.current, self.sum) = (account, 0.0);
    }

    #[cold]
    fn book_several(&mut self, node: usize, twice: Row) {
        let Accounts { phase, contributions, sums, .. } = self;
        for at in phase.start[node] as usize..phase.start[node + 1] as usize {
            if let Some(sum) = sums.get_mut(phase.slot_account[at] as usize) {
                *sum += 0.5 * dot(contributions[phase.slot[at] as usize], twice);
            }
        }
    }

    pub fn close(mut self) {
        self.turn(NO_ACCOUNT);
    }
}
