//! Bodies thinner than a few elements: nodes through their thickness step together.
//!
//! Where coarser nodes go straight between their own times, finer ones beside them move as if their mass were some per cent off, in a
//! layer one element thick. Across a thick mass that reflects little; along a thin body it is part of the body's stiffness in bending.

use crate::model::Model;
use crate::ties::Ties;
use std::collections::HashMap;
use tremolite_kernels::Quadrature;
use tremolite_laws::shapes::hex8::CORNERS;
use tremolite_mesh::topology::face_key;
use tremolite_mesh::{Face, Shape};

/// Elements through the thickness of a thin body, at most.
const THIN: usize = 3;

/// Joins nodes that lie through the thickness of a thin body: elements of several points, of which at most [`THIN`] lie from face to
/// opposite face until others begin, or nothing.
pub fn join_across(model: &Model, classes: &mut Ties) {
    let mesh = &model.mesh;
    let bends = |body: &&crate::Body| !matches!(body.quadrature, Quadrature::OnePoint);
    let elements: Vec<u32> = model.bodies.iter().filter(bends).flat_map(|body| model.lasting(body)).collect();
    let mut sharing: HashMap<[u32; 4], Vec<Face>> = HashMap::new();
    for &element in &elements {
        for side in 0..mesh.elements[element as usize].shape.faces().len() as u8 {
            let face = Face { element, side };
            sharing.entry(face_key(mesh, face)).or_default().push(face);
        }
    }
    let beyond = |face: Face| {
        let faces = &sharing[&face_key(mesh, face)];
        faces.iter().copied().find(|other| other.element != face.element)
    };
    // Elements of the way through a face and from face to opposite face, until it ends or is longer than a thin body.
    let way = |mut face: Face| {
        let mut count = 0;
        while count < THIN
            && let Some(entered) = beyond(face)
        {
            count += 1;
            match opposite(mesh.elements[entered.element as usize].shape, entered.side) {
                Some(side) => face = Face { side, ..entered },
                None => return THIN,
            }
        }
        count
    };
    for &element in &elements {
        let shape = mesh.elements[element as usize].shape;
        for side in (0..shape.faces().len() as u8).step_by(2) {
            let Some(other) = opposite(shape, side) else { continue };
            if 1 + way(Face { element, side }) + way(Face { element, side: other }) <= THIN {
                let nodes = mesh.elements[element as usize].nodes();
                for [a, b] in edges(shape, side as usize / 2) {
                    classes.join(nodes[a], nodes[b]);
                }
            }
        }
    }
}

/// The side across from one, where there is one.
fn opposite(shape: Shape, side: u8) -> Option<u8> {
    match shape {
        Shape::Hex8 => Some(side ^ 1),
        Shape::Wedge6 if side < 2 => Some(side ^ 1),
        _ => None,
    }
}

/// The edges from the lower side of an axis to the upper; those of a wedge lead from triangle to triangle.
fn edges(shape: Shape, axis: usize) -> Vec<[usize; 2]> {
    let upper = |low: usize| {
        let mut corner = CORNERS[low];
        corner[axis] = 1.0;
        CORNERS.iter().position(|other| *other == corner)
    };
    match shape {
        Shape::Hex8 => {
            (0..8).filter(|&k| CORNERS[k][axis] < 0.0).filter_map(|k| Some([k, upper(k)?])).collect()
        }
        _ => (0..3).map(|k| [k, k + 3]).collect(),
    }
}
