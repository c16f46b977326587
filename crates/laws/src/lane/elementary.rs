//! Exponential and logarithm over lanes.
//!
//! Our own, so that every width gives the same bits. Cody & Waite's reduction and a polynomial; within two units
//! in the last place of the exact value over the stated ranges (tested against the standard library).

use super::Lane;

/// ln 2 in two parts, the first with so few bits that its products with exponents are exact.
const LN_2_HIGH: f64 = 0.693_147_180_369_123_8;
const LN_2_LOW: f64 = 1.908_214_929_270_587_7e-10;
/// 1.5 · 2⁵²: adding and taking away rounds to the nearest integer.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// eˣ for |x| ≤ 708; beyond, the value there; not a number where x is not.
#[inline(always)]
pub fn exp<L: Lane>(x: L) -> L {
    // The second operand of a comparison that fails passes through, so a NaN survives both.
    let x = L::splat(708.0).smaller(x);
    let x = L::splat(-708.0).larger(x);
    let n = x.mul_add(L::splat(core::f64::consts::LOG2_E), L::splat(ROUND)) - L::splat(ROUND);
    let r = n.neg_mul_add(L::splat(LN_2_HIGH), x);
    let r = n.neg_mul_add(L::splat(LN_2_LOW), r);
    // Taylor's series: |r| ≤ ½ ln 2 leaves 4e-18 after r¹³.
    const C: [f64; 14] = {
        let mut c = [1.0; 14];
        let mut k = 1;
        while k < 14 {
            c[k] = c[k - 1] / k as f64;
            k += 1;
        }
        c
    };
    let mut sum = L::splat(C[13]);
    let mut k = 12;
    while k > 0 {
        sum = sum.mul_add(r, L::splat(C[k]));
        k -= 1;
    }
    sum.mul_add(r, L::splat(1.0)) * n.power_of_two()
}

/// The natural logarithm of a positive normal number; meaningless, yet finite, for any other.
#[inline(always)]
pub fn ln<L: Lane>(x: L) -> L {
    let (mut e, mut m) = (x.exponent(), x.significand());
    let high = L::splat(core::f64::consts::SQRT_2).less(m);
    m = L::select(high, m * L::splat(0.5), m);
    e = L::select(high, e + L::splat(1.0), e);
    // ln m = 2 artanh f, f = (m − 1)/(m + 1), |f| ≤ 0.1716: the series to f²¹ leaves 2e-19 of f.
    let f = (m - L::splat(1.0)) / (m + L::splat(1.0));
    let s = f * f;
    let mut sum = L::splat(2.0 / 21.0);
    let mut k = 9;
    while k > 0 {
        sum = sum.mul_add(s, L::splat(2.0 / (2 * k + 1) as f64));
        k -= 1;
    }
    // 2f + f s·sum: the large part first, so that the small one only corrects it.
    let tail = (f * s).mul_add(sum, e * L::splat(LN_2_LOW));
    e.mul_add(L::splat(LN_2_HIGH), (f + f) + tail)
}

#[cfg(test)]
mod tests {
    use super::{exp, ln};

    fn units_in_last_place(found: f64, exact: f64) -> f64 {
        (found - exact).abs() / (f64::from_bits(exact.abs().to_bits() + 1) - exact.abs())
    }

    #[test]
    fn exponential_within_two_units_of_the_standard_library() {
        for i in -70_000..=70_000 {
            let x = i as f64 * 0.010_1;
            assert!(units_in_last_place(exp(x), x.exp()) <= 2.0, "{x}");
        }
        assert_eq!(exp(0.0), 1.0);
        assert_eq!(exp(1e300), exp(708.0));
        assert_eq!(exp(-1e300), exp(-708.0));
        assert!(exp(f64::NAN).is_nan());
    }

    #[test]
    fn logarithm_within_two_units_of_the_standard_library() {
        let mut x = 1e-300;
        while x < 1e300 {
            assert!(units_in_last_place(ln(x), x.ln()) <= 2.0, "{x}");
            x *= 1.037;
        }
        for i in 1..4000 {
            let x = 0.5 + i as f64 * 0.000_5;
            assert!(units_in_last_place(ln(x), x.ln()) <= 2.0, "{x}");
        }
        assert_eq!(ln(1.0), 0.0);
    }
}
