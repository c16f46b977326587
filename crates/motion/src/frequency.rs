//! How high the frequencies of a motion reach.

use crate::fourier;

use crate::Motion;

/// The frequency (Hz) below which `share` (0 to 1, usually 0.99 or 0.999) of the motion's energy lies, all three
/// components together. `None` for a motion without any.
///
/// Energy is that of the velocity, ∫ v² dt by Fourier transform of the sampled motion. Strain in a wave is
/// v/c and the energy it carries ρ c v², so this is what the mesh must carry; the spectrum of acceleration
/// weights high frequencies by ω² more and would ask for several times finer elements for the same error in
/// stress. Amplitude goes with the root of energy: a share of 0.99 leaves out a tenth of the amplitude, 0.999
/// three hundredths. A share of 0.5 gives a central frequency.
///
/// The measure sees a low-pass that was applied, and needs no correction for it;
/// [`crate::lowest_lowpass`] tells its corner, which bounds what may be left out on purpose. It resolves
/// 1/duration; a velocity that does not end near zero adds a false tail at high frequencies, so measure after
/// detrending and tapering.
pub fn highest_frequency(motion: &Motion, share: f64) -> Option<f64> {
    frequency_below(&motion.velocity, motion.dt, share)
}

/// The frequency (Hz) below which `share` of the energy Σ ∫ x² dt of signals lies that are sampled every `dt` (s) and equally
/// long. `None` where there is none.
pub fn frequency_below(signals: &[Vec<f64>], dt: f64, share: f64) -> Option<f64> {
    let count = signals.first()?.len();
    if count < 2 {
        return None;
    }
    let transform = fourier::forward(count);
    let mut energy = vec![0.0; count / 2 + 1];
    for signal in signals {
        let mut input = signal.clone();
        let mut output = transform.make_output_vec();
        // Refused only for wrong lengths.
        transform.process(&mut input, &mut output).ok()?;
        energy.iter_mut().zip(&output).for_each(|(e, z)| *e += z.norm_sqr());
    }
    // All lines but the first, and the last of an even count, stand for two of the full spectrum.
    let doubled = if count.is_multiple_of(2) { 1..energy.len() - 1 } else { 1..energy.len() };
    energy[doubled].iter_mut().for_each(|e| *e *= 2.0);

    let total: f64 = energy.iter().sum();
    if !(total > 0.0) {
        return None;
    }
    let mut below = 0.0;
    let line = energy.iter().position(|e| {
        below += e;
        below >= share * total
    });
    Some(line.unwrap_or(energy.len() - 1) as f64 / (count as f64 * dt))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Motion, Sample, ricker_velocity};

    #[test]
    fn a_sine_has_its_energy_at_its_frequency() {
        let omega = 2.0 * std::f64::consts::PI * 5.0;
        let motion =
            Motion::sampled(0.01, 9.99, |t| Sample { v: [0.0, 0.0, (omega * t).sin()], ..Sample::default() })
                .unwrap();
        for share in [0.01, 0.5, 0.99] {
            assert!((highest_frequency(&motion, share).unwrap() - 5.0).abs() < 1e-9);
        }
    }

    /// The amplitude spectrum of a Ricker wavelet is x² exp(−x²), x = f/f_p; the share of x⁴ exp(−2x²) below
    /// x is, with s = 2 x, the chi-squared distribution of five degrees of freedom at s². Its 99 % point is
    /// 15.0863 and its median 4.3515 (tables), so x = 1.94205 and 1.04301.
    #[test]
    fn a_ricker_pulse_has_its_energy_where_the_chi_squared_table_says() {
        let pulse = ricker_velocity(2.0, 5.0, 1.0);
        let motion = Motion::sampled(0.01, 100.0, |t| pulse(t).along([0.6, 0.8, 0.0])).unwrap();
        for (share, x) in [(0.99, 1.94205), (0.5, 1.04301)] {
            // One line of the spectrum is 0.01 Hz.
            assert!((highest_frequency(&motion, share).unwrap() - 2.0 * x).abs() < 0.011);
        }
    }

    #[test]
    fn a_motion_at_rest_has_no_frequency() {
        let still = Motion::sampled(0.01, 1.0, |_| Sample::default()).unwrap();
        assert_eq!(highest_frequency(&still, 0.99), None);
    }
}
