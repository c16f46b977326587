//! Baseline correction and tapering of a record.

/// A straight line through the samples of a record, in their unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trend {
    /// Value at the first sample.
    pub intercept: f64,
    /// Change from one sample to the next.
    pub slope: f64,
}

/// The straight line that fits the samples best (least squares), as `scipy.signal.detrend(type="linear")`
/// subtracts. Fewer than two samples have slope 0.
pub fn linear_trend(values: &[f64]) -> Trend {
    if values.is_empty() {
        return Trend { intercept: 0.0, slope: 0.0 };
    }
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    // About the centre, so that the two unknowns do not disturb each other by cancellation.
    let centre = 0.5 * (count - 1.0);
    let moment: f64 = values.iter().enumerate().map(|(i, v)| (i as f64 - centre) * (v - mean)).sum();
    let inertia = count * (count * count - 1.0) / 12.0;
    let slope = if inertia > 0.0 { moment / inertia } else { 0.0 };
    Trend { intercept: mean - slope * centre, slope }
}

/// Takes the straight line of best fit off the samples.
pub(crate) fn detrend_linear(values: &mut [f64]) {
    let line = linear_trend(values);
    for (i, value) in values.iter_mut().enumerate() {
        *value -= line.intercept + line.slope * i as f64;
    }
}

/// Velocity and displacement at every sample after the first, of an acceleration that is linear between its samples; from rest.
fn integrated(acceleration: &[f64], dt: f64) -> impl Iterator<Item = [f64; 2]> {
    acceleration.windows(2).scan([0.0, 0.0], move |[v, u], pair| {
        *u += dt * *v + dt * dt * (2.0 * pair[0] + pair[1]) / 6.0;
        *v += 0.5 * dt * (pair[0] + pair[1]);
        Some([*v, *u])
    })
}

/// The last of them.
fn end_of(acceleration: &[f64], dt: f64) -> [f64; 2] {
    integrated(acceleration, dt).last().unwrap_or_default()
}

/// Velocity and displacement at the end over their peaks, from rest, of an acceleration that is straight between its samples.
pub fn drift(acceleration: &[f64], dt: f64) -> [f64; 2] {
    let larger = |most: [f64; 2], now: [f64; 2]| [0, 1].map(|i| most[i].max(now[i].abs()));
    let most = integrated(acceleration, dt).fold([0.0; 2], larger);
    let end = end_of(acceleration, dt);
    [0, 1].map(|i| if most[i] > 0.0 { end[i].abs() / most[i] } else { 0.0 })
}

/// Subtracts (b + c (2t/T − 1)) sin²(πt/T), T the record's length, with b and c such that velocity and displacement
/// end at zero. The correction and its slope vanish at both ends. Fewer than five samples stay as they are.
pub(crate) fn bring_to_rest(values: &mut [f64], dt: f64) {
    if values.len() < 5 {
        return;
    }
    let last = (values.len() - 1) as f64;
    let bump = |i: usize| (std::f64::consts::PI * i as f64 / last).sin().powi(2);
    let even: Vec<f64> = (0..values.len()).map(bump).collect();
    let odd: Vec<f64> = (0..values.len()).map(|i| bump(i) * (2.0 * i as f64 / last - 1.0)).collect();
    let ([ve, ue], [vo, uo], [v, u]) = (end_of(&even, dt), end_of(&odd, dt), end_of(values, dt));
    // The even bump alone moves the velocity, the odd one the displacement: the determinant is far from zero.
    let determinant = ve * uo - vo * ue;
    let (b, c) = ((v * uo - vo * u) / determinant, (ve * u - v * ue) / determinant);
    for ((value, even), odd) in values.iter_mut().zip(&even).zip(&odd) {
        *value -= b * even + c * odd;
    }
}

/// Fades both ends in and out with half a cosine wave of `seconds` each, first and last sample to zero.
pub(crate) fn taper(values: &mut [f64], dt: f64, seconds: f64) {
    let count = values.len();
    for (i, value) in values.iter_mut().enumerate() {
        let from_end = i.min(count - 1 - i) as f64 * dt;
        if from_end < seconds {
            *value *= 0.5 * (1.0 - (std::f64::consts::PI * from_end / seconds).cos());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_baseline_brings_motion_to_rest_and_leaves_the_shaking_alone() {
        let dt = 0.01;
        let shaking = |i: usize| 3.0 * (0.2 * i as f64).sin() * (-((i as f64 - 800.0) / 200.0).powi(2)).exp();
        let mut values: Vec<f64> = (0..1600).map(|i| shaking(i) + 0.05 - 2e-5 * i as f64).collect();
        let [v, u] = end_of(&values, dt);
        assert!(v.abs() > 0.3 && u.abs() > 1.0, "the record drifts at first");
        let before = values.clone();
        bring_to_rest(&mut values, dt);
        let [v, u] = end_of(&values, dt);
        assert!(v.abs() < 1e-12 && u.abs() < 1e-11);
        assert_eq!((values[0], values[1599]), (before[0], before[1599]));
        // The correction holds the drift alone: some hundredths of the shaking's peak.
        assert!(values.iter().zip(&before).all(|(a, b)| (a - b).abs() < 0.2));
    }

    #[test]
    fn detrending_a_line_leaves_nothing_and_keeps_what_is_orthogonal_to_lines() {
        let even = [1.0, -2.0, 1.0];
        let mut values: Vec<f64> = even.iter().enumerate().map(|(i, e)| e + 5.0 - 0.5 * i as f64).collect();
        let line = linear_trend(&values);
        assert!((line.intercept - 5.0).abs() < 1e-14 && (line.slope + 0.5).abs() < 1e-14);
        detrend_linear(&mut values);
        for (v, e) in values.iter().zip(even) {
            assert!((v - e).abs() < 1e-14);
        }
    }

    #[test]
    fn the_taper_is_zero_at_the_ends_half_in_the_middle_and_one_inside() {
        let mut values = vec![1.0; 21];
        taper(&mut values, 0.1, 0.4);
        assert_eq!((values[0], values[20]), (0.0, 0.0));
        assert!((values[2] - 0.5).abs() < 1e-15 && (values[18] - 0.5).abs() < 1e-15);
        assert!(values[4..=16].iter().all(|v| *v == 1.0));
    }
}
