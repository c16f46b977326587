//! Histories drawn in panels one above the other, over one time axis.

use std::borrow::Cow;

use serde::Serialize;

use crate::drawing::axes::{Axes, drawable};
use crate::drawing::plot::WIDTH;
use crate::drawing::svg::{Anchor, LINES, Style, Svg, text_width};
use crate::drawing::thinning::thin;
use crate::drawing::ticks::Ticks;
use crate::language::{Language, say};
use crate::quantities::scale::{Scale, moment};

const LEFT: f64 = 56.0;
const RIGHT: f64 = 16.0;
/// Of all panels of a figure that is narrow.
const NARROW_HEIGHT: f64 = 340.0;
/// Room for a panel's heading.
const HEADING: f64 = 32.0;

/// How a line is drawn: where several lie on one another, all are to be seen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Stroke {
    #[default]
    Thin,
    /// Under thin ones.
    Broad,
    /// Over thin ones.
    Dashed,
}

impl Stroke {
    /// Width and colour as [`Svg::lines`] takes them.
    fn pen(self, colour: usize) -> (f64, usize) {
        match self {
            Stroke::Thin => (1.3, colour),
            Stroke::Broad => (4.2, colour),
            Stroke::Dashed => (1.3, colour % LINES.len() + LINES.len()),
        }
    }
}

/// One line of a panel.
pub struct Curve<'a> {
    pub name: String,
    /// In SI, one value for each time.
    pub values: Cow<'a, [f64]>,
    /// Which colour; lines of one name have the same in all panels.
    pub colour: usize,
    /// Lines of one name have the same in all panels.
    pub stroke: Stroke,
}

/// Which point of a panel's lines is marked and named.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mark {
    Largest,
    Highest,
    Lowest,
    /// None: the files hold no such number.
    Nothing,
}

impl Mark {
    /// Of two values the one to be marked ranks higher.
    fn rank(self, value: f64) -> f64 {
        match self {
            Mark::Largest | Mark::Nothing => value.abs(),
            Mark::Highest => value,
            Mark::Lowest => -value,
        }
    }

    /// Time and value of the point of a line that is marked; of equal ones the first.
    pub fn of(self, time: &[f64], line: &Curve<'_>) -> Option<(f64, f64)> {
        if self == Mark::Nothing {
            return None;
        }
        let points = time.iter().copied().zip(line.values.iter().copied());
        let points = points.filter(|(t, x)| drawable(*t) && drawable(*x));
        points.reduce(|best, next| if self.rank(next.1) > self.rank(best.1) { next } else { best })
    }
}

/// One set of axes.
pub struct Panel<'a> {
    pub title: String,
    pub scale: Scale,
    pub lines: Vec<Curve<'a>>,
    pub mark: Mark,
}

/// A figure of one or more panels.
pub struct Chart<'a> {
    pub title: String,
    /// Times (s), ascending.
    pub time: &'a [f64],
    pub panels: Vec<Panel<'a>>,
}

/// The marked point: line, time, value.
pub struct Peak<'a> {
    pub line: &'a Curve<'a>,
    pub time: f64,
    pub value: f64,
}

impl Panel<'_> {
    /// The point to be marked; none if no value is finite.
    pub fn peak(&self, time: &[f64]) -> Option<Peak<'_>> {
        let peaks = self.lines.iter().filter_map(|line| {
            let (time, value) = self.mark.of(time, line)?;
            Some(Peak { line, time, value })
        });
        peaks.reduce(
            |best, next| if self.mark.rank(next.value) > self.mark.rank(best.value) { next } else { best },
        )
    }

    /// The smallest and the largest value of all lines, in SI.
    pub fn range(&self) -> (f64, f64) {
        let finite = self.lines.iter().flat_map(|line| line.values.iter().copied()).filter(|x| drawable(*x));
        finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)))
    }
}

impl Chart<'_> {
    /// The figure as SVG.
    pub fn draw(&self, language: Language) -> String {
        self.draw_at(language, WIDTH)
    }

    /// The figure as SVG of another width.
    pub fn draw_at(&self, language: Language, width: f64) -> String {
        let mut svg = Svg::new(width);
        let height = match self.panels.len() {
            // Beside others on a sheet it is as tall whatever it shows.
            number if width < WIDTH => (NARROW_HEIGHT / number.max(1) as f64 - HEADING).clamp(56.0, 270.0),
            0 | 1 => 270.0,
            2 => 200.0,
            _ => 158.0,
        };
        let finite = || self.time.iter().copied().filter(|t| drawable(*t));
        let across = Ticks::within(
            finite().fold(f64::INFINITY, f64::min),
            finite().fold(f64::NEG_INFINITY, f64::max),
            if width < WIDTH { 6 } else { 10 },
        );
        let mut top = self.legend(&mut svg, width) - 4.0;
        for panel in &self.panels {
            self.panel(&mut svg, panel, (&across, width), (top + HEADING, height), language);
            top += HEADING + height;
        }
        for (t, label) in &across.marks {
            let x = LEFT + across.fraction(*t) * (width - LEFT - RIGHT);
            svg.text((x, top + 17.0), Anchor::Middle, 12.0, Style::Muted, label);
        }
        svg.text((width - RIGHT, top + 34.0), Anchor::End, 12.0, Style::Muted, &say!(language, "time (s)"));
        let description = self
            .panels
            .iter()
            .map(|panel| self.remark(panel, language))
            .collect::<Vec<_>>()
            .join(&say!(language, "; "));
        svg.finish(top + 42.0, &self.title, &description)
    }

    /// Names and colours above the panels, in rows; returns where the rows end.
    fn legend(&self, svg: &mut Svg, whole: f64) -> f64 {
        let mut entries: Vec<(&str, usize, Stroke)> = Vec::new();
        for line in self.panels.iter().flat_map(|panel| &panel.lines) {
            if !entries.iter().any(|(name, ..)| *name == line.name) {
                entries.push((&line.name, line.colour, line.stroke));
            }
        }
        let (mut x, mut y) = (LEFT, 14.0);
        for (name, colour, stroke) in entries {
            let width = 28.0 + text_width(name, 13.0) + 20.0;
            if x + width > whole && x > LEFT {
                (x, y) = (LEFT, y + 20.0);
            }
            let (pen, colour) = stroke.pen(colour);
            svg.lines(colour, pen.max(2.4), &[vec![(x, y - 4.5), (x + 22.0, y - 4.5)]]);
            svg.text((x + 28.0, y), Anchor::Start, 13.0, Style::Plain, name);
            x += width;
        }
        y + 4.0
    }

    fn panel(
        &self,
        svg: &mut Svg,
        panel: &Panel<'_>,
        (across, width): (&Ticks, f64),
        (top, height): (f64, f64),
        language: Language,
    ) {
        let bottom = top + height;
        let (low, high) = panel.range();
        let up = Ticks::around(
            low * panel.scale.factor,
            high * panel.scale.factor,
            (height / 38.0).max(2.0) as usize,
        );
        let axes = Axes { left: LEFT, right: width - RIGHT, top, bottom, across: across.clone(), up };
        axes.draw(svg);
        svg.text((LEFT, top - 8.0), Anchor::Start, 13.0, Style::Bold, &panel.scale.labelled(&panel.title));
        // Beside the title where there is room for both.
        let remark = self.remark(panel, language);
        let title = text_width(&panel.scale.labelled(&panel.title), 13.0);
        if 1.1 * title + text_width(&remark, 12.0) < width - LEFT - RIGHT {
            svg.text((width - RIGHT, top - 8.0), Anchor::End, 12.0, Style::Muted, &remark);
        }
        for line in &panel.lines {
            let shown = |x: f64| if drawable(x) { x } else { f64::NAN };
            let points = self.time.iter().zip(line.values.iter());
            let points = points.map(|(&t, &x)| axes.point(shown(t), shown(x) * panel.scale.factor));
            let (pen, colour) = line.stroke.pen(line.colour);
            svg.lines(colour, pen, &thin(points, 0.2));
        }
        if let Some(peak) = panel.peak(self.time) {
            svg.ring(axes.point(peak.time, peak.value * panel.scale.factor), peak.line.colour);
        }
    }

    /// Names the marked point of a panel.
    pub fn remark(&self, panel: &Panel<'_>, language: Language) -> String {
        if panel.mark == Mark::Nothing {
            return String::new();
        }
        let Some(peak) = panel.peak(self.time) else { return say!(language, "no values") };
        let duration = self.time.last().copied().unwrap_or(f64::NAN);
        let (name, value, time) =
            (&peak.line.name, panel.scale.quantity(peak.value), moment(peak.time, duration));
        match panel.mark {
            Mark::Largest | Mark::Nothing => {
                say!(
                    language,
                    "largest: {name}, {value} at {time}\u{a0}s",
                    name = name,
                    value = value,
                    time = time
                )
            }
            Mark::Highest => {
                say!(
                    language,
                    "highest: {name}, {value} at {time}\u{a0}s",
                    name = name,
                    value = value,
                    time = time
                )
            }
            Mark::Lowest => {
                say!(
                    language,
                    "lowest: {name}, {value} at {time}\u{a0}s",
                    name = name,
                    value = value,
                    time = time
                )
            }
        }
    }
}
