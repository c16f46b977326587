//! Orders of convergence, and the two constants of a damped oscillation from its samples.

/// Order p of an error that falls from `coarse` to `fine` when the size falls by `ratio`.
pub fn order(coarse: f64, fine: f64, ratio: f64) -> f64 {
    (coarse / fine).ln() / ratio.ln()
}

/// One oscillation as samples q_n obey it: q_{n+1} = trace · q_n − determinant · q_{n−1}.
///
/// Its two solutions are exp(±iθ) √determinant with cos θ = ½ trace/√determinant; so θ/Δt is the frequency of the
/// computed motion and √determinant its growth a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Oscillation {
    pub trace: f64,
    pub determinant: f64,
}

impl Oscillation {
    /// Least squares over all samples; exact to round-off if they hold one oscillation and nothing else.
    pub fn fit(q: &[f64]) -> Self {
        let (mut aa, mut ab, mut bb, mut ay, mut by) = (0.0, 0.0, 0.0, 0.0, 0.0);
        for w in q.windows(3) {
            let (a, b, y) = (w[1], -w[0], w[2]);
            aa += a * a;
            ab += a * b;
            bb += b * b;
            ay += a * y;
            by += b * y;
        }
        let det = aa * bb - ab * ab;
        Oscillation { trace: (ay * bb - by * ab) / det, determinant: (by * aa - ay * ab) / det }
    }

    /// Least squares with the determinant known to be 1: an undamped oscillation.
    pub fn fit_undamped(q: &[f64]) -> Self {
        let (mut num, mut den) = (0.0, 0.0);
        for w in q.windows(3) {
            num += w[1] * (w[0] + w[2]);
            den += w[1] * w[1];
        }
        Oscillation { trace: num / den, determinant: 1.0 }
    }

    /// Angle θ a step \[rad\].
    pub fn angle(&self) -> f64 {
        (0.5 * self.trace / self.determinant.sqrt()).clamp(-1.0, 1.0).acos()
    }

    /// Growth of the amplitude a step.
    pub fn growth(&self) -> f64 {
        self.determinant.sqrt()
    }

    /// Damping ratio ζ of the continuous oscillation through the samples.
    pub fn damping_ratio(&self) -> f64 {
        let decay = -self.growth().ln();
        decay / decay.hypot(self.angle())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_damped_cosine_gives_back_its_angle_and_decay() {
        let q: Vec<f64> = (0..50).map(|n| 0.99f64.powi(n) * (0.3 * f64::from(n) + 0.4).cos()).collect();
        let found = Oscillation::fit(&q);
        assert!((found.angle() - 0.3).abs() < 1e-12 && (found.growth() - 0.99).abs() < 1e-12);
        let decay = -0.99f64.ln();
        assert!((found.damping_ratio() - decay / decay.hypot(0.3)).abs() < 1e-12);
        let q: Vec<f64> = (0..50).map(|n| (0.3 * f64::from(n)).cos()).collect();
        assert!((Oscillation::fit_undamped(&q).angle() - 0.3).abs() < 1e-12);
    }

    #[test]
    fn an_error_that_falls_by_four_when_the_size_halves_has_order_two() {
        assert!((order(4e-3, 1e-3, 2.0) - 2.0).abs() < 1e-14);
    }
}
