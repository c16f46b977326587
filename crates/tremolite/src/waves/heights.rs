//! Series at the heights that a model asks for.
//!
//! Meshes have their nodes and the points of their faces at some heights, often the same for many. There the cubics upwards are the same at
//! all times, so what they come to is kept, and to ask costs a quarter of what it does anywhere else.

use super::series::Series;

/// Numbers kept of a value at a sample: it, and its slope in time times the interval.
const KEPT: usize = 2;

/// What a wave does at some heights: displacements, or stresses.
pub struct AtHeights {
    /// Samples a second, and the time of the first \[s\].
    rate: f64,
    start: f64,
    samples: usize,
    /// Height after height, sample after sample, the V components and then their V slopes.
    kept: Vec<f32>,
}

/// Heights \[m\] above the base, to be found among: each place of a boundary asks in every step.
pub struct Heights {
    /// Rising.
    all: Vec<f64>,
    /// By how much one may differ \[m\].
    near: f64,
    /// Bins of equal height \[1/m\] from the lowest on, and for each which height is the first that may be in it or above.
    per_metre: f64,
    first: Vec<u32>,
}

impl Heights {
    /// Of heights in any order; those that differ by a part in 10⁹ of `size` are one.
    pub fn new(mut all: Vec<f64>, size: f64) -> Heights {
        let near = 1e-9 * size;
        all.sort_by(f64::total_cmp);
        all.dedup_by(|a, b| *a - *b <= near);
        let (low, high) = (all.first().copied().unwrap_or(0.0), all.last().copied().unwrap_or(0.0));
        let bins = 4 * all.len().max(1);
        let per_metre = if high > low { bins as f64 / (high - low) } else { 0.0 };
        // From the bin below on, so that round-off at the border of two hides none.
        let from = |bin: usize| low + (bin as f64 - 1.0) / per_metre - near;
        let first = |bin: usize| match per_metre > 0.0 {
            true => all.partition_point(|h| *h < from(bin)) as u32,
            false => 0,
        };
        let first = (0..=bins).map(first).collect();
        Heights { all, near, per_metre, first }
    }

    /// Rising.
    pub fn all(&self) -> &[f64] {
        &self.all
    }

    /// The number of a height; none if it is none of them.
    pub fn find(&self, height: f64) -> Option<usize> {
        let above = (height - self.all.first()?) * self.per_metre;
        let bin = (above.max(0.0) as usize).min(self.first.len() - 1);
        let mut at = self.first[bin] as usize;
        while *self.all.get(at)? < height - self.near {
            at += 1;
        }
        (self.all[at] <= height + self.near).then_some(at)
    }
}

/// Bytes that they take.
pub fn bytes(heights: usize, samples: usize, components: usize) -> usize {
    4 * heights * samples * components * KEPT
}

impl AtHeights {
    /// Of a wave's series at heights \[m\] above the base, rising: its displacements, or its stresses.
    pub fn of(series: &Series, heights: &[f64], stresses: bool) -> AtHeights {
        // Room for all at once: a vector that grows would take up to twice as much while it does.
        let mut kept =
            Vec::with_capacity(heights.len() * series.samples() * KEPT * series.components(stresses));
        heights.iter().for_each(|&height| series.column(height, stresses, &mut kept));
        AtHeights { rate: 1.0 / series.dt(), start: series.start, samples: series.samples(), kept }
    }

    /// Components at one of the heights, by its number.
    #[inline(always)]
    pub fn at<const V: usize>(&self, number: usize, time: f64) -> [f64; V] {
        let place = (time - self.start) * self.rate;
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
        let [f, ft, g, gt] = [0, 1, 2, 3].map(|k| {
            let mut of = [0.0; V];
            of.iter_mut().zip(&two[k * V..(k + 1) * V]).for_each(|(out, &kept)| *out = f64::from(kept));
            of
        });
        let mut out = [0.0; V];
        for c in 0..V {
            out[c] = weights[0] * f[c] + weights[1] * ft[c] + weights[2] * g[c] + weights[3] * gt[c];
        }
        out
    }

    /// What it takes of memory.
    pub fn bytes(&self) -> usize {
        4 * self.kept.len()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_are_found_as_by_halving_wherever_they_lie() {
        let size = 90.0;
        let sets = [
            vec![],
            vec![0.0],
            vec![30.0, 30.0 + 1e-8, 12.5],
            (0..200).map(|k| f64::from(k) * 0.37).collect(),
            (0..50).map(|k| 90.0 * (f64::from(k) / 49.0).powi(5)).collect(),
        ];
        for set in sets {
            let heights = Heights::new(set, size);
            let all = heights.all().to_vec();
            let halved = |height: f64| {
                let at = all.partition_point(|h| *h < height - 9e-8);
                (at < all.len() && all[at] <= height + 9e-8).then_some(at)
            };
            let beside = all.iter().flat_map(|h| [-1.0, -1e-7, -8e-8, 0.0, 8e-8, 1e-7, 1.0].map(|d| h + d));
            for height in beside.chain((-5..110).map(f64::from)) {
                assert_eq!(heights.find(height), halved(height), "{height} in {all:?}");
            }
            assert!((0..all.len()).all(|k| heights.find(all[k]) == Some(k)));
        }
    }
}
