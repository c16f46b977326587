//! The verdict: whether the lining stands, in five lines at most, from what the summary found.

pub mod short_names;
mod strength;
pub mod surroundings;
mod widest;

use serde::Serialize;
use tremolite_results::{Cracks, Finding, GroupDamage, Severity, Status, Summary};

use crate::language::{Language, say};
use crate::quantities::scale::{figures, moment};
use crate::quantities::units::Kind;
use crate::source::Source;
use crate::source::monitor_pairs::held;
use crate::verdict::short_names::{CHECK, NAME, percent, short};
use crate::verdict::surroundings::{around, of_rock, yielded};
use crate::verdict::widest::widest;

/// Lines that the verdict may have.
const LINES: usize = 5;
/// Linings that have a line each; further ones share the last.
const ALONE: usize = 2;
/// Checks that warn and are named.
const WARNINGS: usize = 3;
/// Parts of a lining, crown and walls, of which each is told.
const PARTS: usize = 3;

/// What `share_cracked` of a finding counts: the column of the law.
const CRACKED: &str = "d_tension";

/// What stands at the top of the page.
#[derive(Serialize)]
pub struct Verdict {
    pub question: String,
    pub answer: String,
    /// `good`, `warn`, `bad`, or `plain` where no earthquake has asked: the colour of the answer.
    pub class: &'static str,
    pub lines: Vec<VerdictLine>,
}

/// A fact of the verdict with its colour.
#[derive(Serialize)]
pub struct VerdictLine {
    pub class: &'static str,
    pub text: String,
}

/// The verdict of a run.
pub fn verdict(source: &Source) -> Verdict {
    let facts = source.facts();
    let language = source.language;
    let mut lines = vec![run(source, &facts)];
    let linings = linings(&facts);
    lines.extend(linings.iter().take(ALONE).map(|finding| in_full(source, &facts, finding)));
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
    let (class, answer) = answer(source, &linings, yielding(source, &facts));
    let crushed = linings.iter().filter_map(|finding| finding.numbers.get("share_crushed_or_sheared"));
    let crushed = crushed.copied().fold(0.0, f64::max);
    let answer = match crushed > 0.0 && source.summary.is_ok() {
        true => say!(
            language,
            "{answer} Concrete is crushed or sheared in up to {share} of a lining's volume.",
            answer = answer,
            share = percent(crushed)
        ),
        false => answer,
    };
    let question = match source.still() {
        Some(_) => say!(language, "Is the lining whole when the stages are done?"),
        None => say!(language, "Does the lining withstand the earthquake?"),
    };
    Verdict { question, answer, class, lines }
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

/// Of the linings whose law cannot crack that which has yielded most: a lining is what section forces were taken of.
fn yielding<'a>(source: &Source, facts: &'a Summary) -> Option<&'a Finding> {
    let rows = source.sections.as_ref()?.as_ref().ok()?;
    let lining = |finding: &&Finding| rows.iter().any(|row| row.lining == finding.group);
    let share = |finding: &Finding| {
        let shares = finding.numbers.iter().filter(|(name, _)| name.starts_with("share_yielded"));
        shares.map(|(_, share)| *share).fold(0.0, f64::max)
    };
    let all = facts.conclusion.findings.iter().filter(|finding| of_rock(finding)).filter(lining);
    let all = all.map(|finding| (finding, share(finding))).filter(|(_, share)| *share > 0.0);
    all.max_by(|a, b| a.1.total_cmp(&b.1)).map(|(finding, _)| finding)
}

/// `yielding` is a lining that cannot crack but has yielded.
fn answer(source: &Source, linings: &[&Finding], yielding: Option<&Finding>) -> (&'static str, String) {
    let language = source.language;
    let Ok(summary) = &source.summary else {
        return ("warn", say!(language, "Cannot be said: there is no summary of the run."));
    };
    // Beside linings that can crack and have not, one that cannot may be asked for more than it bears.
    let first = linings.first().map(|finding| finding.severity);
    if let (Status::Done, Some(Severity::Undamaged), Some(answer)) =
        (summary.conclusion.status, first, strength::answer(source, summary))
        && answer.0 == "bad"
    {
        return answer;
    }
    let yielded = yielding.map(|finding| yielded(language, summary, finding));
    match (summary.conclusion.status, linings.first().map(|finding| finding.severity), yielded) {
        (Status::Failed, ..) => ("bad", say!(language, "Cannot be said: the run failed.")),
        (Status::Stopped, Some(Severity::Through), _) => {
            ("bad", say!(language, "The run has not ended, and cracks already run through its thickness."))
        }
        (Status::Stopped, ..) => ("warn", say!(language, "Cannot be said yet: the run has not ended.")),
        (Status::Done, None, Some(yielded)) => {
            ("warn", say!(language, "Not judged by cracks. {yielded}", yielded = yielded))
        }
        (Status::Done, None, None) => match strength::answer(source, summary) {
            Some(answer) => answer,
            None => ("warn", say!(language, "Not judged: no structure of this run can crack.")),
        },
        (Status::Done, Some(Severity::Through), _) if linings.iter().any(|lining| is_loose(lining)) => (
            "bad",
            say!(
                language,
                "It is damaged: cracks run through its thickness, and pieces have come loose. This model cannot say whether they fall."
            ),
        ),
        (Status::Done, Some(Severity::Through), _) => {
            ("bad", say!(language, "It is damaged: cracks run through its thickness."))
        }
        (Status::Done, Some(Severity::Damaged), _) => {
            ("warn", say!(language, "It is cracked, but no crack runs through its thickness."))
        }
        (Status::Done, Some(Severity::Undamaged), Some(yielded)) => {
            ("warn", say!(language, "It has not cracked, but it has yielded. {yielded}", yielded = yielded))
        }
        (Status::Done, Some(Severity::Undamaged), _) if summary.warnings() > 0 || summary.judged() == 0 => {
            ("warn", say!(language, "The computation shows no damage, but some checks warn."))
        }
        (Status::Done, Some(Severity::Undamaged), _) if source.still().is_some() => {
            ("plain", say!(language, "It is undamaged; no earthquake has come."))
        }
        (Status::Done, Some(Severity::Undamaged), _) => ("good", say!(language, "It is undamaged.")),
    }
}

/// How the run went, and whether it can be trusted.
fn run(source: &Source, facts: &Summary) -> VerdictLine {
    let language = source.language;
    if source.summary.is_err() {
        return VerdictLine {
            class: "warn",
            text: say!(language, "The run left no summary, so nothing is checked."),
        };
    }
    let (judged, warnings) = (facts.judged(), facts.warnings());
    let passed = judged - warnings.min(judged);
    let (class, text) = match facts.conclusion.status {
        Status::Failed => ("bad", say!(language, "The run failed: what follows is not to be trusted.")),
        Status::Stopped => ("warn", say!(language, "The run was stopped before its end.")),
        Status::Done if judged == 0 => ("warn", say!(language, "The run is done, but nothing was checked.")),
        Status::Done if warnings == 0 => (
            "good",
            say!(
                language,
                "{passed} of {judged} checks of the run pass: none warns.",
                passed = passed,
                judged = judged
            ),
        ),
        Status::Done => ("warn", warned(source, facts, passed, judged)),
    };
    VerdictLine { class, text }
}

/// That checks warn, and which.
fn warned(source: &Source, facts: &Summary, passed: usize, judged: usize) -> String {
    let language = source.language;
    let warn = facts.soundness.trust.iter().filter(|line| !line.pass && !line.not_applicable);
    let names: Vec<String> =
        warn.map(|line| short(&language.tell_or(&line.name_said, &line.name), CHECK)).collect();
    let told = names[..names.len().min(WARNINGS)].join(&say!(language, "; "));
    match names.len() {
        0 | 1 => say!(
            language,
            "The run is done; {passed} of {judged} checks pass. Read the one that warns first: {check}.",
            passed = passed,
            judged = judged,
            check = told
        ),
        all if all <= WARNINGS => say!(
            language,
            "The run is done; {passed} of {judged} checks pass. Read those that warn first: {checks}.",
            passed = passed,
            judged = judged,
            checks = told
        ),
        all => say!(
            language,
            "The run is done; {passed} of {judged} checks pass. Read those that warn first: {checks}, and {more} more.",
            passed = passed,
            judged = judged,
            checks = told,
            more = all - WARNINGS
        ),
    }
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
        (Severity::Undamaged, _) => say!(language, "{group}: undamaged.", group = group),
        (_, None) => {
            let headline = language.tell_or(&finding.headline_said, &finding.headline);
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

/// Whether a lining's cracks opened so far that pieces have come loose.
fn is_loose(lining: &Finding) -> bool {
    lining.numbers.get("crack_opening").is_some_and(|opening| *opening > Cracks::LOOSE)
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
