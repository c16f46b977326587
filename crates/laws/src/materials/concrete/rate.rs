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
    /// - `ceb`, the paper's (12) and (16): 0.020, Model Code 1990's exponent of the strain at the largest stress, with that code's
    ///   reference in tension, 3·10⁻⁶ s⁻¹, and 1.026/(5 + ¾f_c), f_c of cubes in MPa, with that in compression, 3·10⁻⁵ s⁻¹.
    /// - `mc90`, CEB-FIP Model Code 1990: 1.016/(10 + 6 f_c/10), reference 3·10⁻⁶ s⁻¹, and 1.026/(5 + 9 f_c/10),
    ///   reference 3·10⁻⁵ s⁻¹, f_c of cylinders in MPa.
    /// - `mc2010`, fib Model Code 2010: 0.018 and 0.014, references 10⁻⁶ and 3·10⁻⁵ s⁻¹.
    pub fn named(word: &str, fc: f64, reference: Option<f64>, filter: f64) -> Option<Rate> {
        let fc = fc / 1e6;
        let (tension, shear) = match word {
            "ceb" => ((3e-6, 0.020), (3e-5, 1.026 / (5.0 + 0.75 * fc))),
            "mc90" => ((3e-6, 1.016 / (10.0 + 0.6 * fc)), (3e-5, 1.026 / (5.0 + 0.9 * fc))),
            "mc2010" => ((1e-6, 0.018), (3e-5, 0.014)),
            _ => return None,
        };
        let power = |(own, exponent)| Power { reference: reference.unwrap_or(own), exponent };
        Some(Rate { tension: power(tension), shear: power(shear), filter })
    }
}

/// A strain is smoothed through r ← r + Δt/(τ + Δt)(rate − r) of its signed rate r, rearranged for y = ε − τ r, which takes one
/// history variable where r and the last strain take two. Where y is not brought on in every step, the rate in between is what
/// the filter would give in one step since then: a steady rate comes out exactly at all of them.
impl Rate {
    /// 1/(τ + Δt)
    #[inline(always)]
    fn inverse<L: Lane>(&self, since: L) -> L {
        L::splat(1.0) / (L::splat(self.filter) + since)
    }

    /// The rate \[1/s\] of a strain at a time `since` \[s\] after its smoothed value; 0 while time stands still.
    #[inline(always)]
    pub(super) fn rate<L: Lane>(&self, strain: L, smoothed: L, since: L) -> L {
        let zero = L::splat(0.0);
        L::select(zero.less(since), (strain - smoothed) * self.inverse(since), zero)
    }

    /// Smoothed strains after `since` \[s\]; while time stands still they are the strains.
    #[inline(always)]
    pub(super) fn brought_on<L: Lane>(&self, smoothed: [L; 2], strain: [L; 2], since: L) -> [L; 2] {
        let moving = L::splat(0.0).less(since);
        let inverse = self.inverse(since);
        [
            L::select(moving, since.mul_add((strain[0] - smoothed[0]) * inverse, smoothed[0]), strain[0]),
            L::select(moving, since.mul_add((strain[1] - smoothed[1]) * inverse, smoothed[1]), strain[1]),
        ]
    }

    /// Steps of `dt` \[s\] after which smoothed strains are brought on: as many as a twentieth of the filter time holds, a power of
    /// two, at most eight.
    pub(super) fn steps(&self, dt: f64) -> u64 {
        let mut steps = 1;
        while steps < 8 && dt > 0.0 && 2.0 * steps as f64 * dt <= 0.05 * self.filter {
            steps *= 2;
        }
        steps
    }
}
