//! How strength grows with the rate of strain.

use crate::lane::Lane;
use crate::lane::elementary::{exp, ln};

/// Rate laws by the word in a case.
pub const RATES: &[&str] = &["none", "ceb", "mc90", "mc2010"];

/// The rate \[1/s\] beyond which the laws no longer hold: factors stay at their value there.
const FASTEST: f64 = 30.0;

/// (ε̇/ε̇_s)^k for ε̇ within \[ε̇_s, 30 s⁻¹\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Power {
    /// ε̇_s \[1/s\]
    pub reference: f64,
    /// k
    pub exponent: f64,
}

impl Power {
    /// ln of the largest ratio of rates.
    fn range(&self) -> f64 {
        (FASTEST / self.reference).max(1.0)
    }

    /// The factor at a signed, filtered rate \[1/s\].
    #[inline(always)]
    pub fn factor<L: Lane>(&self, rate: L) -> L {
        let one = L::splat(1.0);
        let ratio = (rate.abs() * L::splat(1.0 / self.reference)).larger(one).smaller(L::splat(self.range()));
        if L::any(one.less(ratio)) { exp(L::splat(self.exponent) * ln(ratio)) } else { one }
    }
}

/// The rate law of one concrete.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rate {
    /// Factor f_ε of the tensile strains.
    pub tension: Power,
    /// Factor f_σ of the compressive strength.
    pub shear: Power,
    /// Filter time τ \[s\].
    pub filter: f64,
}

impl Rate {
    /// A rate law by its word, for a concrete of static compressive strength `fc` \[Pa\]; `None` for `none`.
    ///
    /// - `ceb`, the paper's (12) and (16): 0.020 and 1.026/(5 + ¾f_c), f_c of cubes in MPa; reference 3·10⁻⁵ s⁻¹.
    /// - `mc90`, CEB-FIP Model Code 1990: 1.016/(10 + 6 f_c/10), reference 3·10⁻⁶ s⁻¹, and 1.026/(5 + 9 f_c/10),
    ///   reference 3·10⁻⁵ s⁻¹, f_c of cylinders in MPa.
    /// - `mc2010`, fib Model Code 2010: 0.018 and 0.014, references 10⁻⁶ and 3·10⁻⁵ s⁻¹.
    pub fn named(word: &str, fc: f64, reference: Option<f64>, filter: f64) -> Option<Rate> {
        let fc = fc / 1e6;
        let (tension, shear) = match word {
            "ceb" => ((3e-5, 0.020), (3e-5, 1.026 / (5.0 + 0.75 * fc))),
            "mc90" => ((3e-6, 1.016 / (10.0 + 0.6 * fc)), (3e-5, 1.026 / (5.0 + 0.9 * fc))),
            "mc2010" => ((1e-6, 0.018), (3e-5, 0.014)),
            _ => return None,
        };
        let power = |(own, exponent)| Power { reference: reference.unwrap_or(own), exponent };
        Some(Rate { tension: power(tension), shear: power(shear), filter })
    }
}

/// The factor in force: the frozen one, else the law's at this rate, 1 without a law.
#[inline(always)]
pub(super) fn factor<L: Lane>(law: Option<Power>, rate: L, frozen: L::Mask, quiet: L::Mask, old: L) -> L {
    let mut current = L::splat(1.0);
    if let Some(power) = law
        && L::any(L::not(L::either(frozen, quiet)))
    {
        current = power.factor(rate);
    }
    L::select(frozen, old, current)
}

/// A strain smoothed over the filter time, and its rate: the signed rate through r ← r + Δt/(τ + Δt)(rate − r),
/// rearranged for y = ε − τ r, which takes one history variable where r and the last strain take two. `inverse` is
/// 1/(τ + Δt). While time stands still r is 0.
#[inline(always)]
pub(super) fn smooth<L: Lane>(strain: L, smoothed: L, dt: L, inverse: L) -> (L, L) {
    let moving = L::splat(0.0).less(dt);
    let rate = (strain - smoothed) * inverse;
    (L::select(moving, dt.mul_add(rate, smoothed), strain), L::select(moving, rate, L::splat(0.0)))
}
