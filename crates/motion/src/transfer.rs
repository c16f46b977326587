//! A signal through a transfer function, in frequency.

use realfft::RealFftPlanner;
use realfft::num_complex::Complex64;
use std::f64::consts::TAU;

/// What a transfer function of ω \[rad/s\] > 0, time going as e^(iωt), makes of a signal sampled every `dt` \[s\]. The
/// transform repeats the signal's span, so leave room at its end for the answer to come to rest. An odd number of samples
/// loses its last one.
///
/// The line at zero takes the function's value close to zero, where it is smooth and at zero itself often 0/0.
pub fn transferred(signal: &[f64], dt: f64, factor: &dyn Fn(f64) -> Complex64) -> Vec<f64> {
    let count = signal.len() / 2 * 2;
    let mut wave = signal[..count].to_vec();
    if wave.iter().all(|v| *v == 0.0) {
        return wave;
    }
    let mut planner = RealFftPlanner::<f64>::new();
    let forward = planner.plan_fft_forward(count);
    let back = planner.plan_fft_inverse(count);
    let mut lines = forward.make_output_vec();
    // Refused only for wrong lengths.
    let Ok(()) = forward.process(&mut wave, &mut lines) else { return vec![f64::NAN; count] };
    let step = TAU / (count as f64 * dt);
    for (k, line) in lines.iter_mut().enumerate() {
        *line *= factor(step * (k as f64).max(1e-6)) / count as f64;
    }
    for end in [0, count / 2] {
        lines[end].im = 0.0;
    }
    let Ok(()) = back.process(&mut lines, &mut wave) else { return vec![f64::NAN; count] };
    wave
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_delay_and_a_derivative_are_what_they_say() {
        let (dt, count) = (0.01, 512);
        let pulse = |t: f64| (-((t - 2.0) / 0.1).powi(2)).exp();
        let signal: Vec<f64> = (0..count).map(|k| pulse(k as f64 * dt)).collect();
        let late = transferred(&signal, dt, &|omega| Complex64::from_polar(3.0, -omega));
        let steep = transferred(&signal, dt, &|omega| Complex64::new(0.0, omega));
        for k in 0..count {
            let t = k as f64 * dt;
            assert!((late[k] - 3.0 * pulse(t - 1.0)).abs() < 1e-12, "{t}");
            let slope = -2.0 * (t - 2.0) / 0.01 * pulse(t);
            assert!((steep[k] - slope).abs() < 1e-9, "{t}: {} {slope}", steep[k]);
        }
        assert_eq!(transferred(&[0.0; 6], dt, &|_| Complex64::new(f64::NAN, 0.0)), [0.0; 6]);
    }
}
