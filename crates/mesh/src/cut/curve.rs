//! How a node of a section may move.

/// How a node may move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Freedom {
    Free,
    /// Along the border that it lies on, through the node before and the one behind.
    Along(Curve),
    Fixed,
}

/// A border at a node: the parabola through it and its neighbours there, straight where they are in line, and of an arc off by a
/// small share of its rise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Curve {
    at: [f64; 2],
    half: [f64; 2],
    bend: [f64; 2],
}

impl Curve {
    pub fn through(before: [f64; 2], at: [f64; 2], behind: [f64; 2]) -> Curve {
        let along = |i: usize| 0.5 * (behind[i] - before[i]);
        let across = |i: usize| 0.5 * (behind[i] + before[i]) - at[i];
        Curve { at, half: [along(0), along(1)], bend: [across(0), across(1)] }
    }

    /// The way from the node to the place `t`: −1 and 1 are its neighbours.
    pub fn way(&self, t: f64) -> [f64; 2] {
        [0, 1].map(|i| t * (self.half[i] + t * self.bend[i]))
    }

    /// The place, nearest to the node, at which n·(x − at) = `short`, if there is one up to the neighbours.
    pub fn meets(&self, normal: [f64; 2], short: f64) -> Option<f64> {
        if short == 0.0 {
            return Some(0.0);
        }
        let (a, b) = (dot(normal, self.bend), dot(normal, self.half));
        // a t² + b t = short, without loss where a is small.
        let root = (b * b + 4.0 * a * short).max(0.0).sqrt();
        let t = 2.0 * short / (b + b.signum() * root);
        let meets = t.is_finite() && (a * t * t + b * t - short).abs() <= 1e-9 * short.abs().max(1e-12);
        (meets && t.abs() <= 1.0).then_some(t)
    }

    /// The place that is `way` along the border.
    pub fn along(&self, way: [f64; 2]) -> f64 {
        dot(way, self.half) / dot(self.half, self.half)
    }
}

pub(super) fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

pub(super) fn minus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

pub(super) fn length(a: [f64; 2]) -> f64 {
    a[0].hypot(a[1])
}
