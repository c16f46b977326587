//! What is known of a run that has ended.

use crate::near_sides::NearSide;
use crate::plan::Plan;
use crate::setup::MotionFacts;
use crate::simulation::Outcome;
use crate::survey::Survey;
use indexmap::IndexMap;
use tremolite_engine::assembly::Assembly;
use tremolite_engine::model::Model;
use tremolite_engine::phase::Phase;
use tremolite_results::{Defaulted, Input, MaterialFacts, RunFacts, Table};

/// All a summary is made from.
pub struct Evidence<'a> {
    pub model: &'a Model,
    pub assembly: &'a Assembly,
    pub phase: &'a Phase,
    pub plan: &'a Plan,
    /// None without an earthquake.
    pub motion: Option<&'a MotionFacts>,
    pub survey: &'a Survey,
    /// Boundaries beside openings.
    pub near: Vec<NearSide>,
    pub outcome: &'a Outcome,
    /// monitors.csv as it was written.
    pub histories: &'a Table,
    /// energy.csv as it was written.
    pub energy: &'a Table,
    pub materials: IndexMap<String, MaterialFacts>,
    pub inputs: Vec<Input>,
    /// Whether numbers without a unit are in SI.
    pub bare_si: bool,
    /// What was said of the case before the run.
    pub before: Vec<String>,
    pub run: RunFacts,
    pub defaulted: Vec<Defaulted>,
    /// Wall time of the whole process so far \[s\].
    pub wall_seconds: f64,
}
