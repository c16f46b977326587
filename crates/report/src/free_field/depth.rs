//! Peaks along depth: the free field by theory and as it moved, the model's edge beside it, and the monitors.

use tremolite_results::{Peaks, Summary, Table};

use crate::chapter::figure::{Block, Chapter, Figure, Section};
use crate::drawing::axes::Axes;
use crate::drawing::plot::{self, Pen, PlotCurve, RIGHT, WIDTH};
use crate::drawing::svg::{Anchor, Style, Svg};
use crate::drawing::ticks::Ticks;
use crate::language::say;
use crate::quantities::scale::Scale;
use crate::source::Source;

const AXES: [&str; 3] = ["x", "y", "z"];
/// A component this much smaller than the largest does not count as moving.
const IDLE: f64 = 1e-3;
/// Of a row of panels, and room left of each.
const HEIGHT: f64 = 190.0;
const LEFT: f64 = 46.0;
const APART: f64 = 12.0;

/// What is drawn beside each other.
struct DepthQuantity {
    title: String,
    unit: &'static str,
    /// Its columns along x, y and z.
    columns: [&'static str; 3],
    /// Whether it is a strain: of elements, between levels, which monitors do not have; nor do they know the base, from which
    /// displacements are counted.
    strain: bool,
    of_monitors: bool,
}

/// The section of the page; nothing where no earthquake came.
pub fn section(source: &Source) -> Option<Section> {
    let language = source.language;
    let heading = say!(language, "Peaks along depth");
    let table = match &source.depth {
        Some(Ok(table)) => table,
        Some(Err(why)) => return Some(Section::left_out(&heading, why)),
        None if source.motion.is_some() => {
            let why = say!(
                language,
                "The folder has no depth.csv: no column of ground stood beside the model, an older version ran, or the run has not \
                 ended."
            );
            return Some(Section::left_out(&heading, why));
        }
        None => return None,
    };
    let quantities = [
        DepthQuantity {
            title: say!(language, "acceleration"),
            unit: "m/s2",
            columns: ["ax", "ay", "az"],
            strain: false,
            of_monitors: true,
        },
        DepthQuantity {
            title: say!(language, "velocity"),
            unit: "m/s",
            columns: ["vx", "vy", "vz"],
            strain: false,
            of_monitors: true,
        },
        DepthQuantity {
            title: say!(language, "displacement from base"),
            unit: "m",
            columns: ["ux", "uy", "uz"],
            strain: false,
            of_monitors: false,
        },
        DepthQuantity {
            title: String::new(),
            unit: "1",
            columns: ["gxz", "gyz", "ezz"],
            strain: true,
            of_monitors: false,
        },
    ];
    let size = |axis: usize| peak(table.column(&format!("free_field.v{}", AXES[axis])).unwrap_or(&[]));
    let most = (0..3).map(size).fold(0.0, f64::max);
    let moving: Vec<usize> = (0..3).filter(|&axis| most > 0.0 && size(axis) > IDLE * most).collect();
    if moving.is_empty() {
        let why = say!(language, "depth.csv holds no motion.");
        return Some(Section::left_out(&heading, why));
    }
    let facts = source.facts();
    let figure = Figure {
        heading: String::new(),
        file: "depth.svg".into(),
        svg: draw(source, table, &quantities, &moving, &facts, &heading),
        caption: caption(source, table),
        curves: None,
        narrow: None,
    };
    let block = Block { figures: vec![figure], ..Block::default() };
    Some(Section::Told(Chapter { id: "depth", heading, blocks: vec![block] }))
}

fn peak(values: &[f64]) -> f64 {
    values.iter().copied().filter(|x| x.is_finite()).fold(0.0, f64::max)
}

fn caption(source: &Source, table: &Table) -> String {
    let language = source.language;
    let mut text = say!(
        language,
        "Largest sizes while the ground shook, over the depth below the top of the column of ground that stands nearest to the \
         monitors. Velocities, displacements and strains are those of all steps (strains of one element each, drawn at its middle), \
         accelerations those between rows. Where the model's edge leaves the column, its sides disturb the wave; where monitors lie \
         right of it, caverns and linings move more than the ground would."
    );
    if !table.columns.iter().any(|column| column.name.ends_with("_theory")) {
        text.push(' ');
        text.push_str(&say!(
            language,
            "No theory stands beside it: the ground of the column has yielded or cracked, or an interface runs through it."
        ));
    }
    text
}

/// A row of panels for each component, a panel for each quantity.
fn draw(
    source: &Source,
    table: &Table,
    quantities: &[DepthQuantity],
    moving: &[usize],
    facts: &Summary,
    title: &str,
) -> String {
    let language = source.language;
    let mut svg = Svg::new(WIDTH);
    let depth = table.column("depth").unwrap_or(&[]);
    let deepest = peak(depth);
    let names = [
        say!(language, "free field, theory"),
        say!(language, "free field"),
        say!(language, "edge of the model"),
        say!(language, "monitors"),
    ];
    let named = |curves: &mut Vec<PlotCurve>| {
        curves.retain(|curve| curve.pieces.iter().any(|piece| !piece.is_empty()))
    };
    let panel = |quantity: &DepthQuantity, axis: usize, scale: &Scale| -> Vec<PlotCurve> {
        let column = quantity.columns[axis];
        let line = |name: &str| {
            let values = table.column(name).unwrap_or(&[]);
            let at = |k: usize| match depth.get(k + 1) {
                Some(below) if quantity.strain => 0.5 * (depth[k] + below),
                _ => depth[k],
            };
            let known = values.iter().enumerate().filter(|(_, x)| x.is_finite());
            known.map(|(k, x)| (x * scale.factor, -at(k))).collect::<Vec<_>>()
        };
        let dots = if quantity.of_monitors { monitors(table, facts, column, scale) } else { Vec::new() };
        let mut curves = vec![
            PlotCurve::new(&names[2], 1, Pen::Curve, line(&format!("model.{column}"))),
            PlotCurve::new(&names[1], 0, Pen::Curve, line(&format!("free_field.{column}"))),
            PlotCurve::new(&names[0], 3, Pen::Dashed, line(&format!("free_field.{column}_theory"))),
            PlotCurve::new(&names[3], 4, Pen::Dots, dots),
        ];
        named(&mut curves);
        curves
    };
    let scale = |quantity: &DepthQuantity| {
        let of = |axis: &usize| {
            peak(table.column(&format!("free_field.{}", quantity.columns[*axis])).unwrap_or(&[]))
        };
        match quantity.strain {
            true => Scale { factor: 1e6, unit: "10⁻⁶".into() },
            false => source.units.suiting(quantity.unit, moving.iter().map(of).fold(0.0, f64::max)),
        }
    };
    let scales: Vec<Scale> = quantities.iter().map(scale).collect();
    let legend = panel(&quantities[0], moving[0], &scales[0]);
    let words = say!(language, "largest sizes over depth (m)");
    let mut top = plot::title(&mut svg, (LEFT, 0.0), WIDTH - LEFT - RIGHT, &words, &legend);
    let wide = (WIDTH - RIGHT + APART) / quantities.len() as f64;
    for &axis in moving {
        for (k, (quantity, scale)) in quantities.iter().zip(&scales).enumerate() {
            let mut curves = panel(quantity, axis, scale);
            curves.iter_mut().for_each(|curve| curve.name.clear());
            let heading = match (quantity.strain, axis) {
                (true, 2) => say!(language, "strain εzz"),
                (true, _) => say!(language, "shear strain γ{axis}z", axis = AXES[axis]),
                _ => say!(language, "{name}, {axis}", name = quantity.title, axis = AXES[axis]),
            };
            let left = LEFT + k as f64 * wide;
            svg.text((left, top + 16.0), Anchor::Start, 12.0, Style::Bold, &scale.labelled(&heading));
            let top = top + 24.0;
            let ((_, right), _) = plot::ranges(&curves);
            let axes = Axes {
                left,
                right: left + wide - LEFT - APART,
                top,
                bottom: top + HEIGHT,
                across: Ticks::within(0.0, 1.08 * right.max(0.0), 4),
                up: downwards(deepest),
            };
            plot::draw(&mut svg, &axes, &curves);
        }
        top += 24.0 + HEIGHT + 24.0;
    }
    svg.finish(top + 6.0, title, &words)
}

/// An axis of depths that points down: places are their negatives.
fn downwards(deepest: f64) -> Ticks {
    let Ticks { range, marks } = Ticks::within(0.0, deepest, 5);
    let marks = marks.into_iter().rev().map(|(depth, label)| (-depth, label)).collect();
    Ticks { range: (-range.1, 0.0), marks }
}

/// Peaks of the monitors at their depth below the column's top: of steps for what does not ring, else of rows.
fn monitors(table: &Table, facts: &Summary, quantity: &str, scale: &Scale) -> Vec<(f64, f64)> {
    let z = table.column("z").unwrap_or(&[]);
    let Some(top) = z.first() else { return Vec::new() };
    let size = |peaks: &Peaks| match (peaks.step_max, peaks.step_min) {
        (Some(most), Some(least)) if quantity.starts_with('v') => most.abs().max(least.abs()),
        _ => peaks.max.abs().max(peaks.min.abs()),
    };
    let dot = |(name, at): (&String, &[f64; 3])| {
        let peaks = facts.monitors.peaks.get(name)?.get(quantity)?;
        Some((size(peaks) * scale.factor, at[2] - top))
    };
    facts.monitors.monitor_positions.iter().filter_map(dot).collect()
}
