//! Between modal values, mean gradients and hourglass amplitudes: what both quadratures share.

use super::HOURGLASS;
use crate::lane::{Lane, Octet};
use crate::material::Sym;

/// The modes that strain, in the order of the geometry's arrays.
pub const MODES: [usize; 7] = [1, 2, 4, HOURGLASS[0], HOURGLASS[1], HOURGLASS[2], HOURGLASS[3]];

/// Column of component (i, j) in a symmetric tensor.
pub const VOIGT: [[usize; 3]; 3] = [[0, 3, 5], [3, 1, 4], [5, 4, 2]];

/// Mean gradient g_ij over j, and U_αi − Σ_j X_αj g_ij over α, of one component's modal displacements.
#[inline(always)]
pub fn mean_gradient<L: Lane>(
    gradient: &[[Octet; 7]; 3],
    hourglass: &[[Octet; 3]; 4],
    u: &[L; 8],
    at: usize,
) -> ([L; 3], [L; 4]) {
    let mut g = [L::splat(0.0); 3];
    let mut j = 0;
    while j < 3 {
        let b = &gradient[j];
        let mut sum = L::load(&b[0], at) * u[MODES[0]];
        let mut k = 1;
        while k < 7 {
            sum = L::load(&b[k], at).mul_add(u[MODES[k]], sum);
            k += 1;
        }
        g[j] = sum;
        j += 1;
    }
    let mut q = [L::splat(0.0); 4];
    let mut alpha = 0;
    while alpha < 4 {
        let x = &hourglass[alpha];
        let mut sum = L::load(&x[0], at).neg_mul_add(g[0], u[HOURGLASS[alpha]]);
        sum = L::load(&x[1], at).neg_mul_add(g[1], sum);
        q[alpha] = L::load(&x[2], at).neg_mul_add(g[2], sum);
        alpha += 1;
    }
    (g, q)
}

/// Mean displacement gradient, `[component][axis]`.
#[inline(always)]
pub fn mean_gradients<L: Lane>(
    gradient: &[[Octet; 7]; 3],
    hourglass: &[[Octet; 3]; 4],
    modes: &[[L; 8]; 3],
    at: usize,
) -> [[L; 3]; 3] {
    [
        mean_gradient::<L>(gradient, hourglass, &modes[0], at).0,
        mean_gradient::<L>(gradient, hourglass, &modes[1], at).0,
        mean_gradient::<L>(gradient, hourglass, &modes[2], at).0,
    ]
}

/// s_kα over α: the amplitudes along natural axis k, over its half-length.
#[inline(always)]
pub fn along_axis<L: Lane>(axis: &[Octet; 3], q0: &[L; 4], q1: &[L; 4], q2: &[L; 4], at: usize) -> [L; 4] {
    let (r0, r1, r2) = (L::load(&axis[0], at), L::load(&axis[1], at), L::load(&axis[2], at));
    let mut s = [L::splat(0.0); 4];
    let mut alpha = 0;
    while alpha < 4 {
        s[alpha] = r2.mul_add(q2[alpha], r1.mul_add(q1[alpha], r0 * q0[alpha]));
        alpha += 1;
    }
    s
}

/// Modal forces of component `I`, from stress resultants ∫σ dV and the forces conjugate to s_kα: first conjugate to q_αi,
/// then to g_ij, then to the modes.
#[inline(always)]
pub fn modal_forces<L: Lane, const I: usize>(
    gradient: &[[Octet; 7]; 3],
    hourglass: &[[Octet; 3]; 4],
    axes: &[[Octet; 3]; 3],
    resultants: &Sym<L>,
    p: &[[L; 4]; 3],
    at: usize,
) -> [L; 8] {
    let r0 = L::load(&axes[0][I], at);
    let r1 = L::load(&axes[1][I], at);
    let r2 = L::load(&axes[2][I], at);
    let mut force = [L::splat(0.0); 4];
    let mut alpha = 0;
    while alpha < 4 {
        force[alpha] = r2.mul_add(p[2][alpha], r1.mul_add(p[1][alpha], r0 * p[0][alpha]));
        alpha += 1;
    }
    let mut t = [L::splat(0.0); 3];
    let mut j = 0;
    while j < 3 {
        let mut sum = resultants[VOIGT[I][j]];
        let mut alpha = 0;
        while alpha < 4 {
            sum = L::load(&hourglass[alpha][j], at).neg_mul_add(force[alpha], sum);
            alpha += 1;
        }
        t[j] = sum;
        j += 1;
    }
    let mut f = [L::splat(0.0); 8];
    let mut k = 0;
    while k < 7 {
        let b0 = L::load(&gradient[0][k], at);
        let mut sum = if k < 3 { b0 * t[0] } else { b0.mul_add(t[0], force[k - 3]) };
        sum = L::load(&gradient[1][k], at).mul_add(t[1], sum);
        f[MODES[k]] = L::load(&gradient[2][k], at).mul_add(t[2], sum);
        k += 1;
    }
    f
}
