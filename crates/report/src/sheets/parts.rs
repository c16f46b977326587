//! What became of each part: linings in a table, what lies around them in a line each.

use tremolite_results::{Cracks, GroupDamage, Summary};

use crate::chapter::text_table::{Cell, Head, TextTable};
use crate::damage::{direction, of_direction, opening};
use crate::language::say;
use crate::quantities::units::Kind;
use crate::section_forces::used::{left, shown, unborne};
use crate::sheets::limits::tells_directions;
use crate::source::Source;
use crate::verdict::short_names::percent;
use crate::verdict::surroundings;

/// Linings by rows: utilisation, cracks.
pub fn table(source: &Source, summary: &Summary) -> TextTable {
    let language = source.language;
    let none = || "–".to_owned();
    let mut head = vec![Head::words(say!(language, "part"))];
    // What no part has is no column.
    let judged = !summary.parts.sections.is_empty();
    let can_crack = |group: &GroupDamage| group.cracks.is_some() || group.measures.contains_key("d_tension");
    let cracks = summary.parts.damage.values().any(can_crack);
    let parallel = tells_directions(summary);
    let of_code = [
        say!(language, "utilisation, thrust and moment"),
        say!(language, "in shear"),
        say!(language, "stations above 1"),
    ];
    let of_model = [
        say!(language, "cracked volume (D⁺ > 0.5)"),
        match parallel {
            true => say!(language, "widest crack across bars"),
            false => say!(language, "widest crack"),
        },
        say!(language, "through the thickness"),
    ];
    head.extend(of_code.map(Head::number).into_iter().filter(|_| judged));
    head.extend(of_model.map(Head::number).into_iter().filter(|_| cracks));
    if parallel {
        head.push(Head::number(say!(language, "crack parallel to the wall")));
    }
    // By the code, of linings with bars alone.
    let lasting = summary.parts.sections.values().any(|of| of.crack.is_some());
    if lasting {
        head.push(Head::number(say!(language, "crack width left, by code")));
    }
    let mut names: Vec<&String> = summary.parts.sections.keys().collect();
    let concrete = |group: &&String| {
        let of: Option<&GroupDamage> = summary.parts.damage.get(*group);
        of.is_some_and(|group| group.cracks.is_some())
    };
    let found = summary.conclusion.findings.iter().filter(|f| f.id.starts_with("damage_")).map(|f| &f.group);
    let found: Vec<&String> = found.filter(concrete).collect();
    names.extend(found.into_iter().filter(|name| !summary.parts.sections.contains_key(*name)));
    let rows = names.into_iter().map(|name| {
        let mut row = vec![Cell::words(name)];
        match summary.parts.sections.get(name) {
            Some(of) => {
                let used = |used: &Option<tremolite_results::Used>| {
                    used.as_ref().map_or_else(none, |used| shown(used.value))
                };
                row.extend([used(&of.bending), used(&of.shear)].map(Cell::number));
                // Files of older versions do not say by what.
                let stations = match of.beyond > 0 && of.beyond_bending + of.beyond_shear > 0 {
                    true => say!(
                        language,
                        "of {stations}: {bending} by N and M, {shear} by shear",
                        stations = of.stations,
                        bending = of.beyond_bending,
                        shear = of.beyond_shear
                    ),
                    false => say!(language, "of {stations}", stations = of.stations),
                };
                let nothing = unborne(language, of);
                let stations = match nothing.is_empty() {
                    true => stations,
                    false => format!("{stations}{}{nothing}", say!(language, "; ")),
                };
                row.push(Cell::number(of.beyond.to_string()).with(stations));
            }
            None if judged => row.extend([none(), none(), none()].map(Cell::number)),
            None => {}
        }
        if cracks {
            row.extend(cracked(source, summary, name));
        }
        if parallel {
            let cracks = summary.parts.damage.get(name).and_then(|group| group.cracks.as_ref());
            row.push(Cell::number(of_direction(source, cracks.and_then(|cracks| cracks.parallel()))));
        }
        if lasting {
            let of = summary.parts.sections.get(name);
            row.push(Cell::number(of.map_or_else(none, |of| left(source, of))));
        }
        row
    });
    let rows: Vec<Vec<Cell>> = rows.collect();
    TextTable { head: if rows.is_empty() { Vec::new() } else { vec![head] }, rows }
}

/// Of one part: cracked share of its volume, widest crack, places cracked through.
fn cracked(source: &Source, summary: &Summary, name: &str) -> [Cell; 3] {
    let language = source.language;
    let none = || "–".to_owned();
    let group = summary.parts.damage.get(name);
    let share = |of: &str| {
        let measure = group?.measures.get(of)?;
        Some(measure.beyond.get("0.5").copied().unwrap_or(0.0) / group?.volume)
    };
    let cracked = Cell::number(share("d_tension").map_or_else(none, percent));
    let cracked = match share("d_shear").filter(|crushed| *crushed > 0.0) {
        Some(crushed) => cracked.with(say!(language, "{crushed} crushed", crushed = percent(crushed))),
        None => cracked,
    };
    let cracks = group.and_then(|group| group.cracks.as_ref());
    let across = cracks.and_then(|cracks| cracks.across());
    let widest = match (cracks, across) {
        (_, Some(across)) => of_direction(source, Some(across)),
        (Some(cracks), None) if cracks.widest.is_some() => opening(source, cracks),
        (Some(_), None) => say!(language, "none"),
        (None, None) => none(),
    };
    let widest = Cell::number(widest);
    // Of loose pieces the width at the end means little.
    let known = |width: f64, left: f64| width <= Cracks::LOOSE && left.is_finite();
    let left = |left: f64| say!(language, "{left} at the end", left = source.quantity(Kind::Opening, left));
    let widest = match (cracks, across) {
        (_, Some(of)) if of.widest.is_some() => {
            let runs = direction(language, of.direction);
            widest.with(match known(of.opening, of.left) {
                true => format!("{runs}{}{}", say!(language, ", "), left(of.left)),
                false => runs,
            })
        }
        (Some(of), None) if of.widest.is_some() && known(of.opening, of.left) => widest.with(left(of.left)),
        _ => widest,
    };
    let through = match cracks {
        Some(cracks) => {
            let stacks = say!(language, "of {stations}", stations = cracks.stacks);
            Cell::number(cracks.through.to_string()).with(stacks)
        }
        None => Cell::number(none()),
    };
    [cracked, widest, through]
}

/// Interfaces, bolts and rock, a sentence each.
pub fn around(source: &Source, summary: &Summary) -> Vec<String> {
    surroundings::all_around(source.language, summary)
}
