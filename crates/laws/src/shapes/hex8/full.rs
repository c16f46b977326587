//! 2×2×2 quadrature of the same assumed-strain field.

use super::modal::{MODES, along_axis, mean_gradient, modal_forces};
use super::{
    Given, Hex8, LEFT, Probe, Stabilisation, Surface, gather_modes, gauss_point, scatter_nodal, store_nodal,
    to_modes, to_nodes,
};
use crate::band::{BandStep, MEMORY};
use crate::lane::{Lane, Octet, Row};
use crate::material::{Material, Point, Sym};

/// Geometry of eight elements; 134 octets, that is 1072 bytes an element.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct FullGeometry {
    /// As in the one-point element.
    gradient: [[Octet; 7]; 3],
    hourglass: [[Octet; 3]; 4],
    axes: [[Octet; 3]; 3],
    /// ℓ_b/ℓ_c of the surface across each natural axis, and its inverse.
    aspects: [[Octet; 2]; 3],
    /// Strain (global axes, engineering shear) for unit s_bc, s_cb and γ of each surface, contraction included.
    surfaces: [[[Octet; 6]; 3]; 3],
    /// Strain for unit s_k4, contraction included.
    fibres: [[Octet; 6]; 3],
    /// det J at the points.
    weights: [Octet; 8],
    /// Weighted means of ξ, η, ζ, ηζ, ξζ, ξη: removed so that a constant stress does no work on the hourglass part.
    means: [Octet; 6],
}

/// ½(u⊗v + v⊗u), as a strain with engineering shear.
fn dyad(u: [f64; 3], v: [f64; 3]) -> [f64; 6] {
    [
        u[0] * v[0],
        u[1] * v[1],
        u[2] * v[2],
        u[0] * v[1] + u[1] * v[0],
        u[1] * v[2] + u[2] * v[1],
        u[2] * v[0] + u[0] * v[2],
    ]
}

/// Strains of the surface across axis `k` for unit s_bc, s_cb and γ, with the contraction that plane stress asks for.
fn surface_strains(hex: &Hex8, k: usize, poisson_plane: f64) -> [[f64; 6]; 3] {
    let (t, u) = (hex.directions[(k + 1) % 3], hex.directions[(k + 2) % 3]);
    let Surface { cosine, stretch, .. } = Surface::across(hex, k);
    // Dual vectors in the surface, and its unit normal.
    let along = [0, 1, 2].map(|i| stretch * (t[i] - cosine * u[i]));
    let across = [0, 1, 2].map(|i| stretch * (u[i] - cosine * t[i]));
    let normal = [t[1] * u[2] - t[2] * u[1], t[2] * u[0] - t[0] * u[2], t[0] * u[1] - t[1] * u[0]];
    let normal = dyad(normal, normal).map(|x| x * stretch);
    let contracted = |strain: [f64; 6], trace: f64| {
        let mut strain = strain;
        for c in 0..6 {
            strain[c] -= poisson_plane * trace * normal[c];
        }
        strain
    };
    [
        contracted(dyad(along, along), stretch),
        contracted(dyad(across, across), stretch),
        contracted(dyad(along, across), -stretch * cosine),
    ]
}

/// Strain of uniaxial stress along axis `k` for a unit stretch.
fn fibre_strain(hex: &Hex8, k: usize, poisson: f64) -> [f64; 6] {
    let t = hex.directions[k];
    let mut strain = dyad(t, t).map(|x| (1.0 + poisson) * x);
    for value in &mut strain[..3] {
        *value -= poisson;
    }
    strain
}

/// Modes of the hourglass strain in the order of `means`.
const STRAIN_MODES: [usize; 6] = [1, 2, 4, 6, 5, 3];
/// ξ at the integration points.
const G: f64 = 0.577_350_269_189_625_8;

impl FullGeometry {
    /// Geometry without extent: forces from it are zero. Pads the last octet of a patch.
    pub const EMPTY: Self = FullGeometry {
        gradient: [[Octet::ZERO; 7]; 3],
        hourglass: [[Octet::ZERO; 3]; 4],
        axes: [[Octet::ZERO; 3]; 3],
        aspects: [[Octet::ZERO; 2]; 3],
        surfaces: [[[Octet::ZERO; 6]; 3]; 3],
        fibres: [[Octet::ZERO; 6]; 3],
        weights: [Octet::ZERO; 8],
        means: [Octet::ZERO; 6],
    };

    /// Puts an element into a lane.
    pub fn set(&mut self, lane: usize, hex: &Hex8, elastic: &Stabilisation) {
        for j in 0..3 {
            for (k, mode) in MODES.into_iter().enumerate() {
                self.gradient[j][k].0[lane] = hex.gradient[mode][j];
            }
            for alpha in 0..4 {
                self.hourglass[alpha][j].0[lane] = hex.hourglass[alpha][j];
            }
            for k in 0..3 {
                self.axes[k][j].0[lane] = hex.directions[k][j] / (8.0 * hex.half_lengths[k]);
            }
        }
        for k in 0..3 {
            let aspect = Surface::across(hex, k).aspect;
            self.aspects[k][0].0[lane] = aspect;
            self.aspects[k][1].0[lane] = 1.0 / aspect;
            let strains = surface_strains(hex, k, elastic.poisson_plane);
            let fibre = fibre_strain(hex, k, elastic.poisson);
            for c in 0..6 {
                for (octets, strain) in self.surfaces[k].iter_mut().zip(&strains) {
                    octets[c].0[lane] = strain[c];
                }
                self.fibres[k][c].0[lane] = fibre[c];
            }
        }
        for p in 0..8 {
            self.weights[p].0[lane] = hex.weights[p];
        }
        for (k, mode) in STRAIN_MODES.into_iter().enumerate() {
            let mean: f64 = (0..8)
                .map(|p| {
                    let xi = gauss_point(p);
                    let value: f64 =
                        (0..3).filter(|axis| mode >> axis & 1 == 1).map(|axis| xi[axis]).product();
                    hex.weights[p] * value
                })
                .sum();
            self.means[k].0[lane] = mean / hex.volume;
        }
    }
}

/// Internal forces of eight elements, added to `out`; history (point by point) is updated in place.
///
/// Arguments and sign as in [`super::one_point`]; strains reach the law in global axes.
///
/// # Safety
/// All indices must be below `rows.len()` and `out.len()`, and the lane's instruction set must be enabled.
#[inline(always)]
pub unsafe fn full<L: Lane, M: Material, const PROBE: bool>(
    material: &M,
    _: &Stabilisation,
    point: &Point<f64>,
    geometry: &FullGeometry,
    index: &[[u16; 8]; 8],
    history: &mut [Octet],
    band: Option<&BandStep>,
    overstress: &mut [Octet],
    given: Given,
    left: &mut [Octet],
    rows: &[Row],
    out: &mut [Row],
    probe: &mut Probe,
) {
    let columns = M::HISTORY.len();
    let mut nodal = [[Octet::ZERO; 3]; 8];
    let mut at = 0;
    while at < 8 {
        // SAFETY: passed on to the caller.
        let mut modes = unsafe { gather_modes::<L>(rows, index, at) };

        let (g0, q0) = mean_gradient::<L>(&geometry.gradient, &geometry.hourglass, &modes[0], at);
        let (g1, q1) = mean_gradient::<L>(&geometry.gradient, &geometry.hourglass, &modes[1], at);
        let (g2, q2) = mean_gradient::<L>(&geometry.gradient, &geometry.hourglass, &modes[2], at);
        let g = [g0, g1, g2];
        let s = [
            along_axis::<L>(&geometry.axes[0], &q0, &q1, &q2, at),
            along_axis::<L>(&geometry.axes[1], &q0, &q1, &q2, at),
            along_axis::<L>(&geometry.axes[2], &q0, &q1, &q2, at),
        ];

        // The strain's modal coefficients by component, from the table in the module documentation.
        let mut e = [[L::splat(0.0); 8]; 6];
        let (gauss, gauss2) = (L::splat(G), L::splat(G * G));
        let mut k = 0;
        while k < 3 {
            let (b, c) = ((k + 1) % 3, (k + 2) % 3);
            let mode = 1 << k;
            let aspects = &geometry.aspects[k];
            let along = s[b][c] * gauss;
            let across = s[c][b] * gauss;
            let gamma = L::load(&aspects[0], at).mul_add(s[b][b], L::load(&aspects[1], at) * s[c][c]) * gauss;
            let fibre = s[k][3] * gauss2;
            let mut v = 0;
            while v < 6 {
                let t = &geometry.surfaces[k];
                let sum = L::load(&t[1][v], at).mul_add(across, L::load(&t[0][v], at) * along);
                e[v][mode] = L::load(&t[2][v], at).mul_add(gamma, sum);
                e[v][7 ^ mode] = L::load(&geometry.fibres[k][v], at) * fibre;
                v += 1;
            }
            k += 1;
        }
        let mut mean: Sym<L> =
            [g[0][0], g[1][1], g[2][2], g[0][1] + g[1][0], g[1][2] + g[2][1], g[0][2] + g[2][0]];
        super::add_initial(&mut mean, given.strain, at);
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
            lane_point.size = super::seen_size(&given, &geometry.gradient, &geometry.hourglass, at);
        }
        let mut energy = L::splat(0.0);
        let (mut dissipated, mut created, mut of_band) = (energy, energy, energy);
        let mut p = 0;
        while p < 8 {
            let strain: Sym<L> = [e[0][p], e[1][p], e[2][p], e[3][p], e[4][p], e[5][p]];
            let own = &mut history[p * columns..(p + 1) * columns];
            let old = super::load_history::<L, M>(own, at);
            let left =
                if M::DAMAGES && !left.is_empty() { &mut left[p * LEFT..(p + 1) * LEFT] } else { &mut [] };
            let (of_law, new) = super::answer(material, &lane_point, strain, old, left, at);
            let weight = L::load(&geometry.weights[p], at);
            let mut stress = of_law;
            let mut held = L::splat(0.0);
            if let Some(band) = band {
                let (before, now) = (super::unbroken(material, &old), super::unbroken(material, &new));
                let memory = &mut overstress[p * MEMORY..(p + 1) * MEMORY];
                stress = super::plus(stress, band.stress(&strain, before, now, memory, at));
                if PROBE {
                    held = band.held(now, memory, at);
                    of_band = weight.mul_add(BandStep::dissipated::<L>(memory, at), of_band);
                }
            }
            super::store_history::<L, M>(new, own, at);
            let mut c = 0;
            while c < 6 {
                e[c][p] = weight * stress[c];
                c += 1;
            }
            if PROBE {
                let stored = material.stored_energy(&strain, &of_law, &new) + held;
                energy = weight.mul_add(stored, energy);
                dissipated = weight.mul_add(super::booked(&new, M::DISSIPATION), dissipated);
                created = weight.mul_add(super::booked(&new, M::CREATION), created);
                let mut c = 0;
                while c < 6 {
                    stress[c].store(&mut probe.stress[p][c], at);
                    c += 1;
                }
            }
            p += 1;
        }
        if PROBE {
            energy.store(&mut probe.strain_energy, at);
            dissipated.store(&mut probe.dissipated, at);
            created.store(&mut probe.created, at);
            of_band.store(&mut probe.of_band, at);
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
        let mut k = 0;
        while k < 3 {
            let (b, c) = ((k + 1) % 3, (k + 2) % 3);
            let mode = 1 << k;
            let t = &geometry.surfaces[k];
            let mut sums = [L::splat(0.0); 4];
            let mut v = 0;
            while v < 6 {
                let resultant = e[v][mode];
                sums[0] = L::load(&t[0][v], at).mul_add(resultant, sums[0]);
                sums[1] = L::load(&t[1][v], at).mul_add(resultant, sums[1]);
                sums[2] = L::load(&t[2][v], at).mul_add(resultant, sums[2]);
                sums[3] = L::load(&geometry.fibres[k][v], at).mul_add(e[v][7 ^ mode], sums[3]);
                v += 1;
            }
            conjugate[b][c] = sums[0] * gauss;
            conjugate[c][b] = sums[1] * gauss;
            let shear = sums[2] * gauss;
            let aspects = &geometry.aspects[k];
            conjugate[b][b] = L::load(&aspects[0], at).mul_add(shear, conjugate[b][b]);
            conjugate[c][c] = L::load(&aspects[1], at).mul_add(shear, conjugate[c][c]);
            conjugate[k][3] = sums[3] * gauss2;
            k += 1;
        }
        let resultants: Sym<L> = [e[0][0], e[1][0], e[2][0], e[3][0], e[4][0], e[5][0]];
        let (b, x, axes) = (&geometry.gradient, &geometry.hourglass, &geometry.axes);
        modes[0] = modal_forces::<L, 0>(b, x, axes, &resultants, &conjugate, at);
        modes[1] = modal_forces::<L, 1>(b, x, axes, &resultants, &conjugate, at);
        modes[2] = modal_forces::<L, 2>(b, x, axes, &resultants, &conjugate, at);
        store_nodal(&mut modes, &mut nodal, at);
        at += L::WIDTH;
    }
    // SAFETY: passed on to the caller.
    unsafe { scatter_nodal::<L>(out, index, &nodal) };
}
