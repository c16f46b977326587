//! Series at the heights that a model asks for.
//!
//! Meshes have their nodes and the points of their faces at some heights, often the same for many. There the cubics upwards are the same at
//! all times, so what they come to is kept, and to ask costs a quarter of what it does anywhere else.

use super::series::Series;

/// Numbers kept of a value at a sample: it, and its slope in time times the interval.
const KEPT: usize = 2;

/// What a wave does at some heights: displacements, or stresses.
pub struct AtHeights {
    /// Between samples, and of the first one \[s\].
    dt: f64,
    start: f64,
    samples: usize,
    /// Of V components each.
    kept: Vec<f32>,
}

/// Which of the heights, rising, one is, to a part in 10⁹ of `size`; none if none.
pub fn find(heights: &[f64], height: f64, size: f64) -> Option<usize> {
    let near = 1e-9 * size;
    let at = heights.partition_point(|h| *h < height - near);
    (at < heights.len() && heights[at] <= height + near).then_some(at)
}

/// Bytes that they take.
pub fn bytes(heights: usize, samples: usize, components: usize) -> usize {
    4 * heights * samples * components * KEPT
}

impl AtHeights {
    /// Of a wave's series at heights \[m\] above the base, rising: its displacements, or its stresses.
    pub fn of(series: &Series, heights: &[f64], stresses: bool) -> AtHeights {
        let kept = heights.iter().flat_map(|&height| series.column(height, stresses)).collect();
        AtHeights { dt: series.dt(), start: series.start, samples: series.samples(), kept }
    }

    /// Components at one of the heights, by its number.
    pub fn at<const V: usize>(&self, number: usize, time: f64) -> [f64; V] {
        let place = (time - self.start) / self.dt;
        if place.is_nan() || place <= 0.0 {
            return [0.0; V];
        }
        let sample = (place as usize).min(self.samples - 2);
        let x = (place - sample as f64).min(1.0);
        let y = 1.0 - x;
        let weights = [y * y * (1.0 + 2.0 * x), x * y * y, x * x * (3.0 - 2.0 * x), -x * x * y];
        let row = V * KEPT;
        let at = (number * self.samples + sample) * row;
        let two = &self.kept[at..at + 2 * row];
        std::array::from_fn(|c| {
            let [f, ft, g, gt] =
                [two[2 * c], two[2 * c + 1], two[row + 2 * c], two[row + 2 * c + 1]].map(f64::from);
            weights[0] * f + weights[1] * ft + weights[2] * g + weights[3] * gt
        })
    }

    /// What it takes of memory.
    pub fn bytes(&self) -> usize {
        4 * self.kept.len()
    }
}
