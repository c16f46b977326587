//! The motion of a case: records read, cut, processed and turned into the model's axes.

use super::doubts;
use super::facts::{ENERGY_SHARE, MotionFacts, largest};
use super::memory::Inputs;
use super::{records, target, unlikely};
use tremolite_case::{self as case, Case, Diagnostic};
use tremolite_motion::{Intensity, Kind, Motion, Process, highest_frequency};

/// The given motion in the model's axes, and what to report of it; nothing if there is none or it was refused.
pub fn build(case: &Case, held: &Inputs, problems: &mut Vec<Diagnostic>) -> Option<(Motion, MotionFacts)> {
    let motion = case.motion.as_ref()?;
    let before = problems.len();
    let steps = steps(motion, problems);
    let kind = match motion.kind.value {
        case::MotionKind::Outcrop => Kind::Outcrop,
        case::MotionKind::Incident => Kind::Incident,
        case::MotionKind::Within => Kind::Within,
        case::MotionKind::Surface => Kind::Surface,
    };
    let factor = kind.incident_factor();
    let (mut channels, mut warnings) = records::of(case, motion, held, problems)?;
    let whole = channels.clone();
    if let Some(window) = &motion.window
        && let Err(e) = channels.cut(window.value)
    {
        let (message, remedy) = e.message_and_remedy();
        problems.push(Diagnostic::at(window, message, remedy));
    }
    let target = target::of_case(case).map_err(|problem| problems.push(problem)).ok().flatten();
    for (step, word) in steps.iter().zip(&motion.process) {
        if let Process::Match { .. } = step {
            if problems.len() == before {
                let done = target::matched(motion, target.as_ref(), step, word, &mut channels);
                problems.extend(done.err());
            }
        } else if let Err(e) = step.apply(&mut channels.each()) {
            let (message, remedy) = e.message_and_remedy();
            problems.push(Diagnostic::at(word, message, remedy));
        }
    }
    if problems.len() > before {
        return None;
    }
    warnings.extend(doubts::of_window(motion, whole, &mut channels, &steps));
    warnings.extend(doubts::of_peak(motion, &mut channels, &steps));
    let (mut source, window) = channels.facts();
    let process: Vec<&str> = motion.process.iter().map(|step| step.value.as_str()).collect();
    if !process.is_empty() {
        source = format!("{source}; {}", process.join(", "));
    }
    let made = channels.geographic().and_then(|ground| {
        Motion::from_acceleration(ground.dt, ground.model_axes(motion.model_x_azimuth.value))
    });
    let made = match made {
        Ok(made) => made,
        Err(e) => {
            let (message, remedy) = e.message_and_remedy();
            problems.push(Diagnostic::new(motion.span.clone(), message, remedy));
            return None;
        }
    };
    let Some(highest_frequency) = highest_frequency(&made, ENERGY_SHARE) else {
        let message = "the motion is zero everywhere, so the run would do nothing";
        problems.push(Diagnostic::new(
            motion.span.clone(),
            message,
            "check the records, the window and the scale",
        ));
        return None;
    };
    if let Some(problem) = factor.and_then(|factor| beyond_any_earthquake(&motion.span, &made, factor)) {
        problems.push(problem);
        return None;
    }
    warnings.extend(unlikely::record(motion, &made));
    warnings.extend(doubts::of_sampling(motion, made.dt, highest_frequency));
    let facts = MotionFacts {
        kind,
        factor,
        site: None,
        waves: Vec::new(),
        condition: None,
        lead: 0.0,
        series: 0,
        incident_peak: made.acceleration.each_ref().map(|a| factor.unwrap_or(1.0) * largest(a)),
        intensity: made.acceleration.each_ref().map(|a| Intensity::of_samples(a, made.dt)),
        source,
        window,
        highest_frequency,
        lowpass: tremolite_motion::lowest_lowpass(&steps),
        warnings,
    };
    Some((made, facts))
}

/// More than any ground has moved in an earthquake: peaks of the incident wave \[m/s²\], \[m/s\], \[m\].
const LIMITS: [(f64, &str); 3] = [(5.0 * 9.80665, "m/s2"), (5.0, "m/s"), (5.0, "m")];

/// The refusal of an incident wave that is a mistake of units or a drifting record.
pub(super) fn beyond_any_earthquake(
    place: &std::ops::Range<usize>,
    motion: &Motion,
    factor: f64,
) -> Option<Diagnostic> {
    let series = [
        ("acceleration", &motion.acceleration),
        ("velocity", &motion.velocity),
        ("displacement", &motion.displacement),
    ];
    for ((what, components), (limit, unit)) in series.into_iter().zip(LIMITS) {
        let peak = factor * components.iter().map(|x| largest(x)).fold(0.0, f64::max);
        if peak > limit {
            return Some(Diagnostic::new(
                place.clone(),
                format!(
                    "the incident wave reaches {peak:.3} {unit} of {what}, more than any earthquake: the limit is \
                     {limit:.3} {unit}"
                ),
                "look at the record's units and scale; velocity and displacement that grow are drift, which \"baseline\" as \
                 the last step of motion.process takes out",
            ));
        }
    }
    None
}

/// The steps of processing; those that cannot be read are among the problems.
fn steps(motion: &case::Motion, problems: &mut Vec<Diagnostic>) -> Vec<Process> {
    motion
        .process
        .iter()
        .filter_map(|word| match Process::parse(word) {
            Ok(step) => Some(step),
            Err(message) => {
                // The reader of steps tells their forms behind what is wrong.
                let (what, remedy) = message.split_once("; ").unwrap_or((&message, "see docs/records.md"));
                problems.push(Diagnostic::at(word, what, remedy));
                None
            }
        })
        .collect()
}
