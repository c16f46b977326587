//! The elastic response spectrum.

use crate::Error;
use crate::intensity::peak;

/// Pseudo-acceleration spectrum ω² max |u| (m/s²) of a damped oscillator under `acceleration` (m/s²) sampled
/// every `dt` (s), at each of `periods` (s). `damping` is the ratio to critical (0.05 for the usual spectrum).
///
/// The oscillator starts at rest and is integrated exactly for an acceleration that is linear between samples
/// (Nigam & Jennings 1969, Bull. Seism. Soc. Am. 59(2):909–922). Peaks are taken at the samples and during the
/// record; for periods below some 10 `dt` the true peak may lie between samples. Period 0 gives the peak
/// ground acceleration.
///
/// # Errors
/// [`Error::Unsuitable`] for a period below 0 or not finite, or a damping ratio outside [0, 1).
pub fn pseudo_acceleration(
    acceleration: &[f64],
    dt: f64,
    periods: &[f64],
    damping: f64,
) -> Result<Vec<f64>, Error> {
    if !(0.0..1.0).contains(&damping) {
        return Err(Error::unsuitable(
            format!("the damping ratio {damping} is not in [0, 1)"),
            "give a fraction of critical damping, such as 0.05",
        ));
    }
    periods
        .iter()
        .map(|&period| {
            if !(period >= 0.0 && period.is_finite()) {
                return Err(Error::unsuitable(
                    format!("the period {period} s is not a number from 0 upwards"),
                    "give periods in s",
                ));
            }
            if period == 0.0 {
                return Ok(peak(acceleration));
            }
            let omega = 2.0 * std::f64::consts::PI / period;
            let mut largest = 0.0_f64;
            follow(acceleration, dt, omega, damping, |u| largest = largest.max(u.abs()));
            Ok(omega * omega * largest)
        })
        .collect()
}

/// Tells u (m) at every sample after the first, u'' + 2 ζ ω u' + ω² u = −a, from rest.
pub(crate) fn follow(acceleration: &[f64], dt: f64, omega: f64, zeta: f64, mut told: impl FnMut(f64)) {
    let damped = omega * (1.0 - zeta * zeta).sqrt();
    let decay = (-zeta * omega * dt).exp();
    let (sin, cos) = (damped * dt).sin_cos();
    let (mut u, mut v) = (0.0_f64, 0.0_f64);
    for pair in acceleration.windows(2) {
        // A particular solution p + q s for the load −(a0 + j s), the rest swings freely.
        let j = (pair[1] - pair[0]) / dt;
        let q = -j / (omega * omega);
        let p = (-pair[0] - 2.0 * zeta * omega * q) / (omega * omega);
        let x = u - p;
        let y = (v - q + zeta * omega * x) / damped;
        u = decay * (x * cos + y * sin) + p + q * dt;
        v = decay * (damped * (y * cos - x * sin) - zeta * omega * (x * cos + y * sin)) + q;
        told(u);
    }
}

/// A hundred periods from 0.02 s to 10 s, equally spaced in the logarithm: for plots and tables.
pub fn default_periods() -> Vec<f64> {
    (0..100).map(|i| 0.02 * 500f64.powf(f64::from(i) / 99.0)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_step_load_on_an_undamped_oscillator_swings_to_twice_the_static_value() {
        // u = −(a/ω²)(1 − cos ω t); the period is a multiple of dt, so a sample meets the peak.
        let psa = pseudo_acceleration(&[1.5; 201], 0.01, &[1.0, 0.5], 0.0).unwrap();
        assert!(psa.iter().all(|s| (s - 3.0).abs() < 1e-11), "{psa:?}");
    }

    #[test]
    fn a_damped_step_load_overshoots_by_the_textbook_factor() {
        let zeta: f64 = 0.05;
        let overshoot = 1.0 + (-std::f64::consts::PI * zeta / (1.0 - zeta * zeta).sqrt()).exp();
        // The samples are fine enough for a parabola's top: (π dt/T)²/2 of the swing.
        let psa = pseudo_acceleration(&[1.0; 4001], 0.0005, &[1.0], zeta).unwrap();
        assert!((psa[0] - overshoot).abs() < 2e-6);
    }

    #[test]
    fn period_zero_is_the_peak_and_nonsense_is_refused() {
        assert_eq!(pseudo_acceleration(&[0.0, -2.0, 1.0], 0.01, &[0.0], 0.05).unwrap(), [2.0]);
        assert!(pseudo_acceleration(&[0.0], 0.01, &[-1.0], 0.05).is_err());
        assert!(pseudo_acceleration(&[0.0], 0.01, &[f64::NAN], 0.05).is_err());
        assert!(pseudo_acceleration(&[0.0], 0.01, &[1.0], 1.0).is_err());
    }

    #[test]
    fn default_periods_run_from_the_first_to_the_last() {
        let periods = default_periods();
        assert!((periods[0] - 0.02).abs() < 1e-15 && (periods[99] - 10.0).abs() < 1e-12);
        assert!(periods.windows(2).all(|p| p[0] < p[1]));
    }
}
