//! The lines of the grid that come before all others.

use std::ops::Range;

use super::claims::Claim;

/// A bound of a cavern's rectangle: where it is, the cavern, the side.
type Bound = (f64, usize, usize);

/// Lines of the block along one axis that come before all others.
pub(super) struct Stops {
    /// From one end of the block to the other.
    pub at: Vec<f64>,
    /// For each cavern the stops at the ends of its rectangle.
    pub places: Vec<[usize; 2]>,
}

impl Stops {
    /// The ends of the block, the caverns' bounds, those closer than `tolerance` made one, and the galleries'
    /// `levels`, where such a line meets one of them there exactly.
    pub fn new(block: [f64; 2], claims: &[Claim], axis: usize, tolerance: f64, levels: &[f64]) -> Stops {
        let mut bounds: Vec<Bound> = Vec::with_capacity(2 * claims.len());
        for (k, claim) in claims.iter().enumerate() {
            let [low, high] = claim.bounds(axis);
            bounds.extend([(low, k, 0), (high, k, 1)]);
        }
        bounds.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut lines: Vec<(f64, &[Bound])> = Vec::new();
        let mut rest = bounds.as_slice();
        while let Some(start) = rest.first() {
            let n = rest.iter().take_while(|b| b.0 - start.0 < tolerance).count();
            let (together, others) = rest.split_at(n);
            let met = levels.iter().find(|l| together.iter().any(|b| (b.0 - **l).abs() < 1e-9));
            let mean = together.iter().map(|b| b.0).sum::<f64>() / n as f64;
            lines.push((met.copied().unwrap_or(mean), together));
            rest = others;
        }
        for &level in levels {
            if lines.iter().all(|line| line.0 != level) {
                lines.push((level, &[]));
            }
        }
        lines.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut at = vec![block[0]];
        let mut places = vec![[0; 2]; claims.len()];
        for (line, together) in lines {
            for &(_, k, side) in together {
                places[k][side] = at.len();
            }
            at.push(line);
        }
        at.push(block[1]);
        Stops { at, places }
    }

    /// The stop at a level that is one.
    pub fn place(&self, level: f64) -> usize {
        let after = self.at.partition_point(|at| *at < level);
        let nearer = after > 0 && level - self.at[after - 1] < self.at[after.min(self.at.len() - 1)] - level;
        if nearer || after == self.at.len() { after - 1 } else { after }
    }

    pub fn length(&self, stretches: Range<usize>) -> f64 {
        self.at[stretches.end] - self.at[stretches.start]
    }
}
