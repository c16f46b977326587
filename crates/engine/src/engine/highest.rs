//! The largest eigenvalue of M⁻¹K by locally optimal conjugate gradients (`knyazev2001`): in each iteration the best of what the
//! mode so far, its residual, and the last correction span. An iteration takes one product with K, as one of the power iteration does.

use super::product::{self, Product};
use crate::assembly::Assembly;
use crate::model::Model;
use crate::phase::Phase;
use crate::sums::over_nodes;
use rayon::prelude::*;
use std::ops::Range;
use tremolite_laws::Row;
use tremolite_laws::sym3::{Eigen, eigen};

const ITERATIONS: u32 = 300;
const CONVERGED: f64 = 1e-5;

/// What was found.
pub struct Highest {
    /// The Rayleigh quotient of the mode, which approaches λmax from below \[1/s²\].
    pub lambda: f64,
    /// Its relative change in the last iteration.
    pub change: f64,
    pub iterations: u32,
}

/// A vector with its product.
struct Pair {
    of: Vec<Row>,
    times: Vec<Row>,
}

impl Pair {
    fn zero(nodes: usize) -> Self {
        Pair { of: vec![Row::ZERO; nodes], times: vec![Row::ZERO; nodes] }
    }
}

/// The largest λ of M⁻¹ times a product, with its mode in `w`, from which the iteration starts: it ends when λ rises by less than
/// 10⁻⁵ a time, or after 300 times.
pub fn highest(
    model: &Model,
    assembly: &Assembly,
    phase: &Phase,
    product: Product,
    w: &mut Vec<Row>,
) -> Highest {
    let mut contributions = vec![Row::ZERO; assembly.totals().contributions.end];
    let mut multiply = |pair: &mut Pair| {
        product::times(assembly, phase, product, &pair.of, &mut contributions, &mut pair.times, None);
    };
    let nodes = w.len();
    let mut mode = Pair { of: std::mem::take(w), times: vec![Row::ZERO; nodes] };
    let (mut residual, mut step) = (Pair::zero(nodes), Pair::zero(nodes));
    multiply(&mut mode);
    let [wkw, wmw] = quotient(model, phase, &mode);
    let mut found = Highest { lambda: wkw / wmw, change: f64::INFINITY, iterations: 1 };
    let lambda = found.lambda;
    residual.of.par_iter_mut().zip(&mode.of).zip(&mode.times).zip(&phase.inverse_mass).for_each(
        |(((r, w), kw), inverse)| (0..3).for_each(|i| r.0[i] = kw.0[i] * inverse.0[i] - lambda * w.0[i]),
    );
    while found.iterations < ITERATIONS && found.change > CONVERGED {
        follow(phase, &mut residual.of);
        multiply(&mut residual);
        let Some((best, shares)) = ritz(grams(model, phase, [&mode, &residual, &step])) else {
            // Nothing is left of the residual: the mode is exact.
            found.change = 0.0;
            break;
        };
        let [a, b, c] = shares;
        let of = mode.of.par_iter_mut().zip(&mut step.of).zip(&mut residual.of);
        let times = mode.times.par_iter_mut().zip(&mut step.times).zip(&residual.times);
        of.zip(times).zip(&phase.inverse_mass).for_each(|((((w, p), r), ((kw, kp), kr)), inverse)| {
            for i in 0..3 {
                p.0[i] = b * r.0[i] + c * p.0[i];
                w.0[i] = a * w.0[i] + p.0[i];
                kp.0[i] = b * kr.0[i] + c * kp.0[i];
                kw.0[i] = a * kw.0[i] + kp.0[i];
                // The residual of the next iteration.
                r.0[i] = kw.0[i] * inverse.0[i] - best * w.0[i];
            }
        });
        found.change = ((best - found.lambda) / best).abs();
        found.lambda = best;
        found.iterations += 1;
    }
    *w = mode.of;
    found
}

/// Gives tied nodes what their masters have.
pub(super) fn follow(phase: &Phase, w: &mut [Row]) {
    for &(node, master) in &phase.tied {
        w[node as usize] = w[master as usize];
    }
}

fn dot(a: &Row, b: &Row) -> f64 {
    a.0[0] * b.0[0] + a.0[1] * b.0[1] + a.0[2] * b.0[2]
}

/// wᵀKw and wᵀMw. A tied node's mass and force are its master's; its own are zero.
fn quotient(model: &Model, phase: &Phase, mode: &Pair) -> [f64; 2] {
    let one = |nodes: Range<usize>| {
        let each = nodes.map(|n| {
            let w = &mode.of[n];
            [dot(w, &mode.times[n]), phase.mass[n] * dot(w, w)]
        });
        each.fold([0.0; 2], |sum, more| [sum[0] + more[0], sum[1] + more[1]])
    };
    over_nodes(&model.nodes, one, |a, b| [a[0] + b[0], a[1] + b[1]])
}

/// Products of three vectors with one another, 11, 22, 33, 12, 23, 31: with K, then with M.
fn grams(model: &Model, phase: &Phase, basis: [&Pair; 3]) -> [[f64; 6]; 2] {
    const PLACES: [[usize; 2]; 6] = [[0, 0], [1, 1], [2, 2], [0, 1], [1, 2], [2, 0]];
    let one = |nodes: Range<usize>| {
        let mut sums = [[0.0; 6]; 2];
        for n in nodes {
            for (k, [i, j]) in PLACES.into_iter().enumerate() {
                sums[0][k] += dot(&basis[i].of[n], &basis[j].times[n]);
                sums[1][k] += phase.mass[n] * dot(&basis[i].of[n], &basis[j].of[n]);
            }
        }
        sums
    };
    over_nodes(&model.nodes, one, |a, b| [0, 1].map(|m| [0, 1, 2, 3, 4, 5].map(|k| a[m][k] + b[m][k])))
}

/// Share of a vector of length 1 that others leave of it, below which it counts as one of them.
const DEPENDENT: f64 = 1e-6;

/// The largest Ritz value in the space of three vectors by their products with K and M, and how much of each has the mode of unit
/// mass; none where the second, the residual, is nothing.
fn ritz([k, m]: [[f64; 6]; 2]) -> Option<(f64, [f64; 3])> {
    // Vectors of length 1; one that is nothing, as the last correction is at first, stays so.
    let unit = [m[0], m[1], m[2]].map(|square| if square > 0.0 { 1.0 / square.sqrt() } else { 0.0 });
    if unit[1] == 0.0 || !unit[1].is_finite() {
        return None;
    }
    let scaled = |t: [f64; 6]| {
        let [x, y, z] = unit;
        [t[0] * x * x, t[1] * y * y, t[2] * z * z, t[3] * x * y, t[4] * y * z, t[5] * z * x]
    };
    let ([k11, k22, k33, k12, k23, k31], [_, _, _, m12, m23, m31]) = (scaled(k), scaled(m));
    // M = LLᵀ, with a diagonal of ones.
    let root = |square: f64| if square > DEPENDENT { square.sqrt() } else { 0.0 };
    let l22 = root(1.0 - m12 * m12);
    let inverse = |l: f64| if l > 0.0 { 1.0 / l } else { 0.0 };
    let i22 = inverse(l22);
    let (l31, l32) = (m31, (m23 - m31 * m12) * i22);
    let i33 = if unit[2] > 0.0 { inverse(root(1.0 - l31 * l31 - l32 * l32)) } else { 0.0 };
    // Rows of L⁻¹; of a vector that is nothing or depends on others, zeroes.
    let rows =
        [[1.0, 0.0, 0.0], [-m12 * i22, i22, 0.0], [(m12 * i22 * l32 - l31) * i33, -l32 * i22 * i33, i33]];
    let apply = |v: [f64; 3]| {
        let [x, y, z] = v;
        [k11 * x + k12 * y + k31 * z, k12 * x + k22 * y + k23 * z, k31 * x + k23 * y + k33 * z]
    };
    let product = |i: usize, j: usize| {
        let kv = apply(rows[j]);
        rows[i][0] * kv[0] + rows[i][1] * kv[1] + rows[i][2] * kv[2]
    };
    let reduced = [product(0, 0), product(1, 1), product(2, 2), product(0, 1), product(1, 2), product(2, 0)];
    let Eigen { values, vectors } = eigen(&reduced);
    let [x, y, z] = vectors[0];
    let shares = [0, 1, 2].map(|i| (x * rows[0][i] + y * rows[1][i] + z * rows[2][i]) * unit[i]);
    Some((values[0], shares))
}

#[cfg(test)]
mod tests {
    use super::ritz;

    /// Vectors e₁, e₁ + e₂ and 2e₃ − e₁ of a space in which K is diagonal: whatever spans it, the largest value is found, and its mode.
    #[test]
    fn the_best_of_three_vectors_is_the_largest_eigenvalue_of_their_space() {
        let basis = [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 0.0, 2.0]];
        for k in [[3.0, 2.0, 1.0], [1.0, 2.0, 3.0], [1.0, 4.0, 2.0], [5.0, 5.0, 1.0]] {
            let m = [2.0, 0.5, 1.5];
            let product = |weight: [f64; 3]| {
                let of = |i: usize, j: usize| (0..3).map(|a| weight[a] * basis[i][a] * basis[j][a]).sum();
                [of(0, 0), of(1, 1), of(2, 2), of(0, 1), of(1, 2), of(2, 0)]
            };
            let exact = (0..3).map(|a| k[a] / m[a]).fold(0.0, f64::max);
            let (value, shares) = ritz([product(k), product(m)]).unwrap();
            assert!((value / exact - 1.0).abs() < 1e-12, "{value} {exact}");
            let mode = [0, 1, 2].map(|a| (0..3).map(|i| shares[i] * basis[i][a]).sum::<f64>());
            let square: f64 = (0..3).map(|a| m[a] * mode[a] * mode[a]).sum();
            let held: f64 = (0..3).map(|a| k[a] * mode[a] * mode[a]).sum();
            assert!((square - 1.0).abs() < 1e-12 && (held / exact - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn a_vector_that_is_nothing_or_one_of_the_others_has_no_part() {
        // e₁, e₂ and nothing; then e₂ again.
        for m in [[1.0, 1.0, 0.0, 0.0, 0.0, 0.0], [1.0, 1.0, 1.0, 0.0, 1.0, 0.0]] {
            let k = [2.0, 3.0, 3.0 * m[2], 0.5, 3.0 * m[4], 0.5 * m[4]];
            let (value, shares) = ritz([k, m]).unwrap();
            let exact = 2.5 + (0.25_f64 + 0.25).sqrt();
            assert!((value - exact).abs() < 1e-12 && shares[2] == 0.0, "{value} {exact} {shares:?}");
        }
        assert!(ritz([[1.0, 0.0, 0.0, 0.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0, 0.0, 0.0]]).is_none());
    }
}
