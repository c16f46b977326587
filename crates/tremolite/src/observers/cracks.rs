//! How far cracks have opened.

use super::{Observer, Schedule, View};
use crate::history;
use crate::model::Model;
use crate::run::RunError;
use crate::state::State;

/// What a law must keep of a point: damage in tension, the extent across the crack, the largest principal strain.
const COLUMNS: [&str; 3] = ["d_tension", "crack_size", "last_e1"];

/// Keeps by element (in the order of parts) the widest crack seen at one of its points \[m\], and when \[s\], under
/// [`Cracks::OPENING`] and [`Cracks::TIME`] in the state.
///
/// The opening is D⁺ ε₁ h with the largest principal strain ε₁ and the extent h across the crack at first damage: of
/// the stretch ε₁ h of a smeared crack, what the stress that is left, (1 − D⁺)Eε₁, does not explain. Where several
/// cracks cross an element it is their sum, and of an element that has come loose it means nothing.
pub struct Cracks {
    schedule: Schedule,
}

impl Cracks {
    pub const OPENING: &'static str = "crack_opening";
    pub const TIME: &'static str = "crack_opening time";

    /// The observer, if a law of the model can crack.
    pub fn new(model: &Model, schedule: Schedule) -> Option<Self> {
        let cracks = |patch: &crate::model::Patch| {
            let history = model.bodies[patch.body].material.info().history;
            COLUMNS.iter().all(|name| history.iter().any(|column| column.name == *name))
        };
        model.patches[..model.user_patches].iter().any(cracks).then_some(Cracks { schedule })
    }
}

impl Observer for Cracks {
    fn schedule(&self) -> Schedule {
        self.schedule
    }

    fn see(&mut self, view: &View, state: &mut State) -> Result<(), RunError> {
        let View { model, phase, .. } = *view;
        let elements = view.snapshot.energy.len();
        let mut take = |name: &str| state.observers.remove(name).unwrap_or_else(|| vec![0.0; elements]);
        let (mut widest, mut when) = (take(Self::OPENING), take(Self::TIME));
        for slot in phase.element_slot.iter().flatten() {
            let [Some(damage), Some(size), Some(strain)] =
                COLUMNS.map(|name| history::position(model, slot, name))
            else {
                continue;
            };
            let column = |at| history::values(model, phase, state, slot, at);
            let opening = column(damage)
                .zip(column(size))
                .zip(column(strain))
                .map(|((damage, size), strain)| damage * size * strain)
                .fold(0.0, f64::max);
            let at = slot.element as usize;
            if opening > widest[at] {
                (widest[at], when[at]) = (opening, state.time());
            }
        }
        state.observers.insert(Self::OPENING.into(), widest);
        state.observers.insert(Self::TIME.into(), when);
        Ok(())
    }
}
