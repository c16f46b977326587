//! Axes with lines and dots in display units, for figures whose abscissa is not time.

use crate::drawing::axes::{Axes, drawable};
use crate::drawing::svg::{Anchor, LINES, Style, Svg, text_width};
use crate::drawing::ticks::Ticks;

/// Width of a figure.
pub const WIDTH: f64 = 940.0;
/// Width of one that stands beside another on a sheet of paper: shrunk to half of it, its texts have 2.3 mm.
pub const NARROW: f64 = 470.0;
/// Room left of the axes for their numbers.
pub const LEFT: f64 = 64.0;
pub const RIGHT: f64 = 16.0;
/// Height of a row of a legend.
const ROW: f64 = 19.0;

/// How a curve is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pen {
    Curve,
    /// A line of many that lie close.
    Thin,
    Dashed,
    Dotted,
    /// A line with its points.
    Marked,
    Dots,
}

/// What is drawn under one name; values in the units of the axes.
#[derive(Clone, Debug, PartialEq)]
pub struct PlotCurve {
    pub name: String,
    pub colour: usize,
    pub pen: Pen,
    /// Lines; what is not a number breaks them.
    pub pieces: Vec<Vec<(f64, f64)>>,
}

impl PlotCurve {
    pub fn new(name: impl Into<String>, colour: usize, pen: Pen, points: Vec<(f64, f64)>) -> Self {
        PlotCurve { name: name.into(), colour, pen, pieces: vec![points] }
    }

    fn values(&self) -> impl Iterator<Item = (f64, f64)> {
        self.pieces.iter().flatten().copied().filter(|(x, y)| drawable(*x) && drawable(*y))
    }
}

/// Smallest and largest of values that can be drawn; turned round where there is none.
pub fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let drawn = values.filter(|x| drawable(*x));
    drawn.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)))
}

/// The ends of what curves show, along the two axes.
pub fn ranges(curves: &[PlotCurve]) -> ((f64, f64), (f64, f64)) {
    let all = || curves.iter().flat_map(PlotCurve::values);
    (range(all().map(|p| p.0)), range(all().map(|p| p.1)))
}

/// A bold title above axes, and below it the names of the curves; returns where the axes may begin.
pub fn title(svg: &mut Svg, (left, top): (f64, f64), width: f64, title: &str, curves: &[PlotCurve]) -> f64 {
    svg.text((left, top + 14.0), Anchor::Start, 13.0, Style::Bold, title);
    // Without a title the names begin where it would stand.
    let (mut x, mut y) = (left, top + if title.is_empty() { 14.0 - ROW } else { 14.0 });
    let mut named: Vec<&str> = Vec::new();
    for curve in curves.iter().filter(|curve| !curve.name.is_empty()) {
        if named.contains(&curve.name.as_str()) {
            continue;
        }
        named.push(&curve.name);
        // A name that is longer than the figure is wide is set smaller.
        let size = 12.0 * ((width - 25.0) / text_width(&curve.name, 12.0)).min(1.0);
        let wide = 25.0 + text_width(&curve.name, size) + 14.0;
        if named.len() == 1 || x + wide > left + width {
            (x, y) = (left, y + ROW);
        }
        if curve.pen != Pen::Dots {
            stroke(svg, curve, 2.4, &[vec![(x, y - 4.5), (x + 20.0, y - 4.5)]]);
        }
        if matches!(curve.pen, Pen::Dots | Pen::Marked) {
            svg.dots(curve.colour, &[(x + 10.0, y - 4.5)]);
        }
        svg.text((x + 25.0, y), Anchor::Start, size, Style::Plain, &curve.name);
        x += wide;
    }
    y + 10.0
}

/// Axes with curves. The numbers below are drawn as well.
pub fn draw(svg: &mut Svg, axes: &Axes, curves: &[PlotCurve]) {
    axes.draw(svg);
    axes.number_across(svg);
    for curve in curves {
        let place = |piece: &Vec<(f64, f64)>| -> Vec<Vec<(f64, f64)>> {
            let broken = piece.split(|(x, y)| !(drawable(*x) && drawable(*y)));
            let whole = broken.filter(|part| !part.is_empty());
            whole.map(|part| part.iter().map(|(x, y)| axes.point(*x, *y)).collect()).collect()
        };
        let placed: Vec<Vec<(f64, f64)>> = curve.pieces.iter().flat_map(place).collect();
        if curve.pen != Pen::Dots {
            stroke(svg, curve, if curve.pen == Pen::Thin { 0.8 } else { 1.5 }, &placed);
        }
        if matches!(curve.pen, Pen::Dots | Pen::Marked) {
            svg.dots(curve.colour, &placed.concat());
        }
    }
}

fn stroke(svg: &mut Svg, curve: &PlotCurve, width: f64, lines: &[Vec<(f64, f64)>]) {
    let dashes = match curve.pen {
        Pen::Dashed => 1,
        Pen::Dotted => 2,
        _ => 0,
    };
    svg.lines(curve.colour % LINES.len() + dashes * LINES.len(), width, lines);
}

/// An axis of stages: their names where there is room for all, else their numbers.
pub fn stages(names: &[&str], width: f64) -> Ticks {
    let room = width / names.len().max(1) as f64 - 10.0;
    let fits = names.iter().all(|name| text_width(name, 12.0) <= room);
    let label = |k: usize| if fits { names[k].to_owned() } else { k.to_string() };
    let label = |k: usize| if names[k].is_empty() { k.to_string() } else { label(k) };
    Ticks {
        range: (-0.5, names.len() as f64 - 0.5),
        marks: (0..names.len()).map(|k| (k as f64, label(k))).collect(),
    }
}
