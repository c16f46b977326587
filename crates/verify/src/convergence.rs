//! Orders of convergence, and the two constants of a damped oscillation from its samples.

/// Levels that an [`Order`] has room for.
const MOST: usize = 4;

/// Errors at sizes that fall, and the order of convergence p between the two finest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Order {
    /// Size over the finest, and error there, coarsest first.
    levels: [[f64; 2]; MOST],
    count: usize,
}

impl Order {
    /// p: errors go as the size to this power.
    pub fn value(&self) -> f64 {
        let [[coarse, before], [fine, after]] = [self.levels[self.count - 2], self.levels[self.count - 1]];
        (before / after).ln() / (coarse / fine).ln()
    }

    /// Size (of elements or steps, or whatever falls) over the finest, and the error there; coarsest first.
    pub fn levels(&self) -> &[[f64; 2]] {
        &self.levels[..self.count]
    }

    /// The same with the level before the coarsest one: its error, and its size over that of the coarsest.
    pub fn after(mut self, error: f64, ratio: f64) -> Self {
        self.levels.copy_within(0..self.count, 1);
        self.levels[0] = [ratio * self.levels[1][0], error];
        self.count += 1;
        self
    }
}

impl From<Order> for f64 {
    fn from(order: Order) -> f64 {
        order.value()
    }
}

/// Order p of an error that falls from `coarse` to `fine` when the size falls by `ratio`.
pub fn order(coarse: f64, fine: f64, ratio: f64) -> Order {
    let mut levels = [[0.0; 2]; MOST];
    levels[..2].copy_from_slice(&[[ratio, coarse], [1.0, fine]]);
    Order { levels, count: 2 }
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
        assert!((order(4e-3, 1e-3, 2.0).value() - 2.0).abs() < 1e-14);
    }

    #[test]
    fn a_level_before_lies_coarser_and_leaves_the_order_to_the_two_finest() {
        let found = order(4e-3, 1e-3, 2.0).after(8e-3, 3.0);
        assert_eq!(found.levels(), [[6.0, 8e-3], [2.0, 4e-3], [1.0, 1e-3]]);
        assert!((found.value() - 2.0).abs() < 1e-14);
    }
}
