//! Samples between samples.

/// Samples on either side that a value between them is made of.
const HALF_WIDTH: i64 = 32;

/// Shape of Kaiser's window for side lobes of −100 dB: 0.1102 (100 − 8.7), his empirical formula. With 64 samples its transition
/// is a tenth of the sampling frequency wide, from 0.9 to 1.1 of Nyquist.
const BETA: f64 = 0.1102 * (100.0 - 8.7);

/// What equally spaced samples are at a place between them, band-limited: a sum of sin(πx)/(πx) under a Kaiser window, 32 samples on
/// either side, with weights that add up to one.
///
/// `place` counts in samples from the first. At a sample it is that sample, bit for bit. Sines up to 0.9 of the Nyquist frequency
/// come out with an error below 3·10⁻⁵ of their amplitude (found: 5·10⁻⁶ up to 0.8, 2·10⁻⁵ at 0.9, 0.1 at 0.95); what a record
/// holds above is shaped by the window, as its own anti-alias filter has shaped it already. Nearer to an end than 32 samples the
/// record is thought to go on by odd reflection about its last sample, so that value and slope go on and nothing rings; there the
/// error of a sine is up to 0.1 (ω dt)² of its amplitude, by the curvature that turns about there.
///
/// `values` has at least two samples.
pub(crate) fn between(values: &[f64], place: f64) -> f64 {
    let left = place.floor();
    let offset = place - left;
    // The cast saturates.
    let left = left as i64;
    if offset == 0.0 {
        return reflected(values, left);
    }
    // sin π(x − k) differs by its sign alone from sample to sample.
    let (mut sum, mut weights, mut sign) = (0.0, 0.0, if HALF_WIDTH % 2 == 0 { -1.0 } else { 1.0 });
    for k in 1 - HALF_WIDTH..=HALF_WIDTH {
        let x = offset - k as f64;
        let weight = sign * kaiser(x / HALF_WIDTH as f64) / x;
        sum += weight * reflected(values, left.saturating_add(k));
        weights += weight;
        sign = -sign;
    }
    sum / weights
}

/// The sample of this index, or what odd reflection about the end samples puts there.
fn reflected(values: &[f64], index: i64) -> f64 {
    let last = values.len().saturating_sub(1) as i64;
    if (0..=last).contains(&index) {
        return values[index as usize];
    }
    if last < 1 {
        return values.first().copied().unwrap_or(0.0);
    }
    // Odd about both ends: what lies two lengths further is the same, higher by twice the difference of the ends.
    let (turns, within) = (index.div_euclid(2 * last), index.rem_euclid(2 * last));
    let (first, end) = (values[0], values[last as usize]);
    let value = if within <= last {
        values[within as usize]
    } else {
        2.0 * end - values[(2 * last - within) as usize]
    };
    value + 2.0 * turns as f64 * (end - first)
}

/// Kaiser's window over −1 … 1, times a constant.
fn kaiser(x: f64) -> f64 {
    // I₀(z) = Σ (z²/4)ᵏ / k!², of which 30 terms hold all figures up to z = 10.
    let quarter = 0.25 * BETA * BETA * (1.0 - x * x).max(0.0);
    let (mut term, mut sum) = (1.0, 1.0);
    for k in 1..30 {
        term *= quarter / f64::from(k * k);
        sum += term;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// Largest error of a sine of unit amplitude at `share` of Nyquist, away from the ends, over places and phases.
    fn error(share: f64) -> f64 {
        let mut worst = 0.0_f64;
        for phase in [0.0, 0.7, 1.5] {
            let wave = |i: f64| (PI * share * i + phase).sin();
            let values: Vec<f64> = (0..200).map(|i| wave(f64::from(i))).collect();
            for step in 0..400 {
                let place = 80.0 + 0.1 * f64::from(step) + 0.037;
                worst = worst.max((between(&values, place) - wave(place)).abs());
            }
        }
        worst
    }

    #[test]
    fn sines_come_out_by_frequency() {
        // A Kaiser window of -100 dB promises 1e-5 outside its
        // transition, which begins at 0.9.
        for (share, limit) in [(0.01, 2e-5), (0.1, 2e-5), (0.5, 2e-5), (0.8, 2e-5), (0.9, 3e-5), (0.95, 0.2)]
        {
            let found = error(share);
            println!("{share:5} of Nyquist: error {found:.2e}");
            assert!(found < limit, "{share} of Nyquist: {found:e}");
        }
        assert!(error(0.97) > 0.1, "no interpolation of this width knows frequencies next to Nyquist");
    }

    #[test]
    fn samples_come_back_bit_for_bit_and_straight_lines_go_on_past_the_ends() {
        let values: Vec<f64> = (0..50).map(|i| 3.0 + 0.1 * f64::from(i)).collect();
        for (i, value) in values.iter().enumerate() {
            assert_eq!(between(&values, i as f64), *value);
        }
        // The window's side lobes cost 3e-5 of the change from sample to sample.
        for place in [0.01, 0.5, 3.3, 24.5, 48.9] {
            let error = between(&values, place) - (3.0 + 0.1 * place);
            println!("slope at {place}: {error:.1e}");
            assert!(error.abs() < 5e-5 * 0.1, "{place}");
        }
        // Few samples are reflected again and again.
        for count in 2..6 {
            let few = &values[..count];
            assert!((between(few, 0.5) - 3.05).abs() < 1e-6 && between(few, 1e18).is_finite());
        }
        assert_eq!(
            [-1, -2, 50, 98, 99].map(|i| (reflected(&values, i) * 1e6).round() / 1e6),
            [2.9, 2.8, 8.0, 12.8, 12.9]
        );
    }

    #[test]
    fn ends_do_not_ring() {
        // A slow motion that is cut at its largest: 1.2 Hz at 100 Hz.
        let wave = |i: f64| (2.0 * PI * 0.012 * i).cos() + 0.5;
        let values: Vec<f64> = (0..300).map(|i| wave(f64::from(i))).collect();
        let mut worst = 0.0_f64;
        for i in 0..299 {
            for part in [0.25, 0.5, 0.75] {
                let place = f64::from(i) + part;
                worst = worst.max((between(&values, place) - wave(place)).abs());
            }
        }
        let curvature = (2.0 * PI * 0.012_f64).powi(2);
        println!("worst error at the ends {worst:.2e}, {:.3} of (omega dt)^2", worst / curvature);
        assert!(worst < 0.1 * curvature, "{worst:e}");
    }
}
