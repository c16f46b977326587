//! What part of a plane (x, z) is seen.

/// A rectangle in (x, z), in m.
#[derive(Clone, Debug, PartialEq)]
pub struct Window {
    pub low: [f64; 2],
    pub high: [f64; 2],
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

    /// Its width and height, more than nothing.
    pub fn size(&self) -> [f64; 2] {
        [0, 1].map(|i| (self.high[i] - self.low[i]).max(1e-9))
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
