//! Writing SVG: every figure carries its own colours, and classes by which the page can recolour it in the dark.

use std::fmt::{Display, Write};

/// Colours of the lines, told apart by people with any of the common colour blindnesses (Okabe & Ito 2008).
pub const LINES: [&str; 7] = ["#0072B2", "#D55E00", "#009E73", "#333333", "#CC79A7", "#E69F00", "#56B4E9"];
/// Of more dots than this larger ones would hide each other.
const MANY: usize = 200;
/// Strokes that are told apart without colours: whole, dashed, dotted.
const DASHES: [&str; 3] = ["", " stroke-dasharray=\"6 3\"", " stroke-dasharray=\"1.5 3\""];
/// Text.
const INK: &str = "#1f2933";
/// Text of lesser weight.
const MUTED: &str = "#5b6773";
const GRID: &str = "#e2e6ea";
const VEIL: &str = "#d3dae1";
const AXIS: &str = "#8b95a1";
/// A middle grey: lighter than any line, darker than the grid.
const BEFORE: &str = "#9aa0a6";
const FONTS: &str =
    "system-ui,-apple-system,'Segoe UI',Roboto,'Helvetica Neue',Arial,'Noto Sans CJK SC',sans-serif";

/// Text, safe in HTML and XML, in elements and in quoted attributes. Characters that XML forbids become `�`.
pub fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            '\t' | '\n' | '\r' => out.push(' '),
            '\u{fffe}' | '\u{ffff}' => out.push('\u{fffd}'),
            c if c.is_control() => out.push('\u{fffd}'),
            c => out.push(c),
        }
    }
    out
}

/// Where a text stands relative to its point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Anchor {
    Start,
    Middle,
    End,
}

/// A figure in the making. One unit is one CSS pixel at full width.
pub struct Svg {
    width: f64,
    body: String,
}

/// Between a dot and its name, and the size of that.
const ASIDE: f64 = 7.0;
const NAMED: f64 = 14.0;

impl Svg {
    pub fn new(width: f64) -> Self {
        Svg { width, body: String::new() }
    }

    fn put(&mut self, text: impl Display) {
        // Writing to a String cannot fail.
        let _ = write!(self.body, "{text}");
    }

    /// A straight line of the grid, or of an axis if `strong`.
    pub fn rule(&mut self, from: (f64, f64), to: (f64, f64), strong: bool) {
        let (class, colour) = if strong { ("axis", AXIS) } else { ("grid", GRID) };
        self.put(format_args!(
            "<path class=\"{class}\" stroke=\"{colour}\" d=\"M{} {}L{} {}\"/>",
            Short(from.0),
            Short(from.1),
            Short(to.0),
            Short(to.1)
        ));
    }

    /// A text of `size` in ink, or muted; `bold` for headings.
    pub fn text(&mut self, at: (f64, f64), anchor: Anchor, size: f64, style: Style, text: &str) {
        let (class, colour) = if style == Style::Muted { ("muted", MUTED) } else { ("ink", INK) };
        let anchor = match anchor {
            Anchor::Start => "",
            Anchor::Middle => " text-anchor=\"middle\"",
            Anchor::End => " text-anchor=\"end\"",
        };
        let weight = if style == Style::Bold { " font-weight=\"600\"" } else { "" };
        self.put(format_args!(
            "<text class=\"{class}\" fill=\"{colour}\" x=\"{}\" y=\"{}\" font-size=\"{}\"{anchor}{weight}>{}</text>",
            Short(at.0),
            Short(at.1),
            Short(size),
            escape(text)
        ));
    }

    /// Polylines in the colour `colour`; from the eighth colour on the colours return, dashed.
    pub fn lines(&mut self, colour: usize, width: f64, lines: &[Vec<(f64, f64)>]) {
        let k = colour % LINES.len();
        let dash = DASHES[(colour / LINES.len()).min(DASHES.len() - 1)];
        self.put(format_args!(
            "<path class=\"s{k}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\"{dash} d=\"",
            LINES[k],
            Short(width)
        ));
        for line in lines {
            self.trace(line, false);
        }
        self.put("\"/>");
    }

    /// A small ring that marks one point of a line of that colour.
    pub fn ring(&mut self, at: (f64, f64), colour: usize) {
        let k = colour % LINES.len();
        self.put(format_args!(
            "<circle class=\"paper s{k}\" cx=\"{}\" cy=\"{}\" r=\"3.6\" fill=\"#fff\" stroke=\"{}\" stroke-width=\"1.6\"/>",
            Short(at.0),
            Short(at.1),
            LINES[k]
        ));
    }

    /// Dots in the colour of a line, smaller where they are many.
    pub fn dots(&mut self, colour: usize, points: &[(f64, f64)]) {
        let k = colour % LINES.len();
        let size = if points.len() > MANY { 3.4 } else { 5.5 };
        self.put(format_args!(
            "<path class=\"s{k}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{size}\" stroke-linecap=\"round\" d=\"",
            LINES[k]
        ));
        for (x, y) in points {
            self.put(format_args!("M{} {}h.01", Short(*x), Short(*y)));
        }
        self.put("\"/>");
    }

    /// Closed areas of one colour.
    pub fn areas(&mut self, colour: &str, outlines: &[Vec<(f64, f64)>]) {
        // The thin outline hides the seams that antialiasing leaves between neighbours.
        self.put(format_args!("<path fill=\"{0}\" stroke=\"{0}\" stroke-width=\"0.5\" d=\"", escape(colour)));
        for outline in outlines {
            self.trace(outline, true);
        }
        self.put("\"/>");
    }

    /// A pale area under lines, in the page's colour.
    pub fn veil(&mut self, outline: &[(f64, f64)]) {
        self.put(format_args!("<path class=\"veil\" fill=\"{VEIL}\" d=\""));
        self.trace(outline, true);
        self.put("\"/>");
    }

    /// Thin dark lines on a map. Maps keep their own light colours in the dark, so these do not follow the page.
    pub fn borders(&mut self, lines: &[Vec<(f64, f64)>]) {
        self.strokes("stroke=\"#1f2933\" stroke-width=\"0.9\" stroke-linecap=\"round\"", lines);
    }

    /// Blue lines with a light edge on a map.
    pub fn marked(&mut self, lines: &[Vec<(f64, f64)>]) {
        for (colour, width) in [("#fff", "2.6"), (LINES[0], "1.3")] {
            self.strokes(&format!("stroke=\"{colour}\" stroke-width=\"{width}\""), lines);
        }
    }

    /// Strong dark lines with a light edge on a map.
    pub fn shapes(&mut self, lines: &[Vec<(f64, f64)>]) {
        for (colour, width) in [("#fff", "4"), ("#1f2933", "2")] {
            let pen = format!("stroke=\"{colour}\" stroke-width=\"{width}\" stroke-linecap=\"round\"");
            self.strokes(&pen, lines);
        }
    }

    /// Hatching on a map, dark with a light edge so that it is seen on any colour.
    pub fn hatching(&mut self, lines: &[Vec<(f64, f64)>]) {
        for (colour, width) in [("#fff", "2.2"), ("#1f2933", "0.9")] {
            self.strokes(&format!("stroke=\"{colour}\" stroke-width=\"{width}\""), lines);
        }
    }

    /// Grey lines for what was before.
    pub fn before(&mut self, lines: &[Vec<(f64, f64)>]) {
        self.strokes(&format!("stroke=\"{BEFORE}\" stroke-width=\"1.5\" stroke-linejoin=\"round\""), lines);
    }

    fn strokes(&mut self, pen: &str, lines: &[Vec<(f64, f64)>]) {
        self.put(format_args!("<path fill=\"none\" {pen} d=\""));
        for line in lines {
            self.trace(line, false);
        }
        self.put("\"/>");
    }

    /// How far the name of a dot reaches to its side, its light edge included.
    pub fn label_reach(name: &str) -> f64 {
        ASIDE + text_width(name, NAMED) + 2.0
    }

    /// A dot on a map.
    pub fn dot(&mut self, at: (f64, f64)) {
        self.put(format_args!(
            "<circle cx=\"{0}\" cy=\"{1}\" r=\"4\" fill=\"#fff\" stroke=\"#1f2933\" stroke-width=\"1.6\"/>",
            Short(at.0),
            Short(at.1),
        ));
    }

    /// The name of a dot on a map, legible on any colour: to the right of the dot, or ending at an edge, its baseline so far below it.
    pub fn label(&mut self, at: (f64, f64), name: &str, edge: Option<f64>, below: f64) {
        let (x, anchor) = match edge {
            Some(edge) => (edge - 2.0, " text-anchor=\"end\""),
            None => (at.0 + ASIDE, ""),
        };
        self.put(format_args!(
            "<text x=\"{0}\" y=\"{1}\"{2} font-size=\"{NAMED}\" font-weight=\"600\" fill=\"#1f2933\" stroke=\"#fff\" \
             stroke-width=\"3.5\" paint-order=\"stroke\">{3}</text>",
            Short(x),
            Short(at.1 + below),
            anchor,
            escape(name)
        ));
    }

    /// A word in the middle of a map, legible on any colour.
    pub fn note(&mut self, (x, y): (f64, f64), text: &str) {
        self.put(format_args!(
            "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\" font-size=\"11.5\" fill=\"#1f2933\" stroke=\"#fff\" \
             stroke-width=\"3\" paint-order=\"stroke\">{}</text>",
            Short(x),
            Short(y + 4.0),
            escape(text)
        ));
    }

    /// Starts a map: a part with its own origin and ground, cut off at its edges. Ends with [`Svg::end_map`].
    pub fn begin_map(&mut self, x: f64, y: f64, width: f64, height: f64) {
        let (x, y, w, h) = (Short(x), Short(y), Short(width), Short(height));
        self.put(format_args!(
            "<svg x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\" overflow=\"hidden\">\
             <rect width=\"{w}\" height=\"{h}\" fill=\"#f3f4f6\"/>"
        ));
    }

    /// Ends the map.
    pub fn end_map(&mut self) {
        self.put("</svg>");
    }

    /// A path in tenths of a unit, relative: a third of the bytes of absolute coordinates.
    fn trace(&mut self, points: &[(f64, f64)], closed: bool) {
        let tenths = |p: &(f64, f64)| (Tenths::of(p.0).0, Tenths::of(p.1).0);
        let mut points = points.iter().map(tenths);
        let Some(start) = points.next() else { return };
        self.put(format_args!("M{} {}l", Tenths(start.0), Tenths(start.1)));
        let mut last = start;
        let mut drawn = false;
        for point in points {
            if point == last {
                continue;
            }
            let (dx, dy) = (point.0 - last.0, point.1 - last.1);
            let between = if dy < 0 { "" } else { " " };
            let before = if drawn && dx >= 0 { " " } else { "" };
            self.put(format_args!("{before}{}{between}{}", Tenths(dx), Tenths(dy)));
            (last, drawn) = (point, true);
        }
        if !drawn {
            // A point alone; a stroke of no length shows nothing.
            self.put("1 0");
        }
        if closed {
            self.put("z");
        }
    }

    /// The whole file. `title` and `description` are what a screen reader says.
    pub fn finish(self, height: f64, title: &str, description: &str) -> String {
        let (w, h) = (Short(self.width), Short(height));
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {w} {h}\" width=\"{w}\" height=\"{h}\" role=\"img\" \
             font-family=\"{FONTS}\"><title>{}</title><desc>{}</desc>\
             <rect class=\"paper\" width=\"{w}\" height=\"{h}\" fill=\"#fff\"/>{}</svg>\n",
            escape(title),
            escape(description),
            self.body
        )
    }
}

/// Height over width of a drawing made here.
pub fn proportion(drawing: &str) -> Option<f64> {
    let (size, _) = drawing.split_once("viewBox=\"0 0 ")?.1.split_once('"')?;
    let (width, height) = size.split_once(' ')?;
    Some(height.parse::<f64>().ok()? / width.parse::<f64>().ok()?)
}

/// How a text is set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Style {
    Plain,
    Bold,
    Muted,
}

/// About how wide a text will be; wide scripts count double. For laying out legends.
pub fn text_width(text: &str, size: f64) -> f64 {
    text.chars().map(|c| if c < '\u{1100}' { 0.56 } else { 1.0 }).sum::<f64>() * size
}

/// A number with at most one decimal.
struct Short(f64);

impl Display for Short {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        Tenths::of(self.0).fmt(f)
    }
}

/// Tenths as a decimal number, without needless characters: `-.5`, `12`, `3.1`.
struct Tenths(i64);

impl Tenths {
    /// Far outside the drawing stays far outside, without overflow.
    fn of(x: f64) -> Self {
        Tenths((x * 10.0).round().clamp(-1e9, 1e9) as i64)
    }
}

impl Display for Tenths {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (whole, tenth) = (self.0.abs() / 10, self.0.abs() % 10);
        if self.0 < 0 {
            f.write_str("-")?;
        }
        match (whole, tenth) {
            (_, 0) => write!(f, "{whole}"),
            (0, _) => write!(f, ".{tenth}"),
            _ => write!(f, "{whole}.{tenth}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_short_and_exact_to_a_tenth() {
        let mut svg = Svg::new(10.0);
        svg.lines(
            8,
            1.2,
            &[vec![(0.0, 1.0), (0.52, 0.5), (0.52, 0.5), (12.0, 3.18), (11.0, 3.18)], vec![(5.0, 5.0)]],
        );
        assert!(svg.body.contains("d=\"M0 1l.5-.5 11.5 2.7-1 0M5 5l1 0\""), "{}", svg.body);
        assert!(svg.body.contains("class=\"s1\"") && svg.body.contains("dasharray"));
    }

    #[test]
    fn text_cannot_break_out_of_its_element() {
        assert_eq!(escape("<b a=\"'x'\">&\u{0}\n"), "&lt;b a=&quot;&#39;x&#39;&quot;&gt;&amp;\u{fffd} ");
    }
}
