//! What is said of the free field: what was found, and what the numbers are.

use tremolite_results::{FreeField, Station};

use crate::chapter::results_text::kind_of_motion;
use crate::free_field::at_corners::{DrawnCorner, farthest_from_theory, same};
use crate::free_field::numbers::{AXES, SAME, Wave, from_column, from_theory, largest, percent, places};
use crate::language::{Language, say};
use crate::quantities::scale::{Scale, figures, quantity, trimmed};
use crate::source::Source;

/// Share of the incident wave's peak that the rows should show, for their peaks to be those of the motion.
const SHOWN: f64 = 0.95;

/// Whether what came out is what was put in, in one sentence of numbers for the component that moves most.
pub fn verdict(
    source: &Source,
    found: &FreeField,
    wave: &Wave,
    drawn: &DrawnCorner,
    (axis, scale): (usize, &Scale),
) -> String {
    let language = source.language;
    let mut parts = Vec::new();
    parts.extend(asked(source, wave, (axis, scale)));
    parts.extend(of_column(language, wave, drawn, (axis, scale)));
    parts.extend(of_model(language, drawn, (axis, scale)));
    let list = parts.join(&say!(language, "; "));
    let mut text = say!(language, "Along {axis} {list}.", axis = AXES[axis], list = list);
    text.push_str(&worst(language, found, drawn));
    let (incident, seen) = (wave.incident[axis], largest(&wave.at_rows[axis]));
    if seen < SHOWN * incident {
        text.push_str(&say!(
            language,
            " The rows are too few to show the wave: at their times the incident one peaks at {peak}.",
            peak = scale.quantity(seen)
        ));
    }
    text
}

/// What was asked for.
fn asked(source: &Source, wave: &Wave, (axis, scale): (usize, &Scale)) -> Option<String> {
    let (given, incident) = (scale.quantity(wave.given[axis]), wave.incident[axis]);
    let kind = source.facts().computed.motion.kind;
    let peak = scale.quantity(incident);
    (incident > 0.0).then(|| {
        if kind.is_empty() {
            say!(
                source.language,
                "the motion given peaks at {given} and the incident wave at {incident}",
                given = given,
                incident = peak
            )
        } else {
            say!(
                source.language,
                "the motion given ({kind}) peaks at {given} and the incident wave at {incident}",
                kind = kind_of_motion(source.language, &kind),
                given = given,
                incident = peak
            )
        }
    })
}

/// What the column made of it at its surface and base.
fn of_column(
    language: Language,
    wave: &Wave,
    drawn: &DrawnCorner,
    (axis, scale): (usize, &Scale),
) -> Vec<String> {
    let Some(column) = drawn.column else { return Vec::new() };
    let incident = wave.incident[axis];
    let mut parts = Vec::new();
    for (k, place) in places(language).into_iter().enumerate() {
        let of = column.places()[k];
        let (measured, theory) = (&of.measured[axis], &of.theory[axis]);
        if measured.is_empty() {
            continue;
        }
        let mut speed = scale.quantity(largest(measured));
        if k == 0 && incident > 0.0 {
            let times = figures(largest(measured) / incident, 3);
            speed = say!(language, "{speed}, {times} times the incident wave", speed = speed, times = times);
        }
        let beside = match from_theory(column, k, axis) {
            None => say!(language, "no theory"),
            Some(share) => say!(
                language,
                "theory {theory}; they differ by at most {share} of its peak",
                theory = scale.quantity(largest(theory)),
                share = percent(share)
            ),
        };
        parts.push(say!(
            language,
            "the {place} of column {column} at {speed} ({beside})",
            place = place,
            column = column.name,
            speed = speed,
            beside = beside
        ));
    }
    parts
}

/// What the model did beside it.
fn of_model(language: Language, drawn: &DrawnCorner, (axis, scale): (usize, &Scale)) -> Vec<String> {
    let Some(beside) = &drawn.model else { return Vec::new() };
    let mut parts = Vec::new();
    for (k, place) in places(language).into_iter().enumerate() {
        let measured = &beside.model.places()[k].measured[axis];
        if measured.is_empty() {
            continue;
        }
        let speed = scale.quantity(largest(measured));
        let apart = beside.column.and_then(|column| from_column(beside.model, column, k, axis));
        parts.push(match apart {
            None => say!(
                language,
                "the model's own {place}, {corner}, at {speed}",
                place = place,
                corner = beside.place,
                speed = speed
            ),
            Some(share) => say!(
                language,
                "the model's own {place}, {corner}, at {speed} (differing from the column's by at most {share} of its peak)",
                place = place,
                corner = beside.place,
                speed = speed,
                share = percent(share)
            ),
        });
    }
    parts
}

/// The corner and the column that are farthest from what they should be.
fn worst(language: Language, found: &FreeField, drawn: &DrawnCorner) -> String {
    let places = places(language);
    let mut text = String::new();
    if let (Some(apart), Some(beside), Some(column)) = (drawn.apart, &drawn.model, drawn.column) {
        text.push_str(&match apart.share > SAME {
            true => say!(
                language,
                " The corner of the model farthest from its column is {corner}: by {share} of the peak of column {column}, \
                 along {axis} at the {place}.",
                corner = beside.model.name,
                share = percent(apart.share),
                column = column.name,
                axis = AXES[apart.axis],
                place = places[apart.place]
            ),
            false => say!(language, " No corner of the model differs from its column."),
        });
    }
    if let Some((farthest, at)) = farthest_from_theory(found)
        && drawn.column.is_some_and(|column| !same(farthest, column))
    {
        text.push_str(&say!(
            language,
            " The column farthest from theory is {column}: by {share} of its peak, along {axis} at the {place}.",
            column = farthest.name,
            share = percent(at.share),
            axis = AXES[at.axis],
            place = places[at.place]
        ));
    }
    text
}

/// What the numbers are.
pub fn explained(language: Language, found: &FreeField) -> String {
    let mut text = match found.time[..] {
        [first, second, ..] => say!(
            language,
            "Peaks and differences are those of the rows of free_field.csv, {interval} apart, not of steps.",
            interval = trimmed(&quantity("s", second - first))
        ),
        _ => say!(language, "Peaks and differences are those of the rows of free_field.csv, not of steps."),
    };
    text.push_str(&say!(
        language,
        " A difference is the largest of any row, over the largest component of the column, or of its theory, at surface or \
         base: as in the checks 'motion at the model's corners against the free field', which takes every step and may find more, and 'free field against one-dimensional theory'. The incident wave is what comes up through the base; at the base it stands together with what \
         comes back from above. A surface moves twice the incident wave where nothing is layered, damped or yields."
    ));
    if found.corners.is_empty() && found.model.is_some() {
        text.push_str(&say!(
            language,
            " This file holds the mean of the model's four corners alone, in which errors of opposite sign cancel and which \
             no column stands for where the ground differs between corners."
        ));
    }
    if found.columns.iter().any(|column| column.name.starts_with("reference-")) {
        text.push_str(&say!(
            language,
            " A reference column is named by the corners of the model that it stands for."
        ));
    }
    if found.columns.iter().any(|column| column.name.starts_with(['x', 'y'])) {
        text.push_str(&say!(
            language,
            " A column is named by the side outside which it stands, then by the end of that side."
        ));
    }
    let has_theory =
        |column: &Station| column.places().iter().any(|of| of.theory.iter().any(|v| !v.is_empty()));
    let without: Vec<&str> =
        found.columns.iter().filter(|c| !has_theory(c)).map(|column| column.name.as_str()).collect();
    if !without.is_empty() {
        let list = without.join(", ");
        text.push_str(&say!(language, " The file holds no theory for {list}.", list = list));
    }
    text
}
