//! Wavelets that are added to a record.

use std::f64::consts::PI;

use super::oscillator::Oscillator;
use crate::baseline::bring_to_rest;

/// Widths γ of a wavelet to either side of its middle: its size has come to e⁻⁹ there.
const WIDTHS: f64 = 3.0;
/// Share of a wavelet's length over which it is faded in and out at either end, which the record may cut.
const FADE: f64 = 0.1;

/// What is added to the samples from one on.
pub(super) struct Wavelet {
    pub from: usize,
    pub values: Vec<f64>,
}

/// ω²u of an oscillator at sample `at` under a wavelet.
pub(super) fn response_at(o: &Oscillator, wavelet: &Wavelet, at: usize) -> f64 {
    let Some(since) = at.checked_sub(wavelet.from) else { return 0.0 };
    let count = wavelet.values.len().min(since + 1);
    let pulses = o.pulse[since + 1 - count..=since].iter().rev();
    wavelet.values[..count].iter().zip(pulses).map(|(a, h)| a * h).sum()
}

/// The improved tapered cosine wavelet (`alatik2010`, eq. 12 to 14) a period earlier, so that the largest response falls on `instant`
/// \[s\]; three widths long to either side as far as the record goes, and at rest at both ends.
pub(super) fn wavelet(samples: usize, dt: f64, o: &Oscillator, instant: f64) -> Wavelet {
    let root = (1.0 - o.damping * o.damping).sqrt();
    let frequency = o.omega / (2.0 * PI);
    let width = 1.178 * frequency.powf(-0.93);
    let damped = o.omega * root;
    let middle = instant - ((root / o.damping).atan() + 2.0 * PI) / damped;
    let place = |t: f64| (t / dt).round().clamp(0.0, (samples - 1) as f64) as usize;
    let (from, to) = (place(middle - WIDTHS * width), place(middle + WIDTHS * width).max(place(instant)));
    let (begin, end) = (from as f64 * dt, to as f64 * dt);
    let fade = FADE * (end - begin);
    let value = |k: usize| {
        let t = k as f64 * dt;
        let from_end = (t - begin).min(end - t);
        let window = if from_end < fade { 0.5 * (1.0 - (PI * from_end / fade).cos()) } else { 1.0 };
        let since = t - middle;
        window * (damped * since).cos() * (-(since / width).powi(2)).exp()
    };
    let mut values: Vec<f64> = (from..=to).map(value).collect();
    bring_to_rest(&mut values, dt);
    Wavelet { from, values }
}
