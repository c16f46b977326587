//! Figure of how damage grew over the run.

use tremolite_results::Table;

use crate::chart::{Chart, Line, Mark, Panel, Stroke};
use crate::curves::Curves;
use crate::damage::heading;
use crate::figure::{Figure, Section};
use crate::scale::Scale;
use crate::source::Source;

const HEADING: &str = "Damage over time";

/// The section of the page; nothing for a run in which nothing could be damaged.
pub fn section(source: &Source) -> Option<Section> {
    let table = match source.damage.as_ref()? {
        Ok(table) => table,
        Err(why) => return Some(Section::left_out(HEADING, why)),
    };
    let time = table.column("time").unwrap_or(&[]);
    let panels = panels(table);
    if panels.is_empty() {
        return Some(Section::left_out(HEADING, "Nothing was damaged."));
    }
    let caption = "Share of each group's volume that is cracked or crushed (damage above 0.5) or has yielded, and the \
                   widest crack so far.";
    let chart = Chart { title: HEADING.into(), time, panels };
    let figure = Figure {
        heading: HEADING.into(),
        file: "damage.svg".into(),
        svg: chart.draw(),
        caption: caption.into(),
        curves: Some(Curves::of_chart(&chart)),
    };
    Some(Section::Drawn(vec![figure]))
}

/// A panel for each measure that rose in some group; a group keeps its colour.
fn panels(table: &Table) -> Vec<Panel<'_>> {
    let mut groups: Vec<&str> = Vec::new();
    let mut panels: Vec<(&str, Panel)> = Vec::new();
    for (column, values) in table.columns.iter().zip(&table.values) {
        let Some((group, measure)) = column.name.rsplit_once('.') else { continue };
        let most = values.iter().copied().filter(|x| x.is_finite()).fold(0.0, f64::max);
        // D_b repeats what D⁺ and D⁻ show.
        if measure == "d_b_max" || most == 0.0 {
            continue;
        }
        let colour = groups.iter().position(|g| *g == group).unwrap_or_else(|| {
            groups.push(group);
            groups.len() - 1
        });
        let line = Line { name: group.into(), values: values.into(), colour, stroke: Stroke::Thin };
        let scale = if column.unit == "m" {
            Scale::suiting("m", most)
        } else {
            Scale { factor: 100.0, unit: "% of volume".into() }
        };
        match panels.iter_mut().find(|(name, _)| *name == measure) {
            Some((_, panel)) => panel.lines.push(line),
            None => {
                let title = if column.unit == "m" { "widest crack".into() } else { heading(measure) };
                panels.push((measure, Panel { title, scale, lines: vec![line], mark: Mark::Highest }));
            }
        }
    }
    panels.into_iter().map(|(_, panel)| panel).collect()
}
