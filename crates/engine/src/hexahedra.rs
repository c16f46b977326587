//! Elements of a mesh as hexahedra.

use tremolite_laws::shapes::hex8::{BadShape, Hex8};
use tremolite_mesh::{Mesh, Shape};

/// Corners of an element as a hexahedron, of which the other shapes are collapsed ones.
///
/// Collapsing keeps the patch test, the six rigid modes and the right row-sum masses, since the shape functions that
/// fall together add up to those of the smaller shape. A tetrahedron is the constant-strain one: it locks in bending
/// and at ν → ½. A wedge bends well along its axis and locks across its triangles; a pyramid is in between.
pub fn hex_nodes(mesh: &Mesh, element: usize) -> [u32; 8] {
    let e = &mesh.elements[element];
    let n = e.nodes;
    match e.shape {
        Shape::Hex8 => n,
        Shape::Wedge6 => [n[0], n[1], n[2], n[2], n[3], n[4], n[5], n[5]],
        Shape::Pyramid5 => [n[0], n[1], n[2], n[3], n[4], n[4], n[4], n[4]],
        Shape::Tet4 => [n[0], n[1], n[2], n[2], n[3], n[3], n[3], n[3]],
    }
}

/// Geometry of an element that was checked to be usable.
pub fn hex(mesh: &Mesh, element: usize) -> Result<Hex8, BadShape> {
    Hex8::new(hex_nodes(mesh, element).map(|n| mesh.nodes[n as usize]))
}

/// Mean of an element's nodes.
pub fn centroid(mesh: &Mesh, element: u32) -> [f64; 3] {
    let nodes = mesh.elements[element as usize].nodes();
    let mut sum = [0.0; 3];
    for &n in nodes {
        for i in 0..3 {
            sum[i] += mesh.nodes[n as usize][i];
        }
    }
    sum.map(|s| s / nodes.len() as f64)
}
