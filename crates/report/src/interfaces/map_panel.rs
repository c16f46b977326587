//! One panel of a map of interfaces: sheets coloured by what their pairs did, with axes around them.

use tremolite_results::PairSurface;

use crate::developed::layout::{BAR, LEFT, Layout, end_walls, marks};
use crate::developed::unfold::Sheet;
use crate::developed::words::direction;
use crate::drawing::colours::{self, LEVELS, colour, level};
use crate::drawing::svg::{Anchor, Style, Svg, text_width};
use crate::drawing::ticks::Ticks;
use crate::language::{Language, say};
use crate::quantities::scale::Scale;

const GREY: &str = "#dfe3e8";
/// Distance of the lines of hatching.
const HATCH: f64 = 6.0;
/// Above a panel's sheets: its title, and a row for names and parts where axes run upwards.
pub const TITLE: f64 = 30.0;
pub const ROW: f64 = 18.0;
/// Below: numbers and what they are.
pub const BELOW: f64 = 48.0;
const TALLEST_BAR: f64 = 220.0;

/// What one panel shows of each pair.
pub struct Layer<'a> {
    pub title: String,
    /// What grey and hatching mean.
    pub never: String,
    pub now: String,
    pub values: &'a [f64],
    pub shown: &'a [bool],
    /// The state whose pairs are hatched.
    pub state: u8,
}

impl Layer<'_> {
    /// The values shown, from the smallest to the largest.
    fn sorted(&self) -> Vec<f64> {
        let shown = self.values.iter().zip(self.shown).filter(|(value, shown)| **shown && value.is_finite());
        let mut values: Vec<f64> = shown.map(|(value, _)| *value).collect();
        values.sort_by(f64::total_cmp);
        values
    }
}

/// One panel with its sheets from `at` on; returns what it shows.
pub fn panel(
    svg: &mut Svg,
    at: (f64, f64),
    above: f64,
    layout: &Layout,
    sheets: &[Sheet],
    surface: &PairSurface,
    layer: &Layer,
    (language, scale): (Language, &Scale),
) -> String {
    let sorted = layer.sorted();
    let most = sorted.last().copied().unwrap_or(0.0).max(0.0);
    let range = (0.0, if most > 0.0 { most } else { 1.0 });
    let mut grey = Vec::new();
    let mut levels: Vec<Vec<Vec<(f64, f64)>>> = vec![Vec::new(); LEVELS];
    let mut hatched = Vec::new();
    let (mut outlines, mut creases) = (Vec::new(), Vec::new());
    for (k, sheet) in sheets.iter().enumerate() {
        let place = |p: &[f64; 2]| {
            let (x, y) = layout.place(k, *p);
            (at.0 + x, at.1 + y)
        };
        for face in &sheet.faces {
            let corners: Vec<(f64, f64)> = face.corners.iter().map(place).collect();
            let class: Vec<Option<usize>> = face
                .points
                .iter()
                .map(|&p| layer.shown[p as usize].then(|| level(layer.values[p as usize], range)))
                .collect();
            let mut keep = |class: Option<usize>, outline| match class {
                Some(level) => levels[level].push(outline),
                None => grey.push(outline),
            };
            if class.iter().all(|c| *c == class[0]) {
                keep(class[0], corners.clone());
            } else {
                class.iter().enumerate().for_each(|(i, c)| keep(*c, share(&corners, i)));
            }
            for (i, &p) in face.points.iter().enumerate() {
                if surface.state[p as usize] == layer.state {
                    hatch(&share(&corners, i), &mut hatched);
                }
            }
        }
        outlines.extend(sheet.outline.iter().map(|edge| edge.iter().map(place).collect::<Vec<_>>()));
        creases.extend(sheet.creases.iter().map(|edge| edge.iter().map(place).collect::<Vec<_>>()));
    }
    svg.areas(GREY, &grey);
    for (level, outlines) in levels.iter().enumerate().filter(|(_, outlines)| !outlines.is_empty()) {
        svg.areas(&colour(level), outlines);
    }
    if !hatched.is_empty() {
        svg.hatching(&hatched);
    }
    svg.borders(&outlines);
    svg.borders(&creases);
    let title = scale.labelled(&layer.title);
    let line = at.1 - above + 16.0;
    svg.text((at.0, line), Anchor::Start, 13.0, Style::Bold, &title);
    let remark = say!(
        language,
        "up to {most} (median {half})",
        most = scale.quantity(most),
        half = scale.quantity(sorted.get(sorted.len().saturating_sub(1) / 2).copied().unwrap_or(0.0))
    );
    svg.text((at.0 + text_width(&title, 13.0) + 30.0, line), Anchor::Start, 12.0, Style::Muted, &remark);
    let left = at.0 + layout.bar_at();
    // The key below it wants two lines.
    let bar = (layout.size.1 - 44.0).clamp(40.0, TALLEST_BAR);
    colours::bar(svg, (left, at.1), bar, (0.0, range.1 * scale.factor), false);
    let mut below = at.1 + bar + 14.0;
    for (name, shown, lined) in
        [(&layer.never, !grey.is_empty(), false), (&layer.now, !hatched.is_empty(), true)]
    {
        if shown {
            let swatch =
                vec![(left, below), (left + 16.0, below), (left + 16.0, below + 12.0), (left, below + 12.0)];
            svg.areas(GREY, std::slice::from_ref(&swatch));
            if lined {
                let mut lines = Vec::new();
                hatch(&swatch, &mut lines);
                svg.hatching(&lines);
            }
            svg.text((left + 20.0, below + 10.0), Anchor::Start, 11.5, Style::Muted, name);
            below += 20.0;
        }
    }
    format!("{} {remark}", layer.title)
}

/// The part of a face that belongs to one of its corners, up to the middles of its edges.
fn share(corners: &[(f64, f64)], i: usize) -> Vec<(f64, f64)> {
    let n = corners.len();
    let middle = |a: (f64, f64), b: (f64, f64)| (0.5 * (a.0 + b.0), 0.5 * (a.1 + b.1));
    let sum = corners.iter().fold((0.0, 0.0), |s, c| (s.0 + c.0, s.1 + c.1));
    let (before, after) = (corners[(i + n - 1) % n], corners[(i + 1) % n]);
    let centre = (sum.0 / n as f64, sum.1 / n as f64);
    vec![corners[i], middle(corners[i], after), centre, middle(corners[i], before)]
}

/// Lines at 45° across a convex outline, on one grid all over the figure.
fn hatch(outline: &[(f64, f64)], lines: &mut Vec<Vec<(f64, f64)>>) {
    let height = |p: &(f64, f64)| (p.0 + p.1) / HATCH;
    let low = outline.iter().map(height).fold(f64::INFINITY, f64::min);
    let high = outline.iter().map(height).fold(f64::NEG_INFINITY, f64::max);
    for k in (low.ceil() as i64)..=(high.floor() as i64) {
        let level = k as f64;
        let mut ends = Vec::with_capacity(2);
        for (a, b) in outline.iter().zip(outline.iter().cycle().skip(1)) {
            let (from, to) = (height(a), height(b));
            if (from < level) != (to < level) {
                let s = (level - from) / (to - from);
                ends.push((a.0 + s * (b.0 - a.0), a.1 + s * (b.1 - a.1)));
            }
        }
        if ends.len() == 2 {
            lines.push(ends);
        }
    }
}

/// Axes, names and parts around the sheets of a panel.
pub fn frame(
    svg: &mut Svg,
    language: Language,
    at: (f64, f64),
    layout: &Layout,
    sheets: &[Sheet],
    labels: &[String],
) {
    let bottom = at.1 + layout.size.1;
    // Where names stand above the sheets, from and to.
    let mut named: Vec<(f64, f64)> = Vec::new();
    for (k, (sheet, spot)) in sheets.iter().zip(&layout.spots).enumerate() {
        let (from, to) = (layout.place(k, [spot.u[0], -spot.s[0]]), layout.place(k, [spot.u[0], -spot.s[1]]));
        let mut parts = marks(language, sheet);
        // A plane is measured from its edge, a lining from its crown.
        let zero = if sheet.wraps { 0.0 } else { spot.s[1] };
        let around = if sheet.wraps { (spot.s[0], spot.s[1]) } else { (0.0, spot.s[1] - spot.s[0]) };
        let along = if sheet.wraps { (spot.u[0], spot.u[1]) } else { (0.0, spot.u[1] - spot.u[0]) };
        let length = |(low, high): (f64, f64)| (high - low) * layout.zoom;
        let s_of = |value: f64| if sheet.wraps { value } else { zero - value };
        let u_of = |value: f64| if sheet.wraps { value } else { spot.u[0] + value };
        let ticks_s = Ticks::within(around.0, around.1, (length(around) / 45.0).max(1.0) as usize);
        let ticks_u = Ticks::within(along.0, along.1, (length(along) / 60.0).max(1.0) as usize);
        let label = &labels[k];
        if layout.upright {
            svg.rule((at.0 + from.0, bottom + 4.0), (at.0 + to.0, bottom + 4.0), true);
            for (value, text) in &ticks_s.marks {
                let x = at.0 + layout.place(k, [spot.u[0], -s_of(*value)]).0;
                svg.rule((x, bottom + 4.0), (x, bottom + 9.0), true);
                svg.text((x, bottom + 22.0), Anchor::Middle, 12.0, Style::Muted, text);
            }
            svg.text((at.0 + from.0, at.1 - 8.0 - ROW), Anchor::Start, 12.5, Style::Plain, label);
            // From the crown outwards, as far as there is room.
            parts.sort_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
            for (name, s) in parts {
                let x = at.0 + layout.place(k, [spot.u[0], -s]).0;
                let half = 0.5 * text_width(&name, 12.0) + 3.0;
                if named.iter().all(|(from, to)| x + half < *from || x - half > *to) {
                    named.push((x - half, x + half));
                    svg.text((x, at.1 - 7.0), Anchor::Middle, 12.0, Style::Muted, &name);
                }
            }
            if k == 0 {
                for (value, text) in &ticks_u.marks {
                    let y = at.1 + layout.place(k, [u_of(*value), 0.0]).1;
                    svg.rule((at.0 - 9.0, y), (at.0 - 4.0, y), true);
                    svg.text((at.0 - 13.0, y + 4.0), Anchor::End, 12.0, Style::Muted, text);
                }
            }
        } else {
            svg.rule((at.0 - 4.0, at.1 + from.1), (at.0 - 4.0, at.1 + to.1), true);
            for (value, text) in &ticks_s.marks {
                let y = at.1 + layout.place(k, [spot.u[0], -s_of(*value)]).1;
                svg.rule((at.0 - 9.0, y), (at.0 - 4.0, y), true);
                svg.text((at.0 - 13.0, y + 4.0), Anchor::End, 12.0, Style::Muted, text);
            }
            svg.text((at.0, at.1 + from.1 - 8.0), Anchor::Start, 12.5, Style::Plain, label);
            for (name, s) in parts {
                let (x, y) = layout.place(k, [spot.u[1], -s]);
                svg.text((at.0 + x + 8.0, at.1 + y + 4.0), Anchor::Start, 12.0, Style::Muted, &name);
            }
            if k + 1 == sheets.len() {
                for (value, text) in &ticks_u.marks {
                    let x = at.0 + layout.place(k, [u_of(*value), 0.0]).0;
                    svg.rule((x, bottom + 4.0), (x, bottom + 9.0), true);
                    svg.text((x, bottom + 22.0), Anchor::Middle, 12.0, Style::Muted, text);
                }
            }
        }
    }
    for (k, sheet) in sheets.iter().enumerate() {
        for middle in end_walls(sheet) {
            let (x, y) = layout.place(k, middle);
            svg.note((at.0 + x, at.1 + y), &say!(language, "end of the lining"));
        }
    }
    let (along, around) = axis_words(language, sheets);
    let (below, beside) = if layout.upright { (around, along) } else { (along, around) };
    // Of a lining whose axis lies across, right is below.
    let arrow = if layout.upright || sheets.iter().all(|sheet| !sheet.wraps) { '↑' } else { '↓' };
    let words = format!("→ {below} (m)   {arrow} {beside} (m)");
    let left = if layout.upright { at.0 - LEFT + 8.0 } else { at.0 };
    let room = layout.size.0 + BAR;
    let size = if text_width(&words, 12.0) > room { 11.0 } else { 12.0 };
    svg.text((left, bottom + 40.0), Anchor::Start, size, Style::Muted, &words);
}

/// What the two directions of sheets are.
fn axis_words(language: Language, sheets: &[Sheet]) -> (String, String) {
    if sheets.iter().all(|sheet| !sheet.wraps) {
        return (say!(language, "along the strike"), say!(language, "up the dip"));
    }
    let first = sheets[0].axis;
    let same = sheets.iter().all(|sheet| (0..3).all(|i| (sheet.axis[i] - first[i]).abs() < 1e-6));
    let along = if same {
        say!(language, "along {axis}", axis = direction(first))
    } else {
        say!(language, "along the axis")
    };
    (along, say!(language, "around, from the crown"))
}
