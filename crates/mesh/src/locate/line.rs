//! A straight line through a mesh: in which elements it lies, from where to where.
//!
//! All places where the line meets a face of an element near it are found first, each a quadratic equation since faces are
//! bilinear. Between two of them it lies in one element or in none, which its middle tells. So nothing goes by how elements are
//! joined, a line may lie in faces and along edges, and a face that is met twice over costs nothing.

use super::{Locator, natural_coordinates};
use crate::isoparametric::{point, weights};

/// A stretch of a line in one element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    pub element: u32,
    /// Distances from the line's first point \[m\].
    pub from: f64,
    pub to: f64,
}

/// What is shorter, over the length of the line, is no stretch of its own.
const SHORT: f64 = 1e-7;
/// How far outside a face, in its natural coordinates from 0 to 1, it still counts as met.
const BESIDE: f64 = 1e-9;
/// Shape functions below this are round-off.
const NO_WEIGHT: f64 = 1e-11;

/// How far outside an element's natural range a point may lie that a warped face puts there by round-off.
const NEAR: f64 = 1e-6;

type Point = [f64; 3];

fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Point, b: Point) -> Point {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// A line and the two planes that it is the intersection of.
struct Line {
    from: Point,
    along: Point,
    length: f64,
    normals: [Point; 2],
}

impl Line {
    fn new(from: Point, to: Point) -> Option<Self> {
        let way = minus(to, from);
        let length = dot(way, way).sqrt();
        if !(length > 0.0 && length.is_finite()) {
            return None;
        }
        let along = way.map(|x| x / length);
        let least = (0..3).min_by(|&a, &b| along[a].abs().total_cmp(&along[b].abs())).unwrap_or(0);
        let mut axis = [0.0; 3];
        axis[least] = 1.0;
        let first = cross(along, axis);
        let size = dot(first, first).sqrt();
        let first = first.map(|x| x / size);
        Some(Line { from, along, length, normals: [first, cross(along, first)] })
    }

    fn at(&self, distance: f64) -> Point {
        [0, 1, 2].map(|i| self.from[i] + distance * self.along[i])
    }

    /// Distances at which the line meets the bilinear face of four corners; a triangle repeats its last.
    fn meets(&self, corners: [Point; 4], found: &mut Vec<f64>) {
        let [p, q, r, s] = corners.map(|x| minus(x, self.from));
        // nᵢ·P(u, v) = a + bu + cv + duv = 0 of both planes.
        let [first, second] = self.normals.map(|n| {
            let [p, q, r, s] = [p, q, r, s].map(|x| dot(n, x));
            [p, q - p, s - p, p - q + r - s]
        });
        // v by the resultant: (a₁ + c₁v)(b₂ + d₂v) = (a₂ + c₂v)(b₁ + d₁v).
        let ([a1, b1, c1, d1], [a2, b2, c2, d2]) = (first, second);
        let roots = quadratic(c1 * d2 - c2 * d1, a1 * d2 + c1 * b2 - a2 * d1 - c2 * b1, a1 * b2 - a2 * b1);
        for v in roots.into_iter().flatten() {
            let (up, down) = ((a1 + c1 * v, b1 + d1 * v), (a2 + c2 * v, b2 + d2 * v));
            let (top, bottom) = if up.1.abs() >= down.1.abs() { up } else { down };
            let u = -top / bottom;
            let within = |x: f64| (-BESIDE..=1.0 + BESIDE).contains(&x);
            if within(u) && within(v) {
                let at = [0, 1, 2]
                    .map(|i| (1.0 - u) * ((1.0 - v) * p[i] + v * s[i]) + u * ((1.0 - v) * q[i] + v * r[i]));
                found.push(dot(at, self.along));
            }
        }
    }
}

/// Real roots of ax² + bx + c; those that are not finite are left to whoever looks whether they lie within bounds.
fn quadratic(a: f64, b: f64, c: f64) -> [Option<f64>; 2] {
    if a == 0.0 {
        return [(b != 0.0).then(|| -c / b), None];
    }
    let square = b * b - 4.0 * a * c;
    if square < 0.0 {
        return [None; 2];
    }
    // Without cancellation.
    let half = -0.5 * (b + square.sqrt().copysign(b));
    [Some(half / a), (half != 0.0).then(|| c / half)]
}

impl Locator<'_> {
    /// Where the straight line between two points \[m\] lies in elements, in order; nothing where it lies in none. Of elements
    /// that share the face it lies in the one of lowest index. Ends lie in the element but for 10⁻⁷ of the line's length.
    pub fn stretches(&self, from: [f64; 3], to: [f64; 3]) -> Vec<Stretch> {
        let Some(line) = Line::new(from, to) else { return Vec::new() };
        let mut meets = vec![0.0, line.length];
        for place in self.along(&line) {
            let element = &self.mesh.elements[self.elements[place as usize] as usize];
            for face in element.shape.faces() {
                let corner = |k: usize| {
                    let local = face[k.min(face.len() - 1)];
                    self.mesh.nodes[element.nodes[local] as usize]
                };
                line.meets([corner(0), corner(1), corner(2), corner(3)], &mut meets);
            }
        }
        let short = SHORT * line.length;
        meets.retain(|s| (0.0..=line.length).contains(s));
        meets.sort_by(f64::total_cmp);
        let mut stretches: Vec<Stretch> = Vec::new();
        let mut from = 0.0;
        for to in meets {
            if to - from <= short && to < line.length {
                continue;
            }
            if let Some(found) = self.locate(line.at(0.5 * (from + to)), 0.0) {
                match stretches.last_mut().filter(|last| last.element == found.element && last.to == from) {
                    Some(last) => last.to = to,
                    None => stretches.push(Stretch { element: found.element, from, to }),
                }
            }
            from = to;
        }
        stretches.retain(|stretch| stretch.to - stretch.from > short);
        stretches
    }

    /// Shape functions of an element's nodes at a point in it or on its surface, and the place that they describe, which is the
    /// point but for round-off; those that are nothing but round-off are 0. A point at most `beside` \[m\] away is moved onto the surface. None if
    /// the point lies elsewhere.
    pub fn weights_in(&self, element: u32, at: [f64; 3], beside: f64) -> Option<([f64; 8], [f64; 3])> {
        let element = &self.mesh.elements[element as usize];
        let nodes = self.corners(element);
        let natural = natural_coordinates(element.shape, &nodes, at)?;
        let clamped = super::clamp(element.shape, natural);
        let mut weights = weights(element.shape, clamped);
        if (0..3).any(|i| (natural[i] - clamped[i]).abs() > NEAR) {
            let off = minus(point(&nodes[..element.shape.nodes()], &weights), at);
            if dot(off, off) > beside * beside {
                return None;
            }
        }
        let dropped: f64 = weights.iter().filter(|w| w.abs() < NO_WEIGHT).sum();
        weights.iter_mut().filter(|w| w.abs() < NO_WEIGHT).for_each(|w| *w = 0.0);
        let largest = weights.iter_mut().max_by(|a, b| a.total_cmp(b))?;
        *largest += dropped;
        Some((weights, point(&nodes[..element.shape.nodes()], &weights)))
    }

    /// Places in `elements` of those whose boxes the line runs through.
    fn along(&self, line: &Line) -> Vec<u32> {
        let to = line.at(line.length);
        let low = [0, 1, 2].map(|i| line.from[i].min(to[i]));
        let high = [0, 1, 2].map(|i| line.from[i].max(to[i]));
        let mut near: Vec<u32> = self
            .bins_between(&low, &high)
            .flat_map(|bin| &self.entries[self.starts[bin] as usize..self.starts[bin + 1] as usize])
            .copied()
            .filter(|&place| self.box_meets(place, line))
            .collect();
        near.sort_unstable();
        near.dedup();
        near
    }

    /// Whether a line runs through the box of an element, or by its surface.
    fn box_meets(&self, place: u32, line: &Line) -> bool {
        let [low, high] = &self.boxes[place as usize];
        let slack = BESIDE * (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max);
        let (mut enter, mut leave) = (0.0f64, line.length);
        for i in 0..3 {
            let (from, way) = (line.from[i], line.along[i]);
            let bounds = [low[i] - slack - from, high[i] + slack - from];
            if way == 0.0 {
                if bounds[0] > 0.0 || bounds[1] < 0.0 {
                    return false;
                }
                continue;
            }
            let [a, b] = bounds.map(|x| x / way);
            enter = enter.max(a.min(b));
            leave = leave.min(a.max(b));
        }
        enter <= leave + slack
    }
}
