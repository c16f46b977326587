//! The sides by which wedges of several points are linked: those that all elements beside them link.

use crate::body::Body;
use crate::hexahedra::{hex, hex_nodes};
use std::collections::HashMap;
use tremolite_kernels::Quadrature;
use tremolite_mesh::topology::face_key;
use tremolite_mesh::{Face, Mesh, Shape};

/// Corners of a wedge's sides as a hexahedron: the ends of two edges along its axis.
const SIDES: [[[usize; 2]; 2]; 3] = [[[0, 4], [1, 5]], [[1, 5], [2, 6]], [[2, 6], [0, 4]]];

/// A side between triangles: its nodes, ascending, and its two edges along the axis.
type Side = ([u32; 4], [[u32; 2]; 2]);

fn sides(mesh: &Mesh, element: u32) -> [Side; 3] {
    let nodes = hex_nodes(mesh, element as usize);
    SIDES.map(|side| {
        let mut edges = side.map(|edge| {
            let [a, b] = edge.map(|corner| nodes[corner]);
            [a.min(b), a.max(b)]
        });
        edges.sort_unstable();
        let mut key = [edges[0][0], edges[0][1], edges[1][0], edges[1][1]];
        key.sort_unstable();
        (key, edges)
    })
}

/// Of each wedge of several points the sides by which it is linked ([`tremolite_laws::shapes::hex8::Hex8::linked`]), in the order of its corners as a
/// hexahedron: where its shape allows it, the side is free or lies between wedges that link it, along the same axis.
pub(super) fn linked(mesh: &Mesh, bodies: &[Body]) -> HashMap<u32, [bool; 3]> {
    let several = |body: &&Body| body.quadrature != Quadrature::OnePoint;
    let elements = |body: &Body| body.elements.clone();
    let wedges: Vec<u32> = bodies
        .iter()
        .filter(several)
        .flat_map(elements)
        .filter(|&e| mesh.elements[e as usize].shape == Shape::Wedge6)
        .collect();
    let mut all = HashMap::new();
    if wedges.is_empty() {
        return all;
    }
    // Of each side how many link it, along these edges; none of edges along another axis.
    let mut linking: HashMap<[u32; 4], (usize, [[u32; 2]; 2])> = HashMap::new();
    for &e in &wedges {
        let may = hex(mesh, e as usize).map_or([false; 3], |hex| hex.linked);
        for ((key, edges), _) in sides(mesh, e).into_iter().zip(may).filter(|(_, may)| *may) {
            let (count, first) = linking.entry(key).or_insert((0, edges));
            *count += usize::from(*first == edges);
        }
        all.insert(e, may);
    }
    let mut sharing: HashMap<[u32; 4], usize> = HashMap::new();
    for e in bodies.iter().flat_map(elements) {
        let faces = mesh.elements[e as usize].shape.faces().len() as u8;
        for key in (0..faces).map(|side| face_key(mesh, Face { element: e, side })) {
            if linking.contains_key(&key) {
                *sharing.entry(key).or_default() += 1;
            }
        }
    }
    for (&e, linked) in &mut all {
        for ((key, _), linked) in sides(mesh, e).into_iter().zip(linked) {
            *linked &= linking.get(&key).map(|(count, _)| count) == sharing.get(&key);
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use tremolite_kernels::{Layers, elastic};
    use tremolite_laws::Moduli;
    use tremolite_mesh::Element;

    /// A row of squares in plan: two wedges, a hexahedron, two wedges of one point, two of several.
    #[test]
    fn sides_between_wedges_of_several_points_and_free_ones_are_linked() {
        let nodes =
            (0..20u32).map(|n| [f64::from(n % 5), f64::from(n / 5 % 2), 0.4 * f64::from(n / 10)]).collect();
        let square = |i: u32| [i, i + 1, i + 6, i + 5];
        let wedge = |[a, b, c]: [u32; 3]| Element::new(Shape::Wedge6, &[a, b, c, a + 10, b + 10, c + 10]);
        let wedges = |i: u32| {
            let [a, b, c, d] = square(i);
            [wedge([a, b, d]), wedge([b, c, d])]
        };
        let [a, b, c, d] = square(1);
        let hexahedron = Element::new(Shape::Hex8, &[a, b, c, d, a + 10, b + 10, c + 10, d + 10]);
        let elements = [&wedges(0)[..], &[hexahedron], &wedges(2), &wedges(3)].concat();
        let mesh = Mesh { nodes, elements, ..Mesh::default() };
        let body = |elements: Vec<u32>, quadrature| Body {
            name: String::new(),
            elements,
            material: elastic(Moduli::from_young_poisson(1.0, 0.2)),
            density: 1.0,
            quadrature,
            viscosity: 0.0,
        };
        let layered = Quadrature::Layered(Layers::Nine);
        let bodies = [body(vec![0, 1, 2, 5, 6], layered), body(vec![3, 4], Quadrature::OnePoint)];
        let linked = linked(&mesh, &bodies);
        assert_eq!(linked.len(), 4);
        let places = |e: u32| -> Vec<[f64; 2]> {
            let sides = sides(&mesh, e).into_iter().zip(linked[&e]).filter(|(_, linked)| *linked);
            let middle = |(_, edges): Side| {
                [0, 1].map(|i| 0.5 * edges.iter().map(|[low, _]| mesh.nodes[*low as usize][i]).sum::<f64>())
            };
            let mut places: Vec<[f64; 2]> = sides.map(|(side, _)| middle(side)).collect();
            places.sort_by(|a, b| a.partial_cmp(b).unwrap());
            places
        };
        assert_eq!(places(0), [[0.0, 0.5], [0.5, 0.0], [0.5, 0.5]]);
        assert_eq!(places(1), [[0.5, 0.5], [0.5, 1.0]], "not to the hexahedron");
        assert_eq!(places(5), [[3.5, 0.0], [3.5, 0.5]], "not to the wedge of one point");
        assert_eq!(places(6), [[3.5, 0.5], [3.5, 1.0], [4.0, 0.5]]);
    }
}
