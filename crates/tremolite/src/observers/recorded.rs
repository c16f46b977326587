//! Whether a record that was deconvolved comes out where it was taken.
//!
//! The velocity of the free field at the place of the record stands in the rows of free_field.csv as `record.free_field.vx` …;
//! what is remembered is its largest difference from the motion given. It holds all that the deconvolution does not know: the mesh,
//! rock that yields, what was left out above the band.

use super::free_field::levels::{self, Height};
use super::free_field::most;
use super::observer::{Event, Observer, Schedule, Setting, View, Wants, Which};
use crate::error::RunError;
use crate::plan::{Plan, Recorded};
use tremolite_engine::model::Model;
use tremolite_engine::state::Memory;

/// Key of what is remembered: the largest difference and the largest velocity given \[m/s\].
const MEMORY: &str = "record";

/// The place of a record in the column of the model that it was taken in; none where that is other ground.
pub fn place(model: &Model, plan: &Plan) -> Option<Height> {
    let Recorded { place, corner, .. } = plan.recorded.as_ref()?;
    let column = model
        .outside
        .columns
        .iter()
        .find(|column| corner.is_some_and(|corner| column.corners.contains(&corner)))?;
    let levels = levels::levels(model, column);
    Height::of(&levels, levels.first()?.z + place.height)
}

/// The largest difference over the largest velocity that the record has had so far; none where nothing was seen.
pub fn error(memory: &Memory) -> Option<f64> {
    let &[difference, peak] = &memory.get(MEMORY)?[..] else { return None };
    (peak > 0.0).then_some(difference / peak)
}

/// Follows the place of the record.
pub struct AtRecord {
    schedule: Schedule,
    height: Height,
}

impl AtRecord {
    /// Nothing where no record was deconvolved through the model's own ground.
    pub fn new(setting: &Setting) -> Option<Self> {
        Some(AtRecord { schedule: setting.rows(), height: place(setting.model, setting.plan)? })
    }
}

impl Observer for AtRecord {
    fn wants(&self) -> Wants {
        Wants { nodes: Which::some(self.height.nodes()), ..Wants::looks(self.schedule) }
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        match event {
            Event::Look(view) => self.see(view, memory),
            _ => Ok(()),
        }
    }
}

impl AtRecord {
    fn see(&mut self, view: &View, memory: &mut Memory) -> Result<(), RunError> {
        let Some(recorded) = &view.plan.recorded else { return Ok(()) };
        let (found, given) =
            (self.height.at(&view.snapshot.velocity), recorded.motion.at(view.snapshot.time).v);
        let seen = memory.entry(MEMORY.into()).or_insert_with(|| vec![0.0; 2]);
        if let [difference, peak] = &mut seen[..] {
            for axis in 0..3 {
                *difference = most(*difference, (found[axis] - given[axis]).abs());
                *peak = peak.max(given[axis].abs());
            }
        }
        Ok(())
    }
}
