//! The sides of a wedge between its triangles: their twist, and which may be linked.

/// Corners of the sides: two of the first triangle, and the two across.
pub(super) const SIDES: [[usize; 4]; 3] = [[0, 1, 4, 5], [1, 2, 5, 6], [2, 0, 6, 4]];

/// Sine of the twist of a side, between the edges at its ends as seen along it, up to which it is flat: the round-off of mesh files.
const FLAT: f64 = 1e-4;
/// Sine of the twist, up to which sides are linked between wedges whose edges lead along the normal: an assumption, 12°, where
/// curved linings of hexahedra lock as well.
pub const TWIST: f64 = 0.2;
/// Sine of the angle between the normal of a wedge and the mean of its edges, up to which these lead along it: 5°, an assumption.
const LEAN: f64 = 0.087;

pub(super) type Vector = [f64; 3];

pub(super) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(super) fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// a + k b.
pub(super) fn plus(a: Vector, k: f64, b: Vector) -> Vector {
    [a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]]
}

/// Natural derivatives of the place at the middle of a side: along its edge s, along ζ, along both; and how the last is made of the
/// first two, α and β, with what is left of it.
pub(super) struct Side {
    pub along: Vector,
    pub through: Vector,
    pub parts: [f64; 2],
    pub left: Vector,
}

impl Side {
    pub fn of(corners: &[Vector; 8], side: [usize; 4]) -> Side {
        let [a, b, c, d] = side.map(|k| corners[k]);
        let sum = |s: [f64; 4]| {
            [0, 1, 2].map(|i| 0.25 * ((s[0] * a[i] + s[1] * b[i]) + (s[2] * c[i] + s[3] * d[i])))
        };
        let along = sum([-1.0, 1.0, -1.0, 1.0]);
        let through = sum([-1.0, -1.0, 1.0, 1.0]);
        let both = sum([1.0, -1.0, -1.0, 1.0]);
        let (aa, at, tt) = (dot(along, along), dot(along, through), dot(through, through));
        let (ab, tb) = (dot(along, both), dot(through, both));
        let det = aa * tt - at * at;
        let parts = [(tt * ab - at * tb) / det, (aa * tb - at * ab) / det];
        let left = plus(plus(both, -parts[0], along), -parts[1], through);
        Side { along, through, parts, left }
    }

    /// Sine of half the angle between the edges at its ends, as seen along it, twice.
    fn twist(&self) -> f64 {
        2.0 * length(self.left) / length(self.through)
    }
}

/// Which sides of a hexahedron with these corners may be linked, if it is a wedge: those that are flat, or little twisted in a wedge whose edges
/// lead along its normal.
pub(super) fn linkable(corners: &[Vector; 8]) -> Option<[bool; 3]> {
    let same = |a: usize, b: usize| corners[a] == corners[b];
    let other = [0, 1, 2, 4, 5, 6];
    let apart = other.iter().all(|&a| other.iter().all(|&b| a == b || !same(a, b)));
    if !(same(2, 3) && same(6, 7) && apart) {
        return None;
    }
    let sides = SIDES.map(|side| Side::of(corners, side));
    let normal = cross(sides[0].along, sides[1].along);
    let edge = sides.iter().fold([0.0; 3], |sum, side| plus(sum, 1.0, side.through));
    let leans = length(cross(normal, edge)) > LEAN * length(normal) * length(edge);
    let limit = if leans { FLAT } else { TWIST };
    Some(sides.map(|side| side.twist() <= limit))
}
