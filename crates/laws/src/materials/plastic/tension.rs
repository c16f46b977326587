//! The tension cut-off σ₁ ≤ f_t in principal stresses, flow normal to it.

use super::Elasticity;
use crate::lane::Lane;

/// What a law's shear envelope leaves of the cut-off: σ₁ ≤ `strength`, and σ₃ ≥ `low` where σ₁ is at it.
#[derive(Clone, Copy)]
pub(in crate::materials) struct CutOff<L> {
    /// f_t \[Pa\], not beyond the envelope's apex.
    pub strength: L,
    /// σ₃ \[Pa\] of the envelope at σ₁ = f_t; equal to f_t at the apex.
    pub low: L,
}

/// Stress after a return, and which lanes flow how.
#[derive(Clone, Copy)]
pub(in crate::materials) struct Returned<L: Lane> {
    /// Largest first \[Pa\].
    pub stress: [L; 3],
    /// Whether the shear envelope is active.
    pub shear: L::Mask,
    /// Whether the cut-off is active.
    pub tension: L::Mask,
}

impl<L: Lane> CutOff<L> {
    /// Completes a return to the shear envelope alone, `sheared`, from the trial stress `s` (both largest first).
    ///
    /// Where σ₁ stays within f_t that return stands: `beyond` marks lanes where it does not, or has no answer. There
    /// the cut-off is active: by itself (face, edge, apex) where the envelope allows what comes of it, else together
    /// with the envelope, on the segment σ₁ = f_t, σ₃ = low, low ≤ σ₂ ≤ f_t. On the segment σ₂ changes by
    /// ν(Δσ₁ + Δσ₃) whatever the dilation, since neither surface flows along it; beyond its ends it is a corner.
    #[inline(always)]
    pub fn complete(
        &self,
        elasticity: &Elasticity,
        s: &[L; 3],
        sheared: [L; 3],
        beyond: L::Mask,
    ) -> Returned<L> {
        let nu = L::splat(elasticity.poisson);
        let ratio = L::splat(elasticity.poisson / (1.0 - elasticity.poisson));
        let (ft, low) = (self.strength, self.low);
        let excess = s[0] - ft;
        let face = ratio.neg_mul_add(excess, s[1]);
        let two = ft.less(face);
        let on_face = ratio.neg_mul_add(excess, s[2]);
        let on_edge = nu.neg_mul_add(excess + (s[1] - ft), s[2]);
        let third = ft.smaller(L::select(two, on_edge, on_face));
        let both = third.less(low);
        let along = nu.neg_mul_add(excess + (s[2] - low), s[1]);
        let along = low.larger(ft.smaller(along));
        let second = L::select(both, along, ft.smaller(face));
        let third = L::select(both, low, third);
        Returned {
            stress: [
                L::select(beyond, ft, sheared[0]),
                L::select(beyond, second, sheared[1]),
                L::select(beyond, third, sheared[2]),
            ],
            shear: L::either(L::not(beyond), both),
            tension: beyond,
        }
    }
}
