//! What interfaces did: as a table here, over time, developed flat, and at single pairs in the files below.

pub mod history;
pub mod map;
pub mod map_panel;
pub mod monitors;
mod shear_path;

use serde::Serialize;
use tremolite_results::{InterfaceSummary, MaterialValue, PairPeak, Summary};

use crate::language::{Language, say};
use crate::quantities::scale::{count, figures, quantity, trimmed};
use crate::quantities::units::Kind;
use crate::source::Source;

/// All interfaces side by side.
#[derive(Serialize)]
pub struct InterfaceTable {
    pub names: Vec<String>,
    pub rows: Vec<InterfaceRow>,
}

/// One quantity of each.
#[derive(Serialize)]
pub struct InterfaceRow {
    pub name: String,
    /// What it is, over which pairs and steps.
    pub meaning: String,
    pub values: Vec<Entry>,
}

/// A value with its small print.
#[derive(Serialize)]
pub struct Entry {
    pub value: String,
    pub note: String,
}

/// A row before it is filled in.
type Wanted = (String, String, fn(&Source, &InterfaceSummary) -> Entry);

fn rows(language: Language) -> [Wanted; 13] {
    let none = String::new;
    [
        (say!(language, "Law"), none(), |_, own| entry(own.law.clone(), String::new())),
        (say!(language, "Parameters"), say!(language, "of the law"), |_, own| {
            entry(parameters(own), String::new())
        }),
        (say!(language, "Area"), say!(language, "and the pairs of nodes that share it"), |source, own| {
            entry(area(own.area), pairs(source.language, own))
        }),
        (say!(language, "Normal stiffness k_n0"), say!(language, "closed and unloaded"), |source, own| {
            let language = source.language;
            let chosen =
                if own.chosen { say!(language, "chosen by the program") } else { say!(language, "given") };
            entry(quantity("Pa/m", own.normal_stiffness), chosen)
        }),
        (say!(language, "Closure at 1\u{a0}MPa"), say!(language, "by the law"), |source, own| {
            entry(length(source, own.closure_at_1_mpa), String::new())
        }),
        (say!(language, "Area that ever slid"), say!(language, "in any step"), |_, own| {
            part(own, own.ever_slid)
        }),
        (say!(language, "Area that ever opened"), say!(language, "in any step"), |_, own| {
            part(own, own.ever_opened)
        }),
        (say!(language, "Area sliding at the end"), none(), |_, own| part(own, own.sliding)),
        (say!(language, "Area open at the end"), none(), |_, own| part(own, own.open)),
        (
            say!(language, "Largest slip"),
            say!(language, "of closed pairs whose bond is broken, of all steps"),
            |source, own| peak(source, &own.max_slip),
        ),
        (
            say!(language, "Largest gap"),
            say!(language, "of all pairs whose bond is broken and all steps"),
            |source, own| peak(source, &own.max_gap),
        ),
        (say!(language, "Largest pressure"), say!(language, "of all pairs and steps"), |source, own| {
            let language = source.language;
            let from = own.straight_from;
            let beyond = own.max_pressure > from;
            let note = || {
                say!(
                    language,
                    "above {pressure}, where the stiffness is constant",
                    pressure = trimmed(&source.quantity(Kind::Stress, from))
                )
            };
            entry(
                source.quantity(Kind::Stress, own.max_pressure),
                if beyond { note() } else { String::new() },
            )
        }),
        (
            say!(language, "Energy found at impacts"),
            say!(language, "over the run, negative where it was lost; part of the balance's error"),
            |source, own| entry(source.quantity(Kind::Energy, own.impact_gain), String::new()),
        ),
    ]
}

/// The table; nothing for a run without interfaces.
pub fn table(source: &Source, summary: &Summary) -> Option<InterfaceTable> {
    let names: Vec<String> = summary.parts.interfaces.keys().cloned().collect();
    let row = |(name, meaning, value): Wanted| InterfaceRow {
        name,
        meaning,
        values: summary.parts.interfaces.values().map(|own| value(source, own)).collect(),
    };
    (!names.is_empty())
        .then(|| InterfaceTable { names, rows: rows(source.language).into_iter().map(row).collect() })
}

/// The largest slip and gap of all interfaces that slid or opened: what it is, the value, and of which interface where.
pub fn extremes(source: &Source, facts: &Summary) -> Vec<(String, String, String)> {
    let language = source.language;
    type Wanted = (String, fn(&InterfaceSummary) -> Option<&PairPeak>);
    let wanted: [Wanted; 2] = [
        (say!(language, "Largest slip of an interface"), |own| {
            (own.ever_slid > 0.0).then_some(&own.max_slip)
        }),
        (say!(language, "Largest gap of an interface"), |own| {
            (own.ever_opened > 0.0).then_some(&own.max_gap)
        }),
    ];
    let most = |(label, of): Wanted| {
        let all = facts.parts.interfaces.iter().filter_map(|(name, own)| Some((name, of(own)?)));
        let (name, peak) = all.max_by(|a, b| a.1.value.total_cmp(&b.1.value))?;
        let place = peak.at.map(|c| trimmed(&format!("{c:.1}").replace('-', "−"))).join(",\u{a0}");
        Some((
            label,
            source.quantity(Kind::Opening, peak.value),
            say!(
                language,
                "{name} at ({place}) m, of pairs whose bond is broken, of all steps",
                name = name,
                place = place
            ),
        ))
    };
    wanted.into_iter().filter_map(most).collect()
}

fn entry(value: String, note: String) -> Entry {
    Entry { value, note }
}

/// But for the stiffness, which has a row of its own.
fn parameters(own: &InterfaceSummary) -> String {
    let own = own.values.iter().filter(|value| value.name != "normal_stiffness");
    let value = |v: &MaterialValue| match v.word.is_empty() {
        true => trimmed(&quantity(&v.unit, v.value)),
        false => v.word.clone(),
    };
    own.map(|v| format!("{}\u{a0}{}", v.name, value(v))).collect::<Vec<_>>().join(", ")
}

fn area(value: f64) -> String {
    format!("{}\u{a0}m²", trimmed(&figures(value, 4)))
}

fn length(source: &Source, value: f64) -> String {
    if value == 0.0 { "0".into() } else { source.size(Kind::Opening, value) }
}

fn pairs(language: Language, own: &InterfaceSummary) -> String {
    let pairs = count(own.pairs);
    match own.ends {
        0 => say!(language, "{pairs}\u{a0}pairs", pairs = pairs),
        1 => say!(language, "{pairs}\u{a0}pairs; ends, closed, at 1 node", pairs = pairs),
        n => say!(
            language,
            "{pairs}\u{a0}pairs; ends, closed, at {ends} nodes",
            pairs = pairs,
            ends = count(n)
        ),
    }
}

/// A part of the interface's area.
fn part(own: &InterfaceSummary, value: f64) -> Entry {
    let share = 100.0 * value / own.area;
    let known = value > 0.0 && share.is_finite();
    let note = if known { format!("{}\u{a0}%", trimmed(&figures(share, 3))) } else { String::new() };
    entry(if value == 0.0 { "0".into() } else { area(value) }, note)
}

fn peak(source: &Source, peak: &PairPeak) -> Entry {
    let language = source.language;
    let coordinate = |x: f64| trimmed(&format!("{x:.2}").replace('-', "−"));
    let known = peak.value > 0.0 && peak.at.iter().all(|x| x.is_finite());
    let [x, y, z] = peak.at.map(coordinate);
    let note = || say!(language, "at\u{a0}({x},\u{a0}{y},\u{a0}{z})", x = x, y = y, z = z);
    let note = if known { note() } else { String::new() };
    entry(length(source, peak.value), note)
}
