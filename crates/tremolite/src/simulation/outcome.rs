//! How a simulation ended.

use crate::history::History;
use crate::plan::Steps;
use tremolite_engine::assembly::Assembly;
use tremolite_engine::engine::{BodyBooks, Relaxed};
use tremolite_engine::state::State;
use tremolite_engine::{Bytes, Halt, StableStep, Stage};
use tremolite_kernels::Lines;
use tremolite_results::{Said, StageSummary};

/// How a run ended.
#[derive(Clone, Debug, PartialEq)]
pub enum Ending {
    Done,
    /// The signal came; a checkpoint was written.
    Stopped,
    /// A stage did not come to rest: its name, how it ended, and where most moves.
    Restless {
        stage: String,
        relaxed: Relaxed,
        place: Said,
    },
    /// What a stage moves snapped back: its name, and what \[J\] it let go at once of what it held.
    SnappedBack {
        stage: String,
        lost: f64,
        held: f64,
    },
    /// Energy appeared: the halt, and the element where most of it is.
    Failed {
        halt: Halt,
        place: Said,
    },
    /// Something moved or closed by more than method and laws are made for: what and where.
    Astray {
        why: Said,
    },
}

/// What is known of a run at its end besides its files.
#[derive(Clone, Debug)]
pub struct Outcome {
    pub ending: Ending,
    pub steps: Steps,
    /// Steps taken in all, and in this process.
    pub taken: u64,
    pub taken_here: u64,
    pub dt: f64,
    pub stable: StableStep,
    /// Wall time of the loop in this process \[s\], observers included, and of its steps alone.
    pub loop_seconds: f64,
    pub step_seconds: f64,
    /// The stages that came to rest.
    pub stages: Vec<StageSummary>,
    /// Whether it came to the earthquake.
    pub shaken: bool,
    /// Wall time of the stages in this process \[s\].
    pub stage_seconds: f64,
    /// Largest displacement \[m\] in a quiet run from the hand-over; none without stages or before it.
    pub quiet: Option<f64>,
    /// What this process held of parts and state once it had made a step.
    pub held: Option<Bytes>,
    pub balance: Lines,
    /// The books of each account of the assembly, when it was last looked at.
    pub bodies: Vec<BodyBooks>,
    pub state: State,
}

impl Outcome {
    /// Element updates a second of the steps, of which each evaluates so many in the mean.
    pub fn updates_per_second(&self, elements: f64) -> f64 {
        self.taken_here as f64 * elements / self.step_seconds.max(1e-9)
    }

    /// The last stage that was come to its end, or the shaking; none before the first.
    pub fn stage(&self) -> Option<Stage> {
        match (self.shaken, self.stages.len().checked_sub(1)) {
            (true, _) => Some(Stage::Shaking),
            (false, last) => Some(Stage::Before(u16::try_from(last?).ok()?)),
        }
    }

    /// What laws remember at the end.
    pub fn history<'a>(&'a self, assembly: &'a Assembly) -> History<'a> {
        History::new(assembly, &self.state.history)
    }
}
