//! How far a spectrum is from a target.

use crate::target::spread;
use crate::{Error, TargetSpectrum, pseudo_acceleration};

/// Periods at which a motion is judged; none of them is matched.
const JUDGED: usize = 200;

/// How far a motion's spectrum is from a target, over judged periods.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Misfit {
    /// Largest |Sa/target − 1|, and the period (s) where it is.
    pub largest: f64,
    pub period: f64,
    /// Root of the mean square of Sa/target − 1.
    pub rms: f64,
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
