//! The figure of a law driven along a path: loops in planes such as stress over strain, and what was kept, over time.

use std::borrow::Cow;

use crate::drawing::axes::{Axes, drawable};
use crate::drawing::state_strips::{self, Strip};
use crate::drawing::svg::{Anchor, Style, Svg, text_width};
use crate::drawing::thinning::thin;
use crate::drawing::ticks::Ticks;
use crate::quantities::scale::Scale;

const WIDTH: f64 = 940.0;
const LEFT: f64 = 56.0;
const RIGHT: f64 = 16.0;
/// Room above axes for a heading and its legend.
const HEADING: f64 = 32.0;
/// Room below a plane for its numbers, its axis and two remarks.
const BELOW: f64 = 62.0;

/// What an axis shows.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// Its name, `stress`.
    pub name: String,
    /// SI unit; empty for a pure number.
    pub unit: String,
    /// The unit that it is shown in where that does not go by its own size.
    shown_in: Option<Scale>,
}

impl Quantity {
    pub fn new(name: impl Into<String>, unit: impl Into<String>) -> Self {
        Quantity { name: name.into(), unit: unit.into(), shown_in: None }
    }

    /// The same in a unit that others share.
    pub(crate) fn shown_in(self, scale: Scale) -> Self {
        Quantity { shown_in: Some(scale), ..self }
    }

    fn scale<'a>(&self, values: impl Iterator<Item = &'a f64>) -> Scale {
        self.shown_in.clone().unwrap_or_else(|| {
            let sizes = values.filter(|x| drawable(**x)).map(|x| x.abs());
            Scale::suiting(&self.unit, sizes.fold(0.0, f64::max))
        })
    }
}

/// One line of a plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve<'a> {
    pub name: String,
    /// Which colour; lines of one thing should have the same all over the figure.
    pub colour: usize,
    /// In SI. What is not a number breaks the line.
    pub across: Cow<'a, [f64]>,
    /// In SI, as many.
    pub up: Cow<'a, [f64]>,
    /// Whether these are points of their own, as of tests, rather than a line.
    pub points: bool,
}

/// Which points of a plane are named below it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Named {
    HighestAndLowest,
    /// Where what lies further down is left out.
    Highest,
    Nothing,
}

/// One quantity over another.
#[derive(Clone, Debug, PartialEq)]
pub struct Plane<'a> {
    pub across: Quantity,
    pub up: Quantity,
    pub curves: Vec<Curve<'a>>,
    pub named: Named,
}

/// One line of a track.
#[derive(Clone, Debug, PartialEq)]
pub struct Course<'a> {
    pub name: String,
    /// Which colour.
    pub colour: usize,
    /// In SI, one for each time.
    pub values: &'a [f64],
}

/// A quantity over time.
#[derive(Clone, Debug, PartialEq)]
pub struct Track<'a> {
    pub quantity: Quantity,
    pub courses: Vec<Course<'a>>,
}

/// Planes side by side, and tracks below them over one axis of time.
#[derive(Clone, Debug, PartialEq)]
pub struct Loops<'a> {
    pub title: String,
    /// What the tracks run over: time, or steps where time stands still.
    pub along: Quantity,
    /// Not falling.
    pub time: &'a [f64],
    /// Two at most have room.
    pub planes: Vec<Plane<'a>>,
    pub tracks: Vec<Track<'a>>,
    /// States that hold or do not, under a name; drawn below the tracks.
    pub states: Option<(String, Vec<Strip>)>,
}

impl Loops<'_> {
    /// The figure as SVG.
    pub fn draw(&self) -> String {
        let mut svg = Svg::new(WIDTH);
        svg.text((LEFT, 16.0), Anchor::Start, 14.0, Style::Bold, &self.title);
        let mut top = 22.0;
        let mut remarks = Vec::new();
        let columns = self.planes.len().max(1) as f64;
        let width = (WIDTH - columns * (LEFT + RIGHT)) / columns;
        let height = if self.planes.len() > 1 { 300.0 } else { 340.0 };
        for (k, plane) in self.planes.iter().enumerate() {
            let left = LEFT + k as f64 * (LEFT + width + RIGHT);
            remarks.extend(plane.draw(&mut svg, (left, top + HEADING), (width, height)));
        }
        if !self.planes.is_empty() {
            top += HEADING + height + BELOW;
        }
        let finite = || self.time.iter().copied().filter(|t| drawable(*t));
        let ends = (finite().fold(f64::INFINITY, f64::min), finite().fold(f64::NEG_INFINITY, f64::max));
        let along = self.along.scale(self.time.iter());
        let across = Ticks::within(ends.0 * along.factor, ends.1 * along.factor, 10);
        let over = (&across, self.time, along.factor);
        let mut lowest = None;
        for track in &self.tracks {
            let axes = track.draw(&mut svg, over, top + HEADING);
            top = axes.bottom;
            lowest = Some(axes);
        }
        if let Some((name, strips)) = &self.states {
            top += HEADING;
            heading(
                &mut svg,
                (LEFT, top - 9.0),
                f64::INFINITY,
                name,
                strips.iter().map(|s| (s.name.as_str(), s.colour, false)),
            );
            let axes = state_strips::draw(&mut svg, strips, over, (LEFT, WIDTH - RIGHT, top));
            top = axes.bottom;
            lowest = Some(axes);
        }
        if let Some(axes) = lowest {
            axes.number_across(&mut svg);
            let label = along.labelled(&self.along.name);
            svg.text((WIDTH - RIGHT, top + 34.0), Anchor::End, 12.0, Style::Muted, &label);
            top += 42.0;
        }
        svg.finish(top, &self.title, &remarks.join("; "))
    }
}

impl Plane<'_> {
    /// Draws the plane with its axes' upper left corner at `from`; returns the remarks on it.
    fn draw(&self, svg: &mut Svg, from: (f64, f64), size: (f64, f64)) -> Vec<String> {
        let ((left, top), (right, bottom)) = (from, (from.0 + size.0, from.1 + size.1));
        let x = self.across.scale(self.curves.iter().flat_map(|c| c.across.iter()));
        let y = self.up.scale(self.curves.iter().flat_map(|c| c.up.iter()));
        let ticks = |(low, high): (f64, f64), factor: f64, room: f64| {
            Ticks::around(low * factor, high * factor, (room / 60.0) as usize)
        };
        let across = ticks(range(self.curves.iter().flat_map(|c| c.across.iter())), x.factor, size.0);
        let up = ticks(range(self.curves.iter().flat_map(|c| c.up.iter())), y.factor, size.1);
        let axes = Axes { left, right, top, bottom, across, up };
        axes.draw(svg);
        axes.number_across(svg);
        let names = self.curves.iter().map(|c| (c.name.as_str(), c.colour, c.points));
        let over = heading(svg, (left, top - 9.0), right + RIGHT, &y.labelled(&self.up.name), names);
        let label = x.labelled(&self.across.name);
        svg.text((right, bottom + 34.0), Anchor::End, 12.0, Style::Muted, &label);
        let beside = right - text_width(&label, 12.0) - 14.0;
        let over = legend(svg, (left, bottom + 34.0), beside, over.into_iter());
        legend(svg, (left, bottom + 51.0), f64::INFINITY, over.into_iter());
        for curve in &self.curves {
            let points =
                curve.across.iter().zip(curve.up.iter()).map(|(a, b)| axes.point(a * x.factor, b * y.factor));
            if curve.points {
                points
                    .filter(|(x, y)| drawable(*x) && drawable(*y))
                    .for_each(|at| svg.ring(at, curve.colour));
            } else {
                svg.lines(curve.colour, 1.5, &spaced(points));
            }
        }
        let mut remarks = Vec::new();
        let wanted = match self.named {
            Named::HighestAndLowest => &[("highest", 1.0), ("lowest", -1.0)][..],
            Named::Highest => &[("highest", 1.0)],
            Named::Nothing => &[],
        };
        for &(word, sign) in wanted {
            if let Some((curve, across, up)) = self.extreme(sign) {
                svg.ring(axes.point(across * x.factor, up * y.factor), curve.colour);
                let (up, across) = (y.quantity(up), with_power(&x, across));
                let remark = format!("{word} {}: {}, {up} at {across}", self.up.name, curve.name);
                let line = 34.0 + 17.0 * remarks.len() as f64;
                let words = format!("{word}: {}, {up} at {across}", curve.name);
                svg.text((left, bottom + line), Anchor::Start, 12.0, Style::Muted, &words);
                remarks.push(remark);
            }
        }
        remarks
    }

    /// The first point that lies highest (`sign` 1) or lowest (−1), if it lies on that side of zero at all.
    fn extreme(&self, sign: f64) -> Option<(&Curve<'_>, f64, f64)> {
        let mut best: Option<(&Curve<'_>, f64, f64)> = None;
        let largest = self.curves.iter().flat_map(|c| c.up.iter()).filter(|x| drawable(**x));
        let noise = 1e-6 * largest.fold(0.0, |most, x| f64::max(most, x.abs()));
        for curve in &self.curves {
            for (&x, &y) in
                curve.across.iter().zip(curve.up.iter()).filter(|(x, y)| drawable(**x) && drawable(**y))
            {
                // Round-off along a plateau makes no new extreme.
                if sign * y > best.as_ref().map_or(0.0, |b| sign * b.2) + noise {
                    best = Some((curve, x, y));
                }
            }
        }
        best
    }
}

impl Track<'_> {
    fn draw(&self, svg: &mut Svg, (across, time, factor): (&Ticks, &[f64], f64), top: f64) -> Axes {
        let scale = self.quantity.scale(self.courses.iter().flat_map(|c| c.values));
        let (low, high) = range(self.courses.iter().flat_map(|c| c.values));
        let up = Ticks::around(low * scale.factor, high * scale.factor, 3);
        let axes =
            Axes { left: LEFT, right: WIDTH - RIGHT, top, bottom: top + 104.0, across: across.clone(), up };
        axes.draw(svg);
        let names = self.courses.iter().map(|c| (c.name.as_str(), c.colour, false));
        heading(svg, (LEFT, top - 9.0), f64::INFINITY, &scale.labelled(&self.quantity.name), names);
        for course in &self.courses {
            let shown = |x: f64| if drawable(x) { x } else { f64::NAN };
            let points = time.iter().zip(course.values);
            let points = points.map(|(&t, &x)| axes.point(shown(t) * factor, shown(x) * scale.factor));
            svg.lines(course.colour, 1.5, &thin(points, 0.12));
        }
        axes
    }
}

/// A name of a legend, its colour, and whether it is of points.
type LegendEntry<'a> = (&'a str, usize, bool);

/// A bold title, and behind it the names of the lines in their colours, but for one that the title already names; of
/// points where the third value says so. Those that find no room before `right` come back.
fn heading<'a>(
    svg: &mut Svg,
    at: (f64, f64),
    right: f64,
    title: &str,
    names: impl Iterator<Item = LegendEntry<'a>>,
) -> Vec<LegendEntry<'a>> {
    svg.text(at, Anchor::Start, 13.0, Style::Bold, title);
    let named =
        |name: &str| title.strip_prefix(name).is_some_and(|unit| unit.is_empty() || unit.starts_with(" ("));
    let start = (at.0 + text_width(title, 13.0) + 24.0, at.1);
    legend(svg, start, right, names.filter(|(name, ..)| !named(name)))
}

/// Names in their colours, one behind the other. Those that find no room before `right` come back.
fn legend<'a>(
    svg: &mut Svg,
    at: (f64, f64),
    right: f64,
    names: impl Iterator<Item = LegendEntry<'a>>,
) -> Vec<LegendEntry<'a>> {
    let mut x = at.0;
    let mut over = Vec::new();
    for (name, colour, points) in names {
        let width = 23.0 + text_width(name, 12.0);
        if x + width > right || !over.is_empty() {
            over.push((name, colour, points));
            continue;
        }
        if points {
            svg.ring((x + 9.0, at.1 - 4.5), colour);
        } else {
            svg.lines(colour, 2.4, &[vec![(x, at.1 - 4.5), (x + 18.0, at.1 - 4.5)]]);
        }
        svg.text((x + 23.0, at.1), Anchor::Start, 12.0, Style::Plain, name);
        x += width + 14.0;
    }
    over
}

/// A value in a unit, with a sign of multiplication before a bare power of ten.
fn with_power(scale: &Scale, value: f64) -> String {
    if scale.unit.starts_with("10") {
        format!("{}\u{202f}×\u{202f}{}", scale.number(value), scale.unit)
    } else {
        scale.quantity(value)
    }
}

fn range<'a>(values: impl Iterator<Item = &'a f64>) -> (f64, f64) {
    let drawable = values.filter(|x| drawable(**x));
    drawable.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &x| (low.min(x), high.max(x)))
}

/// The polylines through points that turn any way, without those closer to the last one kept than the pen shows.
/// Points that cannot be drawn break the line.
fn spaced(points: impl Iterator<Item = (f64, f64)>) -> Vec<Vec<(f64, f64)>> {
    let mut lines: Vec<Vec<(f64, f64)>> = vec![Vec::new()];
    let mut skipped = None;
    for (x, y) in points {
        let Some(line) = lines.last_mut() else { break };
        if !(drawable(x) && drawable(y)) {
            line.extend(skipped.take());
            lines.push(Vec::new());
            continue;
        }
        match line.last() {
            Some((a, b)) if (x - a).hypot(y - b) < 0.3 => skipped = Some((x, y)),
            _ => {
                skipped = None;
                line.push((x, y));
            }
        }
    }
    if let Some(line) = lines.last_mut() {
        line.extend(skipped);
    }
    lines.retain(|line| !line.is_empty());
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_loop_keeps_its_turning_points() {
        let there_and_back =
            (0..=1000).chain((0..1000).rev()).map(|i| (f64::from(i) * 0.1, f64::from(i) * 0.05));
        let lines = spaced(there_and_back);
        assert_eq!(lines.len(), 1);
        let furthest = lines[0].iter().map(|p| p.0).fold(0.0, f64::max);
        assert!(lines[0].len() < 1000 && (furthest - 100.0).abs() < 0.3, "{furthest}");
        assert_eq!(lines[0].last(), Some(&(0.0, 0.0)));
    }

    #[test]
    fn points_that_are_not_finite_break_a_loop() {
        let points =
            [(0.0, 0.0), (1.0, f64::NAN), (2.0, 0.0), (2.1, 0.0), (f64::INFINITY, 0.0), (9.0, 1e200)];
        assert_eq!(spaced(points.into_iter()), [vec![(0.0, 0.0)], vec![(2.0, 0.0), (2.1, 0.0)]]);
    }
}
