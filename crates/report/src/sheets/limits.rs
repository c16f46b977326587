//! Limits of acceptance beside what was found.

use serde::Serialize;
use tremolite_results::limits::{
    HeldLimit, LimitOutcome, coded_cracks, largest_displacement, largest_relative, largest_share, limits,
    loose_monitors, most_used, unknown_crack, widest_crack,
};
use tremolite_results::study::StudyLimit;
use tremolite_results::{Cracks, SectionStrength, Summary};

use crate::damage::{direction, told};
use crate::language::say;
use crate::quantities::scale::{figures, trimmed};
use crate::quantities::units::Kind;
use crate::section_forces::used::{forces, left, part, place, shown};
use crate::sheets::model::of_another_concrete;
use crate::source::Source;
use crate::source::monitor_pairs::held;
use crate::verdict::short_names::percent;

/// A limit, what was found, and whether it is met.
#[derive(Serialize)]
pub struct LimitRow {
    /// The limit's key in the case, and what was found beside it, SI.
    #[serde(skip)]
    key: String,
    #[serde(skip)]
    value: Option<f64>,
    #[serde(skip)]
    bound: f64,
    name: String,
    found: String,
    note: String,
    limit: String,
    /// `pass`, `fail` or `none`: the colour.
    class: &'static str,
    mark: String,
}

impl LimitRow {
    /// Whether what was found is beyond it.
    pub fn is_beyond(&self) -> bool {
        self.class == "fail"
    }

    /// Its key, and the same for the table of a study.
    pub fn told(self) -> (String, StudyLimit) {
        let met = match self.class {
            "pass" => Some(true),
            "fail" => Some(false),
            _ => None,
        };
        let unit = match self.key.as_str() {
            "displacement" | "relative_displacement" | "crack_width" => "m",
            _ => "1",
        };
        let found = self.value.filter(|value| value.is_finite());
        (self.key, StudyLimit { limit: self.bound, found, met, unit: unit.into() })
    }
}

/// A value found: as it is told, and where.
type Found = Option<(String, String)>;

/// The limits that the case or the command gave.
pub fn rows(source: &Source, summary: &Summary) -> Vec<LimitRow> {
    let language = source.language;
    let found_of = |name: &str, limit: f64| match name {
        "displacement" => (
            say!(language, "Displacement of a monitor"),
            source.quantity(Kind::Displacement, limit),
            displacement(source, summary),
        ),
        "relative_displacement" => (
            say!(language, "Relative displacement of two monitors"),
            source.quantity(Kind::Displacement, limit),
            relative(source, summary),
        ),
        "crack_width" => {
            let name = match tells_directions(summary) {
                true => say!(language, "Width of cracks across bars"),
                false => say!(language, "Crack width"),
            };
            (name, source.quantity(Kind::Opening, limit), crack(source, summary))
        }
        "damage" => (
            say!(language, "Cracked share of a lining's volume"),
            percent(limit),
            share(summary, "d_tension"),
        ),
        "crushing" => (
            say!(language, "Crushed or sheared share of a lining's volume"),
            percent(limit),
            share(summary, "d_shear"),
        ),
        "utilisation" => (
            say!(language, "Utilisation of a section"),
            trimmed(&figures(limit, 3)),
            utilisation(source, summary),
        ),
        other => (other.to_owned(), trimmed(&figures(limit, 3)), None),
    };
    let row = |held: HeldLimit| {
        let HeldLimit { key, limit, found: value, outcome, .. } = held;
        let (name, limit_text, found) = found_of(&key, limit);
        let (class, mark) = match outcome {
            LimitOutcome::Inapplicable => ("none", say!(language, "does not apply")),
            LimitOutcome::Unknown => ("none", say!(language, "not known")),
            // A limit that is not met stays so; one that is met may not be at the end.
            LimitOutcome::MetSoFar => ("none", say!(language, "met so far")),
            LimitOutcome::Met => ("pass", say!(language, "met")),
            LimitOutcome::NotMet => ("fail", say!(language, "not met")),
        };
        let beyond = unknown_crack(summary).filter(|_| key == "crack_width");
        let (found, note) = match (found.filter(|_| value.is_some()), outcome) {
            (Some((text, note)), _) => (text, note),
            (None, LimitOutcome::Inapplicable) => {
                (String::new(), say!(language, "no material of this run can crack"))
            }
            (None, _) => match beyond {
                Some(lining) => {
                    let note = say!(
                        language,
                        "{lining}: loaded beyond its strength, so its bars may have yielded",
                        lining = lining
                    );
                    (String::new(), note)
                }
                None if key == "relative_displacement" && !loose_pairs(source, summary).is_empty() => {
                    let pairs = loose_pairs(source, summary).join(&say!(language, ", "));
                    (String::new(), say!(language, "{names}: on broken elements", names = pairs))
                }
                None => (String::new(), say!(language, "the results do not hold it")),
            },
        };
        let limit_text = format!("≤ {limit_text}");
        LimitRow { key, value, bound: limit, name, found, note, limit: limit_text, class, mark }
    };
    limits(summary, source.monitors.as_ref().ok()).into_iter().map(row).collect()
}

/// Pairs of monitors that do not count, because one of them is on a broken element.
fn loose_pairs<'a>(source: &Source, summary: &'a Summary) -> Vec<&'a str> {
    held(source, summary).1
}

/// A note with what it leaves out.
fn without(source: &Source, note: String, loose: &[&str]) -> String {
    match loose.is_empty() {
        true => note,
        false => say!(
            source.language,
            "{first}; not counted, on broken elements: {names}",
            first = note,
            names = loose.join(&say!(source.language, ", "))
        ),
    }
}

fn displacement(source: &Source, summary: &Summary) -> Found {
    let (monitor, time, size) = largest_displacement(source.monitors.as_ref().ok()?, summary)?;
    let at = crate::quantities::scale::moment(time, source.duration());
    let note = say!(source.language, "{monitor} at {time}\u{a0}s", monitor = monitor, time = at);
    let note = match beside(source, monitor, time) {
        Some(free) => say!(
            source.language,
            "{place}, when the free field beside it has moved by {free}",
            place = note,
            free = source.quantity(Kind::Displacement, free)
        ),
        None => note,
    };
    let loose = loose_monitors(summary);
    Some((source.quantity(Kind::Displacement, size), without(source, note, &loose)))
}

/// How far \[m\] the free field beside a monitor has moved at a time \[s\]: its velocity in the rows of free_field.csv, by the trapezoidal rule.
fn beside(source: &Source, monitor: &str, time: f64) -> Option<f64> {
    let field = source.free_field.as_ref()?.as_ref().ok()?;
    let moved = |velocity: &Vec<f64>| {
        let steps = field.time.windows(2).zip(velocity.windows(2)).take_while(|(t, _)| t[1] <= time);
        steps.map(|(t, v)| 0.5 * (v[0] + v[1]) * (t[1] - t[0])).sum::<f64>()
    };
    let size = field.beside.get(monitor)?.iter().map(moved).map(|u| u * u).sum::<f64>().sqrt();
    size.is_finite().then_some(size)
}

fn relative(source: &Source, summary: &Summary) -> Found {
    let (pair, peaks) = largest_relative(source.monitors.as_ref().ok(), summary)?;
    let at = crate::quantities::scale::moment(peaks.t_max, source.duration());
    let note = say!(source.language, "{monitor} at {time}\u{a0}s", monitor = pair, time = at);
    let note = without(source, note, &loose_pairs(source, summary));
    Some((source.quantity(Kind::Displacement, peaks.max), note))
}

/// The widest crack of a lining that cracks, or by the code of one with bars.
fn crack(source: &Source, summary: &Summary) -> Found {
    let coded = coded_cracks(summary).max_by(|a, b| a.1.total_cmp(&b.1));
    match (widest_crack(summary), coded) {
        (None, None) => None,
        (Some((_, width)), Some((lining, coded, of))) if coded >= width => by_code(source, lining, of),
        (None, Some((lining, _, of))) => by_code(source, lining, of),
        (Some((lining, _)), _) => modelled(source, summary, lining),
    }
}

/// The crack that is left in a section with bars.
fn by_code(source: &Source, lining: &str, of: &SectionStrength) -> Found {
    let note = say!(source.language, "{lining}, left at the end, by EN 1992-1-1 7.3.4", lining = lining);
    Some((left(source, of), note))
}

/// Whether the results tell which way cracks run.
pub fn tells_directions(summary: &Summary) -> bool {
    summary.parts.damage.values().any(|group| group.cracks.as_ref().is_some_and(|c| c.across().is_some()))
}

/// The widest crack of a lining that crosses bars, or whatever its direction where the results do not tell that.
fn modelled(source: &Source, summary: &Summary, lining: &str) -> Found {
    let language = source.language;
    let cracks: &Cracks = summary.parts.damage.get(lining)?.cracks.as_ref()?;
    let (width, widest, runs) = match cracks.across() {
        Some(across) => (across.opening, across.widest, Some(across.direction)),
        None => (cracks.opening, cracks.widest, None),
    };
    let note = match (widest.is_some(), runs) {
        (false, _) => String::new(),
        (true, Some(runs)) => say!(
            language,
            "{lining}, {direction}, widest in the run",
            lining = lining,
            direction = direction(language, runs)
        ),
        (true, None) => say!(language, "{lining}, widest in the run, in whatever direction", lining = lining),
    };
    let found = if widest.is_some() { told(source, width) } else { say!(language, "none") };
    Some((found, with_parallel(source, summary, note)))
}

/// A note with the widest crack parallel to the wall, which no bars cross and no limit of width is for.
fn with_parallel(source: &Source, summary: &Summary, note: String) -> String {
    let parallel = summary.parts.damage.values().filter_map(|group| group.cracks.as_ref()?.parallel());
    let parallel = parallel.filter(|of| of.widest.is_some());
    let Some(of) = parallel.max_by(|a, b| a.opening.total_cmp(&b.opening)) else { return note };
    let text =
        say!(source.language, "parallel to the wall, not judged: {width}", width = told(source, of.opening));
    match note.is_empty() {
        true => text,
        false => format!("{note}{}{text}", say!(source.language, "; ")),
    }
}

/// The largest share of a lining's volume in which a measure of damage is above 0.5.
fn share(summary: &Summary, measure: &str) -> Found {
    let (lining, most) = largest_share(summary, measure)?;
    Some((percent(most), lining))
}

fn utilisation(source: &Source, summary: &Summary) -> Found {
    let (lining, shear, used) = most_used(summary)?;
    let language = source.language;
    let way = if shear { say!(language, "in shear") } else { say!(language, "in thrust and moment") };
    let mut note = format!(
        "{way}{}{lining}{}{} {}; {}",
        say!(language, ", "),
        say!(language, ", "),
        part(language, &used.part),
        place(source, used),
        forces(language, used)
    );
    if summary.parts.sections.get(lining).is_some_and(|of| of.yields) {
        note.push_str(&say!(language, "; a cross-check, since this lining can crack"));
        let of = summary.parts.sections.get(lining);
        if of.is_some_and(|of| !of_another_concrete(summary, of).is_empty()) {
            note.push_str(&say!(language, ", and of another concrete than the model's"));
        }
    }
    Some((shown(used.value), note))
}
