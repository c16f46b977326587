//! When each element was first damaged or yielded.

use super::{Observer, Schedule, View};
use crate::history;
use crate::model::Model;
use crate::quantities::{MEASURES, Measure};
use crate::run::RunError;
use crate::state::State;

/// Keeps by element (in the order of parts) the first time seen at which a measure of damage had begun at one of its
/// points, infinite until then, in the state.
pub struct Onsets {
    schedule: Schedule,
    measures: Vec<Measure>,
}

/// Key of the first times of a measure.
pub fn memory(measure: &Measure) -> String {
    format!("first {}", measure.column)
}

impl Onsets {
    /// The observer, if a law of the model can be damaged.
    pub fn new(model: &Model, schedule: Schedule) -> Option<Self> {
        let known = |m: &&Measure| {
            model.user_bodies().iter().any(|b| b.material.info().history.iter().any(|c| c.name == m.column))
        };
        let measures: Vec<Measure> = MEASURES.iter().filter(known).copied().collect();
        (!measures.is_empty()).then_some(Onsets { schedule, measures })
    }
}

impl Observer for Onsets {
    fn schedule(&self) -> Schedule {
        self.schedule
    }

    fn see(&mut self, view: &View, state: &mut State) -> Result<(), RunError> {
        let time = state.time();
        for measure in &self.measures {
            let key = memory(measure);
            let elements = view.snapshot.energy.len();
            let mut first = state.observers.remove(&key).unwrap_or_else(|| vec![f64::INFINITY; elements]);
            for slot in view.phase.element_slot.iter().flatten() {
                let at = &mut first[slot.element as usize];
                if at.is_finite() {
                    continue;
                }
                let column = history::position(view.model, slot, measure.column);
                if column.is_some_and(|c| {
                    history::values(view.model, view.phase, state, slot, c).any(|value| value > measure.onset)
                }) {
                    *at = time;
                }
            }
            state.observers.insert(key, first);
        }
        Ok(())
    }
}
