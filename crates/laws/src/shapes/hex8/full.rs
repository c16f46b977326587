//! 2×2×2 quadrature of the same assumed-strain field.

use super::{
    HOURGLASS, Hex8, Probe, Stabilisation, gather_modes, gauss_point, scatter_nodal, store_nodal, to_modes,
    to_nodes,
};
use crate::lane::{Lane, Octet, Row};
use crate::material::{Material, Point, Sym};

/// Geometry of eight elements in their own frames; 65 octets, that is 520 bytes an element.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct FullGeometry {
    /// Mean gradient in the frame's axes, as in the one-point element.
    gradient: [[Octet; 7]; 3],
    /// X_αj in the frame's axes.
    hourglass: [[Octet; 3]; 4],
    /// Rows are the frame's axes.
    frame: [[Octet; 3]; 3],
    /// 1/(8 ℓ_k): the ⅛ of γ and the half-length.
    inverse_lengths: [Octet; 3],
    /// ℓ_y/ℓ_z, ℓ_z/ℓ_x, ℓ_x/ℓ_y and their inverses.
    ratios: [[Octet; 2]; 3],
    /// det J at the points.
    weights: [Octet; 8],
    /// Weighted means of ξ, η, ζ, ηζ, ξζ, ξη: removed so that a constant stress does no work on the hourglass part.
    means: [Octet; 6],
}

const MODES: [usize; 7] = [1, 2, 4, HOURGLASS[0], HOURGLASS[1], HOURGLASS[2], HOURGLASS[3]];
const VOIGT: [[usize; 3]; 3] = [[0, 3, 5], [3, 1, 4], [5, 4, 2]];
/// Modes of the hourglass strain in the order of `means`.
const STRAIN_MODES: [usize; 6] = [1, 2, 4, 6, 5, 3];
/// ξ at the integration points.
const G: f64 = 0.577_350_269_189_625_8;

impl FullGeometry {
    /// Geometry without extent: forces from it are zero. Pads the last octet of a patch.
    pub const EMPTY: Self = FullGeometry {
        gradient: [[Octet::ZERO; 7]; 3],
        hourglass: [[Octet::ZERO; 3]; 4],
        frame: [[Octet::ZERO; 3]; 3],
        inverse_lengths: [Octet::ZERO; 3],
        ratios: [[Octet::ZERO; 2]; 3],
        weights: [Octet::ZERO; 8],
        means: [Octet::ZERO; 6],
    };

    /// Puts an element into a lane.
    pub fn set(&mut self, lane: usize, hex: &Hex8) {
        let turned = |v: &[f64; 3], j: usize| (0..3).map(|i| hex.frame[j][i] * v[i]).sum::<f64>();
        for j in 0..3 {
            for (k, mode) in MODES.into_iter().enumerate() {
                self.gradient[j][k].0[lane] = turned(&hex.gradient[mode], j);
            }
            for alpha in 0..4 {
                self.hourglass[alpha][j].0[lane] = turned(&hex.hourglass[alpha], j);
            }
            for k in 0..3 {
                self.frame[k][j].0[lane] = hex.frame[k][j];
            }
            let (next, last) = (hex.half_lengths[(j + 1) % 3], hex.half_lengths[(j + 2) % 3]);
            self.inverse_lengths[j].0[lane] = 1.0 / (8.0 * hex.half_lengths[j]);
            self.ratios[j][0].0[lane] = next / last;
            self.ratios[j][1].0[lane] = last / next;
        }
        for p in 0..8 {
            self.weights[p].0[lane] = hex.weights[p];
        }
        for (k, mode) in STRAIN_MODES.into_iter().enumerate() {
            let mean: f64 = (0..8)
                .map(|p| {
                    let xi = gauss_point(p);
                    let value: f64 = (0..3).filter(|axis| mode >> axis & 1 == 1).map(|axis| xi[axis]).product();
                    hex.weights[p] * value
                })
                .sum();
            self.means[k].0[lane] = mean / hex.volume;
        }
    }
}

/// Internal forces of eight elements, added to `out`; history (point by point) is updated in place.
///
/// Arguments and sign as in [`super::one_point`]. Strains reach the law in the element's frame, so tensors in a
/// history are in it too; probed stresses are in global axes.
///
/// # Safety
/// All indices must be below `rows.len()` and `out.len()`, and the lane's instruction set must be enabled.
#[inline(always)]
#[allow(clippy::too_many_arguments)]
pub unsafe fn full<L: Lane, M: Material, const PROBE: bool>(
    material: &M,
    elastic: &Stabilisation,
    point: &Point<f64>,
    geometry: &FullGeometry,
    index: &[[u16; 8]; 8],
    history: &mut [Octet],
    rows: &[Row],
    out: &mut [Row],
    probe: &mut Probe,
) {
    let columns = M::HISTORY.len();
    let mut nodal = [[Octet::ZERO; 3]; 8];
    let mut at = 0;
    while at < 8 {
        // SAFETY: passed on to the caller.
        let global = unsafe { gather_modes::<L>(rows, index, at) };

        // Modal displacements in the frame, the mean gradient and the hourglass amplitudes over half-lengths.
        let mut g = [[L::splat(0.0); 3]; 3];
        let mut s = [[L::splat(0.0); 4]; 3];
        let mut i = 0;
        while i < 3 {
            let r = &geometry.frame[i];
            let (r0, r1, r2) = (L::load(&r[0], at), L::load(&r[1], at), L::load(&r[2], at));
            let mut u = [L::splat(0.0); 7];
            let mut k = 0;
            while k < 7 {
                let m = MODES[k];
                u[k] = r2.mul_add(global[2][m], r1.mul_add(global[1][m], r0 * global[0][m]));
                k += 1;
            }
            let mut j = 0;
            while j < 3 {
                let b = &geometry.gradient[j];
                let mut sum = L::load(&b[0], at) * u[0];
                let mut k = 1;
                while k < 7 {
                    sum = L::load(&b[k], at).mul_add(u[k], sum);
                    k += 1;
                }
                g[i][j] = sum;
                j += 1;
            }
            let inverse = L::load(&geometry.inverse_lengths[i], at);
            let mut alpha = 0;
            while alpha < 4 {
                let x = &geometry.hourglass[alpha];
                let mut sum = u[3 + alpha];
                sum = L::load(&x[0], at).neg_mul_add(g[i][0], sum);
                sum = L::load(&x[1], at).neg_mul_add(g[i][1], sum);
                sum = L::load(&x[2], at).neg_mul_add(g[i][2], sum);
                s[i][alpha] = sum * inverse;
                alpha += 1;
            }
            i += 1;
        }

        // The strain's modal coefficients by component, from the table in the module documentation.
        let mut e = [[L::splat(0.0); 8]; 6];
        let nu = L::splat(elastic.poisson);
        let nu_plane = L::splat(elastic.poisson_plane);
        let gauss = L::splat(G);
        let mut axis = 0;
        while axis < 3 {
            // Along natural axis `axis`: the other two normal strains bend, their sum contracts this one.
            let (b, c) = ((axis + 1) % 3, (axis + 2) % 3);
            let mode = 1 << axis;
            let (eb, ec) = (s[b][c], s[c][b]);
            e[b][mode] = eb * gauss;
            e[c][mode] = ec * gauss;
            e[axis][mode] = -(nu_plane * (eb + ec) * gauss);
            let ratio = &geometry.ratios[axis];
            e[VOIGT[b][c]][mode] =
                L::load(&ratio[0], at).mul_add(s[b][b], L::load(&ratio[1], at) * s[c][c]) * gauss;
            // The bilinear mode without this axis: uniaxial stress along it.
            let twist = s[axis][3] * L::splat(G * G);
            let contract = -(nu * twist);
            e[axis][7 ^ mode] = twist;
            e[b][7 ^ mode] = contract;
            e[c][7 ^ mode] = contract;
            axis += 1;
        }
        let mean: Sym<L> = [
            g[0][0],
            g[1][1],
            g[2][2],
            g[0][1] + g[1][0],
            g[1][2] + g[2][1],
            g[0][2] + g[2][0],
        ];
        let over_gauss = [
            L::load(&geometry.means[0], at) * L::splat(1.0 / G),
            L::load(&geometry.means[1], at) * L::splat(1.0 / G),
            L::load(&geometry.means[2], at) * L::splat(1.0 / G),
            L::load(&geometry.means[3], at) * L::splat(1.0 / (G * G)),
            L::load(&geometry.means[4], at) * L::splat(1.0 / (G * G)),
            L::load(&geometry.means[5], at) * L::splat(1.0 / (G * G)),
        ];
        let mut c = 0;
        while c < 6 {
            let mut constant = mean[c];
            let mut k = 0;
            while k < 6 {
                constant = over_gauss[k].neg_mul_add(e[c][STRAIN_MODES[k]], constant);
                k += 1;
            }
            e[c][0] = constant;
            to_nodes(&mut e[c]);
            c += 1;
        }

        // The law at the eight points; strains make room for weighted stresses.
        let mut lane_point = Point::new(L::splat(point.dt));
        if M::NEEDS_SIZE {
            lane_point.size = super::size::size_tensor(&geometry.gradient, &geometry.hourglass, at);
        }
        let mut energy = L::splat(0.0);
        let mut p = 0;
        while p < 8 {
            let strain: Sym<L> = [e[0][p], e[1][p], e[2][p], e[3][p], e[4][p], e[5][p]];
            let own = &mut history[p * columns..(p + 1) * columns];
            let old = super::load_history::<L, M>(own, at);
            let (stress, new) = material.update(&lane_point, strain, old);
            super::store_history::<L, M>(new, own, at);
            let weight = L::load(&geometry.weights[p], at);
            let mut density = L::splat(0.0);
            let mut c = 0;
            while c < 6 {
                e[c][p] = weight * stress[c];
                if PROBE {
                    density = stress[c].mul_add(strain[c], density);
                }
                c += 1;
            }
            if PROBE {
                energy = weight.mul_add(density, energy);
                store_turned(&geometry.frame, &stress, &mut probe.stress[p], at);
            }
            p += 1;
        }
        if PROBE {
            (L::splat(0.5) * energy).store(&mut probe.strain_energy, at);
        }

        // Back the same way: resultants of the strain's modes, then forces conjugate to s, q, g and the modes.
        let mut c = 0;
        while c < 6 {
            to_modes(&mut e[c]);
            let constant = e[c][0];
            let mut k = 0;
            while k < 6 {
                let mode = STRAIN_MODES[k];
                e[c][mode] = over_gauss[k].neg_mul_add(constant, e[c][mode]);
                k += 1;
            }
            c += 1;
        }
        let mut conjugate = [[L::splat(0.0); 4]; 3];
        let mut axis = 0;
        while axis < 3 {
            let (b, c) = ((axis + 1) % 3, (axis + 2) % 3);
            let mode = 1 << axis;
            let contracted = nu_plane * e[axis][mode];
            conjugate[b][c] = (e[b][mode] - contracted) * gauss;
            conjugate[c][b] = (e[c][mode] - contracted) * gauss;
            let shear = e[VOIGT[b][c]][mode] * gauss;
            let ratio = &geometry.ratios[axis];
            conjugate[b][b] = L::load(&ratio[0], at).mul_add(shear, conjugate[b][b]);
            conjugate[c][c] = L::load(&ratio[1], at).mul_add(shear, conjugate[c][c]);
            let others = e[b][7 ^ mode] + e[c][7 ^ mode];
            conjugate[axis][3] = nu.neg_mul_add(others, e[axis][7 ^ mode]) * L::splat(G * G);
            axis += 1;
        }
        let mut local = [[L::splat(0.0); 7]; 3];
        let mut i = 0;
        while i < 3 {
            let inverse = L::load(&geometry.inverse_lengths[i], at);
            let mut force = [L::splat(0.0); 4];
            let mut alpha = 0;
            while alpha < 4 {
                force[alpha] = conjugate[i][alpha] * inverse;
                alpha += 1;
            }
            let mut t = [L::splat(0.0); 3];
            let mut j = 0;
            while j < 3 {
                let mut sum = e[VOIGT[i][j]][0];
                let mut alpha = 0;
                while alpha < 4 {
                    sum = L::load(&geometry.hourglass[alpha][j], at).neg_mul_add(force[alpha], sum);
                    alpha += 1;
                }
                t[j] = sum;
                j += 1;
            }
            let mut k = 0;
            while k < 7 {
                let b0 = L::load(&geometry.gradient[0][k], at);
                let mut sum = if k < 3 { b0 * t[0] } else { b0.mul_add(t[0], force[k - 3]) };
                sum = L::load(&geometry.gradient[1][k], at).mul_add(t[1], sum);
                local[i][k] = L::load(&geometry.gradient[2][k], at).mul_add(t[2], sum);
                k += 1;
            }
            i += 1;
        }
        let mut modes = [[L::splat(0.0); 8]; 3];
        let mut i = 0;
        while i < 3 {
            let r0 = L::load(&geometry.frame[0][i], at);
            let r1 = L::load(&geometry.frame[1][i], at);
            let r2 = L::load(&geometry.frame[2][i], at);
            let mut k = 0;
            while k < 7 {
                modes[i][MODES[k]] = r2.mul_add(local[2][k], r1.mul_add(local[1][k], r0 * local[0][k]));
                k += 1;
            }
            i += 1;
        }
        store_nodal(&mut modes, &mut nodal, at);
        at += L::WIDTH;
    }
    // SAFETY: passed on to the caller.
    unsafe { scatter_nodal::<L>(out, index, &nodal) };
}

/// Stores a stress turned from the frame to global axes: Rᵀ σ R.
#[inline(always)]
fn store_turned<L: Lane>(frame: &[[Octet; 3]; 3], stress: &Sym<L>, to: &mut [Octet; 6], at: usize) {
    const PAIRS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2)];
    // half = σ R, row k in the frame's axes, column i global.
    let mut half = [[L::splat(0.0); 3]; 3];
    let mut k = 0;
    while k < 3 {
        let mut i = 0;
        while i < 3 {
            let mut sum = stress[VOIGT[k][0]] * L::load(&frame[0][i], at);
            sum = stress[VOIGT[k][1]].mul_add(L::load(&frame[1][i], at), sum);
            half[k][i] = stress[VOIGT[k][2]].mul_add(L::load(&frame[2][i], at), sum);
            i += 1;
        }
        k += 1;
    }
    let mut c = 0;
    while c < 6 {
        let (i, j) = PAIRS[c];
        let mut sum = L::load(&frame[0][i], at) * half[0][j];
        sum = L::load(&frame[1][i], at).mul_add(half[1][j], sum);
        sum = L::load(&frame[2][i], at).mul_add(half[2][j], sum);
        sum.store(&mut to[c], at);
        c += 1;
    }
}
