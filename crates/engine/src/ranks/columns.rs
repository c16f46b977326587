//! What members remember, taken out of a state.

use crate::state::State;
use tremolite_laws::{Octet, Row};

/// What members of one rank remember, while the state has what all do.
#[derive(Debug, Default)]
pub struct Columns {
    pub(super) history: Vec<Octet>,
    pub(super) overstress: Vec<Octet>,
    pub(super) numbers: Vec<f64>,
    pub(super) reference: Vec<Row>,
    pub(super) initial: Vec<Octet>,
    pub(super) carried: Vec<Row>,
    pub(super) carried_hourglass: Vec<Row>,
}

impl Columns {
    /// Takes it; nothing is left in the state.
    pub(super) fn take(state: &mut State) -> Self {
        let mut own = Columns::default();
        own.swap(state);
        own
    }

    /// Puts it back, in place of what the state has now.
    pub fn give_back(mut self, state: &mut State) {
        self.swap(state);
    }

    fn swap(&mut self, state: &mut State) {
        std::mem::swap(&mut self.history, &mut state.history);
        std::mem::swap(&mut self.overstress, &mut state.overstress);
        std::mem::swap(&mut self.numbers, &mut state.numbers);
        std::mem::swap(&mut self.reference, &mut state.reference);
        std::mem::swap(&mut self.initial, &mut state.initial);
        std::mem::swap(&mut self.carried, &mut state.carried);
        std::mem::swap(&mut self.carried_hourglass, &mut state.carried_hourglass);
    }
}
