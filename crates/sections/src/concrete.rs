//! Concrete in compression: a parabola up to a strain, then a plateau up to another, and no tension.

/// Parabola and rectangle with exponent 2, as EN 1992-1-1 3.1.7 (1) and GB 50010-2010 6.2.1 have it up to C50.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Concrete {
    /// Of the plateau, above 0 \[Pa\].
    pub strength: f64,
    /// Strain at which the plateau begins, and at which it ends, both above 0.
    pub plateau: f64,
    pub ultimate: f64,
}

impl Concrete {
    /// ε_c2 = 2 ‰ and ε_cu2 = 3.5 ‰: EN 1992-1-1 table 3.1 up to C50/60.
    pub fn en(strength: f64) -> Self {
        Concrete { strength, plateau: 2.0e-3, ultimate: 3.5e-3 }
    }

    /// ε_0 = 2 ‰ and ε_cu = 3.3 ‰: GB 50010-2010 6.2.1 up to C50.
    pub fn gb(strength: f64) -> Self {
        Concrete { strength, plateau: 2.0e-3, ultimate: 3.3e-3 }
    }

    /// Stress \[Pa\] at a strain, both positive in tension. Beyond the ultimate strain it stays: limits of strain are the section's.
    pub fn stress(&self, strain: f64) -> f64 {
        let left = 1.0 - (-strain).clamp(0.0, self.plateau) / self.plateau;
        -self.strength * (1.0 - left * left)
    }
}
