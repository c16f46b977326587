//! The surface of the ground.

use super::CavernError;
use super::error::value;
use crate::{Mesh, quality};

/// Most values along one axis of a table of heights.
const MOST: usize = 100_000;

/// Steepest slope that leaves elements a scaled Jacobian of 0.3 where the rock is sheared to follow it.
const LEAST_JACOBIAN: f64 = 0.3;

/// Heights of the ground above z = 0. The rock above the caverns is divided as under the highest ground and squeezed in z
/// where it is lower, so sizes keep within `far`; from the caverns' surroundings down nothing moves.
///
/// Sides that are to match (periodic ones) need the same heights on both.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum GroundSurface {
    /// z = 0 everywhere.
    #[default]
    Level,
    /// A plane through z = 0 at x = y = 0 that rises so much along x and along y, m per m.
    Inclined { x: f64, y: f64 },
    /// Heights \[m\] at the places x and y \[m\], which rise; `heights[j * x.len() + i]` is at (x\[i\], y\[j\]).
    /// Linear in between, constant beyond the ends. With one value in `y` the heights are the same along y.
    Table { x: Vec<f64>, y: Vec<f64>, heights: Vec<f64> },
}

impl GroundSurface {
    /// Height above z = 0 \[m\].
    pub fn height(&self, x: f64, y: f64) -> f64 {
        match self {
            GroundSurface::Level => 0.0,
            GroundSurface::Inclined { x: along_x, y: along_y } => x * along_x + y * along_y,
            GroundSurface::Table { x: xs, y: ys, heights } => {
                let ((i, s), (j, t)) = (between(xs, x), between(ys, y));
                let at = |i: usize, j: usize| heights[j.min(ys.len() - 1) * xs.len() + i.min(xs.len() - 1)];
                let row = |j: usize| (1.0 - s) * at(i, j) + s * at(i + 1, j);
                (1.0 - t) * row(j) + t * row(j + 1)
            }
        }
    }

    /// Its greatest height within a rectangle of x and y, or 0 if it is nowhere above.
    pub(super) fn highest(&self, x: [f64; 2], y: [f64; 2]) -> f64 {
        let inside = |list: &[f64], range: [f64; 2]| -> Vec<f64> {
            let within = list.iter().copied().filter(|v| range[0] < *v && *v < range[1]);
            within.chain(range).collect()
        };
        // Linear between the places of a table along x and along y, it is highest at one of them or at a corner.
        let (xs, ys) = match self {
            GroundSurface::Level => return 0.0,
            GroundSurface::Inclined { .. } => (x.to_vec(), y.to_vec()),
            GroundSurface::Table { x: xs, y: ys, .. } => (inside(xs, x), inside(ys, y)),
        };
        let heights = ys.iter().flat_map(|&y| xs.iter().map(move |&x| self.height(x, y)));
        heights.fold(0.0, f64::max)
    }
}

/// The place before `x` in a list that rises, and the share of the way to the next.
fn between(list: &[f64], x: f64) -> (usize, f64) {
    let after = list.partition_point(|v| *v <= x);
    match (after.checked_sub(1), list.get(after)) {
        (Some(before), Some(next)) => (before, (x - list[before]) / (next - list[before])),
        (Some(last), None) => (last, 0.0),
        (None, _) => (0, 0.0),
    }
}

pub(super) fn check(ground: &GroundSurface) -> Result<(), CavernError> {
    match ground {
        GroundSurface::Level => {}
        GroundSurface::Inclined { x, y } => {
            for (key, slope) in [("ground.x", *x), ("ground.y", *y)] {
                if !(-5.0..=5.0).contains(&slope) {
                    return Err(value(key, slope, "a rise of at most 5 m per m"));
                }
            }
        }
        GroundSurface::Table { x, y, heights } => {
            for (key, list) in [("ground.x", x), ("ground.y", y)] {
                if list.is_empty() || list.len() > MOST {
                    return Err(value(key, list.len() as f64, format!("a list of 1 to {MOST} places")));
                }
                if let Some(bad) = list.iter().find(|v| !(-1e7..=1e7).contains(*v)) {
                    return Err(value(key, *bad, "a coordinate (and at most 1e7 m)"));
                }
                if let Some(pair) = list.windows(2).find(|p| p[1] <= p[0]) {
                    return Err(value(key, pair[1], format!("above the place before it, {} m", pair[0])));
                }
            }
            let wanted = x.len().saturating_mul(y.len());
            if heights.len() != wanted {
                let must = format!("a list of {wanted} heights, one for each x and y");
                return Err(value("ground.heights", heights.len() as f64, must));
            }
            if let Some(bad) = heights.iter().find(|v| !(-1e6..=1e6).contains(*v)) {
                return Err(value("ground.heights", *bad, "a height (and at most 1e6 m)"));
            }
        }
    }
    Ok(())
}

/// Where a point at the share `s` of a line goes when the line is stretched by `factor`, as a share of the new line.
///
/// (eᵏˢ − 1)/(eᵏ − 1): at the start nothing is stretched, so sizes go on from those below without a jump, and from
/// there they change geometrically.
fn stretched(s: f64, factor: f64) -> f64 {
    // k / (eᵏ − 1) = 1 / factor; the left side falls with k.
    let (mut low, mut high) = (-60.0_f64, 60.0_f64);
    for _ in 0..60 {
        let k = 0.5 * (low + high);
        let share = if k == 0.0 { 1.0 } else { k / k.exp_m1() };
        if share * factor > 1.0 {
            low = k;
        } else {
            high = k;
        }
    }
    let k = 0.5 * (low + high);
    if k.abs() < 1e-9 || s >= 1.0 { s } else { (k * s).exp_m1() / k.exp_m1() }
}

/// Moves the nodes above `cover` in z so that those at the level `top` come to lie on the ground.
pub(super) fn lift(
    ground: &GroundSurface,
    [cover, top]: [f64; 2],
    near: f64,
    mesh: &mut Mesh,
) -> Result<(), CavernError> {
    if *ground == GroundSurface::Level {
        return Ok(());
    }
    for node in mesh.nodes.iter_mut().filter(|x| x[2] > cover) {
        let height = ground.height(node[0], node[1]);
        let rock = height - cover;
        if rock < near {
            return Err(CavernError::LowGround { at: [node[0], node[1]], height, needed: cover + near });
        }
        node[2] = cover + rock * stretched((node[2] - cover) / (top - cover), rock / (top - cover));
    }
    let scaled_jacobian = quality::summary(mesh).min_scaled_jacobian;
    if scaled_jacobian < LEAST_JACOBIAN {
        return Err(CavernError::SteepGround { scaled_jacobian, limit: LEAST_JACOBIAN });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stretched_line_starts_with_its_old_sizes_and_ends_at_its_new_length() {
        for factor in [0.4, 0.9, 1.0, 1.001, 1.7, 3.0] {
            let h = 1e-6;
            let slope = factor * stretched(h, factor) / h;
            assert!((slope - 1.0).abs() < 1e-4, "{factor}: {slope}");
            assert_eq!(stretched(1.0, factor), 1.0);
            assert_eq!(stretched(0.0, factor), 0.0);
        }
    }
}
