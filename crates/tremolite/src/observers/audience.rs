//! The observers of a stage or of the shaking, each with what it wants, and how they are told.

use super::observer::{
    CycleMade, Event, Observer, OwnObservers, Schedule, Setting, Stepped, View, Wants, Which,
};
use super::unseen::Unseen;
use crate::error::RunError;
use tremolite_engine::Ranks;
use tremolite_engine::engine::Rest;
use tremolite_engine::phase::Phase;
use tremolite_engine::state::Memory;

/// Observers with what they want.
#[derive(Default)]
pub struct Audience {
    all: Vec<(Box<dyn Observer>, Wants)>,
    /// Whether what an observer does not want is not a number to it.
    poisoned: bool,
    /// When somebody looks, and engine nodes of whose motion somebody is told in every step; the same on all ranks.
    looks: Vec<Schedule>,
    pub steps: Which,
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
        let looks = all.iter().filter_map(|(_, wants)| wants.looks).collect();
        let steps = all.iter().fold(Which::Nothing, |steps, (_, wants)| steps.and(&wants.steps));
        Ok(Audience { all, poisoned, looks, steps })
    }

    /// What the observers of the first of several ranks want, for all: the others have none.
    #[must_use]
    pub fn of_first(mut self, ranks: &Ranks) -> Self {
        let number = |count: u64| f64::from_bits(count);
        let mut words = vec![number(self.looks.len() as u64)];
        for Schedule { every, last } in &self.looks {
            words.extend([number(*every), number(u64::from(last.is_some())), number(last.unwrap_or(0))]);
        }
        match &self.steps {
            Which::Nothing => {}
            Which::Some(nodes) => words.extend(nodes.iter().map(|&n| number(u64::from(n)))),
            Which::All => words.push(number(ALL)),
        }
        let counts: Vec<u64> = ranks.from_first(&words).into_iter().map(f64::to_bits).collect();
        let Some((&looks, rest)) = counts.split_first() else { return self };
        let (looks, nodes) = rest.split_at((3 * looks as usize).min(rest.len()));
        self.looks = looks
            .chunks_exact(3)
            .map(|s| Schedule { every: s[0], last: (s[1] > 0).then_some(s[2]) })
            .collect();
        self.steps = match nodes {
            [] => Which::Nothing,
            [ALL] => Which::All,
            nodes => Which::Some(nodes.iter().map(|&n| n as u32).collect()),
        };
        self
    }

    /// Whether anybody wants to look at a step.
    pub fn is_due(&self, step: u64) -> bool {
        self.looks.iter().any(|schedule| schedule.due(step))
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

/// In place of the numbers of nodes: all of them.
const ALL: u64 = u64::MAX;

fn looks(wants: &Wants, step: u64) -> bool {
    wants.looks.is_some_and(|schedule| schedule.due(step))
}
