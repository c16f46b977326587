//! From a point back to natural coordinates.

use crate::Shape;
use crate::isoparametric::{derivatives, determinant, jacobian, point, weights};

/// Newton steps at most; a convex element needs fewer than ten.
const STEPS: usize = 40;
/// Farther out than this in natural coordinates, a point is in no way near the element.
const FAR: f64 = 8.0;
/// After a step this small Newton's method has only round-off to correct.
const SETTLED: f64 = 1e-9;

/// Natural coordinates of the point `at`, by Newton's method.
///
/// None if the search leaves the element's surroundings or does not settle, as it may for points well
/// outside.
pub(super) fn natural_coordinates(shape: Shape, nodes: &[[f64; 3]; 8], at: [f64; 3]) -> Option<[f64; 3]> {
    // From the first node, so that coordinates of a national grid do not swamp the element's size.
    let at = minus(at, nodes[0]);
    let nodes = &nodes.map(|x| minus(x, nodes[0]));
    let start = match shape {
        Shape::Hex8 => [0.0; 3],
        Shape::Wedge6 => [1.0 / 3.0, 1.0 / 3.0, 0.0],
        Shape::Tet4 => [0.25; 3],
        Shape::Pyramid5 => return pyramid_coordinates(nodes, at),
    };
    let nodes = &nodes[..shape.nodes()];
    newton(start, |natural| {
        let miss = minus(at, point(nodes, &weights(shape, natural)));
        solve(&jacobian(nodes, &derivatives(shape, natural)), miss)
    })
}

/// A pyramid's Jacobian is singular at the apex. But every point lies on a ray from the apex, and where
/// that meets the base, at which distance, is a regular problem.
fn pyramid_coordinates(nodes: &[[f64; 3]; 8], at: [f64; 3]) -> Option<[f64; 3]> {
    let nodes = &nodes[..Shape::Pyramid5.nodes()];
    let apex = nodes[4];
    let ray = minus(at, apex);
    let away = (ray[0] * ray[0] + ray[1] * ray[1] + ray[2] * ray[2]).sqrt();
    if away == 0.0 {
        return Some([0.0, 0.0, 1.0]);
    }
    // The distance to the base in units of the first edge, to compare steps with those of r and s.
    let edge = minus(nodes[0], apex);
    let unit = (edge[0] * edge[0] + edge[1] * edge[1] + edge[2] * edge[2]).sqrt();
    let ray = ray.map(|x| x / away * unit);
    let [r, s, reach] = newton([0.0, 0.0, 1.0], |[r, s, reach]| {
        let base = [r, s, 0.0];
        let x = minus(point(nodes, &weights(Shape::Pyramid5, base)), apex);
        let mut slope = jacobian(nodes, &derivatives(Shape::Pyramid5, base));
        for i in 0..3 {
            slope[i][2] = -ray[i];
        }
        solve(&slope, [0, 1, 2].map(|i| reach * ray[i] - x[i]))
    })?;
    Some([r, s, 1.0 - away / (reach * unit)])
}

/// Adds steps to `x` until they vanish.
fn newton(mut x: [f64; 3], step: impl Fn([f64; 3]) -> Option<[f64; 3]>) -> Option<[f64; 3]> {
    for _ in 0..STEPS {
        let step = step(x)?;
        for i in 0..3 {
            x[i] += step[i];
        }
        if x.iter().any(|x| x.is_nan() || x.abs() > FAR) {
            return None;
        }
        if step.iter().all(|s| s.abs() <= SETTLED) {
            return Some(x);
        }
    }
    None
}

/// The nearest natural coordinates in the element's range.
pub(super) fn clamp(shape: Shape, [r, s, t]: [f64; 3]) -> [f64; 3] {
    match shape {
        Shape::Hex8 => [r, s, t].map(|x| x.clamp(-1.0, 1.0)),
        Shape::Pyramid5 => [r.clamp(-1.0, 1.0), s.clamp(-1.0, 1.0), t.clamp(0.0, 1.0)],
        Shape::Tet4 => onto_simplex([r, s, t]),
        Shape::Wedge6 => {
            let [r, s] = onto_simplex([r, s]);
            [r, s, t.clamp(-1.0, 1.0)]
        }
    }
}

/// Into x ≥ 0, ∑x ≤ 1: cut off what is negative, then take the excess from all that are left.
fn onto_simplex<const N: usize>(x: [f64; N]) -> [f64; N] {
    let mut x = x.map(|v| v.max(0.0));
    for _ in 0..N {
        let excess = x.iter().sum::<f64>() - 1.0;
        let left = x.iter().filter(|&&v| v > 0.0).count();
        if excess <= 0.0 || left == 0 {
            break;
        }
        x = x.map(|v| if v > 0.0 { (v - excess / left as f64).max(0.0) } else { 0.0 });
    }
    x
}

/// Solves a 3 × 3 system by Cramer's rule; None if it is singular.
fn solve(a: &[[f64; 3]; 3], b: [f64; 3]) -> Option<[f64; 3]> {
    let det = determinant(a);
    if !det.is_normal() {
        return None;
    }
    Some([0, 1, 2].map(|column| {
        let mut with = *a;
        for (row, value) in with.iter_mut().zip(b) {
            row[column] = value;
        }
        determinant(&with) / det
    }))
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}
