//! The faces of a model on its outer planes.

use std::collections::BTreeSet;
use tremolite_mesh::topology::exterior_faces;
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
        let mut planes = <[[Vec<Face>; 2]; 3]>::default();
        for face in exterior_faces(mesh, Some(elements)) {
            for axis in 0..3 {
                let near = NEAR * (high[axis] - low[axis]);
                for (end, level) in [low[axis], high[axis]].into_iter().enumerate() {
                    if mesh.face_nodes(face).all(|n| (mesh.nodes[n as usize][axis] - level).abs() <= near) {
                        planes[axis][end].push(face);
                    }
                }
            }
        }
        OuterFaces { planes, bounds }
    }
}

/// The nodes of some faces, ascending.
pub fn nodes_of(mesh: &Mesh, faces: &[Face]) -> Vec<u32> {
    let nodes: BTreeSet<u32> = faces.iter().flat_map(|&face| mesh.face_nodes(face)).collect();
    nodes.into_iter().collect()
}
