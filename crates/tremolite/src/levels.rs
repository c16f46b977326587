//! How many levels of steps a run has.

use crate::plan::{Plan, steps_of_row};
use tremolite_engine::{Assembly, Levels, Model, ModelError, Phase, StableStep, find_levels};

/// What another level must spare of the evaluations of elements to be worth having.
const WORTH: f64 = 0.05;

/// The longest step that a model may run with on its finest level \[s\].
pub fn longest_step(model: &Model, stable: &StableStep) -> f64 {
    let step = model.scheme.time_step;
    step.given.unwrap_or_else(|| stable.to_run(step.safety))
}

/// The levels of a run: as many as are allowed and worth it. Rows of histories lie whole steps of the coarsest level apart, so
/// dense ones leave fewer.
///
/// # Errors
/// If there is no phase in which pairs of an interface can be judged.
pub fn levels(
    model: &Model,
    assembly: &Assembly,
    phase: &Phase,
    plan: &Plan,
    stable: &StableStep,
) -> Result<Levels, ModelError> {
    let longest = longest_step(model, stable);
    let most = if plan.duration > 0.0 { model.scheme.time_step.levels } else { 1 };
    let all = find_levels(model, assembly, phase, longest, most)?;
    let elements: Vec<u32> = model.bodies.iter().flat_map(|body| model.lasting(body)).collect();
    let row = plan.row(longest.min(stable.dt));
    let cost = |levels: &Levels| {
        let rows = steps_of_row(row, longest, 1 << levels.coarsest());
        levels.share(&elements) * rows as f64
    };
    let mut best = Levels::one();
    for coarsest in 1..=all.coarsest() {
        let levels = all.capped(coarsest);
        if cost(&levels) < (1.0 - WORTH) * cost(&best) {
            best = levels;
        }
    }
    Ok(best)
}
