//! What came in and what the free field made of it: the wave that was asked for, each column at its surface and base by theory
//! and as it moved, and the model at its corner farthest from its column.

use tremolite_results::{FreeField, Station, Velocities};

use crate::chart::{Chart, Line, Mark, Panel, Stroke};
use crate::curves::Curves;
use crate::figure::{Block, Chapter, Figure, Section};
use crate::free_field_beside::{Drawn, farthest_from_theory, same};
use crate::free_field_numbers::{AXES, PLACES, SAME, Wave, from_column, from_theory, largest, percent};
use crate::free_field_tables::{of_columns, of_corners};
use crate::scale::{Scale, figures, quantity, trimmed};
use crate::source::Source;

const HEADING: &str = "What came in and what the free field made of it";
/// A component this much smaller than the largest does not count as moving: the sides that hold a normal go by the same.
const IDLE: f64 = 1e-3;
/// A component that the model alone has, as caverns and layers that dip scatter it, is drawn from this share of the largest on:
/// a tenth of what the check of its corners allows.
const SCATTERED: f64 = 0.01;
/// Share of the incident wave's peak that the rows should show, for their peaks to be those of the motion.
const SHOWN: f64 = 0.95;

/// The section of the page; nothing where the run wrote no free_field.csv.
pub fn section(source: &Source) -> Option<Section> {
    let found = match source.free_field.as_ref()? {
        Ok(found) => found,
        Err(why) => return Some(Section::left_out(HEADING, why)),
    };
    let stations: Vec<&Station> = found.columns.iter().chain(&found.model).chain(&found.corners).collect();
    if stations.is_empty() {
        return Some(Section::left_out(HEADING, "free_field.csv has no columns of velocities."));
    }
    let wave = Wave::of(source, &found.time);
    // What moves is for the free field to say: the model also moves where its cavern scatters.
    let free = if found.columns.is_empty() { &stations[..] } else { &stations[..found.columns.len()] };
    let size = |axis: usize| {
        let places = free.iter().flat_map(|station| station.places());
        let histories = places.flat_map(|place| [&place.measured[axis], &place.theory[axis]]);
        histories.map(|values| largest(values)).fold(wave.incident[axis], f64::max)
    };
    let sizes = [0, 1, 2].map(size);
    let most = sizes.into_iter().fold(0.0, f64::max);
    if most == 0.0 {
        return Some(Section::left_out(HEADING, "free_field.csv holds no motion."));
    }
    let first = (0..3).filter(|&axis| sizes[axis] > 0.0).max_by(|&a, &b| sizes[a].total_cmp(&sizes[b]));
    let first = first.unwrap_or(0);
    let drawn = Drawn::of(found);
    let size = |axis: usize| sizes[axis].max(drawn.largest(axis));
    let moving: Vec<usize> =
        (0..3).filter(|&axis| sizes[axis] > IDLE * most || size(axis) > SCATTERED * most).collect();
    // One unit for all, in which what is a tenth of the largest still has its figures.
    let scale = Scale::suiting("m/s", 0.1 * most);
    let chart =
        Chart { title: HEADING.into(), time: &found.time, panels: panels(&wave, &drawn, (&moving, &scale)) };
    let mut caption = drawn.why.clone();
    for axis in (0..3).filter(|axis| !moving.contains(axis)) {
        let size = match size(axis) {
            size if size > 0.0 => format!("nowhere more than {}", quantity("m/s", size)),
            _ => "zero".into(),
        };
        caption.push_str(&format!(" Not drawn: {}, {size}.", AXES[axis]));
    }
    let figure = Figure {
        heading: String::new(),
        file: "free_field.svg".into(),
        svg: chart.draw(source.language),
        caption: caption.trim().into(),
        curves: Some(Curves::of_chart(&chart, source.language)),
    };
    let block = Block {
        lead: verdict(source, found, &wave, &drawn, (first, &scale)),
        text: explained(found),
        figures: vec![figure],
        ..Block::default()
    };
    let tables = [
        ("Peaks of velocity of the columns", of_columns(found, &moving, &scale)),
        ("Peaks of velocity of the model at its corners", of_corners(found, &drawn, &moving, &scale)),
    ];
    let tables = tables.into_iter().filter(|(_, table)| !table.rows.is_empty());
    let tables = tables.map(|(heading, table)| Block {
        heading: heading.into(),
        tables: vec![table],
        ..Block::default()
    });
    let blocks = std::iter::once(block).chain(tables).collect();
    Some(Section::Told(Chapter { id: "free-field", heading: HEADING.into(), blocks }))
}

/// A surface and a base for each component that moves.
fn panels<'a>(wave: &'a Wave, drawn: &Drawn<'a>, (moving, scale): (&[usize], &Scale)) -> Vec<Panel<'a>> {
    let mut panels = Vec::new();
    for (k, place) in PLACES.into_iter().enumerate() {
        for &axis in moving {
            let line = |name: String, values: &'a [f64], colour, stroke| {
                let known = values.iter().any(|x| x.is_finite());
                known.then(|| Line { name, values: values.into(), colour, stroke })
            };
            let of_column = |what: &str, of: fn(&'a Velocities) -> &'a [Vec<f64>; 3], colour, stroke| {
                let column = drawn.column?;
                line(format!("{}, {what}", column.name), &of(column.places()[k])[axis], colour, stroke)
            };
            let of_model = || {
                let beside = drawn.model.as_ref()?;
                let values = &beside.model.places()[k].measured[axis];
                line(format!("model, {}", beside.place), values, 3, Stroke::Dashed)
            };
            // In the order in which they are drawn: what may be hidden lies broad below what hides it.
            let lines = [
                of_column("theory", |of| &of.theory, 5, Stroke::Broad),
                line("incident wave".into(), &wave.at_rows[axis], 2, Stroke::Thin),
                of_column("as it moved", |of| &of.measured, 0, Stroke::Thin),
                of_model(),
            ];
            let lines: Vec<Line> = lines.into_iter().flatten().collect();
            if !lines.is_empty() {
                let title = format!("{place}, velocity along {}", AXES[axis]);
                panels.push(Panel { title, scale: scale.clone(), lines, mark: Mark::Largest });
            }
        }
    }
    panels
}

/// Whether what came out is what was put in, in one sentence of numbers for the component that moves most.
fn verdict(
    source: &Source,
    found: &FreeField,
    wave: &Wave,
    drawn: &Drawn,
    (axis, scale): (usize, &Scale),
) -> String {
    let speed = |values: &[f64]| scale.quantity(largest(values));
    let mut parts = Vec::new();
    let incident = wave.incident[axis];
    if incident > 0.0 {
        let kind = source.facts().motion.kind;
        let kind = if kind.is_empty() { String::new() } else { format!(" ({kind})") };
        parts.push(format!(
            "the motion given{kind} peaks at {} and the incident wave at {}",
            scale.quantity(wave.given[axis]),
            scale.quantity(incident)
        ));
    }
    let places = drawn.column.iter().flat_map(|column| (0..2).map(|k| (*column, k)));
    for (column, k) in places {
        let (place, of) = (PLACES[k], column.places()[k]);
        let (measured, theory) = (&of.measured[axis], &of.theory[axis]);
        if measured.is_empty() {
            continue;
        }
        let times = match place == PLACES[0] && incident > 0.0 {
            true => format!(", {} times the incident wave", figures(largest(measured) / incident, 3)),
            false => String::new(),
        };
        let beside = from_theory(column, k, axis).map_or("no theory".into(), |share| {
            format!("theory {}; they differ by at most {} of its peak", speed(theory), percent(share))
        });
        parts.push(format!("the {place} of column {} at {}{times} ({beside})", column.name, speed(measured)));
    }
    for (beside, k) in drawn.model.iter().flat_map(|beside| (0..2).map(move |k| (beside, k))) {
        let measured = &beside.model.places()[k].measured[axis];
        if measured.is_empty() {
            continue;
        }
        let apart = beside.column.and_then(|column| from_column(beside.model, column, k, axis));
        let apart = apart.map_or(String::new(), |share| {
            format!(" (differing from the column's by at most {} of its peak)", percent(share))
        });
        parts.push(format!("the model's own {}, {}, at {}{apart}", PLACES[k], beside.place, speed(measured)));
    }
    let mut text = format!("Along {} {}.", AXES[axis], parts.join("; "));
    if let (Some(apart), Some(beside), Some(column)) = (drawn.apart, &drawn.model, drawn.column) {
        text.push_str(&match apart.share > SAME {
            true => format!(
                " The corner of the model farthest from its column is {}: by {} of the peak of column {}, along {} at the {}.",
                beside.model.name,
                percent(apart.share),
                column.name,
                AXES[apart.axis],
                PLACES[apart.place]
            ),
            false => " No corner of the model differs from its column.".into(),
        });
    }
    if let Some((farthest, at)) = farthest_from_theory(found)
        && drawn.column.is_some_and(|column| !same(farthest, column))
    {
        text.push_str(&format!(
            " The column farthest from theory is {}: by {} of its peak, along {} at the {}.",
            farthest.name,
            percent(at.share),
            AXES[at.axis],
            PLACES[at.place]
        ));
    }
    let seen = largest(&wave.at_rows[axis]);
    if seen < SHOWN * incident {
        text.push_str(&format!(
            " The rows are too few to show the wave: at their times the incident one peaks at {}.",
            scale.quantity(seen)
        ));
    }
    text
}

/// What the numbers are.
fn explained(found: &FreeField) -> String {
    let interval = match found.time[..] {
        [first, second, ..] => format!(", {} apart", trimmed(&quantity("s", second - first))),
        _ => String::new(),
    };
    let mut text = format!(
        "Peaks and differences are those of the rows of free_field.csv{interval}, not of steps. A difference is the largest of \
         any row, over the largest component of the column, or of its theory, at surface or base: as in the checks 'model's \
         corners against free field', which takes every step and may find more, and 'free field against theory'. The \
         incident wave is what comes up through the base; at the base it stands together with what comes back from above. A \
         surface moves twice the incident wave where nothing is layered, damped or yields."
    );
    if found.corners.is_empty() && found.model.is_some() {
        text.push_str(
            " This file holds the mean of the model's four corners alone, in which errors of opposite sign cancel and which \
             no column stands for where the ground differs between corners.",
        );
    }
    if found.columns.iter().any(|column| column.name.starts_with("reference-")) {
        text.push_str(" A reference column is named by the corners of the model that it stands for.");
    }
    let places = found.columns.iter().any(|column| column.name.starts_with(['x', 'y']));
    if places {
        text.push_str(
            " A column is named by the side outside which it stands, then by the end of that side.",
        );
    }
    let has_theory =
        |column: &Station| column.places().iter().any(|of| of.theory.iter().any(|v| !v.is_empty()));
    let without: Vec<&str> =
        found.columns.iter().filter(|c| !has_theory(c)).map(|column| column.name.as_str()).collect();
    if !without.is_empty() {
        text.push_str(&format!(" The file holds no theory for {}.", without.join(", ")));
    }
    text
}
