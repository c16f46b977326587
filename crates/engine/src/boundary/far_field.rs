//! u_ff: the motion of the free field at places of the base, from the bottoms of columns.

use super::Surroundings;
use crate::column::corner_at;
use crate::sheet::Sheet;
use crate::slabs::Slab;

/// Shares of the columns in the free field at a place, from shares of the corners; several columns of a corner share evenly.
fn of_corners(around: Surroundings, shares: impl IntoIterator<Item = (usize, f64)>) -> Vec<(u32, f64)> {
    let mut weights = vec![0.0; around.outside.columns.len()];
    for (corner, share) in shares {
        let here = || {
            around
                .outside
                .columns
                .iter()
                .enumerate()
                .filter(move |(_, column)| column.corners.contains(&corner))
        };
        let count = here().count() as f64;
        here().for_each(|(c, _)| weights[c] += share / count);
    }
    let bottoms = around.outside.columns.iter().map(|column| around.engine(column.bottom));
    bottoms.zip(weights).filter(|(_, weight)| *weight != 0.0).collect()
}

/// Where a place lies between the low and the high end of an axis, from 0 to 1.
fn fraction(around: Surroundings, axis: usize, at: [f64; 3]) -> f64 {
    let (low, high) = around.faces.bounds;
    ((at[axis] - low[axis]) / (high[axis] - low[axis])).clamp(0.0, 1.0)
}

/// The free field at a place of the base: bilinear between the columns at the four corners.
pub fn between_corners(around: Surroundings, at: [f64; 3]) -> Vec<(u32, f64)> {
    let [x, y] = [0, 1].map(|axis| fraction(around, axis, at));
    let share = |ends: [usize; 2]| [1.0 - x, x][ends[0]] * [1.0 - y, y][ends[1]];
    let corners = [[0, 0], [1, 0], [0, 1], [1, 1]];
    of_corners(around, corners.map(|ends| (corner_at(ends), share(ends))))
}

/// The free field at the base of a slab: linear between its own columns, or else between the corners at its ends.
pub fn along_slab(around: Surroundings, slab: &Slab, at: [f64; 3]) -> Vec<(u32, f64)> {
    let Sheet { axis, end, .. } = slab.sheet;
    let part = fraction(around, 1 - axis, at);
    let shares = [1.0 - part, part];
    if let [Some(low), Some(high)] = slab.columns {
        let bottoms = [low, high].map(|c| around.engine(around.outside.columns[c].bottom));
        return bottoms.into_iter().zip(shares).filter(|(_, share)| *share != 0.0).collect();
    }
    let corner = |other: usize| if axis == 0 { corner_at([end, other]) } else { corner_at([other, end]) };
    of_corners(around, [0, 1].map(|other| (corner(other), shares[other])))
}
