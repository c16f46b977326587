//! The earthquake in a few lines: its level, its peak, where it is meant.

use tremolite_results::{Summary, TargetSpectrum};

use crate::chapter::results_text::kind_of_motion;
use crate::facts::{Fact, card};
use crate::language::say;
use crate::quantities::scale::{figures, trimmed};
use crate::quantities::units::Kind;
use crate::source::Source;

/// What is to be said of the motion; that there is none, where none came.
pub fn facts(source: &Source, summary: &Summary) -> Vec<Fact> {
    let language = source.language;
    let motion = &summary.computed.motion;
    let label = || say!(language, "Design earthquake");
    if motion.kind.is_empty() {
        return vec![card(label(), say!(language, "none in this run"), "")];
    }
    let mut facts = Vec::new();
    let level = &summary.case.report.design_level;
    let level = if level.is_empty() { say!(language, "its level is not given") } else { level.clone() };
    facts.push(card(label(), level, ""));
    let place = match motion.kind.as_str() {
        "outcrop" => say!(language, "on outcropping rock; half of it is the incident wave"),
        "incident" => say!(language, "the incident wave; a rock outcrop moves twice as much"),
        "within" => say!(language, "within the ground, at the depth of the record"),
        "surface" => say!(language, "at the surface of the ground"),
        _ => kind_of_motion(language, &motion.kind),
    };
    // Where the record is meant stands beside it.
    match motion.source.values().next() {
        Some(record) => facts.push(card(say!(language, "Record"), record.clone(), place)),
        None => facts.push(card(say!(language, "Meant"), place, "")),
    }
    let mut peaks_told: Vec<String> = Vec::new();
    // A code's peak is that of an outcrop, where the wave that comes in moves rock by half as much.
    let outcrop: Vec<(String, f64)> = match motion.kind.as_str() {
        "incident" => {
            motion.peak_acceleration.iter().map(|(axis, peak)| (axis.clone(), 2.0 * peak)).collect()
        }
        _ => Vec::new(),
    };
    let outcrop = outcrop.into_iter().collect();
    for (peaks, label) in [
        (&motion.given_peak_acceleration, say!(language, "Peak acceleration, motion given")),
        (&motion.peak_acceleration, say!(language, "Peak acceleration, incident wave")),
        (&outcrop, say!(language, "Peak acceleration, rock outcrop")),
    ] {
        let most = peaks.values().fold(0.0_f64, |most, peak| most.max(peak.abs()));
        // Round-off of a component that the record does not have is no motion.
        let all = peaks.iter().filter(|(_, peak)| peak.abs() > 1e-9 * most);
        let all: Vec<String> = all.map(|(axis, peak)| told(source, axis, peak.abs())).collect();
        let text = all.join("; ");
        // What comes in as it is given is told once.
        if !text.is_empty() && !peaks_told.contains(&text) {
            facts.push(card(label, text.clone(), ""));
            peaks_told.push(text);
        }
    }
    facts.extend(beside_target(source, summary));
    facts
}

/// The motion given over the spectrum that the design calls for: the least and the most over its periods, of the larger horizontal
/// component at each.
fn beside_target(source: &Source, summary: &Summary) -> Option<Fact> {
    let language = source.language;
    let target = summary.computed.motion.target.as_ref()?;
    let Some(Ok(table)) = &source.spectra else { return None };
    let periods = table.column("period")?;
    let along: Vec<&[f64]> =
        ["given.ax", "given.ay"].into_iter().filter_map(|name| table.column(name)).collect();
    let ratio = |k: usize| {
        let called = at(target, periods[k])?;
        let most = along.iter().filter_map(|sa| sa.get(k)).fold(0.0_f64, |most, sa| most.max(*sa));
        (most > 0.0 && called > 0.0).then(|| (periods[k], most / called))
    };
    let ratios: Vec<(f64, f64)> = (0..periods.len()).filter_map(ratio).collect();
    let least = ratios.iter().min_by(|a, b| a.1.total_cmp(&b.1))?;
    let most = ratios.iter().max_by(|a, b| a.1.total_cmp(&b.1))?;
    let text = say!(
        language,
        "{least} at {short}\u{a0}s to {most} at {long}\u{a0}s",
        least = figures(least.1, 2),
        short = trimmed(&figures(least.0, 2)),
        most = figures(most.1, 2),
        long = trimmed(&figures(most.0, 2))
    );
    let mut below: Vec<f64> =
        ratios.iter().filter(|(_, ratio)| *ratio < LEAST_RATIO).map(|(t, _)| *t).collect();
    below.sort_by(f64::total_cmp);
    let period = |t: f64| trimmed(&figures(t, 2));
    let label = say!(language, "Motion given over design spectrum");
    let note = say!(language, "the larger horizontal component, 5 % damping");
    Some(match below[..] {
        [] => {
            let text = say!(language, "{ratio}: nowhere below 0.9 (EN 1998-1 3.2.3.1.2)", ratio = text);
            card(label, text, note)
        }
        [first, ..] => {
            let text = say!(
                language,
                "{ratio}: below 0.9 at {number} of {all} periods between {first} and {last}\u{a0}s, where EN 1998-1 3.2.3.1.2 asks for 0.9 of the mean of all records from 0.2 to 2 T_1",
                ratio = text,
                number = below.len(),
                all = ratios.len(),
                first = period(first),
                last = period(below[below.len() - 1])
            );
            card(label, text, note).warning()
        }
    })
}

/// Of the spectrum called for, which that of the motion must not fall below.
const LEAST_RATIO: f64 = 0.9;

/// A spectrum at a period \[s\], straight between its points in logarithms; none beyond them, or beside one that is 0.
fn at(spectrum: &TargetSpectrum, period: f64) -> Option<f64> {
    let behind = spectrum.period.iter().position(|t| *t >= period)?;
    let points = behind.checked_sub(1).map_or([behind, behind], |before| [before, behind]);
    let [(t0, a0), (t1, a1)] = points.map(|k| (spectrum.period[k], *spectrum.sa.get(k).unwrap_or(&0.0)));
    if t1 == period {
        return Some(a1);
    }
    (t0 < period && t0.min(a0).min(a1) > 0.0)
        .then(|| a0 * (a1 / a0).powf((period / t0).ln() / (t1 / t0).ln()))
}

/// An acceleration along an axis, in m/s² and g.
fn told(source: &Source, axis: &str, peak: f64) -> String {
    format!("{axis} {} ({}\u{a0}g)", source.quantity(Kind::Acceleration, peak), figures(peak / 9.806_65, 2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_spectrum_is_straight_in_logarithms_and_none_beyond_its_ends() {
        let spectrum = TargetSpectrum { period: vec![0.1, 1.0, 2.0], sa: vec![4.0, 1.0, 0.0] };
        for (period, expected) in [(0.1, 4.0), (10f64.powf(-0.5), 2.0), (1.0, 1.0), (2.0, 0.0)] {
            let found = at(&spectrum, period).unwrap();
            assert!((found - expected).abs() < 1e-12, "{period}: {found}");
        }
        for period in [0.05, 1.5, 3.0] {
            assert_eq!(at(&spectrum, period), None, "{period}");
        }
    }
}
