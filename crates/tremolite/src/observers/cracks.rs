//! How far cracks have opened.

use super::observer::{Event, Observer, Schedule, Setting, View, Wants, Which};
use crate::error::RunError;
use tremolite_engine::phase::ElementSlot;
use tremolite_engine::state::Memory;
use tremolite_laws::Role;
use tremolite_laws::parameter::position;

/// What a law must keep of a point.
const ROLES: [Role; 3] = [Role::TensionDamage, Role::CrackExtent, Role::CrackStrain];

/// Keeps by element (in the order of members) the widest crack seen at one of its points \[m\], and when \[s\], under
/// [`Cracks::OPENING`] and [`Cracks::TIME`] in the state.
///
/// The opening is D⁺ ε₁ h with the largest principal strain ε₁ and the extent h across the crack at first damage: of
/// the stretch ε₁ h of a smeared crack, what the stress that is left, (1 − D⁺)Eε₁, does not explain. Where several
/// cracks cross an element it is their sum, and of an element that has come loose it means nothing. Where a crack turns after the first
/// damage, h stays: an element of 0.5 × 2 m that cracked along its ring first and then parted parallel to the wall has an opening of up to
/// four times what its thickness opened by. So the opening is then an upper bound.
pub struct Cracks {
    schedule: Schedule,
    /// Elements whose law keeps what is asked for, with its columns.
    cells: Vec<(ElementSlot, [usize; 3])>,
}

impl Cracks {
    pub const OPENING: &'static str = "crack_opening";
    pub const TIME: &'static str = "crack_opening time";

    /// The observer, if a law of the model can crack.
    pub fn new(setting: &Setting) -> Option<Self> {
        let cell = |slot: &ElementSlot| {
            let columns = setting.assembly.members[slot.member as usize].part.columns();
            let [Some(damage), Some(size), Some(strain)] = ROLES.map(|role| position(columns, role)) else {
                return None;
            };
            Some((*slot, [damage, size, strain]))
        };
        let cracks = |history| ROLES.iter().all(|&role| position(history, role).is_some());
        let mut bodies = setting.model.user_bodies().iter();
        bodies.any(|body| cracks(body.material.info().history)).then(|| Cracks {
            schedule: setting.rows(),
            cells: setting.phase.element_slot.iter().flatten().filter_map(cell).collect(),
        })
    }
}

impl Observer for Cracks {
    fn wants(&self) -> Wants {
        Wants { elements: Which::All, ..Wants::looks(self.schedule) }
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
        let (mut widest, mut when) = (take(Self::OPENING), take(Self::TIME));
        for (slot, [damage, size, strain]) in &self.cells {
            let column = |at: &usize| history.values(slot, *at);
            let opening = column(damage)
                .zip(column(size))
                .zip(column(strain))
                .map(|((damage, size), strain)| damage * size * strain)
                .fold(0.0, f64::max);
            let at = slot.element as usize;
            if opening > widest[at] {
                (widest[at], when[at]) = (opening, snapshot.time);
            }
        }
        memory.insert(Self::OPENING.into(), widest);
        memory.insert(Self::TIME.into(), when);
        Ok(())
    }
}
