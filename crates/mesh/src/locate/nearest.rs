//! The nearest point of an element's surface.

use crate::Shape;

type Point = [f64; 3];

/// The point of the element's surface nearest to `at`; quadrilaterals as two triangles, which is exact
/// for flat ones.
pub(super) fn nearest_on_surface(shape: Shape, nodes: &[Point; 8], at: Point) -> Point {
    let mut best = (f64::INFINITY, nodes[0]);
    for face in shape.faces() {
        for k in 2..face.len() {
            let foot = nearest_on_triangle([nodes[face[0]], nodes[face[k - 1]], nodes[face[k]]], at);
            let away = minus(at, foot);
            let squared = dot(away, away);
            if squared < best.0 {
                best = (squared, foot);
            }
        }
    }
    best.1
}

/// The foot of the perpendicular, if it falls inside the triangle, else the nearest point of an edge.
fn nearest_on_triangle(corners: [Point; 3], at: Point) -> Point {
    let [a, b, c] = corners;
    let (ab, ac, ap) = (minus(b, a), minus(c, a), minus(at, a));
    let (bb, bc, cc) = (dot(ab, ab), dot(ab, ac), dot(ac, ac));
    let (pb, pc) = (dot(ap, ab), dot(ap, ac));
    let det = bb * cc - bc * bc;
    if det > 0.0 {
        let (u, v) = ((cc * pb - bc * pc) / det, (bb * pc - bc * pb) / det);
        if u >= 0.0 && v >= 0.0 && u + v <= 1.0 {
            return [0, 1, 2].map(|i| a[i] + u * ab[i] + v * ac[i]);
        }
    }
    let mut best = (f64::INFINITY, a);
    for (from, to) in [(a, b), (b, c), (c, a)] {
        let along = minus(to, from);
        let length = dot(along, along);
        let part = if length > 0.0 { (dot(minus(at, from), along) / length).clamp(0.0, 1.0) } else { 0.0 };
        let foot = [0, 1, 2].map(|i| from[i] + part * along[i]);
        let away = minus(at, foot);
        if dot(away, away) < best.0 {
            best = (dot(away, away), foot);
        }
    }
    best.1
}

fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
