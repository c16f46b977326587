//! A map in the plane (x, z) to scale, with axes and a colour bar.

use crate::colours::{self, LEVELS, colour};
use crate::svg::{Anchor, Style, Svg};
use crate::ticks::Ticks;

const WIDTH: f64 = 940.0;
const LEFT: f64 = 56.0;
/// Right of the map: the colour bar and its labels.
const BAR: f64 = 110.0;
const TOP: f64 = 30.0;
const TALLEST: f64 = 560.0;
/// A rectangle in (x, z), in m.
#[derive(Clone, Debug, PartialEq)]
pub struct Window {
    low: [f64; 2],
    high: [f64; 2],
}

impl Window {
    /// The smallest that holds all points.
    pub fn around(points: impl Iterator<Item = [f64; 2]>) -> Self {
        let mut window = Window { low: [f64::INFINITY; 2], high: [f64::NEG_INFINITY; 2] };
        for point in points {
            for (i, c) in point.into_iter().enumerate() {
                window.low[i] = window.low[i].min(c);
                window.high[i] = window.high[i].max(c);
            }
        }
        window
    }

    /// Its lower left and upper right corner.
    pub fn corners(&self) -> [[f64; 2]; 2] {
        [self.low, self.high]
    }

    /// Whether it has no extent in x or z.
    pub fn is_empty(&self) -> bool {
        self.low
            .iter()
            .zip(&self.high)
            .any(|(low, high)| low.partial_cmp(high) != Some(std::cmp::Ordering::Less))
    }

    /// Wider on each side by that part of the larger extent.
    pub fn widened(&self, part: f64) -> Self {
        let room = part * (self.high[0] - self.low[0]).max(self.high[1] - self.low[1]);
        Window { low: self.low.map(|c| c - room), high: self.high.map(|c| c + room) }
    }

    /// The part inside another.
    pub fn within(&self, other: &Window) -> Self {
        let at = |i: usize| (self.low[i].max(other.low[i]), self.high[i].min(other.high[i]));
        let (x, z) = (at(0), at(1));
        Window { low: [x.0, z.0], high: [x.1, z.1] }
    }

    /// Whether a convex outline's bounding box meets it.
    pub fn meets(&self, outline: &[[f64; 2]]) -> bool {
        let other = Window::around(outline.iter().copied());
        (0..2).all(|i| other.high[i] >= self.low[i] && other.low[i] <= self.high[i])
    }
}

/// Areas of one kind: name, colour and outlines.
type Kind = (&'static str, &'static str, Vec<Vec<(f64, f64)>>);

/// The map in the making.
pub struct Frame {
    window: Window,
    /// Figure units per metre.
    zoom: f64,
    low: f64,
    high: f64,
    /// Whether colours go from dark below to light above.
    turned: bool,
    levels: Vec<Vec<Vec<(f64, f64)>>>,
    /// Areas of a kind each, under the levels: name, colour, outlines.
    kinds: Vec<Kind>,
    borders: Vec<Vec<(f64, f64)>>,
    points: Vec<(String, (f64, f64))>,
}

impl Frame {
    /// A map of the window, coloured from `low` to `high` (in the display unit).
    pub fn new(window: Window, low: f64, high: f64) -> Self {
        let [width, height] = [0, 1].map(|i| (window.high[i] - window.low[i]).max(1e-9));
        let zoom = ((WIDTH - LEFT - BAR) / width).min(TALLEST / height);
        // One value throughout has no extent to be coloured over: it gets its own size, or 1 where it is zero.
        let high = if high > low { high } else { low + if low == 0.0 { 1.0 } else { low.abs() } };
        Frame {
            window,
            zoom,
            low,
            high,
            turned: false,
            levels: vec![Vec::new(); LEVELS],
            kinds: Vec::new(),
            borders: Vec::new(),
            points: Vec::new(),
        }
    }

    /// Turns the colours round.
    pub fn darkest_is_lowest(&mut self) {
        self.turned = true;
    }

    /// From metres to units, from the map's upper left corner.
    fn place(&self, [x, z]: [f64; 2]) -> (f64, f64) {
        ((x - self.window.low[0]) * self.zoom, (self.window.high[1] - z) * self.zoom)
    }

    /// An area of one value.
    pub fn cell(&mut self, outline: &[[f64; 2]], value: f64) {
        let level = colours::level(value, (self.low, self.high));
        let outline = outline.iter().map(|&p| self.place(p)).collect();
        self.levels[level].push(outline);
    }

    /// A straight line of one value, so many units wide whatever the scale; one that is seen from its end is a dot.
    pub fn stroke(&mut self, ends: [[f64; 2]; 2], width: f64, value: f64) {
        let [a, b] = ends.map(|p| self.place(p));
        let (along, across) = (b.0 - a.0, b.1 - a.1);
        let length = along.hypot(across);
        let half = 0.5 * width;
        let (t, n) = match length {
            // What is shorter than a tenth of a unit is not drawn to its length.
            l if l < 0.1 => ((half, 0.0), (0.0, half)),
            l => ((0.0, 0.0), (-across / l * half, along / l * half)),
        };
        let outline = vec![
            (a.0 - t.0 + n.0, a.1 - t.1 + n.1),
            (b.0 + t.0 + n.0, b.1 + t.1 + n.1),
            (b.0 + t.0 - n.0, b.1 + t.1 - n.1),
            (a.0 - t.0 - n.0, a.1 - t.1 - n.1),
        ];
        self.levels[colours::level(value, (self.low, self.high))].push(outline);
    }

    /// An area that has no value but is of a kind, which has a colour of its own and stands beside the map if it has a name.
    pub fn kind(&mut self, outline: &[[f64; 2]], (name, colour): (&'static str, &'static str)) {
        let outline = outline.iter().map(|&p| self.place(p)).collect();
        match self.kinds.iter_mut().find(|(known, shade, _)| (*known, *shade) == (name, colour)) {
            Some((.., outlines)) => outlines.push(outline),
            None => self.kinds.push((name, colour, vec![outline])),
        }
    }

    /// Thin dark lines.
    pub fn outlines(&mut self, edges: &[[[f64; 2]; 2]]) {
        self.borders = edges.iter().map(|[a, b]| vec![self.place(*a), self.place(*b)]).collect();
    }

    /// A named point; left out if it is outside the window.
    pub fn point(&mut self, name: &str, at: [f64; 2]) {
        if self.window.meets(&[at]) {
            let at = self.place(at);
            self.points.push((name.into(), at));
        }
    }

    /// The figure as SVG; `title` stands above the map.
    pub fn draw(self, title: &str) -> String {
        let mut svg = Svg::new(WIDTH);
        let (width, height) = self.place([self.window.high[0], self.window.low[1]]);
        let bottom = TOP + height;
        svg.text((LEFT, TOP - 12.0), Anchor::Start, 13.0, Style::Bold, title);
        svg.begin_map(LEFT, TOP, width, height);
        for (_, colour, outlines) in &self.kinds {
            svg.areas(colour, outlines);
        }
        for (level, outlines) in self.levels.iter().enumerate().filter(|(_, outlines)| !outlines.is_empty()) {
            svg.areas(&colour(if self.turned { LEVELS - 1 - level } else { level }), outlines);
        }
        svg.borders(&self.borders);
        for (name, at) in &self.points {
            svg.label(*at, name);
        }
        svg.end_map();
        let across = Ticks::within(self.window.low[0], self.window.high[0], (width / 80.0) as usize);
        for (x, label) in &across.marks {
            let x = LEFT + (x - self.window.low[0]) * self.zoom;
            svg.rule((x, bottom), (x, bottom + 5.0), true);
            svg.text((x, bottom + 19.0), Anchor::Middle, 12.0, Style::Muted, label);
        }
        let up = Ticks::within(self.window.low[1], self.window.high[1], (height / 60.0) as usize);
        for (z, label) in &up.marks {
            let y = TOP + (self.window.high[1] - z) * self.zoom;
            svg.rule((LEFT - 5.0, y), (LEFT, y), true);
            svg.text((LEFT - 9.0, y + 4.0), Anchor::End, 12.0, Style::Muted, label);
        }
        svg.text((LEFT + width, bottom + 36.0), Anchor::End, 12.0, Style::Muted, "x (m), z (m)");
        let (right, mut below) = (LEFT + width + 24.0, TOP);
        for (name, colour, _) in self.kinds.iter().filter(|(name, ..)| !name.is_empty()) {
            let y = below;
            svg.areas(
                colour,
                &[vec![(right, y), (right + 16.0, y), (right + 16.0, y + 12.0), (right, y + 12.0)]],
            );
            svg.text((right + 22.0, y + 10.5), Anchor::Start, 12.0, Style::Muted, name);
            below += 21.0;
        }
        if self.levels.iter().any(|outlines| !outlines.is_empty()) {
            let height = (TOP + height - below).max(60.0);
            colours::bar(&mut svg, (right, below), height, (self.low, self.high), self.turned);
        }
        svg.finish(bottom + 44.0, title, "a section coloured by element")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_value_throughout_has_a_colour_bar_that_reads() {
        for (value, label) in [(0.0, ">0.5<"), (-3.0, ">−2.0<")] {
            let outline = [[0.0, 0.0], [40.0, 0.0], [40.0, 30.0], [0.0, 30.0]];
            let mut frame = Frame::new(Window::around(outline.into_iter()), value, value);
            frame.cell(&outline, value);
            let figure = frame.draw("damage");
            assert!(figure.contains(label) && !figure.contains("0.000000000000"), "{value}: {figure}");
        }
    }
}
