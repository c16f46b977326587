//! How a run went, in words.

use crate::evidence::Evidence;
use crate::phrases::{listed, sentences};
use crate::simulation::Ending;
use indexmap::IndexMap;
use tremolite_engine::engine::Relaxed;
use tremolite_engine::{Found, Halt};
use tremolite_kernels::Line;
use tremolite_results::{GroupStress, Said, TrustLine, said};

/// How it ended, how many checks pass, and the largest stresses.
pub(crate) fn run_in_words(
    evidence: &Evidence,
    trust: &[TrustLine],
    stress: &IndexMap<String, GroupStress>,
) -> Said {
    let Evidence { outcome, plan, model, .. } = evidence;
    let ended = match &outcome.ending {
        Ending::Restless { stage, relaxed, place } => {
            let number = format!("{:03}", outcome.stages.len());
            restless(stage, plan.field_file(&number, model.mesh.elements.len()), relaxed, place)
        }
        Ending::SnappedBack { stage, lost, held } => snapped_back(stage, *lost, *held),
        Ending::Failed { halt, place } => {
            failed(halt, place, outcome.taken as f64 * outcome.dt, outcome.balance[Line::Created])
        }
        Ending::Astray { why } => astray(why, outcome.taken as f64 * outcome.dt),
        Ending::Done | Ending::Stopped => vec![in_good_order(evidence)],
    };
    let mut text = ended;
    text.push(checks(trust));
    if matches!(outcome.ending, Ending::Done | Ending::Stopped) {
        text.extend(stresses(stress, plan.stages.is_empty()));
    }
    sentences(text)
}

fn in_good_order(evidence: &Evidence) -> Said {
    let Evidence { outcome, plan, .. } = evidence;
    let time = outcome.taken as f64 * outcome.dt;
    match &outcome.ending {
        Ending::Done if plan.duration == 0.0 => said!(
            "All {stages} stages came to rest; there is no earthquake in this case.",
            stages = outcome.stages.len().to_string(),
        ),
        Ending::Done => said!("The run reached its end, {time} s.", time = format!("{time:.2}")),
        _ => match plan.stages.get(outcome.stages.len()) {
            Some(stage) => {
                said!("The run was stopped in the stage '{name}'; go on with --resume.", name = &stage.name)
            }
            None => {
                said!("The run was stopped at {time} s; go on with --resume.", time = format!("{time:.3}"))
            }
        },
    }
}

/// Why a run was ended whose energy grew out of nothing, of which laws of materials created so much \[J\].
fn failed(halt: &Halt, place: &Said, time: f64, created: f64) -> Vec<Said> {
    let (time, joule) = (format!("{time:.4}"), |x: &f64| format!("{x:.3e}"));
    let Halt { what, found, supplied, .. } = halt;
    let why = match (found.is_finite(), what) {
        (true, Found::Held) => said!(
            "The run became unstable and was stopped at {time} s: what moves and what is deformed hold {energy} J more than at rest where {supplied} J were supplied.",
            time = time,
            energy = joule(found),
            supplied = joule(supplied),
        ),
        (true, Found::InNoLine) => said!(
            "The run became unstable and was stopped at {time} s: {energy} J are in no line of its energy balance where {supplied} J were supplied.",
            time = time,
            energy = joule(found),
            supplied = joule(supplied),
        ),
        (true, Found::AtLevels) => said!(
            "The run became unstable and was stopped at {time} s: the borders of the levels of steps gave {energy} J where {supplied} J were supplied.",
            time = time,
            energy = joule(found),
            supplied = joule(supplied),
        ),
        (false, _) => {
            said!("The run became unstable and was stopped at {time} s: its motion overflowed.", time = time,)
        }
    };
    let remedy = if created > *supplied {
        said!(
            "Laws of materials gave out {created} J (created_by_law in energy.csv), more than was supplied, which no smaller step \
             mends: split = \"effective\" does so once concrete has cracked, \"compliance\" does not.",
            created = joule(&created),
        )
    } else {
        said!("Use a smaller time_step or safety.")
    };
    let place = said!("Most of it is in {place}.", place = place.clone());
    vec![why, place, remedy]
}

/// Why a run was ended whose motion is beyond what method and laws are made for.
fn astray(why: &Said, time: f64) -> Vec<Said> {
    let stopped =
        said!("The run was stopped at {time} s: {why}.", time = format!("{time:.4}"), why = why.clone());
    vec![stopped, said!("Rows, fields and checkpoints before it are valid.")]
}

/// Why a stage that moves nodes was given up.
fn snapped_back(stage: &str, lost: f64, held: f64) -> Vec<Said> {
    let joule = |x: f64| format!("{x:.2e}");
    let why = said!(
        "In the stage '{stage}' the specimen snapped back: in one step it released {lost} J of the {held} J that it stored. It stored more than its cracks dissipate (a bond that breaks dissipates nothing), so there is no equilibrium in between.",
        stage = stage,
        lost = joule(lost),
        held = joule(held),
    );
    let remedy = said!(
        "The rows before it are valid. Prescribe the displacement nearer to the crack, as in a test controlled by the opening of the crack; take a shorter or less slender specimen; or give more and smaller `steps` if the force had not reached its peak."
    );
    vec![why, remedy]
}

/// Why a stage did not come to rest, of whose motion a file of fields tells.
fn restless(stage: &str, file: String, relaxed: &Relaxed, place: &Said) -> Vec<Said> {
    let (Relaxed::AtRest(rest) | Relaxed::Stopped(rest) | Relaxed::Restless(rest) | Relaxed::Torn(rest, _)) =
        relaxed;
    let cycles = rest.cycles.to_string();
    let why = match relaxed {
        Relaxed::Torn(..) => said!(
            "The stage '{stage}' did not come to rest: after {cycles} cycles elements there had strained by a tenth or moved by \
             more than their own length: nothing holds them.",
            stage = stage,
            cycles = cycles,
        ),
        _ => said!(
            "The stage '{stage}' did not come to rest: after {cycles} cycles {ratio} of all forces were out of balance and \
             {left} m of motion were left.",
            stage = stage,
            cycles = cycles,
            ratio = format!("{:.1e}", rest.ratio),
            left = format!("{:.1e}", rest.left),
        ),
    };
    let place = said!(
        "Most moves {place}, as `motion_of_last_cycle` in stages/{file} shows.",
        place = place.clone(),
        file = file,
    );
    let remedy = match relaxed {
        Relaxed::Torn(..) => said!(
            "The ground there has lost its support and falls: support it, excavate less in one stage, or release it in smaller shares (`release`)."
        ),
        _ => said!(
            "Give more `max_cycles` if it was on its way to rest (relaxation.csv shows it). Ground that has lost its support falls: support it, excavate less in one stage, or release it in smaller shares (`release`)."
        ),
    };
    vec![why, place, remedy]
}

fn checks(trust: &[TrustLine]) -> Said {
    let judged = || trust.iter().filter(|line| !line.not_applicable);
    let passed = judged().filter(|line| line.pass).count().to_string();
    let judged = judged().count().to_string();
    let warned: Vec<Said> =
        trust.iter().filter(|line| !line.pass).map(|line| line.name_message.clone()).collect();
    match warned.is_empty() {
        true => said!("{passed} of {judged} checks of the run pass.", passed = passed, judged = judged),
        false => said!(
            "{passed} of {judged} checks of the run pass; look at: {names}.",
            passed = passed,
            judged = judged,
            names = listed(warned),
        ),
    }
}

/// The largest principal stress of each group; nothing where none is known.
fn stresses(stress: &IndexMap<String, GroupStress>, alone: bool) -> Option<Said> {
    let known = stress.iter().filter(|(_, of)| of.whole && of.s1.value.is_finite());
    let peaks: Vec<Said> = known
        .map(|(name, of)| {
            said!(
                "{stress} MPa in {group} at {time} s",
                stress = format!("{:.2}", of.s1.value / 1e6),
                group = name,
                time = format!("{:.2}", of.s1.time),
            )
        })
        .collect();
    let peaks = (!peaks.is_empty()).then(|| listed(peaks))?;
    Some(match alone {
        true => said!(
            "Largest principal stress (at the fibre of intact elements with several points, otherwise at points): {peaks} (change by the \
             earthquake alone).",
            peaks = peaks,
        ),
        false => said!(
            "Largest principal stress (at the fibre of intact elements with several points, otherwise at points): {peaks} (in all, initial \
             stress included).",
            peaks = peaks,
        ),
    })
}

#[cfg(test)]
mod tests {
    use super::failed;
    use tremolite_engine::{Found, Halt};
    use tremolite_results::Said;

    #[test]
    fn the_remedy_is_for_what_made_the_energy() {
        let halt = Halt { what: Found::Held, found: 4e10, supplied: 1e10, step: 9, time: 1.0 };
        let told = |created| {
            let told = failed(&halt, &Said::plain("element 7"), 1.0, created);
            told.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ")
        };
        assert!(told(9e9).contains("smaller time_step") && !told(9e9).contains("compliance"));
        assert!(told(9e10).contains("gave out 9.000e10 J") && !told(9e10).contains("smaller time_step"));
    }
}
