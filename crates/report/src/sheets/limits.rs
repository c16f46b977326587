//! Limits of acceptance beside what was found.

use serde::Serialize;
use tremolite_results::study::StudyLimit;
use tremolite_results::{Cracks, Status, Summary};

use crate::damage::{direction, told};
use crate::facts::key_results::{largest_displacement, largest_relative, loose_monitors};
use crate::language::{Language, say};
use crate::quantities::scale::{figures, trimmed};
use crate::quantities::units::Kind;
use crate::section_forces::used::{forces, left, overloaded, part, place, shown};
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

/// A value found: as it is told, where, and its number.
type Found = Option<(f64, String, String)>;

/// The limits that the case or the command gave.
pub fn rows(source: &Source, summary: &Summary) -> Vec<LimitRow> {
    let language = source.language;
    let ended = summary.conclusion.status == Status::Done;
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
    let row = |(name_of, &limit): (&String, &f64)| {
        let (name, limit_text, found) = found_of(name_of, limit);
        // What cannot crack has no cracked share.
        let idle =
            matches!(name_of.as_str(), "damage" | "crushing") && found.is_none() && cannot_crack(summary);
        // Of several linings the widest crack is none where one of them has no width.
        let beyond = unknown_crack(summary).filter(|_| name_of == "crack_width");
        let found = found.filter(|(value, ..)| beyond.is_none() || *value > limit);
        let (class, mark) = match &found {
            None if idle => ("none", say!(language, "does not apply")),
            None => ("none", say!(language, "not known")),
            // What is no number is beyond every limit.
            // Not met is final, met is not before the end.
            Some((value, ..)) if *value <= limit && !ended => ("none", say!(language, "met so far")),
            Some((value, ..)) if *value <= limit => ("pass", say!(language, "met")),
            Some(_) => ("fail", say!(language, "not met")),
        };
        let value = found.as_ref().map(|(value, ..)| *value);
        let (found, note) = match found {
            Some((_, text, note)) => (text, note),
            None if beyond.is_some() => {
                let lining = beyond.map_or("", String::as_str);
                let note = say!(
                    language,
                    "{lining}: loaded beyond its strength, so its bars may have yielded",
                    lining = lining
                );
                (String::new(), note)
            }
            None if idle => (String::new(), say!(language, "no material of this run can crack")),
            None if name_of == "relative_displacement" && !loose_pairs(source, summary).is_empty() => {
                let pairs = loose_pairs(source, summary).join(&say!(language, ", "));
                (String::new(), say!(language, "{names}: on broken elements", names = pairs))
            }
            None => (String::new(), say!(language, "the results do not hold it")),
        };
        let limit_text = format!("≤ {limit_text}");
        LimitRow {
            key: name_of.clone(),
            value,
            bound: limit,
            name,
            found,
            note,
            limit: limit_text,
            class,
            mark,
        }
    };
    summary.case.report.limits.iter().map(row).collect()
}

/// Whether no material can crack: the results say of none how much of it has.
fn cannot_crack(summary: &Summary) -> bool {
    let cracks = |group: &tremolite_results::GroupDamage| group.measures.contains_key("d_tension");
    !summary.computed.materials.is_empty() && !summary.parts.damage.values().any(cracks)
}

/// A lining whose width of cracks is asked for, but not known since it was loaded beyond its strength.
fn unknown_crack(summary: &Summary) -> Option<&String> {
    let asked = |of: &tremolite_results::SectionStrength| of.crack.as_ref().is_some_and(|c| c.station > 0);
    summary.parts.sections.iter().find(|(_, of)| asked(of) && overloaded(of)).map(|(name, _)| name)
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
    let (monitor, time, size) = largest_displacement(source, summary)?;
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
    Some((size, source.quantity(Kind::Displacement, size), without(source, note, &loose)))
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
    let (pair, time, size) = largest_relative(source, summary)?;
    let at = crate::quantities::scale::moment(time, source.duration());
    let note = say!(source.language, "{monitor} at {time}\u{a0}s", monitor = pair, time = at);
    let note = without(source, note, &loose_pairs(source, summary));
    Some((size, source.quantity(Kind::Displacement, size), note))
}

/// The widest crack of a lining that cracks, or by the code of one with bars.
fn crack(source: &Source, summary: &Summary) -> Found {
    let coded = summary.parts.sections.iter().filter_map(|(name, of)| {
        let crack = of.crack.as_ref().filter(|crack| crack.station > 0)?;
        // What it leaves of forces beyond the strength is not known to an elastic law.
        if overloaded(of) {
            return None;
        }
        // Where bars yield there is no number.
        let width = if crack.width.is_nan() { f64::INFINITY } else { crack.width };
        let note = say!(source.language, "{lining}, left at the end, by EN 1992-1-1 7.3.4", lining = name);
        Some((width, left(source, of), note))
    });
    modelled(source, summary).into_iter().chain(coded).max_by(|a, b| a.0.total_cmp(&b.0))
}

/// Whether the results tell which way cracks run.
pub fn tells_directions(summary: &Summary) -> bool {
    summary.parts.damage.values().any(|group| group.cracks.as_ref().is_some_and(|c| c.across().is_some()))
}

/// The widest crack of all linings that crosses bars, or whatever its direction where the results do not tell that.
fn modelled(source: &Source, summary: &Summary) -> Found {
    let language = source.language;
    let judged = |cracks: &Cracks| match cracks.across() {
        Some(across) => (across.opening, across.widest, Some(across.direction)),
        None => (cracks.opening, cracks.widest, None),
    };
    let all = summary.parts.damage.iter().filter_map(|(name, group)| Some((name, group.cracks.as_ref()?)));
    let all = all.map(|(name, cracks)| (name, judged(cracks)));
    let (name, (width, widest, runs)) = all.reduce(|a, b| if b.1.0 > a.1.0 { b } else { a })?;
    let note = match (widest.is_some(), runs) {
        (false, _) => String::new(),
        (true, Some(runs)) => say!(
            language,
            "{lining}, {direction}, widest in the run",
            lining = name,
            direction = direction(language, runs)
        ),
        (true, None) => say!(language, "{lining}, widest in the run, in whatever direction", lining = name),
    };
    let found = if widest.is_some() { told(source, width) } else { say!(language, "none") };
    Some((width, found, with_parallel(source, summary, note)))
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
    let share = |group: &tremolite_results::GroupDamage| {
        let measure = group.measures.get(measure)?;
        Some(measure.beyond.get("0.5").copied().unwrap_or(0.0) / group.volume)
    };
    let all = summary.conclusion.findings.iter().filter(|f| f.id.starts_with("damage_"));
    let all = all.filter_map(|f| Some((f.group.clone(), share(summary.parts.damage.get(&f.group)?)?)));
    let (name, most) = all.max_by(|a, b| a.1.total_cmp(&b.1))?;
    Some((most, percent(most), name))
}

/// That limits are met, or which are not, to be said with the verdict, and its colour; nothing where there are none.
pub fn verdict(language: Language, rows: &[LimitRow]) -> Option<(&'static str, String)> {
    let beyond: Vec<&str> = rows.iter().filter(|row| row.is_beyond()).map(|row| row.name.as_str()).collect();
    let met = rows.iter().filter(|row| row.class == "pass").count();
    match (rows.is_empty(), beyond.is_empty()) {
        (true, _) => None,
        (false, false) => {
            let unknown = rows.len() - met - beyond.len();
            let names = beyond.join(&say!(language, "; "));
            let text = match unknown {
                0 => say!(language, "Limits of acceptance not met: {names}.", names = names),
                unknown => say!(
                    language,
                    "Limits of acceptance not met: {names}; of {unknown} more nothing is known.",
                    names = names,
                    unknown = unknown
                ),
            };
            Some(("bad", text))
        }
        (false, true) if met == rows.len() => {
            let text = match met {
                1 => say!(language, "The one limit of acceptance is met."),
                met => say!(language, "All {met} limits of acceptance are met.", met = met),
            };
            Some(("good", text))
        }
        (false, true) if met == 0 => {
            Some(("warn", say!(language, "No limit of acceptance is known to be met.")))
        }
        (false, true) => Some((
            "warn",
            say!(
                language,
                "{met} of {all} limits of acceptance are met; of the others nothing is known.",
                met = met,
                all = rows.len()
            ),
        )),
    }
}

fn utilisation(source: &Source, summary: &Summary) -> Found {
    let of = |(lining, of): (&String, &tremolite_results::SectionStrength)| {
        let both = [of.bending.clone(), of.shear.clone()];
        let each = both.into_iter().enumerate().filter_map(|(k, used)| Some((k == 1, used?)));
        each.map(|(shear, used)| (lining.clone(), shear, used)).collect::<Vec<_>>()
    };
    // An infinite one is no number in the file.
    let size = |x: f64| if x.is_nan() { f64::INFINITY } else { x };
    let all = summary.parts.sections.iter().flat_map(of);
    let (lining, shear, used) = all.max_by(|a, b| size(a.2.value).total_cmp(&size(b.2.value)))?;
    let language = source.language;
    let way = if shear { say!(language, "in shear") } else { say!(language, "in thrust and moment") };
    let mut note = format!(
        "{way}{}{lining}{}{} {}; {}",
        say!(language, ", "),
        say!(language, ", "),
        part(language, &used.part),
        place(source, &used),
        forces(language, &used)
    );
    if summary.parts.sections.get(&lining).is_some_and(|of| of.yields) {
        note.push_str(&say!(language, "; a cross-check, since this lining can crack"));
        let of = summary.parts.sections.get(&lining);
        if of.is_some_and(|of| !of_another_concrete(summary, of).is_empty()) {
            note.push_str(&say!(language, ", and of another concrete than the model's"));
        }
    }
    Some((size(used.value), shown(used.value), note))
}
