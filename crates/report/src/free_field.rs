//! What came in and what the free field made of it: the wave that was asked for, each column at its surface and base by theory
//! and as it moved, and the model beside them.

use tremolite_results::{FreeField, Station, Velocities};

use crate::chart::{Chart, Line, Mark, Panel, Stroke};
use crate::figure::{Block, Chapter, Figure, Section};
use crate::free_field_numbers::{AXES, Drawn, Wave, apart, largest, percent};
use crate::scale::{Scale, figures, quantity, trimmed};
use crate::source::Source;
use crate::text_table::{Cell, Head, TextTable};

/// What the places of a station are called.
const PLACES: [&str; 2] = ["surface", "base"];
const HEADING: &str = "What came in and what the free field made of it";
/// A component this much smaller than the largest does not count as moving: the sides that hold a normal go by the same.
const IDLE: f64 = 1e-3;
/// Share of the incident wave's peak that the rows should show, for their peaks to be those of the motion.
const SHOWN: f64 = 0.95;

/// The section of the page; nothing where the run wrote no free_field.csv.
pub fn section(source: &Source) -> Option<Section> {
    let found = match source.free_field.as_ref()? {
        Ok(found) => found,
        Err(why) => return Some(Section::left_out(HEADING, why)),
    };
    let stations: Vec<&Station> = found.columns.iter().chain(&found.model).collect();
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
    let moving: Vec<usize> = (0..3).filter(|&axis| sizes[axis] > IDLE * most).collect();
    let first = moving.iter().copied().max_by(|&a, &b| sizes[a].total_cmp(&sizes[b])).unwrap_or(0);
    let drawn = Drawn::of(found, &moving);
    // One unit for all, in which what is a tenth of the largest still has its figures.
    let scale = Scale::suiting("m/s", 0.1 * most);
    let svg = Chart {
        title: HEADING.into(),
        time: &found.time,
        panels: panels(found, &wave, &drawn, (&moving, &scale)),
    };
    let mut caption = drawn.why.clone();
    for axis in (0..3).filter(|axis| !moving.contains(axis)) {
        let size = if sizes[axis].is_nan() || sizes[axis] == 0.0 {
            "zero".into()
        } else {
            format!("nowhere more than {}", quantity("m/s", sizes[axis]))
        };
        caption.push_str(&format!(" Not drawn: {}, {size}.", AXES[axis]));
    }
    let figure = Figure {
        heading: String::new(),
        file: "free_field.svg".into(),
        svg: svg.draw(),
        caption: caption.trim().into(),
    };
    let block = Block {
        lead: verdict(source, found, &wave, &drawn, (first, &scale)),
        text: explained(found),
        figures: vec![figure],
        ..Block::default()
    };
    let peaks = Block {
        heading: "Peaks of velocity at surface and base".into(),
        tables: vec![table(found, &drawn, &moving, &scale)],
        ..Block::default()
    };
    Some(Section::Told(Chapter { id: "free-field", heading: HEADING.into(), blocks: vec![block, peaks] }))
}

/// A surface and a base for each component that moves.
fn panels<'a>(
    found: &'a FreeField,
    wave: &'a Wave,
    drawn: &Drawn<'a>,
    (moving, scale): (&[usize], &Scale),
) -> Vec<Panel<'a>> {
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
                let values = &found.model.as_ref()?.places()[k].measured[axis];
                line("model, as it moved".into(), values, 3, Stroke::Dashed)
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
    for (place, of) in drawn.column.iter().flat_map(|column| PLACES.into_iter().zip(column.places())) {
        let (measured, theory) = (&of.measured[axis], &of.theory[axis]);
        if measured.is_empty() {
            continue;
        }
        let times = match place == PLACES[0] && incident > 0.0 {
            true => format!(", {} times the incident wave", figures(largest(measured) / incident, 3)),
            false => String::new(),
        };
        let beside = apart(measured, theory).map_or("no theory".into(), |share| {
            format!("theory {}; they differ by at most {} of the peak", speed(theory), percent(share))
        });
        let name = drawn.column.map_or("", |column| &column.name);
        parts.push(format!("the {place} of column {name} at {}{times} ({beside})", speed(measured)));
    }
    for (k, of) in found.model.iter().flat_map(Station::places).enumerate() {
        let measured = &of.measured[axis];
        if measured.is_empty() {
            continue;
        }
        let beside = drawn.column.and_then(|column| apart(measured, &column.places()[k].measured[axis]));
        let beside = beside.map_or(String::new(), |share| {
            format!(" (differing from the column's by at most {})", percent(share))
        });
        parts.push(format!("the model's own {} at {}{beside}", PLACES[k], speed(measured)));
    }
    let mut text = format!("Along {} {}.", AXES[axis], parts.join("; "));
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
        "Peaks of the free field are those of the rows of free_field.csv{interval}, not of steps; differences are the largest \
         of any row, over the larger of the two peaks. The incident wave is what comes up through the base; at the base it \
         stands together with what comes back from above. A surface moves twice the incident wave where nothing is layered, \
         damped or yields."
    );
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

/// Peaks of all columns, and of the model, at surface and base.
fn table(found: &FreeField, drawn: &Drawn, moving: &[usize], scale: &Scale) -> TextTable {
    let mut over = vec![Head::words("").over(2)];
    over.extend(PLACES.map(|place| Head::number(place).over(3)));
    let mut head = vec![Head::words("column"), Head::words("along")];
    for _ in PLACES {
        head.push(Head::number(scale.labelled("peak")));
        head.push(Head::number(scale.labelled("theory")));
        head.push(Head::number("differs by (% of peak)"));
    }
    let peak = |values: &[f64]| Cell::number(scale.number(largest(values)));
    let share =
        |share: Option<f64>| Cell::number(share.map_or("–".into(), |s| percent(s).replace("\u{a0}%", "")));
    let mut rows = Vec::new();
    for station in found.columns.iter().chain(&found.model) {
        let is_model = found.model.as_ref().is_some_and(|model| std::ptr::eq(model, station));
        let mut name = station.name.as_str();
        for &axis in moving {
            let places = station.places();
            if places.iter().all(|of| of.measured[axis].is_empty() && of.theory[axis].is_empty()) {
                continue;
            }
            let mut row = vec![Cell::words(std::mem::take(&mut name)), Cell::words(AXES[axis])];
            let beside = drawn.column.filter(|_| is_model).map(Station::places);
            for (k, of) in places.into_iter().enumerate() {
                let measured = &of.measured[axis];
                row.extend([peak(measured), peak(&of.theory[axis])]);
                row.push(match beside {
                    Some(of) => share(apart(measured, &of[k].measured[axis])),
                    None => share(apart(measured, &of.theory[axis])),
                });
            }
            if let Some(column) = drawn.column.filter(|_| is_model && !row[0].text.is_empty()) {
                row[0].note = format!("against {}", column.name);
            }
            rows.push(row);
        }
    }
    TextTable { head: vec![over, head], rows }
}
