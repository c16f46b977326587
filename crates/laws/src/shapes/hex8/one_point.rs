//! One-point quadrature with the hourglass part integrated in closed form.

use super::{
    HOURGLASS, Hex8, Probe, Stabilisation, gather_modes, scatter_nodal, store_nodal,
};
use crate::lane::{Lane, Octet, Row};
use crate::material::{Material, Point, Sym};

/// Geometry of eight elements; 48 octets, that is 384 bytes an element.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct OnePointGeometry {
    /// Mean gradient b_mj: `[j][k]`, k over the modes ξ, η, ζ and then the four hourglass ones.
    gradient: [[Octet; 7]; 3],
    /// X_αj: `[α][j]`.
    hourglass: [[Octet; 3]; 4],
    /// Frame over half-lengths, with the ⅛ of γ: R_ki/(8 ℓ_k).
    axes: [[Octet; 3]; 3],
    /// ℓ_k² Σ_{l≠k} 1/ℓ_l².
    ratios: [Octet; 3],
    volume: Octet,
}

const MODES: [usize; 7] = [1, 2, 4, HOURGLASS[0], HOURGLASS[1], HOURGLASS[2], HOURGLASS[3]];

/// Column of component (i, j) in a symmetric tensor.
const VOIGT: [[usize; 3]; 3] = [[0, 3, 5], [3, 1, 4], [5, 4, 2]];

impl OnePointGeometry {
    /// Geometry without extent: forces from it are zero. Pads the last octet of a patch.
    pub const EMPTY: Self = OnePointGeometry {
        gradient: [[Octet::ZERO; 7]; 3],
        hourglass: [[Octet::ZERO; 3]; 4],
        axes: [[Octet::ZERO; 3]; 3],
        ratios: [Octet::ZERO; 3],
        volume: Octet::ZERO,
    };

    /// Puts an element into a lane.
    pub fn set(&mut self, lane: usize, hex: &Hex8) {
        for j in 0..3 {
            for (k, mode) in MODES.into_iter().enumerate() {
                self.gradient[j][k].0[lane] = hex.gradient[mode][j];
            }
            for alpha in 0..4 {
                self.hourglass[alpha][j].0[lane] = hex.hourglass[alpha][j];
            }
            for k in 0..3 {
                self.axes[k][j].0[lane] = hex.frame[k][j] / (8.0 * hex.half_lengths[k]);
            }
        }
        let inverse = hex.half_lengths.map(|l| 1.0 / (l * l));
        let sum: f64 = inverse.iter().sum();
        for k in 0..3 {
            self.ratios[k].0[lane] = (sum - inverse[k]) / inverse[k];
        }
        self.volume.0[lane] = hex.volume;
    }
}

/// Internal forces of eight elements, added to `out`; history is updated in place.
///
/// `index[corner][lane]` points into `rows` (displacements \[m\]) and `out` (forces \[N\], the sign of ∫Bᵀσ).
/// With `PROBE` the stresses and energies go to `probe` as well.
///
/// # Safety
/// All indices must be below `rows.len()` and `out.len()`, and the lane's instruction set must be enabled.
#[inline(always)]
#[allow(clippy::too_many_arguments)]
pub unsafe fn one_point<L: Lane, M: Material, const PROBE: bool>(
    material: &M,
    elastic: &Stabilisation,
    point: &Point<f64>,
    geometry: &OnePointGeometry,
    index: &[[u16; 8]; 8],
    history: &mut [Octet],
    rows: &[Row],
    out: &mut [Row],
    probe: &mut Probe,
) {
    let mut nodal = [[Octet::ZERO; 3]; 8];
    let mut at = 0;
    while at < 8 {
        // SAFETY: passed on to the caller.
        let mut modes = unsafe { gather_modes::<L>(rows, index, at) };

        // Spelt out by component: a loop over them would keep the arrays out of registers.
        let (g0, q0) = gradient::<L>(geometry, &modes[0], at);
        let (g1, q1) = gradient::<L>(geometry, &modes[1], at);
        let (g2, q2) = gradient::<L>(geometry, &modes[2], at);
        let g = [g0, g1, g2];

        let strain: Sym<L> = [
            g[0][0],
            g[1][1],
            g[2][2],
            g[0][1] + g[1][0],
            g[1][2] + g[2][1],
            g[0][2] + g[2][0],
        ];
        let mut lane_point = Point::new(L::splat(point.dt));
        if M::NEEDS_SIZE {
            lane_point.size = super::size::size_tensor(&geometry.gradient, &geometry.hourglass, at);
        }
        let old = super::load_history::<L, M>(history, at);
        let (stress, new) = material.update(&lane_point, strain, old);
        super::store_history::<L, M>(new, history, at);

        // Hourglass amplitudes in the frame, over half-lengths, and their conjugate forces.
        let s = [
            turned::<L>(&geometry.axes[0], &q0, &q1, &q2, at),
            turned::<L>(&geometry.axes[1], &q0, &q1, &q2, at),
            turned::<L>(&geometry.axes[2], &q0, &q1, &q2, at),
        ];
        let volume = L::load(&geometry.volume, at);
        let third = volume * L::splat(1.0 / 3.0);
        let bend = third * L::splat(elastic.plane_stress);
        let shear = third * L::splat(elastic.mu);
        let twist = volume * L::splat(elastic.young / 9.0);
        let nu = L::splat(elastic.poisson);
        let p = [
            [
                shear * (L::load(&geometry.ratios[0], at).mul_add(s[0][0], s[1][1] + s[2][2])),
                bend * nu.mul_add(s[1][0], s[0][1]),
                bend * nu.mul_add(s[2][0], s[0][2]),
                twist * s[0][3],
            ],
            [
                bend * nu.mul_add(s[0][1], s[1][0]),
                shear * (L::load(&geometry.ratios[1], at).mul_add(s[1][1], s[0][0] + s[2][2])),
                bend * nu.mul_add(s[2][1], s[1][2]),
                twist * s[1][3],
            ],
            [
                bend * nu.mul_add(s[0][2], s[2][0]),
                bend * nu.mul_add(s[1][2], s[2][1]),
                shear * (L::load(&geometry.ratios[2], at).mul_add(s[2][2], s[0][0] + s[1][1])),
                twist * s[2][3],
            ],
        ];

        if PROBE {
            let half = L::splat(0.5);
            let mut density = L::splat(0.0);
            let mut i = 0;
            while i < 6 {
                stress[i].store(&mut probe.stress[0][i], at);
                density = stress[i].mul_add(strain[i], density);
                i += 1;
            }
            (half * volume * density).store(&mut probe.strain_energy, at);
            let mut energy = L::splat(0.0);
            let mut k = 0;
            while k < 3 {
                let mut alpha = 0;
                while alpha < 4 {
                    energy = p[k][alpha].mul_add(s[k][alpha], energy);
                    alpha += 1;
                }
                k += 1;
            }
            (half * energy).store(&mut probe.hourglass_energy, at);
        }

        modes[0] = modal_forces::<L, 0>(geometry, volume, &stress, &p, at);
        modes[1] = modal_forces::<L, 1>(geometry, volume, &stress, &p, at);
        modes[2] = modal_forces::<L, 2>(geometry, volume, &stress, &p, at);
        store_nodal(&mut modes, &mut nodal, at);
        at += L::WIDTH;
    }
    // SAFETY: passed on to the caller.
    unsafe { scatter_nodal::<L>(out, index, &nodal) };
}

/// Mean gradient g_ij over j, and U_αi − Σ_j X_αj g_ij over α, of one component's modal displacements.
#[inline(always)]
fn gradient<L: Lane>(geometry: &OnePointGeometry, u: &[L; 8], at: usize) -> ([L; 3], [L; 4]) {
    let mut g = [L::splat(0.0); 3];
    let mut j = 0;
    while j < 3 {
        let b = &geometry.gradient[j];
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
        let x = &geometry.hourglass[alpha];
        let mut sum = L::load(&x[0], at).neg_mul_add(g[0], u[HOURGLASS[alpha]]);
        sum = L::load(&x[1], at).neg_mul_add(g[1], sum);
        q[alpha] = L::load(&x[2], at).neg_mul_add(g[2], sum);
        alpha += 1;
    }
    (g, q)
}

/// s_kα over α: the amplitudes along axis k of the frame, over its half-length.
#[inline(always)]
fn turned<L: Lane>(axis: &[Octet; 3], q0: &[L; 4], q1: &[L; 4], q2: &[L; 4], at: usize) -> [L; 4] {
    let (r0, r1, r2) = (L::load(&axis[0], at), L::load(&axis[1], at), L::load(&axis[2], at));
    let mut s = [L::splat(0.0); 4];
    let mut alpha = 0;
    while alpha < 4 {
        s[alpha] = r2.mul_add(q2[alpha], r1.mul_add(q1[alpha], r0 * q0[alpha]));
        alpha += 1;
    }
    s
}

/// Modal forces of component `I`: conjugate to q_αi, then to g_ij, then to the modes.
#[inline(always)]
fn modal_forces<L: Lane, const I: usize>(
    geometry: &OnePointGeometry,
    volume: L,
    stress: &Sym<L>,
    p: &[[L; 4]; 3],
    at: usize,
) -> [L; 8] {
    let r0 = L::load(&geometry.axes[0][I], at);
    let r1 = L::load(&geometry.axes[1][I], at);
    let r2 = L::load(&geometry.axes[2][I], at);
    let mut force = [L::splat(0.0); 4];
    let mut alpha = 0;
    while alpha < 4 {
        force[alpha] = r2.mul_add(p[2][alpha], r1.mul_add(p[1][alpha], r0 * p[0][alpha]));
        alpha += 1;
    }
    let mut t = [L::splat(0.0); 3];
    let mut j = 0;
    while j < 3 {
        let mut sum = volume * stress[VOIGT[I][j]];
        let mut alpha = 0;
        while alpha < 4 {
            sum = L::load(&geometry.hourglass[alpha][j], at).neg_mul_add(force[alpha], sum);
            alpha += 1;
        }
        t[j] = sum;
        j += 1;
    }
    let mut f = [L::splat(0.0); 8];
    let mut k = 0;
    while k < 7 {
        let b0 = L::load(&geometry.gradient[0][k], at);
        let mut sum = if k < 3 { b0 * t[0] } else { b0.mul_add(t[0], force[k - 3]) };
        sum = L::load(&geometry.gradient[1][k], at).mul_add(t[1], sum);
        f[MODES[k]] = L::load(&geometry.gradient[2][k], at).mul_add(t[2], sum);
        k += 1;
    }
    f
}
