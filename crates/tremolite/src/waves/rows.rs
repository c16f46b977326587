//! Sums of what a wave does at some heights, each a series of its own.
//!
//! Meshes have their nodes, and the points of their faces, at few heights, often one above another in the same way at many places.
//! There the cubics upwards, and sums over what lies one above another, are the same at all times, so what they come to is kept.

use super::series::Series;

/// Numbers kept of a sum at a sample: a vector with a place to spare, and its slope in time times the interval.
const KEPT: usize = 8;

/// Sums whose weights are found together.
const AT_ONCE: usize = 32;

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

    /// Some sums, each at `place` samples after the first less those by which it is later.
    pub fn read(&self, sums: &[(u32, f64)], place: f64, out: &mut [[f64; 4]]) {
        // Weights of some and then the sums: side by side each is quicker.
        let mut weights = [[0.0; 4]; AT_ONCE];
        let mut samples = [0; AT_ONCE];
        for (out, sums) in out.chunks_mut(AT_ONCE).zip(sums.chunks(AT_ONCE)) {
            for ((weights, sample), (_, late)) in weights.iter_mut().zip(&mut samples).zip(sums) {
                (*sample, *weights) = self.cell(place - late);
            }
            for ((out, (number, _)), (weights, &sample)) in
                out.iter_mut().zip(sums).zip(weights.iter().zip(&samples))
            {
                *out = self.weighted(*number, sample, weights);
            }
        }
    }

    /// One of the sums, `place` samples after the first.
    #[inline(always)]
    pub fn at(&self, number: u32, place: f64) -> [f64; 4] {
        let (sample, weights) = self.cell(place);
        self.weighted(number, sample, &weights)
    }

    /// By how much one of the sums grows from a place to a later one.
    #[inline(always)]
    pub fn gained(&self, number: u32, from: f64, to: f64) -> [f64; 4] {
        let ((first, before), (last, after)) = (self.cell(from), self.cell(to));
        if first == last {
            return self.weighted(number, first, &[0, 1, 2, 3].map(|k| after[k] - before[k]));
        }
        let before = self.weighted(number, first, &before);
        let after = self.weighted(number, last, &after);
        [0, 1, 2, 3].map(|k| after[k] - before[k])
    }

    /// The sample before a place, and weights of value, slope, value and slope there and at the next: nothing before the first.
    #[inline(always)]
    fn cell(&self, place: f64) -> (u32, [f64; 4]) {
        let on = if place > 0.0 { 1.0 } else { 0.0 };
        let place = if place > 0.0 { place } else { 0.0 };
        let sample = (place as u32).min(self.samples as u32 - 2);
        let x = (place - f64::from(sample)).min(1.0);
        let (y, on_x) = (on * (1.0 - x), on * x);
        (
            sample,
            [
                y * (1.0 - x) * (1.0 + 2.0 * x),
                x * y * (1.0 - x),
                on_x * x * (3.0 - 2.0 * x),
                -on_x * x * (1.0 - x),
            ],
        )
    }

    #[inline(always)]
    fn weighted(&self, number: u32, sample: u32, weights: &[f64; 4]) -> [f64; 4] {
        let from = (number as usize * self.samples + sample as usize) * KEPT;
        let mut out = [0.0; 4];
        // Part by part, which compilers see that they can do four at a time.
        if let Some(two) = self.kept.get(from..from + 2 * KEPT) {
            for (weight, part) in weights.iter().zip(two.as_chunks::<4>().0) {
                let part = part.map(f64::from);
                (0..4).for_each(|k| out[k] += weight * part[k]);
            }
        }
        out
    }

    /// What it takes of memory.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.kept[..])
    }
}
