//! The motion of a case: records read, cut, processed and turned into the model's axes.

use super::doubts;
use super::facts::{ENERGY_SHARE, MotionFacts, Peaks, largest};
use super::memory::Inputs;
use super::processing::{Processing, steps};
use super::{records, target, unlikely};
use tremolite_case::{self as case, Case, Diagnostic};
use tremolite_motion::{Intensity, Kind, Motion, TargetSpectrum, highest_frequency};

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
    let cut = channels.clone();
    let target = target::of_case(case).map_err(|problem| problems.push(problem)).ok().flatten();
    let processing = Processing { motion, target: target.as_ref(), steps: &steps };
    processing.apply(&mut channels, steps.len(), problems, before);
    if problems.len() > before {
        return None;
    }
    warnings.extend(doubts::of_reach(motion, &whole));
    warnings.extend(doubts::of_window(&processing, whole, cut, &channels));
    warnings.extend(doubts::of_peak(motion, &mut channels, &steps));
    warnings.extend(doubts::of_steps(&processing, &channels));
    let (mut source, window) = channels.facts();
    let process: Vec<&str> = motion.processing.iter().map(|step| step.value.as_str()).collect();
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
    // Of a motion that is zero everywhere, a test of rest, 0.
    let highest_frequency = highest_frequency(&made, ENERGY_SHARE).unwrap_or(0.0);
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
        incident: Peaks::of(&made, factor.unwrap_or(1.0)),
        design_displacement: target.as_ref().and_then(TargetSpectrum::design_displacement),
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
                 the last step of motion.processing takes out",
            ));
        }
    }
    None
}
