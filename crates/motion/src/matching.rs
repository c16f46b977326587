//! Matching in time: wavelets are added to a record until its response spectrum is a target's.
//!
//! The method is that of Al Atik & Abrahamson (`alatik2010`). For each period the oscillator's largest response and its instant are
//! found; a wavelet whose own largest response falls on that instant is given to each; and the amplitudes solve for the misfits of all
//! periods together. Since the instant of the largest response may change, this is done again and again.
//!
//! Here the wavelet is their tapered cosine, faded at its ends, less what its velocity and displacement are at its own end, so that no
//! sum of wavelets drifts; and the equations are solved by damped least squares (`levenberg1944`), which bears periods that lie close
//! together.

mod least_squares;
mod oscillator;
#[cfg(test)]
mod tests;
mod wavelet;

use crate::baseline::bring_to_rest;
use crate::misfit::{Misfit, misfit, scale_to};
use crate::{Channel, Error, TargetSpectrum};
use least_squares::damped_least_squares;
use oscillator::{Oscillator, Peak, oscillators, peaks};
use wavelet::{Wavelet, response_at, wavelet};

/// Samples a shortest period: an oscillator's largest response then lies at most 1 − cos(π/20) = 1.2 % above that at samples.
const SAMPLES: f64 = 20.0;
/// Rounds at most, and after how many without gain it ends.
const ROUNDS: usize = 60;
const PATIENCE: usize = 12;
/// Weight of small amplitudes against small misfits, where a wavelet's own largest response is one.
const DAMPING: f64 = 0.01;
/// How much heavier an oscillator's misfit weighs in each further round, by its size: the largest of them counts, not the mean
/// (after `lawson1961`).
const GROWTH: f64 = 20.0;
/// Share of a round's amplitudes that is added: instants of largest responses change as wavelets are.
const SHARE: f64 = 0.7;
/// A misfit so much larger than the best is left.
const ASTRAY: f64 = 3.0;
/// Times that half waves which would pass the target are added to the equations of a round.
const PASSES: usize = 4;
/// Rounds end where the misfit is this share of what is asked.
const BETTER: f64 = 0.8;

/// A record whose spectrum is a target's.
#[derive(Debug, Clone, PartialEq)]
pub struct Matched {
    /// The motion, sampled finely enough for the shortest period of the band.
    pub channel: Channel,
    /// The record multiplied and at rest at its end, sampled in the same way, before wavelets were added.
    pub scaled: Vec<f64>,
    /// What the record was multiplied by.
    pub factor: f64,
    /// Of the record multiplied, and of the motion.
    pub before: Misfit,
    pub after: Misfit,
    /// Rounds of wavelets.
    pub rounds: usize,
}

/// Matches a record to a target within `tolerance` (a ratio, 0.05 for 5 %) at 200 periods of a band (s).
///
/// The record is taken as straight between its samples, and sampled so finely that the shortest period has twenty of them. It is
/// scaled as a whole, brought to rest at its end, and wavelets are added.
///
/// # Errors
/// [`Error::Unsuitable`] for a record in counts, shorter than twice the longest period, sampled more coarsely than a quarter of the
/// shortest one, or which does not come as near as asked; the text says how near, and at which period.
pub fn matched(
    record: &Channel,
    target: &TargetSpectrum,
    band: [f64; 2],
    tolerance: f64,
) -> Result<Matched, Error> {
    let made = nearest(record, target, band, tolerance)?;
    if made.after.largest <= tolerance {
        return Ok(made);
    }
    Err(Error::unsuitable(
        format!(
            "'{}' comes no nearer to '{}' than {:.1} %, at {:.3} s",
            record.name,
            target.name,
            100.0 * made.after.largest,
            made.after.period
        ),
        "choose a record whose spectrum is nearer in shape, a longer one, or a narrower band",
    ))
}

/// As [`matched`], though it may come no nearer than it does.
pub(crate) fn nearest(
    record: &Channel,
    target: &TargetSpectrum,
    band: [f64; 2],
    tolerance: f64,
) -> Result<Matched, Error> {
    suitable(record, band)?;
    if !(tolerance > 0.0 && tolerance < 1.0) {
        return Err(Error::unsuitable(
            format!("a tolerance of {tolerance} is not between 0 and 1"),
            "give a ratio such as 0.05",
        ));
    }
    let parts = (SAMPLES * record.dt / band[0]).ceil().max(1.0) as usize;
    let dt = record.dt / parts as f64;
    let mut a = between_samples(&record.acceleration, parts);
    bring_to_rest(&mut a, dt);
    let factor = scale_to(&a, dt, target, band)?;
    a.iter_mut().for_each(|x| *x *= factor);
    let scaled = a.clone();
    let before = misfit(&a, dt, target, band)?;
    let oscillators = oscillators(target, band, a.len(), dt);
    let (mut best, mut after, mut rounds, mut since) = (a.clone(), before, 0, 0);
    let (mut weights, mut share) = (vec![1.0; oscillators.len()], SHARE);
    while rounds < ROUNDS && since < PATIENCE && after.largest > BETTER * tolerance {
        add_wavelets(&mut a, dt, &oscillators, &mut weights, share);
        let now = misfit(&a, dt, target, band)?;
        rounds += 1;
        since += 1;
        if now.largest < after.largest {
            (after, since) = (now, 0);
            best.copy_from_slice(&a);
        } else if now.largest > ASTRAY * after.largest {
            // Largest responses moved too far: from the best again, by smaller steps.
            a.copy_from_slice(&best);
            weights.fill(1.0);
            share *= 0.5;
        }
    }
    let mut channel = record.at(0.0, best);
    channel.dt = dt;
    Ok(Matched { channel, scaled, factor, before, after, rounds })
}

/// Refuses records that cannot have such a spectrum.
fn suitable(record: &Channel, [from, to]: [f64; 2]) -> Result<(), Error> {
    record.sound()?;
    if record.raw {
        return Err(Error::unsuitable(
            format!("'{}' is in counts", record.name),
            "give its sensitivity, so that it is an acceleration",
        ));
    }
    if record.duration() < 2.0 * to {
        return Err(Error::unsuitable(
            format!(
                "'{}' lasts {:.2} s, less than twice the longest period of {to} s",
                record.name,
                record.duration()
            ),
            "give a longer record, or a band that ends earlier",
        ));
    }
    // Half of it is the Nyquist frequency; nothing is known above.
    if record.dt > 0.25 * from {
        return Err(Error::unsuitable(
            format!(
                "'{}' has a sample every {} s, which tells nothing at periods of {from} s",
                record.name, record.dt
            ),
            format!("begin the band at {:.3} s", 4.0 * record.dt),
        ));
    }
    Ok(())
}

/// Samples with `parts − 1` more between each two, on the straight line.
fn between_samples(values: &[f64], parts: usize) -> Vec<f64> {
    let mut all = Vec::with_capacity((values.len() - 1) * parts + 1);
    for pair in values.windows(2) {
        all.extend((0..parts).map(|k| pair[0] + (pair[1] - pair[0]) * k as f64 / parts as f64));
    }
    all.extend(values.last());
    all
}

/// One round: misfits at the instants of largest responses, and the wavelets that take them away together. The weights of oscillators
/// grow from round to round.
fn add_wavelets(a: &mut [f64], dt: f64, oscillators: &[Oscillator], weights: &mut [f64], share: f64) {
    let peaks: Vec<Vec<Peak>> = oscillators.iter().enumerate().map(|(k, o)| peaks(a, dt, k, o)).collect();
    let wavelets: Vec<Wavelet> = oscillators
        .iter()
        .zip(&peaks)
        .map(|(o, peaks)| {
            let at = peaks[0].at;
            let mut wavelet = wavelet(a.len(), dt, o, at as f64 * dt);
            let own = response_at(o, &wavelet, at).abs();
            if own > 0.0 {
                wavelet.values.iter_mut().for_each(|x| *x /= own);
            }
            wavelet
        })
        .collect();
    // Rows by peak, relative to the target, along the response's sign.
    let row = |&Peak { oscillator, at, response }: &Peak| {
        let o = &oscillators[oscillator];
        // A wavelet's amplitude is in shares of its own target, so that all are of one size.
        let effect = |(wavelet, of): (&Wavelet, &Oscillator)| {
            response.signum() * response_at(o, wavelet, at) * of.target / o.target
        };
        let effects: Vec<f64> = wavelets.iter().zip(oscillators).map(effect).collect();
        (effects, 1.0 - response.abs() / o.target)
    };
    let (mut matrix, mut wanted) = (Vec::new(), Vec::new());
    for ((effects, missing), weight) in peaks.iter().map(|peaks| row(&peaks[0])).zip(weights.iter_mut()) {
        *weight += GROWTH * missing.abs();
        matrix.extend(effects.iter().map(|e| *weight * e));
        wanted.push(*weight * missing);
    }
    // Others than the largest need not reach the target, only not pass it: they count where they would.
    let mut others: Vec<(Vec<f64>, f64, f64)> = Vec::new();
    for (peaks, weight) in peaks.iter().zip(&*weights) {
        others.extend(peaks[1..].iter().map(row).map(|(effects, missing)| (effects, missing, *weight)));
    }
    let count = oscillators.len();
    let mut amplitudes = damped_least_squares(&matrix, &wanted, count, DAMPING);
    for _ in 0..PASSES {
        let passes = |(effects, missing, _): &mut (Vec<f64>, f64, f64)| {
            effects.iter().zip(&amplitudes).map(|(e, x)| e * x).sum::<f64>() > *missing
        };
        let more: Vec<_> = others.extract_if(.., passes).collect();
        if more.is_empty() {
            break;
        }
        for (effects, missing, weight) in more {
            matrix.extend(effects.iter().map(|e| weight * e));
            wanted.push(weight * missing);
        }
        amplitudes = damped_least_squares(&matrix, &wanted, count, DAMPING);
    }
    for ((wavelet, amplitude), o) in wavelets.iter().zip(amplitudes).zip(oscillators) {
        let by = share * amplitude * o.target;
        a[wavelet.from..].iter_mut().zip(&wavelet.values).for_each(|(a, w)| *a += by * w);
    }
}
