//! Node coordinates along a line whose spacing grows from a near size to a far size.

use std::fmt;

/// Most elements along one line. A longer list is a slip in a unit, not a mesh.
const MOST: f64 = 1e6;

/// Why a line could not be divided.
#[derive(Clone, Debug, PartialEq)]
pub enum GradingError {
    /// The ends do not rise, or are not finite numbers.
    Ends { from: f64, to: f64 },
    /// A size is not a positive number.
    Size { what: &'static str, value: f64 },
    /// The growth from one element to the next is not a number above 1.
    Growth { value: f64 },
    /// More than a million elements along one line.
    TooMany { from: f64, to: f64, elements: f64 },
}

impl fmt::Display for GradingError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Ends { from, to } => {
                write!(
                    f,
                    "a line from {from} m to {to} m cannot be divided: its end must lie beyond its start"
                )
            }
            Self::Size { what, value } => {
                write!(f, "the {what} size is {value} m; give a positive length")
            }
            Self::Growth { value } => {
                write!(
                    f,
                    "a growth of {value} from one element to the next; give a number above 1, such as 1.2"
                )
            }
            Self::TooMany { from, to, elements } => write!(
                f,
                "{elements:.1e} elements between {from} m and {to} m; larger sizes are needed (check the units)"
            ),
        }
    }
}

impl std::error::Error for GradingError {}

/// Coordinates \[m\] from `from` to `to` with sizes that start at `near.0` and end at `near.1` (an end with
/// `None` is free) and grow inwards, by at most the factor `growth` from one element to the next, up to `far`.
///
/// The number of elements is rounded up, so no size exceeds what was asked for; all sizes of a line are
/// smaller by the same share. Both ends are met exactly.
///
/// # Errors
/// Ends that do not rise, sizes that are not positive, a growth not above 1, more than a million elements.
pub fn graded(
    from: f64,
    to: f64,
    near: (Option<f64>, Option<f64>),
    far: f64,
    growth: f64,
) -> Result<Vec<f64>, GradingError> {
    if !(from.is_finite() && to.is_finite() && to > from) {
        return Err(GradingError::Ends { from, to });
    }
    for (what, value) in
        [("size_near", near.0.unwrap_or(far)), ("size_near", near.1.unwrap_or(far)), ("size_far", far)]
    {
        if !(value.is_finite() && value > 0.0) {
            return Err(GradingError::Size { what, value });
        }
    }
    if !(growth.is_finite() && growth > 1.0) {
        return Err(GradingError::Growth { value: growth });
    }
    let line = Spacing::new(to - from, near, far, growth);
    let total = line.count(line.length);
    if total > MOST {
        return Err(GradingError::TooMany { from, to, elements: total });
    }
    // A hair below, so that a length of exactly three sizes makes three elements and not four.
    let n = (total - 1e-9).ceil().max(1.0) as usize;
    let mut coordinates: Vec<f64> =
        (0..=n).map(|i| from + line.position(total * i as f64 / n as f64)).collect();
    coordinates[0] = from;
    coordinates[n] = to;
    Ok(coordinates)
}

/// The wanted size along a line: a ramp up, a plateau, a ramp down. A geometric row of elements of first
/// size a and ratio q has the continuous size a ln q/(q − 1) + s ln q at the distance s: with it the integral
/// of 1/size counts elements exactly.
struct Spacing {
    length: f64,
    /// Slope of the ramps, ln q.
    slope: f64,
    /// Continuous size at the left end, on the plateau, at the right end.
    left: f64,
    plateau: f64,
    right: f64,
    /// Where the left ramp ends and where the right one begins.
    turns: [f64; 2],
}

impl Spacing {
    fn new(length: f64, near: (Option<f64>, Option<f64>), far: f64, growth: f64) -> Self {
        let slope = growth.ln();
        let share = slope / (growth - 1.0);
        let end = |near: Option<f64>| near.map_or(far, |size| (size * share).min(far));
        let (left, right) = (end(near.0), end(near.1));
        let (mut up, mut down) = ((far - left) / slope, length - (far - right) / slope);
        let mut plateau = far;
        if up > down {
            // The ramps meet before they reach `far`.
            up = ((right - left) / slope + length).clamp(0.0, 2.0 * length) / 2.0;
            down = up;
            plateau = (left + slope * up).min(right + slope * (length - down));
        }
        // An end larger than the other's ramp allows is lowered to that ramp.
        let left = left.min(plateau);
        let right = right.min(plateau);
        Spacing { length, slope, left, plateau, right, turns: [up, down] }
    }

    /// Number of elements from the start to the distance `s`.
    fn count(&self, s: f64) -> f64 {
        let [up, down] = self.turns;
        let ramp = |size: f64, s: f64| (1.0 + self.slope * s / size).ln() / self.slope;
        let mut count = ramp(self.left, s.min(up));
        if s > up {
            count += (s.min(down) - up) / self.plateau;
        }
        if s > down {
            count += ramp(self.right, self.length - down) - ramp(self.right, self.length - s);
        }
        count
    }

    /// The distance at which `count` elements are reached.
    fn position(&self, count: f64) -> f64 {
        let [up, down] = self.turns;
        let (first, second) = (self.count(up), self.count(down));
        let ramp = |size: f64, c: f64| size * ((self.slope * c).exp() - 1.0) / self.slope;
        if count <= first {
            ramp(self.left, count)
        } else if count <= second {
            up + (count - first) * self.plateau
        } else {
            self.length - ramp(self.right, self.count(self.length) - count)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sizes(x: &[f64]) -> Vec<f64> {
        x.windows(2).map(|p| p[1] - p[0]).collect()
    }

    #[test]
    fn a_geometric_row_is_reproduced() {
        // 1 + 1.25 + 1.25² + 1.25³ = 5.765625
        let x = graded(2.0, 2.0 + 5.765625, (Some(1.0), None), 100.0, 1.25).unwrap();
        for (size, exact) in sizes(&x).iter().zip([1.0, 1.25, 1.5625, 1.953125]) {
            assert!((size - exact).abs() < 1e-12, "{size} against {exact}");
        }
        assert_eq!(x.len(), 5);
    }

    #[test]
    fn a_line_without_near_ends_is_uniform() {
        let x = graded(-3.0, 6.0, (None, None), 3.0, 1.2).unwrap();
        assert_eq!(x.len(), 4);
        assert!(sizes(&x).iter().all(|s| (s - 3.0).abs() < 1e-12));
    }

    #[test]
    fn sizes_and_growth_stay_below_their_bounds() {
        for &(length, near, far, growth) in &[
            (195.0, (Some(3.0), None), 12.0, 1.3),
            (20.0, (Some(3.0), Some(1.5)), 12.0, 1.25),
            (4.0, (Some(3.0), Some(0.1)), 12.0, 1.3),
            (90.0, (None, Some(0.7)), 9.0, 1.1),
            (5.0, (Some(8.0), Some(8.0)), 2.0, 1.2),
        ] {
            let x = graded(0.0, length, near, far, growth).unwrap();
            let sizes = sizes(&x);
            assert_eq!((x[0], x[x.len() - 1]), (0.0, length));
            assert!(sizes.iter().all(|&s| s > 0.0 && s <= far * (1.0 + 1e-9)), "{sizes:?}");
            if let Some(near) = near.0 {
                assert!(sizes[0] <= near * (1.0 + 1e-9), "{sizes:?}");
            }
            if let Some(near) = near.1 {
                assert!(sizes[sizes.len() - 1] <= near * (1.0 + 1e-9), "{sizes:?}");
            }
            for pair in sizes.windows(2) {
                assert!((pair[0] / pair[1]).max(pair[1] / pair[0]) <= growth * (1.0 + 1e-9), "{sizes:?}");
            }
        }
    }

    #[test]
    fn equal_ends_give_a_symmetric_line() {
        let x = graded(0.0, 31.0, (Some(1.0), Some(1.0)), 5.0, 1.3).unwrap();
        for (a, b) in x.iter().zip(x.iter().rev()) {
            assert!((a + b - 31.0).abs() < 1e-12);
        }
    }

    #[test]
    fn impossible_lines_are_refused() {
        let bad =
            |from, to, near, far, growth| graded(from, to, (Some(near), None), far, growth).unwrap_err();
        assert!(matches!(bad(1.0, 1.0, 1.0, 1.0, 1.2), GradingError::Ends { .. }));
        assert!(matches!(bad(0.0, f64::NAN, 1.0, 1.0, 1.2), GradingError::Ends { .. }));
        assert!(matches!(bad(0.0, 1.0, -1.0, 1.0, 1.2), GradingError::Size { .. }));
        assert!(matches!(bad(0.0, 1.0, 1.0, f64::INFINITY, 1.2), GradingError::Size { .. }));
        assert!(matches!(bad(0.0, 1.0, 1.0, 1.0, 1.0), GradingError::Growth { .. }));
        assert!(matches!(bad(0.0, 1.0, 1e-9, 1e-9, 1.2), GradingError::TooMany { .. }));
    }
}
