//! What the laws remember at the points of an element, read out of the octets in which the parts keep it.
//!
//! Histories are brought up to date when the parts are evaluated: who looks at a state that the engine has just
//! observed sees those of its displacements.

use crate::quantities::MEASURES;
use std::collections::BTreeSet;
use tremolite_engine::assembly::{Assembly, Slices};
use tremolite_engine::phase::{ElementSlot, Phase};
use tremolite_laws::parameter::position;
use tremolite_laws::{Column, Octet, Role};

/// Members that elements of the mesh are in, in a phase: of those that are `wanted`.
pub fn of_elements(phase: &Phase, wanted: impl Fn(&ElementSlot) -> bool) -> Vec<u32> {
    let slots = phase.element_slot.iter().flatten().filter(|slot| wanted(slot));
    let members: BTreeSet<u32> = slots.map(|slot| slot.member).collect();
    members.into_iter().collect()
}

/// The histories of all parts at one time.
#[derive(Clone, Copy)]
pub struct History<'a> {
    assembly: &'a Assembly,
    /// Where each member's lie.
    slices: &'a [Slices],
    /// The state's octets, or a copy of them.
    pub octets: &'a [Octet],
}

impl<'a> History<'a> {
    /// Of all members.
    pub fn new(assembly: &'a Assembly, octets: &'a [Octet]) -> Self {
        History { assembly, slices: &assembly.slices, octets }
    }

    /// Of those that this rank holds, with slots of its own phase.
    pub(crate) fn held(assembly: &'a Assembly, octets: &'a [Octet]) -> Self {
        History { assembly, slices: &assembly.held, octets }
    }

    /// The same of other octets.
    pub(crate) fn with<'o>(&self, octets: &'o [Octet]) -> History<'o>
    where
        'a: 'o,
    {
        History { octets, ..*self }
    }

    /// The parts that remember them.
    pub(crate) fn assembly(&self) -> &'a Assembly {
        self.assembly
    }

    fn elements(&self) -> usize {
        self.slices.last().map_or(0, |last| last.elements.end)
    }

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

    /// By element, in the order of members, whether a column of this meaning lies beyond a value at any point: of these members.
    pub fn beyond(&self, members: &[u32], role: Role, value: f64) -> Vec<bool> {
        let mut marks = vec![false; self.elements()];
        self.mark_beyond(members, role, value, &mut marks);
        marks
    }

    /// Whether any point of an element of these members has cracked or yielded ([`History::is_damaged`]), by element.
    pub fn damaged(&self, members: &[u32]) -> Vec<bool> {
        let mut marks = vec![false; self.elements()];
        MEASURES
            .iter()
            .for_each(|measure| self.mark_beyond(members, measure.role, measure.onset, &mut marks));
        marks
    }

    /// Marks elements as [`History::beyond`]: eight at a time, as they lie.
    fn mark_beyond(&self, members: &[u32], role: Role, value: f64, marks: &mut [bool]) {
        for &member in members {
            let columns = self.assembly.members[member as usize].part.columns();
            let Some(column) = position(columns, role) else { continue };
            let slices = &self.slices[member as usize];
            let own = &mut marks[slices.elements.clone()];
            let points = slices.points.len() / own.len().max(1);
            let octets = &self.octets[slices.history.clone()];
            for (marks, octets) in own.chunks_mut(8).zip(octets.chunks_exact((points * columns.len()).max(1)))
            {
                let mut any = [false; 8];
                for octet in octets[column..].iter().step_by(columns.len()) {
                    any.iter_mut().zip(&octet.0).for_each(|(any, x)| *any |= *x > value);
                }
                marks.iter_mut().zip(any).for_each(|(mark, any)| *mark |= any);
            }
        }
    }

    /// Where all columns of an element lie: an octet, and its place there.
    pub(crate) fn places(&self, slot: &ElementSlot) -> impl Iterator<Item = (usize, usize)> + use<> {
        let (first, lane) = self.first(slot);
        let count = self.columns(slot).len() * slot.points as usize;
        (first..first + count).map(move |octet| (octet, lane))
    }

    /// The octet of an element's first column at its first point, and its place in that: the layout that Part::columns describes.
    fn first(&self, slot: &ElementSlot) -> (usize, usize) {
        let slices = &self.slices[slot.member as usize];
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
