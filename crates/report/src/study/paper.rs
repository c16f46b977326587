//! Axes of a study's figures: one pair in a drawing, with what they show written beside them.

use tremolite_results::study::StudyColumn;

use crate::drawing::axes::Axes;
use crate::drawing::plot::{self, LEFT, Pen, PlotCurve, RIGHT, WIDTH};
use crate::drawing::svg::{Anchor, Style, Svg};
use crate::drawing::ticks::Ticks;
use crate::quantities::scale::Scale;

/// Height of the axes.
const HEIGHT: f64 = 320.0;
/// Dots of a curve that are drawn as rings, at most.
const RINGS: usize = 200;
/// Room below them.
const BELOW: f64 = 44.0;

/// A drawing of curves; `veil` lies under them.
pub fn draw(
    title: &str,
    (across, up): (&str, &str),
    (x, y): (Ticks, Ticks),
    curves: &[PlotCurve],
    veil: &[(f64, f64)],
    description: &str,
) -> String {
    let mut svg = Svg::new(WIDTH);
    let top = plot::title(&mut svg, (LEFT, 4.0), WIDTH - LEFT - RIGHT, title, curves) + 16.0;
    svg.text((LEFT - 46.0, top - 4.0), Anchor::Start, 12.0, Style::Muted, up);
    let axes = Axes {
        left: LEFT,
        right: WIDTH - RIGHT,
        top: top + 6.0,
        bottom: top + 6.0 + HEIGHT,
        across: x,
        up: y,
    };
    if veil.len() > 2 {
        svg.veil(&veil.iter().map(|(x, y)| axes.point(*x, *y)).collect::<Vec<_>>());
    }
    plot::draw(&mut svg, &axes, curves);
    // A few dots are seen better as rings.
    for curve in curves.iter().filter(|curve| curve.pen == Pen::Dots) {
        for (x, y) in curve
            .pieces
            .iter()
            .flatten()
            .filter(|_| curve.pieces.iter().map(Vec::len).sum::<usize>() <= RINGS)
        {
            svg.ring(axes.point(*x, *y), curve.colour);
        }
    }
    svg.text((axes.right, axes.bottom + 36.0), Anchor::End, 12.0, Style::Muted, across);
    svg.finish(axes.bottom + BELOW, title, description)
}

/// The unit that suits a column whose numbers go up to a size.
pub fn suiting(column: &StudyColumn, values: impl Iterator<Item = f64>) -> Scale {
    let largest = values.filter(|x| x.is_finite()).fold(0.0_f64, |most, x| most.max(x.abs()));
    Scale::suiting(column.unit.as_deref().unwrap_or_default(), largest)
}

/// An axis from zero to a little beyond the largest value.
pub fn from_zero(largest: f64) -> Ticks {
    let end = if largest > 0.0 && largest.is_finite() { 1.04 * largest } else { 1.0 };
    Ticks::within(0.0, end, 8)
}

/// A name as the part of a file's.
pub fn file_part(text: &str) -> String {
    let kept = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '-' };
    let raw: String = text.chars().map(kept).collect();
    raw.split('-').filter(|part| !part.is_empty()).collect::<Vec<_>>().join("-")
}

/// A number to four digits.
pub fn told(x: f64) -> String {
    let rounded: f64 = format!("{x:.3e}").parse().unwrap_or(x);
    let size = rounded.abs();
    if size == 0.0 || (1e-3..1e6).contains(&size) { format!("{rounded}") } else { format!("{rounded:e}") }
}

/// A number with its unit, if it has one.
pub fn measured(x: f64, unit: &str) -> String {
    if matches!(unit, "" | "1") { told(x) } else { format!("{} {unit}", told(x)) }
}
