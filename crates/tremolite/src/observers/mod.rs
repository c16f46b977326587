//! What looks at a run: when (a schedule in steps) is apart from what (an observer).

mod bolt_fields;
mod bolts;
mod cracks;
mod depth;
mod energy;
mod envelopes;
mod fibres;
mod fields;
mod free_field;
mod growth;
mod histories;
mod interfaces;
mod onsets;
pub mod recorded;
mod ringing;
mod rows;
mod section_forces;
mod steps;

pub use bolt_fields::{BoltFields, BoltGrid};
pub use bolts::{BoltForces, count as bolt_rows};
pub use cracks::Cracks;
pub use depth::Depth;
pub use energy::{Energy, MEMORY as ENERGY_MEMORY};
pub use envelopes::Envelopes;
pub use fibres::Fibres;
pub use fields::{FieldGrid, Fields};
pub use free_field::{ColumnSeen, FreeField, FreeFieldSeen, Theory, chosen};
pub use growth::Growth;
pub use histories::{Histories, at_rest};
pub use interfaces::{InterfaceFields, InterfaceGrid, Interfaces};
pub use onsets::{Onsets, memory_key as onset_memory};
pub use ringing::{Ringing, Rings};
pub use rows::{Cell, Seen, cells};
pub use section_forces::SectionForces;
pub use steps::{Extremes, StepPeaks};

use crate::error::RunError;
use crate::history::History;
use crate::plan::{Plan, Steps};
use std::sync::Arc;
use tremolite_engine::Snapshot;
use tremolite_engine::assembly::{Assembly, Slices};
use tremolite_engine::model::Model;
use tremolite_engine::phase::Phase;
use tremolite_engine::state::Memory;
use tremolite_laws::Row;
use tremolite_results::ResultFolder;

/// When an observer looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Schedule {
    /// Every so many steps.
    pub every: u64,
    /// At the last step as well, whatever its number.
    pub last: Option<u64>,
}

impl Schedule {
    /// Whether to look at this step.
    pub fn due(&self, step: u64) -> bool {
        step.is_multiple_of(self.every) || Some(step) == self.last
    }
}

/// The schedule of the rows of histories.
pub fn rows(steps: Steps) -> Schedule {
    Schedule { every: steps.histories, last: Some(steps.total) }
}

/// What an observer sees at u^n: numbers of that time, wherever the state itself is kept.
#[derive(Clone, Copy)]
pub struct View<'a> {
    pub model: &'a Model,
    pub assembly: &'a Assembly,
    pub phase: &'a Phase,
    pub plan: &'a Plan,
    pub snapshot: &'a Snapshot,
    /// What laws remember at points.
    pub history: History<'a>,
    /// What other parts remember.
    pub numbers: &'a [f64],
}

impl<'a> View<'a> {
    /// What a part remembers beside histories of points.
    pub fn numbers_of(&self, slices: &Slices) -> &'a [f64] {
        &self.numbers[slices.numbers.clone()]
    }
}

/// Something that looks at a run now and then. All it remembers from one look to the next is in the memory that it is
/// given, which is part of the state, so a resumed run goes on as if it had never stopped.
pub trait Observer: Send {
    fn schedule(&self) -> Schedule;
    /// Looks, and writes or remembers.
    ///
    /// # Errors
    /// If a result file cannot be written.
    fn see(&mut self, view: &View, memory: &mut Memory) -> Result<(), RunError>;
    /// Told of every step as it is made, whatever the schedule: for what must not be missed and costs next to nothing.
    fn stepped(&mut self, _: &Stepped, _: &mut Memory) {}
}

/// A step just made.
#[derive(Clone, Copy)]
pub struct Stepped<'a> {
    pub model: &'a Model,
    pub plan: &'a Plan,
    /// u^{n+1} and u^{n+1} − u^n by engine node \[m\], and the step \[s\].
    pub u: &'a [Row],
    /// What u was at t = 0 \[m\]; empty where that was nothing.
    pub datum: &'a [Row],
    pub du: &'a [Row],
    pub dt: f64,
}

/// What observers are made from, when a run starts or goes on.
pub struct Setting<'a> {
    pub folder: &'a ResultFolder,
    pub model: &'a Model,
    pub assembly: &'a Assembly,
    pub phase: &'a Phase,
    pub plan: &'a Plan,
    pub steps: Steps,
    /// What was remembered before; empty at the start.
    pub memory: &'a Memory,
    /// Step and time \[s\] since t = 0 from which the run goes on, and the step \[s\].
    pub step: u64,
    pub time: f64,
    pub dt: f64,
}

impl Setting<'_> {
    /// The schedule of the rows of histories.
    pub fn rows(&self) -> Schedule {
        rows(self.steps)
    }
}

/// Makes an observer, or nothing where it would have nothing to see.
///
/// # Errors
/// If a file of its cannot be written or gone on with.
pub type MakeObserver = dyn Fn(&Setting) -> Result<Option<Box<dyn Observer>>, RunError> + Send + Sync;

/// One entry of [`OBSERVERS`].
type Make = fn(&Setting) -> Result<Option<Box<dyn Observer>>, RunError>;

/// The program's own observers, in the order in which they look.
pub const OBSERVERS: &[Make] = &[
    |s| Ok(Some(Box::new(Histories::new(s)?))),
    |s| Ok(Some(Box::new(StepPeaks::new(s)))),
    |s| Ok(Some(Box::new(Energy::new(s)?))),
    |s| Ok(Some(Box::new(Envelopes { schedule: s.rows() }))),
    |s| Ok(FreeField::new(s)?.map(|o| Box::new(o) as Box<dyn Observer>)),
    |s| Ok(recorded::AtRecord::observer(s).map(|o| Box::new(o) as Box<dyn Observer>)),
    |s| Ok(Depth::observer(s).map(|o| Box::new(o) as Box<dyn Observer>)),
    |s| Ok(Onsets::new(s).map(|o| Box::new(o) as Box<dyn Observer>)),
    |s| Ok(Cracks::new(s).map(|o| Box::new(o) as Box<dyn Observer>)),
    |s| Ok(Fibres::new(s).map(|o| Box::new(o) as Box<dyn Observer>)),
    // Behind the cracks, whose widths it writes.
    |s| Ok(Growth::new(s)?.map(|o| Box::new(o) as Box<dyn Observer>)),
    |s| Ok(Fields::new(s)?.map(|o| Box::new(o) as Box<dyn Observer>)),
    |s| Ok(SectionForces::observer(s).map(|o| Box::new(o) as Box<dyn Observer>)),
    |s| Ok(Interfaces::new(s)?.map(|o| Box::new(o) as Box<dyn Observer>)),
    |s| Ok(Rings::observer(s).map(|o| Box::new(o) as Box<dyn Observer>)),
    |s| Ok(InterfaceFields::new(s)?.map(|o| Box::new(o) as Box<dyn Observer>)),
    |s| Ok(BoltForces::new(s)?.map(|o| Box::new(o) as Box<dyn Observer>)),
    |s| Ok(BoltFields::new(s)?.map(|o| Box::new(o) as Box<dyn Observer>)),
];

/// Observers of a program's own, which look behind those of [`OBSERVERS`].
pub type OwnObservers = Vec<Arc<MakeObserver>>;
