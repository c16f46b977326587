//! Analytic pulses for problems with known solutions.

use std::f64::consts::PI;

use crate::Sample;

/// Acceleration (m/s²), velocity (m/s) and displacement (m) of a pulse along one line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scalar {
    pub a: f64,
    pub v: f64,
    pub u: f64,
}

impl Scalar {
    /// The pulse along `direction`, a unit vector in the model's axes.
    pub fn along(self, direction: [f64; 3]) -> Sample {
        Sample {
            a: direction.map(|d| d * self.a),
            v: direction.map(|d| d * self.v),
            u: direction.map(|d| d * self.u),
        }
    }
}

/// The pulse whose velocity is a Ricker wavelet: v = V (1 − 2 τ²) exp(−τ²), τ = π f (t − t₀).
///
/// `frequency` f (Hz) is where its spectrum peaks, `centre` t₀ (s), `velocity` V (m/s) the peak. Displacement
/// V (t − t₀) exp(−τ²) returns to zero. Nothing of note lies above 3 f, and before t₀ − 1.5/f all of it is
/// below 2·10⁻⁸ of the peaks; so choose t₀ of at least 1.5/f.
pub fn ricker_velocity(frequency: f64, centre: f64, velocity: f64) -> impl Fn(f64) -> Scalar {
    let k = PI * frequency;
    move |t| {
        let tau = k * (t - centre);
        let bell = velocity * (-tau * tau).exp();
        Scalar {
            a: k * tau * (4.0 * tau * tau - 6.0) * bell,
            v: (1.0 - 2.0 * tau * tau) * bell,
            u: (t - centre) * bell,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn acceleration_and_velocity_of_the_ricker_pulse_are_derivatives() {
        let pulse = ricker_velocity(3.0, 0.5, 2.0);
        let h = 1e-5;
        for i in 0..100 {
            let t = 0.01 * f64::from(i);
            let (before, here, after) = (pulse(t - h), pulse(t), pulse(t + h));
            // Central differences: h² (2 π f)³ V/6 of velocity is 2e-7 · V, of acceleration 2 π f times that.
            assert!(((after.u - before.u) / (2.0 * h) - here.v).abs() < 1e-6);
            assert!(((after.v - before.v) / (2.0 * h) - here.a).abs() < 2e-5);
        }
        assert_eq!(pulse(0.5).v, 2.0);
        let early = pulse(0.5 - 0.5);
        assert!(early.v.abs() < 2e-8 * 2.0 && early.u.abs() < 2e-8 * 0.1);
    }
}
