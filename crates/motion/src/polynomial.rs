//! Polynomials of best fit through equally spaced samples.

/// Takes the polynomial of this degree that fits best (least squares) off the samples.
///
/// The fit is a sum of polynomials that are orthogonal over these very samples (Gram's), made by their recurrence on
/// −1 … 1. So no system of equations is solved, and degree 10 is as accurate as degree 1: powers of the time, which become parallel
/// with their degree, do not occur. With no more samples than coefficients nothing is left but round-off.
pub(crate) fn detrend_polynomial(values: &mut [f64], degree: usize) {
    let count = values.len();
    if count == 0 {
        return;
    }
    let last = (count - 1).max(1) as f64;
    let place = |i: usize| 2.0 * i as f64 / last - 1.0;
    let mut before = vec![0.0; count];
    let mut now = vec![1.0; count];
    let mut size_before = 1.0;
    for k in 0..=degree.min(count - 1) {
        let size: f64 = now.iter().map(|p| p * p).sum();
        // What is left of the samples, not the samples themselves: it loses no figures to the parts that are off already.
        let share = now.iter().zip(&*values).map(|(p, v)| p * v).sum::<f64>() / size;
        values.iter_mut().zip(&now).for_each(|(v, p)| *v -= share * p);
        // Even polynomials and odd ones follow each other, so the recurrence p₊ = x p − b p₋ has no term of p.
        let back = if k == 0 { 0.0 } else { size / size_before };
        for (i, (p, q)) in now.iter_mut().zip(&mut before).enumerate() {
            (*p, *q) = (place(i) * *p - back * *q, *p);
        }
        size_before = size;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A shaking on a baseline that bends.
    fn record() -> Vec<f64> {
        let at = |t: f64| {
            3.0 * (20.0 * t).sin() * (-((t - 4.0) / 1.5).powi(2)).exp() + 0.05 - 0.02 * t + 0.003 * t * t
        };
        (0..1001).map(|i| at(0.01 * f64::from(i))).collect()
    }

    /// Figures of `numpy.polynomial.Polynomial.fit` (NumPy 2.4.6).
    #[test]
    fn what_is_left_is_what_numpy_leaves() {
        let places = [0, 1, 250, 400, 777, 1000];
        for (degree, left) in [
            (
                1,
                [
                    0.04990260709692998,
                    0.05010689409774702,
                    -0.2958965572069768,
                    -3.0037349076808537,
                    -0.0074082806493378645,
                    0.0499734297477943,
                ],
            ),
            (
                2,
                [
                    -0.00010681191878477575,
                    0.0003975315961265505,
                    -0.28958906291670644,
                    -2.981658677664907,
                    -0.00537456427603214,
                    -3.5989267920449874e-05,
                ],
            ),
            (
                3,
                [
                    -0.00019028589382072414,
                    0.00031505930879102695,
                    -0.28955230773309926,
                    -2.9816351844682987,
                    -0.005408689091287305,
                    4.748470711532504e-05,
                ],
            ),
            (
                6,
                [
                    -0.0005854032343406076,
                    -6.741337670244929e-05,
                    -0.2895845536623704,
                    -2.9816886984733504,
                    -0.0054162947380230475,
                    -8.39723717921681e-05,
                ],
            ),
            (
                10,
                [
                    -0.0014166989076821596,
                    -0.0008288905441756547,
                    -0.289502193611143,
                    -2.981714791273677,
                    -0.005353508109988039,
                    -0.0001202582571999955,
                ],
            ),
        ] {
            let mut values = record();
            detrend_polynomial(&mut values, degree);
            for (i, expected) in places.into_iter().zip(left) {
                assert!((values[i] - expected).abs() < 1e-12, "degree {degree}: {} {expected}", values[i]);
            }
        }
    }

    #[test]
    fn a_polynomial_goes_and_comes_back_no_more_at_any_degree() {
        for degree in 0..=10 {
            let mut values: Vec<f64> =
                (0..4001).map(|i| (f64::from(i) / 4000.0).powi(degree) * 9.0 + 100.0).collect();
            detrend_polynomial(&mut values, degree as usize);
            assert!(values.iter().all(|v| v.abs() < 1e-11), "degree {degree}");
        }
        for count in 0..5 {
            let mut values: Vec<f64> = (0..count).map(f64::from).map(f64::exp).collect();
            detrend_polynomial(&mut values, 10);
            assert!(values.iter().all(|v| v.abs() < 1e-12), "{count} samples: {values:?}");
        }
    }
}
