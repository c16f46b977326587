//! The observers of a stage or of the shaking, each with what it wants, and how they are told.

use super::observer::{CycleMade, Event, Observer, OwnObservers, Setting, Stepped, View, Wants, Which};
use super::unseen::Unseen;
use crate::error::RunError;
use tremolite_engine::engine::Rest;
use tremolite_engine::phase::Phase;
use tremolite_engine::state::Memory;

/// Observers with what they want.
pub struct Audience {
    all: Vec<(Box<dyn Observer>, Wants)>,
    /// Whether what an observer does not want is not a number to it.
    poisoned: bool,
}

impl Audience {
    /// Those of a list that have something to see, in its order.
    ///
    /// # Errors
    /// If a file of theirs cannot be written or gone on with.
    pub fn of(makers: &OwnObservers, setting: &Setting, poisoned: bool) -> Result<Self, RunError> {
        let mut all = Vec::new();
        for make in makers {
            all.extend(make(setting)?.map(|observer| {
                let wants = observer.wants();
                (observer, wants)
            }));
        }
        Ok(Audience { all, poisoned })
    }

    /// Whether anybody wants to look at a step.
    pub fn is_due(&self, step: u64) -> bool {
        self.all.iter().any(|(_, wants)| looks(wants, step))
    }

    /// Tells all.
    ///
    /// # Errors
    /// If a result file cannot be written.
    pub fn tell(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        for (observer, wants) in &mut self.all {
            match event {
                Event::StageEnds(seen) if self.poisoned => {
                    let unseen = Unseen::of(&seen.view, wants);
                    let rows = unseen.rows_at_end(seen, wants);
                    observer.told(&Event::StageEnds(unseen.stage(seen, &rows)), memory)?;
                }
                _ => observer.told(event, memory)?,
            }
        }
        Ok(())
    }

    /// Shows a step to those who look at it.
    ///
    /// # Errors
    /// If a result file cannot be written.
    pub fn look(&mut self, step: u64, view: &View, memory: &mut Memory) -> Result<(), RunError> {
        for (observer, wants) in self.all.iter_mut().filter(|(_, wants)| looks(wants, step)) {
            match self.poisoned {
                false => observer.told(&Event::Look(*view), memory)?,
                true => observer.told(&Event::Look(Unseen::of(view, wants).view(view)), memory)?,
            }
        }
        Ok(())
    }

    /// Whether anybody wants to glance at every step of the coarsest level.
    pub fn glances(&self) -> bool {
        self.all.iter().any(|(_, wants)| wants.glances)
    }

    /// The members that hold the elements which are glanced at.
    pub fn glanced(&self, phase: &Phase) -> Vec<u32> {
        let glancing = || self.all.iter().filter(|(_, wants)| wants.glances);
        let seen = |e: &usize| glancing().any(|(_, wants)| wants.elements.has(*e));
        let slots = phase.element_slot.iter().enumerate().filter(|(e, _)| seen(e));
        let mut members: Vec<u32> = slots.filter_map(|(_, slot)| Some(slot.as_ref()?.member)).collect();
        members.dedup();
        members
    }

    /// Shows a step to those who glance.
    ///
    /// # Errors
    /// If a result file cannot be written.
    pub fn glance(&mut self, view: &View, memory: &mut Memory) -> Result<(), RunError> {
        for (observer, wants) in self.all.iter_mut().filter(|(_, wants)| wants.glances) {
            match self.poisoned {
                false => observer.told(&Event::Glance(*view), memory)?,
                true => observer.told(&Event::Glance(Unseen::of(view, wants).view(view)), memory)?,
            }
        }
        Ok(())
    }

    /// Tells those who follow every step of one just made.
    ///
    /// # Errors
    /// If a result file cannot be written.
    pub fn stepped(&mut self, step: &Stepped, memory: &mut Memory) -> Result<(), RunError> {
        for (observer, wants) in self.all.iter_mut().filter(|(_, wants)| wants.steps != Which::Nothing) {
            match self.poisoned {
                false => observer.told(&Event::Step(*step), memory)?,
                true => {
                    let [u, datum, du] = [step.u, step.datum, step.du].map(|rows| wants.steps.rows(rows));
                    let step = Stepped { u: &u, datum: &datum, du: &du, ..*step };
                    observer.told(&Event::Step(step), memory)?;
                }
            }
        }
        Ok(())
    }

    /// Tells those who want to know of a cycle.
    ///
    /// # Errors
    /// If a result file cannot be written.
    pub fn cycle(
        &mut self,
        stage: usize,
        rest: &Rest,
        freed: bool,
        memory: &mut Memory,
    ) -> Result<(), RunError> {
        let wanted = |wants: &Wants| wants.cycles.is_some_and(|every| rest.cycles.is_multiple_of(every));
        for (observer, _) in self.all.iter_mut().filter(|(_, wants)| wanted(wants)) {
            observer.told(&Event::Cycle(CycleMade { stage, rest, freed }), memory)?;
        }
        Ok(())
    }
}

fn looks(wants: &Wants, step: u64) -> bool {
    wants.looks.is_some_and(|schedule| schedule.due(step))
}
