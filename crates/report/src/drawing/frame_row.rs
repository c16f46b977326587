//! Maps of one window beside each other or above each other, with one bar of colours for all.

use crate::drawing::colours;
use crate::drawing::frame::Frame;
use crate::drawing::plot::{NARROW, WIDTH};
use crate::drawing::svg::{Anchor, Style, Svg, text_width};
use crate::drawing::window::Window;

const LEFT: f64 = 56.0;
/// Right of the maps: the colour bar and its labels.
const BAR: f64 = 118.0;
const BETWEEN: f64 = 14.0;
/// Left of the names of narrow maps.
const EDGE: f64 = 6.0;
/// Above the maps: the title, and a line for what each of several is.
const TITLE: f64 = 30.0;
/// The title of a narrow figure, whose heading stands beside it on the page.
const SLIM_TITLE: f64 = 18.0;
const LINE: f64 = 20.0;
/// A second such line.
const SECOND: f64 = 15.0;
/// Below a map: its numbers.
const BELOW: f64 = 44.0;
const TALLEST: f64 = 560.0;
/// The same of a figure that stands beside another on a sheet of paper; of maps above each other all that the sheet has room for.
const NARROW_TALLEST: [f64; 2] = [300.0, 390.0];
/// By how much maps above each other must be larger than beside each other, since on a page they leave half of it empty.
const WORTH: f64 = 1.4;

/// So many maps of one window.
pub struct MapRow {
    window: Window,
    width: f64,
    beside: bool,
    room: (f64, f64),
}

impl MapRow {
    /// Beside each other, unless maps of this window are drawn much larger above each other.
    pub fn of(window: Window, maps: usize) -> Self {
        MapRow::at(window, maps, WIDTH, [TALLEST, 1.5 * TALLEST], WORTH)
    }

    /// The same of a figure that stands beside another on a sheet of paper.
    pub fn narrow(window: Window, maps: usize) -> Self {
        MapRow::at(window, maps, NARROW, NARROW_TALLEST, 1.0)
    }

    /// Of so wide a figure; `tallest` is what maps beside each other and above each other have of its height.
    fn at(window: Window, maps: usize, width: f64, tallest: [f64; 2], worth: f64) -> Self {
        let n = maps.max(1) as f64;
        let across = width - LEFT - BAR;
        let beside = ((across - (n - 1.0) * BETWEEN) / n, tallest[0]);
        let above = (across, (tallest[1] - (n - 1.0) * (BELOW + LINE)) / n);
        let [wide, high] = window.size();
        let zoom = |room: (f64, f64)| (room.0 / wide).min(room.1 / high);
        let best = maps < 2 || worth * zoom(beside) >= zoom(above);
        MapRow { window, width, beside: best, room: if best { beside } else { above } }
    }

    /// A map of the row, coloured from `low` to `high` (in the display unit).
    pub fn frame(&self, low: f64, high: f64) -> Frame {
        Frame::new(self.window.clone(), (low, high), self.room)
    }

    /// The figure as SVG: the title above, and above each map what it is, if it is not empty. The bar is that of the first.
    pub fn draw(&self, title: &str, maps: &[(String, Frame)], description: &str) -> String {
        let mut svg = Svg::new(self.width);
        let narrow = self.width < WIDTH;
        match narrow {
            true => svg.text((EDGE, SLIM_TITLE - 5.0), Anchor::Start, 12.0, Style::Muted, title),
            false => svg.text((LEFT, TITLE - 12.0), Anchor::Start, 14.0, Style::Bold, title),
        }
        // On a narrow figure a name has two lines if it needs them; beside other maps its map's width, else all up to the bar.
        let names = |(name, frame): &(String, Frame)| match (narrow, self.beside) {
            (true, true) => halves(name, frame.size().0).map(str::to_owned),
            (true, false) => halves(name, LEFT + frame.size().0 - EDGE).map(str::to_owned),
            (false, _) => [String::new(), name.clone()],
        };
        let names: Vec<[String; 2]> = maps.iter().map(names).collect();
        let mut line = if names.iter().any(|[_, name]| !name.is_empty()) { LINE } else { 0.0 };
        line += if names.iter().any(|[first, _]| !first.is_empty()) { SECOND } else { 0.0 };
        let above = match (title.is_empty(), narrow) {
            (true, _) => 0.0,
            (false, true) => SLIM_TITLE,
            (false, false) => TITLE,
        };
        let (mut at, mut end) = ((LEFT, (above + line).max(8.0)), (0.0, 0.0));
        let top = at.1;
        for (k, ((_, frame), name)) in maps.iter().zip(&names).enumerate() {
            frame.paint(&mut svg, at, k == 0 || !self.beside);
            let (width, height) = frame.size();
            let from = if narrow && !self.beside { EDGE } else { at.0 };
            let room = if self.beside || narrow { at.0 + width - from } else { self.width - LEFT };
            for (words, up) in name.iter().zip([8.0 + SECOND, 8.0]) {
                let size = 13.0 * (room / text_width(words, 13.0)).min(1.0);
                svg.text((from, at.1 - up), Anchor::Start, size, Style::Plain, words);
            }
            end = (at.0 + width, at.1 + height);
            let words = if k == 0 || !self.beside { "x (m), z (m)" } else { "x (m)" };
            svg.text((end.0, end.1 + 36.0), Anchor::End, 12.0, Style::Muted, words);
            at = if self.beside { (end.0 + BETWEEN, at.1) } else { (at.0, end.1 + BELOW + line) };
        }
        let (right, mut below) = (end.0 + 18.0, top);
        let mut named: Vec<(&str, &str)> = Vec::new();
        for (name, colour) in maps.iter().flat_map(|(_, frame)| frame.names()) {
            if named.contains(&(name, colour)) {
                continue;
            }
            named.push((name, colour));
            let y = below;
            let corners = [(right, y), (right + 16.0, y), (right + 16.0, y + 12.0), (right, y + 12.0)];
            svg.areas(colour, &[corners.to_vec()]);
            svg.text((right + 21.0, y + 10.5), Anchor::Start, 12.0, Style::Muted, name);
            below += 21.0;
        }
        if let Some((_, first)) = maps.first()
            && maps.iter().any(|(_, frame)| frame.has_values())
        {
            let height = (end.1 - below).max(60.0);
            colours::bar(&mut svg, (right, below), height, first.range, first.turned);
        }
        svg.finish(end.1 + BELOW, title, description)
    }
}

/// A name in two lines behind one of its stops, as even as these allow, or in the second alone where all of it fits into so much room.
fn halves(name: &str, room: f64) -> [&str; 2] {
    let width = |text: &str| text_width(text, 13.0);
    if width(name) <= room {
        return ["", name];
    }
    let ends = name.char_indices().filter(|(_, c)| ",:，：".contains(*c)).map(|(at, c)| at + c.len_utf8());
    let parts = ends.map(|end| name.split_at(end)).map(|(first, second)| [first, second.trim_start()]);
    let longest = |parts: &[&str; 2]| width(parts[0]).max(width(parts[1]));
    parts.min_by(|a, b| longest(a).total_cmp(&longest(b))).unwrap_or(["", name])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_value_throughout_has_a_colour_bar_that_reads() {
        for (value, label) in [(0.0, ">0.5<"), (-3.0, ">−2.0<")] {
            let outline = [[0.0, 0.0], [40.0, 0.0], [40.0, 30.0], [0.0, 30.0]];
            let row = MapRow::of(Window::around(outline.into_iter()), 1);
            let mut frame = row.frame(value, value);
            frame.cell(&outline, value);
            let figure = row.draw("damage", &[(String::new(), frame)], "");
            assert!(figure.contains(label) && !figure.contains("0.000000000000"), "{value}: {figure}");
        }
    }

    #[test]
    fn a_name_longer_than_its_map_takes_two_lines() {
        let name = "Before the earthquake, t = 0: up to 1.0";
        assert_eq!(halves(name, 300.0), ["", name]);
        assert_eq!(halves(name, 150.0), ["Before the earthquake,", "t = 0: up to 1.0"]);
        assert_eq!(halves("地震前，t = 0：最大 1.0", 100.0), ["地震前，t = 0：", "最大 1.0"]);
        assert_eq!(halves("oneword", 10.0), ["", "oneword"]);
    }

    #[test]
    fn long_maps_stand_above_each_other() {
        let window = |width: f64, height: f64| Window { low: [0.0; 2], high: [width, height] };
        assert!(MapRow::of(window(60.0, 55.0), 2).beside);
        assert!(!MapRow::of(window(200.0, 40.0), 2).beside);
    }
}
