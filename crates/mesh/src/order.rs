//! An order of points along a space-filling curve, so that neighbours in space are close in memory.

/// Bits an axis: 2¹⁶ cells, far finer than a mesh.
const BITS: u32 = 16;

/// The order in which Hilbert's curve in three dimensions visits the points \[skilling2004\].
///
/// Returns the indices of `points` (usually centroids of elements), each once. Points in the same of
/// the 2⁴⁸ cells of their bounding cube keep their order. The result depends on the points alone.
/// A coordinate that is not a number counts as the smallest.
pub fn hilbert_order(points: &[[f64; 3]]) -> Vec<u32> {
    let mut low = [f64::INFINITY; 3];
    let mut high = [f64::NEG_INFINITY; 3];
    for point in points {
        for i in 0..3 {
            low[i] = low[i].min(point[i]);
            high[i] = high[i].max(point[i]);
        }
    }
    // One scale for the three axes: cells are cubes, so the curve favours no direction.
    let extent = (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max);
    let scale = if extent > 0.0 { f64::from((1u32 << BITS) - 1) / extent } else { 0.0 };
    let mut keyed: Vec<(u64, u32)> = points
        .iter()
        .enumerate()
        .map(|(index, point)| {
            // `as` saturates and takes NaN to 0.
            let cell = [0, 1, 2].map(|i| ((point[i] - low[i]) * scale) as u16);
            (hilbert_key(cell), index as u32)
        })
        .collect();
    keyed.sort_unstable();
    keyed.into_iter().map(|(_, index)| index).collect()
}

/// Place of a cell along the curve.
///
/// Skilling's transform: from the coarsest bit down, each bit that is set says how the finer ones are
/// reflected or exchanged; then Gray decoding and interleaving of the three axes.
fn hilbert_key(cell: [u16; 3]) -> u64 {
    let mut x = cell.map(u32::from);
    let mut bit = 1 << (BITS - 1);
    while bit > 1 {
        let finer = bit - 1;
        for i in 0..3 {
            if x[i] & bit != 0 {
                x[0] ^= finer;
            } else {
                let exchanged = (x[0] ^ x[i]) & finer;
                x[0] ^= exchanged;
                x[i] ^= exchanged;
            }
        }
        bit >>= 1;
    }
    x[1] ^= x[0];
    x[2] ^= x[1];
    let mut flip = 0;
    bit = 1 << (BITS - 1);
    while bit > 1 {
        if x[2] & bit != 0 {
            flip ^= bit - 1;
        }
        bit >>= 1;
    }
    (0..BITS).rev().fold(0, |key, b| {
        x.iter().fold(key, |key, &coordinate| key << 1 | u64::from((coordinate ^ flip) >> b & 1))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Centres of the cells of an n × n × n grid.
    fn grid(n: u32) -> Vec<[f64; 3]> {
        let at = |i: u32| f64::from(i) + 0.5;
        (0..n * n * n).map(|k| [at(k % n), at(k / n % n), at(k / n / n)]).collect()
    }

    #[test]
    fn consecutive_cells_of_a_power_of_two_grid_share_a_face() {
        let points = grid(16);
        let order = hilbert_order(&points);
        for pair in order.windows(2) {
            let (a, b) = (points[pair[0] as usize], points[pair[1] as usize]);
            let apart: f64 = (0..3).map(|i| (a[i] - b[i]).abs()).sum();
            assert_eq!(apart, 1.0, "cells {pair:?}");
        }
    }

    #[test]
    fn every_point_is_visited_once() {
        let points: Vec<_> = grid(13).into_iter().map(|[x, y, z]| [x * x, -3.0 * y, 1e-3 * z]).collect();
        let mut order = hilbert_order(&points);
        order.sort_unstable();
        assert!(order.iter().copied().eq(0..points.len() as u32));
    }

    #[test]
    fn points_in_one_cell_keep_their_order() {
        assert_eq!(hilbert_order(&[[1.0, 2.0, 3.0]; 5]), [0, 1, 2, 3, 4]);
        assert_eq!(hilbert_order(&[]), [0u32; 0]);
        assert_eq!(hilbert_order(&[[f64::NAN; 3], [f64::INFINITY; 3], [0.0; 3]]).len(), 3);
    }
}
