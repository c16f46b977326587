//! How far cracks are open.
//!
//! A smeared crack is as wide as the strain that the stress does not explain, e_i = ε_i − \[σ_i − ν(σ_j + σ_k)\]/E, is
//! over the element's extent along its normal. Directions are those of the strain now: the extent at first damage, which
//! sets the softening, is that of another direction where a lining of 0.5 × 2 m cracks along its ring and then splits
//! parallel to its wall. Lateral strain of pressed concrete is explained by its stress and opens nothing.
//!
//! Where cracks of several directions are open, w² is the largest principal value of e⁺·G·e⁺ with e⁺ = Σ⟨e_i⟩ p_i⊗p_i and the
//! size tensor G: the mean square over the corners of how far e⁺ moves them apart along the worst direction. It does not
//! depend on how axes are chosen where e_i are equal, is √(p·G·p) e of a single crack with the normal p, and the widest of
//! several whose normals lie along a brick's edges.
//!
//! All of e⁺·G·e⁺ is kept beside the width: its principal directions are the normals of the cracks, each with a width of its own, the root of
//! the principal value. Of a single crack the only one is p. Strain and stress of the law have the same axes, so none turns with the other.
//!
//! Nothing but results reads them, so they are found in steps at which somebody looks ([`Point::looked_at`]).

use super::{CRACK_WIDTH, Concrete, D_TENSION, MEMORY, OPENINGS};
use crate::lane::Lane;
use crate::material::{Point, Sym};
use crate::sym3::{Eigen, Spectrum};

/// a·G·b
#[inline(always)]
fn between<L: Lane>(size: &Sym<L>, a: &[L; 3], b: &[L; 3]) -> L {
    let [xx, yy, zz, xy, yz, zx] = *size;
    let x = zx.mul_add(b[2], xy.mul_add(b[1], xx * b[0]));
    let y = yz.mul_add(b[2], yy.mul_add(b[1], xy * b[0]));
    let z = zz.mul_add(b[2], yz.mul_add(b[1], zx * b[0]));
    z.mul_add(a[2], y.mul_add(a[1], x * a[0]))
}

/// m·G·m of symmetric m and G.
#[inline(always)]
fn squared<L: Lane>(m: &Sym<L>, size: &Sym<L>) -> Sym<L> {
    let [xx, yy, zz, xy, yz, zx] = *m;
    let rows = [[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]];
    // Written out: a closure would leave the kernel's instruction set.
    let [x, y, z] = &rows;
    [
        between(size, x, x),
        between(size, y, y),
        between(size, z, z),
        between(size, x, y),
        between(size, y, z),
        between(size, z, x),
    ]
}

impl Concrete {
    /// Writes the width of the widest crack \[m\], and e⁺·G·e⁺ \[m²\], at the strain with these axes and at its stress, for the damage in `new`.
    #[inline(always)]
    pub(super) fn open<L: Lane>(
        &self,
        point: &Point<L>,
        strain: &Eigen<L>,
        stress: &[L; 3],
        new: &mut [L; MEMORY],
    ) {
        let zero = L::splat(0.0);
        // What is no more than the round-off of the difference opens nothing.
        let least = L::splat(1e-9 * self.threshold());
        let cracked = zero.less(new[D_TENSION]);
        let (of_own, of_all) =
            (L::splat((1.0 + self.poisson) / self.young), L::splat(self.poisson / self.young));
        let trace = stress[0] + stress[1] + stress[2];
        let mut e = [zero; 3];
        let mut i = 0;
        while i < 3 {
            let beyond = of_all.mul_add(trace, of_own.neg_mul_add(stress[i], strain.values[i]));
            e[i] = L::select(L::both(cracked, least.less(beyond)), beyond, zero);
            i += 1;
        }
        // The values fall, so the first is the largest.
        let first = &strain.vectors[0];
        let mut width = e[0] * point.extent(first);
        let several = zero.less(e[1]);
        if L::any(several) {
            let one = L::splat(1.0);
            let [_, second, third] = &strain.vectors;
            let (b, c) = (
                L::select(several, e[1], zero) / L::select(several, e[0], one),
                L::select(several, e[2], zero) / L::select(several, e[0], one),
            );
            let apart = [
                between(&point.size, first, first),
                b * b * between(&point.size, second, second),
                c * c * between(&point.size, third, third),
                b * between(&point.size, first, second),
                b * c * between(&point.size, second, third),
                c * between(&point.size, third, first),
            ];
            let together = e[0] * Spectrum::of(&apart).values()[0].larger(zero).sqrt();
            width = L::select(several, together, width);
        }
        // Of a strain that is no number the directions are none either.
        let open = zero.less(e[0]);
        new[CRACK_WIDTH] = L::select(open, width, zero);
        let opened = squared(&strain.recompose(e), &point.size);
        let mut k = 0;
        while k < 6 {
            new[OPENINGS + k] = L::select(open, opened[k], zero);
            k += 1;
        }
    }
}
