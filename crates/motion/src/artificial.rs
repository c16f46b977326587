//! Motions made by computation: random phases under an envelope, matched to a target.

use std::f64::consts::PI;

use crate::fourier;
use realfft::num_complex::Complex64;

use crate::matching::{Matched, nearest};
use crate::shown::rounded;
use crate::{Channel, Error, TargetSpectrum, pseudo_acceleration};

/// How the strength of an artificial motion goes with time: (t/rise)² to the end of the rise, 1 to `fall`, then e^(−c(t − fall)), which
/// at the end has come to a twentieth (after `jennings1968`).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Envelope {
    /// s.
    pub rise: f64,
    /// s.
    pub fall: f64,
    /// s.
    pub duration: f64,
}

/// Rounds in which amplitudes are multiplied by target over spectrum, before wavelets are added.
const ROUNDS: usize = 6;
/// |correlation| of two motions at most, what is usually asked of motions that are to be independent.
pub const CORRELATION: f64 = 0.3;
/// Phases that are drawn for a motion at most.
const DRAWS: u64 = 20;

impl Envelope {
    /// Rises in a seventh of the duration and falls from three fifths of it on, an assumption for want of better.
    ///
    /// # Errors
    /// [`Error::Unsuitable`] if the three times are not in order.
    pub fn new(duration: f64, rise: Option<f64>, fall: Option<f64>) -> Result<Envelope, Error> {
        let (rise, fall) = (rise.unwrap_or(duration / 7.0), fall.unwrap_or(0.6 * duration));
        if !(rise > 0.0 && rise <= fall && fall < duration && duration.is_finite()) {
            return Err(Error::unsuitable(
                format!(
                    "an envelope that rises to {} s and falls from {} s of {} s is none",
                    rounded(rise),
                    rounded(fall),
                    rounded(duration)
                ),
                "give times above 0: the rise ends first, then the fall begins, before the end",
            ));
        }
        Ok(Envelope { rise, fall, duration })
    }

    fn at(&self, t: f64) -> f64 {
        if t < self.rise {
            (t / self.rise).powi(2)
        } else if t <= self.fall {
            1.0
        } else {
            (20f64.ln() * (self.fall - t) / (self.duration - self.fall)).exp()
        }
    }
}

/// Motions with random phases, of mutual correlation below [`CORRELATION`] at zero lag, each matched as [`matched`](crate::matched) does. Equal seeds
/// give equal motions; each of several has a seed of its own, the next number.
///
/// # Errors
/// Those of [`matched`](crate::matched); [`Error::Unsuitable`] where 20 draws of phases give none that fits and differs from those before.
pub fn artificial(
    target: &TargetSpectrum,
    band: [f64; 2],
    envelope: Envelope,
    dt: f64,
    seeds: std::ops::Range<u64>,
    tolerance: f64,
) -> Result<Vec<Matched>, Error> {
    let mut all: Vec<Matched> = Vec::new();
    for seed in seeds {
        let mut least = f64::INFINITY;
        let draws = (0..DRAWS).map(|draw| {
            let phases = seed.wrapping_mul(DRAWS).wrapping_add(draw);
            let samples = shaking(target, band, envelope, dt, phases)?;
            nearest(&Channel::new(format!("artificial {seed}"), dt, samples), target, band, tolerance)
        });
        let mut found = None;
        for one in draws {
            let one = one?;
            least = least.min(one.after.largest);
            let differs = |other: &Matched| {
                correlation(&one.channel.acceleration, &other.channel.acceleration).abs() < CORRELATION
            };
            if one.after.largest <= tolerance && all.iter().all(differs) {
                found = Some(one);
                break;
            }
        }
        let refused = || {
            Error::unsuitable(
                format!(
                    "{DRAWS} draws of phases gave no motion of '{}' that differs from those before and fits; the best was off by \
                     {:.1} %",
                    target.name,
                    100.0 * least
                ),
                "ask for fewer motions, longer ones, or a narrower band",
            )
        };
        all.push(found.ok_or_else(refused)?);
    }
    Ok(all)
}

/// Σab / √(Σa² Σb²) of two motions of one length and interval, those of a shorter one counted as zero behind it.
pub fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let square = |x: &[f64]| x.iter().map(|x| x * x).sum::<f64>();
    let both: f64 = a.iter().zip(b).map(|(a, b)| a * b).sum();
    both / (square(a) * square(b)).sqrt()
}

/// A motion whose Fourier amplitudes go after the target and whose phases are random, under the envelope.
fn shaking(
    target: &TargetSpectrum,
    [from, to]: [f64; 2],
    envelope: Envelope,
    dt: f64,
    seed: u64,
) -> Result<Vec<f64>, Error> {
    // The cast saturates.
    let samples = ((envelope.duration / dt).round() as usize).saturating_add(1);
    if !(4..=10_000_000).contains(&samples) {
        return Err(Error::unsuitable(
            format!("{} s at every {dt} s are {samples} samples", envelope.duration),
            "give a duration of seconds and an interval such as 0.01 s",
        ));
    }
    let length = samples.next_power_of_two();
    let back = fourier::inverse(length);
    // Periods somewhat beyond the band: oscillators at its ends see them as well.
    let [shortest, longest] = [from / 1.5, to * 1.5];
    let frequency = |k: usize| k as f64 / (length as f64 * dt);
    let in_band = |k: &usize| (1.0 / longest..=1.0 / shortest).contains(&frequency(*k));
    let lines: Vec<usize> = (1..length / 2).filter(in_band).collect();
    let mut state = seed;
    let phases: Vec<f64> = lines.iter().map(|_| 2.0 * PI * random(&mut state)).collect();
    // The power spectrum that a response spectrum asks for, but for factors that change slowly with the period (`kaul1978`).
    let power = |f: f64| target.damping * target.at(1.0 / f).powi(2) / (PI * PI * f);
    let mut amplitudes: Vec<f64> = lines.iter().map(|&k| power(frequency(k)).sqrt()).collect();
    let mut a = Vec::new();
    for round in 0..=ROUNDS {
        let mut spectrum = back.make_input_vec();
        for ((&k, amplitude), phase) in lines.iter().zip(&amplitudes).zip(&phases) {
            spectrum[k] = Complex64::from_polar(*amplitude, *phase);
        }
        let mut values = back.make_output_vec();
        // Lengths are those of the plan.
        let _ = back.process(&mut spectrum, &mut values);
        values.truncate(samples);
        values.iter_mut().enumerate().for_each(|(k, a)| *a *= envelope.at(k as f64 * dt));
        a = values;
        if round == ROUNDS {
            break;
        }
        let periods: Vec<f64> =
            (0..60).map(|i| longest * (shortest / longest).powf(f64::from(i) / 59.0)).collect();
        let spectrum = pseudo_acceleration(&a, dt, &periods, target.damping)?;
        let ratio: Vec<f64> =
            periods.iter().zip(spectrum).map(|(t, sa)| target.at(*t) / sa.max(1e-300)).collect();
        for (amplitude, &k) in amplitudes.iter_mut().zip(&lines) {
            let place = 59.0 * (longest * frequency(k)).ln() / (longest / shortest).ln();
            let left = (place.floor() as usize).min(58);
            let share = (place - left as f64).clamp(0.0, 1.0);
            *amplitude *= (1.0 - share) * ratio[left] + share * ratio[left + 1];
        }
    }
    Ok(a)
}

/// Numbers from 0 to 1: SplitMix64 (`steele2014`).
fn random(state: &mut u64) -> f64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let z = (*state ^ (*state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn motions_fit_differ_and_repeat() {
        let target = TargetSpectrum::en1998(1, 'B', 2.0).unwrap();
        let band = [0.2, 2.0];
        let envelope = Envelope::new(16.0, None, None).unwrap();
        let made = artificial(&target, band, envelope, 0.02, 1..3, 0.05).unwrap();
        for one in &made {
            assert!(one.after.largest <= 0.05, "{:?}", one.after);
        }
        let rho = correlation(&made[0].channel.acceleration, &made[1].channel.acceleration);
        assert!(rho.abs() < CORRELATION, "{rho}");
        let again = artificial(&target, band, envelope, 0.02, 1..2, 0.05).unwrap();
        assert_eq!(again[0], made[0]);
    }

    #[test]
    fn an_envelope_rises_stays_and_falls_to_a_twentieth() {
        let e = Envelope::new(20.0, Some(2.0), Some(10.0)).unwrap();
        for (t, exact) in [(0.0, 0.0), (1.0, 0.25), (2.0, 1.0), (10.0, 1.0), (20.0, 0.05)] {
            assert!((e.at(t) - exact).abs() < 1e-12, "{t}");
        }
        assert!(Envelope::new(20.0, Some(12.0), Some(10.0)).is_err());
        assert!(Envelope::new(f64::NAN, None, None).is_err());
    }
}
