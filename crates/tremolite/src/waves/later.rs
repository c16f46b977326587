//! Series that are later by a part of a sample.
//!
//! A value and a slope at each of four samples determine a polynomial of degree 7, which at twenty samples a period errs by less than 10⁻⁷ of a
//! sine: as much as numbers of four bytes. So a sum over points that a wave reaches one after the other is as good as its terms.

/// By how many samples something is later: whole ones, and weights of vectors and slopes of four samples, for the vector and for its slope.
pub struct Later {
    whole: usize,
    weights: [[[f64; 2]; 4]; 2],
}

impl Later {
    /// By 0 samples or more.
    pub fn by(samples: f64) -> Later {
        let whole = samples.floor();
        // Samples lie at −1, 0, 1 and 2, and what is sought between the middle ones.
        let at = 1.0 - (samples - whole);
        let nodes = [-1.0, 0.0, 1.0, 2.0];
        let mut weights = [[[0.0; 2]; 4]; 2];
        for (i, own) in nodes.iter().enumerate() {
            let others = || nodes.iter().filter(move |node| *node != own);
            let product = |t: f64| others().map(|node| (t - node) / (own - node)).product::<f64>();
            // Its slope, as a sum of products without one factor each: defined at samples too.
            let slope = |t: f64| -> f64 {
                let without = |left: &f64| {
                    let rest = others().filter(|node| *node != left);
                    rest.map(|node| (t - node) / (own - node)).product::<f64>() / (own - left)
                };
                others().map(without).sum()
            };
            let (l, rate, steep) = (product(at), slope(at), slope(*own));
            let (ahead, square) = (at - own, l * l);
            let twice = 2.0 * l * rate;
            weights[0][i] = [(1.0 - 2.0 * ahead * steep) * square, ahead * square];
            weights[1][i] =
                [-2.0 * steep * square + (1.0 - 2.0 * ahead * steep) * twice, square + ahead * twice];
        }
        Later { whole: whole as usize, weights }
    }

    /// Adds to a sum a series, vectors and their slopes, which is at rest before its first sample.
    pub fn add(&self, series: &[[[f64; 4]; 2]], sum: &mut [[[f64; 4]; 2]]) {
        let last = series.len() as isize - 1;
        for (k, sum) in (0_isize..).zip(sum).skip(self.whole) {
            // Between the second and the third.
            let first = k - self.whole as isize - 2;
            for (i, weights) in (0..).zip(self.weights[0].iter().zip(&self.weights[1])) {
                let at = first + i;
                if at < 0 {
                    continue;
                }
                let of = &series[at.min(last) as usize];
                for (sum, weights) in sum.iter_mut().zip([weights.0, weights.1]) {
                    (0..4).for_each(|c| sum[c] += weights[0] * of[0][c] + weights[1] * of[1][c]);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// A sine of a twentieth of a sample's frequency under a bell, which is nothing at both ends.
    fn wave(t: f64) -> [[f64; 4]; 2] {
        let (omega, s) = (TAU / 20.0, (t - 80.0) / 16.0);
        let bell = (-s * s).exp();
        let (sin, cos) = (omega * t).sin_cos();
        [[bell * sin, 0.0, -3.0 * bell * sin, 0.0], {
            let slope = bell * (omega * cos - s / 8.0 * sin);
            [slope, 0.0, -3.0 * slope, 0.0]
        }]
    }

    #[test]
    fn a_wave_of_twenty_samples_is_later_by_any_part_of_one() {
        let series: Vec<[[f64; 4]; 2]> = (0..160).map(|k| wave(f64::from(k))).collect();
        for by in [0.0, 1e-9, 0.3, 0.5, 0.999, 1.0, 7.25] {
            let mut sum = vec![[[0.0; 4]; 2]; series.len()];
            Later::by(by).add(&series, &mut sum);
            Later::by(by).add(&series, &mut sum);
            for (k, found) in sum.iter().enumerate().take(150) {
                let exact = wave(k as f64 - by);
                for (found, exact) in found.iter().flatten().zip(exact.iter().flatten()) {
                    assert!((found - 2.0 * exact).abs() < 2e-7, "{by} {k}: {found} {exact}");
                }
            }
        }
        // Whole samples leave what there is.
        let mut sum = vec![[[0.0; 4]; 2]; series.len()];
        Later::by(3.0).add(&series, &mut sum);
        assert_eq!(sum[3..], series[..157]);
    }
}
