//! Concrete with rate-dependent damage, separate in tension and in shear.
//!
//! Wang, Chen, Xiao & Deng (2018), equations (1)–(16). Strain ε is counted since the concrete was placed, σ̂_i and
//! p_i are principal values and directions of the effective stress C : ε.
//!
//! - (2)–(7) σ = Σ (1 − D_i) σ̂_i p_i⊗p_i, D_i = D⁺ where σ̂_i ≥ 0, else D⁻: a crack that closes carries pressure again.
//! - (8)–(12) tension: ε̄ = √Σ⟨ε_i⟩²; D⁺ = 0 below ε_t = f_ε f_t/E, then 1 − α ε_t/ε̄, and 1 beyond ε_u = f_ε ε_us.
//! - (13)–(16) shear, compression positive, c1 ≥ c2 ≥ c3: D⁻ = 1 − β ε_c/e1 from e1 = ε_c on,
//!   ε_c = \[f_c + N c3′ − ν(c2 + c3)\]/E, N = (1 + sin φ)/(1 − sin φ), e1 the largest compressive strain.
//!   As e1 = \[c1 − ν(c2 + c3)\]/E this is Mohr–Coulomb's c1 ≥ f_c + N c3′.
//! - Both are running maxima. Rates are those of strains smoothed over τ, so that noise of the mesh is none; factors
//!   are frozen at first damage, since the rate of a localised crack is an artefact of the mesh.
//!
//! **Where the print is corrected.** (14) prints the stresses without 1/E and ν(σ1 + σ2): units, and the strain in
//! the direction of c1 has ν(c2 + c3). (12) prints ε̇_s = 0.3 s⁻¹, which no earthquake reaches; the CEB law it cites
//! starts at 3·10⁻⁵ s⁻¹, and `reference_rate = 0.3` brings the print back. (13) with effective tension fails any
//! cracked point under a trace of compression: c3′ = (1 − D⁺) c3 in tension (`shear_tension = "effective"` is the
//! print). In (7) the effective split has no potential where ν ≠ 0 and D⁺ ≠ D⁻: a closed loop of strain at fixed
//! damage can give out work, up to 0.39 of its peak energy; `split = "compliance"` cannot, and its dissipation is
//! never negative.
//!
//! **Beyond the paper.** `fracture_energy` sets ε_us from the element's extent h across the crack,
//! ε_us = ε_ts + (G_f/h − ½f_t ε_ts)/(α f_t); `evolution = "exponential"` is the crack band (Bažant & Oh 1983),
//! D⁺ = 1 − (ε_t/ε̄) exp\[−(ε̄ − ε_t)/ε_f\], ε_f = f_ε\[G_f/(f_t h) − ½ε_ts\]; `driver = "stress"` takes
//! ε̄ = √Σ⟨σ̂_i⟩²/E.
//!
//! **Not modelled.** Plastic strain (a crack closes fully), the intermediate principal stress in shear, crushing
//! energy and with it objectivity in compression (the β plateau does not soften), creep, shrinkage, temperature,
//! reinforcement. Uniaxial compression raises D⁺ through Poisson's expansion when strain drives it; the pressure
//! does not feel it, a later reversal does. Strength under biaxial tension, triaxial tension and pure shear is
//! 0.85, 0.87 and 0.85 f_t (ν = 0.17), driven by stress 0.71, 0.58 and 1 f_t; under biaxial compression f_c, where
//! Kupfer (1969) measured 1.16 f_c.

mod grade;
mod parameters;
mod rate;
mod stress;

pub use grade::{GRADES, Grade};
pub use rate::{Power, Rate};

use crate::lane::Lane;
use crate::lane::elementary::exp;
use crate::material::{Material, Moduli, Point, Sym};
use crate::parameter::{BadParameter, Column, Parameter, Values};
use crate::sym3::Spectrum;

#[derive(Clone, Copy, Debug, PartialEq)]
enum Driver {
    Strain,
    Stress,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Split {
    Effective,
    Compliance,
}

/// Softening in tension.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Evolution {
    /// Plateau up to ε_us = `ratio` ε_ts.
    Ratio { ratio: f64 },
    /// Plateau, ε_us from G_f \[N/m\] and the element's extent.
    Energy { energy: f64 },
    /// Crack band from G_f \[N/m\].
    Exponential { energy: f64 },
}

/// The law for one concrete; see the [module](self).
#[derive(Clone, Copy, Debug)]
pub struct Concrete {
    moduli: Moduli,
    young: f64,
    poisson: f64,
    ft: f64,
    fc: f64,
    /// N
    slope: f64,
    alpha: f64,
    beta: f64,
    evolution: Evolution,
    rate: Option<Rate>,
    driver: Driver,
    split: Split,
    /// Whether c3′ is what a crack carries.
    nominal: bool,
}

const COLUMNS: [Column; 9] = [
    Column { name: "d_tension", unit: "1", doc: "D⁺, damage in tension" },
    Column { name: "d_shear", unit: "1", doc: "D⁻, damage in shear" },
    Column { name: "d_b", unit: "1", doc: "D_b, mean principal damage as the stress now feels it" },
    Column { name: "d_b_max", unit: "1", doc: "largest D_b so far" },
    Column {
        name: "smoothed_tension",
        unit: "1",
        doc: "equivalent tensile strain, smoothed over the filter time",
    },
    Column {
        name: "smoothed_shear",
        unit: "1",
        doc: "largest compressive strain, smoothed over the filter time",
    },
    Column {
        name: "factor_tension", unit: "1", doc: "rate factor f_ε at first damage in tension; 0 before"
    },
    Column { name: "factor_shear", unit: "1", doc: "rate factor of f_c at first damage in shear; 0 before" },
    Column {
        name: "crack_size",
        unit: "m",
        doc: "element's extent across the crack at first damage; 0 before",
    },
];

/// Bound tests stand off the thresholds by more than the round-off of what they compare.
const SAFE: f64 = 1.0 - 1e-6;

impl Concrete {
    /// Uniaxial tensile and compressive strength f_t, f_c \[Pa\], static.
    pub fn strengths(&self) -> [f64; 2] {
        [self.ft, self.fc]
    }

    /// The rate law, if there is one.
    pub fn rate(&self) -> Option<&Rate> {
        self.rate.as_ref()
    }

    /// Energy per area of a crack \[N/m\] that an element of extent `h` \[m\] across it dissipates, static rates.
    pub fn fracture_energy(&self, h: f64) -> f64 {
        match self.evolution {
            Evolution::Energy { energy } | Evolution::Exponential { energy } => energy,
            Evolution::Ratio { ratio } => {
                h * self.ft * self.ft / self.young * (0.5 + self.alpha * (ratio - 1.0))
            }
        }
    }

    /// ε_ts
    fn threshold(&self) -> f64 {
        self.ft / self.young
    }

    /// Whether no damage can start, from mean q and radius p of the strain alone.
    ///
    /// ‖⟨ε⟩‖ ≤ 2p + √3⟨q⟩ (2p + q for q < 0), and c1 − N c3 ≤ 3Kq(N − 1) + 4μp √(N² + N + 1), the largest over all
    /// Lode angles; rate factors are at least 1, so static strengths are on the safe side.
    #[inline(always)]
    fn far_from_damage<L: Lane>(&self, mean: L, radius: L) -> L::Mask {
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
    fn below_damage<L: Lane>(&self, radius: L, equivalent: L, undamaged: &[L; 3]) -> L::Mask {
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

    /// The factor of a rate law: the frozen one, else the one at this rate, 1 without a law.
    #[inline(always)]
    fn rate_factor<L: Lane>(law: Option<Power>, rate: L, frozen: L::Mask, quiet: L::Mask, old: L) -> L {
        let one = L::splat(1.0);
        let mut current = one;
        if let Some(power) = law
            && L::any(L::not(L::either(frozen, quiet)))
        {
            current = power.factor(rate);
        }
        L::select(frozen, old, current)
    }

    /// Principal effective stresses \[Pa\].
    #[inline(always)]
    fn undamaged<L: Lane>(&self, strain: &[L; 3]) -> [L; 3] {
        let mu2 = L::splat(2.0 * self.moduli.mu);
        let pressure = L::splat(self.moduli.lambda) * (strain[0] + strain[1] + strain[2]);
        [mu2.mul_add(strain[0], pressure), mu2.mul_add(strain[1], pressure), mu2.mul_add(strain[2], pressure)]
    }

    /// ε̄ of (9), or its counterpart in stress.
    #[inline(always)]
    fn equivalent_strain<L: Lane>(&self, strain: &[L; 3], undamaged: &[L; 3]) -> L {
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

    /// Candidate of D⁺ at ε̄ ≥ ε_t, for thresholds times `factor` and a crack across an extent `size`.
    #[inline(always)]
    fn softened<L: Lane>(&self, equivalent: L, factor: L, size: L) -> L {
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

    /// Principal stresses \[Pa\] for damage.
    #[inline(always)]
    fn principal_stress<L: Lane>(&self, strain: [L; 3], undamaged: [L; 3], tension: L, shear: L) -> [L; 3] {
        match self.split {
            Split::Effective => stress::effective(undamaged, tension, shear),
            Split::Compliance => {
                stress::compliance(self.young, self.poisson, strain, undamaged, tension, shear)
            }
        }
    }

    /// ε_c of (14) from principal stresses, tension positive and largest first.
    #[inline(always)]
    fn shear_threshold<L: Lane>(&self, stress: &[L; 3], tension: L, factor: L) -> L {
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

/// A strain smoothed over the filter time, and its rate: the signed rate through r ← r + Δt/(τ + Δt)(rate − r),
/// rearranged for y = ε − τ r, which takes one history variable where r and the last strain take two. `inverse` is
/// 1/(τ + Δt). While time stands still r is 0.
#[inline(always)]
fn smooth<L: Lane>(strain: L, smoothed: L, dt: L, inverse: L) -> (L, L) {
    let moving = L::splat(0.0).less(dt);
    let rate = (strain - smoothed) * inverse;
    (L::select(moving, dt.mul_add(rate, smoothed), strain), L::select(moving, rate, L::splat(0.0)))
}

impl Material for Concrete {
    const NAME: &'static str = "concrete-damage";
    const SUMMARY: &'static str = "concrete, rate-dependent damage separate in tension and shear";
    const SOURCE: &'static str = "wang2018, (1)-(16)";
    const PARAMETERS: &'static [Parameter] = parameters::PARAMETERS;
    const HISTORY: &'static [Column] = &COLUMNS;
    const NEEDS_SIZE: bool = true;
    type History<L: Lane> = [L; 9];

    fn new(values: &Values) -> Result<Self, Vec<BadParameter>> {
        parameters::read(values)
    }

    fn moduli(&self) -> Moduli {
        self.moduli
    }

    /// 2 G_f E/f_t²: a larger element stores more than a crack dissipates.
    fn size_limit(&self) -> f64 {
        match self.evolution {
            Evolution::Ratio { .. } => f64::INFINITY,
            Evolution::Energy { energy } | Evolution::Exponential { energy } => {
                2.0 * energy * self.young / (self.ft * self.ft)
            }
        }
    }

    fn warnings(&self) -> Vec<String> {
        let mut warnings = Vec::new();
        if self.slope * self.ft >= self.fc {
            warnings.push(format!(
                "N f_t = {:.3e} Pa reaches f_c = {:.3e} Pa: plain tension counts as shear failure; raise the \
                 compressive strength or the cohesion, or lower the friction angle",
                self.slope * self.ft,
                self.fc
            ));
        }
        warnings
    }

    #[inline(always)]
    fn update<L: Lane>(&self, point: &Point<L>, strain: Sym<L>, old: [L; 9]) -> (Sym<L>, [L; 9]) {
        let (zero, one, half) = (L::splat(0.0), L::splat(1.0), L::splat(0.5));
        let mut new = old;
        let mut tensor =
            [strain[0], strain[1], strain[2], half * strain[3], half * strain[4], half * strain[5]];
        // Beyond any strain that means something, squares would overflow and leave no number behind.
        let limit = L::splat(1e100);
        let mut largest = zero;
        let mut k = 0;
        while k < 6 {
            largest = largest + tensor[k].abs();
            k += 1;
        }
        if L::any(limit.less(largest)) {
            let mut k = 0;
            while k < 6 {
                tensor[k] = (-limit).larger(limit.smaller(tensor[k]));
                k += 1;
            }
        }

        let mu2 = L::splat(2.0 * self.moduli.mu);
        let pressure = L::splat(self.moduli.lambda) * (tensor[0] + tensor[1] + tensor[2]);
        let mut stress = [
            mu2.mul_add(tensor[0], pressure),
            mu2.mul_add(tensor[1], pressure),
            mu2.mul_add(tensor[2], pressure),
            mu2 * tensor[3],
            mu2 * tensor[4],
            mu2 * tensor[5],
        ];

        let spectrum = Spectrum::of(&tensor);
        let virgin = L::not(zero.less(old[0] + old[1]));
        let mut quiet = L::both(virgin, self.far_from_damage(spectrum.mean, spectrum.radius));
        let (mut tension_rate, mut shear_rate) = (zero, zero);
        if self.rate.is_some() || L::any(L::both(virgin, L::not(quiet))) {
            let values = spectrum.values();
            let undamaged = self.undamaged(&values);
            let equivalent = self.equivalent_strain(&values, &undamaged);
            let below = self.below_damage(spectrum.radius, equivalent, &undamaged);
            quiet = L::either(quiet, L::both(virgin, below));
            if let Some(rate) = &self.rate {
                let inverse = one / (L::splat(rate.filter) + point.dt);
                (new[4], tension_rate) = smooth(equivalent, old[4], point.dt, inverse);
                (new[5], shear_rate) = smooth(-values[2], old[5], point.dt, inverse);
            }
        }
        if !L::any(L::not(quiet)) {
            return (stress, new);
        }

        let (tension_law, shear_law) = match &self.rate {
            Some(rate) => (Some(rate.tension), Some(rate.shear)),
            None => (None, None),
        };
        let eigen = spectrum.eigen();
        let undamaged = self.undamaged(&eigen.values);
        let equivalent = self.equivalent_strain(&eigen.values, &undamaged);
        let frozen = zero.less(old[6]);
        let factor = Self::rate_factor(tension_law, tension_rate, frozen, quiet, old[6]);
        let cracking = L::not(equivalent.less(factor * L::splat(self.threshold())));
        let [x, y, z] = eigen.vectors[0];
        let g = &point.size;
        let along = [
            g[5].mul_add(z, g[3].mul_add(y, g[0] * x)),
            g[4].mul_add(z, g[1].mul_add(y, g[3] * x)),
            g[2].mul_add(z, g[4].mul_add(y, g[5] * x)),
        ];
        let extent = along[2].mul_add(z, along[1].mul_add(y, along[0] * x)).larger(zero).sqrt();
        let size = L::select(frozen, old[8], extent);
        let candidate = L::select(cracking, self.softened(equivalent, factor, size), zero);
        let tension = candidate.larger(old[0]);
        let starts = L::both(cracking, L::not(frozen));
        new[0] = tension;
        new[6] = L::select(starts, factor, old[6]);
        new[8] = L::select(starts, extent, old[8]);

        // The effective split tests shear on the effective stress, the compliance split on the damaged one.
        let tested = match self.split {
            Split::Effective => undamaged,
            Split::Compliance => self.principal_stress(eigen.values, undamaged, tension, old[1]),
        };
        let frozen = zero.less(old[7]);
        let factor = Self::rate_factor(shear_law, shear_rate, frozen, quiet, old[7]);
        let threshold = self.shear_threshold(&tested, tension, factor);
        let compressive = -eigen.values[2];
        let pressed = L::both(zero.less(compressive), L::splat(1e-6 * self.fc).less(-tested[2]));
        let failing = L::both(pressed, L::not(compressive.less(threshold)));
        let candidate = (one - L::splat(self.beta) * threshold / compressive).smaller(one);
        let shear = L::select(failing, candidate, zero).larger(old[1]);
        new[1] = shear;
        new[7] = L::select(L::both(failing, L::not(frozen)), factor, old[7]);

        let round = L::splat(-1e-6 * self.ft);
        let mut sum = zero;
        let mut i = 0;
        while i < 3 {
            sum = sum + L::select(undamaged[i].less(round), shear, tension);
            i += 1;
        }
        new[2] = sum * L::splat(1.0 / 3.0);
        new[3] = new[2].larger(old[3]);

        let principal = self.principal_stress(eigen.values, undamaged, tension, shear);
        let damaged = eigen.recompose(principal);
        let mut k = 0;
        while k < 6 {
            stress[k] = L::select(quiet, stress[k], damaged[k]);
            k += 1;
        }
        (stress, new)
    }
}
