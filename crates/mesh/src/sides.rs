//! The outer sides of a mesh in plan: whether they are two pairs of parallel vertical planes, and which way these stand.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use crate::Mesh;
use crate::topology::{exterior_faces, vector_areas};

/// Sides that are two pairs of parallel vertical planes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sides {
    /// About z from the x and y axes, counter-clockwise seen from above \[rad\], above −π/4 and at most π/4: a rectangle
    /// comes back to itself after a right angle.
    pub angle: f64,
    /// Of the planes that are nearest to normal to x, and to y: how far nodes of the sides' faces lie off them, at most, over
    /// the distance between the two planes.
    pub off: [f64; 2],
    /// The same off planes normal to x and to y that bound the mesh.
    pub off_axes: [f64; 2],
}

impl Sides {
    /// Whether turning by the angle would bring the sides onto planes normal to x and y that they are off by more than a
    /// tolerance, or much nearer to them; `axes` says which planes matter.
    pub fn turned(&self, axes: [bool; 2], tolerance: f64) -> bool {
        let most = |off: [f64; 2]| (0..2).filter(|&i| axes[i]).map(|i| off[i]).fold(0.0, f64::max);
        let (off, off_axes) = (most(self.off), most(self.off_axes));
        off_axes > tolerance && (off <= tolerance || off_axes > 2.0 * off)
    }
}

/// Why the sides are not two pairs of parallel vertical planes: in plan one edge of the smallest rectangle around the mesh
/// has vertical faces along a part of it only.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error(
    "the outer sides are not two pairs of parallel vertical planes: seen from above, the edge from ({:.6}, {:.6}) m to \
     ({:.6}, {:.6}) m of the smallest rectangle around the mesh has vertical faces along {:.0} % of it", from[0], from[1], to[0],
     to[1], 100.0 * covered
)]
pub struct NoRectangle {
    /// Ends of the edge \[m\].
    pub from: [f64; 2],
    pub to: [f64; 2],
    /// Share of its length with faces.
    pub covered: f64,
}

/// A point, or a way, in plan.
type Place = [f64; 2];

/// Farther from a plane, over the size of the mesh, a face belongs to another side. Coarse on purpose: sides that waver by
/// less are told by how far they are off.
const BESIDE: f64 = 1e-3;
/// Least cosine between a face's normal and its side's.
const ALIKE: f64 = 0.9;
/// Share of an edge that must have faces; what is left allows for round-off.
const COVERED: f64 = 0.999;

/// The outer sides of a mesh.
///
/// The angle is the mean of the directions of exterior faces on the outline, weighted by their areas, so that round-off of
/// single nodes does not turn it. Openings that reach a side, and a ground that is not level, change nothing.
///
/// # Errors
/// If the sides are not two pairs of parallel vertical planes.
pub fn sides(mesh: &Mesh) -> Result<Sides, NoRectangle> {
    let outline = convex(mesh.nodes.iter().map(|&[x, y, _]| [x, y]).collect());
    let faces = upright_faces(mesh);
    let rough = Rectangle::smallest(&outline);
    // Directions that differ by right angles are the same: their fourth powers, as complex numbers, are.
    let mut sum = [0.0; 2];
    for face in faces.iter().filter(|face| rough.side_of(face).is_some()) {
        let fourth = squared(squared(face.area));
        (0..2).for_each(|i| sum[i] += fourth[i] / length(face.area).powi(3));
    }
    let angle = within_a_right_angle(if sum == [0.0; 2] { rough.angle } else { 0.25 * sum[1].atan2(sum[0]) });
    let (turned, straight) = (Rectangle::around(&outline, angle), Rectangle::around(&outline, 0.0));
    let mut covers: [Vec<[f64; 2]>; 4] = Default::default();
    let (mut off, mut off_axes) = ([0.0_f64; 2], [0.0_f64; 2]);
    for face in &faces {
        let Some(side) = turned.side_of(face) else { continue };
        let (axis, along) = (side / 2, 1 - side / 2);
        let places = face.corners.iter().map(|&p| turned.local(p)[along]);
        covers[side].push(places.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], s| [a.min(s), b.max(s)]));
        off[axis] = off[axis].max(turned.distance(face, side) / turned.width(axis));
        off_axes[axis] = off_axes[axis].max(straight.distance(face, side) / straight.width(axis));
    }
    let edges = covers.into_iter().enumerate().map(|(side, cover)| {
        let [from, to] = turned.edge(side);
        NoRectangle { from, to, covered: union(cover) / turned.width(1 - side / 2) }
    });
    // It is not a number where the mesh has no extent.
    let bare = edges.filter(|edge| edge.covered.is_nan() || edge.covered < COVERED);
    match bare.min_by(|a, b| a.covered.total_cmp(&b.covered)) {
        Some(edge) => Err(edge),
        None => Ok(Sides { angle, off, off_axes }),
    }
}

/// An exterior face that stands upright, seen from above.
struct Upright {
    corners: Vec<Place>,
    /// Outward \[m²\].
    area: [f64; 2],
}

fn upright_faces(mesh: &Mesh) -> Vec<Upright> {
    let upright = |face| {
        let areas = vector_areas(mesh, &[face]);
        let total = areas.values().fold([0.0; 3], |s, a| [s[0] + a[0], s[1] + a[1], s[2] + a[2]]);
        let area = [total[0], total[1]];
        let plan = |n: u32| [mesh.nodes[n as usize][0], mesh.nodes[n as usize][1]];
        let corners = mesh.face_nodes(face).map(plan).collect();
        (ALIKE * total[2].hypot(length(area)) < length(area)).then_some(Upright { corners, area })
    };
    exterior_faces(mesh, None).into_iter().filter_map(upright).collect()
}

/// A rectangle in plan. Its sides are numbered low and high along its first axis, then along its second.
struct Rectangle {
    /// Of its first axis from x.
    angle: f64,
    axes: [[f64; 2]; 2],
    low: [f64; 2],
    high: [f64; 2],
}

impl Rectangle {
    /// The rectangle with this angle around some points.
    fn around(points: &[Place], angle: f64) -> Self {
        let (sine, cosine) = angle.sin_cos();
        let axes = [[cosine, sine], [-sine, cosine]];
        let mut rectangle = Rectangle { angle, axes, low: [f64::INFINITY; 2], high: [f64::NEG_INFINITY; 2] };
        for p in points {
            let local = rectangle.local(*p);
            for i in 0..2 {
                rectangle.low[i] = rectangle.low[i].min(local[i]);
                rectangle.high[i] = rectangle.high[i].max(local[i]);
            }
        }
        rectangle
    }

    /// The one of least area around a convex outline; it has an edge along one of the outline's.
    fn smallest(outline: &[Place]) -> Self {
        let next = outline.iter().cycle().skip(1);
        let along = |(a, b): (&Place, &Place)| within_a_right_angle((b[1] - a[1]).atan2(b[0] - a[0]));
        outline
            .iter()
            .zip(next)
            .map(|edge| Rectangle::around(outline, along(edge)))
            .min_by(|a, b| (a.width(0) * a.width(1)).total_cmp(&(b.width(0) * b.width(1))))
            .unwrap_or_else(|| Rectangle::around(outline, 0.0))
    }

    fn local(&self, p: Place) -> [f64; 2] {
        self.axes.map(|axis| dot(axis, p))
    }

    fn width(&self, axis: usize) -> f64 {
        self.high[axis] - self.low[axis]
    }

    /// How far the farthest corner of a face lies off a side \[m\].
    fn distance(&self, face: &Upright, side: usize) -> f64 {
        let level = if side.is_multiple_of(2) { self.low[side / 2] } else { self.high[side / 2] };
        let off = |&p: &Place| (self.local(p)[side / 2] - level).abs();
        face.corners.iter().map(off).fold(0.0, f64::max)
    }

    fn side_of(&self, face: &Upright) -> Option<usize> {
        let size = self.width(0).hypot(self.width(1));
        (0..4).find(|&side: &usize| {
            let outward = if side.is_multiple_of(2) { -1.0 } else { 1.0 };
            let alike = outward * dot(self.axes[side / 2], face.area) >= ALIKE * length(face.area);
            alike && self.distance(face, side) <= BESIDE * size
        })
    }

    /// The ends of a side.
    fn edge(&self, side: usize) -> [Place; 2] {
        let (axis, along) = (side / 2, 1 - side / 2);
        [self.low[along], self.high[along]].map(|s| {
            let mut local = [0.0; 2];
            local[axis] = if side.is_multiple_of(2) { self.low[axis] } else { self.high[axis] };
            local[along] = s;
            [0, 1].map(|i| local[0] * self.axes[0][i] + local[1] * self.axes[1][i])
        })
    }
}

/// The convex outline of some points, counter-clockwise (Andrew's chains).
fn convex(mut points: Vec<Place>) -> Vec<Place> {
    points.sort_unstable_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    points.dedup();
    let chain = |points: &mut dyn Iterator<Item = &Place>| {
        let mut chain: Vec<Place> = Vec::new();
        for &p in points {
            while let [.., a, b] = chain[..]
                && (b[0] - a[0]) * (p[1] - a[1]) <= (b[1] - a[1]) * (p[0] - a[0])
            {
                chain.pop();
            }
            chain.push(p);
        }
        // The last is the first of the other chain.
        chain.pop();
        chain
    };
    [chain(&mut points.iter()), chain(&mut points.iter().rev())].concat()
}

/// The same direction of a rectangle, above −π/4 and at most π/4; what is π/4 but for round-off is positive.
fn within_a_right_angle(angle: f64) -> f64 {
    let turned = angle - FRAC_PI_2 * (angle / FRAC_PI_2).round();
    if turned < 1e-12 - FRAC_PI_4 { turned + FRAC_PI_2 } else { turned }
}

/// The length that intervals cover together.
fn union(mut intervals: Vec<[f64; 2]>) -> f64 {
    intervals.sort_unstable_by(|a, b| a[0].total_cmp(&b[0]));
    let mut end = f64::NEG_INFINITY;
    let mut sum = 0.0;
    for [from, to] in intervals {
        sum += (to - from.max(end)).max(0.0);
        end = end.max(to);
    }
    sum
}

/// A complex number times itself.
fn squared([x, y]: [f64; 2]) -> [f64; 2] {
    [x * x - y * y, 2.0 * x * y]
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn length(a: [f64; 2]) -> f64 {
    a[0].hypot(a[1])
}

#[cfg(test)]
mod tests;
