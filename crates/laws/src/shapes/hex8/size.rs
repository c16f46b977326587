//! The element's size tensor, for laws that soften by a fracture energy.

use crate::lane::{Lane, Octet};
use crate::material::Sym;

/// Size tensor G = ½ Σ (x − x̄)⊗(x − x̄) over the corners, from what the kernels' geometry holds anyway.
///
/// The ±1 patterns are orthogonal, so G = Σ_m X_m⊗X_m/16 over the modal coordinates X_m of the seven patterns
/// m ≠ constant. The three linear ones follow from Σ_m b_mj X_mi = δ_ij, which the mean gradients obey exactly:
/// no element has to store them. Zero for an element without extent.
#[inline(always)]
pub(super) fn size_tensor<L: Lane>(
    gradient: &[[Octet; 7]; 3],
    hourglass: &[[Octet; 3]; 4],
    at: usize,
) -> Sym<L> {
    let zero = L::splat(0.0);
    let mut x = [[zero; 3]; 4];
    let mut b = [[zero; 3]; 3];
    // R_ij = δ_ij − Σ_α b_αj X_αi
    let mut rest = [[zero; 3]; 3];
    let mut j = 0;
    while j < 3 {
        let mut i = 0;
        while i < 3 {
            b[i][j] = L::load(&gradient[j][i], at);
            rest[i][j] = L::splat(if i == j { 1.0 } else { 0.0 });
            let mut alpha = 0;
            while alpha < 4 {
                x[alpha][i] = L::load(&hourglass[alpha][i], at);
                rest[i][j] = L::load(&gradient[j][3 + alpha], at).neg_mul_add(x[alpha][i], rest[i][j]);
                alpha += 1;
            }
            i += 1;
        }
        j += 1;
    }
    let mut cofactor = [[zero; 3]; 3];
    let mut m = 0;
    while m < 3 {
        let (m1, m2) = ((m + 1) % 3, (m + 2) % 3);
        let mut j = 0;
        while j < 3 {
            let (j1, j2) = ((j + 1) % 3, (j + 2) % 3);
            cofactor[m][j] = b[m1][j2].neg_mul_add(b[m2][j1], b[m1][j1] * b[m2][j2]);
            j += 1;
        }
        m += 1;
    }
    let determinant =
        b[0][2].mul_add(cofactor[0][2], b[0][1].mul_add(cofactor[0][1], b[0][0] * cofactor[0][0]));
    let empty = determinant.abs().less(L::splat(1e-300));
    let inverse = L::select(empty, zero, L::splat(1.0) / determinant);
    let mut linear = [[zero; 3]; 3];
    let mut m = 0;
    while m < 3 {
        let mut i = 0;
        while i < 3 {
            let c = &cofactor[m];
            linear[m][i] = inverse * c[2].mul_add(rest[i][2], c[1].mul_add(rest[i][1], c[0] * rest[i][0]));
            i += 1;
        }
        m += 1;
    }
    const PAIRS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)];
    let mut size = [zero; 6];
    let mut k = 0;
    while k < 6 {
        let (i, j) = PAIRS[k];
        let mut sum = linear[0][i] * linear[0][j];
        sum = linear[1][i].mul_add(linear[1][j], sum);
        sum = linear[2][i].mul_add(linear[2][j], sum);
        let mut alpha = 0;
        while alpha < 4 {
            sum = x[alpha][i].mul_add(x[alpha][j], sum);
            alpha += 1;
        }
        size[k] = sum * L::splat(1.0 / 16.0);
        k += 1;
    }
    size
}
