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
mod tests {
    use super::*;

    const CUBE: [[f64; 3]; 8] = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
        [1.0, 0.0, 1.0],
        [1.0, 1.0, 1.0],
        [0.0, 1.0, 1.0],
    ];

    /// Regular shapes with edges of length 1, and their volumes.
    fn regular() -> [(Shape, Vec<[f64; 3]>, f64); 4] {
        let (h, r) = (3f64.sqrt() / 2.0, 3f64.sqrt() / 6.0);
        let triangle = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.5, h, 0.0]];
        let mut wedge = triangle.to_vec();
        wedge.extend(triangle.map(|p| [p[0], p[1], 1.0]));
        let mut pyramid = CUBE[..4].to_vec();
        pyramid.push([0.5, 0.5, 0.5f64.sqrt()]);
        let mut tet = triangle.to_vec();
        tet.push([0.5, r, (2.0f64 / 3.0).sqrt()]);
        [
            (Shape::Hex8, CUBE.to_vec(), 1.0),
            (Shape::Wedge6, wedge, h / 2.0),
            (Shape::Pyramid5, pyramid, 0.5f64.sqrt() / 3.0),
            (Shape::Tet4, tet, 2f64.sqrt() / 12.0),
        ]
    }

    #[test]
    fn regular_shapes_have_scaled_jacobian_one_and_their_volume() {
        for (shape, x, exact) in regular() {
            assert!((scaled_jacobian(shape, &x) - 1.0).abs() < 1e-14, "{shape:?}");
            assert!((volume(shape, &x) - exact).abs() < 1e-15, "{shape:?} {}", volume(shape, &x));
        }
    }

    #[test]
    fn every_corner_counts() {
        // Pulling one corner of the cube along its diagonal flattens that corner alone at 1/3 of the way
        // from it: the corner then lies in the plane of its three neighbours.
        for moved in 0..8 {
            let mut x = CUBE;
            for c in &mut x[moved] {
                *c += (0.5 - *c) * (2.0 / 3.0);
            }
            assert!(scaled_jacobian(Shape::Hex8, &x).abs() < 1e-15, "corner {moved}");
        }
        for (shape, x, _) in regular() {
            let mirrored: Vec<[f64; 3]> = x.iter().map(|p| [p[0], p[1], -p[2]]).collect();
            assert!((scaled_jacobian(shape, &mirrored) + 1.0).abs() < 1e-14, "{shape:?}");
        }
    }

    #[test]
    fn hexahedron_volume_equals_its_gauss_integral() {
        let mut x = CUBE;
        for (n, p) in x.iter_mut().enumerate() {
            for (i, c) in p.iter_mut().enumerate() {
                *c += 1000.0 + 0.2 * ((7 * n + 3 * i) as f64).sin();
            }
        }
        // 2×2×2 points integrate det J of a trilinear map exactly (degree 2 in each coordinate).
        let mut exact = 0.0;
        for point in CUBE {
            let g = point.map(|c| (2.0 * c - 1.0) / 3f64.sqrt());
            let mut j = [[0.0; 3]; 3];
            for (corner, p) in CUBE.iter().zip(&x) {
                let s = corner.map(|c| 2.0 * c - 1.0);
                let f = [1.0 + s[0] * g[0], 1.0 + s[1] * g[1], 1.0 + s[2] * g[2]];
                let slope = [s[0] * f[1] * f[2], f[0] * s[1] * f[2], f[0] * f[1] * s[2]];
                for (row, d) in j.iter_mut().zip(slope) {
                    for (value, c) in row.iter_mut().zip(p) {
                        *value += d / 8.0 * (c - 1000.0);
                    }
                }
            }
            exact += triple(j[0], j[1], j[2]);
        }
        assert!((volume(Shape::Hex8, &x) - exact).abs() < 1e-11, "{} {exact}", volume(Shape::Hex8, &x));
    }

    #[test]
    fn a_brick_reports_its_edges_and_groups() {
        let spec = crate::boxes::BoxSpec::uniform([0.0; 3], [4.0, 1.0, 6.0], [2, 2, 3]);
        let mut mesh = spec.mesh().unwrap();
        mesh.groups.insert("low".into(), vec![0, 1, 2, 3]);
        let one = of(&mesh, 5);
        assert_eq!((one.shortest_edge, one.longest_edge, one.aspect()), (0.5, 2.0, 4.0));
        assert!((one.size() - 2f64.cbrt()).abs() < 1e-15);
        let low = by_group(&mesh)["low"];
        assert_eq!(low.elements, 4);
        assert!((low.volume - 8.0).abs() < 1e-13 && (summary(&mesh).volume - 24.0).abs() < 1e-13);
    }

    #[test]
    fn a_collapsed_element_is_the_worst() {
        let mut mesh = crate::boxes::BoxSpec::uniform([0.0; 3], [2.0, 1.0, 1.0], [2, 1, 1]).mesh().unwrap();
        let far = mesh.elements[1].nodes[1] as usize;
        mesh.nodes[far] = mesh.nodes[mesh.elements[1].nodes[0] as usize];
        assert_eq!(summary(&mesh).worst, Some(1));
    }
}
