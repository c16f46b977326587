//! Figures of the motion that a case gives: acceleration by component, velocity and displacement, response spectra.

pub mod deconvolved;
pub mod processing;
mod record_at_place;
mod transfer;
pub mod waves;

use tremolite_results::Table;

use crate::chapter::figure::{Block, Chapter, Figure, Section};
use crate::chapter::results_text::kind_of_motion;
use crate::drawing::chart::{Chart, Curve, Mark, Panel, Stroke};
use crate::language::say;
use crate::quantities::scale::figures;
use crate::quantities::units::Kind;
use crate::script::curves::Curves;
use crate::source::Source;
use crate::spectra;

const AXES: [&str; 3] = ["x", "y", "z"];
/// Of the largest component: what a record that is turned into the model's axes leaves along one that it does not have.
const ROUND_OFF: f64 = 1e-9;

fn largest(values: &[f64]) -> f64 {
    values.iter().filter(|x| x.is_finite()).fold(0.0, |most, x| f64::max(most, x.abs()))
}

/// The components of a kind of the given motion that are more than round-off, by axis.
fn moving<'t>(table: &'t Table, kind: &str) -> Vec<(usize, &'t [f64])> {
    let column = |axis: usize| table.column(&format!("given.{kind}{}", AXES[axis]));
    let known: Vec<_> = (0..3).filter_map(|axis| Some((axis, column(axis)?))).collect();
    let most = known.iter().map(|(_, values)| largest(values)).fold(0.0, f64::max);
    known.into_iter().filter(|(_, values)| largest(values) > ROUND_OFF * most).collect()
}

/// The axes along which the file holds a motion that is round-off or nothing.
fn still(table: &Table, moving: &[(usize, &[f64])]) -> Vec<&'static str> {
    let known = |axis: &usize| table.column(&format!("given.a{}", AXES[*axis])).is_some();
    let still = (0..3).filter(|axis| moving.iter().all(|(moving, _)| moving != axis));
    still.filter(known).map(|axis| AXES[axis]).collect()
}

fn line((axis, values): (usize, &[f64])) -> Curve<'_> {
    Curve { name: AXES[axis].to_owned(), values: values.into(), colour: axis, stroke: Stroke::Thin }
}

/// The section of the page; nothing where the run wrote no motion.csv.
pub fn section(source: &Source) -> Option<Section> {
    let language = source.language;
    let heading = say!(language, "The motion that comes in");
    let table = match source.motion.as_ref()? {
        Ok(table) => table,
        Err(why) => return Some(Section::left_out(&heading, why)),
    };
    let accelerations = moving(table, "a");
    let scale = source.scale(Kind::Acceleration);
    // Components one below the other, on one unit.
    let panels: Vec<Panel> = accelerations
        .iter()
        .map(|&(axis, values)| Panel {
            title: say!(language, "acceleration along {axis}", axis = AXES[axis]),
            scale: scale.clone(),
            lines: vec![line((axis, values))],
            mark: Mark::Largest,
        })
        .collect();
    let drift: Vec<Panel> = [
        ("v", say!(language, "velocity"), Kind::Velocity),
        ("u", say!(language, "displacement"), Kind::Displacement),
    ]
    .into_iter()
    .map(|(letter, title, kind)| (moving(table, letter), title, kind))
    .filter(|(components, ..)| !components.is_empty())
    .map(|(components, title, kind)| Panel {
        title,
        scale: source.scale(kind),
        lines: components.into_iter().map(line).collect(),
        mark: Mark::Largest,
    })
    .collect();
    if panels.is_empty() && drift.is_empty() {
        return Some(Section::left_out(&heading, say!(language, "motion.csv holds no motion.")));
    }
    let drawn = |panels: Vec<Panel>, title: &str, file: &str, caption: String| {
        let time = table.column("time").unwrap_or(&[]);
        let chart = Chart { title: title.into(), time, panels };
        Figure {
            heading: String::new(),
            file: file.into(),
            svg: chart.draw(language),
            caption,
            curves: Some(Curves::of_chart(&chart, language)),
            narrow: None,
        }
    };
    let mut figures = Vec::new();
    if !panels.is_empty() {
        figures.push(drawn(
            panels,
            &heading,
            "input.svg",
            caption(source, &accelerations, &still(table, &accelerations)),
        ));
    }
    if !drift.is_empty() {
        let title = say!(language, "Velocity and displacement that come in");
        let words = say!(
            language,
            "The same motion, integrated. Velocity and displacement should end near zero; the model follows any drift."
        );
        figures.push(drawn(drift, &title, "input-drift.svg", words));
    }
    let axes_of: Vec<usize> = accelerations.iter().map(|(axis, _)| *axis).collect();
    let (transfer, notes) = transfer::figure(source, &axes_of);
    figures.extend(transfer);
    figures.extend(record_at_place::figure(source, &moving(table, "v")));
    figures.extend(spectra::of_input(source));
    let blocks = vec![Block { figures, notes, ..Block::default() }];
    Some(Section::Told(Chapter { id: "input", heading, blocks }))
}

/// What the accelerations are, with their peaks.
fn caption(source: &Source, accelerations: &[(usize, &[f64])], still: &[&str]) -> String {
    let language = source.language;
    let peaks = accelerations.iter().map(|(axis, values)| {
        say!(
            language,
            "{peak} along {axis}",
            peak = source.quantity(Kind::Acceleration, largest(values)),
            axis = AXES[*axis]
        )
    });
    let peaks = peaks.collect::<Vec<_>>().join(&say!(language, ", "));
    let mut text = say!(
        language,
        "As the case gives it, windowed, filtered and turned into the model's axes; largest {peaks}.",
        peaks = peaks
    );
    if !still.is_empty() {
        text.push(' ');
        text.push_str(&say!(
            language,
            "Nothing comes in along {axes}.",
            axes = still.join(&say!(language, ", "))
        ));
    }
    let facts = source.facts();
    let factor = facts.computed.motion.factor;
    if let Some(site) = &facts.computed.motion.deconvolved {
        text.push(' ');
        text.push_str(&deconvolved::words(language, site));
    } else if !facts.computed.motion.waves.is_empty() {
        text.push(' ');
        text.push_str(&waves::words(language, &facts.computed.motion));
    } else if factor.is_finite() && !facts.computed.motion.kind.is_empty() {
        text.push(' ');
        text.push_str(&say!(
            language,
            "It is taken as {kind}: the wave that comes up through the base is {factor} times this.",
            kind = kind_of_motion(language, &facts.computed.motion.kind),
            factor = figures(factor, 3)
        ));
    }
    text
}
