//! A face that a stage lays bare, seen from the void.

use tremolite_mesh::{Face, Mesh};

pub type Vector = [f64; 3];

/// cos 45°: beyond it a face is a crown, a floor or an end wall.
const STEEP: f64 = std::f64::consts::FRAC_1_SQRT_2;
/// Round-off on which side a face at 45° falls must not hang.
const ROUND_OFF: f64 = 1e-9;

/// A bare face.
#[derive(Clone, Debug)]
pub struct Wall {
    /// Nodes, three or four, in order around it.
    pub nodes: Vec<u32>,
    /// Their places \[m\].
    pub corners: Vec<Vector>,
    /// Mean unit normal, into the rock.
    pub normal: Vector,
    /// m²
    pub area: f64,
}

/// Which way a face looks from the void.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Looks {
    Up,
    Sideways,
    Down,
}

impl Wall {
    /// The face of an element that stands. None without an area.
    pub fn new(mesh: &Mesh, face: Face) -> Option<Wall> {
        let mut nodes: Vec<u32> = mesh.face_nodes(face).collect();
        // The element's outward normal leads into the void.
        nodes.reverse();
        let corners: Vec<Vector> = nodes.iter().map(|&n| mesh.nodes[n as usize]).collect();
        let first = *corners.first()?;
        let mut sum = [0.0; 3];
        for pair in corners.windows(2) {
            let part = cross(minus(pair[0], first), minus(pair[1], first));
            (0..3).for_each(|i| sum[i] += 0.5 * part[i]);
        }
        let area = norm(sum);
        (area > 0.0).then(|| Wall { nodes, corners, normal: sum.map(|x| x / area), area })
    }

    pub fn looks(&self) -> Looks {
        match self.normal[2] {
            up if up > STEEP + ROUND_OFF => Looks::Up,
            up if up < -STEEP - ROUND_OFF => Looks::Down,
            _ => Looks::Sideways,
        }
    }

    /// Whether it ends a cavern along this axis, rather than running along it.
    pub fn ends(&self, axis: Vector) -> bool {
        dot(self.normal, axis).abs() > STEEP + ROUND_OFF
    }

    /// The point of the face, which may be warped, nearest to one that lies between points of its edges, seen along its normal.
    pub fn onto(&self, point: Vector) -> Vector {
        let &[a, b, c, d] = &self.corners[..] else { return point };
        let along = [minus(b, a), minus(d, a)];
        let twist = [0, 1, 2].map(|i| c[i] - b[i] - d[i] + a[i]);
        let [mut r, mut s] = [0.5; 2];
        // Newton's method for where the bilinear face meets the line along the normal; a few steps, as faces are nearly flat.
        for _ in 0..20 {
            let at = [0, 1, 2].map(|i| a[i] + r * along[0][i] + s * along[1][i] + r * s * twist[i]);
            let off = minus(point, at);
            let by_r = [0, 1, 2].map(|i| along[0][i] + s * twist[i]);
            let by_s = [0, 1, 2].map(|i| along[1][i] + r * twist[i]);
            // Of the three unknowns, r, s and the distance along the normal, the last is of no use.
            let volume = dot(cross(by_r, by_s), self.normal);
            if volume.abs() <= f64::MIN_POSITIVE {
                return point;
            }
            let dr = dot(cross(off, by_s), self.normal) / volume;
            let ds = dot(cross(by_r, off), self.normal) / volume;
            (r, s) = (r + dr, s + ds);
            if dr.abs().max(ds.abs()) < 1e-14 {
                break;
            }
        }
        let (r, s) = (r.clamp(0.0, 1.0), s.clamp(0.0, 1.0));
        [0, 1, 2].map(|i| a[i] + r * along[0][i] + s * along[1][i] + r * s * twist[i])
    }
}

pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn norm(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

pub fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// a + t (b − a)
pub fn between(a: Vector, b: Vector, t: f64) -> Vector {
    [0, 1, 2].map(|i| a[i] + t * (b[i] - a[i]))
}
