//! Integration in time.

/// The running integral of equally spaced samples by the trapezoidal rule, zero at the first sample.
///
/// `values` in any unit, `dt` in s; as many samples come out as go in.
pub fn cumulative_trapezoid(values: &[f64], dt: f64) -> Vec<f64> {
    let mut sum = 0.0;
    let mut previous = None;
    values
        .iter()
        .map(|&value| {
            if let Some(before) = previous.replace(value) {
                sum += 0.5 * dt * (before + value);
            }
            sum
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_straight_line_integrates_exactly() {
        let values: Vec<f64> = (0..9).map(|i| 2.0 + 3.0 * 0.25 * f64::from(i)).collect();
        for (i, sum) in cumulative_trapezoid(&values, 0.25).into_iter().enumerate() {
            let t = 0.25 * i as f64;
            assert!((sum - (2.0 * t + 1.5 * t * t)).abs() < 1e-14);
        }
        assert!(cumulative_trapezoid(&[], 1.0).is_empty());
    }
}
