//! The weight above a point, along the vertical through it.

mod lattice;
mod surface;
#[cfg(test)]
mod tests;

use crate::topology::{all_faces, face_key};
use crate::{Face, Mesh};
use lattice::Lattice;
use rayon::prelude::*;
use surface::Surface;

/// Pressure \[Pa\] at each point of what lies above it: ∫ γ dz from the point up, with γ the unit weights \[N/m³\], one an
/// element and 0 where nothing is.
///
/// Summed by parts, Σ Δγ (z_f − z) over the faces above the point, so that only faces with another γ on their other side
/// count, outer ones among them, and homogeneous rock costs no more than its surface. Quadrilaterals are two triangles,
/// split from their corner of lowest x, then y, then z, on which neighbours agree even where they have nodes of their
/// own at one place.
///
/// In x and y places are told apart to 10⁻¹² of the mesh's extent, and a vertical that meets an edge or a node, as most
/// do in structured meshes, runs beside it, towards the middle of the mesh. So every vertical passes into an element as
/// often as out of it, and a point on the model's outer sides has the weight that is just inside. Between columns of
/// different weight a point has that of one of them. Points beyond the mesh's sides have nothing above them; one that
/// is not a number gives none.
///
/// The result does not depend on the order of elements, bit for bit. Elements must not overlap, unless all but one of those
/// at a place weigh nothing.
///
/// # Panics
/// If `unit_weight` has not an entry for each element.
pub fn weight_above(mesh: &Mesh, unit_weight: &[f64], points: &[[f64; 3]]) -> Vec<f64> {
    assert_eq!(unit_weight.len(), mesh.elements.len(), "an entry an element");
    let lattice = Lattice::new(mesh);
    let mut surface = Surface::new(mesh, &lattice);
    for (face, weight) in changes(mesh, unit_weight) {
        surface.add(face, weight);
    }
    let grid = surface.sorted();
    points.par_iter().map(|&x| grid.weight_above(x)).collect()
}

/// Faces of elements that weigh something, but for those with as much on their other side.
fn changes(mesh: &Mesh, unit_weight: &[f64]) -> Vec<(Face, f64)> {
    let mut keyed: Vec<([u32; 4], Face)> =
        all_faces(mesh, None).map(|face| (face_key(mesh, face), face)).collect();
    keyed.par_sort_unstable();
    let weight = |face: &Face| unit_weight[face.element as usize];
    let same = |faces: &&[([u32; 4], Face)]| faces.len() == 2 && weight(&faces[0].1) == weight(&faces[1].1);
    let chunks = keyed.chunk_by(|a, b| a.0 == b.0).filter(|faces| !same(faces));
    chunks.flatten().map(|(_, face)| (*face, weight(face))).filter(|(_, weight)| *weight != 0.0).collect()
}
