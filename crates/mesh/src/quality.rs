//! Size and shape of elements: volume, scaled Jacobian, edges.

use std::collections::BTreeMap;

use crate::mesh::{Mesh, Shape};

/// Measures of one element. Lengths in metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quality {
    /// Volume \[m³\], negative if the element is inside out. Exact for the isoparametric element.
    pub volume: f64,
    /// Smallest over the corners of det J with unit edges, scaled so that the regular shape has 1.
    pub scaled_jacobian: f64,
    pub shortest_edge: f64,
    pub longest_edge: f64,
}

impl Quality {
    /// Longest edge over shortest.
    pub fn aspect(&self) -> f64 {
        self.longest_edge / self.shortest_edge
    }

    /// Size \[m\]: the cube root of the volume.
    pub fn size(&self) -> f64 {
        self.volume.abs().cbrt()
    }
}

/// Measures of a set of elements. Of an empty set the volume is 0, minima are +∞ and maxima −∞.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Summary {
    pub elements: usize,
    /// \[m³\]
    pub volume: f64,
    pub min_scaled_jacobian: f64,
    /// The element (index) with the smallest scaled Jacobian.
    pub worst: Option<u32>,
    /// \[m\]
    pub shortest_edge: f64,
    /// \[m\]
    pub longest_edge: f64,
    pub max_aspect: f64,
}

/// For each corner, the corners at the ends of its three edges, right-handed.
const fn corners(shape: Shape) -> &'static [[usize; 4]] {
    match shape {
        Shape::Hex8 => &[
            [0, 1, 3, 4],
            [1, 2, 0, 5],
            [2, 3, 1, 6],
            [3, 0, 2, 7],
            [4, 7, 5, 0],
            [5, 4, 6, 1],
            [6, 5, 7, 2],
            [7, 6, 4, 3],
        ],
        Shape::Wedge6 => {
            &[[0, 1, 2, 3], [1, 2, 0, 4], [2, 0, 1, 5], [3, 5, 4, 0], [4, 3, 5, 1], [5, 4, 3, 2]]
        }
        // The four of the base: at the apex, where four edges meet, the map is singular.
        Shape::Pyramid5 => &[[0, 1, 3, 4], [1, 2, 0, 4], [2, 3, 1, 4], [3, 0, 2, 4]],
        Shape::Tet4 => &[[0, 1, 2, 3], [1, 2, 0, 3], [2, 0, 1, 3], [3, 0, 2, 1]],
    }
}

/// One over det J with unit edges of the regular shape.
const fn scale(shape: Shape) -> f64 {
    match shape {
        Shape::Hex8 => 1.0,
        // 2/√3: all edges equal, sin 60° between two of them
        Shape::Wedge6 => 1.154_700_538_379_251_5,
        Shape::Pyramid5 | Shape::Tet4 => std::f64::consts::SQRT_2,
    }
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn triple(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> f64 {
    a[0] * (b[1] * c[2] - b[2] * c[1])
        + a[1] * (b[2] * c[0] - b[0] * c[2])
        + a[2] * (b[0] * c[1] - b[1] * c[0])
}

fn length(a: [f64; 3]) -> f64 {
    (a[0] * a[0] + a[1] * a[1] + a[2] * a[2]).sqrt()
}

/// Volume \[m³\] of an element with corners `x` (as many as the shape has), exact for bilinear faces.
///
/// By the divergence theorem; the flux of the position through a bilinear face is the mean of those through
/// its two foldings along a diagonal.
pub fn volume(shape: Shape, x: &[[f64; 3]]) -> f64 {
    let sixfold: f64 = shape
        .faces()
        .iter()
        .map(|face| {
            // From corner 0, so that far coordinates do not cancel.
            let p = |k: usize| minus(x[face[k]], x[0]);
            match face.len() {
                3 => triple(p(0), p(1), p(2)),
                _ => {
                    let fold = triple(p(0), p(1), p(2)) + triple(p(0), p(2), p(3));
                    let other = triple(p(1), p(2), p(3)) + triple(p(1), p(3), p(0));
                    0.5 * (fold + other)
                }
            }
        })
        .sum();
    sixfold / 6.0
}

/// Smallest over the corners of det J with unit edges, scaled so that the regular shape has 1; of a pyramid
/// the corners of the base. Not a number if an edge has no length.
pub fn scaled_jacobian(shape: Shape, x: &[[f64; 3]]) -> f64 {
    let mut smallest = f64::INFINITY;
    for &[at, a, b, c] in corners(shape) {
        let (a, b, c) = (minus(x[a], x[at]), minus(x[b], x[at]), minus(x[c], x[at]));
        let corner = triple(a, b, c) / (length(a) * length(b) * length(c));
        if corner.is_nan() {
            return f64::NAN;
        }
        smallest = smallest.min(corner);
    }
    scale(shape) * smallest
}

/// All measures of element `e` of a mesh.
///
/// # Panics
/// If there is no such element.
pub fn of(mesh: &Mesh, e: usize) -> Quality {
    let element = &mesh.elements[e];
    let mut corner = [[0.0; 3]; 8];
    for (x, &n) in corner.iter_mut().zip(element.nodes()) {
        *x = mesh.nodes[n as usize];
    }
    let x = &corner[..element.shape.nodes()];
    let (mut shortest_edge, mut longest_edge) = (f64::INFINITY, 0.0f64);
    for face in element.shape.faces() {
        for k in 0..face.len() {
            let edge = length(minus(x[face[(k + 1) % face.len()]], x[face[k]]));
            shortest_edge = shortest_edge.min(edge);
            longest_edge = longest_edge.max(edge);
        }
    }
    Quality {
        volume: volume(element.shape, x),
        scaled_jacobian: scaled_jacobian(element.shape, x),
        shortest_edge,
        longest_edge,
    }
}

/// Summary over some elements of a mesh.
///
/// # Panics
/// If an element is not in the mesh.
pub fn summary_of(mesh: &Mesh, elements: impl IntoIterator<Item = u32>) -> Summary {
    let mut all = Summary {
        elements: 0,
        volume: 0.0,
        min_scaled_jacobian: f64::INFINITY,
        worst: None,
        shortest_edge: f64::INFINITY,
        longest_edge: f64::NEG_INFINITY,
        max_aspect: f64::NEG_INFINITY,
    };
    for e in elements {
        let one = of(mesh, e as usize);
        all.elements += 1;
        all.volume += one.volume;
        // An element without shape is worse than any other.
        let jacobian = if one.scaled_jacobian.is_nan() { -1.0 } else { one.scaled_jacobian };
        if jacobian < all.min_scaled_jacobian {
            all.min_scaled_jacobian = jacobian;
            all.worst = Some(e);
        }
        all.shortest_edge = all.shortest_edge.min(one.shortest_edge);
        all.longest_edge = all.longest_edge.max(one.longest_edge);
        all.max_aspect = all.max_aspect.max(one.aspect());
    }
    all
}

/// Summary over the whole mesh.
pub fn summary(mesh: &Mesh) -> Summary {
    summary_of(mesh, 0..mesh.elements.len() as u32)
}

/// Summary for each named group of elements.
pub fn by_group(mesh: &Mesh) -> BTreeMap<&str, Summary> {
    mesh.groups.iter().map(|(name, list)| (name.as_str(), summary_of(mesh, list.iter().copied()))).collect()
}

#[cfg(test)]
mod tests;
