//! What interfaces did, as a table.

use serde::Serialize;
use tremolite_results::{InterfaceSummary, MaterialValue, PairPeak, Summary};

use crate::scale::{count, figures, quantity, trimmed};

/// All interfaces side by side.
#[derive(Serialize)]
pub struct InterfaceTable {
    pub names: Vec<String>,
    pub rows: Vec<InterfaceRow>,
}

/// One quantity of each.
#[derive(Serialize)]
pub struct InterfaceRow {
    pub name: &'static str,
    /// What it is, over which pairs and steps.
    pub meaning: &'static str,
    pub values: Vec<Entry>,
}

/// A value with its small print.
#[derive(Serialize)]
pub struct Entry {
    pub value: String,
    pub note: String,
}

/// A row before it is filled in.
type Wanted = (&'static str, &'static str, fn(&InterfaceSummary) -> Entry);

const ROWS: [Wanted; 13] = [
    ("Law", "", |own| entry(own.law.clone(), String::new())),
    ("Parameters", "of the law", |own| entry(parameters(own), String::new())),
    ("Area", "and the pairs of nodes that share it", |own| entry(area(own.area), pairs(own))),
    ("Normal stiffness k_n0", "closed and unloaded", |own| {
        let chosen = if own.chosen { "chosen by the program" } else { "given" };
        entry(quantity("Pa/m", own.normal_stiffness), chosen.into())
    }),
    ("Closure at 1\u{a0}MPa", "by the law", |own| entry(length(own.closure_at_1_mpa), String::new())),
    ("Area that ever slid", "in any step", |own| part(own, own.ever_slid)),
    ("Area that ever opened", "in any step", |own| part(own, own.ever_opened)),
    ("Area sliding at the end", "", |own| part(own, own.sliding)),
    ("Area open at the end", "", |own| part(own, own.open)),
    ("Largest slip", "of closed pairs whose bond is broken, of all steps", |own| peak(&own.max_slip)),
    ("Largest gap", "of all pairs whose bond is broken and all steps", |own| peak(&own.max_gap)),
    ("Largest pressure", "of all pairs and steps", |own| {
        let from = own.straight_from;
        let beyond = own.max_pressure > from;
        let note = format!("beyond {}, from which on the law is straight", trimmed(&quantity("Pa", from)));
        entry(quantity("Pa", own.max_pressure), if beyond { note } else { String::new() })
    }),
    (
        "Energy found at impacts",
        "over the run, negative where it was lost; part of the balance's error",
        |own| entry(quantity("J", own.impact_gain), String::new()),
    ),
];

/// The table; nothing for a run without interfaces.
pub fn table(summary: &Summary) -> Option<InterfaceTable> {
    let names: Vec<String> = summary.interfaces.keys().cloned().collect();
    let row = |&(name, meaning, value): &Wanted| InterfaceRow {
        name,
        meaning,
        values: summary.interfaces.values().map(value).collect(),
    };
    (!names.is_empty()).then(|| InterfaceTable { names, rows: ROWS.iter().map(row).collect() })
}

/// The largest slip and gap of all interfaces that slid or opened: what it is, the value, and of which interface where.
pub fn extremes(facts: &Summary) -> Vec<(&'static str, String, String)> {
    type Wanted = (&'static str, fn(&InterfaceSummary) -> Option<&PairPeak>);
    let wanted: [Wanted; 2] = [
        ("Largest slip of an interface", |own| (own.ever_slid > 0.0).then_some(&own.max_slip)),
        ("Largest gap of an interface", |own| (own.ever_opened > 0.0).then_some(&own.max_gap)),
    ];
    let most = |(label, of): Wanted| {
        let all = facts.interfaces.iter().filter_map(|(name, own)| Some((name, of(own)?)));
        let (name, peak) = all.max_by(|a, b| a.1.value.total_cmp(&b.1.value))?;
        let place = peak.at.map(|c| trimmed(&format!("{c:.1}").replace('-', "−"))).join(",\u{a0}");
        Some((
            label,
            quantity("m", peak.value),
            format!("{name} at ({place}) m, of pairs whose bond is broken, of all steps"),
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

fn length(value: f64) -> String {
    if value == 0.0 { "0".into() } else { quantity("m", value) }
}

fn pairs(own: &InterfaceSummary) -> String {
    let ends = match own.ends {
        0 => String::new(),
        1 => "; ends, closed, at 1 node".into(),
        n => format!("; ends, closed, at {} nodes", count(n)),
    };
    format!("{}\u{a0}pairs{ends}", count(own.pairs))
}

/// A part of the interface's area.
fn part(own: &InterfaceSummary, value: f64) -> Entry {
    let share = 100.0 * value / own.area;
    let known = value > 0.0 && share.is_finite();
    let note = if known { format!("{}\u{a0}%", trimmed(&figures(share, 3))) } else { String::new() };
    entry(if value == 0.0 { "0".into() } else { area(value) }, note)
}

fn peak(peak: &PairPeak) -> Entry {
    let coordinate = |x: f64| trimmed(&format!("{x:.2}").replace('-', "−"));
    let known = peak.value > 0.0 && peak.at.iter().all(|x| x.is_finite());
    let [x, y, z] = peak.at.map(coordinate);
    let note = if known { format!("at\u{a0}({x},\u{a0}{y},\u{a0}{z})") } else { String::new() };
    entry(length(peak.value), note)
}
