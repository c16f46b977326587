//! What the laws remember at the points of an element, read out of the octets in which the parts keep it.
//!
//! Histories are brought up to date when the parts are evaluated: who looks at a state that the engine has just
//! observed sees those of its displacements.

use crate::quantities::MEASURES;
use tremolite_engine::assembly::Assembly;
use tremolite_engine::phase::ElementSlot;
use tremolite_laws::parameter::position;
use tremolite_laws::{Column, Octet, Role};

/// The histories of all parts at one time.
#[derive(Clone, Copy)]
pub struct History<'a> {
    pub assembly: &'a Assembly,
    /// The state's octets, or a copy of them.
    pub octets: &'a [Octet],
}

impl<'a> History<'a> {
    /// The columns of the law that an active element is made of.
    pub fn columns(&self, slot: &ElementSlot) -> &'static [Column] {
        self.assembly.members[slot.member as usize].part.columns()
    }

    /// Position of a column by its name in the history of an element's law; none if the law has no such column.
    pub fn named(&self, slot: &ElementSlot, name: &str) -> Option<usize> {
        self.columns(slot).iter().position(|c| c.name == name)
    }

    /// Position of a column by what it means.
    pub fn with_role(&self, slot: &ElementSlot, role: Role) -> Option<usize> {
        position(self.columns(slot), role)
    }

    /// Whether any point of an element has cracked or yielded, by whatever measure its law has.
    pub fn is_damaged(&self, slot: &ElementSlot) -> bool {
        MEASURES.iter().any(|measure| {
            self.with_role(slot, measure.role)
                .is_some_and(|at| self.values(slot, at).any(|value| value > measure.onset))
        })
    }

    /// Where all columns of an element lie: an octet, and its place there.
    pub(crate) fn places(&self, slot: &ElementSlot) -> impl Iterator<Item = (usize, usize)> + use<> {
        let (first, lane) = self.first(slot);
        let count = self.columns(slot).len() * slot.points as usize;
        (first..first + count).map(move |octet| (octet, lane))
    }

    /// The octet of an element's first column at its first point, and its place in that: the layout that Part::columns describes.
    fn first(&self, slot: &ElementSlot) -> (usize, usize) {
        let slices = &self.assembly.slices[slot.member as usize];
        let element = slot.element as usize - slices.elements.start;
        let octets = slot.points as usize * self.columns(slot).len();
        (slices.history.start + element / 8 * octets, element % 8)
    }

    /// One column at all points of an element, in the order of points.
    pub fn values(
        &self,
        slot: &ElementSlot,
        column: usize,
    ) -> impl ExactSizeIterator<Item = f64> + 'a + use<'a> {
        let (points, count) = (slot.points as usize, self.columns(slot).len());
        let (first, lane) = self.first(slot);
        let octets = self.octets;
        (0..points).map(move |p| octets[first + column + p * count].0[lane])
    }
}
