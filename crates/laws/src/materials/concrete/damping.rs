//! What a damaged point still carries besides the law's own stress.

use super::step::bounded;
use super::{Concrete, D_SHEAR, D_TENSION, MEMORY};
use crate::lane::Lane;
use crate::material::{LEAST_HOURGLASS_SHARE, Sym};
use crate::sym3::{Axes, Spectrum};

/// V of a point without damage.
#[inline(always)]
pub(super) fn whole<L: Lane>() -> Sym<L> {
    let (zero, one) = (L::splat(0.0), L::splat(1.0));
    [one, one, one, zero, zero, zero]
}

impl Concrete {
    /// Σ (1 − D_i)^¼ p_i⊗p_i in the principal axes of strain, D_i by the sign of the effective stress there.
    #[inline(always)]
    pub(super) fn left<L: Lane>(&self, strain: &Sym<L>, history: &[L; MEMORY]) -> Sym<L> {
        if !L::any(L::splat(0.0).less(history[D_TENSION] + history[D_SHEAR])) {
            return whole();
        }
        let axes = Spectrum::of(&bounded(*strain)).axes();
        self.left_along(&axes, &self.undamaged(&axes.values), history)
    }

    /// The same where axes and effective stresses are known already.
    #[inline(always)]
    pub(super) fn left_along<L: Lane>(
        &self,
        axes: &Axes<L>,
        undamaged: &[L; 3],
        history: &[L; MEMORY],
    ) -> Sym<L> {
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        let plus = (one - history[D_TENSION]).sqrt().sqrt();
        let minus = (one - history[D_SHEAR]).sqrt().sqrt();
        let along = [
            L::select(undamaged[0].less(zero), minus, plus),
            L::select(undamaged[1].less(zero), minus, plus),
            L::select(undamaged[2].less(zero), minus, plus),
        ];
        let mut left = axes.compose(along);
        // Axes are square to each other but for round-off; what is whole, as a closed crack is, is whole.
        let damaged = along[0].smaller(along[1].smaller(along[2])).less(one);
        let whole = whole::<L>();
        let mut k = 0;
        while k < 6 {
            left[k] = L::select(damaged, left[k], whole[k]);
            k += 1;
        }
        left
    }

    /// (1 − D⁺)(1 − D⁻), not below [`LEAST_HOURGLASS_SHARE`].
    #[inline(always)]
    pub(super) fn bending_share<L: Lane>(history: &[L; MEMORY]) -> L {
        let one = L::splat(1.0);
        L::splat(LEAST_HOURGLASS_SHARE).larger((one - history[D_TENSION]) * (one - history[D_SHEAR]))
    }
}
