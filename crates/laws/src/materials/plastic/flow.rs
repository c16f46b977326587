//! Shear flow along g = M σ₁ − σ₃: the edge that a return meets, and what flowed in the end.

use super::tension::Returned;
use super::{Elasticity, Memory, SHEAR, STATE, TENSION, state};
use crate::lane::Lane;
use crate::material::Sym;
use crate::sym3::Eigen;

/// A straight way back from a trial stress: σ₁ = `first` − `a1` Γ, σ₃ = `third` − `a3` Γ.
#[derive(Clone, Copy)]
pub(in crate::materials) struct Way<L: Lane> {
    pub first: L,
    pub third: L,
    pub a1: L,
    pub a3: L,
    on_12: L::Mask,
    on_23: L::Mask,
    middle: L,
    a2: L,
}

/// The flow direction with its elastic answer C:(M, 0, −1).
#[derive(Clone, Copy)]
pub(in crate::materials) struct Flow<L> {
    /// M = (1 + sin ψ)/(1 − sin ψ)
    pub ratio: L,
    /// 1/M
    inverse: L,
    /// λ(M − 1)
    bulk: L,
    mu: f64,
}

impl<L: Lane> Flow<L> {
    #[inline(always)]
    pub fn new(elasticity: &Elasticity, ratio: L) -> Self {
        let bulk = L::splat(elasticity.lambda) * (ratio - L::splat(1.0));
        Flow { ratio, inverse: L::splat(1.0) / ratio, bulk, mu: elasticity.mu }
    }

    /// The way that stays in one face, σ₁ > σ₂ > σ₃.
    #[inline(always)]
    pub fn on_face(&self, s: &[L; 3]) -> Way<L> {
        let zero = L::splat(0.0);
        let never = zero.less(zero);
        let mu2 = L::splat(2.0 * self.mu);
        Way {
            first: s[0],
            third: s[2],
            a1: mu2.mul_add(self.ratio, self.bulk),
            a3: self.bulk - mu2,
            on_12: never,
            on_23: never,
            middle: s[1],
            a2: self.bulk,
        }
    }

    /// Where the way on the face meets its first edge: the multiplier there, and whether it is σ₁ = σ₂.
    ///
    /// The differences σ₁ − σ₂ and σ₂ − σ₃ close at 2μM and 2μ. With non-negative multipliers only the edge that is
    /// met first can hold the answer: on σ₂ = σ₃ they need σ₁ − σ₂ ≥ M(σ₂ − σ₃) of the trial, on σ₁ = σ₂ the reverse.
    #[inline(always)]
    pub fn first_edge(&self, s: &[L; 3]) -> (L, L::Mask) {
        let (upper, lower) = (s[0] - s[1], s[1] - s[2]);
        let is_12 = upper.less(self.ratio * lower);
        let inverse = L::splat(0.5 / self.mu);
        (L::select(is_12, upper * self.inverse, lower) * inverse, is_12)
    }

    /// The way along an edge where `on_edge`, with the two equal stresses as one; else the way on the face.
    #[inline(always)]
    pub fn on_edge(&self, s: &[L; 3], on_edge: L::Mask, is_12: L::Mask) -> Way<L> {
        let face = self.on_face(s);
        let on_12 = L::both(on_edge, is_12);
        let on_23 = L::both(on_edge, L::not(is_12));
        let half = L::splat(0.5);
        let mu = L::splat(self.mu);
        Way {
            first: L::select(on_12, (s[0] + s[1]) * half, s[0]),
            third: L::select(on_23, (s[1] + s[2]) * half, s[2]),
            a1: L::select(on_12, mu.mul_add(self.ratio, self.bulk), face.a1),
            a3: L::select(on_23, self.bulk - mu, face.a3),
            on_12,
            on_23,
            ..face
        }
    }

    /// Books what a return took off the trial stress: stress tensor and new history.
    ///
    /// Only shear flow shortens: it shortens by Γ and lengthens by MΓ, on faces and edges alike. So Γ is the sum of
    /// the shortening plastic strains, and what lengthens beyond MΓ is tension's share. √J₂ of a face's flow is
    /// Γ√((M² + M + 1)/3), which edges add up face by face.
    #[inline(always)]
    pub fn book(
        &self,
        elasticity: &Elasticity,
        trial: &Sym<L>,
        eigen: &Eigen<L>,
        returned: &Returned<L>,
        yielding: L::Mask,
        old: &Memory<L>,
    ) -> (Sym<L>, Memory<L>) {
        let zero = L::splat(0.0);
        let s = &returned.stress;
        let off = [eigen.values[0] - s[0], eigen.values[1] - s[1], eigen.values[2] - s[2]];
        let e = elasticity.principal_strain(&off);
        let mut shorter = zero;
        let mut longer = zero;
        let mut i = 0;
        while i < 3 {
            longer = longer + zero.larger(e[i]);
            shorter = shorter + zero.larger(-e[i]);
            i += 1;
        }
        let m = self.ratio;
        let one = L::splat(1.0);
        let root = ((m + one).mul_add(m, one) * L::splat(1.0 / 3.0)).sqrt();
        let shear = L::both(yielding, returned.shear);
        let tension = L::both(yielding, returned.tension);
        let opened = zero.larger(m.neg_mul_add(shorter, longer));
        // Where sides are free of stress and f_t is 0, how closely they are so would decide whether tension yields.
        let noise = eigen.values[0].abs().larger(eigen.values[2].abs()) * L::splat(elasticity.least_opening);
        let tension = L::both(tension, noise.less(opened));

        let mut new = *old;
        new[SHEAR] = old[SHEAR] + L::select(shear, shorter * root, zero);
        new[TENSION] = old[TENSION] + L::select(tension, opened, zero);
        new[STATE] = state(shear, tension, old);
        let stress = eigen.recompose(*s);
        let stress = elasticity.settle(trial, &stress, yielding, &mut new);
        (stress, new)
    }
}

impl<L: Lane> Way<L> {
    /// Principal stresses, largest first, for σ₁, σ₃ and the multiplier Γ at the end of the way.
    #[inline(always)]
    pub fn end(&self, first: L, third: L, gamma: L) -> [L; 3] {
        let middle = self.a2.neg_mul_add(gamma, self.middle);
        [first, L::select(self.on_12, first, L::select(self.on_23, third, middle)), third]
    }
}
