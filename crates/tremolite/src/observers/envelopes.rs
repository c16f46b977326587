//! Extremes over time, by node and element.

use super::{Observer, Schedule, View};
use crate::error::RunError;
use crate::quantities::{extremes, length};
use tremolite_engine::state::Memory;

/// Keeps the largest displacement by engine node, and the largest s1 and smallest s3 by element (in the order of
/// members), under [`Envelopes::DISPLACEMENT`], [`Envelopes::S1`] and [`Envelopes::S3`] in the state.
pub struct Envelopes {
    pub schedule: Schedule,
}

impl Envelopes {
    pub const DISPLACEMENT: &'static str = "displacement_max";
    pub const S1: &'static str = "s1_max";
    pub const S3: &'static str = "s3_min";
}

fn column<'m>(memory: &'m mut Memory, name: &str, length: usize, start: f64) -> &'m mut Vec<f64> {
    memory.entry(name.into()).or_insert_with(|| vec![start; length])
}

impl Observer for Envelopes {
    fn schedule(&self) -> Schedule {
        self.schedule
    }

    fn see(&mut self, view: &View, memory: &mut Memory) -> Result<(), RunError> {
        let lengths: Vec<f64> = view.snapshot.displacement.iter().map(length).collect();
        let most = column(memory, Self::DISPLACEMENT, lengths.len(), 0.0);
        most.iter_mut().zip(lengths).for_each(|(most, now)| *most = most.max(now));

        let elements = view.snapshot.energy.len();
        let mut now = vec![[0.0; 2]; elements];
        for slot in view.phase.element_slot.iter().flatten() {
            let first = slot.point as usize;
            now[slot.element as usize] = extremes(&view.snapshot.stress[first..first + slot.points as usize]);
        }
        let s1 = column(memory, Self::S1, elements, f64::NEG_INFINITY);
        s1.iter_mut().zip(&now).for_each(|(most, now)| *most = most.max(now[0]));
        let s3 = column(memory, Self::S3, elements, f64::INFINITY);
        s3.iter_mut().zip(&now).for_each(|(least, now)| *least = least.min(now[1]));
        Ok(())
    }
}
