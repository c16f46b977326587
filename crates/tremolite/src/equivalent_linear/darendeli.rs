//! Darendeli's curves.

use std::f64::consts::PI;

/// Curvature a of the hyperbola.
const CURVATURE: f64 = 0.919;

/// Kilopascals of an atmosphere.
const ATMOSPHERE: f64 = 101_325.0;

/// Soil as the curves of `darendeli2001` know it: G/G_max = 1/(1 + (γ/γ_r)^a), and Masing's damping of that hyperbola, corrected by a polynomial
/// (his equations 9.1 to 9.4), beside damping at small strains. Fitted to strains up to a few parts in a thousand of intact clays, silts and sands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Darendeli {
    /// \[%\]
    pub plasticity_index: f64,
    /// Overconsolidation ratio.
    pub ocr: f64,
    /// Mean effective stress \[Pa\].
    pub stress: f64,
    /// Frequency of loading \[Hz\], and number of cycles.
    pub frequency: f64,
    pub cycles: f64,
}

impl Darendeli {
    /// As it is mostly used: 1 Hz and ten cycles.
    pub fn new(plasticity_index: f64, ocr: f64, stress: f64) -> Self {
        Darendeli { plasticity_index, ocr, stress, frequency: 1.0, cycles: 10.0 }
    }

    /// The shear strain at which the modulus has fallen to half.
    pub fn reference_strain(&self) -> f64 {
        let by_kind = 0.0352 + 0.0010 * self.plasticity_index * self.ocr.powf(0.3246);
        by_kind * (self.stress / ATMOSPHERE).powf(0.3483) / 100.0
    }

    /// Damping ratio at small strains.
    pub fn least_damping(&self) -> f64 {
        let by_kind = 0.8005 + 0.0129 * self.plasticity_index * self.ocr.powf(-0.1069);
        by_kind * (self.stress / ATMOSPHERE).powf(-0.2889) * (1.0 + 0.2919 * self.frequency.ln()) / 100.0
    }

    /// G/G_max and damping ratio at a shear strain.
    pub fn at(&self, strain: f64) -> [f64; 2] {
        let x = strain / self.reference_strain();
        let modulus = 1.0 / (1.0 + x.powf(CURVATURE));
        let masing = masing(x);
        let a = CURVATURE;
        let c1 = -1.1143 * a * a + 1.8618 * a + 0.2523;
        let c2 = 0.0805 * a * a - 0.0710 * a - 0.0095;
        let c3 = -0.0005 * a * a + 0.0002 * a + 0.0003;
        let corrected = masing * (c1 + masing * (c2 + masing * c3));
        let share = 0.6329 - 0.00566 * self.cycles.ln();
        [modulus, self.least_damping() + share * corrected * modulus.powf(0.1) / 100.0]
    }
}

/// Masing's damping \[%\] of a hyperbola at a strain over its reference strain.
fn masing(x: f64) -> f64 {
    // 4 (x − ln(1+x))/(x²/(1+x)) − 2, whose terms cancel where x is small: there by its series.
    let loss = match x {
        _ if x < 1e-3 => x * (2.0 / 3.0 - x / 3.0 + x * x * 0.2),
        _ => 4.0 * (x - x.ln_1p()) * (1.0 + x) / (x * x) - 2.0,
    };
    100.0 / PI * loss
}
