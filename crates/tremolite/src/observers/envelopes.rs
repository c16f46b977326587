//! Extremes over time, by node and element.

use super::observer::{Event, Keeps, Observer, Schedule, Setting, View, Wants, Which};
use crate::error::RunError;
use crate::history::of_elements;
use crate::point_stress::fibre_extremes;
use crate::quantities::length;
use rayon::prelude::*;
use tremolite_engine::phase::ElementSlot;
use tremolite_engine::state::Memory;

/// Keeps the largest displacement by engine node, and the largest s1 and smallest s3 with their times by element (in the order
/// of members), under the names below in the state. Stresses of elements of several points are those at the fibre as long as they are
/// intact.
pub struct Envelopes {
    schedule: Schedule,
    /// Members with elements of several points, of which alone it counts here whether they are damaged.
    members: Vec<u32>,
}

impl Envelopes {
    pub const DISPLACEMENT: &'static str = "displacement_max";
    pub const S1: &'static str = "s1_max";
    pub const S1_TIME: &'static str = "s1_max_time";
    pub const S3: &'static str = "s3_min";
    pub const S3_TIME: &'static str = "s3_min_time";

    pub fn new(setting: &Setting) -> Self {
        let several = |slot: &ElementSlot| slot.points > 1;
        Envelopes { schedule: setting.rows(), members: of_elements(setting.phase, several) }
    }
}

/// Elements whose principal stresses are found together.
const AT_ONCE: usize = 256;

fn column<'m>(memory: &'m mut Memory, name: &str, length: usize, start: f64) -> &'m mut Vec<f64> {
    memory.entry(name.into()).or_insert_with(|| vec![start; length])
}

impl Observer for Envelopes {
    fn wants(&self) -> Wants {
        let elements = [Self::S1, Self::S1_TIME, Self::S3, Self::S3_TIME];
        let of_elements = elements.map(|name| (name.to_owned(), Keeps::Elements));
        let keeps = std::iter::once((Self::DISPLACEMENT.to_owned(), Keeps::Nodes)).chain(of_elements);
        Wants {
            nodes: Which::All,
            elements: Which::All,
            keeps: keeps.collect(),
            ..Wants::looks(self.schedule)
        }
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
        let damaged = view.history.damaged(&self.members);
        // Tension positive: s3 is the largest of −s3.
        let kinds = [(Self::S1, Self::S1_TIME, 0, 1.0), (Self::S3, Self::S3_TIME, 1, -1.0)];
        for (name, time, _, sign) in kinds {
            column(memory, name, elements, sign * f64::NEG_INFINITY);
            column(memory, time, elements, 0.0);
        }
        let slots: Vec<&ElementSlot> = view.phase.element_slot.iter().flatten().collect();
        let of_some = |slots: &[&ElementSlot]| {
            let seen = slots.iter().map(|slot| {
                let points = &view.snapshot.stress[slot.point as usize..][..slot.points as usize];
                (&slot.places, points, damaged[slot.element as usize])
            });
            fibre_extremes(seen).collect::<Vec<_>>()
        };
        let found: Vec<Vec<[f64; 2]>> = slots.par_chunks(AT_ONCE).map(of_some).collect();
        for (name, time, which, sign) in kinds {
            let most = column(memory, name, elements, sign * f64::NEG_INFINITY);
            let mut later = Vec::new();
            for (slot, now) in slots.iter().zip(found.iter().flatten()) {
                let element = slot.element as usize;
                if sign * now[which] > sign * most[element] {
                    most[element] = now[which];
                    later.push(element);
                }
            }
            let times = column(memory, time, elements, 0.0);
            later.into_iter().for_each(|element| times[element] = view.snapshot.time);
        }
        Ok(())
    }
}
