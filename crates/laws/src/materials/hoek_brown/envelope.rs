//! The curved envelope σ₁ − σ₃ = σ_ci u^a, u = s − m_b σ₁/σ_ci, and where a straight way meets it.

use crate::lane::Lane;
use crate::lane::elementary::{exp, ln};
use crate::materials::plastic::flow::Way;

/// The constants of a rock mass.
#[derive(Clone, Copy, Debug)]
pub(super) struct Envelope<L> {
    /// σ_ci \[Pa\]
    pub sci: f64,
    pub mb: L,
    pub s: L,
    /// ½ to ⅔
    pub a: L,
    /// b = 1/a
    b: L,
    /// 2ᵇ
    two_b: L,
    /// σ_ci min(1, s^(a−½)) \[Pa\]
    floor: L,
}

/// Newton's steps in [`scaled_root`], as many as round-off takes for every constant (see the test).
const STEPS: usize = 3;

/// xⁿ for x > 0; of x ≤ 0 about 1e-300ⁿ.
#[inline(always)]
fn power<L: Lane>(x: L, n: L) -> L {
    exp(ln(x.larger(L::splat(1e-300))) * n)
}

/// The root x of x + C xᵇ = 1 in (0, 1\], for C > 0 and b from 1.5 to 2; `two_b` is 2ᵇ.
///
/// The start 2/(1 + (1 + 2ᵇC)^(1/b)) is exact for b = 2 and for C → 0 and ∞. With P = C xᵇ Newton's step is
/// x (1 + (b − 1)P)/(x + bP): positive, never below the root after the first step (the left side is convex), without
/// cancellation.
#[inline(always)]
fn scaled_root<L: Lane>(c: L, b: L, two_b: L) -> L {
    let one = L::splat(1.0);
    let start = power(c.mul_add(two_b, one), one / b);
    let mut x = L::splat(2.0) / (one + start);
    let mut step = 0;
    while step < STEPS {
        let p = c * power(x, b);
        x = x * (b - one).mul_add(p, one) / b.mul_add(p, x);
        step += 1;
    }
    x
}

impl Envelope<f64> {
    /// From σ_ci \[Pa\], m_b, s and a.
    pub fn new(sci: f64, [mb, s, a]: [f64; 3]) -> Self {
        let b = 1.0 / a;
        Envelope { sci, mb, s, a, b, two_b: 2f64.powf(b), floor: sci * s.powf(a - 0.5).min(1.0) }
    }

    /// The same for every lane.
    #[inline(always)]
    pub fn splat<L: Lane>(&self) -> Envelope<L> {
        Envelope {
            sci: self.sci,
            mb: L::splat(self.mb),
            s: L::splat(self.s),
            a: L::splat(self.a),
            b: L::splat(self.b),
            two_b: L::splat(self.two_b),
            floor: L::splat(self.floor),
        }
    }

    /// σ₁ − σ₃ \[Pa\] that it bears at a confinement −σ₁ \[Pa\].
    pub fn strength(&self, confinement: f64) -> f64 {
        self.sci * (self.s + self.mb * confinement / self.sci).powf(self.a)
    }

    /// Uniaxial compressive strength σ_ci sᵃ \[Pa\].
    pub fn uniaxial(&self) -> f64 {
        // s is at most 1 and a at least ½, so that the floor is σ_ci s^(a−½).
        self.floor * self.s.sqrt()
    }

    /// σ₁ of the apex \[Pa\].
    pub fn apex(&self) -> f64 {
        self.s * self.sci / self.mb
    }
}

impl<L: Lane> Envelope<L> {
    /// An envelope of other m_b, s and a in lanes that have changed, and this one in all others.
    #[inline(always)]
    pub fn changed(&self, changed: L::Mask, [mb, s, a]: [L; 3]) -> Self {
        let one = L::splat(1.0);
        let b = one / a;
        let floor = L::splat(self.sci) * one.smaller(power(s, a - L::splat(0.5)));
        Envelope {
            sci: self.sci,
            mb: L::select(changed, mb, self.mb),
            s: L::select(changed, s, self.s),
            a: L::select(changed, a, self.a),
            b: L::select(changed, b, self.b),
            two_b: L::select(changed, exp(b * L::splat(core::f64::consts::LN_2)), self.two_b),
            floor: L::select(changed, floor, self.floor),
        }
    }

    /// f_t \[Pa\], not beyond the apex, and σ₃ of the envelope there, in lanes that have changed; `peak` in all others.
    #[inline(always)]
    pub fn cut_off(&self, changed: L::Mask, tensile: f64, peak: [f64; 2]) -> [L; 2] {
        let zero = L::splat(0.0);
        let apex = self.s * L::splat(self.sci) / self.mb;
        let tensile = L::splat(tensile);
        let below = tensile.less(apex);
        let ft = L::select(below, tensile, apex);
        let left = self.argument(ft);
        let bears = L::select(L::both(below, zero.less(left)), power(left, self.a), zero);
        let low = L::splat(self.sci).neg_mul_add(bears, ft);
        [L::select(changed, ft, L::splat(peak[0])), L::select(changed, low, L::splat(peak[1]))]
    }

    /// u
    #[inline(always)]
    fn argument(&self, first: L) -> L {
        (self.mb / L::splat(self.sci)).neg_mul_add(first, self.s)
    }

    /// σ₁ − σ₃ − σ_ci u^a \[Pa\]; beyond the apex the last part is zero.
    #[inline(always)]
    pub fn excess(&self, first: L, third: L) -> L {
        let zero = L::splat(0.0);
        let u = self.argument(first);
        let strength = L::select(zero.less(u), power(u, self.a), zero);
        L::splat(self.sci).neg_mul_add(strength, first - third)
    }

    /// Slope of the envelope, 1 + a m_b u^(a−1), from the excess of the same stresses; endless beyond the apex.
    #[inline(always)]
    pub fn slope(&self, first: L, third: L, excess: L) -> L {
        let zero = L::splat(0.0);
        let u = self.argument(first);
        let strength = first - third - excess;
        let slope = (self.a * self.mb / L::splat(self.sci)).mul_add(strength / u, L::splat(1.0));
        L::select(zero.less(u), slope, L::splat(f64::MAX))
    }

    /// What σ₁ − σ₃ can at least be for a negative σ₁: u ≥ s there, so u^a ≥ min(1, s^(a−½)) √u.
    #[inline(always)]
    pub fn floor(&self, first: L) -> L {
        self.floor * self.argument(first).larger(L::splat(0.0)).sqrt()
    }

    /// σ₁ and σ₃ where a way that starts outside meets the envelope; the third is 1 where it does not before the
    /// apex, else 0.
    ///
    /// With ρ = a₃/a₁ of the way the multiplier drops out and v = u^a solves v + B v^(1/a) = A,
    /// B = (1 − ρ)/m_b, A = sB − (σ₃ − ρσ₁)/σ_ci of the way's start; v = A x scales that.
    #[inline(always)]
    pub fn meet(&self, way: &Way<L>) -> [L; 3] {
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        let ratio = way.a3 / way.a1;
        let b = (one - ratio) * (one / self.mb);
        let offset = ratio.neg_mul_add(way.first, way.third) * L::splat(1.0 / self.sci);
        let a = b.mul_add(self.s, -offset);
        let reached = zero.less(a);
        let a = L::select(reached, a, one);
        let x = scaled_root(b * power(a, self.b - one), self.b, self.two_b);
        let u = a * (one - x) / b;
        let first = L::splat(self.sci) / self.mb * (self.s - u);
        let third = (L::splat(self.sci) * a).neg_mul_add(x, first);
        [first, third, L::select(reached, zero, one)]
    }
}

#[cfg(test)]
mod tests {
    use super::scaled_root;

    #[test]
    fn the_fixed_number_of_newtons_steps_reaches_round_off_for_every_constant() {
        let mut worst = 0.0f64;
        for i in 0..=200 {
            let b = 1.5 + 0.5 * i as f64 / 200.0;
            for j in 0..=600 {
                let c = 10f64.powf(-30.0 + 0.1 * j as f64 * (if j > 300 { 1.5 } else { 1.0 }));
                let x = scaled_root(c, b, 2f64.powf(b));
                // Residual over the derivative times the root: relative error of the root, to first order.
                let p = c * x.powf(b);
                worst = worst.max(((x + p - 1.0) / (x + b * p)).abs());
            }
        }
        // The power's own error: ln within 2 units of up to 100, times b.
        assert!(worst < 1e-13, "{worst:e}");
        println!("largest relative error {worst:e}");
    }
}
