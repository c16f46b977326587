//! What touches what: outer faces, separate parts, nodes of opposite sides, areas of nodes.

mod opposite;

use std::collections::BTreeMap;

pub use opposite::{Unmatched, match_faces};

use crate::{Face, Mesh};
use rayon::slice::ParallelSliceMut;

/// The nodes of a face in ascending order; a triangle's fourth is `u32::MAX`. Equal for the two faces
/// where elements meet.
pub fn face_key(mesh: &Mesh, face: Face) -> [u32; 4] {
    let mut key = [u32::MAX; 4];
    for (place, node) in key.iter_mut().zip(mesh.face_nodes(face)) {
        *place = node;
    }
    key.sort_unstable();
    key
}

/// All faces of the given elements (indices into [`Mesh::elements`]), or of all.
pub fn all_faces<'a>(mesh: &'a Mesh, elements: Option<&'a [u32]>) -> impl Iterator<Item = Face> + use<'a> {
    let count = elements.map_or(mesh.elements.len(), <[u32]>::len);
    (0..count).flat_map(move |i| {
        let element = elements.map_or(i as u32, |e| e[i]);
        let sides = mesh.elements[element as usize].shape.faces().len() as u8;
        (0..sides).map(move |side| Face { element, side })
    })
}

/// Faces of the given elements (or of all) that no other of these elements shares, ascending.
///
/// For a subset these include its faces against the rest of the mesh. Where meshes meet without
/// sharing nodes (hanging nodes, a split interface) both sides are exterior.
///
/// # Panics
/// If an element is not in the mesh.
pub fn exterior_faces(mesh: &Mesh, elements: Option<&[u32]>) -> Vec<Face> {
    unshared(mesh, all_faces(mesh, elements))
}

/// Those of some faces that no other of them has the nodes of, ascending.
pub fn unshared(mesh: &Mesh, faces: impl Iterator<Item = Face>) -> Vec<Face> {
    let mut keyed: Vec<([u32; 4], Face)> = faces.map(|face| (face_key(mesh, face), face)).collect();
    keyed.par_sort_unstable();
    let mut faces: Vec<Face> =
        keyed.chunk_by(|a, b| a.0 == b.0).filter(|same| same.len() == 1).map(|same| same[0].1).collect();
    faces.sort_unstable();
    faces
}

/// Faces that more than two elements share, the first of each: elements lie on one another there, as they do where a
/// file has an element twice.
pub fn crowded_faces(mesh: &Mesh) -> Vec<Face> {
    let mut keyed: Vec<([u32; 4], Face)> =
        all_faces(mesh, None).map(|face| (face_key(mesh, face), face)).collect();
    keyed.par_sort_unstable();
    keyed.chunk_by(|a, b| a.0 == b.0).filter(|same| same.len() > 2).map(|same| same[0].1).collect()
}

/// Exterior faces on the planes that bound the mesh, named `xmin`, `xmax`, `ymin`, `ymax`, `base` and
/// `top`; for meshes from files that do not name their sides.
///
/// A face counts if all its nodes are within `tolerance` \[m\] of the plane. All six names are there,
/// `top` with few or no faces if the ground is not level.
pub fn plane_faces(mesh: &Mesh, tolerance: f64) -> BTreeMap<String, Vec<Face>> {
    let (low, high) = mesh.bounds();
    let planes = [
        ("xmin", 0, low[0]),
        ("xmax", 0, high[0]),
        ("ymin", 1, low[1]),
        ("ymax", 1, high[1]),
        ("base", 2, low[2]),
        ("top", 2, high[2]),
    ];
    let exterior = exterior_faces(mesh, None);
    let on = |face: &Face, axis: usize, level: f64| {
        mesh.face_nodes(*face).all(|n| (mesh.nodes[n as usize][axis] - level).abs() <= tolerance)
    };
    planes
        .into_iter()
        .map(|(name, axis, level)| {
            (name.to_owned(), exterior.iter().copied().filter(|face| on(face, axis, level)).collect())
        })
        .collect()
}

/// The separate parts of the given elements (or of all): sets of elements that share nodes, directly
/// or through others. Each ascending, in the order of their first elements.
///
/// # Panics
/// If an element is not in the mesh.
pub fn components(mesh: &Mesh, elements: Option<&[u32]>) -> Vec<Vec<u32>> {
    let all: Vec<u32>;
    let elements = match elements {
        Some(some) => some,
        None => {
            all = (0..mesh.elements.len() as u32).collect();
            &all
        }
    };
    // Each tree's root is its smallest node.
    let mut parent: Vec<u32> = (0..mesh.nodes.len() as u32).collect();
    for &element in elements {
        let nodes = mesh.elements[element as usize].nodes();
        for &node in &nodes[1..] {
            let (a, b) = (root(&mut parent, nodes[0]), root(&mut parent, node));
            parent[a.max(b) as usize] = a.min(b);
        }
    }
    let mut parts: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for &element in elements {
        let root = root(&mut parent, mesh.elements[element as usize].nodes()[0]);
        parts.entry(root).or_default().push(element);
    }
    let mut parts: Vec<Vec<u32>> = parts.into_values().collect();
    for part in &mut parts {
        part.sort_unstable();
    }
    parts.sort_unstable();
    parts
}

/// The root of a node's tree, halving the path on the way.
pub(crate) fn root(parent: &mut [u32], mut node: u32) -> u32 {
    while parent[node as usize] != node {
        parent[node as usize] = parent[parent[node as usize] as usize];
        node = parent[node as usize];
    }
    node
}

/// Vector area of each node of a set of faces, ∑ ∫ N_i n dA \[m²\], outward from the faces' elements.
///
/// Quadrilaterals are bilinear, integrated by 2 × 2 Gauss points, which is exact for warped ones too;
/// a triangle gives a third to each node. The areas of a closed surface sum to zero.
///
/// # Panics
/// If a face is not in the mesh.
pub fn vector_areas(mesh: &Mesh, faces: &[Face]) -> BTreeMap<u32, [f64; 3]> {
    let mut areas: BTreeMap<u32, [f64; 3]> = BTreeMap::new();
    for &face in faces {
        let (corners, shares) = corner_areas(mesh, face);
        for (&node, (share, _)) in corners.nodes().iter().zip(shares) {
            let area = areas.entry(node).or_default();
            for i in 0..3 {
                area[i] += share[i];
            }
        }
    }
    areas
}

/// The nodes of a face, in its order.
pub(crate) struct FaceCorners {
    nodes: [u32; 4],
    count: usize,
}

impl FaceCorners {
    pub(crate) fn new(mesh: &Mesh, face: Face) -> Self {
        let mut corners = FaceCorners { nodes: [0; 4], count: 0 };
        for node in mesh.face_nodes(face) {
            corners.nodes[corners.count] = node;
            corners.count += 1;
        }
        corners
    }

    pub(crate) fn nodes(&self) -> &[u32] {
        &self.nodes[..self.count]
    }
}

/// A corner's share of a face, \[m²\]: ∫ N_i n dA, outward, and ∫ N_i dA.
pub(crate) type CornerArea = ([f64; 3], f64);

/// The shares of a face's corners, as in [`vector_areas`]; of a triangle the first three count.
pub(crate) fn corner_areas(mesh: &Mesh, face: Face) -> (FaceCorners, [CornerArea; 4]) {
    let corners = FaceCorners::new(mesh, face);
    let x = corners.nodes.map(|n| mesh.nodes[n as usize]);
    let shares = if corners.count == 4 { quadrilateral_areas(&x) } else { triangle_areas(&x) };
    (corners, shares)
}

/// A point of integration of a face.
#[derive(Clone, Copy, Debug, Default)]
pub struct FacePoint {
    /// m
    pub at: [f64; 3],
    /// n dA, outward \[m²\].
    pub area: [f64; 3],
    /// N_i of the face's corners; of a triangle the first three count.
    pub shapes: [f64; 4],
}

/// The nodes of a face, in its order, and its points of integration: 2 × 2 Gauss points of a quadrilateral, the middles of a
/// triangle's edges.
///
/// # Panics
/// If the face is not in the mesh.
pub fn face_points(mesh: &Mesh, face: Face) -> (Vec<u32>, Vec<FacePoint>) {
    let corners = FaceCorners::new(mesh, face);
    let x = corners.nodes.map(|n| mesh.nodes[n as usize]);
    let points =
        if corners.count == 4 { quadrilateral_points(&x).to_vec() } else { triangle_points(&x).to_vec() };
    (corners.nodes().to_vec(), points)
}

fn triangle_points(x: &[[f64; 3]; 4]) -> [FacePoint; 3] {
    let area = cross(minus(x[1], x[0]), minus(x[2], x[0])).map(|n| n / 6.0);
    [[0.5, 0.5, 0.0, 0.0], [0.0, 0.5, 0.5, 0.0], [0.5, 0.0, 0.5, 0.0]].map(|shapes| {
        let at = [0, 1, 2].map(|i| (0..3).map(|k| shapes[k] * x[k][i]).sum());
        FacePoint { at, area, shapes }
    })
}

fn triangle_areas(x: &[[f64; 3]; 4]) -> [CornerArea; 4] {
    let normal = cross(minus(x[1], x[0]), minus(x[2], x[0]));
    [(normal.map(|n| n / 6.0), norm(normal) / 6.0); 4]
}

fn quadrilateral_points(x: &[[f64; 3]; 4]) -> [FacePoint; 4] {
    const SIGNS: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let g = 1.0 / 3.0_f64.sqrt();
    SIGNS.map(|[a, b]| [a * g, b * g]).map(|[r, s]| {
        let (mut along_r, mut along_s) = ([0.0; 3], [0.0; 3]);
        for (node, [a, b]) in x.iter().zip(SIGNS) {
            for i in 0..3 {
                along_r[i] += 0.25 * a * (1.0 + b * s) * node[i];
                along_s[i] += 0.25 * b * (1.0 + a * r) * node[i];
            }
        }
        let shapes = SIGNS.map(|[a, b]| 0.25 * (1.0 + a * r) * (1.0 + b * s));
        let at = [0, 1, 2].map(|i| (0..4).map(|k| shapes[k] * x[k][i]).sum());
        FacePoint { at, area: cross(along_r, along_s), shapes }
    })
}

fn quadrilateral_areas(x: &[[f64; 3]; 4]) -> [CornerArea; 4] {
    let mut areas = [([0.0; 3], 0.0); 4];
    for point in quadrilateral_points(x) {
        let size = norm(point.area);
        for ((vector, area), weight) in areas.iter_mut().zip(point.shapes) {
            for i in 0..3 {
                vector[i] += weight * point.area[i];
            }
            *area += weight * size;
        }
    }
    areas
}

pub(crate) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn norm(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

pub(crate) fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(crate) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[cfg(test)]
mod tests;
