//! Strength that falls with plastic strain.

use crate::lane::Lane;

/// Straight lines from peak to residual.
#[derive(Clone, Copy, Debug)]
pub(super) struct Softening {
    /// c \[Pa\], peak and residual.
    pub cohesion: [f64; 2],
    /// φ \[rad\], peak and residual.
    pub friction: [f64; 2],
    /// f_t \[Pa\], peak and residual.
    pub tensile: [f64; 2],
    /// 1/`softening_strain`
    pub per_shear: f64,
    /// 1/`softening_tension_strain`, or 0
    pub per_tension: f64,
}

/// What is left of the strength.
pub(super) struct Left<L> {
    /// k = (1 + sin φ)/(1 − sin φ)
    pub slope: L,
    /// \[Pa\]
    pub cohesion: L,
    /// \[Pa\]
    pub tensile: L,
}

#[inline(always)]
fn between<L: Lane>([peak, residual]: [f64; 2], share: L) -> L {
    share.mul_add(L::splat(residual - peak), L::splat(peak))
}

/// sin x for x from 0 to π/2, by Taylor's series up to x¹⁹; within 5e-16, five units below 1.
#[inline(always)]
fn sine<L: Lane>(x: L) -> L {
    const C: [f64; 10] = {
        let mut c = [1.0; 10];
        let mut k = 1;
        while k < 10 {
            c[k] = -c[k - 1] / ((2 * k) as f64 * (2 * k + 1) as f64);
            k += 1;
        }
        c
    };
    let square = x * x;
    let mut sum = L::splat(C[9]);
    let mut k = 9;
    while k > 0 {
        k -= 1;
        sum = sum.mul_add(square, L::splat(C[k]));
    }
    sum * x
}

impl Softening {
    /// Strength after plastic strains of shear and tension.
    #[inline(always)]
    pub fn left<L: Lane>(&self, shear: L, tension: L) -> Left<L> {
        let one = L::splat(1.0);
        let sheared = one.smaller(shear * L::splat(self.per_shear));
        let opened = one.smaller((tension * L::splat(self.per_tension)).larger(sheared));
        let sine = sine(between(self.friction, sheared));
        Left {
            slope: (one + sine) / (one - sine),
            cohesion: between(self.cohesion, sheared),
            tensile: between(self.tensile, opened),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::sine;

    #[test]
    fn sine_of_every_friction_angle() {
        for i in 0..=1570 {
            let x = i as f64 * 1e-3;
            assert!((sine(x) - x.sin()).abs() <= 5e-16, "{x}");
        }
    }
}
