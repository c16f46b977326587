//! What can be said of stages before they are run: what stands when, on what, and under which stress.

mod at_rest;
mod bare;
mod pieces;
mod pulls;
mod stress;

pub use at_rest::{AtRest, Wall};
pub use pieces::{Hold, Piece};
pub use stress::{MIDDLE, StressAt, stress_at_start};

use crate::plan::Plan;
use at_rest::at_rest;
use bare::Walls;
use pieces::pieces;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use tremolite_case::pattern;
use tremolite_engine::{Assembly, Life, Model, ModelError, Phase, Stage};

/// Groups that a stage takes out or installs, as the case names them.
#[derive(Clone, Debug, PartialEq)]
pub struct Named {
    pub pattern: String,
    /// Elements of all groups that it fits, each once.
    pub elements: usize,
}

/// A stage as it will be.
#[derive(Clone, Debug)]
pub struct StageOutlook {
    pub name: String,
    pub excavated: Vec<Named>,
    pub installed: Vec<Named>,
    pub release: f64,
    pub changed: Vec<String>,
    /// Elements that stand, and those that go and begin with it; what stands in the place of a lining counts.
    pub standing: usize,
    pub gone: usize,
    pub begun: usize,
    /// Wall without lining \[m²\]: between what stands from the start and what is void.
    pub bare: f64,
    /// What it leaves without support that was not so before.
    pub pieces: Vec<Piece>,
}

/// Elements of a group that come and go together.
#[derive(Clone, Debug, PartialEq)]
pub struct Lot {
    pub group: String,
    pub elements: usize,
    pub life: Life,
}

/// What stands in the place of elements that are installed later.
#[derive(Clone, Debug, PartialEq)]
pub struct StandIn {
    /// The body that it is of.
    pub body: String,
    /// Of what is installed: its smallest group.
    pub group: String,
    pub elements: usize,
    /// The stage that takes it out.
    pub gone: Option<Stage>,
}

/// All that is foreseen.
#[derive(Clone, Debug)]
pub struct Outlook {
    pub stages: Vec<StageOutlook>,
    /// Of groups that are not there from the start to the end.
    pub lots: Vec<Lot>,
    pub stand_ins: Vec<StandIn>,
    /// Cycles of all stages, a guess.
    pub cycles: u64,
    /// What the initial stress is to the ground; nothing where there is none.
    pub at_rest: Option<AtRest>,
}

/// What a plan's stages will be.
///
/// # Errors
/// If a stage has no faces on a plane that should hold it.
/// `along_y`: the openings are known to go along y.
pub fn outlook(
    model: &Arc<Model>,
    assembly: &Arc<Assembly>,
    plan: &Plan,
    along_y: bool,
) -> Result<Outlook, ModelError> {
    let walls = Walls::of(model);
    let mut stages = Vec::new();
    let mut known = BTreeSet::new();
    let mut before: Vec<u32> = Vec::new();
    // Both ascend.
    let beyond = |some: &[u32], of: &[u32]| some.iter().filter(|e| of.binary_search(e).is_err()).count();
    let mut rest = None;
    for (k, planned) in plan.stages.iter().enumerate() {
        let stage = Stage::Before(k as u16);
        let phase = Phase::of(model, assembly, stage)?;
        if k == 0 {
            rest = at_rest(model, assembly, &phase, along_y);
        }
        let standing = model.standing(stage);
        let mut new = pieces(model, &phase, &standing);
        // What hangs since an earlier stage has been told there.
        new.retain(|piece| !piece.elements.iter().all(|e| known.contains(e)));
        known.extend(new.iter().flat_map(|piece| piece.elements.iter().copied()));
        stages.push(StageOutlook {
            name: planned.name.clone(),
            excavated: named(model, &planned.excavated),
            installed: named(model, &planned.installed),
            release: planned.release.share,
            changed: planned.changed.iter().map(ToString::to_string).collect(),
            standing: standing.len(),
            gone: beyond(&before, &standing),
            begun: if k == 0 { 0 } else { beyond(&standing, &before) },
            bare: walls.bare(model, &standing),
            pieces: new,
        });
        before = standing;
    }
    let of_stage = |stage: usize| {
        let release = &plan.stages[stage].release;
        guess(stages[stage].standing).max(release.cycles + SETTLE).min(release.most)
    };
    let cycles = (0..stages.len()).map(of_stage).sum();
    Ok(Outlook { stages, lots: lots(model), stand_ins: stand_ins(model), cycles, at_rest: rest })
}

/// Cycles that even a small model takes to settle behind the last release: 350 of 1,700 elements.
const SETTLE: u64 = 300;

/// Cycles a stage takes, from trials: 500 of 8,214 elements and 1,150 of 98,080, both of rock that yields.
fn guess(elements: usize) -> u64 {
    (600.0 * (elements as f64 / 15e3).powf(0.45)).round() as u64
}

fn named(model: &Model, patterns: &[String]) -> Vec<Named> {
    let count = |pattern: &String| {
        let groups = model.mesh.groups.iter().filter(|(name, _)| pattern::matches(pattern, name));
        groups.flat_map(|(_, elements)| elements).copied().collect::<BTreeSet<u32>>().len()
    };
    patterns.iter().map(|p| Named { pattern: p.clone(), elements: count(p) }).collect()
}

fn lots(model: &Model) -> Vec<Lot> {
    let mut all = Vec::new();
    for (name, elements) in &model.mesh.groups {
        let solid = elements.iter().filter(|&&e| model.elements.body_of[e as usize].is_some());
        let mut of_life: BTreeMap<Life, usize> = BTreeMap::new();
        solid.for_each(|&e| *of_life.entry(model.elements.lives[e as usize]).or_default() += 1);
        if of_life.keys().any(|life| *life != Life::ALWAYS) {
            let lot = |(life, elements)| Lot { group: name.clone(), elements, life };
            all.extend(of_life.into_iter().map(lot));
        }
    }
    all
}

fn stand_ins(model: &Model) -> Vec<StandIn> {
    let mut all: BTreeMap<(Option<Stage>, usize, &str), usize> = BTreeMap::new();
    let smallest = smallest_groups(model);
    for &(stand_in, of) in &model.elements.stand_ins {
        let Some(body) = model.elements.body_of[stand_in as usize] else { continue };
        let gone = model.elements.lives[stand_in as usize].gone;
        *all.entry((gone, body, smallest[of as usize])).or_default() += 1;
    }
    let of = |((gone, body, group), elements): ((Option<Stage>, usize, &str), usize)| StandIn {
        body: model.bodies[body].name.clone(),
        group: group.to_owned(),
        elements,
        gone,
    };
    all.into_iter().map(of).collect()
}

/// The smallest group of each element, or the name of its body.
pub(super) fn smallest_groups(model: &Model) -> Vec<&str> {
    let mut names: Vec<(usize, &str)> = (0..model.mesh.elements.len())
        .map(|e| match model.elements.body_of.get(e).copied().flatten() {
            Some(body) => (usize::MAX, model.bodies[body].name.as_str()),
            None => (usize::MAX, ""),
        })
        .collect();
    for (name, elements) in &model.mesh.groups {
        for &e in elements {
            let own = &mut names[e as usize];
            if elements.len() < own.0 {
                *own = (elements.len(), name);
            }
        }
    }
    names.into_iter().map(|(_, name)| name).collect()
}
