//! What the page says in words and numbers: outcome, trust, the model, the run.

pub mod key_results;
pub mod materials;
pub mod peaks;

use indexmap::IndexMap;
use minijinja::Value;
use serde::Serialize;
use tremolite_results::{Bound, Finding, PairPlace, Peaks, Said, Severity, Status, Summary, TrustLine, said};

use crate::chapter::results_text::{in_english, kind_of_motion, told};
use crate::input::{deconvolved, waves};
use crate::language::{Language, say};
use crate::quantities::scale::{count, figures, quantity, span, trimmed};
use crate::quantities::units::Kind;
use crate::source::Source;
use crate::verdict::{assessment, reliance_class};

/// An outcome at the top of the page.
#[derive(Serialize)]
pub struct Outcome {
    /// `good`, `warn` or `bad`: the colour.
    pub class: &'static str,
    pub headline: Value,
    pub text: Value,
}

/// A label with a value, and where or what in small print.
#[derive(Serialize)]
pub struct Fact {
    pub label: Value,
    pub value: String,
    pub note: Value,
    /// `fail` where it is to be seen before one signs; else empty.
    pub class: &'static str,
}

impl Fact {
    /// The same, to be seen before one signs.
    pub fn warning(self) -> Fact {
        Fact { class: "fail", ..self }
    }
}

/// A line of the trust table.
#[derive(Serialize)]
pub struct Check {
    pub name: Value,
    pub value: String,
    pub limit: String,
    /// `pass`, `fail` or `none`: the colour.
    pub class: &'static str,
    /// Pass, warn, or a dash for a line that cannot be judged.
    pub mark: String,
    pub note: Value,
}

/// By name of a monitor or pair, then of a quantity.
pub(crate) type ByName = IndexMap<String, IndexMap<String, Peaks>>;

/// Outcome of the run and colour of its banner.
pub fn outcome(source: &Source) -> Outcome {
    let language = source.language;
    let Ok(summary) = &source.summary else {
        let why = source.summary.as_ref().err().cloned().unwrap_or_default();
        let headline = say!(language, "No summary of the run").into();
        return Outcome { class: "warn", headline, text: told(language, &Said::default(), &why) };
    };
    let (judged, warnings) = (summary.judged(), summary.warnings());
    let headline = match summary.conclusion.status {
        Status::Failed => say!(language, "Run: failed"),
        Status::Stopped => say!(language, "Run: stopped before its end"),
        Status::Done if judged == 0 => say!(language, "Run: done, but nothing was checked"),
        Status::Done if warnings == 0 => {
            say!(language, "Run: all {judged} checks pass", judged = judged)
        }
        Status::Done if warnings == 1 => {
            say!(language, "Run: done, 1 of {judged} checks warns", judged = judged)
        }
        Status::Done => say!(
            language,
            "Run: done, {warnings} of {judged} checks warn",
            warnings = warnings,
            judged = judged
        ),
    };
    let class = reliance_class(&assessment(source));
    let text = if summary.conclusion.outcome.is_empty() {
        &summary.conclusion.verdict
    } else {
        &summary.conclusion.outcome
    };
    Outcome {
        class,
        headline: headline.into(),
        text: told(language, &summary.conclusion.outcome_message, text),
    }
}

/// What became of each structure, each a banner of its own: a sound run may show a lining that fails.
pub fn findings(language: Language, summary: &Summary) -> Vec<Outcome> {
    let banner = |finding: &Finding| Outcome {
        class: match finding.severity {
            Severity::Undamaged => "good",
            Severity::Damaged => "warn",
            Severity::Through => "bad",
        },
        headline: headline(language, finding),
        text: told(language, &finding.text_message, &finding.text),
    };
    summary.conclusion.findings.iter().map(banner).collect()
}

fn headline(language: Language, finding: &Finding) -> Value {
    let Finding { group, headline, headline_message, .. } = finding;
    let whole = match headline_message.is_empty() {
        true => Said::default(),
        false => said!("{group}: {headline}", group = group, headline = headline_message.clone()),
    };
    told(language, &whole, &format!("{group}: {headline}"))
}

/// The trust table.
pub fn checks(language: Language, summary: &Summary) -> Vec<Check> {
    summary.soundness.checks.iter().map(|line| check(language, line)).collect()
}

fn check(language: Language, line: &TrustLine) -> Check {
    let name = told(language, &line.name_message, &line.name);
    let note = told(language, &line.note_message, &line.note);
    if line.not_applicable {
        let value = say!(language, "not applicable");
        return Check { name, value, limit: String::new(), class: "none", mark: "–".into(), note };
    }
    // What must be none at all is counted.
    let counted = line.unit.is_empty() && line.limit == 0.0 && line.value.fract() == 0.0 && line.value < 1e6;
    let number = |x: f64| if counted { format!("{x:.0}") } else { quantity(&line.unit, x) };
    let relation = if line.bound == Bound::AtMost { "≤" } else { "≥" };
    Check {
        name,
        value: number(line.value),
        limit: format!("{relation}\u{a0}{}", trimmed(&quantity(&line.unit, line.limit))),
        class: if line.pass { "pass" } else { "fail" },
        mark: if line.pass { say!(language, "pass") } else { say!(language, "warn") },
        note,
    }
}

/// What was said before the run. Every key and every law has its own; they stand as the run wrote them.
pub fn warnings(language: Language, summary: &Summary) -> Vec<Value> {
    let set = |text: &String| match language {
        Language::English => Value::from(text.as_str()),
        Language::Chinese => in_english(text),
    };
    summary.case.warnings.iter().map(set).collect()
}

/// Size, time step and motion.
pub fn model(source: &Source, summary: &Summary) -> Vec<Fact> {
    let language = source.language;
    let model = &summary.computed.model;
    let mut facts = Vec::new();
    if model.elements > 0 {
        let groups: Vec<_> = model.groups.iter().map(|(name, n)| format!("{name} {}", count(*n))).collect();
        facts.push(card(say!(language, "Elements"), count(model.elements), groups.join(", ")));
        facts.push(card(say!(language, "Nodes"), count(model.nodes), ""));
    }
    if model.steps > 0 {
        let set_by = told(language, &model.step_set_by_message, &model.step_set_by);
        facts.push(card(say!(language, "Time step"), quantity("s", model.time_step), set_by));
        let shaking = say!(language, "{time} of shaking", time = span(model.duration));
        let levels = match (&model.elements_of_level[..], model.elements) {
            ([finest, .., _], all @ 1..) => say!(
                language,
                "{time} of shaking; {share} % of the elements make each step, others steps of up to {most} times as long",
                time = span(model.duration),
                share = format!("{:.0}", 100.0 * *finest as f64 / all as f64),
                most = (1u64 << (model.elements_of_level.len() - 1)).to_string(),
            ),
            _ => shaking,
        };
        facts.push(card(say!(language, "Steps"), count(model.steps), levels));
    }
    facts.extend(motion(source, summary));
    for fact in &summary.case.facts {
        facts.push(Fact {
            label: told(language, &fact.name_message, &capital(&fact.name)),
            value: trimmed(&quantity(&fact.unit, fact.value)),
            note: told(language, &fact.note_message, &fact.note),
            class: "",
        });
    }
    facts.extend(monitors(language, summary));
    facts
}

/// The motion that went in.
fn motion(source: &Source, summary: &Summary) -> Vec<Fact> {
    let language = source.language;
    let motion = &summary.computed.motion;
    let mut facts = Vec::new();
    if !motion.kind.is_empty() {
        // A motion of layered ground has no factor; older versions did not say what was done.
        let note = match &motion.deconvolved {
            Some(site) => deconvolved::words(language, site),
            None if !motion.waves.is_empty() => String::new(),
            None if motion.factor.is_finite() => say!(
                language,
                "incident motion = {factor} × the motion given",
                factor = trimmed(&figures(motion.factor, 3))
            ),
            None => String::new(),
        };
        facts.push(card(
            say!(language, "Kind of motion given"),
            kind_of_motion(language, &motion.kind),
            note,
        ));
    }
    let waves = waves::lines(language, motion).into_iter();
    facts.extend(waves.map(|[label, value, note]| card(label, value, note)));
    let sources: Vec<&String> = motion.source.values().collect();
    let shared = sources.windows(2).all(|pair| pair[0] == pair[1]);
    if let Some(record) = sources.first().filter(|_| shared) {
        facts.push(card(say!(language, "Record"), (*record).clone(), ""));
    }
    // Round-off of a component that the record does not have is no motion.
    let largest = motion.peak_acceleration.values().fold(0.0_f64, |most, x| most.max(x.abs()));
    for (axis, &peak) in &motion.peak_acceleration {
        let peak = if peak.abs() < 1e-9 * largest { 0.0 } else { peak };
        let record = motion.source.get(axis).filter(|_| !shared).map_or("", String::as_str);
        let value =
            format!("{} ({}\u{a0}g)", source.quantity(Kind::Acceleration, peak), figures(peak / 9.806_65, 2));
        facts.push(card(say!(language, "Peak incident acceleration, {axis}", axis = axis), value, record));
    }
    facts
}

/// Where the monitors are.
fn monitors(language: Language, summary: &Summary) -> Vec<Fact> {
    let place = |p: &[f64; 3]| p.map(|c| trimmed(&format!("{c:.2}").replace('-', "−"))).join(",\u{a0}");
    let mut facts = Vec::new();
    if !summary.monitors.monitor_positions.is_empty() {
        let places: Vec<_> = summary
            .monitors
            .monitor_positions
            .iter()
            .map(|(name, p)| format!("{name}\u{a0}({})", place(p)))
            .collect();
        facts.push(card(say!(language, "Monitors (x, y, z in m)"), places.join("; "), ""));
    }
    if !summary.parts.pairs.is_empty() {
        let of = |(name, pair): (&String, &PairPlace)| {
            say!(
                language,
                "{monitor} on {interface}\u{a0}({place}), m\u{a0}({normal})",
                monitor = name,
                interface = pair.interface,
                place = place(&pair.at),
                normal = place(&pair.normal)
            )
        };
        let places: Vec<_> = summary.parts.pairs.iter().map(of).collect();
        let note = say!(
            language,
            "at the pair nearest to what was asked for; m points out of the first side into the second"
        );
        facts.push(card(say!(language, "Monitors on interfaces (x, y, z in m)"), places.join("; "), note));
    }
    facts
}

fn capital(name: &str) -> String {
    let mut letters = name.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

/// How the run was made.
pub fn run(language: Language, summary: &Summary) -> Vec<Fact> {
    let run = &summary.computed.run;
    let mut facts = Vec::new();
    for (label, value) in [
        (say!(language, "Program"), &run.program),
        (say!(language, "Command"), &run.command),
        (say!(language, "Started"), &run.started),
        (say!(language, "Instructions"), &run.instruction_set),
    ] {
        if !value.is_empty() {
            facts.push(card(label, value.clone(), ""));
        }
    }
    if run.threads > 0 {
        facts.push(card(say!(language, "Threads"), run.threads.to_string(), ""));
    }
    if summary.computed.wall_seconds.is_finite() && summary.computed.wall_seconds > 0.0 {
        facts.push(card(say!(language, "Wall-clock time"), span(summary.computed.wall_seconds), ""));
    }
    let rate = summary.computed.element_updates_per_second;
    if rate.is_finite() && rate > 0.0 {
        let value = say!(language, "{rate}\u{a0}million a second", rate = figures(rate / 1e6, 3));
        facts.push(card(say!(language, "Element updates"), value, ""));
    }
    if run.resumed > 0 {
        let times = match run.resumed {
            1 => say!(language, "once"),
            more => say!(language, "{count} times", count = more),
        };
        facts.push(card(say!(language, "Resumed from a checkpoint"), times, ""));
    }
    facts
}

/// A label with a value and small print, all in the page's language.
pub(crate) fn card(label: String, value: String, note: impl Into<Value>) -> Fact {
    Fact { label: label.into(), value, note: note.into(), class: "" }
}
