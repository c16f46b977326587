//! Bounds of a fragility curve by a bootstrap over records: records are drawn again and again with repetition, each with all of its
//! runs, since the runs of one record are not independent.

use crate::fragility::{Curve, NoCurve};
use crate::random::Stream;

/// The share of all samples that lies below and above the bounds.
pub const TAIL: f64 = 0.05;

/// Bounds between which nine tenths of the samples lie.
#[derive(Clone, Debug, PartialEq)]
pub struct Bounds {
    pub theta: [f64; 2],
    pub beta: [f64; 2],
    /// Of the probability at each intensity that was asked for.
    pub band: Vec<[f64; 2]>,
    /// Samples that have a curve.
    pub samples: usize,
    /// Samples that have none, which are in no bound.
    pub without: usize,
}

/// The bounds of what `fit` makes of data in clusters from 0 to below `clusters`, at `intensities`; nothing for fewer than two
/// clusters, or where fewer than half of the samples have a curve.
pub fn bounds<T: Copy>(
    data: &[T],
    cluster: impl Fn(&T) -> usize,
    clusters: usize,
    (count, seed): (usize, u32),
    intensities: &[f64],
    fit: impl Fn(&[T]) -> Result<Curve, NoCurve>,
) -> Option<Bounds> {
    if clusters < 2 {
        return None;
    }
    let mut of_cluster: Vec<Vec<T>> = (0..clusters).map(|_| Vec::new()).collect();
    for item in data {
        of_cluster[cluster(item)].push(*item);
    }
    let sample = |k: usize| {
        let stream = Stream::new(seed, (1 << 32) + k as u64);
        let drawn: Vec<T> = (0..clusters)
            .flat_map(|place| &of_cluster[stream.below(place as u64, clusters)])
            .copied()
            .collect();
        fit(&drawn).ok()
    };
    let curves: Vec<Curve> = (0..count).filter_map(sample).collect();
    if 2 * curves.len() < count || curves.is_empty() {
        return None;
    }
    let ends = |value: &dyn Fn(&Curve) -> f64| {
        let mut values: Vec<f64> = curves.iter().map(value).collect();
        values.sort_by(f64::total_cmp);
        [TAIL, 1.0 - TAIL].map(|share| percentile(&values, share))
    };
    Some(Bounds {
        theta: ends(&|c| c.theta),
        beta: ends(&|c| c.beta),
        band: intensities.iter().map(|x| ends(&|c| c.at(*x))).collect(),
        samples: curves.len(),
        without: count - curves.len(),
    })
}

/// The value at a share of sorted ones, linear in between.
fn percentile(sorted: &[f64], share: f64) -> f64 {
    let place = share * (sorted.len() - 1) as f64;
    let low = place.floor() as usize;
    let high = (low + 1).min(sorted.len() - 1);
    sorted[low] + (place - low as f64) * (sorted[high] - sorted[low])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fragility::{Seen, of_stripes};

    /// Records that are all alike leave nothing to chance; records that differ do.
    #[test]
    fn bounds_come_from_differences_between_records() {
        let seen = |limit: &dyn Fn(usize) -> f64| -> Vec<Seen> {
            let levels = (1..=8).map(|k| 0.1 * f64::from(k));
            let of = |x: f64| (0..8).map(move |cluster| (x, cluster));
            let all = levels.flat_map(of);
            all.map(|(intensity, cluster)| Seen { intensity, exceeded: intensity > limit(cluster), cluster })
                .collect()
        };
        let differ = seen(&|cluster| 0.16 + 0.07 * cluster as f64);
        let found = bounds(&differ, |s| s.cluster, 8, (300, 1), &[0.4], of_stripes).unwrap();
        let whole = of_stripes(&differ).unwrap();
        assert!(found.theta[0] < whole.theta && whole.theta < found.theta[1], "{found:?} {whole:?}");
        assert!(found.band[0][0] < whole.at(0.4) && whole.at(0.4) < found.band[0][1]);
        // Equal records are separated in every sample.
        assert_eq!(bounds(&seen(&|_| 0.35), |s| s.cluster, 8, (50, 1), &[], of_stripes), None);
        assert_eq!(bounds(&differ, |_| 0, 1, (50, 1), &[], of_stripes), None);
        assert_eq!(found, bounds(&differ, |s| s.cluster, 8, (300, 1), &[0.4], of_stripes).unwrap());
    }

    #[test]
    fn percentiles_are_linear_between_values() {
        assert_eq!(percentile(&[1.0, 2.0, 4.0], 0.75), 3.0);
        assert_eq!(percentile(&[5.0], 0.05), 5.0);
    }
}
