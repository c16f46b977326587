//! A map in the plane (x, z) to scale: what is on it. How maps stand side by side is in [`frame_row`](crate::drawing::frame_row).

use crate::drawing::colours::{self, LEVELS, colour};
use crate::drawing::contours::{bands, line};
use crate::drawing::svg::{Anchor, Style, Svg};
use crate::drawing::ticks::Ticks;
use crate::drawing::window::Window;

/// Areas of one kind: name, colour and outlines.
type LineKind = (String, &'static str, Vec<Vec<(f64, f64)>>);

/// Units: of lines that lead somewhere, how long and how far apart the heads of arrows are.
const HEAD: f64 = 5.0;
const HEADS_APART: f64 = 130.0;
/// Baselines of a point's name below its dot, in the order in which they are tried.
const BASELINES: [f64; 4] = [-6.0, 17.0, -20.0, 31.0];
/// Height of the letters of a name.
const LETTERS: f64 = 12.0;

/// Left, top, right and bottom of a name.
type Area = [f64; 4];

fn overlap(a: &Area, b: &Area) -> bool {
    a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]
}

/// The map in the making.
pub struct Frame {
    window: Window,
    /// Figure units per metre.
    zoom: f64,
    /// Ends of the colours, in the display unit.
    pub range: (f64, f64),
    /// Whether colours go from dark below to light above.
    pub turned: bool,
    levels: Vec<Vec<Vec<(f64, f64)>>>,
    /// Areas of a kind each, under the levels.
    kinds: Vec<LineKind>,
    borders: Vec<Vec<(f64, f64)>>,
    /// Lines over all else, and those on which the value is zero.
    shapes: Vec<Vec<(f64, f64)>>,
    zero: Vec<Vec<(f64, f64)>>,
    /// Lines that lead somewhere with the heads of their arrows, thin.
    leading: Vec<Vec<(f64, f64)>>,
    points: Vec<(String, (f64, f64))>,
}

impl Frame {
    /// A map of the window within so much room, coloured from `low` to `high` (in the display unit).
    pub fn new(window: Window, (low, high): (f64, f64), room: (f64, f64)) -> Self {
        let [width, height] = window.size();
        let zoom = (room.0 / width).min(room.1 / height);
        // One value throughout has no extent to be coloured over: it gets its own size, or 1 where it is zero.
        let high = if high > low { high } else { low + if low == 0.0 { 1.0 } else { low.abs() } };
        Frame {
            window,
            zoom,
            range: (low, high),
            turned: false,
            levels: vec![Vec::new(); LEVELS],
            kinds: Vec::new(),
            borders: Vec::new(),
            shapes: Vec::new(),
            zero: Vec::new(),
            leading: Vec::new(),
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

    /// What of edges is seen.
    fn placed(&self, edges: &[[[f64; 2]; 2]]) -> Vec<Vec<(f64, f64)>> {
        let seen = edges.iter().filter(|edge| self.window.meets(*edge));
        seen.map(|[a, b]| vec![self.place(*a), self.place(*b)]).collect()
    }

    /// Its width and height in units.
    pub fn size(&self) -> (f64, f64) {
        let [width, height] = self.window.size();
        (width * self.zoom, height * self.zoom)
    }

    /// An area of one value.
    pub fn cell(&mut self, outline: &[[f64; 2]], value: f64) {
        if self.window.meets(outline) {
            let level = colours::level(value, self.range);
            let outline = outline.iter().map(|&p| self.place(p)).collect();
            self.levels[level].push(outline);
        }
    }

    /// An area with a value at each corner, as filled contours; with a line where the value is zero.
    pub fn contours(&mut self, outline: &[[f64; 2]], values: &[f64]) {
        if !self.window.meets(outline) {
            return;
        }
        let (low, high) = self.range;
        let corners: Vec<([f64; 2], f64)> = outline.iter().copied().zip(values.iter().copied()).collect();
        let from = |level: usize| low + (high - low) * level as f64 / LEVELS as f64;
        for (level, outline) in bands(&corners, |value| colours::level(value, (low, high)), from) {
            let outline = outline.into_iter().map(|p| self.place(p)).collect();
            self.levels[level].push(outline);
        }
        // Where an end of the colours is zero, there is no sign to tell.
        if low < 0.0 && high > 0.0 {
            let zero = self.placed(&line(&corners, 0.0));
            self.zero.extend(zero);
        }
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
        self.levels[colours::level(value, self.range)].push(outline);
    }

    /// An area that has no value but is of a kind, which has a colour of its own and stands beside the map by its name,
    /// unless that is empty.
    pub fn kind(&mut self, outline: &[[f64; 2]], name: &str, colour: &'static str) {
        if !self.window.meets(outline) {
            return;
        }
        let outline = outline.iter().map(|&p| self.place(p)).collect();
        match self.kinds.iter_mut().find(|(known, of, _)| known == name && *of == colour) {
            Some((.., outlines)) => outlines.push(outline),
            None => self.kinds.push((name.into(), colour, vec![outline])),
        }
    }

    /// Thin dark lines.
    pub fn outlines(&mut self, edges: &[[[f64; 2]; 2]]) {
        let lines = self.placed(edges);
        self.borders.extend(lines);
    }

    /// Dark lines with a light edge, over all else.
    pub fn shapes(&mut self, edges: &[[[f64; 2]; 2]]) {
        let lines = self.placed(edges);
        self.shapes.extend(lines);
    }

    /// A line that leads from its first point to its last, over all but names, with heads of arrows on what of it is seen.
    pub fn leading(&mut self, line: &[[f64; 2]]) {
        let mut seen: Vec<Vec<(f64, f64)>> = Vec::new();
        let mut goes_on = false;
        for ends in line.windows(2) {
            let inside = self.window.meets(ends);
            let [a, b] = [ends[0], ends[1]].map(|end| self.place(end));
            match seen.last_mut() {
                Some(part) if inside && goes_on => part.push(b),
                _ if inside => seen.push(vec![a, b]),
                _ => {}
            }
            goes_on = inside;
        }
        for part in seen {
            self.heads(&part);
            self.leading.push(part);
        }
    }

    /// Heads in the middle of a line, or so far apart from each other along it.
    fn heads(&mut self, line: &[(f64, f64)]) {
        let length = |ends: &[(f64, f64)]| (ends[1].0 - ends[0].0).hypot(ends[1].1 - ends[0].1);
        let whole: f64 = line.windows(2).map(length).sum();
        let number = (whole / HEADS_APART).round().max(1.0);
        let mut next = 0.5 * whole / number;
        if whole < 3.0 * HEAD {
            return;
        }
        let mut passed = 0.0;
        for piece in line.windows(2) {
            let ([x, y], [to_x, to_y]) = ([piece[0].0, piece[0].1], [piece[1].0, piece[1].1]);
            let own = length(piece);
            while next <= passed + own && own > 0.0 {
                let (along, down) = ((to_x - x) / own, (to_y - y) / own);
                let (x, y) = (x + (next - passed) * along, y + (next - passed) * down);
                let tip = (x + 0.5 * HEAD * along, y + 0.5 * HEAD * down);
                let back =
                    |turn: f64| (tip.0 - HEAD * (along - turn * down), tip.1 - HEAD * (down + turn * along));
                self.leading.push(vec![back(0.45), tip, back(-0.45)]);
                next += whole / number;
            }
            passed += own;
        }
    }

    /// A named point; left out if it is outside the window.
    pub fn point(&mut self, name: &str, at: [f64; 2]) {
        if self.window.meets(&[at]) {
            let at = self.place(at);
            self.points.push((name.into(), at));
        }
    }

    /// Names and colours of the kinds that have a name.
    pub fn names(&self) -> impl Iterator<Item = (&str, &'static str)> {
        self.kinds
            .iter()
            .filter(|(name, ..)| !name.is_empty())
            .map(|(name, colour, _)| (name.as_str(), *colour))
    }

    /// Whether anything on it has a value.
    pub fn has_values(&self) -> bool {
        self.levels.iter().any(|outlines| !outlines.is_empty())
    }

    /// Draws it with its upper left corner at a point, numbers of x below, and those of z to its left if wanted.
    pub fn paint(&self, svg: &mut Svg, (left, top): (f64, f64), heights: bool) {
        let (width, height) = self.size();
        let bottom = top + height;
        svg.begin_map(left, top, width, height);
        for (_, colour, outlines) in &self.kinds {
            svg.areas(colour, outlines);
        }
        for (level, outlines) in self.levels.iter().enumerate().filter(|(_, outlines)| !outlines.is_empty()) {
            svg.areas(&colour(if self.turned { LEVELS - 1 - level } else { level }), outlines);
        }
        if !self.zero.is_empty() {
            svg.marked(&self.zero);
        }
        svg.borders(&self.borders);
        if !self.shapes.is_empty() {
            svg.shapes(&self.shapes);
        }
        if !self.leading.is_empty() {
            svg.hatching(&self.leading);
        }
        self.points.iter().for_each(|(_, at)| svg.dot(*at));
        let mut taken: Vec<Area> = Vec::new();
        for (name, at) in &self.points {
            // A name that would be cut off at the map's edge ends there.
            let reach = Svg::label_reach(name);
            let edge = (at.0 + reach > width && reach < width).then_some(width);
            let left = edge.map_or(at.0, |edge| edge - reach);
            // A name for which no place is free is left out: wider figures have it.
            let places =
                BASELINES.map(|below| (below, [left, at.1 + below - LETTERS, left + reach, at.1 + below]));
            let free = |area: &Area| taken.iter().all(|other| !overlap(area, other));
            if let Some((below, area)) = places.into_iter().find(|(_, area)| free(area)) {
                svg.label(*at, name, edge, below);
                taken.push(area);
            }
        }
        svg.end_map();
        let across = Ticks::within(self.window.low[0], self.window.high[0], (width / 80.0) as usize);
        for (x, label) in &across.marks {
            let x = left + (x - self.window.low[0]) * self.zoom;
            svg.rule((x, bottom), (x, bottom + 5.0), true);
            svg.text((x, bottom + 19.0), Anchor::Middle, 12.0, Style::Muted, label);
        }
        let up = Ticks::within(self.window.low[1], self.window.high[1], (height / 60.0) as usize);
        for (z, label) in up.marks.iter().filter(|_| heights) {
            let y = top + (self.window.high[1] - z) * self.zoom;
            svg.rule((left - 5.0, y), (left, y), true);
            svg.text((left - 9.0, y + 4.0), Anchor::End, 12.0, Style::Muted, label);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Beside the right edge a name would be cut off.
    #[test]
    fn the_name_of_a_point_stands_where_there_is_room_for_it() {
        let window = || Window { low: [0.0; 2], high: [40.0, 30.0] };
        for (x, ends) in [(20.0, false), (39.0, true), (0.5, false)] {
            let mut frame = Frame::new(window(), (0.0, 1.0), (160.0, 120.0));
            frame.point("F", [x, 15.0]);
            let mut svg = Svg::new(200.0);
            frame.paint(&mut svg, (0.0, 0.0), false);
            let drawn = svg.finish(150.0, "", "");
            let (text, _) = drawn.split_once(">F</text>").unwrap();
            let (_, text) = text.rsplit_once("<text").unwrap();
            assert_eq!(
                text.contains("x=\"158\"") && text.contains("text-anchor=\"end\""),
                ends,
                "{x}: {text}"
            );
        }
        // Names of points beside one another do not overlap; the fifth finds no place.
        let mut frame = Frame::new(window(), (0.0, 1.0), (160.0, 120.0));
        for (k, name) in ["crown", "left", "right", "roof", "floor"].into_iter().enumerate() {
            frame.point(name, [10.0 + 0.1 * k as f64, 15.0]);
        }
        let mut svg = Svg::new(200.0);
        frame.paint(&mut svg, (0.0, 0.0), false);
        let drawn = svg.finish(150.0, "", "");
        let height = |name: &str| {
            let (text, _) = drawn.split_once(&format!(">{name}</text>"))?;
            let (_, text) = text.rsplit_once(" y=\"")?;
            text.split_once('"')?.0.parse::<f64>().ok()
        };
        let mut heights: Vec<f64> =
            ["crown", "left", "right", "roof"].map(|name| height(name).unwrap()).into();
        heights.sort_by(f64::total_cmp);
        assert!(heights.windows(2).all(|pair| pair[1] - pair[0] >= LETTERS), "{heights:?}");
        assert_eq!(height("floor"), None);
        // On a map narrower than the name it stays, cut off or not.
        let mut frame = Frame::new(window(), (0.0, 1.0), (16.0, 12.0));
        frame.point("monitor 12", [39.0, 15.0]);
        let mut svg = Svg::new(200.0);
        frame.paint(&mut svg, (0.0, 0.0), false);
        assert!(!svg.finish(150.0, "", "").contains("text-anchor=\"end\""));
    }
}
