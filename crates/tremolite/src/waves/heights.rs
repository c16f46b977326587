//! Heights of which series are kept.

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
