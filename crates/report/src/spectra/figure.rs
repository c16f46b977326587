//! Figures of response spectra: rows of axes side by side, all on one scale.

use tremolite_results::Table;

use crate::chapter::figure::Figure;
use crate::drawing::axes::Axes;
use crate::drawing::period_axis::{axis, place};
use crate::drawing::plot::{self, NARROW, Pen, PlotCurve, RIGHT, WIDTH};
use crate::drawing::svg::{Anchor, Style, Svg};
use crate::drawing::ticks::Ticks;
use crate::language::{Language, say};
use crate::quantities::scale::Scale;
use crate::quantities::units::Kind;
use crate::script::curves::Curves;
use crate::script::plot_curves::{self, Plot};
use crate::source::Source;

pub const AXES: [&str; 3] = ["x", "y", "z"];
/// A component this much smaller than the largest does not count as moving.
const IDLE: f64 = 1e-3;
const HEIGHT: f64 = 128.0;
/// Room left of each pair of axes for its numbers, and between neighbours.
const LEFT: f64 = 46.0;
const APART: f64 = 10.0;

/// What is drawn: the columns of a point.
pub struct SpectrumPlace<'a> {
    pub name: String,
    /// Along x, y and z; empty where the file has none.
    pub spectrum: [&'a [f64]; 3],
}

impl<'a> SpectrumPlace<'a> {
    pub fn of(table: &'a Table, name: &str) -> SpectrumPlace<'a> {
        let along = |axis: &str| table.column(&format!("{name}.a{axis}")).unwrap_or(&[]);
        SpectrumPlace { name: name.into(), spectrum: AXES.map(along) }
    }

    pub fn is_known(&self) -> bool {
        self.spectrum.iter().any(|s| s.iter().any(|x| x.is_finite()))
    }

    /// The largest value of any component; 0 without one.
    pub fn largest(&self) -> f64 {
        (0..3).map(|axis| largest(&[self], axis)).fold(0.0, f64::max)
    }

    /// Period (s), from one on, and value of the largest of a component.
    pub fn peak(&self, periods: &[f64], axis: usize, shortest: f64) -> Option<(f64, f64)> {
        let values = periods.iter().copied().zip(self.spectrum[axis].iter().copied());
        values
            .filter(|(period, x)| x.is_finite() && *period >= shortest)
            .reduce(|most, next| if next.1 > most.1 { next } else { most })
    }
}

/// A spectrum that is drawn, under the name it has in the legend.
pub struct DrawnSpectra<'a> {
    pub name: String,
    pub point: &'a SpectrumPlace<'a>,
    pub colour: usize,
    pub pen: Pen,
    /// Periods (s) of its own; nothing: those of the file.
    pub periods: Option<&'a [f64]>,
}

/// Spectra of one pair of axes, or of several components.
pub struct SpectraRow<'a> {
    /// Before the component in the heading; empty for none.
    pub name: &'a str,
    pub drawn: Vec<DrawnSpectra<'a>>,
}

fn largest(points: &[&SpectrumPlace], axis: usize) -> f64 {
    let values = points.iter().flat_map(|point| point.spectrum[axis]).copied();
    values.filter(|x| x.is_finite()).fold(0.0, f64::max)
}

/// The components that move.
pub fn moving(points: &[&SpectrumPlace]) -> Vec<usize> {
    let sizes = [0, 1, 2].map(|axis| largest(points, axis));
    let most = sizes.into_iter().fold(0.0, f64::max);
    (0..3).filter(|&axis| most > 0.0 && sizes[axis] > IDLE * most).collect()
}

/// Rows of spectra by component, all over the same periods and on the same scale; without heading and caption.
pub fn figure(
    rows: &[SpectraRow],
    axes_of: &[usize],
    periods: &[f64],
    title: &str,
    file: String,
    source: &Source,
) -> Figure {
    let language = source.language;
    let all: Vec<&SpectrumPlace> =
        rows.iter().flat_map(|row| row.drawn.iter().map(|drawn| drawn.point)).collect();
    let most = axes_of.iter().map(|&axis| largest(&all, axis)).fold(0.0, f64::max);
    let scale = source.scale(Kind::Acceleration);
    let (low, high) = plot::range(periods.iter().copied());
    let words = scale.labelled(&say!(language, "spectral acceleration, 5 % damping"));
    let cells: Vec<SpectrumAxes> = rows
        .iter()
        .flat_map(|row| axes_of.iter().map(move |&axis| (row, axis)))
        .map(|(row, axis)| SpectrumAxes {
            heading: heading(row, axis, language),
            curves: curves(row, axis, periods, &scale),
        })
        .collect();
    let sheet = SpectraDrawing {
        // Where one component moves, monitors stand beside each other.
        abreast: if axes_of.len() > 1 { axes_of.len() } else { rows.len().clamp(1, 3) },
        cells,
        across: axis(low, high),
        up: Ticks::within(0.0, 1.06 * most * scale.factor, 4),
        unit: scale.unit,
        words,
        period: say!(language, "period"),
    };
    let [svg, narrow] = [(WIDTH, sheet.abreast), (NARROW, 1)].map(|size| sheet.draw(title, size));
    Figure {
        heading: String::new(),
        file,
        svg,
        caption: String::new(),
        curves: Some(sheet.curves(title)),
        narrow: Some(narrow),
    }
}

/// One pair of axes.
struct SpectrumAxes {
    heading: String,
    /// Over periods (s).
    curves: Vec<PlotCurve>,
}

/// What a figure is made of.
struct SpectraDrawing {
    cells: Vec<SpectrumAxes>,
    abreast: usize,
    across: Ticks,
    up: Ticks,
    unit: String,
    /// What is drawn, with the unit.
    words: String,
    /// What it is drawn over.
    period: String,
}

impl SpectraDrawing {
    /// So wide, with so many pairs of axes abreast.
    fn draw(&self, title: &str, (width, abreast): (f64, usize)) -> String {
        let mut svg = Svg::new(width);
        let wide = (width - RIGHT + APART) / abreast as f64;
        let legend = self.cells.first().map_or(&[][..], |cell| &cell.curves);
        let mut top = plot::title(&mut svg, (LEFT, 0.0), width - LEFT - RIGHT, &self.words, legend);
        for line in self.cells.chunks(abreast) {
            for (k, cell) in line.iter().enumerate() {
                let mut drawn = cell.curves.clone();
                for curve in &mut drawn {
                    curve.name.clear();
                    curve.pieces.iter_mut().flatten().for_each(|point| point.0 = place(point.0));
                }
                let left = LEFT + k as f64 * wide;
                svg.text((left, top + 16.0), Anchor::Start, 12.5, Style::Bold, &cell.heading);
                let top = top + 24.0;
                let axes = Axes {
                    left,
                    right: left + wide - LEFT - APART,
                    top,
                    bottom: top + HEIGHT,
                    across: self.across.clone(),
                    up: self.up.clone(),
                };
                plot::draw(&mut svg, &axes, &drawn);
            }
            top += 24.0 + HEIGHT + 24.0;
        }
        let below = format!("{} (s)", self.period);
        svg.text((width - RIGHT, top + 8.0), Anchor::End, 12.0, Style::Muted, &below);
        svg.finish(top + 16.0, title, &self.words)
    }

    fn curves(&self, title: &str) -> Curves {
        let plots = self.cells.iter().map(|cell| Plot {
            title: cell.heading.clone(),
            unit: self.unit.clone(),
            log: false,
            ends: Some(self.up.range.into()),
            curves: &cell.curves,
        });
        let mut curves = plot_curves::curves(title, &self.period, "s", &plots.collect::<Vec<_>>());
        curves.across.log = true;
        curves.heading.clone_from(&self.words);
        curves.abreast = self.abreast;
        curves
    }
}

fn heading(row: &SpectraRow, axis: usize, language: Language) -> String {
    match row.name {
        "" => say!(language, "along {axis}", axis = AXES[axis]),
        name => say!(language, "{name}, along {axis}", name = name, axis = AXES[axis]),
    }
}

fn curves(row: &SpectraRow, axis: usize, periods: &[f64], scale: &Scale) -> Vec<PlotCurve> {
    let curve = |drawn: &DrawnSpectra| {
        let points = drawn.periods.unwrap_or(periods).iter().zip(drawn.point.spectrum[axis]);
        let points = points.map(|(period, value)| (*period, value * scale.factor)).collect();
        PlotCurve::new(drawn.name.clone(), drawn.colour, drawn.pen, points)
    };
    // Nothing is drawn of what has no such component.
    let known = |drawn: &&DrawnSpectra| !drawn.point.spectrum[axis].is_empty();
    row.drawn.iter().filter(known).map(curve).collect()
}
