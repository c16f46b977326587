//! Sobol sequences with the direction numbers of `joe2008`, shifted by random digits.

use crate::random::Stream;

/// Primitive polynomials by their degree and inner coefficients, and first direction numbers: `new-joe-kuo-6.21201`, dimensions 2 to 21.
const DIRECTIONS: [(u32, u32, &[u32]); 20] = [
    (1, 0, &[1]),
    (2, 1, &[1, 3]),
    (3, 1, &[1, 3, 1]),
    (3, 2, &[1, 1, 1]),
    (4, 1, &[1, 1, 3, 3]),
    (4, 4, &[1, 3, 5, 13]),
    (5, 2, &[1, 1, 5, 5, 17]),
    (5, 4, &[1, 1, 5, 5, 5]),
    (5, 7, &[1, 1, 7, 11, 19]),
    (5, 11, &[1, 1, 5, 1, 1]),
    (5, 13, &[1, 1, 1, 3, 11]),
    (5, 14, &[1, 3, 5, 5, 31]),
    (6, 1, &[1, 3, 3, 9, 7, 49]),
    (6, 13, &[1, 1, 1, 15, 21, 21]),
    (6, 16, &[1, 3, 1, 13, 27, 49]),
    (6, 19, &[1, 1, 1, 15, 7, 5]),
    (6, 22, &[1, 3, 1, 15, 13, 25]),
    (6, 25, &[1, 1, 5, 5, 19, 61]),
    (7, 1, &[1, 3, 7, 11, 23, 15, 103]),
    (7, 4, &[1, 3, 7, 13, 13, 15, 69]),
];

/// Keys at most.
pub const MOST: usize = DIRECTIONS.len() + 1;

const BITS: u32 = 32;

/// The direction numbers of a dimension from 0.
fn directions(dimension: usize) -> [u32; BITS as usize] {
    let mut v = [0; BITS as usize];
    if dimension == 0 {
        for (k, v) in v.iter_mut().enumerate() {
            *v = 1 << (BITS - 1 - k as u32);
        }
        return v;
    }
    let (degree, inner, first) = DIRECTIONS[dimension - 1];
    let s = degree as usize;
    for k in 0..BITS as usize {
        if k < s {
            v[k] = first[k] << (BITS - 1 - k as u32);
            continue;
        }
        v[k] = v[k - s] ^ (v[k - s] >> degree);
        for j in 1..s {
            if inner >> (s - 1 - j) & 1 == 1 {
                v[k] ^= v[k - j];
            }
        }
    }
    v
}

/// Point `index` of the plain sequence along a dimension, in 2⁻³².
fn point(directions: &[u32; BITS as usize], index: u32) -> u32 {
    let gray = index ^ (index >> 1);
    (0..BITS).filter(|k| gray >> k & 1 == 1).fold(0, |x, k| x ^ directions[k as usize])
}

/// Shares for `count` samples of `keys` keys, at most [`MOST`], `shares[key][sample]` in (0, 1). The digits of each key are shifted by
/// random ones of the seed, which keeps every balance of the sequence; its first point is kept.
pub fn sobol(count: usize, keys: usize, seed: u32) -> Vec<Vec<f64>> {
    let of_key = |key: usize| {
        let (v, shift) = (directions(key), (Stream::new(seed, key as u64).bits(0) >> 32) as u32);
        let share = |index: u32| (f64::from(point(&v, index) ^ shift) + 0.5) / f64::from(BITS).exp2();
        (0..count as u32).map(share).collect()
    };
    (0..keys).map(of_key).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// scipy.stats.qmc.Sobol(d=21, scramble=False).random(16)\[13\] of SciPy 1.17.1, in sixteenths.
    #[test]
    fn points_are_those_of_joe_and_kuo() {
        const THIRTEENTH: [u32; MOST] =
            [13, 11, 13, 1, 7, 15, 9, 9, 9, 7, 13, 15, 1, 13, 3, 9, 3, 11, 9, 15, 9];
        for (dimension, sixteenths) in THIRTEENTH.into_iter().enumerate() {
            assert_eq!(point(&directions(dimension), 13) >> 28, sixteenths, "dimension {dimension}");
        }
        /// Number 1000 of the same, times 1024.
        const THOUSANDTH: [u32; MOST] = [
            225, 99, 531, 693, 287, 929, 47, 921, 513, 71, 87, 261, 165, 393, 147, 379, 737, 353, 1015, 743,
            535,
        ];
        for (dimension, parts) in THOUSANDTH.into_iter().enumerate() {
            assert_eq!(point(&directions(dimension), 1000) >> 22, parts, "dimension {dimension}");
        }
    }

    #[test]
    fn every_interval_of_a_power_of_two_has_one_point_however_it_is_shifted() {
        for seed in [1, 7, 12345] {
            for key in sobol(64, MOST, seed) {
                let mut places: Vec<usize> = key.iter().map(|u| (u * 64.0) as usize).collect();
                places.sort_unstable();
                assert_eq!(places, (0..64).collect::<Vec<_>>());
            }
        }
        assert_ne!(sobol(8, 2, 1), sobol(8, 2, 2));
    }
}
