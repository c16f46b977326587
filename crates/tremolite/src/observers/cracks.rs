//! How far cracks have opened.

use super::observer::{Event, Observer, Schedule, Setting, View, Wants, Which};
use crate::error::RunError;
use tremolite_engine::phase::ElementSlot;
use tremolite_engine::state::Memory;
use tremolite_laws::Role;
use tremolite_laws::parameter::position;

/// Keeps by element (in the order of members) the widest crack seen at one of its points \[m\], and when \[s\], and the widest when
/// somebody looked last, under [`Cracks::OPENING`], [`Cracks::TIME`] and [`Cracks::LAST`] in the state.
///
/// How wide a crack is the law says ([`Role::CrackWidth`]). Where several parallel cracks cross an element it is their sum, and of
/// an element that has come loose it means nothing.
pub struct Cracks {
    schedule: Schedule,
    elements: Which,
    /// Elements whose law knows how wide its cracks are, with the column.
    cells: Vec<(ElementSlot, usize)>,
}

impl Cracks {
    pub const OPENING: &'static str = "crack_opening";
    pub const TIME: &'static str = "crack_opening time";
    pub const LAST: &'static str = "crack_opening last";

    /// The observer, if a law of the model can crack.
    pub fn new(setting: &Setting) -> Option<Self> {
        let column = |slot: &ElementSlot| {
            position(setting.assembly.members[slot.member as usize].part.columns(), Role::CrackWidth)
        };
        let slots = || {
            let slots = setting.phase.element_slot.iter().enumerate();
            slots.filter_map(|(e, slot)| slot.and_then(|slot| Some((e, slot, column(&slot)?))))
        };
        let mut bodies = setting.model.user_bodies().iter();
        bodies.any(|body| position(body.material.info().history, Role::CrackWidth).is_some()).then(|| {
            Cracks {
                schedule: setting.rows(),
                elements: Which::some(slots().map(|(e, ..)| e)),
                cells: slots().map(|(_, slot, column)| (slot, column)).collect(),
            }
        })
    }
}

impl Observer for Cracks {
    fn wants(&self) -> Wants {
        Wants { histories: self.elements.clone(), ..Wants::looks(self.schedule) }
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        match event {
            Event::Look(view) => self.see(view, memory),
            _ => Ok(()),
        }
    }
}

impl Cracks {
    fn see(&mut self, view: &View, memory: &mut Memory) -> Result<(), RunError> {
        let View { history, snapshot, .. } = *view;
        let elements = snapshot.energy.len();
        let mut take = |name: &str| memory.remove(name).unwrap_or_else(|| vec![0.0; elements]);
        let (mut widest, mut when, mut last) = (take(Self::OPENING), take(Self::TIME), take(Self::LAST));
        for (slot, column) in &self.cells {
            let opening = history.values(slot, *column).fold(0.0, f64::max);
            let at = slot.element as usize;
            last[at] = opening;
            if opening > widest[at] {
                (widest[at], when[at]) = (opening, snapshot.time);
            }
        }
        memory.insert(Self::OPENING.into(), widest);
        memory.insert(Self::TIME.into(), when);
        memory.insert(Self::LAST.into(), last);
        Ok(())
    }
}
