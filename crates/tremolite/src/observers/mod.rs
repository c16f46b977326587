//! What looks at a run: when (a schedule in steps) is apart from what (an observer).

mod cracks;
mod energy;
mod envelopes;
mod fields;
mod free_field;
mod growth;
mod histories;
mod onsets;

pub use cracks::Cracks;
pub use energy::{Energy, MEMORY as ENERGY_MEMORY};
pub use envelopes::Envelopes;
pub use fields::Fields;
pub use free_field::{FreeField, MEMORY as FREE_FIELD_MEMORY};
pub use growth::Growth;
pub use histories::Histories;
pub use onsets::{Onsets, memory as onset_memory};

use crate::engine::Snapshot;
use crate::model::Model;
use crate::phase::Phase;
use crate::plan::Plan;
use crate::run::RunError;
use crate::state::State;

/// When an observer looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Schedule {
    /// Every so many steps.
    pub every: u64,
    /// At the last step as well, whatever its number.
    pub last: Option<u64>,
}

impl Schedule {
    /// Whether to look at this step.
    pub fn due(&self, step: u64) -> bool {
        step.is_multiple_of(self.every) || Some(step) == self.last
    }
}

/// What an observer sees at u^n.
pub struct View<'a> {
    pub model: &'a Model,
    pub phase: &'a Phase,
    pub plan: &'a Plan,
    pub snapshot: &'a Snapshot,
}

/// Something that looks at a run now and then. All it remembers from one look to the next is in
/// [`State::observers`], so a resumed run goes on as if it had never stopped.
pub trait Observer {
    fn schedule(&self) -> Schedule;
    /// Looks, and writes or remembers.
    ///
    /// # Errors
    /// If a result file cannot be written.
    fn see(&mut self, view: &View, state: &mut State) -> Result<(), RunError>;
}
