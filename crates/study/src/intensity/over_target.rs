//! How a motion's spectrum stands to a target over a band of periods.

use super::Of;
use tremolite_motion::{Error, Motion, TargetSpectrum, pseudo_acceleration};

/// Periods of the band, in the middles of equal parts of its logarithm.
const PERIODS: usize = 200;

/// e to the mean of ln(Sa/target), with Sa at each period of the components that are asked for.
///
/// # Errors
/// Where there is no target, the band reaches beyond it, or the motion does not move.
pub fn over_target(
    of: Of,
    band: [f64; 2],
    motion: &Motion,
    target: Option<&TargetSpectrum>,
) -> Result<f64, Error> {
    let Some(target) = target else {
        return Err(Error::unsuitable(
            "there is no spectrum that it could be set beside",
            "add target = \"EN 1998-1 type 1 ground B 2 m/s2\" or a CSV file to [scale], or [motion.target] to the case",
        ));
    };
    let [from, to] = target.band(Some(band))?;
    let part = (to / from).ln() / PERIODS as f64;
    let periods: Vec<f64> = (0..PERIODS).map(|i| from * libm::exp((i as f64 + 0.5) * part)).collect();
    let spectrum = |a: &[f64]| pseudo_acceleration(a, motion.dt, &periods, target.damping);
    let [x, y, _] = &motion.acceleration;
    let joined = |how: fn(f64, f64) -> f64| -> Result<Vec<f64>, Error> {
        Ok(spectrum(x)?.into_iter().zip(spectrum(y)?).map(|(x, y)| how(x, y)).collect())
    };
    let sa = match of {
        Of::Axis(axis) => spectrum(&motion.acceleration[axis])?,
        Of::Largest => joined(f64::max)?,
        Of::GeometricMean => joined(|x, y| (x * y).sqrt())?,
        Of::RotD50 | Of::RotD100 => {
            let mut turned: Vec<Vec<f64>> = Vec::new();
            for degree in 0..180 {
                let angle = f64::from(degree).to_radians();
                let (sin, cos) = (libm::sin(angle), libm::cos(angle));
                turned
                    .push(spectrum(&x.iter().zip(y).map(|(x, y)| x * cos + y * sin).collect::<Vec<f64>>())?);
            }
            let at = |k: usize| {
                let mut all: Vec<f64> = turned.iter().map(|one| one[k]).collect();
                all.sort_by(f64::total_cmp);
                if of == Of::RotD100 { all[179] } else { 0.5 * (all[89] + all[90]) }
            };
            (0..PERIODS).map(at).collect()
        }
    };
    if !sa.iter().all(|sa| *sa > 0.0) {
        // As other measures of what does not move.
        return Ok(0.0);
    }
    let sum: f64 = periods.iter().zip(sa).map(|(&t, sa)| libm::log(sa / target.at(t))).sum();
    Ok(libm::exp(sum / PERIODS as f64))
}
