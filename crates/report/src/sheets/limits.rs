//! Limits of acceptance beside what was found.

use serde::Serialize;
use tremolite_results::Summary;

use crate::damage::opening;
use crate::facts::key_results::{largest_displacement, largest_relative, loose_monitors};
use crate::language::say;
use crate::quantities::scale::{figures, trimmed};
use crate::quantities::units::Kind;
use crate::section_forces::used::{left, overloaded, place, shown};
use crate::sheets::model::of_another_concrete;
use crate::source::Source;
use crate::source::monitor_pairs::held;
use crate::verdict::short_names::percent;

/// A limit, what was found, and whether it is met.
#[derive(Serialize)]
pub struct LimitRow {
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
}

/// A value found: as it is told, where, and its number.
type Found = Option<(f64, String, String)>;

/// The limits that the case or the command gave.
pub fn rows(source: &Source, summary: &Summary) -> Vec<LimitRow> {
    let language = source.language;
    let told = |name: &str, limit: f64| match name {
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
            (say!(language, "Crack width"), source.quantity(Kind::Opening, limit), crack(source, summary))
        }
        "damage" => (say!(language, "Cracked share of a lining's volume"), percent(limit), cracked(summary)),
        "utilisation" => (
            say!(language, "Utilisation of a section"),
            trimmed(&figures(limit, 3)),
            utilisation(source, summary),
        ),
        other => (other.to_owned(), trimmed(&figures(limit, 3)), None),
    };
    let row = |(name_of, &limit): (&String, &f64)| {
        let (name, limit_text, found) = told(name_of, limit);
        // What cannot crack has no cracked share.
        let idle = name_of == "damage" && found.is_none() && cannot_crack(summary);
        // Of several linings the widest crack is none where one of them has no width.
        let beyond = unknown_crack(summary).filter(|_| name_of == "crack_width");
        let found = found.filter(|(value, ..)| beyond.is_none() || *value > limit);
        let (class, mark) = match &found {
            None if idle => ("none", say!(language, "does not apply")),
            None => ("none", say!(language, "not known")),
            // What is no number is beyond every limit.
            Some((value, ..)) if *value <= limit => ("pass", say!(language, "met")),
            Some(_) => ("fail", say!(language, "not met")),
        };
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
        LimitRow { name, found, note, limit: format!("≤ {limit_text}"), class, mark }
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
    let loose = loose_monitors(summary);
    Some((size, source.quantity(Kind::Displacement, size), without(source, note, &loose)))
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

fn modelled(source: &Source, summary: &Summary) -> Found {
    let all = summary.parts.damage.iter().filter_map(|(name, group)| Some((name, group.cracks.as_ref()?)));
    let (name, cracks) = all.reduce(|a, b| if b.1.opening > a.1.opening { b } else { a })?;
    match cracks.widest {
        Some(_) => {
            let note =
                say!(source.language, "{lining}, widest in the run, in whatever direction", lining = name);
            Some((cracks.opening, opening(source, cracks), note))
        }
        None => Some((0.0, say!(source.language, "none"), String::new())),
    }
}

fn cracked(summary: &Summary) -> Found {
    let share = |group: &tremolite_results::GroupDamage| {
        let measure = group.measures.get("d_tension")?;
        Some(measure.beyond.get("0.5").copied().unwrap_or(0.0) / group.volume)
    };
    let all = summary.conclusion.findings.iter().filter(|f| f.id.starts_with("damage_"));
    let all = all.filter_map(|f| Some((f.group.clone(), share(summary.parts.damage.get(&f.group)?)?)));
    let (name, most) = all.max_by(|a, b| a.1.total_cmp(&b.1))?;
    Some((most, percent(most), name))
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
    let mut note = format!("{way}{}{lining} {}", say!(language, ", "), place(source, &used));
    if summary.parts.sections.get(&lining).is_some_and(|of| of.yields) {
        note.push_str(&say!(language, "; a cross-check, since this lining can crack"));
        let of = summary.parts.sections.get(&lining);
        if of.is_some_and(|of| of_another_concrete(summary, of).is_some()) {
            note.push_str(&say!(language, ", and of another concrete than the model's"));
        }
    }
    Some((size(used.value), shown(used.value), note))
}
