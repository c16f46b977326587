//! The assumed strain in bricks of several points, wherever their edges point.
//!
//! In the frame of its own edges a brick needs little: r_k = 1/(8 ℓ_k), the volume, and how a surface contracts. A shear
//! strain has two coefficients, det J is the same everywhere, no mode of the strain has a mean, and the modes are square to each
//! other over the points: elastic resultants are Hooke's stresses of the coefficients. Laws are isotropic, so they are given strains
//! in that frame. Forces are those of the general element but for round-off.

mod left;
mod points;

pub use left::bricks_left;

use super::field::{FieldShape, Scale};
use super::modal::VOIGT;
use super::{CORNERS, Given, HOURGLASS, Hex8, LINEAR, Stabilisation, to_modes, to_nodes};
use crate::lane::{Lane, Octet};
use crate::material::Sym;

/// How far a corner may lie beside its place in a brick, over the brick's shortest edge: forces then differ by as little.
const SKEW: f64 = 1e-12;

impl Hex8 {
    /// Whether this is a brick: its edges are square to each other.
    pub fn is_brick(&self) -> bool {
        let mean = [0, 1, 2].map(|i| 0.125 * self.corners.iter().map(|x| x[i]).sum::<f64>());
        let shortest = 2.0 * self.half_lengths.iter().copied().fold(f64::INFINITY, f64::min);
        let off = |k: usize, l: usize| -> f64 {
            (0..3).map(|i| self.directions[k][i] * self.directions[l][i]).sum::<f64>().abs()
        };
        let longest = self.half_lengths.iter().copied().fold(0.0, f64::max);
        let square = [(0, 1), (1, 2), (2, 0)].iter().all(|&(k, l)| off(k, l) * longest <= SKEW * shortest);
        square
            && self.corners.iter().zip(CORNERS).all(|(x, xi)| {
                (0..3).all(|i| {
                    let place: f64 =
                        (0..3).map(|k| xi[k] * self.half_lengths[k] * self.directions[k][i]).sum();
                    (x[i] - mean[i] - place).abs() <= SKEW * shortest
                })
            })
    }
}

/// Geometry of eight bricks; 14 octets, that is 112 bytes an element.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct BrickField {
    /// r_k = 1/(8 ℓ_k) \[1/m\].
    inverse: [Octet; 3],
    /// Unit vectors t_k along the edges: `[k][i]`.
    axes: [[Octet; 3]; 3],
    /// An eighth of the volume \[m³\].
    weight: Octet,
    /// ν/(1 − ν), or what stands for it ([`Stabilisation::flowing`]), and ν.
    contraction: [f64; 2],
}

/// Mode that a shear strain of xy, yz and zx has beside the constant.
const SHEAR: [usize; 3] = [4, 1, 2];
/// The two others of ξ, η and ζ.
const BESIDE: [[usize; 2]; 3] = [[1, 2], [2, 4], [4, 1]];

impl BrickField {
    /// Without extent: forces from it are zero. Pads the last octet of a patch.
    pub const EMPTY: Self = BrickField {
        inverse: [Octet::ZERO; 3],
        axes: [[Octet::ZERO; 3]; 3],
        weight: Octet::ZERO,
        contraction: [0.0; 2],
    };

    /// Puts an element, which must be a brick ([`Hex8::is_brick`]), into a lane.
    fn put(&mut self, lane: usize, hex: &Hex8, elastic: &Stabilisation) {
        for k in 0..3 {
            self.inverse[k].0[lane] = 1.0 / (8.0 * hex.half_lengths[k]);
            for i in 0..3 {
                self.axes[k][i].0[lane] = hex.directions[k][i];
            }
        }
        self.weight.0[lane] = 0.125 * hex.volume;
        self.contraction = [elastic.poisson_plane, elastic.poisson];
    }

    /// Modal values along the edges.
    #[inline(always)]
    fn along<L: Lane>(&self, u: &[[L; 8]; 3], at: usize) -> [[L; 8]; 3] {
        [
            self.along_edge::<L>(&self.axes[0], u, at),
            self.along_edge::<L>(&self.axes[1], u, at),
            self.along_edge::<L>(&self.axes[2], u, at),
        ]
    }

    #[inline(always)]
    fn along_edge<L: Lane>(&self, axis: &[Octet; 3], u: &[[L; 8]; 3], at: usize) -> [L; 8] {
        let t = [L::load(&axis[0], at), L::load(&axis[1], at), L::load(&axis[2], at)];
        let mut along = [L::splat(0.0); 8];
        let mut mode = 1;
        while mode < 8 {
            along[mode] = t[2].mul_add(u[2][mode], t[1].mul_add(u[1][mode], t[0] * u[0][mode]));
            mode += 1;
        }
        along
    }

    /// The transpose, one component of it.
    #[inline(always)]
    fn back<L: Lane, const I: usize>(&self, f: &[[L; 8]; 3], at: usize) -> [L; 8] {
        let t = [L::load(&self.axes[0][I], at), L::load(&self.axes[1][I], at), L::load(&self.axes[2][I], at)];
        let mut back = [L::splat(0.0); 8];
        let mut mode = 1;
        while mode < 8 {
            back[mode] = t[2].mul_add(f[2][mode], t[1].mul_add(f[1][mode], t[0] * f[0][mode]));
            mode += 1;
        }
        back
    }

    /// Σ_ij t_ai t_bj s_ij of a symmetric tensor with tensor shear.
    #[inline(always)]
    fn component<L: Lane>(&self, s: &Sym<L>, a: &[L; 3], b: &[L; 3]) -> L {
        let x = s[5].mul_add(b[2], s[3].mul_add(b[1], s[0] * b[0]));
        let y = s[4].mul_add(b[2], s[1].mul_add(b[1], s[3] * b[0]));
        let z = s[2].mul_add(b[2], s[4].mul_add(b[1], s[5] * b[0]));
        a[2].mul_add(z, a[1].mul_add(y, a[0] * x))
    }

    /// A symmetric tensor in the frame of the edges from one in global axes, both with tensor shear.
    #[inline(always)]
    fn turned<L: Lane>(&self, s: &Sym<L>, at: usize) -> Sym<L> {
        let t = self.rows::<L>(at);
        self.between(s, &t[0], &t[1], &t[2])
    }

    #[inline(always)]
    fn rows<L: Lane>(&self, at: usize) -> [[L; 3]; 3] {
        let mut t = [[L::splat(0.0); 3]; 3];
        let mut k = 0;
        while k < 3 {
            t[k] =
                [L::load(&self.axes[k][0], at), L::load(&self.axes[k][1], at), L::load(&self.axes[k][2], at)];
            k += 1;
        }
        t
    }

    #[inline(always)]
    fn between<L: Lane>(&self, s: &Sym<L>, a: &[L; 3], b: &[L; 3], c: &[L; 3]) -> Sym<L> {
        [
            self.component(s, a, a),
            self.component(s, b, b),
            self.component(s, c, c),
            self.component(s, a, b),
            self.component(s, b, c),
            self.component(s, c, a),
        ]
    }

    #[inline(always)]
    fn lengths<L: Lane>(&self, at: usize) -> [L; 3] {
        [L::load(&self.inverse[0], at), L::load(&self.inverse[1], at), L::load(&self.inverse[2], at)]
    }

    /// Strain of the modes of axis `K` and of the surface of axes `B` and `C` across it.
    #[inline(always)]
    fn strain_across<L: Lane, const K: usize, const B: usize, const C: usize>(
        &self,
        u: &[[L; 8]; 3],
        r: &[L; 3],
        scale: &Scale,
        e: &mut [[L; 8]; 6],
    ) {
        let [plane, poisson] = self.contraction;
        let (mode, linear) = (LINEAR[K], L::splat(scale.linear[K]));
        let along = r[B] * u[B][HOURGLASS[C]] * linear;
        let across = r[C] * u[C][HOURGLASS[B]] * linear;
        e[B][mode] = along;
        e[C][mode] = across;
        e[K][mode] = L::splat(-plane) * (along + across);
        let gamma = r[C].mul_add(u[B][HOURGLASS[B]], r[B] * u[C][HOURGLASS[C]]);
        e[VOIGT[B][C]][mode] = gamma * linear;
        let fibre = r[K] * u[K][HOURGLASS[3]] * L::splat(scale.product[K]);
        let less = L::splat(-poisson) * fibre;
        e[K][7 ^ mode] = fibre;
        e[B][7 ^ mode] = less;
        e[C][7 ^ mode] = less;
    }

    /// The transpose.
    #[inline(always)]
    fn forces_across<L: Lane, const K: usize, const B: usize, const C: usize>(
        &self,
        e: &[[L; 8]; 6],
        r: &[L; 3],
        scale: &Scale,
        f: &mut [[L; 8]; 3],
    ) {
        let [plane, poisson] = self.contraction;
        let (mode, linear) = (LINEAR[K], L::splat(scale.linear[K]));
        let plane = L::splat(plane);
        f[B][HOURGLASS[C]] = r[B] * (plane.neg_mul_add(e[K][mode], e[B][mode]) * linear);
        f[C][HOURGLASS[B]] = r[C] * (plane.neg_mul_add(e[K][mode], e[C][mode]) * linear);
        let shear = e[VOIGT[B][C]][mode] * linear;
        f[B][HOURGLASS[B]] = r[C].mul_add(shear, f[B][HOURGLASS[B]]);
        f[C][HOURGLASS[C]] = r[B].mul_add(shear, f[C][HOURGLASS[C]]);
        let sideways = e[B][7 ^ mode] + e[C][7 ^ mode];
        let fibre = L::splat(poisson).neg_mul_add(sideways, e[K][7 ^ mode]);
        f[K][HOURGLASS[3]] = r[K] * (fibre * L::splat(scale.product[K]));
    }
}

impl FieldShape for BrickField {
    #[inline(always)]
    fn strain<L: Lane>(&self, u: &[[L; 8]; 3], scale: &Scale, initial: &[Octet], at: usize) -> [[L; 8]; 6] {
        let (r, u) = (self.lengths::<L>(at), &self.along(u, at));
        let [x, y, z] = LINEAR;
        let mut mean = [
            r[0] * u[0][x],
            r[1] * u[1][y],
            r[2] * u[2][z],
            r[1].mul_add(u[0][y], r[0] * u[1][x]),
            r[2].mul_add(u[1][z], r[1] * u[2][y]),
            r[2].mul_add(u[0][z], r[0] * u[2][x]),
        ];
        if initial.len() >= 6 {
            let half = L::splat(0.5);
            let mut begins: Sym<L> = super::load_tensor(initial, at);
            begins = [begins[0], begins[1], begins[2], half * begins[3], half * begins[4], half * begins[5]];
            begins = self.turned(&begins, at);
            let mut c = 0;
            while c < 3 {
                mean[c] = mean[c] + begins[c];
                mean[3 + c] = mean[3 + c] + (begins[3 + c] + begins[3 + c]);
                c += 1;
            }
        }
        let mut e = [[L::splat(0.0); 8]; 6];
        let mut c = 0;
        while c < 6 {
            e[c][0] = mean[c];
            c += 1;
        }
        self.strain_across::<L, 0, 1, 2>(u, &r, scale, &mut e);
        self.strain_across::<L, 1, 2, 0>(u, &r, scale, &mut e);
        self.strain_across::<L, 2, 0, 1>(u, &r, scale, &mut e);
        e
    }

    #[inline(always)]
    fn forces<L: Lane>(&self, e: [[L; 8]; 6], scale: &Scale, at: usize) -> [[L; 8]; 3] {
        let r = self.lengths::<L>(at);
        let mut f = [[L::splat(0.0); 8]; 3];
        let mut i = 0;
        while i < 3 {
            let mut j = 0;
            while j < 3 {
                f[i][LINEAR[j]] = r[j] * e[VOIGT[i][j]][0];
                j += 1;
            }
            i += 1;
        }
        self.forces_across::<L, 0, 1, 2>(&e, &r, scale, &mut f);
        self.forces_across::<L, 1, 2, 0>(&e, &r, scale, &mut f);
        self.forces_across::<L, 2, 0, 1>(&e, &r, scale, &mut f);
        [self.back::<L, 0>(&f, at), self.back::<L, 1>(&f, at), self.back::<L, 2>(&f, at)]
    }

    /// 4 ℓ_k² on the diagonal, in the frame of the edges.
    #[inline(always)]
    fn dilatation<L: Lane>(&self, e: &[[L; 8]; 6], _: &Scale, _: usize) -> L {
        e[0][0] + e[1][0] + e[2][0]
    }

    #[inline(always)]
    fn press<L: Lane>(&self, resultants: &mut [[L; 8]; 6], pressure: L, _: &Scale, _: usize) {
        let mut c = 0;
        while c < 3 {
            resultants[c][0] = resultants[c][0] - pressure;
            c += 1;
        }
    }

    #[inline(always)]
    fn size<L: Lane>(&self, given: &Given, at: usize) -> Sym<L> {
        if given.size.len() >= 6 {
            return self.turned(&super::load_tensor(given.size, at), at);
        }
        super::brick::size_of(&self.lengths::<L>(at))
    }

    #[inline(always)]
    fn gradient<L: Lane>(&self, modes: &[[L; 8]; 3], at: usize) -> [[L; 3]; 3] {
        super::brick::gradient_of(&self.lengths::<L>(at), &self.along(modes, at))
    }

    #[inline(always)]
    fn global<L: Lane>(&self, stress: &Sym<L>, at: usize) -> Sym<L> {
        let t = self.rows::<L>(at);
        let x = [t[0][0], t[1][0], t[2][0]];
        let y = [t[0][1], t[1][1], t[2][1]];
        let z = [t[0][2], t[1][2], t[2][2]];
        self.between(stress, &x, &y, &z)
    }

    #[inline(always)]
    fn local<L: Lane>(&self, stress: &Sym<L>, at: usize) -> Sym<L> {
        self.turned(stress, at)
    }

    #[inline(always)]
    fn to_points<L: Lane>(e: &mut [[L; 8]; 6]) {
        to_nodes(&mut e[0]);
        to_nodes(&mut e[1]);
        to_nodes(&mut e[2]);
        let mut s = 0;
        while s < 3 {
            let (low, high) = (e[3 + s][0] - e[3 + s][SHEAR[s]], e[3 + s][0] + e[3 + s][SHEAR[s]]);
            let mut p = 0;
            while p < 8 {
                e[3 + s][p] = if p & SHEAR[s] == 0 { low } else { high };
                p += 1;
            }
            s += 1;
        }
    }

    #[inline(always)]
    fn to_resultants<L: Lane>(e: &mut [[L; 8]; 6]) {
        to_modes(&mut e[0]);
        to_modes(&mut e[1]);
        to_modes(&mut e[2]);
        let mut s = 0;
        while s < 3 {
            let e = &mut e[3 + s];
            let [a, b] = BESIDE[s];
            let low = (e[0] + e[a]) + (e[b] + e[a ^ b]);
            let m = SHEAR[s];
            let high = (e[m] + e[m ^ a]) + (e[m ^ b] + e[m ^ a ^ b]);
            e[0] = low + high;
            e[m] = high - low;
            s += 1;
        }
    }
}
