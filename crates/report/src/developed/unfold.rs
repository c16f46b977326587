//! Surfaces of flat faces laid out in a plane without stretching, as a paper model opened along some of its edges.
//!
//! A lining's surface opens along its floor: faces are laid down in the order of their distance from the crown around the
//! section, each turned about the edge that it shares with one that lies already. So every edge keeps its length, and
//! what cannot be developed tears. Faces across the axis, end walls, hang on their highest edge. What would come to lie
//! on something else is moved apart.

mod edges;
mod folds;
mod grow;
mod overlap;
#[cfg(test)]
mod tests;

use folds::Folds;

/// One connected part of a surface, developed. Lengths in m; u runs along the axis, v across it.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// Unit vector along u: the common direction of the folds, or the strike where there are none.
    pub axis: [f64; 3],
    /// Whether it goes round more than a corner, as a lining does; v is then 0 at the crown.
    pub wraps: bool,
    pub faces: Vec<Flat>,
    /// Edges with nothing beside them: those of the surface, and where it was opened; tears that double curvature leaves are
    /// not among them.
    pub outline: Vec<[[f64; 2]; 2]>,
    /// Edges at which it was folded by more than 25°.
    pub creases: Vec<[[f64; 2]; 2]>,
    /// Number of parts that lie apart from one another.
    pub pieces: usize,
}

/// A face laid flat. Seen so that its normal points at the reader.
#[derive(Clone, Debug)]
pub struct Flat {
    /// Which of the faces given.
    pub face: usize,
    /// Its points, and where they lie.
    pub points: Vec<u32>,
    pub corners: Vec<[f64; 2]>,
    pub normal: [f64; 3],
    /// Whether it lies across the axis.
    pub end: bool,
    pub piece: usize,
}

/// Develops a surface: points with their normals, and faces with three or four points each, one sheet for each part
/// that hangs together. Points at one place count as one, so that faces hang together across sharp edges too, where
/// each side has its own. Faces without area are left out.
///
/// # Panics
/// If a face names a point that is not there, or there are fewer normals than points.
pub fn unfold(points: &[[f64; 3]], normals: &[[f64; 3]], faces: &[Vec<u32>]) -> Vec<Sheet> {
    let folds = Folds::of(points, normals, faces);
    folds.components().iter().map(|own| grow::sheet(&folds, own)).collect()
}

/// Where the corners of a face lie.
type Corners = Vec<[f64; 2]>;

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn less(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

/// Its direction; none of a vector without length.
fn unit(a: [f64; 3]) -> Option<[f64; 3]> {
    let size = length(a);
    (size > 0.0 && size.is_finite()).then(|| a.map(|c| c / size))
}
