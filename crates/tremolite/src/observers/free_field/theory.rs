//! A homogeneous column under a vertical wave, exact in the frequency domain.

use std::f64::consts::{PI, TAU};
use tremolite_engine::problem::Rayleigh;
use tremolite_laws::band::Band;
use tremolite_motion::{Complex64, transferred};

/// A column of one material.
pub struct Layer {
    /// H \[m\]
    pub height: f64,
    /// c \[m/s\] by the material's own moduli, which the dashpots of the base go by as well.
    pub speed: f64,
    pub band: Option<Band>,
    pub rayleigh: Rayleigh,
}

impl Layer {
    /// Velocity of the top over that of the incident wave at ω \[rad/s\] > 0, time going as e^(iωt).
    ///
    /// With M the modulus over the material's own, damping included, the wave number is k = (ω/c) √((1 − iω_R/ω)/M),
    /// and the balance at the base, 2v_i − v = M (c/iω) ∂v/∂z, gives 2/(cos kH + i M (ck/ω) sin kH): 2 e^(−iωH/c)
    /// without damping.
    fn factor(&self, omega: f64) -> Complex64 {
        let i = Complex64::i();
        let frequency = omega / TAU;
        let (elastic, unrelaxed) = match &self.band {
            Some(band) => {
                let loss = Complex64::new(1.0, 2.0 * band.ratio(frequency));
                (band.stiffness(frequency) * loss, band.unrelaxed())
            }
            None => (Complex64::new(1.0, 0.0), 1.0),
        };
        let modulus = elastic + i * omega * self.rayleigh.stiffness * unrelaxed;
        let inertia = 1.0 - i * self.rayleigh.mass / omega;
        // ck/ω
        let slowness = (inertia / modulus).sqrt();
        let angle = slowness * (omega * self.height / self.speed);
        let factor = 2.0 / (angle.cos() + i * modulus * slowness * angle.sin());
        // What is damped beyond the reach of numbers does not arrive.
        if factor.is_finite() { factor } else { Complex64::new(0.0, 0.0) }
    }
}

/// Velocity \[m/s\] of the column's top every `dt` \[s\] from 0 to `duration` \[s\], under a wave whose velocity at the
/// base is `incident` \[m/s\]; empty for a wave that is zero.
pub fn surface_velocity(layer: &Layer, incident: impl Fn(f64) -> f64, dt: f64, duration: f64) -> Vec<f64> {
    // The transform repeats its span: room for the column to come to rest, over which the wave is faded out.
    let room = 0.5 * duration + 10.0 * layer.height / layer.speed;
    let wanted = (duration / dt).ceil() as usize + 2;
    let count = (wanted + (room / dt).ceil() as usize).next_power_of_two();
    let span = count as f64 * dt;
    let fade = |t: f64| {
        if t <= duration { 1.0 } else { 0.5 + 0.5 * (PI * (t - duration) / (span - duration)).cos() }
    };
    let wave: Vec<f64> = (0..count).map(|k| k as f64 * dt).map(|t| fade(t) * incident(t)).collect();
    if wave.iter().all(|v| *v == 0.0) {
        return Vec::new();
    }
    let mut found = transferred(&wave, dt, &|omega| layer.factor(omega));
    found.truncate(wanted);
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    const NONE: Rayleigh = Rayleigh { mass: 0.0, stiffness: 0.0 };

    /// A pulse of about 2 Hz around 1 s.
    fn pulse(t: f64) -> f64 {
        let s = TAU * (t - 1.0);
        (1.0 - 2.0 * s * s) * (-s * s).exp()
    }

    fn largest(values: &[f64]) -> f64 {
        values.iter().fold(0.0_f64, |most, v| most.max(v.abs()))
    }

    #[test]
    fn without_damping_the_wave_arrives_doubled_and_late() {
        let layer = Layer { height: 240.0, speed: 1200.0, band: None, rayleigh: NONE };
        let found = surface_velocity(&layer, pulse, 1e-3, 3.0);
        for (k, v) in found.iter().enumerate().take(3000) {
            assert!((v - 2.0 * pulse(k as f64 * 1e-3 - 0.2)).abs() < 1e-9, "{k}");
        }
    }

    #[test]
    fn weak_damping_of_mass_or_stiffness_takes_what_first_order_says() {
        let (height, speed) = (240.0, 1200.0);
        let travel = height / speed;
        // A long train of one wavelength a height, with which damping changes nothing at the base: to first order
        // e^(−ω_R t/2) and e^(−ξω² t/2) over the travel time.
        let omega = TAU / travel;
        let train = |t: f64| (omega * t).sin() * (0.5 * t.min(2.0) / 2.0);
        let found = |rayleigh| {
            let layer = Layer { height, speed, band: None, rayleigh };
            largest(&surface_velocity(&layer, train, 1e-3, 6.0)[4000..])
        };
        let whole = found(NONE);
        let mass = Rayleigh { mass: 0.1, stiffness: 0.0 };
        assert!((found(mass) / whole - (-0.05 * travel).exp()).abs() < 2e-4);
        let stiffness = Rayleigh { mass: 0.0, stiffness: 2e-4 };
        assert!((found(stiffness) / whole - (-1e-4 * omega * omega * travel).exp()).abs() < 5e-4);
    }

    #[test]
    fn a_band_takes_about_its_ratio_times_the_phase() {
        let (height, speed, ratio) = (240.0, 1200.0, 0.02);
        let omega = TAU * speed / height;
        let train = |t: f64| (omega * t).sin() * (0.5 * t.min(2.0) / 2.0);
        let found = |band| {
            let layer = Layer { height, speed, band, rayleigh: NONE };
            largest(&surface_velocity(&layer, train, 1e-3, 6.0)[4000..])
        };
        let band = Band::fit(ratio, [0.5, 20.0], 5.0).unwrap();
        let exact = (-band.ratio(5.0) * omega * height / speed).exp();
        assert!((found(Some(band)) / found(None) / exact - 1.0).abs() < 3e-3);
    }
}
