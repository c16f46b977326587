//! When each element was first damaged or yielded.

use super::observer::{Event, Keeps, Observer, Schedule, Setting, View, Wants, Which};
use crate::error::RunError;
use crate::history::of_elements;
use crate::quantities::{MEASURES, Measure};
use crate::state::Memory;
use tremolite_laws::parameter::position;

/// Keeps by element (in the order of members) the first time seen at which a measure of damage had begun at one of its
/// points, infinite until then, in the state.
pub struct Onsets {
    schedule: Schedule,
    measures: Vec<Measure>,
    /// Members that elements are in.
    members: Vec<u32>,
}

/// Key of the first times of a measure.
pub fn memory_key(measure: &Measure) -> String {
    format!("first {}", measure.words)
}

impl Onsets {
    /// The observer, if a law of the model can be damaged.
    pub fn new(setting: &Setting) -> Option<Self> {
        let known = |m: &&Measure| {
            let mut bodies = setting.model.user_bodies().iter();
            bodies.any(|b| position(b.material.info().history, m.role).is_some())
        };
        let measures: Vec<Measure> = MEASURES.iter().filter(known).copied().collect();
        let members = of_elements(setting.phase, |_| true);
        (!measures.is_empty()).then(|| Onsets { schedule: setting.rows(), measures, members })
    }
}

impl Observer for Onsets {
    fn wants(&self) -> Wants {
        let keeps = self.measures.iter().map(|measure| (memory_key(measure), Keeps::Elements)).collect();
        Wants { histories: Which::All, keeps, ..Wants::looks(self.schedule) }
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        match event {
            Event::Look(view) => self.see(view, memory),
            _ => Ok(()),
        }
    }
}

impl Onsets {
    fn see(&mut self, view: &View, memory: &mut Memory) -> Result<(), RunError> {
        let View { history, snapshot, .. } = *view;
        for measure in &self.measures {
            let key = memory_key(measure);
            let elements = snapshot.energy.len();
            let mut first = memory.remove(&key).unwrap_or_else(|| vec![f64::INFINITY; elements]);
            let begun = history.beyond(&self.members, measure.role, measure.onset);
            for at in first.iter_mut().zip(begun).filter_map(|(at, begun)| begun.then_some(at)) {
                if !at.is_finite() {
                    *at = snapshot.time;
                }
            }
            memory.insert(key, first);
        }
        Ok(())
    }
}
