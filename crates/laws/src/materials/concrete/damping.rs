//! What a damaged point still carries of a damping stress.

use super::{Concrete, D_SHEAR, D_TENSION, bounded};
use crate::lane::Lane;
use crate::material::Sym;
use crate::sym3::eigen;

impl Concrete {
    /// The damping stress in the principal split of the damage: components (i, j) in the principal axes of strain
    /// times √((1 − D_i)(1 − D_j)), D_i by the sign of the effective stress there.
    #[inline(always)]
    pub(super) fn weakened<L: Lane>(&self, damping: Sym<L>, strain: &Sym<L>, history: &[L; 9]) -> Sym<L> {
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        let (tension, shear) = (history[D_TENSION], history[D_SHEAR]);
        if !L::any(zero.less(tension + shear)) {
            return damping;
        }
        let axes = eigen(&bounded(*strain));
        let undamaged = self.undamaged(&axes.values);
        let (plus, minus) = ((one - tension).sqrt(), (one - shear).sqrt());
        let root = [
            L::select(undamaged[0].less(zero), minus, plus),
            L::select(undamaged[1].less(zero), minus, plus),
            L::select(undamaged[2].less(zero), minus, plus),
        ];
        // W = Σ √(1 − D_i) p_i⊗p_i; what is left is W s W.
        let p = &axes.vectors;
        let mut w = [[zero; 3]; 3];
        let mut i = 0;
        while i < 3 {
            let mut j = 0;
            while j < 3 {
                let mut k = 0;
                while k < 3 {
                    w[i][j] = (root[k] * p[k][i]).mul_add(p[k][j], w[i][j]);
                    k += 1;
                }
                j += 1;
            }
            i += 1;
        }
        let s = [
            [damping[0], damping[3], damping[5]],
            [damping[3], damping[1], damping[4]],
            [damping[5], damping[4], damping[2]],
        ];
        let left = product(&w, &product(&s, &w));
        [left[0][0], left[1][1], left[2][2], left[0][1], left[1][2], left[0][2]]
    }
}

#[inline(always)]
fn product<L: Lane>(a: &[[L; 3]; 3], b: &[[L; 3]; 3]) -> [[L; 3]; 3] {
    let mut c = [[L::splat(0.0); 3]; 3];
    let mut i = 0;
    while i < 3 {
        let mut j = 0;
        while j < 3 {
            c[i][j] = a[i][2].mul_add(b[2][j], a[i][1].mul_add(b[1][j], a[i][0] * b[0][j]));
            j += 1;
        }
        i += 1;
    }
    c
}
