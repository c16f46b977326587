//! The faces across which the weight changes, as triangles in buckets over x and y.

use super::lattice::{Lattice, Place, doubled_area};
use crate::{Face, Mesh};

/// One triangle that is not vertical.
struct Triangle {
    /// Nodes in the order of their places, whichever element it is from.
    nodes: [u32; 3],
    /// The element's unit weight \[N/m³\]; negative if the element lies above.
    weight: f64,
}

/// Triangles, not yet in buckets.
pub(super) struct Surface<'a> {
    mesh: &'a Mesh,
    lattice: &'a Lattice,
    triangles: Vec<Triangle>,
}

impl<'a> Surface<'a> {
    pub fn new(mesh: &'a Mesh, lattice: &'a Lattice) -> Self {
        Surface { mesh, lattice, triangles: Vec::new() }
    }

    /// Adds an element's face.
    pub fn add(&mut self, face: Face, weight: f64) {
        let place = |n: u32| self.mesh.nodes[n as usize];
        let before = |a: u32, b: u32| place(a).partial_cmp(&place(b)).is_some_and(|order| order.is_lt());
        let nodes: Vec<u32> = self.mesh.face_nodes(face).collect();
        let lowest = (1..nodes.len()).fold(0, |low, k| if before(nodes[k], nodes[low]) { k } else { low });
        for k in 1..nodes.len() - 1 {
            let mut nodes = [0, k, k + 1].map(|step| nodes[(lowest + step) % nodes.len()]);
            let [a, b, c] = nodes.map(|n| self.lattice.places[n as usize]);
            let area = doubled_area(a, b, c);
            if area == 0 {
                continue;
            }
            nodes.sort_unstable_by(|a, b| {
                place(*a).partial_cmp(&place(*b)).unwrap_or(std::cmp::Ordering::Equal)
            });
            self.triangles.push(Triangle { nodes, weight: if area > 0 { weight } else { -weight } });
        }
    }

    /// Sorts the triangles into buckets.
    pub fn sorted(self) -> Grid<'a> {
        let count = self.triangles.len().max(1) as f64;
        // Of the root mean square of the triangles' sides: so each is in a few buckets on average, however they are graded.
        let mut size = [0, 1].map(|i| {
            let side = |t| {
                let [low, high] = self.extent(t);
                (high[i] - low[i]) as f64
            };
            (self.triangles.iter().map(|t| side(t).powi(2)).sum::<f64>() / count).sqrt().max(1.0)
        });
        let buckets = |size: [f64; 2]| [0, 1].map(|i| (self.lattice.high[i] as f64 / size[i]).floor() + 1.0);
        // Few and small ones in a wide mesh would leave most buckets empty.
        while buckets(size).iter().product::<f64>() > 4.0 * count {
            size = size.map(|s| 2.0 * s);
        }
        let counts = buckets(size).map(|n| n as usize);
        let mut grid = Grid { surface: self, size, counts, starts: Vec::new(), members: Vec::new() };
        grid.fill();
        grid
    }

    /// Lowest and highest place of a triangle.
    fn extent(&self, triangle: &Triangle) -> [Place; 2] {
        let places = self.places(triangle);
        let of =
            |pick: fn(i64, i64) -> i64| [0, 1].map(|i| pick(places[0][i], pick(places[1][i], places[2][i])));
        [of(i64::min), of(i64::max)]
    }

    fn places(&self, triangle: &Triangle) -> [Place; 3] {
        triangle.nodes.map(|n| self.lattice.places[n as usize])
    }

    /// Height \[m\] at which a vertical passes through a triangle.
    fn height(&self, triangle: &Triangle, x: [f64; 3]) -> f64 {
        let [a, b, c] = triangle.nodes.map(|n| self.mesh.nodes[n as usize]);
        let from_a = |p: [f64; 3]| [p[0] - a[0], p[1] - a[1]];
        let cross = |p: [f64; 2], q: [f64; 2]| p[0] * q[1] - p[1] * q[0];
        let (b2, c2, x2) = (from_a(b), from_a(c), from_a(x));
        let area = cross(b2, c2);
        // Round-off must not lead out of a triangle that is nearly vertical; NaN is of one without an area.
        let share = |part: f64| if part > 0.0 { part.min(1.0) } else { 0.0 };
        let s = share(cross(x2, c2) / area);
        let t = share(cross(b2, x2) / area).min(1.0 - s);
        a[2] + s * (b[2] - a[2]) + t * (c[2] - a[2])
    }
}

/// Triangles in buckets.
pub(super) struct Grid<'a> {
    surface: Surface<'a>,
    /// Of a bucket, in steps of the lattice.
    size: [f64; 2],
    counts: [usize; 2],
    /// For each bucket where its triangles begin in `members`; the last entry is the end.
    starts: Vec<u32>,
    members: Vec<u32>,
}

impl Grid<'_> {
    fn bucket(&self, place: Place) -> [usize; 2] {
        [0, 1].map(|i| ((place[i] as f64 / self.size[i]) as usize).min(self.counts[i] - 1))
    }

    /// The buckets that a triangle may touch.
    fn touched(&self, triangle: &Triangle) -> impl Iterator<Item = usize> + use<> {
        let [low, high] = self.surface.extent(triangle).map(|p| self.bucket(p));
        let row = self.counts[0];
        (low[1]..=high[1]).flat_map(move |j| (low[0]..=high[0]).map(move |i| j * row + i))
    }

    fn fill(&mut self) {
        let mut starts = vec![0u32; self.counts[0] * self.counts[1] + 1];
        for triangle in &self.surface.triangles {
            self.touched(triangle).for_each(|bucket| starts[bucket + 1] += 1);
        }
        for bucket in 1..starts.len() {
            starts[bucket] += starts[bucket - 1];
        }
        let mut next = starts.clone();
        let mut members = vec![0u32; starts[starts.len() - 1] as usize];
        for (number, triangle) in (0..).zip(&self.surface.triangles) {
            for bucket in self.touched(triangle) {
                members[next[bucket] as usize] = number;
                next[bucket] += 1;
            }
        }
        (self.starts, self.members) = (starts, members);
    }

    /// Pressure \[Pa\] at a point of what lies above it.
    pub fn weight_above(&self, x: [f64; 3]) -> f64 {
        if x.iter().any(|v| v.is_nan()) {
            return f64::NAN;
        }
        let Some(vertical) = self.surface.lattice.vertical(x) else { return 0.0 };
        let [i, j] = self.bucket(vertical.at);
        let bucket = j * self.counts[0] + i;
        let members = &self.members[self.starts[bucket] as usize..self.starts[bucket + 1] as usize];
        let mut crossed: Vec<(f64, f64)> = members
            .iter()
            .map(|&number| &self.surface.triangles[number as usize])
            .filter(|triangle| vertical.passes(self.surface.places(triangle)))
            .map(|triangle| (self.surface.height(triangle, x), triangle.weight))
            .filter(|(height, _)| *height > x[2])
            .collect();
        // One order, whatever that of the elements.
        crossed.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
        crossed.iter().fold(0.0, |sum, (height, weight)| sum + weight * (height - x[2]))
    }
}
