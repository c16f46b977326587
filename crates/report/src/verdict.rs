//! The verdict: state and reliance in a line each, and five lines at most of what the summary found.

pub mod short_names;
mod strength;
pub mod surroundings;
mod widest;

use serde::Serialize;
use tremolite_results::assessment::Class;
use tremolite_results::{
    Assessment, Finding, GroupDamage, Reliance, Said, Severity, State, Summary, assess, said,
};

use crate::language::{Language, say};
use crate::quantities::scale::{figures, moment};
use crate::quantities::units::Kind;
use crate::source::Source;
use crate::source::monitor_pairs::held;
use crate::verdict::short_names::{NAME, percent, short};
use crate::verdict::surroundings::{around, of_rock};
use crate::verdict::widest::widest;

/// Lines that the verdict may have below its two classes.
const LINES: usize = 5;
/// Linings that have a line each; further ones share the last.
const ALONE: usize = 2;
/// Parts of a lining, crown and walls, of which each is told.
const PARTS: usize = 3;

/// What `share_cracked` of a finding counts: the column of the law.
const CRACKED: &str = "d_tension";

/// What stands at the top of the page.
#[derive(Serialize)]
pub struct Verdict {
    pub question: String,
    /// `good`, `warn` or `bad`: the worse colour of both classes.
    pub class: &'static str,
    pub state: VerdictClass,
    pub reliance: VerdictClass,
    pub lines: Vec<VerdictLine>,
}

/// A class of the verdict with its colour and its reasons.
#[derive(Serialize)]
pub struct VerdictClass {
    pub class: &'static str,
    /// Which of the two it is, up to the word.
    pub label: String,
    pub word: String,
    /// The reasons, after the word.
    pub text: String,
}

impl VerdictClass {
    /// As the end of a run says it.
    pub fn line(&self) -> String {
        format!("{}{}{}", self.label, self.word, self.text).trim_end().to_owned()
    }
}

/// A fact of the verdict with its colour.
#[derive(Serialize)]
pub struct VerdictLine {
    pub class: &'static str,
    pub text: String,
}

/// State and reliance of a run, by its result files.
pub fn assessment(source: &Source) -> Assessment {
    match &source.summary {
        Ok(summary) => assess(summary, source.monitors.as_ref().ok()),
        Err(_) => Assessment::default(),
    }
}

/// The verdict of a run.
pub fn verdict(source: &Source) -> Verdict {
    let facts = source.facts();
    let language = source.language;
    let linings = linings(&facts);
    let alone = linings.iter().take(ALONE);
    let mut lines: Vec<VerdictLine> = alone.map(|finding| in_full(source, &facts, finding)).collect();
    if let [next, ..] = linings.get(ALONE..).unwrap_or_default() {
        let count = linings.len() - ALONE;
        let next = lining(source, &facts, next);
        let text = say!(
            language,
            "{count} more structures, none worse; of these {worst}",
            count = count,
            worst = next.text
        );
        lines.push(VerdictLine { text, ..next });
    }
    lines.extend(strength::lines(source, &facts));
    let room = LINES.saturating_sub(lines.len());
    lines.extend(within(room, around(language, &facts), language));
    lines.extend(relative(source, &facts));
    lines.truncate(LINES);
    let question = match source.still() {
        Some(_) => say!(language, "Is the lining whole when the stages are done?"),
        None => say!(language, "Does the lining withstand the earthquake?"),
    };
    let found = assessment(source);
    let [state, reliance] = classes(source, &facts, &found);
    let worse = |a: &'static str, b: &'static str| if rank(b) > rank(a) { b } else { a };
    Verdict { question, class: worse(state.class, reliance.class), state, reliance, lines }
}

/// Colours, the worst last.
fn rank(class: &str) -> usize {
    ["good", "warn", "bad"].iter().position(|known| *known == class).unwrap_or(0)
}

/// Both classes with their reasons, in the page's language.
fn classes(source: &Source, facts: &Summary, found: &Assessment) -> [VerdictClass; 2] {
    let language = source.language;
    let text = |reasons: Vec<Said>| {
        let texts: Vec<String> =
            reasons.iter().map(|said| language.tell_or(said, &said.to_string())).collect();
        say!(language, ". ") + &language.joined(&texts)
    };
    let none = || vec![said!("There is no summary of the run.")];
    let known = source.summary.is_ok();
    let state = VerdictClass {
        class: match found.state.class {
            State::Withstands => "good",
            State::NotJudged | State::Damaged => "warn",
            State::Fails => "bad",
        },
        label: say!(language, "State: "),
        word: word(language, found.state.class),
        text: text(if known { found.why_state(facts) } else { none() }),
    };
    let reliance = VerdictClass {
        class: reliance_class(found),
        label: say!(language, "Reliance: "),
        word: word(language, found.reliance.class),
        text: text(if known { found.why_reliance(facts) } else { none() }),
    };
    [state, reliance]
}

/// The colour of the reliance.
pub fn reliance_class(found: &Assessment) -> &'static str {
    match found.reliance.class {
        Reliance::Sound => "good",
        Reliance::WithReservations => "warn",
        Reliance::NotToBeUsed => "bad",
    }
}

/// A class in words.
pub fn word<C: Class>(language: Language, class: C) -> String {
    let words = class.words();
    language.tell_or(&words, &words.to_string())
}

fn class(severity: Severity) -> &'static str {
    match severity {
        Severity::Undamaged => "good",
        Severity::Damaged => "warn",
        Severity::Through => "bad",
    }
}

/// Findings of what can crack, the worst first; of equal ones that which is cracked most.
fn linings(facts: &Summary) -> Vec<&Finding> {
    let cracks = |finding: &&Finding| finding.id.starts_with("damage_") && !of_rock(finding);
    // An undamaged group has no numbers: whether it can crack is known from what its damage is measured by.
    let concrete = |finding: &&Finding| {
        let group = facts.parts.damage.get(&finding.group);
        group.is_none_or(|group| group.measures.keys().any(|name| !name.starts_with("plastic_")))
    };
    let mut all: Vec<&Finding> = facts.conclusion.findings.iter().filter(cracks).filter(concrete).collect();
    let share = |finding: &Finding| finding.numbers.get("share_cracked").copied().unwrap_or(0.0);
    all.sort_by(|a, b| (b.severity as u8).cmp(&(a.severity as u8)).then(share(b).total_cmp(&share(a))));
    all
}

/// The lines in the room there is for them: those that have none of their own share the last.
fn within(room: usize, mut lines: Vec<(Severity, String)>, language: Language) -> Vec<VerdictLine> {
    while lines.len() > room.max(1) {
        let Some((severity, text)) = lines.pop() else { break };
        if let Some(last) = lines.last_mut() {
            let worse = if severity as u8 > last.0 as u8 { severity } else { last.0 };
            *last = (worse, say!(language, "{first} {second}", first = last.1, second = text));
        }
    }
    lines.into_iter().map(|(severity, text)| VerdictLine { class: class(severity), text }).collect()
}

/// A lining's cracks, those of its parts, and what of them was there before the earthquake.
fn in_full(source: &Source, facts: &Summary, finding: &Finding) -> VerdictLine {
    let language = source.language;
    let mut line = lining(source, facts, finding);
    let cracked = |group: &GroupDamage| Some(group.measures.get(CRACKED)?.beyond.get("0.5")? / group.volume);
    let of_whole = facts.parts.damage.get(&finding.group).and_then(cracked);
    let inside = format!("{}.", finding.group);
    let mut parts: Vec<(&str, f64)> = facts
        .parts
        .damage
        .iter()
        .filter_map(|(name, group)| Some((name.strip_prefix(&inside)?, cracked(group)?)))
        .filter(|(_, share)| share.is_finite())
        .collect();
    if of_whole.is_some_and(|share| share > 0.0) && (2..=PARTS).contains(&parts.len()) {
        parts.sort_by(|a, b| b.1.total_cmp(&a.1));
        let called = |name: &str| match name {
            "crown" => say!(language, "crown"),
            "walls" => say!(language, "walls"),
            "floor" => say!(language, "floor"),
            other => other.to_owned(),
        };
        let told: Vec<String> =
            parts.into_iter().map(|(name, x)| format!("{} {}", called(name), percent(x))).collect();
        line.text = say!(
            language,
            "{first} By parts: {parts}.",
            first = line.text,
            parts = told.join(&say!(language, ", "))
        );
    }
    if let Some(share) = before(source, &finding.group).filter(|share| *share > 0.0) {
        line.text = say!(
            language,
            "{first} Before the earthquake: {share}.",
            first = line.text,
            share = percent(share)
        );
    }
    line
}

/// The share of a lining that was cracked when the shaking began.
fn before(source: &Source, group: &str) -> Option<f64> {
    let table = source.damage.as_ref()?.as_ref().ok().filter(|_| source.shakes())?;
    table.column(&format!("{group}.{CRACKED}"))?.first().copied().filter(|share| share.is_finite())
}

/// A lining's cracks.
fn lining(source: &Source, facts: &Summary, finding: &Finding) -> VerdictLine {
    let language = source.language;
    let number = |name: &str| finding.numbers.get(name).copied().filter(|x| x.is_finite());
    let group = &short(&finding.group, NAME);
    let text = match (finding.severity, number("share_cracked")) {
        (Severity::Undamaged, _) => say!(language, "{group}: no damage computed.", group = group),
        (_, None) => {
            let headline = language.tell_or(&finding.headline_message, &finding.headline);
            say!(language, "{group}: {headline}", group = group, headline = headline)
        }
        (_, Some(cracked)) => {
            let cracked = percent(cracked);
            let widest = widest(source, facts, finding);
            match (number("through").filter(|n| *n > 0.0), number("places"), widest) {
                (Some(through), Some(places), Some(widest)) => say!(
                    language,
                    "{group}: cracked in {cracked} of its volume, through the thickness at {through} of {places} places; {widest}.",
                    group = group,
                    cracked = cracked,
                    through = through,
                    places = places,
                    widest = widest
                ),
                (_, _, Some(widest)) => say!(
                    language,
                    "{group}: cracked in {cracked} of its volume, nowhere through the thickness; {widest}.",
                    group = group,
                    cracked = cracked,
                    widest = widest
                ),
                _ => say!(
                    language,
                    "{group}: cracked in {cracked} of its volume.",
                    group = group,
                    cracked = cracked
                ),
            }
        }
    };
    let text = match number("share_crushed_or_sheared").filter(|share| *share > 0.0) {
        Some(crushed) => say!(
            language,
            "{first} Crushed or sheared in {share} of its volume.",
            first = text,
            share = percent(crushed)
        ),
        None => text,
    };
    VerdictLine { class: class(finding.severity), text }
}

/// The pair of monitors that moved apart most, of those that did not come loose.
fn relative(source: &Source, facts: &Summary) -> Option<VerdictLine> {
    let (held, loose) = held(source, facts);
    let lengths = held.into_iter().filter_map(|(pair, of)| Some((pair, of.get("u")?)));
    let (pair, most) =
        lengths.filter(|(_, p)| p.max.is_finite()).max_by(|a, b| a.1.max.total_cmp(&b.1.max))?;
    let share = |x: f64| source.quantity(Kind::Displacement, x);
    let mut text = say!(
        source.language,
        "Monitors {pair} moved by up to {most} against each other, at {time}\u{a0}s; {left} at the end.",
        pair = pair,
        most = share(most.max),
        time = moment(most.t_max, facts.computed.model.duration),
        // Below a thousandth it is what still swings.
        left = match most.residual {
            r if r.abs() < 1e-3 * most.max => share(0.0),
            r if r.is_finite() => share(r),
            r => figures(r, 3),
        }
    );
    if !loose.is_empty() {
        text = say!(
            source.language,
            "{first} Not counted: {pairs}, of which a monitor is on a broken element.",
            first = text,
            pairs = loose.join(", ")
        );
    }
    Some(VerdictLine { class: "plain", text })
}
