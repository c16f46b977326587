//! Records chosen from many by how near their spectra are to a target in shape.

use crate::misfit::{misfit, scale_to};
use crate::target::spread;
use crate::{Channel, Error, TargetSpectrum, pseudo_acceleration};

/// A record that was considered.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidate {
    /// Its place in the list that was given.
    pub record: usize,
    /// What to multiply it by: e to the mean of ln(target/Sa).
    pub factor: f64,
    /// Root of the mean square of ln(factor Sa/target) over the band.
    pub misfit: f64,
    /// Largest |factor Sa/target − 1|, and the period (s) where it is.
    pub largest: f64,
    pub period: f64,
}

/// Periods of the band, as for [`misfit`].
const PERIODS: usize = 200;

/// All records by rising misfit in a band (s), those apart whose factor is outside `factors`.
///
/// # Errors
/// Those of [`scale_to`], with the record's name.
pub fn select(
    records: &[Channel],
    target: &TargetSpectrum,
    band: [f64; 2],
    factors: [f64; 2],
) -> Result<[Vec<Candidate>; 2], Error> {
    let periods = spread(band, PERIODS, 0.5, PERIODS);
    let mut all = Vec::new();
    for (record, channel) in records.iter().enumerate() {
        let named = |error: Error| {
            let (problem, remedy) = error.message_and_remedy();
            Error::unsuitable(format!("'{}': {problem}", channel.name), remedy)
        };
        let (a, dt) = (&channel.acceleration, channel.dt);
        let factor = scale_to(a, dt, target, band).map_err(named)?;
        let scaled: Vec<f64> = a.iter().map(|a| factor * a).collect();
        let spectrum = pseudo_acceleration(&scaled, dt, &periods, target.damping).map_err(named)?;
        let squares: f64 =
            periods.iter().zip(spectrum).map(|(&t, sa)| (sa / target.at(t)).ln().powi(2)).sum();
        let most = misfit(&scaled, dt, target, band).map_err(named)?;
        all.push(Candidate {
            record,
            factor,
            misfit: (squares / PERIODS as f64).sqrt(),
            largest: most.largest,
            period: most.period,
        });
    }
    all.sort_by(|a, b| a.misfit.total_cmp(&b.misfit));
    let [least, most] = factors;
    let (fit, unfit) = all.into_iter().partition(|c| (least..=most).contains(&c.factor));
    Ok([fit, unfit])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::artificial::{Envelope, artificial};

    #[test]
    fn a_motion_that_fits_is_nearest_and_its_factor_undoes_a_scale() {
        let target = TargetSpectrum::en1998(1, 'B', 2.0).unwrap();
        let other = TargetSpectrum::en1998(2, 'A', 2.0).unwrap();
        let (band, envelope) = ([0.2, 2.0], Envelope::new(12.0, None, None).unwrap());
        let make = |target, seed: u64| {
            artificial(target, band, envelope, 0.02, seed..seed + 1, 0.05).unwrap().remove(0).channel
        };
        let (mut fits, apart) = (make(&target, 1), make(&other, 2));
        fits.acceleration.iter_mut().for_each(|a| *a *= 0.25);
        let records = [apart, fits];
        let [fit, unfit] = select(&records, &target, band, [0.2, 5.0]).unwrap();
        assert!(unfit.is_empty());
        assert_eq!([fit[0].record, fit[1].record], [1, 0]);
        assert!((fit[0].factor / 4.0 - 1.0).abs() < 0.05 && fit[0].misfit < 0.05);
        // The other's plateau ends at 0.25 s in place of 0.5 s.
        assert!(fit[1].misfit > 0.3, "{fit:?}");
        let [fit, unfit] = select(&records, &target, band, [0.5, 2.0]).unwrap();
        assert!(!fit.iter().any(|c| c.record == 1) && unfit.iter().any(|c| c.record == 1));
    }
}
