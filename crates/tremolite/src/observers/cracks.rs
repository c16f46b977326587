//! How far cracks have opened, and which way they run.

mod directions;

use super::observer::{Event, Observer, Schedule, Setting, View, Wants, Which};
use crate::error::RunError;
use crate::history::History;
use directions::{Frame, frames, widths};
use rayon::prelude::*;
use std::collections::HashMap;
use tremolite_engine::assembly::Assembly;
use tremolite_engine::law_axes;
use tremolite_engine::model::Model;
use tremolite_engine::phase::{ElementSlot, Phase};
use tremolite_engine::state::Memory;
use tremolite_laws::Role;
use tremolite_laws::parameter::position;
use tremolite_results::CrackDirection;

/// Keeps by element (in the order of members) the widest crack seen at one of its points \[m\], and when \[s\], and the widest when
/// somebody looked last, under [`Cracks::OPENING`], [`Cracks::TIME`] and [`Cracks::LAST`] in the state.
///
/// The same by the direction in which cracks run ([`CrackDirection`]) for those elements alone, by the lining's frame at each.
///
/// How wide a crack is the law says ([`Role::CrackWidth`]). Where several parallel cracks cross an element it is their sum, and of
/// an element that has come loose it means nothing.
pub struct Cracks {
    schedule: Schedule,
    elements: Which,
    cells: Vec<Cell>,
}

/// An element whose law knows how wide its cracks are.
struct Cell {
    slot: ElementSlot,
    width: usize,
    /// The first of the openings squared, if the law keeps them.
    openings: Option<usize>,
    frame: Option<Frame>,
}

/// Key of what is remembered by direction: for each cell and direction what [`Opened`] holds.
const DIRECTIONS: &str = "crack directions";
const EACH: usize = 3;

/// The widest crack of one direction in an element \[m\], when it was \[s\], and how wide it was when somebody looked last.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Opened {
    pub widest: f64,
    pub time: f64,
    pub last: f64,
}

impl Cracks {
    pub const OPENING: &'static str = "crack_opening";
    pub const TIME: &'static str = "crack_opening time";
    pub const LAST: &'static str = "crack_opening last";

    /// The observer, if a law of the model can crack.
    pub fn new(setting: &Setting) -> Option<Self> {
        let columns = |slot: &ElementSlot| setting.assembly.members[slot.member as usize].part.columns();
        let slots = || cracking(setting.phase, |slot| position(columns(slot), Role::CrackWidth).is_some());
        let mut bodies = setting.model.user_bodies().iter();
        bodies.any(|body| position(body.material.info().history, Role::CrackWidth).is_some()).then(|| {
            let frames = frames(setting.model);
            let cell = |(e, slot): (u32, ElementSlot)| {
                let width = position(columns(&slot), Role::CrackWidth)?;
                let openings = position(columns(&slot), Role::CrackOpenings);
                let frame = frames.get(&e).map(|frame| of_law(setting.model, (e, &slot), frame));
                Some(Cell { slot, width, openings, frame })
            };
            Cracks {
                schedule: setting.rows(),
                elements: Which::some(slots().map(|(e, _)| e as usize)),
                cells: slots().filter_map(cell).collect(),
            }
        })
    }
}

const ALL: [CrackDirection; 4] = CrackDirection::ALL;

/// Elements of the mesh whose law knows how wide its cracks are, in their order.
fn cracking(phase: &Phase, knows: impl Fn(&ElementSlot) -> bool) -> impl Iterator<Item = (u32, ElementSlot)> {
    let slots = (0u32..).zip(&phase.element_slot);
    slots.filter_map(move |(e, slot)| slot.filter(|slot| knows(slot)).map(|slot| (e, slot)))
}

/// The frame of an element in the axes of its law, in which that keeps its openings.
fn of_law(model: &Model, (e, slot): (u32, &ElementSlot), frame: &Frame) -> Frame {
    frame.within(&law_axes(model, &model.patches[slot.patch as usize], e))
}

/// The widest crack \[m\] of each direction in an element; `frame` in the axes of its law.
fn by_direction(
    history: &History,
    slot: &ElementSlot,
    (width, openings): (usize, Option<usize>),
    frame: Option<&Frame>,
) -> [f64; ALL.len()] {
    let frame = frame.filter(|_| openings.is_some());
    let mut columns = openings.map(|first| [0, 1, 2, 3, 4, 5].map(|k| history.values(slot, first + k)));
    let points = history.values(slot, width).map(|width| {
        let next = |columns: &mut [_; 6]| columns.each_mut().map(|of| Iterator::next(of).unwrap_or(0.0));
        (columns.as_mut().map_or([0.0; 6], next), width)
    });
    widths(frame, points)
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
    /// The widest crack \[m\] of each direction ([`CrackDirection::ALL`]) in each element of the mesh whose law tells widths, as it is open now.
    pub fn now(model: &Model, phase: &Phase, history: &History) -> HashMap<u32, [f64; ALL.len()]> {
        let frames = frames(model);
        let of = |(e, slot): (u32, ElementSlot)| {
            let width = history.with_role(&slot, Role::CrackWidth)?;
            let openings = history.with_role(&slot, Role::CrackOpenings);
            let frame = frames.get(&e).map(|frame| of_law(model, (e, &slot), frame));
            Some((e, by_direction(history, &slot, (width, openings), frame.as_ref())))
        };
        cracking(phase, |slot| history.with_role(slot, Role::CrackWidth).is_some()).filter_map(of).collect()
    }

    /// Which row of what is remembered by direction an element of the mesh has, for [`Cracks::opened`].
    pub fn rows(assembly: &Assembly, phase: &Phase) -> HashMap<u32, usize> {
        let columns = |slot: &ElementSlot| assembly.members[slot.member as usize].part.columns();
        let slots = cracking(phase, |slot| position(columns(slot), Role::CrackWidth).is_some());
        slots.enumerate().map(|(row, (e, _))| (e, row)).collect()
    }

    /// What was remembered by direction, for [`Cracks::opened`]; empty where nothing was.
    pub fn remembered(memory: &Memory) -> &[f64] {
        memory.get(DIRECTIONS).map_or(&[], Vec::as_slice)
    }

    /// How far an element has opened in each direction, in the order of [`CrackDirection::ALL`], by its row of [`Cracks::rows`] in what was
    /// remembered; no crack where nothing was.
    pub fn opened(remembered: &[f64], row: usize) -> [Opened; ALL.len()] {
        let each = EACH * ALL.len();
        let own = remembered.get(row * each..(row + 1) * each).unwrap_or_default();
        let mut all = [Opened::default(); ALL.len()];
        for (opened, [widest, time, last]) in all.iter_mut().zip(own.as_chunks::<EACH>().0) {
            *opened = Opened { widest: *widest, time: *time, last: *last };
        }
        all
    }

    fn see(&mut self, view: &View, memory: &mut Memory) -> Result<(), RunError> {
        let View { history, snapshot, .. } = *view;
        let elements = snapshot.energy.len();
        let mut take = |name: &str| memory.remove(name).unwrap_or_else(|| vec![0.0; elements]);
        let (mut widest, mut when, mut last) = (take(Self::OPENING), take(Self::TIME), take(Self::LAST));
        let mut directions =
            memory.remove(DIRECTIONS).unwrap_or_else(|| vec![0.0; EACH * ALL.len() * self.cells.len()]);
        let own = directions.chunks_exact_mut(EACH * ALL.len());
        let of = |Cell { slot, width, openings, frame }: &Cell| {
            let opening = history.values(slot, *width).fold(0.0, f64::max);
            let each = match opening > 0.0 {
                true => by_direction(&history, slot, (*width, *openings), frame.as_ref()),
                false => [0.0; ALL.len()],
            };
            (opening, each)
        };
        let found: Vec<(f64, [f64; ALL.len()])> = self.cells.par_iter().map(of).collect();
        for ((Cell { slot, .. }, own), (opening, each)) in self.cells.iter().zip(own).zip(found) {
            for (opening, own) in each.into_iter().zip(own.as_chunks_mut::<EACH>().0) {
                own[2] = opening;
                if opening > own[0] {
                    [own[0], own[1]] = [opening, snapshot.time];
                }
            }
            let at = slot.element as usize;
            last[at] = opening;
            if opening > widest[at] {
                (widest[at], when[at]) = (opening, snapshot.time);
            }
        }
        memory.insert(DIRECTIONS.into(), directions);
        memory.insert(Self::OPENING.into(), widest);
        memory.insert(Self::TIME.into(), when);
        memory.insert(Self::LAST.into(), last);
        Ok(())
    }
}
