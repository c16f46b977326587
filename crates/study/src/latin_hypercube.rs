//! Latin hypercubes (`mckay1979`), with ranks that go together as asked for (`iman1982`).

use crate::matrix::{self, Matrix};
use crate::normal;
use crate::random::Stream;

/// How often ranks are brought nearer to what is wanted; the best of them is taken.
const ROUNDS: usize = 40;
/// The share of what is missed that is made good in a round: all of it swings about what is wanted where samples are few, since ranks jump.
const SHARE: f64 = 0.5;
/// Ranks that miss what is wanted by less are near enough.
const ENOUGH: f64 = 1e-3;

/// Shares for `count` samples of several keys, `shares[key][sample]` in (0, 1): every key has one sample in each of `count` strata of
/// equal probability, at a random place within it.
///
/// `ranks` is the matrix of rank correlations between keys. Where there are more samples than keys the ranks are brought near to it,
/// uncorrelated ones to zero as well.
///
/// # Errors
/// A matrix that no numbers can have.
pub fn latin_hypercube(count: usize, seed: u32, ranks: &Matrix) -> Result<Vec<Vec<f64>>, NotPositive> {
    let keys = ranks.len();
    matrix::cholesky(ranks).ok_or(NotPositive)?;
    let random: Vec<Vec<usize>> =
        (0..keys).map(|key| Stream::new(seed, 2 * key as u64).order(count)).collect();
    let orders = together(random, ranks);
    let share = |key: usize, sample: usize| {
        let within = Stream::new(seed, 2 * key as u64 + 1).uniform(sample as u64);
        (orders[key][sample] as f64 + within) / count as f64
    };
    Ok((0..keys).map(|key| (0..count).map(|sample| share(key, sample)).collect()).collect())
}

/// A matrix of correlations that no numbers can have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotPositive;

/// Strata in another order, so that the ranks of keys go together as asked for.
///
/// `iman1982` gives normal scores the correlations that ranks are to have. Ranks then miss them by some hundredths; half of what
/// they miss is added to what scores are given, and all is done again.
fn together(random: Vec<Vec<usize>>, ranks: &Matrix) -> Vec<Vec<usize>> {
    let (keys, count) = (random.len(), random.first().map_or(0, Vec::len));
    if keys < 2 || count <= keys {
        return random;
    }
    // Van der Waerden's scores of the random ranks.
    let score = |rank: usize| normal::quantile((rank as f64 + 1.0) / (count as f64 + 1.0));
    let scores: Vec<Vec<f64>> =
        random.iter().map(|order| order.iter().map(|&r| score(r)).collect()).collect();
    let Some(found) = matrix::cholesky(&matrix::correlation(&scores)) else { return random };
    let mut given = ranks.clone();
    let mut best = (f64::INFINITY, random);
    for _ in 0..ROUNDS {
        let Some(wanted) = matrix::cholesky(&given) else { break };
        let orders = reordered(&scores, &found, &wanted);
        let columns: Vec<Vec<f64>> = orders.iter().map(|o| o.iter().map(|&r| r as f64).collect()).collect();
        let of_ranks = matrix::correlation(&columns);
        let mut worst = 0.0_f64;
        for (i, j) in (0..keys).flat_map(|i| (0..keys).map(move |j| (i, j))).filter(|(i, j)| i != j) {
            let missed = ranks[i][j] - of_ranks[i][j];
            worst = worst.max(missed.abs());
            given[i][j] += SHARE * missed;
        }
        if worst < best.0 {
            best = (worst, orders);
        }
        if best.0 < ENOUGH {
            break;
        }
    }
    best.1
}

/// The ranks of scores with other correlations: S* = S Q⁻ᵀ Pᵀ, with T = Q Qᵀ `found` in them and C = P Pᵀ `wanted`.
fn reordered(scores: &[Vec<f64>], found: &Matrix, wanted: &Matrix) -> Vec<Vec<usize>> {
    let (keys, count) = (scores.len(), scores.first().map_or(0, Vec::len));
    let mut placed = vec![vec![0.0; count]; keys];
    for sample in 0..count {
        let own: Vec<f64> = scores.iter().map(|s| s[sample]).collect();
        let free = matrix::solve_lower(found, &own);
        for key in 0..keys {
            placed[key][sample] = (0..=key).map(|k| wanted[key][k] * free[k]).sum();
        }
    }
    placed.iter().map(|values| matrix::ranks(values)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn identity(n: usize) -> Matrix {
        (0..n).map(|i| (0..n).map(|j| f64::from(u8::from(i == j))).collect()).collect()
    }

    proptest! {
        #[test]
        fn every_stratum_has_one_sample(count in 1_usize..60, keys in 1_usize..6, seed in 1_u32..1000, rank in -0.15_f64..0.9) {
            let mut ranks = identity(keys);
            for (i, j) in (0..keys).flat_map(|i| (0..keys).map(move |j| (i, j))).filter(|(i, j)| i != j) {
                ranks[i][j] = rank;
            }
            let shares = latin_hypercube(count, seed, &ranks).unwrap();
            for key in &shares {
                let mut strata: Vec<usize> = key.iter().map(|u| (u * count as f64) as usize).collect();
                strata.sort_unstable();
                prop_assert_eq!(strata, (0..count).collect::<Vec<_>>());
            }
        }
    }

    #[test]
    fn ranks_go_together_as_asked_for() {
        for rank in [-0.7, 0.0, 0.3, 0.9] {
            let ranks = vec![vec![1.0, rank, 0.0], vec![rank, 1.0, 0.0], vec![0.0, 0.0, 1.0]];
            let shares = latin_hypercube(200, 7, &ranks).unwrap();
            let found = matrix::correlation(&shares);
            // Of 200 at random they would miss by 1/√200 = 0.07.
            assert!((found[0][1] - rank).abs() < 0.01, "{rank}: {found:?}");
            assert!(found[0][2].abs() < 0.01 && found[1][2].abs() < 0.01, "{rank}: {found:?}");
        }
    }

    /// Of a few dozen, whatever the seed.
    #[test]
    fn few_samples_keep_to_a_hundredth() {
        for (count, keys) in [(30, 2), (60, 3)] {
            let mut ranks = identity(keys);
            (ranks[0][1], ranks[1][0]) = (0.6, 0.6);
            for seed in 1..=100 {
                let orders: Vec<Vec<f64>> = latin_hypercube(count, seed, &ranks)
                    .unwrap()
                    .iter()
                    .map(|shares| shares.iter().map(|u| (u * count as f64).floor()).collect())
                    .collect();
                let found = matrix::correlation(&orders);
                for (i, j) in (0..keys).flat_map(|i| (0..i).map(move |j| (i, j))) {
                    assert!((found[i][j] - ranks[i][j]).abs() < 0.01, "{count} {seed}: {found:?}");
                }
            }
        }
    }

    #[test]
    fn the_sample_is_a_function_of_the_seed() {
        let sample = |seed| latin_hypercube(20, seed, &identity(3)).unwrap();
        assert_eq!(sample(7), sample(7));
        assert_ne!(sample(7), sample(8));
    }

    #[test]
    fn correlations_that_no_numbers_can_have_are_refused() {
        let ranks = vec![vec![1.0, 0.9, -0.9], vec![0.9, 1.0, 0.9], vec![-0.9, 0.9, 1.0]];
        assert_eq!(latin_hypercube(10, 1, &ranks), Err(NotPositive));
    }
}
