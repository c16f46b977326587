//! Measures of how strong a record is.

use std::f64::consts::PI;

use crate::baseline::detrend_linear;
use crate::{Channel, cumulative_trapezoid};

/// Gravity (m/s²) in the definition of the Arias intensity, by custom of the field.
const ARIAS_GRAVITY: f64 = 9.81;

/// Intensity measures of one channel. Peaks are of absolute values at the samples; all integrals are
/// trapezoidal, velocity and displacement starting from zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Intensity {
    /// Sampling interval (s).
    pub dt: f64,
    /// Number of samples.
    pub npts: usize,
    /// Peak ground acceleration (m/s²).
    pub pga: f64,
    /// Peak ground velocity (m/s).
    pub pgv: f64,
    /// Peak ground displacement (m).
    pub pgd: f64,
    /// Arias intensity π/(2 g) ∫ a² dt (m/s), g = 9.81 m/s².
    pub arias: f64,
    /// Time (s) from the first sample at which 5 % of the Arias intensity is reached, linear between samples.
    pub t5: f64,
    /// The same for 95 %.
    pub t95: f64,
    /// Significant duration (s), from 5 % to 95 % of the Arias intensity.
    pub d5_95: f64,
    /// Cumulative absolute velocity ∫ |a| dt (m/s), without a threshold.
    pub cav: f64,
}

impl Intensity {
    /// Measures a channel after linear detrending.
    pub fn of(channel: &Channel) -> Intensity {
        let mut acceleration = channel.acceleration.clone();
        detrend_linear(&mut acceleration);
        Intensity::of_samples(&acceleration, channel.dt)
    }

    /// Measures samples (m/s²), `dt` (s) apart, as they are. No samples give zeros.
    pub fn of_samples(acceleration: &[f64], dt: f64) -> Intensity {
        let velocity = cumulative_trapezoid(acceleration, dt);
        let displacement = cumulative_trapezoid(&velocity, dt);
        let square: Vec<f64> = acceleration.iter().map(|a| a * a).collect();
        let energy = cumulative_trapezoid(&square, dt);
        let modulus: Vec<f64> = acceleration.iter().map(|a| a.abs()).collect();
        let total = energy.last().copied().unwrap_or(0.0);
        let [t5, t95] = [0.05, 0.95].map(|share| reaches(&energy, share * total) * dt);
        Intensity {
            dt,
            npts: acceleration.len(),
            pga: peak(acceleration),
            pgv: peak(&velocity),
            pgd: peak(&displacement),
            arias: PI / (2.0 * ARIAS_GRAVITY) * total,
            t5,
            t95,
            d5_95: t95 - t5,
            cav: cumulative_trapezoid(&modulus, dt).last().copied().unwrap_or(0.0),
        }
    }
}

/// The largest absolute value.
pub(crate) fn peak(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |m, v| v.abs().max(m))
}

/// Where a rising curve reaches `level`, in samples from the first, linear between them.
fn reaches(rising: &[f64], level: f64) -> f64 {
    match rising.iter().position(|e| *e >= level) {
        Some(i) if i > 0 && rising[i] > rising[i - 1] => {
            i as f64 - (rising[i] - level) / (rising[i] - rising[i - 1])
        }
        Some(i) => i as f64,
        None => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn constant_acceleration_has_closed_forms() {
        let i = Intensity::of_samples(&[2.0; 101], 0.01);
        assert_eq!((i.npts, i.pga), (101, 2.0));
        assert!((i.pgv - 2.0).abs() < 1e-12 && (i.pgd - 1.0).abs() < 1e-12);
        assert!((i.arias - PI / 19.62 * 4.0).abs() < 1e-12);
        assert!((i.d5_95 - 0.9).abs() < 1e-12 && (i.cav - 2.0).abs() < 1e-12);
    }

    #[test]
    fn a_channel_is_detrended_first() {
        let record = Channel::new("", 0.01, (0..50).map(|i| 3.0 - 0.1 * f64::from(i)).collect());
        let i = Intensity::of(&record);
        assert!(i.pga < 1e-13 && i.arias < 1e-25 && i.cav < 1e-13);
    }

    #[test]
    fn silence_and_nothing_measure_zero() {
        for samples in [&[][..], &[0.0], &[0.0; 5]] {
            let i = Intensity::of_samples(samples, 0.01);
            assert_eq!((i.pga, i.pgv, i.pgd, i.arias, i.d5_95, i.cav), (0.0, 0.0, 0.0, 0.0, 0.0, 0.0));
        }
    }
}
