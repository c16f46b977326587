//! What will happen, before it happens.

mod json;
mod stages;

pub use json::diagnostics;

use super::Job;
use crate::disk::{Disk, disk};
use crate::interfaces::{interfaces, monitors};
use crate::outlook::{StressAt, stress_at_start};
use crate::places::element;
use crate::step_cost::{time_cycle_cost, time_step_cost};
use crate::support;
use crate::survey::{impacts_in_words, limit_in_words};
use indexmap::IndexMap;
use serde::{Serialize, Serializer};
use tremolite_engine::{Body, Phase, Stage};
use tremolite_results::{BoltPlace, BoltSummary, Defaulted, InterfaceSummary, MaterialFacts, PairPlace};

/// All that is said of a job before it runs. Serialized it is the object of `tremolite check --json`, numbers in SI.
pub struct Checked<'a> {
    pub job: &'a Job,
    /// The element with fewest elements a wavelength around it.
    pub coarsest: String,
    pub interfaces: IndexMap<String, InterfaceSummary>,
    /// Monitors on interfaces.
    pub pairs: IndexMap<String, PairPlace>,
    pub bolts: IndexMap<String, BoltSummary>,
    /// Monitors on bolts.
    pub bolt_monitors: IndexMap<String, BoltPlace>,
    /// What sets the stable step.
    pub set_by: String,
    /// What impacts at interfaces allow.
    pub impacts: Option<String>,
    pub initial: Vec<StressAt>,
    pub relaxed: Vec<Relaxed>,
    pub threads: usize,
    /// Wall time of a step \[s\].
    pub cost: f64,
    /// Wall time of a cycle of the last stage's relaxation \[s\]; 0 without stages.
    pub cycle_cost: f64,
    pub disk: Disk,
    pub left_out: Vec<Defaulted>,
}

/// The modulus of a material in the stages, where damping over a band makes it another.
pub struct Relaxed {
    pub material: String,
    /// Of the given moduli.
    pub share: f64,
    /// As given and in the stages \[Pa\], of a law with one.
    pub young: Option<[f64; 2]>,
}

impl<'a> Checked<'a> {
    /// Times a step and a cycle on the pool of threads that it is called from.
    pub(super) fn of(job: &'a Job) -> Checked<'a> {
        let Job { model, assembly, phase, plan, survey, stable, .. } = job;
        let last = plan.stages.len().checked_sub(1).map(|last| Stage::Before(last as u16));
        // `outlook` has made the phases of all stages.
        let last = last.and_then(|stage| Phase::of(model, assembly, stage).ok());
        Checked {
            job,
            coarsest: survey
                .coarsest()
                .map_or(String::new(), |b| element(model, b.coarsest as usize).to_string()),
            interfaces: interfaces(model, assembly, &assembly.rest().history),
            pairs: monitors(model, plan),
            bolts: support::bolts(&model.bolts, plan, None, &|_, _| Vec::new(), &[]),
            bolt_monitors: support::monitors(&model.bolts, plan),
            set_by: limit_in_words(model, assembly, stable).to_string(),
            impacts: impacts_in_words(model, stable).map(|said| said.to_string()),
            initial: stress_at_start(model),
            relaxed: relaxed(job),
            threads: rayon::current_num_threads(),
            cost: time_step_cost(model, assembly, phase, job.dt),
            cycle_cost: last.map_or(0.0, |stage| time_cycle_cost(model, assembly, &stage)),
            disk: disk(model, assembly, phase, plan, job.steps),
            left_out: job.defaulted(),
        }
    }
}

impl Checked<'_> {
    /// Wall time of the run \[s\].
    pub fn seconds(&self) -> f64 {
        self.stage_seconds() + self.shaking_seconds()
    }

    /// Observers take a twentieth.
    fn shaking_seconds(&self) -> f64 {
        if self.job.motion.is_some() { 1.05 * self.cost * self.job.steps.total as f64 } else { 0.0 }
    }

    /// Of its stages \[s\].
    pub fn stage_seconds(&self) -> f64 {
        self.cycle_cost * self.cycles() as f64
    }

    /// Cycles of all stages, a guess.
    pub fn cycles(&self) -> u64 {
        self.job.outlook.as_ref().map_or(0, |outlook| outlook.cycles)
    }

    /// Element updates a second.
    pub fn updates_per_second(&self) -> f64 {
        self.job.phase.evaluated_elements / self.cost
    }
}

impl Serialize for Checked<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.json().serialize(serializer)
    }
}

/// The moduli of the stages that differ from those given.
fn relaxed(job: &Job) -> Vec<Relaxed> {
    if !job.case.seeks_equilibrium() {
        return Vec::new();
    }
    let of_material = |(name, facts): (&String, &MaterialFacts)| {
        let made = |body: &&Body| facts.groups.iter().any(|group| group.body == body.name);
        let share = job.model.user_bodies().iter().find(made)?.material.band()?.relaxed();
        let young = facts.values.iter().find(|v| v.name == "young").map(|v| [v.value, share * v.value]);
        Some(Relaxed { material: name.clone(), share, young })
    };
    job.materials.iter().filter_map(of_material).collect()
}
