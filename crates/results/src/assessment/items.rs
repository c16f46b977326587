//! The table of what sets which class of state and of reliance.
//!
//! docs/report.md prints [`table`]. Slip of interfaces and bolts and yielding of rock set no class.

use super::{Class, Reliance, State};
use crate::limits::{HeldLimit, LimitOutcome, limits, size};
use crate::{
    Bound, Cracks, FailureModes, Finding, JudgedBy, SectionStrength, Severity, Status, Summary, Table,
    TrustLine, Used, said,
};
use crate::{Said, Slot};
use std::collections::BTreeSet;

/// What sets a class.
pub struct Item<C> {
    /// By which scripts know it.
    pub id: &'static str,
    /// When it does, in words.
    pub condition: &'static str,
    pub class: C,
    /// A sentence for each place where the condition holds.
    pub reasons: fn(&Run) -> Vec<Said>,
}

/// Share of the shaking's ∫a² dt left out beyond which results are not to be used: assumption.
const NOT_RUN: f64 = 0.05;
/// Share of the largest energy held that may be missing from the balance: assumption, a hundred times the limit of the check.
const ENERGY: f64 = 0.05;
/// Stress change at a boundary over the initial stress, at which the hoop stress of an opening is wrong by a quarter.
const BOUNDARY: f64 = 0.4;
/// Share of itself by which the initial stress changes on the way to equilibrium: assumption.
const INITIAL: f64 = 0.5;
/// Displacement of the initial equilibrium over that of the stages: assumption.
const MOTION: f64 = 1.0;
/// Elements a shortest wavelength, fewer than which do not carry it: half the limit of the check.
const WAVELENGTH: f64 = 4.0;

/// Checks, each with the value beyond which results are not to be used. Beyond their limit alone all set reservations.
pub const FAR: [(&str, f64); 6] = [
    ("truncated_motion", NOT_RUN),
    ("energy_error", ENERGY),
    ("boundary_stress_change", BOUNDARY),
    ("initial_stress_change", INITIAL),
    ("initial_motion", MOTION),
    ("elements_per_wavelength", WAVELENGTH),
];

/// Items of the state, by classes, the worst first.
pub const STATE: [Item<State>; 14] = [
    Item {
        id: "section_beyond_strength",
        condition: "the utilisation of a section by `[[section]]` is above 1",
        class: State::Fails,
        reasons: sections_beyond,
    },
    Item {
        id: "limit_not_met",
        condition: "a limit of `[report.limits]` is not met",
        class: State::Fails,
        reasons: |run| run.of_limits(&[LimitOutcome::NotMet], limit_not_met),
    },
    Item {
        id: "loose_pieces",
        condition: "cracks of a lining open beyond 20 mm: pieces come loose",
        class: State::Fails,
        reasons: |run| {
            run.of_linings(
                |finding| number(finding, "crack_opening") > Cracks::LOOSE,
                |finding| {
                    said!(
                        "Pieces of {lining} have come loose; this model does not follow them.",
                        lining = &finding.group
                    )
                },
            )
        },
    },
    Item {
        id: "steel_broken",
        condition: "bolts or bars break",
        class: State::Fails,
        reasons: |run| {
            run.of_steel(
                |finding| number(finding, "broken") > 0.0,
                |finding| said!("Bolts or bars of {group} broke.", group = &finding.group),
            )
        },
    },
    Item {
        id: "cracked_through",
        condition: "cracks run through the thickness of a lining",
        class: State::Damaged,
        reasons: |run| {
            run.of_linings(
                |finding| finding.severity == Severity::Through,
                |finding| said!("{lining}: cracks run through its thickness.", lining = &finding.group),
            )
        },
    },
    Item {
        id: "cracked",
        condition: "a lining cracks, is crushed or yields",
        class: State::Damaged,
        reasons: |run| run.of_linings(|finding| finding.severity == Severity::Damaged, damaged),
    },
    Item {
        id: "tension_beyond_strength",
        condition: "an elastic lining without bars has tension above the strength of its `[[section]]`",
        class: State::Damaged,
        reasons: |run| run.of_findings("tension_", headline),
    },
    Item {
        id: "steel_yielded",
        condition: "bolts or bars yield",
        class: State::Damaged,
        reasons: |run| {
            run.of_steel(
                |finding| number(finding, "yielded") > 0.0,
                |finding| said!("Bolts or bars of {group} yielded.", group = &finding.group),
            )
        },
    },
    Item {
        id: "run_failed",
        condition: "the run failed; no other item is then judged",
        class: State::NotJudged,
        reasons: |run| match run.summary.conclusion.status {
            Status::Failed => vec![said!("The run failed.")],
            _ => Vec::new(),
        },
    },
    Item {
        id: "not_complete",
        condition: "the run was stopped, or more than 1 % of the shaking was not run",
        class: State::NotJudged,
        reasons: not_complete,
    },
    Item {
        id: "mode_not_judged",
        condition: "neither the law nor a `[[section]]` judges thrust and moment, or shear, of a lining",
        class: State::NotJudged,
        reasons: modes_not_judged,
    },
    Item {
        id: "limit_not_known",
        condition: "the results do not hold the value of a limit of `[report.limits]`",
        class: State::NotJudged,
        reasons: |run| run.of_limits(&[LimitOutcome::Unknown], limit_not_known),
    },
    Item {
        id: "limit_does_not_apply",
        condition: "a limit is for cracks, and no material can crack",
        class: State::NotJudged,
        reasons: |run| run.of_limits(&[LimitOutcome::Inapplicable], limit_inapplicable),
    },
    Item {
        id: "no_lining",
        condition: "the run has no lining",
        class: State::NotJudged,
        reasons: |run| match run.failed() || !run.linings.is_empty() {
            true => Vec::new(),
            false => vec![said!("The run has no lining: no stage installs one, and no material cracks.")],
        },
    },
];

/// Items of the reliance, by classes, the worst first.
pub const RELIANCE: [Item<Reliance>; 6] = [
    Item {
        id: "run_failed",
        condition: "the run failed",
        class: Reliance::NotToBeUsed,
        reasons: |run| match run.summary.conclusion.status {
            Status::Failed => vec![said!("The run failed.")],
            _ => Vec::new(),
        },
    },
    Item {
        id: "run_stopped",
        condition: "the run was stopped before its end",
        class: Reliance::NotToBeUsed,
        reasons: |run| match run.summary.conclusion.status {
            Status::Stopped => vec![said!("The run was stopped before its end.")],
            _ => Vec::new(),
        },
    },
    Item {
        id: "check_far_beyond_limit",
        condition: "a check is far beyond its limit (the table of checks)",
        class: Reliance::NotToBeUsed,
        reasons: |run| run.of_checks(true),
    },
    Item {
        id: "check_beyond_limit",
        condition: "a check is beyond its limit",
        class: Reliance::WithReservations,
        reasons: |run| run.of_checks(false),
    },
    Item {
        id: "nothing_checked",
        condition: "no check applies",
        class: Reliance::WithReservations,
        reasons: |run| match run.summary.judged() {
            0 => vec![said!("No check applies.")],
            _ => Vec::new(),
        },
    },
    Item {
        id: "warned",
        condition: "`tremolite check` warns of the case",
        class: Reliance::WithReservations,
        reasons: |run| {
            let message = |warning: &String| warning.split("; ").next().unwrap_or_default().to_owned();
            let warnings = run.summary.case.warnings.iter();
            warnings
                .map(|warning| said!("Warning of the case: {message}.", message = message(warning)))
                .collect()
        },
    },
];

/// What items look at.
pub struct Run<'a> {
    summary: &'a Summary,
    limits: Vec<HeldLimit>,
    /// Groups that are linings.
    linings: BTreeSet<&'a str>,
}

impl<'a> Run<'a> {
    pub(super) fn new(summary: &'a Summary, monitors: Option<&Table>) -> Run<'a> {
        Run { summary, limits: limits(summary, monitors), linings: linings(summary) }
    }

    /// Of a run that failed nothing else is judged.
    fn failed(&self) -> bool {
        self.summary.conclusion.status == Status::Failed
    }

    /// A sentence for each limit of some outcomes.
    fn of_limits(&self, outcomes: &[LimitOutcome], told: fn(&HeldLimit) -> Said) -> Vec<Said> {
        let all = self.limits.iter().filter(|held| outcomes.contains(&held.outcome) && !self.failed());
        all.map(told).collect()
    }

    /// A sentence for each finding of a lining that is damaged so.
    fn of_linings(&self, damaged: fn(&Finding) -> bool, told: fn(&Finding) -> Said) -> Vec<Said> {
        let own = |finding: &&Finding| {
            finding.id.starts_with("damage_") && self.linings.contains(finding.group.as_str())
        };
        let all = self.summary.conclusion.findings.iter().filter(own).filter(|finding| damaged(finding));
        all.filter(|_| !self.failed()).map(told).collect()
    }

    /// A sentence for each finding with a kind of id.
    fn of_findings(&self, prefix: &str, told: fn(&Finding) -> Said) -> Vec<Said> {
        let all = self.summary.conclusion.findings.iter();
        all.filter(|finding| finding.id.starts_with(prefix) && !self.failed()).map(told).collect()
    }

    /// A sentence for each group of bolts or bars that is damaged so.
    fn of_steel(&self, damaged: fn(&Finding) -> bool, told: fn(&Finding) -> Said) -> Vec<Said> {
        let all = self.summary.conclusion.findings.iter().filter(|finding| finding.id.starts_with("bolts_"));
        all.filter(|finding| damaged(finding) && !self.failed()).map(told).collect()
    }

    /// A sentence for each check beyond its limit, of those that are far beyond or of the others.
    fn of_checks(&self, far: bool) -> Vec<Said> {
        let beyond = self.summary.soundness.checks.iter().filter(|line| !line.pass && !line.not_applicable);
        beyond.filter(|line| is_far(line) == far).map(check).collect()
    }
}

/// Groups of which the results say that they are linings: section forces were taken of them, or their law cracks.
fn linings(summary: &Summary) -> BTreeSet<&str> {
    let parts = &summary.parts;
    // An undamaged group has no numbers: its measures tell whether it can crack.
    let cracks = |finding: &&Finding| {
        let yields = || finding.numbers.keys().any(|name| name.starts_with("share_yielded"));
        match parts.damage.get(&finding.group) {
            Some(group) => group.measures.keys().any(|name| !name.starts_with("plastic_")),
            None => !yields(),
        }
    };
    let findings = summary.conclusion.findings.iter().filter(|finding| finding.id.starts_with("damage_"));
    let cracking = findings.filter(cracks).map(|finding| &finding.group);
    let known =
        parts.failure_modes.keys().chain(parts.sections.keys()).chain(summary.computed.linings.keys());
    known.chain(cracking).map(String::as_str).collect()
}

fn number(finding: &Finding, name: &str) -> f64 {
    finding.numbers.get(name).copied().unwrap_or(f64::NAN)
}

/// A sentence as a slot; files of other versions have the text alone.
fn spoken(said: &Said, text: &str) -> Slot {
    if said.is_empty() { Slot::from(text) } else { Slot::from(said.clone()) }
}

/// How a lining is damaged whose cracks do not run through its thickness.
fn damaged(finding: &Finding) -> Said {
    let share = |name: &str| number(finding, name) > 0.0;
    let lining = &finding.group;
    match (share("share_cracked"), share("share_crushed_or_sheared"), share("share_yielded_in_shear")) {
        (true, true, _) => said!("{lining}: cracked, and crushed or sheared.", lining = lining),
        (true, false, _) => said!("{lining}: cracked.", lining = lining),
        (false, true, _) => said!("{lining}: crushed or sheared.", lining = lining),
        (false, false, true) => said!("{lining}: yielded in shear.", lining = lining),
        (false, false, false) if share("share_yielded_in_tension") => {
            said!("{lining}: yielded in tension.", lining = lining)
        }
        _ => said!("{lining}: hardly damaged.", lining = lining),
    }
}

fn headline(finding: &Finding) -> Said {
    let headline = spoken(&finding.headline_message, &finding.headline);
    said!("{group}: {headline}.", group = &finding.group, headline = headline)
}

/// Three significant digits.
fn figures(x: f64) -> String {
    if x.is_infinite() {
        return "∞".into();
    }
    let digits = if x == 0.0 { 2 } else { (2 - x.abs().log10().floor() as i32).clamp(0, 9) };
    format!("{x:.0$}", digits as usize)
}

/// A limit: the same without zeros at its end.
fn bound(x: f64) -> String {
    let text = figures(x);
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}

fn sections_beyond(run: &Run) -> Vec<Said> {
    let mut found = Vec::new();
    for (lining, of) in run.summary.parts.sections.iter().filter(|_| !run.failed()) {
        let each = [(false, &of.bending), (true, &of.shear)];
        for (shear, used) in each.into_iter().filter_map(|(shear, used)| Some((shear, used.as_ref()?))) {
            if size(used.value) > 1.0 {
                found.push((size(used.value), beyond(run, lining, of, shear, used)));
            }
        }
    }
    found.sort_by(|a, b| b.0.total_cmp(&a.0));
    found.into_iter().map(|(_, said)| said).collect()
}

fn beyond(run: &Run, lining: &str, of: &SectionStrength, shear: bool, used: &Used) -> Said {
    let value = figures(size(used.value));
    let place = used.at.map(|x| format!("{x:.1}").replace('-', "−")).join(", ");
    let first = match shear {
        true => said!(
            "Shear utilisation of {lining}: {value} (limit 1) at ({place}) m.",
            lining = lining,
            value = value,
            place = place,
        ),
        false => said!(
            "Utilisation of {lining} in thrust and moment: {value} (limit 1) at ({place}) m.",
            lining = lining,
            value = value,
            place = place,
        ),
    };
    let modes = run.summary.parts.failure_modes.get(lining);
    let second = match shear {
        true if of.yields && modes.is_some_and(|modes| modes.shear != JudgedBy::Law) => {
            said!("This model does not compute shear failure of a section.")
        }
        false if of.yields => said!("The lining's own law cracks: read both."),
        _ => return first,
    };
    said!("{first} {second}", first = first, second = second)
}

/// What a limit is for.
fn quantity(key: &str) -> Said {
    match key {
        "displacement" => said!("Displacement of a monitor"),
        "relative_displacement" => said!("Relative displacement of two monitors"),
        "crack_width" => said!("Crack width"),
        "damage" => said!("Cracked share of a lining's volume"),
        "crushing" => said!("Crushed or sheared share of a lining's volume"),
        "utilisation" => said!("Utilisation of a section"),
        other => Said::plain(other),
    }
}

/// A value of a limit with its unit.
fn measured(key: &str, value: f64, told: fn(f64) -> String) -> String {
    match key {
        "displacement" | "relative_displacement" | "crack_width" => format!("{} mm", told(1e3 * value)),
        "damage" | "crushing" => format!("{} %", told(100.0 * value)),
        _ => told(value),
    }
}

fn limit_not_met(held: &HeldLimit) -> Said {
    said!(
        "{quantity}: {found} (limit {limit}) at {subject}.",
        quantity = quantity(&held.key),
        found = measured(&held.key, held.found.unwrap_or(f64::INFINITY), figures),
        limit = measured(&held.key, held.limit, bound),
        subject = &held.subject,
    )
}

fn limit_not_known(held: &HeldLimit) -> Said {
    said!(
        "{quantity}: not known (limit {limit}).",
        quantity = quantity(&held.key),
        limit = measured(&held.key, held.limit, bound),
    )
}

fn limit_inapplicable(held: &HeldLimit) -> Said {
    said!("{quantity}: no material of this run can crack.", quantity = quantity(&held.key))
}

fn not_complete(run: &Run) -> Vec<Said> {
    match run.summary.conclusion.status {
        Status::Failed => Vec::new(),
        Status::Stopped => vec![said!("The run was stopped before its end.")],
        Status::Done => {
            let trust = run.summary.soundness.checks.iter();
            let cut = trust.filter(|line| line.id == "truncated_motion" && !line.pass);
            cut.map(|line| {
                said!("Shaking not run: {share} % (limit 1 %).", share = figures(100.0 * line.value))
            })
            .collect()
        }
    }
}

fn modes_not_judged(run: &Run) -> Vec<Said> {
    let modes = run.summary.parts.failure_modes.iter().filter(|_| !run.failed());
    modes.filter_map(|(lining, modes)| mode_not_judged(lining, modes, run.summary)).collect()
}

fn mode_not_judged(lining: &str, modes: &FailureModes, summary: &Summary) -> Option<Said> {
    let open = [modes.thrust_moment, modes.shear].map(|by| by == JudgedBy::Nothing);
    let section = summary.parts.sections.get(lining);
    match (open, section) {
        ([false, false], _) => None,
        (_, Some(of)) if of.stations < modes.stations => Some(said!(
            "{lining}: {some} of {all} stations judged by [[section]]. Name all groups of the lining in it.",
            lining = lining,
            some = of.stations.to_string(),
            all = modes.stations.to_string(),
        )),
        (_, Some(of)) => {
            Some(said!("Shear of {lining}: {code} has no clause for it.", lining = lining, code = &of.code))
        }
        ([true, _], None) => Some(said!(
            "No strength is known for {lining} (law {law}). Add a [[section]] to judge it.",
            lining = lining,
            law = &modes.law,
        )),
        ([false, true], None) => Some(said!(
            "Shear of {lining}: this model does not compute shear failure of a section. Add a [[section]] to judge it.",
            lining = lining,
        )),
    }
}

/// Whether a check is so far beyond its limit that results are not to be used.
fn is_far(line: &TrustLine) -> bool {
    let far = FAR.iter().find(|(id, _)| line.id == *id);
    far.is_some_and(|(_, far)| match line.bound {
        Bound::AtMost => line.value > *far,
        Bound::AtLeast => line.value < *far,
    })
}

fn check(line: &TrustLine) -> Said {
    let name = spoken(&line.name_message, &line.name);
    match line.value.is_nan() {
        true => said!("Check '{name}': no value.", name = name),
        false => said!(
            "Check '{name}': {value} (limit {limit}).",
            name = name,
            value = figures(line.value),
            limit = bound(line.limit),
        ),
    }
}

/// The items as docs/report.md prints them.
pub fn table() -> String {
    let mut text = String::from("| item | condition | state |\n|---|---|---|\n");
    for item in &STATE {
        text += &format!("| `{}` | {} | {} |\n", item.id, item.condition, item.class.words());
    }
    text += "\n| item | condition | reliance |\n|---|---|---|\n";
    for item in &RELIANCE {
        text += &format!("| `{}` | {} | {} |\n", item.id, item.condition, item.class.words());
    }
    text += "\n| check | not to be used beyond |\n|---|---|\n";
    for (id, far) in &FAR {
        text += &format!("| `{id}` | {far} |\n");
    }
    text
}
