//! A mesh seen from above, on a lattice so fine that it changes nothing, where all questions have exact answers.

use crate::Mesh;

/// Steps of the lattice along the longer side: 10⁻¹² of it each.
const STEPS: f64 = (1u64 << 40) as f64;

/// A place on the lattice.
pub(super) type Place = [i64; 2];

/// The lattice over a mesh, in x and y.
pub(super) struct Lattice {
    low: [f64; 2],
    /// Length of a step \[m\].
    step: f64,
    /// Of the mesh's far corner.
    pub high: Place,
    /// By node.
    pub places: Vec<Place>,
}

impl Lattice {
    pub fn new(mesh: &Mesh) -> Self {
        let (low, high) = mesh.bounds();
        let step = (high[0] - low[0]).max(high[1] - low[1]) / STEPS;
        let mut lattice = Lattice { low: [low[0], low[1]], step, high: [0; 2], places: Vec::new() };
        lattice.high = lattice.place(high);
        lattice.places = mesh.nodes.iter().map(|x| lattice.place(*x)).collect();
        lattice
    }

    /// The nearest place of the lattice, at most one step beyond it; what is not a number has the first.
    fn place(&self, x: [f64; 3]) -> Place {
        [0, 1].map(|i| ((x[i] - self.low[i]) / self.step).round().clamp(-1.0, STEPS + 1.0) as i64)
    }

    /// The vertical through a point, if it meets the mesh's extent.
    pub fn vertical(&self, x: [f64; 3]) -> Option<Vertical> {
        let at = self.place(x);
        let inside = (0..2).all(|i| (0..=self.high[i]).contains(&at[i]));
        let towards = [0, 1].map(|i| if 2 * at[i] <= self.high[i] { 1 } else { -1 });
        (inside && x.iter().all(|v| v.is_finite())).then_some(Vertical { at, towards })
    }
}

/// A vertical, less than any length away from its place along x, and less than that along y, so that it never meets an
/// edge.
pub(super) struct Vertical {
    pub at: Place,
    /// 1 or −1 along x and y.
    towards: [i64; 2],
}

impl Vertical {
    /// Whether it lies on the left of the way from `a` to `b`, which are apart.
    fn is_left(&self, a: Place, b: Place) -> bool {
        let way = [b[0] - a[0], b[1] - a[1]];
        let area = doubled_area(a, b, self.at);
        let nudged = [-way[1] * self.towards[0], way[0] * self.towards[1]];
        if area != 0 { area > 0 } else { nudged[0] > 0 || nudged[0] == 0 && nudged[1] > 0 }
    }

    /// Whether it passes through a triangle that has an area.
    pub fn passes(&self, [a, b, c]: [Place; 3]) -> bool {
        let left = self.is_left(a, b);
        left == self.is_left(b, c) && left == self.is_left(c, a)
    }
}

/// Twice the area of a triangle, positive counter-clockwise, in squares of the lattice; beyond the range of i64.
pub(super) fn doubled_area(a: Place, b: Place, c: Place) -> i128 {
    let from_a = |p: Place| [0, 1].map(|i| i128::from(p[i] - a[i]));
    let ([bx, by], [cx, cy]) = (from_a(b), from_a(c));
    bx * cy - by * cx
}
