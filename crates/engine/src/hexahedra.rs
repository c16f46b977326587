//! Elements of a mesh as hexahedra.

use tremolite_laws::shapes::hex8::{BadShape, Hex8};
use tremolite_mesh::{Mesh, Shape};

/// Squares of lengths that differ by no more over themselves are alike: far above round-off of coordinates.
const ALIKE: f64 = 1e-9;

/// Corners of an element as a hexahedron, of which the other shapes are collapsed ones.
///
/// Collapsing keeps the patch test, the six rigid modes and the right row-sum masses, since the shape functions that
/// fall together add up to those of the smaller shape. A tetrahedron is the constant-strain one: it locks in bending
/// and at ν → ½; a pyramid is between it and a hexahedron. A wedge has a field of its own, which bends out of the plane of its triangles
/// as a hexahedron does, and is constant strain in that plane.
///
/// The natural axes of a wedge depend on which of its three edges along the axis counts twice. A prism has the same strain for each. Other wedges
/// take the edge across from the longest side of the triangles, so results do not depend on the corner with which a mesh begins.
pub fn hex_nodes(mesh: &Mesh, element: usize) -> [u32; 8] {
    let e = &mesh.elements[element];
    let n = e.nodes;
    match e.shape {
        Shape::Hex8 => n,
        Shape::Wedge6 => {
            let c = twice(mesh, n);
            let [a, b] = [(c + 1) % 3, (c + 2) % 3];
            [n[a], n[b], n[c], n[c], n[a + 3], n[b + 3], n[c + 3], n[c + 3]]
        }
        Shape::Pyramid5 => [n[0], n[1], n[2], n[3], n[4], n[4], n[4], n[4]],
        Shape::Tet4 => [n[0], n[1], n[2], n[2], n[3], n[3], n[3], n[3]],
    }
}

/// The corner of a wedge's first triangle whose edge along the axis counts twice: across from the longest side, of sides alike the one with
/// the smallest number of a node, which a mirror image has as well.
fn twice(mesh: &Mesh, n: [u32; 8]) -> usize {
    let square = |a: usize, b: usize| {
        let [a, b] = [a, b].map(|corner| mesh.nodes[n[corner] as usize]);
        (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>()
    };
    let across = [(1, 2), (2, 0), (0, 1)].map(|(a, b)| square(a, b) + square(a + 3, b + 3));
    let longest = across.into_iter().fold(0.0, f64::max);
    let alike = (0..3).filter(|&c| across[c] >= (1.0 - ALIKE) * longest);
    alike.min_by_key(|&c| n[c].min(n[c + 3])).unwrap_or(2)
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

#[cfg(test)]
mod tests {
    use super::*;
    use tremolite_mesh::Element;

    /// Wedges as hexahedra, from a triangle at z = 0 and 1, by the corner with which they begin; `mirror` turns x and the way round.
    fn wedges(triangle: [[f64; 2]; 3], mirror: bool) -> [[u32; 8]; 3] {
        let sign = if mirror { -1.0 } else { 1.0 };
        let nodes = [0.0, 1.0].map(|z| triangle.map(|[x, y]| [sign * x, y, z])).concat();
        [0, 1, 2].map(|first| {
            let mut order = [0, 1, 2].map(|k| (first + k) % 3);
            if mirror {
                order.reverse();
            }
            let corners = [order, order.map(|k| k + 3)].concat();
            let elements = vec![Element::new(Shape::Wedge6, &corners)];
            hex_nodes(&Mesh { nodes: nodes.clone(), elements, ..Mesh::default() }, 0)
        })
    }

    #[test]
    fn a_wedge_goes_by_its_shape_and_not_by_the_corner_it_begins_with() {
        let right_angled = [[0.0, 2.0], [0.0, 0.0], [1.0, 0.0]];
        // The two longest sides are alike, so numbers decide between the corners across from them.
        let slim = [[0.0, 0.0], [3.0, -1.0], [3.0, 1.0]];
        let even = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.75f64.sqrt()]];
        for (triangle, twice) in [(right_angled, 1), (slim, 1), (even, 0)] {
            for mirror in [false, true] {
                let all = wedges(triangle, mirror);
                assert!(all.iter().all(|one| *one == all[0]), "{all:?}");
                assert_eq!([all[0][2], all[0][3], all[0][6]], [twice, twice, twice + 3]);
            }
        }
    }
}
