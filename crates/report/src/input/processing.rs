//! The figure of a record before and after its processing: histories above one another, response spectra below them.

use crate::drawing::axes::{Axes, drawable};
use crate::drawing::period_axis::{axis, place};
use crate::drawing::plot::range;
use crate::drawing::svg::{Anchor, Style, Svg, text_width};
use crate::drawing::thinning::thin;
use crate::drawing::ticks::Ticks;
use crate::quantities::scale::{Scale, moment};

const WIDTH: f64 = 940.0;
const LEFT: f64 = 64.0;
const RIGHT: f64 = 16.0;
/// Room above axes for their heading.
const HEADING: f64 = 34.0;
const HISTORY: f64 = 132.0;
const SPECTRUM: f64 = 210.0;
/// Colour of what came of the processing.
const AFTER: usize = 0;
/// Colour of a target.
const TARGET: usize = 1;
/// What was before is shown up to this many times the extent of what came after, beyond both its ends. A drift is so seen to leave
/// the axes and does not flatten what is left without it.
const BEYOND: f64 = 2.0;

/// One quantity before and after, in SI and of equal length.
#[derive(Clone, Debug, PartialEq)]
pub struct Pair<'a> {
    /// Its name, `velocity`.
    pub name: &'a str,
    /// SI unit; `counts` where nothing better is known.
    pub unit: &'a str,
    pub before: &'a [f64],
    pub after: &'a [f64],
}

/// A record before and after.
#[derive(Clone, Debug, PartialEq)]
pub struct BeforeAfter<'a> {
    pub title: String,
    /// What was done, in words.
    pub steps: String,
    /// What was before, for the legend.
    pub before: &'a str,
    /// Times of the histories (s), ascending.
    pub time: &'a [f64],
    pub histories: Vec<Pair<'a>>,
    /// Periods (s), ascending and above zero, and the pseudo-acceleration at them for 5 % damping, if there is one.
    pub spectrum: Option<(&'a [f64], Pair<'a>)>,
    /// What the spectrum is to be, where there is such: its name, and the values at the same periods, not a number where it says
    /// nothing.
    pub target: Option<(&'a str, &'a [f64])>,
}

impl BeforeAfter<'_> {
    /// The figure as SVG. Largest values are ringed and named.
    pub fn draw(&self) -> String {
        let mut svg = Svg::new(WIDTH);
        svg.text((LEFT, 18.0), Anchor::Start, 14.0, Style::Bold, &self.title);
        let mut top = 18.0;
        for line in wrapped(&self.steps, WIDTH - LEFT - RIGHT) {
            top += 18.0;
            svg.text((LEFT, top), Anchor::Start, 12.0, Style::Muted, &line);
        }
        top += 20.0;
        svg.before(&[vec![(LEFT, top - 4.5), (LEFT + 22.0, top - 4.5)]]);
        svg.text((LEFT + 28.0, top), Anchor::Start, 13.0, Style::Plain, self.before);
        let next = LEFT + 28.0 + text_width(self.before, 13.0) + 24.0;
        svg.lines(AFTER, 2.0, &[vec![(next, top - 4.5), (next + 22.0, top - 4.5)]]);
        svg.text((next + 28.0, top), Anchor::Start, 13.0, Style::Plain, "after");
        if let Some((name, _)) = self.target {
            let next = next + 28.0 + text_width("after", 13.0) + 24.0;
            svg.lines(TARGET, 2.0, &[vec![(next, top - 4.5), (next + 22.0, top - 4.5)]]);
            svg.text((next + 28.0, top), Anchor::Start, 13.0, Style::Plain, &format!("target: {name}"));
        }
        let mut remarks = Vec::new();

        let (from, to) = range(self.time.iter().copied());
        let duration = self.time.last().copied().unwrap_or(f64::NAN);
        let last = self.histories.len().saturating_sub(1);
        for (k, pair) in self.histories.iter().enumerate() {
            let panel = ProcessingPanel {
                pair,
                numbered: k == last,
                across: Ticks::within(from, to, 10),
                places: self.time.to_vec(),
                at: &|time| format!("{}\u{a0}s", moment(time, duration)),
                up: pair.ticks(4),
                height: HISTORY,
                target: None,
            };
            let (bottom, remark) = panel.draw(&mut svg, top);
            remarks.push(remark);
            top = bottom;
        }
        if !self.histories.is_empty() {
            top = below(&mut svg, top, "time (s)");
        }
        if let Some((periods, pair)) = &self.spectrum {
            let (low, high) = range(periods.iter().copied());
            let (_, most) = range(pair.before.iter().chain(pair.after).copied());
            let panel = ProcessingPanel {
                pair,
                numbered: true,
                across: axis(low, high),
                places: periods.iter().map(|period| place(*period)).collect(),
                at: &|place| {
                    format!("{}\u{a0}s", crate::quantities::scale::figures(1e-3 * 10_f64.powf(place), 2))
                },
                up: Ticks::within(0.0, 1.06 * most * pair.scale().factor, 5),
                height: SPECTRUM,
                target: self.target.map(|(_, values)| values),
            };
            let (bottom, remark) = panel.draw(&mut svg, top);
            remarks.push(remark);
            top = below(&mut svg, bottom, "period (s)");
        }
        svg.finish(top, &self.title, &remarks.join("; "))
    }
}

/// The words below an axis; returns where the next thing may begin.
fn below(svg: &mut Svg, bottom: f64, words: &str) -> f64 {
    svg.text((WIDTH - RIGHT, bottom + 34.0), Anchor::End, 12.0, Style::Muted, words);
    bottom + 44.0
}

impl Pair<'_> {
    /// A unit that suits what came after, or both where nothing did.
    fn scale(&self) -> Scale {
        let (most, other) = (largest(self.after), largest(self.before));
        let size = if most.1 == 0.0 { other.1 } else { most.1 };
        Scale::suiting(self.unit, size.abs())
    }

    /// The upright axis: all of what came after, and so much of what was before as lets that be seen.
    fn ticks(&self, wanted: usize) -> Ticks {
        let (low, high) = range(self.after.iter().copied());
        let (below, above) = range(self.before.iter().copied());
        let size = low.abs().max(high.abs());
        let room = if size > 0.0 { BEYOND * size } else { f64::INFINITY };
        let factor = self.scale().factor;
        Ticks::around(
            low.min(below.max(low - room)) * factor,
            high.max(above.min(high + room)) * factor,
            wanted,
        )
    }
}

/// Index and value of the largest size; of equal ones the first.
fn largest(values: &[f64]) -> (usize, f64) {
    let drawn = values.iter().copied().enumerate().filter(|(_, x)| drawable(*x));
    drawn.fold((0, 0.0), |best, next| if next.1.abs() > f64::abs(best.1) { next } else { best })
}

/// A pair on its axes.
struct ProcessingPanel<'a> {
    pair: &'a Pair<'a>,
    across: Ticks,
    /// Whether the axis below has its numbers.
    numbered: bool,
    /// Where the values stand along the axis.
    places: Vec<f64>,
    /// A place in words.
    at: &'a dyn Fn(f64) -> String,
    up: Ticks,
    height: f64,
    target: Option<&'a [f64]>,
}

impl ProcessingPanel<'_> {
    /// Draws the panel below `top`; returns where its axes end, and the largest values in words.
    fn draw(&self, svg: &mut Svg, top: f64) -> (f64, String) {
        let scale = self.pair.scale();
        let (top, bottom) = (top + HEADING, top + HEADING + self.height);
        let axes = Axes {
            left: LEFT,
            right: WIDTH - RIGHT,
            top,
            bottom,
            across: self.across.clone(),
            up: self.up.clone(),
        };
        axes.draw(svg);
        if self.numbered {
            axes.number_across(svg);
        }
        let placed = |values: &[f64]| {
            let shown = |x: f64| if drawable(x) { x } else { f64::NAN };
            let points = self.places.iter().zip(values);
            let points = points.map(|(t, x)| axes.point(shown(*t), shown(*x) * scale.factor));
            clipped(&thin(points, 0.15), (top, bottom))
        };
        svg.before(&placed(self.pair.before));
        svg.lines(AFTER, 1.2, &placed(self.pair.after));
        if let Some(target) = self.target {
            svg.lines(TARGET, 1.6, &placed(target));
        }
        let mut words = Vec::new();
        for (name, values) in [("before", self.pair.before), ("after", self.pair.after)] {
            let (index, value) = largest(values);
            let Some(place) = self.places.get(index) else { continue };
            let point = axes.point(*place, value * scale.factor);
            let beyond =
                if (top - 1e-6..=bottom + 1e-6).contains(&point.1) { "" } else { " (beyond the axis)" };
            if beyond.is_empty() {
                // The ring of what was before is that of a dark line.
                svg.ring(point, if name == "after" { AFTER } else { 3 });
            }
            words.push(format!("{name} {} at {}{beyond}", scale.quantity(value), (self.at)(*place)));
        }
        let words = format!("largest: {}", words.join(", "));
        let title = scale.labelled(self.pair.name);
        svg.text((LEFT, top - 8.0), Anchor::Start, 13.0, Style::Bold, &title);
        svg.text((WIDTH - RIGHT, top - 8.0), Anchor::End, 12.0, Style::Muted, &words);
        (bottom, format!("{}, {words}", self.pair.name))
    }
}

/// The parts of polylines between two heights.
fn clipped(lines: &[Vec<(f64, f64)>], (top, bottom): (f64, f64)) -> Vec<Vec<(f64, f64)>> {
    let mut parts: Vec<Vec<(f64, f64)>> = Vec::new();
    for line in lines {
        let mut part: Vec<(f64, f64)> = Vec::new();
        for pair in line.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            let cut = |height: f64| ((height - a.1) / (b.1 - a.1)).clamp(0.0, 1.0);
            let inside = |y: f64| (top..=bottom).contains(&y);
            let crosses = a.1.min(b.1) < bottom && a.1.max(b.1) > top;
            if !(crosses || inside(a.1) && inside(b.1)) {
                parts.push(std::mem::take(&mut part));
                continue;
            }
            let (s, t) =
                if a.1 == b.1 { (0.0, 1.0) } else { (cut(top).min(cut(bottom)), cut(top).max(cut(bottom))) };
            let at = |s: f64| (a.0 + s * (b.0 - a.0), a.1 + s * (b.1 - a.1));
            if part.is_empty() {
                part.push(at(s));
            }
            part.push(at(t));
            if t < 1.0 {
                parts.push(std::mem::take(&mut part));
            }
        }
        parts.push(part);
    }
    parts.retain(|part| part.len() > 1);
    parts
}

/// A text in lines of at most this width, broken at commas.
fn wrapped(text: &str, width: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_inclusive(", ") {
        match lines.last_mut() {
            Some(line) if text_width(line, 12.0) + text_width(word, 12.0) <= width => line.push_str(word),
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(before: &[f64], after: &[f64]) -> String {
        let time: Vec<f64> = (0..before.len()).map(|i| 0.01 * i as f64).collect();
        let pair = Pair { name: "displacement", unit: "m", before, after };
        let histories = vec![pair];
        BeforeAfter {
            title: "N <S>".into(),
            steps: "taper 1 s".into(),
            before: "as read <raw>",
            time: &time,
            histories,
            spectrum: None,
            target: None,
        }
        .draw()
    }

    #[test]
    fn a_drift_leaves_the_axes_and_is_named() {
        let after: Vec<f64> = (0..500).map(|i| 0.03 * (0.1 * f64::from(i)).sin()).collect();
        let before: Vec<f64> = after.iter().enumerate().map(|(i, x)| x + 0.01 * i as f64).collect();
        let svg = drawn(&before, &after);
        assert!(svg.contains("as read &lt;raw&gt;"), "{svg}");
        assert!(svg.contains("N &lt;S&gt;") && svg.contains("displacement (mm)"), "{svg}");
        assert!(svg.contains("before 4\u{202f}") || svg.contains("before 4"), "{svg}");
        assert!(svg.contains("(beyond the axis)") && svg.contains("after 30.0\u{a0}mm"), "{svg}");
        assert_eq!(svg.matches("<circle").count(), 1, "the peak beyond the axes has no ring");
        let svg = drawn(&after, &after);
        assert!(!svg.contains("beyond") && svg.matches("<circle").count() == 2);
    }

    #[test]
    fn lines_are_cut_where_they_leave() {
        let lines = [vec![(0.0, 5.0), (10.0, 15.0), (20.0, 25.0), (30.0, 5.0), (40.0, 5.0)]];
        assert_eq!(
            clipped(&lines, (0.0, 10.0)),
            [vec![(0.0, 5.0), (5.0, 10.0)], vec![(27.5, 10.0), (30.0, 5.0), (40.0, 5.0)]]
        );
        // Out and in again where points are on the edge itself.
        let edge = [vec![(0.0, 5.0), (10.0, 10.0), (20.0, 15.0), (30.0, 10.0), (40.0, 5.0)]];
        assert_eq!(
            clipped(&edge, (0.0, 10.0)),
            [vec![(0.0, 5.0), (10.0, 10.0)], vec![(30.0, 10.0), (40.0, 5.0)]]
        );
        // From beyond one end to beyond the other.
        assert_eq!(clipped(&[vec![(0.0, -10.0), (3.0, 20.0)]], (0.0, 10.0)), [vec![(1.0, 0.0), (2.0, 10.0)]]);
        assert!(clipped(&[vec![(0.0, 11.0), (3.0, 20.0)]], (0.0, 10.0)).is_empty());
    }

    #[test]
    fn nothing_and_silence_are_drawn_all_the_same() {
        for (before, after) in
            [(&[][..], &[][..]), (&[0.0; 3], &[0.0; 3]), (&[f64::NAN; 3], &[0.0, 1e300, 1.0])]
        {
            assert!(drawn(before, after).ends_with("</svg>\n"));
        }
    }
}
