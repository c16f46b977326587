//! Matching in time: wavelets are added to a record until its response spectrum is a target's.
//!
//! The method is that of Al Atik & Abrahamson (`alatik2010`). For each period the oscillator's largest response and its instant are
//! found; a wavelet whose own largest response falls on that instant is given to each; and the amplitudes solve for the misfits of all
//! periods together. Since the instant of the largest response may change, this is done again and again.
//!
//! Here the wavelet is their tapered cosine, faded at its ends, less what its velocity and displacement are at its own end, so that no
//! sum of wavelets drifts; and the equations are solved by damped least squares (`levenberg1944`), which bears periods that lie close
//! together.

use std::f64::consts::PI;

use crate::baseline::bring_to_rest;
use crate::spectrum::follow;
use crate::target::spread;
use crate::{Channel, Error, TargetSpectrum, pseudo_acceleration};

/// Spacing of the periods that are matched, in the logarithm. An oscillator with 5 % damping sees a tenth of its period to either side.
const SPACING: f64 = 0.03;
/// Periods at which a motion is judged; none of them is matched.
const JUDGED: usize = 200;
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
/// Half waves of an oscillator that are minded: as many at most, from this share of the largest on.
const PEAKS: usize = 4;
const NEAR: f64 = 0.7;
/// Times that half waves which would pass the target are added to the equations of a round.
const PASSES: usize = 4;
/// Rounds end where the misfit is this share of what is asked.
const BETTER: f64 = 0.8;
/// Widths γ of a wavelet to either side of its middle: its size has come to e⁻⁹ there.
const WIDTHS: f64 = 3.0;
/// Share of a wavelet's length over which it is faded in and out at either end, which the record may cut.
const FADE: f64 = 0.1;

/// How far a motion's spectrum is from a target, over judged periods.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Misfit {
    /// Largest |Sa/target − 1|, and the period (s) where it is.
    pub largest: f64,
    pub period: f64,
    /// Root of the mean square of Sa/target − 1.
    pub rms: f64,
}

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

/// The misfit of samples (m/s²) at 200 periods of a band (s) that none of the matched ones is.
///
/// # Errors
/// Those of [`pseudo_acceleration`].
pub fn misfit(
    acceleration: &[f64],
    dt: f64,
    target: &TargetSpectrum,
    band: [f64; 2],
) -> Result<Misfit, Error> {
    let periods = spread(band, JUDGED, 0.5, JUDGED);
    let spectrum = pseudo_acceleration(acceleration, dt, &periods, target.damping)?;
    let (mut most, mut squares) = ((0.0, band[0]), 0.0);
    for (&period, sa) in periods.iter().zip(spectrum) {
        let off = sa / target.at(period) - 1.0;
        squares += off * off;
        if !(off.abs() <= most.0) {
            most = (off.abs(), period);
        }
    }
    Ok(Misfit { largest: most.0, period: most.1, rms: (squares / JUDGED as f64).sqrt() })
}

/// The factor by which a record's spectrum is nearest to a target's in a band (s): the mean of ln(target/Sa) over its periods.
///
/// # Errors
/// Those of [`pseudo_acceleration`]; [`Error::Unsuitable`] for a record that does not move.
pub fn scale_to(
    acceleration: &[f64],
    dt: f64,
    target: &TargetSpectrum,
    band: [f64; 2],
) -> Result<f64, Error> {
    let periods = spread(band, JUDGED, 0.5, JUDGED);
    let spectrum = pseudo_acceleration(acceleration, dt, &periods, target.damping)?;
    if !spectrum.iter().all(|sa| *sa > 0.0) {
        return Err(Error::unsuitable("the record does not move", "give a record of an earthquake"));
    }
    let sum: f64 = periods.iter().zip(spectrum).map(|(&t, sa)| (target.at(t) / sa).ln()).sum();
    Ok((sum / JUDGED as f64).exp())
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

/// One matched period.
struct Oscillator {
    omega: f64,
    damping: f64,
    /// Target (m/s²).
    target: f64,
    /// ω²u by steps since the top of a triangular pulse of the ground of height one that is two dt wide.
    pulse: Vec<f64>,
}

fn oscillators(target: &TargetSpectrum, band: [f64; 2], samples: usize, dt: f64) -> Vec<Oscillator> {
    let mut spacings = ((band[1] / band[0]).ln() / SPACING).ceil().max(2.0) as usize;
    // 200 i/n is then never a whole number and a half, so that no matched period is judged.
    if spacings.is_multiple_of(16) {
        spacings += 1;
    }
    let one = |period: f64| {
        let omega = 2.0 * PI / period;
        let mut ground = vec![0.0; samples + 1];
        ground[1] = 1.0;
        let mut pulse = response(&ground, dt, omega, target.damping);
        pulse.remove(0);
        Oscillator { omega, damping: target.damping, target: target.at(period), pulse }
    };
    spread(band, spacings + 1, 0.0, spacings).into_iter().map(one).collect()
}

/// ω²u (m/s²) at every sample, from rest; see [`pseudo_acceleration`].
fn response(acceleration: &[f64], dt: f64, omega: f64, zeta: f64) -> Vec<f64> {
    let mut all = vec![0.0];
    follow(acceleration, dt, omega, zeta, |u| all.push(omega * omega * u));
    all
}

/// A largest or nearly largest response of an oscillator.
struct Peak {
    oscillator: usize,
    /// Sample.
    at: usize,
    /// ω²u there (m/s²).
    response: f64,
}

/// The largest response of an oscillator, then the largest of other half waves that come within [`NEAR`] of it: they
/// become the largest if nobody minds them.
fn peaks(a: &[f64], dt: f64, oscillator: usize, o: &Oscillator) -> Vec<Peak> {
    let all = response(a, dt, o.omega, o.damping);
    let mut tops: Vec<Peak> = Vec::new();
    for (at, &response) in all.iter().enumerate() {
        match tops.last_mut() {
            Some(top) if top.response * response > 0.0 => {
                if response.abs() > top.response.abs() {
                    (top.at, top.response) = (at, response);
                }
            }
            _ => tops.push(Peak { oscillator, at, response }),
        }
    }
    tops.sort_by(|a, b| b.response.abs().total_cmp(&a.response.abs()));
    let largest = tops.first().map_or(0.0, |top| top.response.abs());
    let kept = tops.iter().take(PEAKS).take_while(|top| top.response.abs() > NEAR * largest).count();
    tops.truncate(kept.max(1));
    tops
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

/// What is added to the samples from one on.
struct Wavelet {
    from: usize,
    values: Vec<f64>,
}

/// ω²u of an oscillator at sample `at` under a wavelet.
fn response_at(o: &Oscillator, wavelet: &Wavelet, at: usize) -> f64 {
    let Some(since) = at.checked_sub(wavelet.from) else { return 0.0 };
    let count = wavelet.values.len().min(since + 1);
    let pulses = o.pulse[since + 1 - count..=since].iter().rev();
    wavelet.values[..count].iter().zip(pulses).map(|(a, h)| a * h).sum()
}

/// The improved tapered cosine wavelet (`alatik2010`, eq. 12 to 14) a period earlier, so that the largest response falls on `instant`
/// \[s\]; three widths long to either side as far as the record goes, and at rest at both ends.
fn wavelet(samples: usize, dt: f64, o: &Oscillator, instant: f64) -> Wavelet {
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

/// x of length n that makes |Ax − b|² + λ²|x|² least, for A by rows: (AᵀA + λ²) x = Aᵀb by Cholesky's factors.
fn damped_least_squares(a: &[f64], b: &[f64], n: usize, lambda: f64) -> Vec<f64> {
    let mut m = vec![0.0; n * n];
    let mut x = vec![0.0; n];
    for (line, b) in a.chunks(n).zip(b) {
        for i in 0..n {
            x[i] += line[i] * b;
            for j in 0..=i {
                m[i * n + j] += line[i] * line[j];
            }
        }
    }
    for i in 0..n {
        m[i * n + i] += lambda * lambda;
        for j in 0..=i {
            let sum: f64 = (0..j).map(|k| m[i * n + k] * m[j * n + k]).sum();
            let rest = m[i * n + j] - sum;
            m[i * n + j] = if i == j { rest.sqrt() } else { rest / m[j * n + j] };
        }
    }
    for i in 0..n {
        let sum: f64 = (0..i).map(|k| m[i * n + k] * x[k]).sum();
        x[i] = (x[i] - sum) / m[i * n + i];
    }
    for i in (0..n).rev() {
        let sum: f64 = (i + 1..n).map(|k| m[k * n + i] * x[k]).sum();
        x[i] = (x[i] - sum) / m[i * n + i];
    }
    x
}

#[cfg(test)]
mod tests;
