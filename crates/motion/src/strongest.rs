//! Finding the part of a record that matters.

use crate::baseline::detrend_linear;
use crate::{Channel, Error, common_time_base, cumulative_trapezoid};

/// The strongest window of a record.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strongest {
    /// Where it begins (s), in the record's own time.
    pub start: f64,
    /// Where it ends (s).
    pub end: f64,
    /// Its share of the whole Arias intensity of all components, 0 to 1.
    pub share: f64,
}

/// The window of `length` (s) that holds most Arias intensity over all components, each linearly detrended.
///
/// `length` is rounded to whole intervals. Of equal windows the earliest; the whole record if it is shorter.
///
/// # Errors
/// [`Error::Unsuitable`] if `length` is not above 0, or as [`common_time_base`].
pub fn strongest_window(channels: &[&Channel], length: f64) -> Result<Strongest, Error> {
    if !(length > 0.0) {
        return Err(Error::unsuitable(
            format!("a window of {length} s has no length"),
            "give a length in s, such as 20",
        ));
    }
    let channels = common_time_base(channels)?;
    // At least one channel with at least two samples: common_time_base refuses anything less.
    let (dt, start, count) = (channels[0].dt, channels[0].start, channels[0].acceleration.len());
    let mut power = vec![0.0; count];
    for channel in &channels {
        let mut acceleration = channel.acceleration.clone();
        detrend_linear(&mut acceleration);
        power.iter_mut().zip(&acceleration).for_each(|(p, a)| *p += a * a);
    }
    let energy = cumulative_trapezoid(&power, dt);
    // The cast saturates, so any length is fine.
    let steps = ((length / dt).round() as usize).clamp(1, count - 1);
    let held = |i: usize| energy[i + steps] - energy[i];
    let mut best = 0;
    for i in 1..count - steps {
        if held(i) > held(best) {
            best = i;
        }
    }
    let total = energy[count - 1];
    Ok(Strongest {
        start: start + best as f64 * dt,
        end: start + (best + steps) as f64 * dt,
        share: if total > 0.0 { held(best) / total } else { 0.0 },
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn burst(centre: f64, size: f64) -> Channel {
        let wave = |t: f64| size * (40.0 * t).sin() * (-(t - centre).powi(2)).exp();
        let acceleration = (0..3001).map(|i| wave(0.01 * f64::from(i))).collect();
        Channel { start: 100.0, ..Channel::new("burst", 0.01, acceleration) }
    }

    #[test]
    fn the_window_sits_on_the_stronger_burst_in_record_time() {
        let found = strongest_window(&[&burst(8.0, 1.0), &burst(20.0, 2.0)], 4.0).unwrap();
        assert!((found.start - 118.0).abs() < 0.05 && (found.end - found.start - 4.0).abs() < 1e-9);
        // Energies are as 1 to 4, and erf(2√2) of the stronger one is inside.
        assert!((found.share - 0.8).abs() < 1e-3, "{}", found.share);
    }

    #[test]
    fn a_record_shorter_than_the_window_is_taken_whole() {
        let record = burst(8.0, 1.0);
        for length in [30.0, 1e3, f64::INFINITY] {
            let found = strongest_window(&[&record], length).unwrap();
            assert_eq!((found.start, found.share), (100.0, 1.0));
            assert!((found.end - 130.0).abs() < 1e-9);
        }
        assert!(strongest_window(&[&record], 0.0).is_err() && strongest_window(&[], 1.0).is_err());
        assert!(strongest_window(&[&record], f64::NAN).is_err());
    }
}
