//! What the laws remember at the points of an element, read out of the octets in which the parts keep it.
//!
//! Histories are brought up to date when the parts are evaluated: who looks at a state that the engine has just
//! observed sees those of its displacements.

use crate::model::Model;
use crate::phase::{ElementSlot, Phase};
use crate::quantities::MEASURES;
use crate::state::State;
use tremolite_laws::Column;

/// The columns of the law that an active element is made of.
pub fn columns(model: &Model, slot: &ElementSlot) -> &'static [Column] {
    model.bodies[model.patches[slot.part as usize].body].material.info().history
}

/// Position of a column in the history of an element's law; none if the law has no such column.
pub fn position(model: &Model, slot: &ElementSlot, name: &str) -> Option<usize> {
    columns(model, slot).iter().position(|c| c.name == name)
}

/// Whether any point of an element has cracked or yielded, by whatever measure its law has.
pub fn is_damaged(model: &Model, phase: &Phase, state: &State, slot: &ElementSlot) -> bool {
    MEASURES.iter().any(|measure| {
        position(model, slot, measure.column)
            .is_some_and(|at| values(model, phase, state, slot, at).any(|value| value > measure.onset))
    })
}

/// One column at all points of an element, in the order of points; `column` as [`position`] gives it.
pub fn values<'s>(
    model: &Model,
    phase: &Phase,
    state: &'s State,
    slot: &ElementSlot,
    column: usize,
) -> impl ExactSizeIterator<Item = f64> + 's + use<'s> {
    let slices = &phase.slices[slot.part as usize];
    let (points, count) = (slot.points as usize, columns(model, slot).len());
    let element = slot.element as usize - slices.elements.start;
    // A part's octets lie element octet by element octet, in each point by point, in each column by column.
    let first = slices.history.start + element / 8 * points * count + column;
    (0..points).map(move |p| state.history[first + p * count].0[element % 8])
}
