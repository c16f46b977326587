//! Checks of what came before the earthquake.

use crate::evidence::Evidence;
use crate::run::Beginning;
use tremolite_results::{Fact, TrustLine};

/// What is held besides weight, loads and reactions when the shaking begins, over all contributions: ten times what stages
/// leave out of balance.
const HELD: f64 = 1e-4;
/// Motion to the initial equilibrium over the largest of the stages that follow.
const INITIAL: f64 = 0.1;

/// Change of the initial stress over itself.
const CHANGE: f64 = 0.1;
/// What to look at where the initial stress does not fit.
const FITS: &str = "the initial stress is out of balance where it differs from the weight above, or from what the rock can bear: \
                    look at `lateral`, `stress` or `overburden`; on slopes and beside layers some is right";

pub(super) fn lines(evidence: &Evidence) -> Vec<TrustLine> {
    const HELD_ID: &str = "held_at_the_end";
    const HELD_NAME: &str =
        "held besides weight, loads and reactions after the last stage, over all contributions";
    const CHANGE_ID: &str = "initial_stress_change";
    const CHANGE_NAME: &str = "change of the initial stress on the way to equilibrium over that stress";
    const INITIAL_ID: &str = "initial_motion";
    const INITIAL_NAME: &str = "motion to the initial equilibrium over the stages'";
    let stages = &evidence.outcome.stages;
    let (Some(first), Some(last)) = (stages.first(), stages.last()) else {
        let why = if evidence.plan.stages.is_empty() {
            "nothing comes before the earthquake"
        } else {
            "no stage came to rest"
        };
        return vec![
            TrustLine::not_applicable(HELD_ID, HELD_NAME, why),
            TrustLine::not_applicable(INITIAL_ID, INITIAL_NAME, why),
            TrustLine::not_applicable(CHANGE_ID, CHANGE_NAME, why),
        ];
    };
    let all = stages.len() == evidence.plan.stages.len();
    let held = TrustLine::at_most(HELD_ID, HELD_NAME, last.held, HELD, "").with_note(
        "what stages have not let go stays held in the shaking: end with a stage whose `release` is 1",
    );
    let held =
        if all { held } else { TrustLine::not_applicable(HELD_ID, HELD_NAME, "not all stages are done") };
    let largest = stages[1..].iter().map(|stage| stage.largest_motion).fold(0.0, f64::max);
    let excavates = stages[1..].iter().any(|stage| !stage.excavated.is_empty());
    let initial = if excavates {
        TrustLine::at_most(INITIAL_ID, INITIAL_NAME, first.largest_motion / largest, INITIAL, "")
            .with("initial", first.largest_motion)
            .with("largest", largest)
            .with_note(FITS)
    } else {
        TrustLine::not_applicable(INITIAL_ID, INITIAL_NAME, "no stage that came to rest excavates")
    };
    let change = match Beginning::recall(&evidence.outcome.state.observers) {
        Some(found) if !evidence.model.initial.is_empty() => {
            TrustLine::at_most(CHANGE_ID, CHANGE_NAME, found.change, CHANGE, "")
                .with("imbalance", found.imbalance)
                .with_note(format!(
                    "integrated over what stands; {:.1e} of all forces were out of balance at first; {FITS}",
                    found.imbalance
                ))
        }
        _ => TrustLine::not_applicable(CHANGE_ID, CHANGE_NAME, "the ground begins without stress"),
    };
    vec![held, initial, change]
}

pub(super) fn facts(evidence: &Evidence) -> Vec<Fact> {
    let outcome = evidence.outcome;
    let mut facts = Vec::new();
    if let Some(first) = outcome.stages.first() {
        facts.push(Fact::new(
            "initial_plastic_volume",
            "plastic shear strain at the initial equilibrium, integrated",
            first.plastic_volume,
            "m3",
            "rock that the initial stress itself brings to yield",
        ));
        let worst = outcome.stages.iter().map(|stage| stage.ratio).fold(0.0, f64::max);
        facts.push(Fact::new(
            "stages_out_of_balance",
            "out of balance over all contributions, worst of the stages",
            worst,
            "",
            "each stage goes on until this is below `initial.tolerance`, and little motion is left",
        ));
    }
    if let Some(Beginning { pairs, beyond, .. }) =
        Beginning::recall(&outcome.state.observers).filter(|found| found.pairs > 0)
    {
        facts.push(Fact::new(
            "initial_pairs_beyond_strength",
            "pairs of interfaces that the initial stress brings beyond their strength",
            beyond as f64,
            "",
            format!("of {pairs} that are there from the start: they slid or opened on the way to the initial equilibrium"),
        ));
    }
    if let Some(drift) = outcome.quiet {
        facts.push(Fact::new(
            "quiet_drift",
            "largest displacement in 100 steps without motion",
            drift,
            "m",
            "what all parts do at rest is held, so nothing moves but by round-off",
        ));
    }
    facts
}
