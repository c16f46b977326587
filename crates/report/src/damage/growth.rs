//! Figure of how damage grew over the run.

use std::borrow::Cow;

use tremolite_results::{Column, CrackDirection, Subject, Table};

use crate::chapter::figure::Section;
use crate::damage::crack_widths::width_by_mesh;
use crate::damage::heading;
use crate::drawing::chart::{Curve, Mark, Panel, Stroke};
use crate::histories::legible::{self, Titles};
use crate::language::{Language, say};
use crate::quantities::scale::Scale;
use crate::quantities::units::Kind;
use crate::source::Source;

/// The section of the page; nothing for a run in which nothing could be damaged.
pub fn section(source: &Source) -> Option<Section> {
    let language = source.language;
    let heading = say!(language, "Damage over time");
    let table = match source.damage.as_ref()? {
        Ok(table) => table,
        Err(why) => return Some(Section::left_out(&heading, why)),
    };
    let time = table.column("time").unwrap_or(&[]);
    let panels = panels(source, table);
    if panels.is_empty() {
        return Some(Section::left_out(&heading, say!(language, "Nothing was damaged.")));
    }
    let first = say!(
        language,
        "Share of each group's volume that is cracked or crushed (damage above 0.5) or has yielded, and the widest crack so \
         far. Look whether it grows at once or with every cycle; what still grows at the end of the run may go on."
    );
    let caption = say!(language, "{first} {second}", first = first, second = width_by_mesh(language));
    let titles = Titles { heading: &heading, file: "damage", caption: &caption };
    Some(Section::Drawn(legible::figures(language, &titles, time, panels)))
}

/// A panel for each measure that rose in some group; a group keeps its colour.
fn panels<'a>(source: &Source, table: &'a Table) -> Vec<Panel<'a>> {
    let language = source.language;
    let mut groups: Vec<&str> = Vec::new();
    let mut panels: Vec<(String, Panel)> = Vec::new();
    for (group, title, unit, values) in columns(language, table) {
        let most = values.iter().copied().filter(|x| x.is_finite()).fold(0.0, f64::max);
        if most == 0.0 {
            continue;
        }
        let colour = groups.iter().position(|g| *g == group).unwrap_or_else(|| {
            groups.push(group);
            groups.len() - 1
        });
        let line = Curve { name: group.into(), values, colour, stroke: Stroke::Thin };
        let scale = if unit == "m" {
            source.scale(Kind::Opening)
        } else {
            Scale { factor: 100.0, unit: say!(language, "% of volume") }
        };
        match panels.iter_mut().find(|(name, _)| *name == title) {
            Some((_, panel)) => panel.lines.push(line),
            None => {
                let panel = Panel { title: title.clone(), scale, lines: vec![line], mark: Mark::Highest };
                panels.push((title, panel));
            }
        }
    }
    panels.into_iter().map(|(_, panel)| panel).collect()
}

/// Group, what is drawn, unit, values: the shares, and the widest crack so far, where the file tells directions of those across bars and of those
/// parallel to the wall.
type Drawn<'a> = (&'a str, String, &'a str, Cow<'a, [f64]>);

fn columns(language: Language, table: &Table) -> Vec<Drawn<'_>> {
    let mut drawn: Vec<Drawn> = Vec::new();
    let ways = |column: &Column| CrackDirection::ALL.into_iter().find(|way| way.column() == column.quantity);
    let tells = |group: &str| {
        let own = |column: &&Column| matches!(&column.subject, Subject::Group(name) if name == group);
        table.columns.iter().filter(own).any(|column| ways(column).is_some())
    };
    for (column, values) in table.columns.iter().zip(&table.values) {
        let (Subject::Group(group), measure) = (&column.subject, column.quantity.as_str()) else { continue };
        let title = match (ways(column), measure) {
            // D_b repeats what D⁺ and D⁻ show, and the widest of all what its direction shows.
            (None, "d_b_max") => continue,
            (None, "crack_opening") if tells(group) => continue,
            (Some(way), _) if way.crosses_bars() => say!(language, "widest crack across bars"),
            (Some(_), _) => say!(language, "widest crack parallel to the wall"),
            (None, _) if column.unit == "m" => say!(language, "widest crack"),
            (None, _) => heading(language, measure),
        };
        match drawn.iter_mut().find(|(of, known, ..)| of == group && *known == title) {
            // Of cracks across bars the widest of any direction.
            Some((.., widest)) => {
                widest.to_mut().iter_mut().zip(values).for_each(|(most, x)| *most = most.max(*x));
            }
            None => drawn.push((group, title, &column.unit, values.into())),
        }
    }
    drawn
}
