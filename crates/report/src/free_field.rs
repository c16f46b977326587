//! Incident motion and free field: the wave that was asked for, each column at its surface and base by theory
//! and as it moved, and the model at its corner farthest from its column.

mod at_corners;
pub mod depth;
pub mod numbers;
mod tables;
mod words;

use tremolite_results::Station;

use crate::chapter::figure::{Block, Chapter, Figure, Section};
use crate::drawing::chart::{Chart, Curve, Mark, Panel, Stroke};
use crate::free_field::at_corners::DrawnCorner;
use crate::free_field::numbers::{AXES, Wave, largest, places};
use crate::free_field::tables::{of_columns, of_corners};
use crate::free_field::words::{explained, verdict};
use crate::language::{Language, say};
use crate::quantities::scale::Scale;
use crate::quantities::units::Kind;
use crate::script::curves::Curves;
use crate::source::Source;

/// A component this much smaller than the largest does not count as moving: the sides that hold a normal go by the same.
const IDLE: f64 = 1e-3;
/// A component that the model alone has, as caverns and layers that dip scatter it, is drawn from this share of the largest on:
/// a tenth of what the check of its corners allows.
const SCATTERED: f64 = 0.01;

/// The section of the page; nothing where the run wrote no free_field.csv.
pub fn section(source: &Source) -> Option<Section> {
    let language = source.language;
    let heading = say!(language, "Incident motion and free field");
    let found = match source.free_field.as_ref()? {
        Ok(found) => found,
        Err(why) => return Some(Section::left_out(&heading, why)),
    };
    let stations: Vec<&Station> = found.columns.iter().chain(&found.model).chain(&found.corners).collect();
    if stations.is_empty() {
        let why = say!(language, "free_field.csv has no columns of velocities.");
        return Some(Section::left_out(&heading, why));
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
        return Some(Section::left_out(&heading, say!(language, "free_field.csv holds no motion.")));
    }
    let first = (0..3).filter(|&axis| sizes[axis] > 0.0).max_by(|&a, &b| sizes[a].total_cmp(&sizes[b]));
    let first = first.unwrap_or(0);
    let drawn = DrawnCorner::of(language, found);
    let size = |axis: usize| sizes[axis].max(drawn.largest(axis));
    let moving: Vec<usize> =
        (0..3).filter(|&axis| sizes[axis] > IDLE * most || size(axis) > SCATTERED * most).collect();
    let scale = source.scale(Kind::Velocity);
    let softened = |column: &&Station| column.top.equivalent.iter().any(|of| !of.is_empty());
    let softened = found.columns.iter().find(softened);
    let panels = panels(language, &wave, &drawn, softened, (&moving, &scale));
    let chart = Chart { title: heading.clone(), time: &found.time, panels };
    let mut caption = drawn.why.clone();
    let theory = drawn.column.iter().flat_map(|column| column.places()).flat_map(|of| &of.theory);
    if theory.flatten().any(|x| x.is_finite()) {
        caption.push_str(&say!(
            language,
            " The thin line of the column should lie on the broad one of theory wherever the ground does not yield."
        ));
    }
    if softened.is_some() {
        caption.push_str(&say!(
            language,
            " Beside ground that yields stands its equivalent-linear column: layers with the modulus and damping that the same laws show at 0.65 \
             of their largest strain. It keeps no lasting displacement and may damp what is fast too much, so nothing is judged by it."
        ));
    }
    for axis in (0..3).filter(|axis| !moving.contains(axis)) {
        caption.push_str(&match size(axis) {
            size if size > 0.0 => say!(
                language,
                " Not drawn: {axis}, nowhere more than {size}.",
                axis = AXES[axis],
                size = scale.quantity(size)
            ),
            _ => say!(language, " Not drawn: {axis}, zero.", axis = AXES[axis]),
        });
    }
    let figure = Figure {
        heading: String::new(),
        file: "free_field.svg".into(),
        svg: chart.draw(source.language),
        caption: caption.trim().into(),
        curves: Some(Curves::of_chart(&chart, source.language)),
        narrow: None,
    };
    let block = Block {
        lead: verdict(source, found, &wave, &drawn, (first, &scale)),
        text: explained(language, found),
        figures: vec![figure],
        ..Block::default()
    };
    let tables = [
        (say!(language, "Peaks of velocity of the columns"), of_columns(language, found, &moving, &scale)),
        (
            say!(language, "Peaks of velocity of the model at its corners"),
            of_corners(language, found, &drawn, &moving, &scale),
        ),
    ];
    let tables = tables.into_iter().filter(|(_, table)| !table.rows.is_empty());
    let tables = tables.map(|(heading, table)| Block { heading, tables: vec![table], ..Block::default() });
    let blocks = std::iter::once(block).chain(tables).collect();
    Some(Section::Told(Chapter { id: "free-field", heading, blocks }))
}

/// A surface and a base for each component that moves.
fn panels<'a>(
    language: Language,
    wave: &'a Wave,
    drawn: &DrawnCorner<'a>,
    softened: Option<&'a Station>,
    (moving, scale): (&[usize], &Scale),
) -> Vec<Panel<'a>> {
    let mut panels = Vec::new();
    for (k, place) in places(language).into_iter().enumerate() {
        for &axis in moving {
            let line = |name: String, values: &'a [f64], colour, stroke| {
                let known = values.iter().any(|x| x.is_finite());
                known.then(|| Curve { name, values: values.into(), colour, stroke })
            };
            let column = drawn.column.map(|column| (&column.name, column.places()[k]));
            let of_theory = || {
                let (name, of) = column?;
                let name = say!(language, "{column}, theory", column = name);
                line(name, &of.theory[axis], 5, Stroke::Broad)
            };
            let of_equivalent = || {
                let softened = softened?;
                let name = say!(language, "{column}, equivalent-linear", column = softened.name);
                line(name, &softened.places()[k].equivalent[axis], 4, Stroke::Dashed)
            };
            let of_column = || {
                let (name, of) = column?;
                let name = say!(language, "{column}, as it moved", column = name);
                line(name, &of.measured[axis], 0, Stroke::Thin)
            };
            let of_model = || {
                let beside = drawn.model.as_ref()?;
                let values = &beside.model.places()[k].measured[axis];
                line(say!(language, "model, {place}", place = beside.place), values, 3, Stroke::Dashed)
            };
            // In the order in which they are drawn: what may be hidden lies broad below what hides it.
            let lines = [
                of_theory(),
                line(say!(language, "incident wave"), &wave.at_rows[axis], 2, Stroke::Thin),
                of_equivalent(),
                of_column(),
                of_model(),
            ];
            let lines: Vec<Curve> = lines.into_iter().flatten().collect();
            if !lines.is_empty() {
                let title =
                    say!(language, "{place}, velocity along {axis}", place = place, axis = AXES[axis]);
                panels.push(Panel { title, scale: scale.clone(), lines, mark: Mark::Largest });
            }
        }
    }
    panels
}
