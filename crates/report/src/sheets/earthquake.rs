//! The earthquake in a few lines: its level, its peak, where it is meant.

use tremolite_results::Summary;

use crate::chapter::results_text::kind_of_motion;
use crate::facts::{Fact, card};
use crate::language::say;
use crate::quantities::scale::figures;
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
    for (peaks, label) in [
        (&motion.given_peak_acceleration, say!(language, "Peak acceleration, motion given")),
        (&motion.peak_acceleration, say!(language, "Peak acceleration, incident wave")),
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
    facts
}

/// An acceleration along an axis, in m/s² and g.
fn told(source: &Source, axis: &str, peak: f64) -> String {
    format!("{axis} {} ({}\u{a0}g)", source.quantity(Kind::Acceleration, peak), figures(peak / 9.806_65, 2))
}
