//! Sums of what a wave does at some heights, each a series of its own.
//!
//! Meshes have their nodes, and the points of their faces, at few heights, often one above another in the same way at many places.
//! There the cubics upwards, and sums over what lies one above another, are the same at all times, so what they come to is kept.

use super::series::Series;

/// Numbers kept of a sum at a sample: a vector with a place to spare, and its slope in time times the interval.
const KEPT: usize = 8;

/// What is summed up: components of displacement or of stress at a height, times what one of each makes of a vector.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    /// m above the base.
    pub height: f64,
    pub of: [[f64; 4]; 4],
}

/// Series of vectors, all with the samples of a wave's series.
pub struct Rows {
    samples: usize,
    /// Sum after sum, sample after sample.
    kept: Vec<f32>,
}

/// Bytes of so many sums.
pub fn bytes(sums: usize, samples: usize) -> usize {
    4 * KEPT * sums * samples
}

impl Rows {
    /// Of sums of displacements, or of stresses.
    pub fn of<'a>(series: &Series, stresses: bool, sums: impl ExactSizeIterator<Item = &'a [Term]>) -> Rows {
        let samples = series.samples();
        // Room for all at once: a vector that grows would take up to twice as much while it does.
        let mut kept = Vec::with_capacity(sums.len() * samples * KEPT);
        let mut sum = vec![[[0.0; 4]; 2]; samples];
        for terms in sums {
            sum.fill([[0.0; 4]; 2]);
            terms.iter().for_each(|term| series.add(term.height, stresses, &term.of, &mut sum));
            kept.extend(sum.iter().flatten().flatten().map(|&x| x as f32));
        }
        Rows { samples, kept }
    }

    /// One of the sums, `place` samples after the first.
    #[inline(always)]
    pub fn at(&self, number: u32, place: f64) -> [f64; 4] {
        match self.cell(place) {
            Some((sample, x)) => self.weighted(number, sample, weights(x)),
            None => [0.0; 4],
        }
    }

    /// By how much one of the sums grows from a place to a later one.
    #[inline(always)]
    pub fn gained(&self, number: u32, from: f64, to: f64) -> [f64; 4] {
        if let (Some((sample, x)), Some((same, y))) = (self.cell(from), self.cell(to))
            && sample == same
        {
            let (before, after) = (weights(x), weights(y));
            return self.weighted(number, sample, [0, 1, 2, 3].map(|k| after[k] - before[k]));
        }
        let (before, after) = (self.at(number, from), self.at(number, to));
        [0, 1, 2, 3].map(|k| after[k] - before[k])
    }

    /// The sample before a place, and how far behind it that is; none before the first.
    #[inline(always)]
    fn cell(&self, place: f64) -> Option<(usize, f64)> {
        if place > 0.0 {
            let sample = (place as usize).min(self.samples - 2);
            return Some((sample, (place - sample as f64).min(1.0)));
        }
        None
    }

    #[inline(always)]
    fn weighted(&self, number: u32, sample: usize, [a, b, c, d]: [f64; 4]) -> [f64; 4] {
        let from = (number as usize * self.samples + sample) * KEPT;
        let mut out = [0.0; 4];
        if let Some(two) = self.kept.get(from..from + 2 * KEPT).and_then(|two| <&[f32; 16]>::try_from(two).ok()) {
            for k in 0..4 {
                out[k] = (a * f64::from(two[k]) + b * f64::from(two[4 + k]))
                    + (c * f64::from(two[8 + k]) + d * f64::from(two[12 + k]));
            }
        }
        out
    }

    /// What it takes of memory.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.kept[..])
    }
}

/// Of value, slope, value, slope at the ends of an interval.
#[inline(always)]
fn weights(x: f64) -> [f64; 4] {
    let y = 1.0 - x;
    [y * y * (1.0 + 2.0 * x), x * y * y, x * x * (3.0 - 2.0 * x), -x * x * y]
}
