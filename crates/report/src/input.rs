//! Figure of the motion that a case gives: acceleration, velocity and displacement along the model's axes.

use crate::chart::{Chart, Line, Mark, Panel, Stroke};
use crate::figure::{Figure, Section};
use crate::scale::{Scale, figures, quantity};
use crate::source::Source;

const HEADING: &str = "The motion that comes in";
const AXES: [&str; 3] = ["x", "y", "z"];

fn largest(values: &[f64]) -> f64 {
    values.iter().filter(|x| x.is_finite()).fold(0.0, |most, x| f64::max(most, x.abs()))
}

/// The section of the page; nothing where the run wrote no motion.csv.
pub fn section(source: &Source) -> Option<Section> {
    let table = match source.motion.as_ref()? {
        Ok(table) => table,
        Err(why) => return Some(Section::left_out(HEADING, why)),
    };
    let mut panels = Vec::new();
    let mut peaks = Vec::new();
    for (kind, title, unit) in
        [("a", "acceleration", "m/s2"), ("v", "velocity", "m/s"), ("u", "displacement", "m")]
    {
        let columns = AXES
            .iter()
            .enumerate()
            .filter_map(|(k, axis)| Some((k, axis, table.column(&format!("given.{kind}{axis}"))?)));
        let moving: Vec<_> = columns.filter(|(_, _, values)| largest(values) > 0.0).collect();
        let most = moving.iter().map(|(_, _, values)| largest(values)).fold(0.0, f64::max);
        if moving.is_empty() {
            continue;
        }
        peaks.push(quantity(unit, most));
        let line = |(colour, axis, values): (usize, &&str, _)| Line {
            name: (*axis).to_owned(),
            values,
            colour,
            stroke: Stroke::Thin,
        };
        panels.push(Panel {
            title: title.into(),
            scale: Scale::suiting(unit, most),
            lines: moving
                .into_iter()
                .map(|(colour, axis, values)| line((colour, axis, values.into())))
                .collect(),
            mark: Mark::Largest,
        });
    }
    if panels.is_empty() {
        return Some(Section::left_out(HEADING, "motion.csv holds no motion."));
    }
    let facts = source.facts();
    let factor = facts.motion.factor;
    let mut caption = format!(
        "As the case gives it, windowed, filtered and turned into the model's axes; largest {}.",
        peaks.join(", ")
    );
    if factor.is_finite() && !facts.motion.kind.is_empty() {
        caption.push_str(&format!(
            " It is taken as {}: the wave that comes up through the base is {} times this.",
            facts.motion.kind,
            figures(factor, 3)
        ));
    }
    caption.push_str(" Velocity and displacement should end near zero; the model follows any drift.");
    let time = table.column("time").unwrap_or(&[]);
    let svg = Chart { title: HEADING.into(), time, panels }.draw(source.language);
    Some(Section::Drawn(vec![Figure { heading: HEADING.into(), file: "input.svg".into(), svg, caption }]))
}
