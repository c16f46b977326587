//! Shear over pressure at a pair, row by row, in the colours of its states.

use crate::drawing::axes::{Axes, drawable};
use crate::drawing::svg::{Anchor, Style, Svg, text_width};
use crate::drawing::ticks::Ticks;
use crate::language::{Language, say};
use crate::quantities::scale::Scale;

const WIDTH: f64 = 940.0;
const LEFT: f64 = 56.0;
const RIGHT: f64 = 16.0;
const TOP: f64 = 56.0;
const HEIGHT: f64 = 330.0;

/// The drawing before it is made. Stresses in Pa.
pub struct Path<'a> {
    pub language: Language,
    pub title: String,
    pub pressure: &'a [f64],
    pub shear: &'a [f64],
    /// Of both, so that the slope of friction is seen.
    pub scale: Scale,
    /// Which of the states a row has.
    pub state: &'a dyn Fn(usize) -> Option<usize>,
    /// Name and colour.
    pub states: &'a [(String, usize)],
}

impl Path<'_> {
    /// The figure as SVG.
    pub fn draw(&self) -> String {
        let mut svg = Svg::new(WIDTH);
        svg.text((LEFT, 16.0), Anchor::Start, 14.0, Style::Bold, &self.title);
        let ends = |values: &[f64]| {
            let all = values.iter().copied().filter(|x| drawable(*x));
            all.fold((0.0, 0.0), |(low, high), x| (f64::min(low, x), f64::max(high, x)))
        };
        let (p, q) = (ends(self.pressure), ends(self.shear));
        let scale = &self.scale;
        let ticks =
            |(low, high): (f64, f64), wanted| Ticks::around(low * scale.factor, high * scale.factor, wanted);
        let axes = Axes {
            left: LEFT,
            right: WIDTH - RIGHT,
            top: TOP,
            bottom: TOP + HEIGHT,
            across: ticks(p, 10),
            up: ticks(q, 6),
        };
        axes.draw(&mut svg);
        axes.number_across(&mut svg);
        let label = scale.labelled(&say!(self.language, "|shear|"));
        svg.text((LEFT, TOP - 9.0), Anchor::Start, 13.0, Style::Bold, &label);
        let mut x = LEFT + text_width(&label, 13.0) + 24.0;
        let label = scale.labelled(&say!(self.language, "pressure, compression positive"));
        svg.text((WIDTH - RIGHT, axes.bottom + 34.0), Anchor::End, 12.0, Style::Muted, &label);
        let mut words = Vec::new();
        for (k, (name, colour)) in self.states.iter().enumerate() {
            let rows = (0..self.shear.len()).filter(|row| (self.state)(*row) == Some(k));
            let points: Vec<(f64, f64)> = rows
                .filter_map(|row| Some((*self.pressure.get(row)?, self.shear[row])))
                .filter(|(p, q)| drawable(*p) && drawable(*q))
                .map(|(p, q)| axes.point(p * scale.factor, q * scale.factor))
                .collect();
            if points.is_empty() {
                continue;
            }
            svg.dots(*colour, &points);
            svg.dots(*colour, &[(x, TOP - 13.5)]);
            svg.text((x + 8.0, TOP - 9.0), Anchor::Start, 12.0, Style::Plain, name);
            x += 8.0 + text_width(name, 12.0) + 18.0;
            words.push(say!(self.language, "{name} in {rows} rows", name = name, rows = points.len()));
        }
        svg.finish(axes.bottom + 42.0, &self.title, &words.join(&say!(self.language, "; ")))
    }
}
