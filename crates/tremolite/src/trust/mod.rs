//! How far a run can be trusted: each line a number against a limit. A check that does not apply says so; what holds by
//! construction is a fact and no check.

mod before;
mod bolts;
mod corners;
mod creep;
mod cut_short;
mod energy;
mod fibres;
mod interface;
mod lining_closure;
mod mass_damping;
mod material;
mod moved;
mod near_sides;
mod pore_water;
mod rows;
mod seam;
mod waves;

pub(crate) use corners::{LEAST as LEAST_AT_CORNERS, typical as typical_extent};
pub(crate) use cut_short::{NOT_RUN, left_after};
pub(crate) use mass_damping::{MOST as MOST_MASS_DAMPING, ratio as mass_damping};
pub(crate) use material::on_broken_elements;
pub(crate) use rows::MISSED as MOST_MISSED;
pub(crate) use waves::DRIFT;
pub(crate) use waves::PER_WAVELENGTH;

use crate::evidence::Evidence;
use crate::plan::Plan;
use crate::survey::limit_in_words;
use tremolite_engine::Model;
use tremolite_engine::state::Memory;
use tremolite_results::{Fact, StageSummary, TrustLine, said, tell_apart};

/// Every check of a run.
pub(crate) fn trust(evidence: &Evidence) -> Vec<TrustLine> {
    let mut lines = before::lines(evidence);
    lines.extend(moved::lines(evidence));
    lines.push(near_sides::line(evidence));
    if evidence.outcome.shaken {
        lines.extend([waves::per_wavelength(evidence), waves::drift(evidence)]);
        lines.extend([cut_short::line(evidence), creep::line(evidence)]);
        lines.extend([mass_damping::line(evidence), rows::line(evidence)]);
        lines.extend(waves::free_field(evidence));
        lines.extend(waves::record(evidence));
        lines.extend(energy::lines(evidence));
        lines.push(fibres::line(evidence));
        lines.extend(pore_water::lines(evidence));
    }
    lines.extend(interface::lines(evidence));
    lines.extend(lining_closure::lines(evidence));
    lines.extend(bolts::lines(evidence));
    lines.extend(corners::lines(evidence));
    lines.extend(material::lines(evidence));
    tell_apart(lines.iter_mut().map(|line| &mut line.id));
    lines
}

/// Checks whose value is known when a stage is at rest, before the earthquake: of the initial equilibrium those of the initial stress, of the
/// last stage all others as well.
pub(crate) fn of_stages(
    model: &Model,
    plan: &Plan,
    stages: &[StageSummary],
    memory: &Memory,
) -> Vec<TrustLine> {
    let mut lines = before::of_stages(model, plan, stages, memory);
    if stages.len() < plan.stages.len() {
        lines.retain(|line| before::OF_THE_FIRST.contains(&&*line.id));
    } else {
        lines.extend(moved::of_stages(plan, memory));
    }
    lines
}

/// What is true of a run by construction.
pub(crate) fn facts(evidence: &Evidence) -> Vec<Fact> {
    let Evidence { model, assembly, outcome, .. } = evidence;
    if !evidence.outcome.shaken {
        return before::facts(evidence);
    }
    let stable = &outcome.stable;
    let set_by = limit_in_words(model, assembly, stable);
    let mut facts = vec![
        Fact::new(
            "time_step_over_stable_step",
            said!("time step over stable step"),
            outcome.dt / stable.dt,
            "",
            said!(
                "set by {set_by}; the estimate changed by {change} in the last of {iterations} iterations",
                set_by = set_by,
                change = format!("{:.0e}", stable.change),
                iterations = stable.iterations.to_string(),
            ),
        )
        .with("change", stable.change)
        .with("iterations", stable.iterations as f64),
        Fact::new(
            "viscosity_step_ratio",
            said!("stable step with artificial viscosity over that without"),
            stable.dt / stable.undamped,
            "",
            said!(
                "artificial viscosity damps the ringing of pieces between cracks and costs a share of the step"
            ),
        ),
    ];
    facts.extend(material::facts(model));
    facts.extend(pore_water::fact(evidence));
    facts.extend(before::facts(evidence));
    tell_apart(facts.iter_mut().map(|fact| &mut fact.id));
    facts
}
