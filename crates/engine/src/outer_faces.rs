//! The faces of a model on its outer planes.

use rayon::prelude::*;
use std::collections::BTreeSet;
use tremolite_mesh::topology::{all_faces, unshared};
use tremolite_mesh::{Face, Mesh};

/// How far a face's nodes may lie off an outer plane, over the mesh's extent normal to it.
pub const NEAR: f64 = 1e-6;

/// Distance \[m\] within which something is at a place of a model with these bounds.
pub fn near(bounds: ([f64; 3], [f64; 3])) -> f64 {
    let (low, high) = bounds;
    NEAR * (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max)
}

/// Faces of elements on the outer planes.
#[derive(Clone, Debug, Default)]
pub struct OuterFaces {
    /// `[axis][low or high]`: x, y, z (base and top).
    pub planes: [[Vec<Face>; 2]; 3],
    /// Smallest and largest coordinates of the mesh \[m\].
    pub bounds: ([f64; 3], [f64; 3]),
}

impl OuterFaces {
    /// Sorts the exterior faces of some elements by the plane of these bounds that they lie on.
    pub fn of(mesh: &Mesh, bounds: ([f64; 3], [f64; 3]), elements: &[u32]) -> Self {
        let (low, high) = bounds;
        let near = |node: u32, axis: usize, level: f64| {
            (mesh.nodes[node as usize][axis] - level).abs() <= NEAR * (high[axis] - low[axis])
        };
        // Few elements reach an outer plane, so these are sought before faces that two of them share are left out.
        let reaches = |n: u32| (0..3).any(|axis| near(n, axis, low[axis]) || near(n, axis, high[axis]));
        let outer = |e: &u32| mesh.elements[*e as usize].nodes().iter().any(|&n| reaches(n));
        let outer: Vec<u32> = elements.par_iter().copied().filter(outer).collect();
        let planes = [0, 1, 2].map(|axis| {
            [low[axis], high[axis]].map(|level| {
                let on = |face: &Face| mesh.face_nodes(*face).all(|n| near(n, axis, level));
                unshared(mesh, all_faces(mesh, Some(&outer)).filter(on))
            })
        });
        OuterFaces { planes, bounds }
    }
}

/// The nodes of some faces, ascending.
pub fn nodes_of(mesh: &Mesh, faces: &[Face]) -> Vec<u32> {
    let nodes: BTreeSet<u32> = faces.iter().flat_map(|&face| mesh.face_nodes(face)).collect();
    nodes.into_iter().collect()
}
