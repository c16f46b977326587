//! What became of each part: linings in a table, what lies around them in a line each.

use tremolite_results::{GroupDamage, Summary};

use crate::chapter::text_table::{Cell, Head, TextTable};
use crate::damage::opening;
use crate::language::say;
use crate::section_forces::used::{left, shown};
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
    let of_code = [
        say!(language, "utilisation, thrust and moment"),
        say!(language, "in shear"),
        say!(language, "stations above 1"),
    ];
    let of_model = [
        say!(language, "cracked volume"),
        say!(language, "widest crack"),
        say!(language, "through the thickness"),
    ];
    head.extend(of_code.map(Head::number).into_iter().filter(|_| judged));
    head.extend(of_model.map(Head::number).into_iter().filter(|_| cracks));
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
                let stations = say!(language, "of {stations}", stations = of.stations);
                row.push(Cell::number(of.beyond.to_string()).with(stations));
            }
            None if judged => row.extend([none(), none(), none()].map(Cell::number)),
            None => {}
        }
        if cracks {
            row.extend(cracked(source, summary, name));
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
    let share = group.and_then(|group| {
        let measure = group.measures.get("d_tension")?;
        Some(measure.beyond.get("0.5").copied().unwrap_or(0.0) / group.volume)
    });
    let cracks = group.and_then(|group| group.cracks.as_ref());
    let widest = match cracks {
        Some(cracks) if cracks.widest.is_some() => opening(source, cracks),
        Some(_) => say!(language, "none"),
        None => none(),
    };
    let through = match cracks {
        Some(cracks) => {
            let stacks = say!(language, "of {stations}", stations = cracks.stacks);
            Cell::number(cracks.through.to_string()).with(stacks)
        }
        None => Cell::number(none()),
    };
    [Cell::number(share.map_or_else(none, percent)), Cell::number(widest), through]
}

/// Interfaces, bolts and rock, a sentence each.
pub fn around(source: &Source, summary: &Summary) -> Vec<String> {
    surroundings::all_around(source.language, summary)
}
