//! The observers of a stage or of the shaking, each with what it wants, and how they are told.

use super::apart::Apart;
use super::observer::{CycleMade, Event, Observer, OwnObservers, Setting, Stepped, View, Wants, Which};
use super::unseen::Unseen;
use super::wishes::{LaidOut, Wishes};
use crate::error::RunError;
use tremolite_engine::Ranks;
use tremolite_engine::engine::Rest;
use tremolite_engine::model::Model;
use tremolite_engine::phase::Phase;
use tremolite_engine::state::Memory;

/// Observers with what they want.
#[derive(Default)]
pub struct Audience {
    all: Vec<(Box<dyn Observer>, Wants)>,
    /// Whether what an observer does not want is not a number to it.
    poisoned: bool,
    /// The same on all ranks.
    wishes: Wishes,
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
        let wishes = Wishes::of(all.iter().map(|(_, wants)| wants));
        Ok(Audience { all, poisoned, wishes })
    }

    /// What the observers of the first of several ranks want, for all: the others have none.
    #[must_use]
    pub fn of_first(mut self, ranks: &Ranks) -> Self {
        let words: Vec<f64> = self.wishes.put().into_iter().map(f64::from_bits).collect();
        let counts: Vec<u64> = ranks.from_first(&words).into_iter().map(f64::to_bits).collect();
        self.wishes = Wishes::take(&counts).unwrap_or_default();
        self
    }

    /// Adds that others look who are shown nothing of other ranks.
    pub fn beside(&mut self, apart: &Apart) {
        apart.wants().filter_map(|wants| wants.looks).for_each(|schedule| self.wishes.looks_itself(schedule));
    }

    /// Whether anybody wants to look at a step.
    pub fn is_due(&self, step: u64) -> bool {
        self.wishes.is_due(step)
    }

    /// What all want to be shown, in blocks of nodes and members of a phase.
    pub fn laid_out(&self, model: &Model, phase: &Phase) -> LaidOut {
        self.wishes.laid_out(model, phase)
    }

    /// Engine nodes of whose motion somebody is told in every step.
    pub fn steps(&self) -> &Which {
        &self.wishes.steps
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
        let kept: Vec<String> = match self.poisoned {
            true => self.all.iter().flat_map(|(_, w)| w.keeps.iter().map(|(name, _)| name.clone())).collect(),
            false => Vec::new(),
        };
        for (observer, wants) in self.all.iter_mut().filter(|(_, wants)| wants.look_at(step)) {
            match self.poisoned {
                false => observer.told(&Event::Look(*view), memory)?,
                true => {
                    let reads = wants.reads_kept || !wants.keeps.is_empty();
                    let hidden = if reads { Memory::new() } else { take(memory, &kept) };
                    observer.told(&Event::Look(Unseen::of(view, wants).view(view)), memory)?;
                    memory.extend(hidden);
                }
            }
        }
        Ok(())
    }

    /// Whether anybody wants to glance at every step of the coarsest level.
    pub fn glances(&self) -> bool {
        self.wishes.glances()
    }

    /// The members that hold the elements which are glanced at.
    pub fn glanced(&self, phase: &Phase) -> Vec<u32> {
        self.wishes.glanced(phase)
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

/// Takes some columns out of a memory.
fn take(memory: &mut Memory, names: &[String]) -> Memory {
    names.iter().filter_map(|name| memory.remove_entry(name)).collect()
}
