//! The check of sides, base and top that stand near an opening.

use crate::evidence::Evidence;
use crate::near_sides::NearSide;
use crate::observers::Beside;
use tremolite_results::{Said, TrustLine, said};

/// What stages change at the boundary, over the stress along the opening before. Around a hall of 10 × 10 m, with sides and base at
/// 60, 30, 21, 15 and 7 m, it is 1.4, 4.4, 8.4, 15 and 45 % where the hoop stress is wrong by 0.7, 2.6, 4.8, 8.0 and 26 %; of one twice
/// as wide as high the stress is wrong by less.
const CHANGE: f64 = 0.08;
const ID: &str = "boundary_stress_change";

pub(super) fn line(evidence: &Evidence) -> TrustLine {
    let name = said!("stress change at the model's sides and base over the initial stress");
    let none = |why: Said| TrustLine::not_applicable(ID, name.clone(), why);
    if evidence.near.is_empty() {
        return none(said!("no opening lies beside a boundary that represents continuing ground"));
    }
    let Some(beside) = Beside::recall(&evidence.outcome.state.observers) else {
        return none(said!("the ground begins without stress"));
    };
    if evidence.outcome.stages.len() < evidence.plan.stages.len() {
        return none(said!("not all stages are done"));
    }
    let change = |near: &NearSide| beside.change[near.plane()] / beside.initial;
    let apart = evidence.near.iter().filter(|near| !near.met);
    let Some(worst) = apart.max_by(|a, b| change(a).total_cmp(&change(b))) else {
        return none(said!("an opening reaches every boundary that represents continuing ground"));
    };
    TrustLine::at_most(ID, name, change(worst), CHANGE, "")
        .with("radius", worst.radius)
        .with("distance", worst.distance)
        .with("estimate", worst.share())
        .with_note(said!(
            "largest change that the stages cause beside {side}, over the mean stress along the openings before: a boundary that cannot move holds the ground back, and stresses around the opening are wrong by half of this and more; {distance} m from an opening of {extent} m it is \
             {estimate} % by 1.5 (R/(R + d))²",
            side = worst.name(),
            distance = format!("{:.1}", worst.distance),
            extent = format!("{:.1}", 2.0 * worst.radius),
            estimate = format!("{:.1}", 100.0 * worst.share()),
        ))
}
