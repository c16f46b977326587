//! A signal through a transfer function, in frequency.

use crate::fourier;
use realfft::num_complex::Complex64;
use std::f64::consts::TAU;

/// The lines of a real signal's spectrum, to be sent through transfer functions.
pub struct Lines {
    lines: Vec<Complex64>,
    /// Samples of the signal, an even number.
    count: usize,
    /// Between lines \[rad/s\].
    step: f64,
}

impl Lines {
    /// Of a signal sampled every `dt` \[s\]. An odd number of samples loses its last one. None if the transform refuses it.
    pub fn of(signal: &[f64], dt: f64) -> Option<Lines> {
        let count = signal.len() / 2 * 2;
        let mut wave = signal[..count].to_vec();
        let forward = fourier::forward(count);
        let mut lines = forward.make_output_vec();
        forward.process(&mut wave, &mut lines).ok()?;
        Some(Lines { lines, count, step: TAU / (count as f64 * dt) })
    }

    /// The same of a signal and, added to it, another that is turned in phase by a quarter: times i at all ω > 0.
    pub fn of_turned(signal: &[f64], turned: &[f64], dt: f64) -> Option<Lines> {
        let (mut lines, turned) = (Lines::of(signal, dt)?, Lines::of(turned, dt)?);
        for (line, other) in lines.lines.iter_mut().zip(&turned.lines) {
            *line += Complex64::i() * other;
        }
        Some(lines)
    }

    /// ω \[rad/s\] of a line. That at zero stands close to zero, where a transfer function is smooth and at zero itself often 0/0.
    pub fn omega(&self, line: usize) -> f64 {
        self.step * (line as f64).max(1e-6)
    }

    /// How many lines lie up to the last of which the rate of the signal, ω times the line, has this share of its largest.
    pub fn above(&self, share: f64) -> usize {
        let rate = |(k, line): (usize, &Complex64)| k as f64 * line.norm();
        let most = self.lines.iter().enumerate().map(rate).fold(0.0, f64::max);
        let last = (0..self.lines.len()).rev().find(|&k| rate((k, &self.lines[k])) > share * most);
        last.map_or(0, |k| k + 1)
    }

    /// The signal of these lines times as many factors; further lines are none.
    pub fn through(&self, factors: impl Iterator<Item = Complex64>) -> Vec<f64> {
        let back = fourier::inverse(self.count);
        self.with(factors, back.as_ref())
    }

    /// The signals of some sets of factors.
    pub fn through_each<I: Iterator<Item = Complex64>>(
        &self,
        sets: impl Iterator<Item = I>,
    ) -> Vec<Vec<f64>> {
        let back = fourier::inverse(self.count);
        sets.map(|factors| self.with(factors, back.as_ref())).collect()
    }

    fn with(
        &self,
        factors: impl Iterator<Item = Complex64>,
        back: &dyn realfft::ComplexToReal<f64>,
    ) -> Vec<f64> {
        let mut lines = back.make_input_vec();
        for ((out, line), factor) in lines.iter_mut().zip(&self.lines).zip(factors) {
            *out = line * factor / self.count as f64;
        }
        for end in [0, self.count / 2] {
            lines[end].im = 0.0;
        }
        let mut wave = back.make_output_vec();
        // Refused only for wrong lengths.
        let Ok(()) = back.process(&mut lines, &mut wave) else { return vec![f64::NAN; self.count] };
        wave
    }
}

/// What a transfer function of ω \[rad/s\] > 0, time going as e^(iωt), makes of a signal sampled every `dt` \[s\]. The
/// transform repeats the signal's span, so leave room at its end for the answer to come to rest. An odd number of samples
/// loses its last one.
pub fn transferred(signal: &[f64], dt: f64, factor: &dyn Fn(f64) -> Complex64) -> Vec<f64> {
    let count = signal.len() / 2 * 2;
    if signal[..count].iter().all(|v| *v == 0.0) {
        return vec![0.0; count];
    }
    let Some(lines) = Lines::of(signal, dt) else { return vec![f64::NAN; count] };
    lines.through((0..lines.lines.len()).map(|k| factor(lines.omega(k))))
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
