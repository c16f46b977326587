//! Small multiples: each history alone, in ink over the range of all, where one panel would be a tangle.

use std::collections::{BTreeMap, HashMap};

use crate::drawing::axes::{Axes, drawable};
use crate::drawing::chart::{Curve, Panel};
use crate::drawing::svg::{Anchor, Style, Svg, text_width};
use crate::drawing::thinning::thin;
use crate::drawing::ticks::Ticks;
use crate::language::{Language, say};
use crate::quantities::scale::moment;

const WIDTH: f64 = 940.0;
/// Between the left edge of a column and its axis, at least: the numbers.
const LEFT: f64 = 46.0;
const RIGHT: f64 = 10.0;
/// Room for the headings of the columns.
const HEADING: f64 = 26.0;
/// Room above a cell for its name and its marked value.
const NAME: f64 = 18.0;
/// With six rows half a page of paper.
const CELL: f64 = 57.0;
/// The dark one, light on a dark page.
const INK: usize = 3;

/// A cell: which panel's axes and range, and the line.
pub type PanelLine<'a> = (&'a Panel<'a>, &'a Curve<'a>);

/// A figure of cells in rows.
pub struct Multiples<'a> {
    pub title: &'a str,
    /// Times (s), ascending.
    pub time: &'a [f64],
    /// Cells abreast; one that is not there leaves its place empty.
    pub rows: Vec<Vec<Option<PanelLine<'a>>>>,
}

impl Multiples<'_> {
    /// The figure as SVG. Every panel has the same axes in all its cells.
    pub fn draw(&self, language: Language) -> String {
        let mut svg = Svg::new(WIDTH);
        let columns = self.rows.iter().map(Vec::len).max().unwrap_or(1).max(1);
        let width = WIDTH / columns as f64;
        // Worked out once a panel, of which any number of lines are cells.
        let mut ups: HashMap<*const Panel<'_>, Ticks> = HashMap::new();
        for &(panel, _) in self.rows.iter().flatten().flatten() {
            ups.entry(panel).or_insert_with(|| ticks(panel));
        }
        let labels = ups.values().flat_map(|up| &up.marks);
        let indent = labels.map(|(_, label)| text_width(label, 12.0) + 11.0).fold(LEFT, f64::max);
        let finite = || self.time.iter().copied().filter(|t| drawable(*t));
        let (from, to) = (finite().fold(f64::INFINITY, f64::min), finite().fold(f64::NEG_INFINITY, f64::max));
        let across = Ticks::within(from, to, (width / 75.0) as usize);
        let mut ranges: HashMap<(*const Panel<'_>, usize), Vec<(f64, f64)>> = HashMap::new();
        let mut said = Vec::new();
        let mut headed: Vec<Option<&str>> = vec![None; columns];
        let mut top = 0.0;
        for row in &self.rows {
            // A heading where a column begins with another quantity.
            let news = |k: usize, cell: &Option<PanelLine<'_>>| {
                cell.as_ref().is_some_and(|(panel, _)| headed[k] != Some(panel.title.as_str()))
            };
            if row.iter().enumerate().any(|(k, cell)| news(k, cell)) {
                for (k, (panel, _)) in row.iter().enumerate().filter_map(|(k, c)| Some((k, c.as_ref()?))) {
                    headed[k] = Some(&panel.title);
                    // Lines abreast of one panel have one heading.
                    if k > 0 && headed[k - 1] == headed[k] {
                        continue;
                    }
                    let heading = panel.scale.labelled(&panel.title);
                    svg.text(
                        (k as f64 * width + indent, top + 16.0),
                        Anchor::Start,
                        13.0,
                        Style::Bold,
                        &heading,
                    );
                }
                top += HEADING;
            }
            for (k, cell) in row.iter().enumerate() {
                let Some(cell) = cell else { continue };
                let left = k as f64 * width;
                let axes = Axes {
                    left: left + indent,
                    right: left + width - RIGHT,
                    top: 0.0,
                    bottom: CELL,
                    across: across.clone(),
                    up: ups[&std::ptr::from_ref(cell.0)].clone(),
                };
                let below = top + NAME;
                let range = ranges.entry((cell.0, k)).or_insert_with(|| range(self.time, cell.0, &axes));
                svg.veil(&range.iter().map(|(x, y)| (*x, y + below)).collect::<Vec<_>>());
                let axes = Axes { top: below, bottom: below + CELL, ..axes };
                said.extend(self.cell(&mut svg, cell, &axes, language));
            }
            top += NAME + CELL;
        }
        for k in 0..columns {
            for (t, label) in &across.marks {
                let x = k as f64 * width + indent + across.fraction(*t) * (width - indent - RIGHT);
                svg.text((x, top + 16.0), Anchor::Middle, 12.0, Style::Muted, label);
            }
        }
        // True of the drawing alone, so not of the figure's caption: the page's script shows lines together.
        let alone = say!(language, "Each line stands alone; grey is the range of all of them.");
        svg.text((indent, top + 33.0), Anchor::Start, 12.0, Style::Muted, &alone);
        svg.text((WIDTH - RIGHT, top + 33.0), Anchor::End, 12.0, Style::Muted, &say!(language, "time (s)"));
        svg.finish(top + 41.0, self.title, &said.join(&say!(language, "; ")))
    }

    /// One cell; returns what its marked point is, in words, if it has one.
    fn cell(
        &self,
        svg: &mut Svg,
        (panel, line): &PanelLine<'_>,
        axes: &Axes,
        language: Language,
    ) -> Option<String> {
        axes.draw(svg);
        svg.text((axes.left, axes.top - 6.0), Anchor::Start, 12.0, Style::Bold, &line.name);
        let shown = |x: f64| if drawable(x) { x } else { f64::NAN };
        let points = self.time.iter().zip(line.values.iter());
        let points = points.map(|(&t, &x)| axes.point(shown(t), shown(x) * panel.scale.factor));
        svg.lines(INK, 1.2, &thin(points, 0.2));
        let (time, value) = panel.mark.of(self.time, line)?;
        let at = moment(time, self.time.last().copied().unwrap_or(f64::NAN));
        let remark = say!(language, "{value} at {time}\u{a0}s", value = panel.scale.number(value), time = at);
        let room = axes.right - axes.left - text_width(&line.name, 12.5) - text_width(&remark, 12.0);
        let y = if room > 8.0 { axes.top - 6.0 } else { axes.top + 12.0 };
        svg.text((axes.right, y), Anchor::End, 12.0, Style::Muted, &remark);
        svg.ring(axes.point(time, value * panel.scale.factor), INK);
        Some(format!("{}{}{remark}", line.name, say!(language, ": ")))
    }
}

fn ticks(panel: &Panel<'_>) -> Ticks {
    let (low, high) = panel.range();
    Ticks::around(low * panel.scale.factor, high * panel.scale.factor, 4)
}

/// The area between the lowest and the highest of a panel's lines, to a unit of the figure.
fn range(time: &[f64], panel: &Panel<'_>, axes: &Axes) -> Vec<(f64, f64)> {
    let mut bins: BTreeMap<i64, (f64, f64)> = BTreeMap::new();
    for line in &panel.lines {
        for (&t, &x) in time.iter().zip(line.values.iter()).filter(|(t, x)| drawable(**t) && drawable(**x)) {
            let (x, y) = axes.point(t, x * panel.scale.factor);
            let bin = bins.entry(x.floor() as i64).or_insert((y, y));
            *bin = (bin.0.min(y), bin.1.max(y));
        }
    }
    let upper = bins.iter().map(|(x, (y, _))| (*x as f64, *y));
    let lower = bins.iter().rev().map(|(x, (_, y))| (*x as f64, *y));
    upper.chain(lower).collect()
}
