//! Checks of what came before the earthquake.

use crate::evidence::Evidence;
use crate::observers::{Beginning, uneven};
use crate::places;
use crate::plan::Plan;
use tremolite_engine::Model;
use tremolite_engine::state::Memory;
use tremolite_results::{Fact, Said, StageSummary, TrustLine, said};

/// What is held besides weight, loads and reactions when the shaking begins, over all contributions: ten times what stages
/// leave out of balance.
const HELD: f64 = 1e-4;
/// Motion to the initial equilibrium over the largest of the stages that follow.
const INITIAL: f64 = 0.1;

/// Change of the initial stress over itself.
const CHANGE: f64 = 0.1;
/// The same of a single element: at the foot of slopes of 15°, 30° and 45° it is 0.21, 0.38 and 0.48, beside an opening in stress that
/// knows nothing of it 0.8.
const LOCAL: f64 = 0.6;

const HELD_ID: &str = "unreleased_force";
const CHANGE_ID: &str = "initial_stress_change";
const INITIAL_ID: &str = "initial_motion";
const LOCAL_ID: &str = "initial_stress_change_local";
const UNEVEN_ID: &str = "initial_motion_local";

/// Those that the initial equilibrium alone settles.
pub(super) const OF_THE_FIRST: [&str; 2] = [CHANGE_ID, LOCAL_ID];

pub(super) fn lines(evidence: &Evidence) -> Vec<TrustLine> {
    let Evidence { model, plan, outcome, .. } = evidence;
    of_stages(model, plan, &outcome.stages, &outcome.state.observers)
}

/// The same of stages alone, with what is remembered of them.
pub(super) fn of_stages(
    model: &Model,
    plan: &Plan,
    stages: &[StageSummary],
    memory: &Memory,
) -> Vec<TrustLine> {
    let held_name = || said!("unreleased force after the last stage over all forces");
    let change_name = || said!("change of the initial stress by the initial equilibrium, relative");
    let initial_name = || said!("displacement of the initial equilibrium over that of the stages");
    let local_name =
        || said!("largest change of an element's initial stress by the initial equilibrium, relative");
    let uneven_name = || {
        said!("largest relative displacement across an element or interface, initial equilibrium over stages")
    };
    let (Some(first), Some(last)) = (stages.first(), stages.last()) else {
        let why = || match plan.stages.is_empty() {
            true => said!("there are no stages before the earthquake"),
            false => said!("no stage came to rest"),
        };
        return vec![
            TrustLine::not_applicable(HELD_ID, held_name(), why()),
            TrustLine::not_applicable(INITIAL_ID, initial_name(), why()),
            TrustLine::not_applicable(UNEVEN_ID, uneven_name(), why()),
            TrustLine::not_applicable(CHANGE_ID, change_name(), why()),
            TrustLine::not_applicable(LOCAL_ID, local_name(), why()),
        ];
    };
    let held = if stages.len() == plan.stages.len() {
        TrustLine::at_most(HELD_ID, held_name(), last.held, HELD, "").with_note(said!(
            "what stages have not let go stays held in the shaking: end with a stage whose `release` is 1"
        ))
    } else {
        TrustLine::not_applicable(HELD_ID, held_name(), said!("not all stages are done"))
    };
    let largest = stages[1..].iter().map(|stage| stage.largest_motion).fold(0.0, f64::max);
    let excavates = stages[1..].iter().any(|stage| !stage.excavated.is_empty());
    let initial = if excavates {
        let share = [first.largest_motion, largest];
        let line = TrustLine::share_at_most(INITIAL_ID, initial_name(), share, INITIAL, still());
        match line.not_applicable {
            true => line,
            false => line.with("initial", first.largest_motion).with("largest", largest).with_note(fits()),
        }
    } else {
        TrustLine::not_applicable(INITIAL_ID, initial_name(), said!("no stage that came to rest excavates"))
    };
    let beginning = Beginning::recall(memory);
    let place = |element: u32| places::element_beside(model, element);
    let uneven = match (beginning, uneven(memory)) {
        (Some(found), Some((initial, later))) if excavates => {
            let line = TrustLine::share_at_most(UNEVEN_ID, uneven_name(), [initial, later], INITIAL, still());
            match line.not_applicable {
                true => line,
                false => line.with("initial", initial).with("largest", later).with_note(said!(
                    "at {place}; {remedy}",
                    place = place(found.uneven_at),
                    remedy = fits()
                )),
            }
        }
        _ => {
            TrustLine::not_applicable(UNEVEN_ID, uneven_name(), said!("no stage that came to rest excavates"))
        }
    };
    let local = match beginning {
        Some(found) if !model.elements.initial.is_empty() => {
            let (share, at) = found.largest_change;
            TrustLine::at_most(LOCAL_ID, local_name(), share, LOCAL, "").with_note(said!(
                "at {place}, over the mean of all where its own is less; {remedy}",
                place = place(at),
                remedy = fits(),
            ))
        }
        _ => TrustLine::not_applicable(LOCAL_ID, local_name(), said!("the ground begins without stress")),
    };
    let change = match beginning {
        Some(found) if !model.elements.initial.is_empty() => TrustLine::at_most(
            CHANGE_ID,
            change_name(),
            found.change,
            CHANGE,
            "",
        )
        .with("imbalance", found.imbalance)
        .with_note(said!(
            "integrated over what stands; {imbalance} of all forces were out of balance at first; {remedy}",
            imbalance = format!("{:.1e}", found.imbalance),
            remedy = fits(),
        )),
        _ => TrustLine::not_applicable(CHANGE_ID, change_name(), said!("the ground begins without stress")),
    };
    vec![held, initial, uneven, change, local]
}

/// Why motion of nothing has no share.
fn still() -> Said {
    said!("nothing moved in the initial equilibrium and in the stages")
}

/// What to look at where the initial stress does not fit.
fn fits() -> Said {
    said!(
        "the initial stress is out of balance where it differs from the weight above, or from what the rock can bear: look at \
         `lateral`, `stress` or `overburden`; on slopes and beside layers some is right"
    )
}

pub(super) fn facts(evidence: &Evidence) -> Vec<Fact> {
    let outcome = evidence.outcome;
    let mut facts = Vec::new();
    if let Some(first) = outcome.stages.first() {
        facts.push(Fact::new(
            "initial_plastic_volume",
            said!("plastic shear strain at the initial equilibrium, integrated"),
            first.plastic_volume,
            "m3",
            said!("rock that yields under the initial stress alone"),
        ));
        let worst = outcome.stages.iter().map(|stage| stage.ratio).fold(0.0, f64::max);
        facts.push(Fact::new(
            "stage_imbalance",
            said!("out-of-balance force over all forces, worst stage"),
            worst,
            "",
            said!("each stage continues until this is below `initial.tolerance` and little motion remains"),
        ));
    }
    if let Some(Beginning { pairs, beyond, .. }) =
        Beginning::recall(&outcome.state.observers).filter(|found| found.pairs > 0)
    {
        let note = said!(
            "of {pairs} that are there from the start: they slid or opened on the way to the initial equilibrium",
            pairs = pairs.to_string(),
        );
        let name = said!("interface pairs whose strength the initial stress exceeds");
        let fact = Fact::new("initial_pairs_beyond_strength", name, beyond as f64, "", note);
        facts.push(fact.with("pairs", pairs as f64));
    }
    if let Some(drift) = outcome.quiet {
        facts.push(Fact::new(
            "drift_without_motion",
            said!("largest displacement in 100 steps without motion"),
            drift,
            "m",
            said!("all forces at rest are held, so only round-off moves the model"),
        ));
    }
    facts
}
