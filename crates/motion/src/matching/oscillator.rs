//! The oscillators whose responses are matched, and when they respond most.

use std::f64::consts::PI;

use crate::TargetSpectrum;
use crate::spectrum::follow;
use crate::target::spread;

/// Spacing of the periods that are matched, in the logarithm. An oscillator with 5 % damping sees a tenth of its period to either side.
const SPACING: f64 = 0.03;
/// Half waves of an oscillator that are minded: as many at most, from this share of the largest on.
const PEAKS: usize = 4;
const NEAR: f64 = 0.7;

/// One matched period.
pub(super) struct Oscillator {
    pub omega: f64,
    pub damping: f64,
    /// Target (m/s²).
    pub target: f64,
    /// ω²u by steps since the top of a triangular pulse of the ground of height one that is two dt wide.
    pub pulse: Vec<f64>,
}

pub(super) fn oscillators(
    target: &TargetSpectrum,
    band: [f64; 2],
    samples: usize,
    dt: f64,
) -> Vec<Oscillator> {
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
pub(super) fn response(acceleration: &[f64], dt: f64, omega: f64, zeta: f64) -> Vec<f64> {
    let mut all = vec![0.0];
    follow(acceleration, dt, omega, zeta, |u| all.push(omega * omega * u));
    all
}

/// A largest or nearly largest response of an oscillator.
pub(super) struct Peak {
    pub oscillator: usize,
    /// Sample.
    pub at: usize,
    /// ω²u there (m/s²).
    pub response: f64,
}

/// The largest response of an oscillator, then the largest of other half waves that come within [`NEAR`] of it: they
/// become the largest if nobody minds them.
pub(super) fn peaks(a: &[f64], dt: f64, oscillator: usize, o: &Oscillator) -> Vec<Peak> {
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
