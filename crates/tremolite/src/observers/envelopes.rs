//! Extremes over time, by node and element.

use super::observer::{Event, Observer, Schedule, View, Wants, Which};
use crate::error::RunError;
use crate::point_stress::fibre_extremes;
use crate::quantities::length;
use rayon::prelude::*;
use tremolite_engine::phase::ElementSlot;
use tremolite_engine::state::Memory;

/// Keeps the largest displacement by engine node, and the largest s1 and smallest s3 with their times by element (in the order
/// of members), under the names below in the state. Stresses of elements of several points are those at the fibre as long as they are
/// intact.
pub struct Envelopes {
    pub schedule: Schedule,
}

impl Envelopes {
    pub const DISPLACEMENT: &'static str = "displacement_max";
    pub const S1: &'static str = "s1_max";
    pub const S1_TIME: &'static str = "s1_max_time";
    pub const S3: &'static str = "s3_min";
    pub const S3_TIME: &'static str = "s3_min_time";
}

fn column<'m>(memory: &'m mut Memory, name: &str, length: usize, start: f64) -> &'m mut Vec<f64> {
    memory.entry(name.into()).or_insert_with(|| vec![start; length])
}

impl Observer for Envelopes {
    fn wants(&self) -> Wants {
        Wants { nodes: Which::All, elements: Which::All, ..Wants::looks(self.schedule) }
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        match event {
            Event::Look(view) => self.see(view, memory),
            _ => Ok(()),
        }
    }
}

impl Envelopes {
    fn see(&mut self, view: &View, memory: &mut Memory) -> Result<(), RunError> {
        let lengths: Vec<f64> = view.snapshot.displacement.iter().map(length).collect();
        let most = column(memory, Self::DISPLACEMENT, lengths.len(), 0.0);
        most.iter_mut().zip(lengths).for_each(|(most, now)| *most = most.max(now));

        let elements = view.snapshot.energy.len();
        let slots: Vec<&ElementSlot> = view.phase.element_slot.iter().flatten().collect();
        let of_element = |slot: &&ElementSlot| {
            let first = slot.point as usize;
            let points = &view.snapshot.stress[first..first + slot.points as usize];
            fibre_extremes(&slot.places, points, view.history.is_damaged(slot))
        };
        let extremes: Vec<[f64; 2]> = slots.par_iter().map(of_element).collect();
        let mut now = vec![[f64::NEG_INFINITY, f64::INFINITY]; elements];
        for (slot, extremes) in slots.iter().zip(extremes) {
            now[slot.element as usize] = extremes;
        }
        // Tension positive: s3 is the largest of −s3.
        let kinds = [(Self::S1, Self::S1_TIME, 0, 1.0), (Self::S3, Self::S3_TIME, 1, -1.0)];
        for (name, time, which, sign) in kinds {
            let most = column(memory, name, elements, sign * f64::NEG_INFINITY);
            let later: Vec<bool> =
                most.iter().zip(&now).map(|(m, now)| sign * now[which] > sign * *m).collect();
            for ((most, now), later) in most.iter_mut().zip(&now).zip(&later) {
                if *later {
                    *most = now[which];
                }
            }
            let times = column(memory, time, elements, 0.0);
            times
                .iter_mut()
                .zip(&later)
                .filter(|(_, later)| **later)
                .for_each(|(t, _)| *t = view.snapshot.time);
        }
        Ok(())
    }
}
