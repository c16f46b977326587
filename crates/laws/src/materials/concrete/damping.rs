//! What a damaged point still carries besides the law's own stress.

use super::{Concrete, D_SHEAR, D_TENSION, MEMORY, bounded};
use crate::lane::Lane;
use crate::material::{LEAST_HOURGLASS_SHARE, Sym};
use crate::sym3::eigen;

impl Concrete {
    /// Σ (1 − D_i)^¼ p_i⊗p_i in the principal axes of strain, D_i by the sign of the effective stress there.
    #[inline(always)]
    pub(super) fn left<L: Lane>(&self, strain: &Sym<L>, history: &[L; MEMORY]) -> Sym<L> {
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        let (tension, shear) = (history[D_TENSION], history[D_SHEAR]);
        if !L::any(zero.less(tension + shear)) {
            return [one, one, one, zero, zero, zero];
        }
        let axes = eigen(&bounded(*strain));
        let undamaged = self.undamaged(&axes.values);
        let (plus, minus) = ((one - tension).sqrt().sqrt(), (one - shear).sqrt().sqrt());
        axes.recompose([
            L::select(undamaged[0].less(zero), minus, plus),
            L::select(undamaged[1].less(zero), minus, plus),
            L::select(undamaged[2].less(zero), minus, plus),
        ])
    }

    /// (1 − D⁺)(1 − D⁻), not below [`LEAST_HOURGLASS_SHARE`].
    #[inline(always)]
    pub(super) fn bending_share<L: Lane>(history: &[L; MEMORY]) -> L {
        let one = L::splat(1.0);
        L::splat(LEAST_HOURGLASS_SHARE).larger((one - history[D_TENSION]) * (one - history[D_SHEAR]))
    }
}
