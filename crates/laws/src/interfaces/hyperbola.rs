//! The hyperbola of Bandis' closure (`bandis1983`) with a straight end; [`super::bandis`] says why.

use super::joint::Normal;
use crate::lane::Lane;
use crate::lane::elementary::ln;

/// Bandis' hyperbola with a straight end.
#[derive(Clone, Copy, Debug)]
pub struct Hyperbola {
    /// k_n0 \[Pa/m\]
    pub stiffness: f64,
    /// T \[m\]
    pub closure: f64,
    /// φ
    pub floor: f64,
}

impl Hyperbola {
    /// Pressure \[Pa\] from which on it is straight.
    pub fn straight_from(&self) -> f64 {
        self.stiffness * self.closure * (1.0 / self.floor - 1.0)
    }
}

impl Normal for Hyperbola {
    #[inline(always)]
    fn pressure<L: Lane>(&self, gap: L) -> L {
        let Hyperbola { stiffness, closure, floor } = *self;
        let most = L::splat((floor - 1.0) * closure);
        let curved = most.larger(gap);
        let one = L::splat(1.0);
        let p = -(L::splat(stiffness) * curved) / curved.mul_add(L::splat(1.0 / closure), one);
        let beyond = (most - gap).larger(L::splat(0.0));
        L::splat(stiffness / (floor * floor)).mul_add(beyond, p)
    }

    #[inline(always)]
    fn stiffness<L: Lane>(&self, gap: L) -> L {
        let Hyperbola { stiffness, closure, floor } = *self;
        let open = gap.mul_add(L::splat(1.0 / closure), L::splat(1.0)).larger(L::splat(floor));
        L::splat(stiffness) / (open * open)
    }

    #[inline(always)]
    fn energy<L: Lane>(&self, gap: L) -> L {
        let Hyperbola { stiffness, closure, floor } = *self;
        let zero = L::splat(0.0);
        let most = L::splat((floor - 1.0) * closure);
        let x = most.larger(gap) * L::splat(1.0 / closure);
        let beyond = (most - gap).larger(zero);
        let straight =
            L::splat(0.5 * stiffness / (floor * floor)).mul_add(beyond, L::splat(self.straight_from()));
        straight.mul_add(beyond, L::splat(stiffness * closure * closure) * less_logarithm(x))
    }

    fn gap(&self, pressure: f64) -> f64 {
        let Hyperbola { stiffness, closure, floor } = *self;
        let beyond = pressure - self.straight_from();
        if beyond > 0.0 {
            (floor - 1.0) * closure - beyond * floor * floor / stiffness
        } else if pressure > -stiffness * closure {
            -pressure / (stiffness + pressure / closure)
        } else {
            f64::INFINITY
        }
    }
}

/// x − ln(1 + x), without the loss of digits near 0.
#[inline(always)]
fn less_logarithm<L: Lane>(x: L) -> L {
    let direct = x - ln(x + L::splat(1.0));
    // ln(1 + x) = 2 artanh y with y = x/(2 + x), and x − 2y = xy; |y| < 0.06 leaves 1e-17 after y¹³.
    let y = x / (x + L::splat(2.0));
    let s = y * y;
    let mut sum = L::splat(2.0 / 13.0);
    let mut k = 5;
    while k > 0 {
        sum = sum.mul_add(s, L::splat(2.0 / (2 * k + 1) as f64));
        k -= 1;
    }
    let series = (y * s).neg_mul_add(sum, x * y);
    L::select(x.abs().less(L::splat(0.1)), series, direct)
}
