//! What the page says in words and numbers: outcome, key results, trust, the model.

use indexmap::IndexMap;
use serde::Serialize;
use tremolite_results::{Bound, Finding, Peaks, Severity, Status, Summary, Table, TrustLine};

use crate::bolt_card;
use crate::damage::opening;
use crate::energy::worst_error;
use crate::interfaces;
use crate::scale::{count, figures, moment, quantity, span, trimmed};
use crate::source::Source;

/// An outcome at the top of the page.
#[derive(Serialize)]
pub struct Outcome {
    /// `good`, `warn` or `bad`: the colour.
    pub class: &'static str,
    pub headline: String,
    pub text: String,
}

/// A label with a value, and where or what in small print.
#[derive(Serialize)]
pub struct Fact {
    pub label: String,
    pub value: String,
    pub note: String,
}

/// A line of the trust table.
#[derive(Serialize)]
pub struct Check {
    pub name: String,
    pub value: String,
    pub limit: String,
    /// `pass`, `warn`, or a dash for a line that cannot be judged.
    pub mark: &'static str,
    pub note: String,
}

/// Outcome of the run and colour of its banner.
pub fn outcome(source: &Source) -> Outcome {
    let Ok(summary) = &source.summary else {
        let why = source.summary.as_ref().err().cloned().unwrap_or_default();
        return Outcome { class: "warn", headline: "No summary of the run".into(), text: why };
    };
    let (judged, warnings) = (summary.judged(), summary.warnings());
    let (class, headline) = match summary.status {
        Status::Failed => ("bad", "Run: failed".to_owned()),
        Status::Stopped => ("warn", "Run: stopped before its end".into()),
        Status::Done if judged == 0 => ("warn", "Run: done, but nothing was checked".into()),
        Status::Done if warnings == 0 => ("good", format!("Run: sound ({judged} of {judged} checks pass)")),
        Status::Done if warnings == 1 => ("warn", format!("Run: done, 1 of {judged} checks warns")),
        Status::Done => ("warn", format!("Run: done, {warnings} of {judged} checks warn")),
    };
    let text = if summary.outcome.is_empty() { &summary.verdict } else { &summary.outcome };
    Outcome { class, headline, text: text.clone() }
}

/// What became of each structure, each a banner of its own: a sound run may show a lining that fails.
pub fn findings(summary: &Summary) -> Vec<Outcome> {
    let banner = |finding: &Finding| Outcome {
        class: match finding.severity {
            Severity::Undamaged => "good",
            Severity::Damaged => "warn",
            Severity::Through => "bad",
        },
        headline: format!("{}: {}", finding.group, finding.headline),
        text: finding.text.clone(),
    };
    summary.findings.iter().map(banner).collect()
}

/// The few numbers that a reader wants first.
pub fn key_results(source: &Source) -> Vec<Fact> {
    let facts = source.facts();
    let duration = duration(source);
    let at = |time: f64| format!("{}\u{a0}s", moment(time, duration));
    let mut cards = stage_cards(&facts);
    if let Ok(table) = &source.monitors
        && let Some((monitor, time, size)) = longest(table, facts.monitors.keys())
    {
        cards.push(card(
            "Largest displacement of a monitor",
            quantity("m", size),
            &format!("{monitor} at {}", at(time)),
        ));
    }
    let component = |name: &str| ["ux", "uy", "uz"].contains(&name);
    let most = extreme(&facts.relative, component, |p| p.largest().1.abs());
    if let Some((pair, name, peaks)) = most {
        let (time, value) = peaks.largest();
        let note = format!("{pair}, {}, at {}", name.trim_start_matches('u'), at(time));
        cards.push(card("Largest relative displacement, one component", quantity("m", value.abs()), &note));
    }
    cards.extend(stress_cards(&facts, at));
    let cracks = facts.damage.iter().filter_map(|(name, group)| Some((name, group.cracks.as_ref()?)));
    let cracks = cracks.filter_map(|(name, cracks)| Some((name, cracks, cracks.widest?)));
    // Of equal ones the first: the whole stands before its parts.
    let wider = cracks.reduce(|a, b| if b.1.opening > a.1.opening { b } else { a });
    if let Some((group, cracks, widest)) = wider {
        let note = format!("{group} at {}", at(widest.time));
        cards.push(card("Widest crack", opening(cracks), &note));
    }
    let extremes = interfaces::extremes(source.language, &facts).into_iter();
    cards.extend(extremes.map(|(label, value, note)| card(&label, value, &note)));
    cards.extend(
        bolt_card::hardest(source.language, &facts)
            .map(|(value, note)| card("Force of the bolt nearest to yield", value, &note)),
    );
    // As the check has it; summaries of other versions leave it to the table.
    let checked = facts.trust.iter().find(|line| line.id == "energy_error");
    let checked = checked.and_then(|line| Some((*line.numbers.get("error")?, line.value)));
    let of_table = || source.energy.as_ref().ok().and_then(worst_error);
    if let Some((error, ratio)) = checked.or_else(of_table) {
        let note = format!("{}, of the largest energy held", quantity("J", error));
        cards.push(card(
            "Largest error of the energy balance",
            format!("{}\u{a0}%", figures(100.0 * ratio, 2)),
            &note,
        ));
    }
    cards
}

/// What the stages before the shaking left: the most that a wall moved, what has yielded, and how far from rest it is.
fn stage_cards(facts: &Summary) -> Vec<Fact> {
    let mut cards = Vec::new();
    let Some(last) = facts.stages.last().filter(|_| facts.stages.len() > 1) else { return cards };
    let size = |u: &[f64; 3]| u.iter().map(|x| x * x).sum::<f64>().sqrt();
    let moved = last.walls.iter().map(|(name, u)| (name, size(u))).filter(|(_, size)| size.is_finite());
    if let Some((name, size)) = moved.max_by(|a, b| a.1.total_cmp(&b.1)) {
        let note = format!("{name}, after the last stage, since the initial equilibrium");
        cards.push(card("Largest motion of a wall in the stages", quantity("m", size), &note));
    }
    if last.plastic_volume > 0.0 {
        let value = format!("{}\u{a0}m³", figures(last.plastic_volume, 3));
        cards.push(card("Plastic shear strain × volume, ∫Γ dV", value, "after the last stage"));
    }
    cards
}

/// The largest stresses of all groups; of the monitors in summaries that know of none.
fn stress_cards(facts: &Summary, at: impl Fn(f64) -> String) -> Vec<Fact> {
    let mut cards = Vec::new();
    let groups = || facts.stress.iter().filter(|(_, stress)| stress.whole);
    let most = groups().max_by(|a, b| a.1.s1.value.total_cmp(&b.1.s1.value)).map(|(name, s)| (name, &s.s1));
    let least = groups().min_by(|a, b| a.1.s3.value.total_cmp(&b.1.s3.value)).map(|(name, s)| (name, &s.s3));
    for (label, found) in [("Largest principal stress s1", most), ("Smallest principal stress s3", least)] {
        if let Some((group, peak)) = found {
            let note = format!(
                "{group} at {}; at the fibre of intact 2×2×2 elements, else at points",
                at(peak.time)
            );
            cards.push(card(label, quantity("Pa", peak.value), &note));
        }
    }
    if !cards.is_empty() {
        return cards;
    }
    if let Some((monitor, _, peaks)) = extreme(&facts.monitors, |name| name == "s1", |p| p.max) {
        let note = format!("monitor {monitor} at {}", at(peaks.t_max));
        cards.push(card("Largest principal stress s1", quantity("Pa", peaks.max), &note));
    }
    if let Some((monitor, _, peaks)) = extreme(&facts.monitors, |name| name == "s3", |p| -p.min) {
        let note = format!("monitor {monitor} at {}", at(peaks.t_min));
        cards.push(card("Smallest principal stress s3", quantity("Pa", peaks.min), &note));
    }
    cards
}

/// How long the histories are (s); without them, how long the run was to be.
pub(crate) fn duration(source: &Source) -> f64 {
    let last = source.monitors.as_ref().ok().and_then(|table| table.column("time")?.last().copied());
    last.unwrap_or(source.facts().model.duration)
}

/// Monitor, time and length of the longest displacement vector.
fn longest<'a>(table: &Table, monitors: impl Iterator<Item = &'a String>) -> Option<(&'a str, f64, f64)> {
    let time = table.column("time")?;
    let mut best: Option<(&str, f64, f64)> = None;
    for monitor in monitors {
        let parts = ["ux", "uy", "uz"].map(|q| table.column(&format!("{monitor}.{q}")));
        let parts: Vec<&[f64]> = parts.into_iter().flatten().collect();
        if parts.is_empty() {
            continue;
        }
        for (row, &t) in time.iter().enumerate() {
            let length = parts.iter().map(|part| part[row] * part[row]).sum::<f64>().sqrt();
            if length.is_finite() && best.is_none_or(|(_, _, most)| length > most) {
                best = Some((monitor, t, length));
            }
        }
    }
    best
}

pub(crate) type ByName = IndexMap<String, IndexMap<String, Peaks>>;

fn extreme(
    all: &ByName,
    wanted: impl Fn(&str) -> bool,
    rank: impl Fn(&Peaks) -> f64,
) -> Option<(&str, &str, Peaks)> {
    let each =
        all.iter().flat_map(|(name, by_quantity)| by_quantity.iter().map(move |(q, peaks)| (name, q, peaks)));
    each.filter(|(_, q, peaks)| wanted(q) && rank(peaks).is_finite())
        .max_by(|a, b| rank(a.2).total_cmp(&rank(b.2)))
        .map(|(name, q, peaks)| (name.as_str(), q.as_str(), *peaks))
}

/// The trust table.
pub fn checks(summary: &Summary) -> Vec<Check> {
    summary.trust.iter().map(check).collect()
}

fn check(line: &TrustLine) -> Check {
    if line.not_applicable {
        let (value, limit) = ("not applicable".into(), String::new());
        return Check { name: line.name.clone(), value, limit, mark: "–", note: line.note.clone() };
    }
    let relation = if line.bound == Bound::AtMost { "≤" } else { "≥" };
    Check {
        name: line.name.clone(),
        value: quantity(&line.unit, line.value),
        limit: format!("{relation}\u{a0}{}", trimmed(&quantity(&line.unit, line.limit))),
        mark: if line.pass { "pass" } else { "warn" },
        note: line.note.clone(),
    }
}

/// Size, time step and motion.
pub fn model(summary: &Summary) -> Vec<Fact> {
    let (model, motion) = (&summary.model, &summary.motion);
    let mut facts = Vec::new();
    if model.elements > 0 {
        let groups: Vec<_> = model.groups.iter().map(|(name, n)| format!("{name} {}", count(*n))).collect();
        facts.push(card("Elements", count(model.elements), &groups.join(", ")));
        facts.push(card("Nodes", count(model.nodes), ""));
    }
    if model.steps > 0 {
        facts.push(card("Time step", quantity("s", model.time_step), &model.step_set_by));
        facts.push(card("Steps", count(model.steps), &format!("{} of shaking", span(model.duration))));
    }
    if !motion.kind.is_empty() {
        let note = format!("incident motion = {} × the motion given", trimmed(&figures(motion.factor, 3)));
        facts.push(card("Kind of motion given", motion.kind.clone(), &note));
    }
    let sources: Vec<&String> = motion.source.values().collect();
    let shared = sources.windows(2).all(|pair| pair[0] == pair[1]);
    if let Some(source) = sources.first().filter(|_| shared) {
        facts.push(card("Record", (*source).clone(), ""));
    }
    // Round-off of a component that the record does not have is no motion.
    let largest = motion.peak_acceleration.values().fold(0.0_f64, |most, x| most.max(x.abs()));
    for (axis, &peak) in &motion.peak_acceleration {
        let peak = if peak.abs() < 1e-9 * largest { 0.0 } else { peak };
        let source = motion.source.get(axis).filter(|_| !shared).map_or("", String::as_str);
        let value = format!("{} ({}\u{a0}g)", quantity("m/s2", peak), figures(peak / 9.806_65, 2));
        facts.push(card(&format!("Peak incident acceleration, {axis}"), value, source));
    }
    for fact in &summary.facts {
        facts.push(card(&capital(&fact.name), trimmed(&quantity(&fact.unit, fact.value)), &fact.note));
    }
    if !summary.positions.is_empty() {
        let place = |p: &[f64; 3]| p.map(|c| trimmed(&format!("{c:.2}").replace('-', "−"))).join(",\u{a0}");
        let places: Vec<_> =
            summary.positions.iter().map(|(name, p)| format!("{name}\u{a0}({})", place(p))).collect();
        facts.push(card("Monitors (x, y, z in m)", places.join("; "), ""));
    }
    if !summary.pairs.is_empty() {
        let place = |p: &[f64; 3]| p.map(|c| trimmed(&format!("{c:.2}").replace('-', "−"))).join(",\u{a0}");
        let pairs = summary.pairs.iter();
        let places = pairs.map(|(name, p)| {
            format!("{name} on {}\u{a0}({}), m\u{a0}({})", p.interface, place(&p.at), place(&p.normal))
        });
        let places: Vec<_> = places.collect();
        let note =
            "at the pair nearest to what was asked for; m points out of the first side into the second";
        facts.push(card("Monitors on interfaces (x, y, z in m)", places.join("; "), note));
    }
    facts
}

fn capital(name: &str) -> String {
    let mut letters = name.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

/// How the run was made.
pub fn run(summary: &Summary) -> Vec<Fact> {
    let run = &summary.run;
    let mut facts = Vec::new();
    for (label, value) in [
        ("Program", &run.program),
        ("Command", &run.command),
        ("Started", &run.started),
        ("Instructions", &run.instruction_set),
    ] {
        if !value.is_empty() {
            facts.push(card(label, value.clone(), ""));
        }
    }
    if run.threads > 0 {
        facts.push(card("Threads", run.threads.to_string(), ""));
    }
    if summary.wall_seconds.is_finite() && summary.wall_seconds > 0.0 {
        facts.push(card("Wall-clock time", span(summary.wall_seconds), ""));
    }
    let rate = summary.element_updates_per_second;
    if rate.is_finite() && rate > 0.0 {
        facts.push(card("Element updates", format!("{}\u{a0}million a second", figures(rate / 1e6, 3)), ""));
    }
    if run.resumed > 0 {
        let times = if run.resumed == 1 { "once".into() } else { format!("{} times", run.resumed) };
        facts.push(card("Resumed from a checkpoint", times, ""));
    }
    facts
}

fn card(label: &str, value: String, note: &str) -> Fact {
    Fact { label: label.into(), value, note: note.into() }
}
