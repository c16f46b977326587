//! A pair of axes: their grid, and where a point lies between them.

use crate::drawing::svg::{Anchor, Style, Svg};
use crate::drawing::ticks::Ticks;

/// A rectangle of a figure with an axis along each direction.
pub struct Axes {
    pub left: f64,
    pub right: f64,
    pub top: f64,
    pub bottom: f64,
    pub across: Ticks,
    pub up: Ticks,
}

/// Whether a value can be drawn. Those of a run that has diverged may be finite and yet beyond any axis.
pub fn drawable(x: f64) -> bool {
    x.abs() < 1e100
}

impl Axes {
    /// Where the point of these two values lies in the figure.
    pub fn point(&self, x: f64, y: f64) -> (f64, f64) {
        (
            self.left + self.across.fraction(x) * (self.right - self.left),
            self.bottom - self.up.fraction(y) * (self.bottom - self.top),
        )
    }

    /// The grid, the lines of both axes and of their zeros, and the numbers of the upright one.
    pub fn draw(&self, svg: &mut Svg) {
        for (value, label) in &self.up.marks {
            let (_, y) = self.point(0.0, *value);
            svg.rule((self.left, y), (self.right, y), *value == 0.0);
            svg.text((self.left - 7.0, y + 4.0), Anchor::End, 12.0, Style::Muted, label);
        }
        for (value, _) in &self.across.marks {
            let (x, _) = self.point(*value, 0.0);
            svg.rule((x, self.top), (x, self.bottom), *value == 0.0);
        }
        svg.rule((self.left, self.top), (self.left, self.bottom), true);
        svg.rule((self.left, self.bottom), (self.right, self.bottom), true);
    }

    /// The numbers of the axis below.
    pub fn number_across(&self, svg: &mut Svg) {
        for (value, label) in &self.across.marks {
            let (x, _) = self.point(*value, 0.0);
            svg.text((x, self.bottom + 17.0), Anchor::Middle, 12.0, Style::Muted, label);
        }
    }
}
