//! The sheet: polygons, axes and the legend of groups, as SVG.

use std::collections::BTreeMap;
use std::fmt::Write;

use super::Window;
use crate::Mesh;

/// Width of the drawing, and most of its height, in pixels.
const WIDTH: f64 = 900.0;
const HEIGHT: f64 = 900.0;
/// Left of and below the drawing, for the numbers; elsewhere the edge.
const MARGIN: f64 = 60.0;
const EDGE: f64 = 30.0;
/// Height of a row of the legend and width of the legend.
const ROW: f64 = 20.0;
const LEGEND: f64 = 300.0;

const GREY: [u8; 3] = [214, 210, 202];
const COLOURS: [[u8; 3]; 14] = [
    [230, 159, 0],
    [86, 180, 233],
    [0, 158, 115],
    [240, 228, 66],
    [0, 114, 178],
    [213, 94, 0],
    [204, 121, 167],
    [148, 103, 60],
    [150, 200, 100],
    [120, 120, 200],
    [230, 130, 130],
    [70, 150, 150],
    [190, 160, 90],
    [160, 160, 160],
];

/// Which group each element is coloured by, and how.
pub(super) struct Legend {
    /// For each element of the mesh the place of its group in `groups`, `u32::MAX` if it has none.
    group_of: Vec<u32>,
    /// Name, elements and colour of the groups seen, in the order of their names.
    groups: BTreeMap<u32, (String, usize, [u8; 3])>,
}

impl Legend {
    /// `seen`: the elements in the picture.
    pub fn new(mesh: &Mesh, seen: impl Iterator<Item = u32>) -> Legend {
        let mut by_size: Vec<(u32, &String, &Vec<u32>)> =
            (0..).zip(&mesh.groups).map(|(place, (name, elements))| (place, name, elements)).collect();
        by_size.sort_by_key(|g| std::cmp::Reverse(g.2.len()));
        let mut group_of = vec![u32::MAX; mesh.elements.len()];
        for (place, _, elements) in &by_size {
            elements.iter().for_each(|&e| group_of[e as usize] = *place);
        }
        let mut shown: Vec<u32> = seen.map(|e| group_of[e as usize]).collect();
        shown.sort_unstable();
        shown.dedup();
        let grey = by_size.iter().map(|g| g.0).find(|place| shown.contains(place));
        // Once round, the colours come again, lighter.
        let light = COLOURS.map(|c| c.map(|x| ((u16::from(x) + 510) / 3) as u8));
        let mut next = COLOURS.iter().chain(&light).cycle();
        let mut groups = BTreeMap::new();
        for (place, (name, elements)) in (0..).zip(&mesh.groups) {
            if shown.contains(&place) {
                let colour = if grey == Some(place) { &GREY } else { next.next().unwrap_or(&GREY) };
                groups.insert(place, (name.clone(), elements.len(), *colour));
            }
        }
        if shown.contains(&u32::MAX) {
            groups.insert(u32::MAX, ("(no group)".to_owned(), 0, [255, 255, 255]));
        }
        Legend { group_of, groups }
    }

    pub fn rows(&self) -> usize {
        self.groups.len()
    }

    pub fn colour(&self, element: u32) -> [u8; 3] {
        self.groups.get(&self.group_of[element as usize]).map_or(GREY, |g| g.2)
    }
}

/// The sheet under the pen.
pub(super) struct Canvas {
    window: Window,
    /// Pixels per metre.
    scale: f64,
    height: f64,
    body: String,
    /// Drawn after the polygons, outside the window.
    frame: String,
    rows: usize,
}

impl Canvas {
    /// A sheet for what lies in the window, with room for so many rows of legend.
    pub fn new(window: Window, rows: usize) -> Canvas {
        let size = [0, 1].map(|c| window[1][c] - window[0][c]);
        let sound = size.iter().all(|s| s.is_finite() && *s > 0.0);
        let window = if sound { window } else { [[0.0; 2], [1.0; 2]] };
        let size = if sound { size } else { [1.0; 2] };
        let scale = (WIDTH / size[0]).min(HEIGHT / size[1]);
        Canvas { window, scale, height: scale * size[1], body: String::new(), frame: String::new(), rows }
    }

    fn place(&self, p: [f64; 2]) -> [f64; 2] {
        let [x, z] = [0, 1].map(|c| (p[c] - self.window[0][c]) * self.scale);
        [MARGIN + x, EDGE + self.height - z]
    }

    /// A filled polygon with its outline, its colour made darker by `light` below 1.
    pub fn polygon(&mut self, points: &[[f64; 2]], colour: [u8; 3], light: f64) {
        let [r, g, b] = colour.map(|c| (f64::from(c) * light).round() as u8);
        let mut list = String::new();
        for p in points {
            let [x, y] = self.place(*p);
            // Writing to a string cannot fail; nor below.
            let _ = write!(list, "{x:.1},{y:.1} ");
        }
        let _ =
            writeln!(self.body, "<polygon points=\"{}\" fill=\"#{r:02x}{g:02x}{b:02x}\"/>", list.trim_end());
    }

    /// Numbers along the lower and the left edge.
    pub fn axes(&mut self, names: [&str; 2]) {
        for axis in 0..2 {
            let [low, high] = [self.window[0][axis], self.window[1][axis]];
            let step = step((high - low) / 6.0);
            let mut k = (low / step).ceil();
            while k * step <= high && (high - low) / step < 100.0 {
                let mut at = self.window[0];
                at[axis] = k * step;
                let [x, y] = self.place(at);
                // Not "-0".
                let label = k * step + 0.0;
                let _ = if axis == 0 {
                    writeln!(
                        self.frame,
                        "<path d=\"M{x:.1} {y:.1}v6\"/><text x=\"{x:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{label}</text>",
                        y + 20.0
                    )
                } else {
                    writeln!(
                        self.frame,
                        "<path d=\"M{x:.1} {y:.1}h-6\"/><text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">{label}</text>",
                        x - 9.0,
                        y + 4.0
                    )
                };
                k += 1.0;
            }
        }
        let [x, y] = self.place([self.window[1][0], self.window[0][1]]);
        let top = self.place([self.window[0][0], self.window[1][1]]);
        let _ = writeln!(
            self.frame,
            "<text x=\"{x:.1}\" y=\"{:.1}\" text-anchor=\"end\">{} [m]</text>\
             <text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">{} [m]</text>",
            y + 38.0,
            names[0],
            top[0] - 9.0,
            top[1] - 10.0,
            names[1]
        );
    }

    /// The text of the picture.
    pub fn finish(self, legend: &Legend, title: &str) -> String {
        let width = self.scale * (self.window[1][0] - self.window[0][0]);
        let left = MARGIN + width + EDGE;
        let sheet = [left + LEGEND, (EDGE + self.height + MARGIN).max(EDGE * 3.0 + ROW * self.rows as f64)];
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {w:.0} {h:.0}\" width=\"{w:.0}\" height=\"{h:.0}\" \
             font-family=\"sans-serif\" font-size=\"13\">\n<title>{title}</title>\n\
             <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n\
             <clipPath id=\"window\"><rect x=\"{MARGIN}\" y=\"{EDGE}\" width=\"{width:.1}\" height=\"{height:.1}\"/></clipPath>\n\
             <g clip-path=\"url(#window)\" stroke=\"#333333\" stroke-width=\"0.4\" stroke-linejoin=\"round\">\n",
            title = escaped(title),
            w = sheet[0],
            h = sheet[1],
            height = self.height,
        );
        svg.push_str(&self.body);
        svg.push_str("</g>\n<g stroke=\"none\" fill=\"#222222\">\n");
        svg.push_str(&self.frame.replace("<path ", "<path stroke=\"#222222\" "));
        let _ = writeln!(svg, "<text x=\"{left:.1}\" y=\"{:.1}\">{}</text>", EDGE + 4.0, escaped(title));
        for (row, (name, count, [r, g, b])) in (1..).zip(legend.groups.values()) {
            let y = EDGE + 4.0 + ROW * f64::from(row);
            let count = if *count > 0 { format!(" — {count}") } else { String::new() };
            let _ = writeln!(
                svg,
                "<rect x=\"{left:.1}\" y=\"{:.1}\" width=\"14\" height=\"14\" fill=\"#{r:02x}{g:02x}{b:02x}\" stroke=\"#333333\"/>\
                 <text x=\"{:.1}\" y=\"{y:.1}\">{}{count}</text>",
                y - 12.0,
                left + 20.0,
                escaped(name)
            );
        }
        svg.push_str("</g>\n</svg>\n");
        svg
    }
}

/// The next of 1, 2, 5, 10 … above.
fn step(least: f64) -> f64 {
    let power = 10f64.powf(least.log10().floor());
    [1.0, 2.0, 5.0].map(|k| k * power).into_iter().find(|s| *s >= least).unwrap_or(10.0 * power)
}

fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            // Control characters may not stand in XML at all.
            c if c.is_control() => safe.push('\u{fffd}'),
            c => safe.push(c),
        }
    }
    safe
}
