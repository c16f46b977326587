//! What one side of a node needs to be held: tension over displacement.

/// Tension \[N\] over displacement \[m\]: points that rise, and the slopes \[N/m\] before and behind them.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    points: Vec<[f64; 2]>,
    before: f64,
    behind: f64,
}

impl Curve {
    /// The same tension everywhere.
    pub fn constant(force: f64) -> Self {
        Curve { points: vec![[0.0, force]], before: 0.0, behind: 0.0 }
    }

    /// A link from a node that is held to one at w: no tension where its elongation is `none` \[m\].
    pub fn held(none: f64, stiffness: f64, yields: f64) -> Self {
        let mut curve = Curve { points: vec![[none, 0.0]], before: stiffness, behind: stiffness };
        curve.end(yields);
        curve
    }

    /// Where w lies among the points: behind so many of them.
    fn place(&self, w: f64) -> usize {
        self.points.partition_point(|point| point[0] <= w)
    }

    pub fn at(&self, w: f64) -> f64 {
        let (k, last) = (self.place(w), self.points.len() - 1);
        if k == 0 {
            let [w0, force] = self.points[0];
            return force + self.before * (w - w0);
        }
        let [w0, force] = self.points[k - 1];
        if k > last {
            return force + self.behind * (w - w0);
        }
        let [w1, next] = self.points[k];
        (force + (w - w0) / (w1 - w0) * (next - force)).min(next)
    }

    /// Where the tension is `force`; of several places the one nearest to `near`, and the nearest end where it never is.
    pub fn inverse(&self, force: f64, near: f64) -> f64 {
        let last = self.points.len() - 1;
        let (first, end) = (self.points[0], self.points[last]);
        if force < first[1] {
            return if self.before > 0.0 {
                first[0] + (force - first[1]) / self.before
            } else {
                first[0].min(near)
            };
        }
        if force > end[1] {
            return if self.behind > 0.0 {
                end[0] + (force - end[1]) / self.behind
            } else {
                end[0].max(near)
            };
        }
        // Points below, and not above.
        let below = self.points.partition_point(|point| point[1] < force);
        let upto = self.points.partition_point(|point| point[1] <= force);
        if below < upto {
            let low =
                if below == 0 && self.before == 0.0 { f64::NEG_INFINITY } else { self.points[below][0] };
            let high =
                if upto > last && self.behind == 0.0 { f64::INFINITY } else { self.points[upto - 1][0] };
            // Not `clamp`, which would panic where round-off puts two places the wrong way round.
            return near.max(low).min(high);
        }
        let ([w0, n0], [w1, n1]) = (self.points[below - 1], self.points[below]);
        w0 + (force - n0) / (n1 - n0) * (w1 - w0)
    }

    /// Adds a bond without force at `none` \[m\], of this stiffness \[N/m\], which slides at this strength \[N\].
    pub fn bond(&mut self, none: f64, stiffness: f64, strength: f64) {
        if stiffness == 0.0 {
            return;
        }
        for bend in [none - strength / stiffness, none + strength / stiffness] {
            let (k, force) = (self.place(bend), self.at(bend));
            self.points.insert(k, [bend, force]);
        }
        for [w, force] in &mut self.points {
            *force += (stiffness * (*w - none)).clamp(-strength, strength);
        }
    }

    /// On to the other end of a link: w grows by q + N/k, and N ends at yield.
    pub fn link(&mut self, stiffness: f64, none: f64, yields: f64) {
        for [w, force] in &mut self.points {
            *w += none + *force / stiffness;
        }
        for slope in [&mut self.before, &mut self.behind] {
            *slope /= 1.0 + *slope / stiffness;
        }
        self.end(yields);
    }

    /// No more than ± this.
    fn end(&mut self, yields: f64) {
        let side = yields.copysign(self.points[0][1]);
        let ends = [self.inverse_end(-yields), self.inverse_end(yields)];
        self.points.retain(|point| point[1].abs() < yields);
        if let Some(low) = ends[0] {
            self.points.insert(0, [low, -yields]);
            self.before = 0.0;
        }
        if let Some(high) = ends[1] {
            self.points.push([high, yields]);
            self.behind = 0.0;
        }
        if self.points.is_empty() {
            // No end was reached and no point left: it lies beyond one of them everywhere.
            self.points.push([0.0, side]);
        }
    }

    /// Where the curve reaches an end, if it does.
    fn inverse_end(&self, force: f64) -> Option<f64> {
        let last = self.points[self.points.len() - 1];
        let reached = if force < 0.0 {
            self.points[0][1] <= force || self.before > 0.0
        } else {
            last[1] >= force || self.behind > 0.0
        };
        if !reached || !force.is_finite() {
            return None;
        }
        // The inner end of a stretch that is flat there.
        let near = if force < 0.0 { f64::INFINITY } else { f64::NEG_INFINITY };
        let w = self.inverse(force, near);
        w.is_finite().then_some(w)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_curve_is_its_own_inverse_where_it_rises() {
        let mut curve = Curve::constant(0.0);
        curve.bond(0.1, 2.0, 0.5);
        curve.link(4.0, 0.3, 10.0);
        curve.bond(-0.2, 1.0, 0.25);
        curve.link(1.0, 0.0, 0.6);
        for k in -59..60 {
            let force = 0.01 * f64::from(k);
            assert!((curve.at(curve.inverse(force, 0.0)) - force).abs() < 1e-12, "{force}");
        }
        for w in [-30.0, 30.0] {
            assert!((curve.at(w).abs() - 0.6).abs() < 1e-15);
        }
    }

    #[test]
    fn a_flat_stretch_is_left_where_the_bar_was() {
        let mut curve = Curve::constant(0.0);
        curve.bond(0.0, 1.0, 0.5);
        assert_eq!(curve.inverse(0.5, 7.0), 7.0);
        assert_eq!(curve.inverse(0.5, -7.0), 0.5);
        assert_eq!(curve.inverse(2.0, 3.0), 3.0);
        assert_eq!(Curve::constant(1.0).inverse(1.0, -2.0), -2.0);
    }
}
