//! What came in and what the free field made of it: the wave that was asked for, each column at its surface and base by theory
//! and as it moved, and the model beside them.

use tremolite_results::{FreeField, Station, Velocities};

use crate::chart::{Chart, Line, Mark, Panel, Stroke};
use crate::figure::{Block, Chapter, Figure, Section};
use crate::scale::{Scale, figures, quantity, trimmed};
use crate::source::Source;
use crate::text_table::{Cell, Head, TextTable};

const HEADING: &str = "What came in and what the free field made of it";
const AXES: [&str; 3] = ["x", "y", "z"];
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
        let places = free.iter().flat_map(|station| [&station.top, &station.base]);
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

/// What was asked for (m/s): peaks of the motion given and of the incident wave, and the wave at the times of the rows.
#[derive(Default)]
struct Wave {
    given: [f64; 3],
    incident: [f64; 3],
    at_rows: [Vec<f64>; 3],
}

impl Wave {
    fn of(source: &Source, rows: &[f64]) -> Wave {
        let Some(Ok(table)) = &source.motion else { return Wave::default() };
        let time = table.column("time").unwrap_or(&[]);
        let velocity = |of: &str| AXES.map(|axis| table.column(&format!("{of}.v{axis}")).unwrap_or(&[]));
        let incident = velocity("incident");
        Wave {
            given: velocity("given").map(largest),
            incident: incident.map(largest),
            at_rows: incident.map(|values| interpolated(time, values, rows)),
        }
    }
}

/// A history at other times, linear between its own; not a number beyond them. Empty for an empty history.
fn interpolated(time: &[f64], values: &[f64], rows: &[f64]) -> Vec<f64> {
    let at = |&t: &f64| {
        let after = time.partition_point(|x| *x <= t);
        let (before, after) = (after.checked_sub(1)?, after.min(time.len() - 1));
        let step = time[after] - time[before];
        let part = if t == time[before] { 0.0 } else { (t - time[before]) / step };
        Some((1.0 - part) * values[before] + part * values[after])
    };
    if values.is_empty() { Vec::new() } else { rows.iter().map(|t| at(t).unwrap_or(f64::NAN)).collect() }
}

/// The column that is drawn, and why it is that one.
struct Drawn<'a> {
    column: Option<&'a Station>,
    why: String,
}

impl<'a> Drawn<'a> {
    /// The one farthest from theory; without theory the one farthest from the model.
    fn of(found: &'a FreeField, moving: &[usize]) -> Drawn<'a> {
        let model = found.model.as_ref();
        let farthest = |of: &dyn Fn(&Velocities, &Velocities, usize) -> Option<f64>| {
            let distance = |column: &'a Station| {
                let none = Velocities::default();
                let beside = model.map_or([&none; 2], |model| [&model.top, &model.base]);
                let places = [&column.top, &column.base].into_iter().zip(beside);
                let each = places
                    .flat_map(|(own, model)| moving.iter().filter_map(move |&axis| of(own, model, axis)));
                Some((column, each.reduce(f64::max)?))
            };
            // Of equal ones the first.
            found.columns.iter().filter_map(distance).reduce(|a, b| if b.1 > a.1 { b } else { a })
        };
        let theory = farthest(&|own, _, axis| apart(&own.measured[axis], &own.theory[axis]));
        let beside = || farthest(&|own, model, axis| apart(&own.measured[axis], &model.measured[axis]));
        let (column, from) = match theory {
            Some((column, _)) => (Some(column), "theory"),
            None => match beside() {
                Some((column, _)) => (Some(column), "the model"),
                None => (found.columns.first(), ""),
            },
        };
        let why = match (column, found.columns.len(), from) {
            (Some(column), 2.., "") => format!("Of the columns the first is drawn, {}.", column.name),
            (Some(column), n @ 2.., from) => {
                format!("Of the {n} columns the one farthest from {from} is drawn, {}.", column.name)
            }
            _ => String::new(),
        };
        Drawn { column, why }
    }
}

/// The largest finite size; not a number where there is none.
fn largest(values: &[f64]) -> f64 {
    values.iter().filter(|x| x.is_finite()).map(|x| x.abs()).reduce(f64::max).unwrap_or(f64::NAN)
}

/// How far two histories are apart at most, over the larger of their peaks; none where they have no row in common.
fn apart(a: &[f64], b: &[f64]) -> Option<f64> {
    let both = a.iter().zip(b).filter(|(a, b)| a.is_finite() && b.is_finite());
    let most = both.map(|(a, b)| (a - b).abs()).reduce(f64::max)?;
    let peak = largest(a).max(largest(b));
    Some(if most == 0.0 { 0.0 } else { most / peak })
}

/// A share in per cent.
fn percent(share: f64) -> String {
    format!("{}\u{a0}%", if share == 0.0 { "0".into() } else { figures(100.0 * share, 2) })
}

/// A surface and a base for each component that moves.
fn panels<'a>(
    found: &'a FreeField,
    wave: &'a Wave,
    drawn: &Drawn<'a>,
    (moving, scale): (&[usize], &Scale),
) -> Vec<Panel<'a>> {
    let mut panels = Vec::new();
    let places: [(&str, fn(&Station) -> &Velocities); 2] =
        [("surface", |station| &station.top), ("base", |station| &station.base)];
    for (place, of) in places {
        for &axis in moving {
            let line = |name: String, values: &'a [f64], colour, stroke| {
                values.iter().any(|x| x.is_finite()).then(|| Line {
                    name,
                    values: values.into(),
                    colour,
                    stroke,
                })
            };
            // In the order in which they are drawn: what may be hidden lies broad below what hides it.
            let mut lines = Vec::new();
            if let Some(column) = drawn.column {
                lines.push(line(
                    format!("{}, theory", column.name),
                    &of(column).theory[axis],
                    6,
                    Stroke::Broad,
                ));
            }
            lines.push(line("incident wave".into(), &wave.at_rows[axis], 2, Stroke::Thin));
            if let Some(column) = drawn.column {
                lines.push(line(
                    format!("{}, as it moved", column.name),
                    &of(column).measured[axis],
                    3,
                    Stroke::Thin,
                ));
            }
            if let Some(model) = &found.model {
                lines.push(line("model, as it moved".into(), &of(model).measured[axis], 1, Stroke::Dashed));
            }
            let lines: Vec<Line> = lines.into_iter().flatten().collect();
            if !lines.is_empty() {
                panels.push(Panel {
                    title: format!("{place}, velocity along {}", AXES[axis]),
                    scale: scale.clone(),
                    lines,
                    mark: Mark::Largest,
                });
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
    if let Some(column) = drawn.column {
        for (place, of) in [("surface", &column.top), ("base", &column.base)] {
            let (measured, theory) = (&of.measured[axis], &of.theory[axis]);
            if measured.is_empty() {
                continue;
            }
            let times = if place == "surface" && incident > 0.0 {
                format!(", {} times the incident wave", figures(largest(measured) / incident, 3))
            } else {
                String::new()
            };
            let beside = match apart(measured, theory) {
                Some(share) => {
                    format!(
                        " (theory {}; they differ by at most {} of the peak)",
                        speed(theory),
                        percent(share)
                    )
                }
                None => " (no theory)".into(),
            };
            parts.push(format!(
                "the {place} of column {} at {}{times}{beside}",
                column.name,
                speed(measured)
            ));
        }
    }
    if let Some(model) = &found.model {
        let none = Velocities::default();
        let beside = drawn.column.map_or([&none; 2], |column| [&column.top, &column.base]);
        for ((place, of), column) in [("surface", &model.top), ("base", &model.base)].into_iter().zip(beside)
        {
            let measured = &of.measured[axis];
            if measured.is_empty() {
                continue;
            }
            let beside = apart(measured, &column.measured[axis]).map_or(String::new(), |share| {
                format!(" (differing from the column's by at most {})", percent(share))
            });
            parts.push(format!("the model's own {place} at {}{beside}", speed(measured)));
        }
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
    let has_theory = |column: &Station| {
        [&column.top, &column.base].iter().any(|of| of.theory.iter().any(|v| !v.is_empty()))
    };
    let without: Vec<&str> =
        found.columns.iter().filter(|c| !has_theory(c)).map(|column| column.name.as_str()).collect();
    if !without.is_empty() {
        text.push_str(&format!(" The file holds no theory for {}.", without.join(", ")));
    }
    text
}

/// Peaks of all columns, and of the model, at surface and base.
fn table(found: &FreeField, drawn: &Drawn, moving: &[usize], scale: &Scale) -> TextTable {
    let over = vec![Head::words("").over(2), Head::number("surface").over(3), Head::number("base").over(3)];
    let mut head = vec![Head::words("column"), Head::words("along")];
    for _ in 0..2 {
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
            let places = [&station.top, &station.base];
            if places.iter().all(|of| of.measured[axis].is_empty() && of.theory[axis].is_empty()) {
                continue;
            }
            let mut row = vec![Cell::words(std::mem::take(&mut name)), Cell::words(AXES[axis])];
            let beside = drawn.column.filter(|_| is_model).map(|column| [&column.top, &column.base]);
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
