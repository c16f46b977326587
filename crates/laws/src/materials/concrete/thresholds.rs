//! When damage starts, and how far it goes: (8)–(14), with bound tests that spare points far from it the work.

use super::{Concrete, Driver, Evolution, SMOOTHED_TENSION, Split};
use crate::lane::Lane;
use crate::lane::elementary::exp;
use crate::material::Sym;
use crate::sym3::{Spectrum, below, principal_values};

/// Bound tests stand off the thresholds by more than the round-off of what they compare.
const SAFE: f64 = 1.0 - 1e-6;

impl Concrete {
    /// ε_ts
    #[inline(always)]
    pub(super) fn threshold(&self) -> f64 {
        self.ft / self.young
    }

    /// Whether no damage can start, from mean q and radius p of the strain alone.
    ///
    /// ‖⟨ε⟩‖ ≤ 2p + √3⟨q⟩ (2p + q for q < 0), and c1 − N c3 ≤ 3Kq(N − 1) + 4μp √(N² + N + 1), the largest over all
    /// Lode angles; rate factors are at least 1, so static strengths are on the safe side.
    #[inline(always)]
    pub(super) fn far_from_damage<L: Lane>(&self, mean: L, radius: L) -> L::Mask {
        let (bulk3, mu2) = (3.0 * self.moduli.lambda + 2.0 * self.moduli.mu, 2.0 * self.moduli.mu);
        let zero = L::splat(0.0);
        let (mean_weight, radius_weight) = match self.driver {
            Driver::Strain => (1.0, 1.0),
            Driver::Stress => (bulk3 / self.young, mu2 / self.young),
        };
        let mean_part =
            L::select(mean.less(zero), mean, mean * L::splat(3f64.sqrt())) * L::splat(mean_weight);
        let tension = radius.mul_add(L::splat(2.0 * radius_weight), mean_part);
        let n = self.slope;
        let shear = radius
            .mul_add(L::splat(2.0 * mu2 * (n * n + n + 1.0).sqrt()), mean * L::splat(bulk3 * (n - 1.0)));
        L::both(tension.less(L::splat(SAFE * self.threshold())), shear.less(L::splat(SAFE * self.fc)))
    }

    /// The same from the principal values, which are wrong by 1e-8 of the radius where two nearly agree.
    #[inline(always)]
    pub(super) fn below_damage<L: Lane>(&self, radius: L, equivalent: L, undamaged: &[L; 3]) -> L::Mask {
        let (mu2, n) = (2.0 * self.moduli.mu, self.slope);
        let tension_error = match self.driver {
            Driver::Strain => 1e-7,
            Driver::Stress => 1e-7 * mu2 / self.young,
        };
        let tension = radius.mul_add(L::splat(tension_error), equivalent);
        let shear = L::splat(n).mul_add(undamaged[0], -undamaged[2]);
        let shear = radius.mul_add(L::splat(1e-7 * mu2 * (1.0 + n)), shear);
        L::both(tension.less(L::splat(SAFE * self.threshold())), shear.less(L::splat(SAFE * self.fc)))
    }

    /// ε̄ of (9), or its counterpart in stress.
    #[inline(always)]
    pub(super) fn equivalent_strain<L: Lane>(&self, strain: &[L; 3], undamaged: &[L; 3]) -> L {
        let (values, scale) = match self.driver {
            Driver::Strain => (strain, 1.0),
            Driver::Stress => (undamaged, 1.0 / self.young),
        };
        let zero = L::splat(0.0);
        let a = values[0].larger(zero);
        let b = values[1].larger(zero);
        let c = values[2].larger(zero);
        c.mul_add(c, b.mul_add(b, a * a)).sqrt() * L::splat(scale)
    }

    /// ε̄/(ε_ts f_ε) of an undamaged stress \[Pa\], with the rate of a point that has the stress `beside`.
    pub(super) fn used(&self, stress: &Sym<f64>, beside: &Sym<f64>, history: &[f64]) -> f64 {
        let equivalent = |stress: &Sym<f64>| {
            // The other's values are not asked for.
            let values = principal_values(&self.driven_by(stress));
            self.equivalent_strain(&values, &values)
        };
        let at_stress = equivalent(stress);
        let factor = self.rate.as_ref().filter(|law| law.filter > 0.0).map_or(1.0, |law| {
            let at_point = if beside == stress { at_stress } else { equivalent(beside) };
            law.tension.factor((at_point - history[SMOOTHED_TENSION]) / law.filter)
        });
        at_stress / (factor * self.threshold())
    }

    /// Whether [`Concrete::used`] surely is at most `share`: rate factors are at least 1.
    ///
    /// Where no value exceeds x, ε̄ ≤ √3 x; else the values themselves tell, wrong by 1e-8 of the radius where two nearly agree.
    pub(super) fn surely_used_at_most(&self, stress: &Sym<f64>, share: f64) -> bool {
        let driver = self.driven_by(stress);
        let limit = SAFE * share * self.threshold();
        let scale = if self.driver == Driver::Strain { 1.0 } else { self.young };
        if below(&driver, scale * limit / 3f64.sqrt()) {
            return true;
        }
        let spectrum = Spectrum::of(&driver);
        let values = spectrum.values();
        self.equivalent_strain(&values, &values) + 1e-7 * spectrum.radius / scale < limit
    }

    /// The tensor by which damage in tension goes, with tensor shear: the elastic strain of a stress \[Pa\], or the stress itself.
    fn driven_by(&self, stress: &Sym<f64>) -> Sym<f64> {
        match self.driver {
            Driver::Strain => {
                let [xx, yy, zz, xy, yz, zx] = self.moduli.strain(stress);
                [xx, yy, zz, 0.5 * xy, 0.5 * yz, 0.5 * zx]
            }
            Driver::Stress => *stress,
        }
    }

    /// Candidate of D⁺ at ε̄ ≥ ε_t, for thresholds times `factor` and a crack across an extent `size`.
    #[inline(always)]
    pub(super) fn softened<L: Lane>(&self, equivalent: L, factor: L, size: L) -> L {
        let one = L::splat(1.0);
        let start = factor * L::splat(self.threshold());
        let plateau = L::splat(self.alpha) * start / equivalent;
        // An element without a size would divide by zero; it never softens.
        let size = size.larger(L::splat(1e-100));
        match self.evolution {
            Evolution::Ratio { ratio } => {
                let past = (start * L::splat(ratio)).less(equivalent);
                L::select(past, one, one - plateau)
            }
            Evolution::Energy { energy } => {
                let offset = self.threshold() * (1.0 - 0.5 / self.alpha);
                let ultimate = L::splat(energy / (self.alpha * self.ft)) / size + L::splat(offset);
                let past = (factor * ultimate).less(equivalent);
                L::select(past, one, one - plateau)
            }
            Evolution::Exponential { energy } => {
                let width = L::splat(energy / self.ft) / size - L::splat(0.5 * self.threshold());
                // At the limit of size the fall is sheer; an exponent is kept that can be divided by.
                let width = width.larger(L::splat(1e-3 * self.threshold()));
                one - start / equivalent * exp((start - equivalent) / (factor * width))
            }
        }
    }

    /// ε_c of (14) from principal stresses, tension positive and largest first.
    #[inline(always)]
    pub(super) fn shear_threshold<L: Lane>(&self, stress: &[L; 3], tension: L, factor: L) -> L {
        let (least, middle) = (-stress[0], -stress[1]);
        let confinement = if self.split == Split::Effective && self.nominal {
            let carried = (L::splat(1.0) - tension) * least;
            L::select(least.less(L::splat(0.0)), carried, least)
        } else {
            least
        };
        let strength = L::splat(self.slope).mul_add(confinement, L::splat(self.fc) * factor);
        L::splat(self.poisson).neg_mul_add(middle + least, strength) * L::splat(1.0 / self.young)
    }
}
