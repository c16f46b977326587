//! Limits of acceptance beside the values found in the results.

use crate::{Cracks, GroupDamage, Peaks, SectionStrength, Status, Subject, Summary, Table, Used, halves};
use indexmap::IndexMap;

/// Whether a limit is met.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LimitOutcome {
    Met,
    NotMet,
    /// Met up to the end of a run that is not complete.
    MetSoFar,
    /// The results do not hold the value.
    Unknown,
    /// No material of the run can crack.
    Inapplicable,
}

/// A limit of acceptance beside the value found.
#[derive(Clone, Debug, PartialEq)]
pub struct HeldLimit {
    /// Its key in the case.
    pub key: String,
    /// SI.
    pub limit: f64,
    /// SI; infinite where nothing resists.
    pub found: Option<f64>,
    /// The monitor, pair of monitors or lining it was found at.
    pub subject: String,
    pub outcome: LimitOutcome,
}

/// Pair of monitors with the peaks of its quantities.
pub type PairPeaks<'a> = (&'a str, &'a IndexMap<String, Peaks>);

/// The limits of a run in the order of its case. `monitors` is monitors.csv.
pub fn limits(summary: &Summary, monitors: Option<&Table>) -> Vec<HeldLimit> {
    summary.case.report.limits.iter().map(|(key, &limit)| held(key, limit, summary, monitors)).collect()
}

fn held(key: &str, limit: f64, summary: &Summary, monitors: Option<&Table>) -> HeldLimit {
    let found = value(key, summary, monitors);
    // The widest crack of several linings is not known where one of them has no width.
    let unknown = key == "crack_width" && unknown_crack(summary).is_some();
    let found = found.filter(|(_, value)| !unknown || *value > limit);
    let inapplicable = matches!(key, "damage" | "crushing") && cannot_crack(summary);
    let outcome = match &found {
        None if inapplicable => LimitOutcome::Inapplicable,
        None => LimitOutcome::Unknown,
        // A value that is no number is beyond every limit.
        Some((_, value)) if *value <= limit => match summary.is_complete() {
            true => LimitOutcome::Met,
            false => LimitOutcome::MetSoFar,
        },
        Some(_) => LimitOutcome::NotMet,
    };
    let (subject, found) = found.map_or((String::new(), None), |(subject, value)| (subject, Some(value)));
    HeldLimit { key: key.to_owned(), limit, found, subject, outcome }
}

/// Subject and value of what a limit is for.
fn value(key: &str, summary: &Summary, monitors: Option<&Table>) -> Option<(String, f64)> {
    match key {
        "displacement" => {
            largest_displacement(monitors?, summary).map(|(monitor, _, size)| (monitor.to_owned(), size))
        }
        "relative_displacement" => {
            largest_relative(monitors, summary).map(|(pair, peaks)| (pair.to_owned(), peaks.max))
        }
        "crack_width" => {
            let modelled = widest_crack(summary).map(|(lining, width)| (lining.to_owned(), width));
            let coded = coded_cracks(summary).map(|(lining, width, _)| (lining.to_owned(), width));
            modelled.into_iter().chain(coded).max_by(|a, b| a.1.total_cmp(&b.1))
        }
        "damage" => largest_share(summary, "d_tension"),
        "crushing" => largest_share(summary, "d_shear"),
        "utilisation" => most_used(summary).map(|(lining, _, used)| (lining.to_owned(), size(used.value))),
        _ => None,
    }
}

/// A utilisation; an infinite one is no number in the file.
pub fn size(utilisation: f64) -> f64 {
    if utilisation.is_nan() { f64::INFINITY } else { utilisation }
}

/// Monitors on broken elements, and those that count; where all are on such they are all there is.
fn counted(summary: &Summary) -> (Vec<&String>, Vec<&String>) {
    let (loose, counted): (Vec<&String>, Vec<&String>) =
        summary.monitors.peaks.keys().partition(|name| summary.monitors.on_broken_elements.contains(name));
    if counted.is_empty() { (counted, loose) } else { (loose, counted) }
}

/// Monitors that do not count beside others, because they are on broken elements.
pub fn loose_monitors(summary: &Summary) -> Vec<&str> {
    counted(summary).0.into_iter().map(String::as_str).collect()
}

/// Monitor, time (s) and length (m) of the largest displacement, but for those on broken elements.
pub fn largest_displacement<'a>(monitors: &Table, summary: &'a Summary) -> Option<(&'a str, f64, f64)> {
    let time = monitors.column("time")?;
    let mut best: Option<(&str, f64, f64)> = None;
    for monitor in counted(summary).1 {
        let parts = ["ux", "uy", "uz"].map(|q| monitors.column(&format!("{monitor}.{q}")));
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

/// The monitors of a pair: as its columns say or, in files of older versions that have none, its name.
pub fn monitors_of(table: Option<&Table>, summary: &Summary, pair: &str) -> Option<[String; 2]> {
    let subjects = table.into_iter().flat_map(|table| &table.columns).map(|column| &column.subject);
    let told = subjects
        .filter(|subject| matches!(subject, Subject::Relative(_)))
        .find(|subject| subject.name().as_deref() == Some(pair));
    match told {
        Some(Subject::Relative(monitors)) => Some(monitors.clone()),
        _ => Some(halves(pair, |name| summary.monitors.peaks.contains_key(name))?.map(str::to_owned)),
    }
}

/// The pairs of a run of which no monitor is on a broken element, and the names of the others: nothing holds such an element.
pub fn held_pairs<'a>(table: Option<&Table>, summary: &'a Summary) -> (Vec<PairPeaks<'a>>, Vec<&'a str>) {
    let is_broken = |monitor: &String| summary.monitors.on_broken_elements.contains(monitor);
    let one_is_broken =
        |pair: &str| monitors_of(table, summary, pair).is_some_and(|of| of.iter().any(is_broken));
    let pairs = summary.monitors.relative.iter().map(|(pair, peaks)| (pair.as_str(), peaks));
    let (broken, held): (Vec<_>, Vec<_>) = pairs.partition(|(pair, _)| one_is_broken(pair));
    (held, broken.into_iter().map(|(pair, _)| pair).collect())
}

/// Pair of monitors with the largest displacement (m) of two against each other, but for those on broken elements.
pub fn largest_relative<'a>(table: Option<&Table>, summary: &'a Summary) -> Option<(&'a str, Peaks)> {
    let lengths =
        held_pairs(table, summary).0.into_iter().filter_map(|(pair, of)| Some((pair, *of.get("u")?)));
    lengths.filter(|(_, peaks)| peaks.max.is_finite()).max_by(|a, b| a.1.max.total_cmp(&b.1.max))
}

/// Lining and width (m) of the widest crack of the model that crosses bars, or of any where the results do not tell directions.
pub fn widest_crack(summary: &Summary) -> Option<(&str, f64)> {
    let width = |cracks: &Cracks| cracks.across().map_or(cracks.opening, |across| across.opening);
    let all = summary.parts.damage.iter().filter_map(|(name, group)| Some((name, group.cracks.as_ref()?)));
    let all = all.map(|(name, cracks)| (name.as_str(), width(cracks)));
    all.reduce(|a, b| if b.1 > a.1 { b } else { a })
}

/// Lining, width (m) that is left in a section with bars by the code, and the section; infinite where bars yield.
pub fn coded_cracks(summary: &Summary) -> impl Iterator<Item = (&str, f64, &SectionStrength)> {
    summary.parts.sections.iter().filter_map(|(name, of)| {
        let crack = of.crack.as_ref().filter(|crack| crack.station > 0)?;
        // The cracks that forces beyond its strength leave are not known to an elastic law.
        (!of.is_overloaded()).then(|| (name.as_str(), size(crack.width), of))
    })
}

/// Whether no material can crack: the results give no cracked share.
pub fn cannot_crack(summary: &Summary) -> bool {
    let cracks = |group: &GroupDamage| group.measures.contains_key("d_tension");
    !summary.computed.materials.is_empty() && !summary.parts.damage.values().any(cracks)
}

/// A lining whose width of cracks is asked for, but not known since it was loaded beyond its strength.
pub fn unknown_crack(summary: &Summary) -> Option<&String> {
    let asked = |of: &SectionStrength| of.crack.as_ref().is_some_and(|c| c.station > 0);
    summary.parts.sections.iter().find(|(_, of)| asked(of) && of.is_overloaded()).map(|(name, _)| name)
}

/// Lining and share of its volume in which a measure of damage is above 0.5, of the lining with the largest.
pub fn largest_share(summary: &Summary, measure: &str) -> Option<(String, f64)> {
    let share = |group: &GroupDamage| {
        let measure = group.measures.get(measure)?;
        Some(measure.beyond.get("0.5").copied().unwrap_or(0.0) / group.volume)
    };
    let all = summary.conclusion.findings.iter().filter(|f| f.id.starts_with("damage_"));
    let all = all.filter_map(|f| Some((f.group.clone(), share(summary.parts.damage.get(&f.group)?)?)));
    all.max_by(|a, b| a.1.total_cmp(&b.1))
}

/// Lining, whether in shear, and state of the section that uses most of its strength.
pub fn most_used(summary: &Summary) -> Option<(&str, bool, &Used)> {
    let each = summary.parts.sections.iter().flat_map(|(lining, of)| {
        let both = [(false, of.bending.as_ref()), (true, of.shear.as_ref())];
        both.into_iter().filter_map(move |(shear, used)| Some((lining.as_str(), shear, used?)))
    });
    each.max_by(|a, b| size(a.2.value).total_cmp(&size(b.2.value)))
}

impl Summary {
    /// Whether the run reached its end and at most 1 % of the shaking, by ∫a² dt, was left out.
    pub fn is_complete(&self) -> bool {
        let cut = self.soundness.checks.iter().any(|line| line.id == "truncated_motion" && !line.pass);
        self.conclusion.status == Status::Done && !cut
    }
}

impl SectionStrength {
    /// Whether a lining that can neither crack nor yield was loaded beyond its strength in thrust and moment: an elastic law does not know
    /// the cracks that this leaves.
    pub fn is_overloaded(&self) -> bool {
        !self.yields && self.bending.as_ref().is_some_and(|used| size(used.value) > 1.0)
    }
}
