//! Bricks with edges along x, y and z, of which hardly anything need be known.
//!
//! With half-lengths ℓ_k and r_k = 1/(8 ℓ_k) the mean gradient of component i is r_j U_ji, the coordinates of the hourglass
//! patterns vanish, and the amplitudes are the modal displacements themselves, q_iα = U_αi. The shear of the surface across x is
//! γ_yz = r_z q_y2 + r_y q_z3, so not even ratios of lengths are needed. Forces are those of the general element but
//! for round-off.

use super::modal::VOIGT;
use super::one_point::{OnePointShape, Resistance};
use super::{BINARY, Given, HOURGLASS, Hex8, LINEAR};
use crate::lane::{Lane, Octet};
use crate::material::Sym;

/// Geometry of eight bricks whose natural axes are x, y and z; 4 octets, that is 32 bytes an element.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct BrickGeometry {
    /// r_k = 1/(8 ℓ_k) \[1/m\].
    inverse: [Octet; 3],
    volume: Octet,
}

/// How far a corner may lie beside its place in a brick, over the brick's shortest edge: forces then differ by as little.
const SKEW: f64 = 1e-12;

impl Hex8 {
    /// The order of the corners in which the natural axes are x, y and z, if this is a brick with edges along them.
    pub fn upright(&self) -> Option<[usize; 8]> {
        let end = |pick: fn(f64, f64) -> f64| {
            [0, 1, 2].map(|i| self.corners.iter().map(|x| x[i]).reduce(pick).unwrap_or_default())
        };
        let (low, high) = (end(f64::min), end(f64::max));
        let shortest = (0..3).map(|i| high[i] - low[i]).fold(f64::INFINITY, f64::min);
        let mut order = [usize::MAX; 8];
        for (corner, x) in self.corners.iter().enumerate() {
            let mut place = 0;
            for i in 0..3 {
                let up = x[i] - low[i] > high[i] - x[i];
                let beside = if up { high[i] - x[i] } else { x[i] - low[i] };
                if beside > SKEW * shortest {
                    return None;
                }
                place |= usize::from(up) << i;
            }
            // `BINARY` is its own inverse: it swaps two pairs.
            order[BINARY[place]] = corner;
        }
        (!order.contains(&usize::MAX)).then_some(order)
    }
}

impl OnePointShape for BrickGeometry {
    const EMPTY: Self = BrickGeometry { inverse: [Octet::ZERO; 3], volume: Octet::ZERO };

    /// The element's natural axes must be x, y and z ([`Hex8::upright`]).
    fn set(&mut self, lane: usize, hex: &Hex8) {
        for k in 0..3 {
            self.inverse[k].0[lane] = 1.0 / (8.0 * hex.half_lengths[k]);
        }
        self.volume.0[lane] = hex.volume;
    }

    #[inline(always)]
    fn volume<L: Lane>(&self, at: usize) -> L {
        L::load(&self.volume, at)
    }

    /// Of a brick 4 ℓ_k² on the diagonal.
    #[inline(always)]
    fn size<L: Lane>(&self, given: &Given, at: usize) -> Sym<L> {
        if given.size.len() >= 6 {
            return super::load_tensor(given.size, at);
        }
        size_of(&self.lengths::<L>(at))
    }

    #[inline(always)]
    fn gradient<L: Lane>(&self, modes: &[[L; 8]; 3], at: usize) -> [[L; 3]; 3] {
        gradient_of(&self.lengths::<L>(at), modes)
    }

    #[inline(always)]
    fn strain<L: Lane>(&self, modes: &[[L; 8]; 3], at: usize) -> (Sym<L>, [[L; 4]; 3]) {
        let [x, y, z] = LINEAR;
        let r = self.lengths::<L>(at);
        let strain = [
            r[0] * modes[0][x],
            r[1] * modes[1][y],
            r[2] * modes[2][z],
            r[1].mul_add(modes[0][y], r[0] * modes[1][x]),
            r[2].mul_add(modes[1][z], r[1] * modes[2][y]),
            r[2].mul_add(modes[0][z], r[0] * modes[2][x]),
        ];
        let mut amplitudes = [[L::splat(0.0); 4]; 3];
        let mut alpha = 0;
        while alpha < 4 {
            amplitudes[0][alpha] = modes[0][HOURGLASS[alpha]];
            amplitudes[1][alpha] = modes[1][HOURGLASS[alpha]];
            amplitudes[2][alpha] = modes[2][HOURGLASS[alpha]];
            alpha += 1;
        }
        (strain, amplitudes)
    }

    #[inline(always)]
    fn resist<L: Lane>(&self, elastic: Resistance<L>, q: &[[L; 4]; 3], at: usize) -> [[L; 4]; 3] {
        let r = self.lengths::<L>(at);
        let mut f = [[L::splat(0.0); 4]; 3];
        f[0][3] = r[0] * elastic.twist * (r[0] * q[0][3]);
        f[1][3] = r[1] * elastic.twist * (r[1] * q[1][3]);
        f[2][3] = r[2] * elastic.twist * (r[2] * q[2][3]);
        bend::<L, 1, 2>(&r, &elastic, q, &mut f);
        bend::<L, 2, 0>(&r, &elastic, q, &mut f);
        bend::<L, 0, 1>(&r, &elastic, q, &mut f);
        f
    }

    #[inline(always)]
    fn forces<L: Lane, const I: usize>(
        &self,
        resultants: &Sym<L>,
        against: &[[L; 4]; 3],
        at: usize,
    ) -> [L; 8] {
        let r = self.lengths::<L>(at);
        let mut f = [L::splat(0.0); 8];
        let mut j = 0;
        while j < 3 {
            f[LINEAR[j]] = r[j] * resultants[VOIGT[I][j]];
            j += 1;
        }
        let mut alpha = 0;
        while alpha < 4 {
            f[HOURGLASS[alpha]] = against[I][alpha];
            alpha += 1;
        }
        f
    }
}

impl BrickGeometry {
    #[inline(always)]
    fn lengths<L: Lane>(&self, at: usize) -> [L; 3] {
        [L::load(&self.inverse[0], at), L::load(&self.inverse[1], at), L::load(&self.inverse[2], at)]
    }
}

/// Forces against the amplitudes that bend the surface of axes `B` and `C`.
#[inline(always)]
fn bend<L: Lane, const B: usize, const C: usize>(
    r: &[L; 3],
    elastic: &Resistance<L>,
    q: &[[L; 4]; 3],
    f: &mut [[L; 4]; 3],
) {
    let Resistance { bend, less, .. } = *elastic;
    let (a, b) = (r[B] * q[B][C], r[C] * q[C][B]);
    let trace = a + b;
    f[B][C] = r[B] * (bend * less.neg_mul_add(b, trace));
    f[C][B] = r[C] * (bend * less.neg_mul_add(a, trace));
    let gamma = r[C].mul_add(q[B][B], r[B] * q[C][C]);
    let shear = bend * (L::splat(0.5) * less) * gamma;
    f[B][B] = r[C].mul_add(shear, f[B][B]);
    f[C][C] = r[B].mul_add(shear, f[C][C]);
}

/// Mean displacement gradient along the edges, from modal displacements along them.
#[inline(always)]
pub(super) fn gradient_of<L: Lane>(r: &[L; 3], modes: &[[L; 8]; 3]) -> [[L; 3]; 3] {
    let [x, y, z] = LINEAR;
    [
        [r[0] * modes[0][x], r[1] * modes[0][y], r[2] * modes[0][z]],
        [r[0] * modes[1][x], r[1] * modes[1][y], r[2] * modes[1][z]],
        [r[0] * modes[2][x], r[1] * modes[2][y], r[2] * modes[2][z]],
    ]
}

/// The size tensor of a brick, 4 ℓ_k² on the diagonal; zero of one without extent.
#[inline(always)]
pub(super) fn size_of<L: Lane>(r: &[L; 3]) -> Sym<L> {
    let zero = L::splat(0.0);
    let mut size = [zero; 6];
    let mut k = 0;
    while k < 3 {
        let square = L::splat(1.0 / 16.0) / (r[k] * r[k]);
        size[k] = L::select(zero.less(r[k]), square, zero);
        k += 1;
    }
    size
}
