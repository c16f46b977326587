//! Faces of a mesh by their nodes.

use std::collections::HashMap;
use tremolite_mesh::Mesh;
use tremolite_mesh::topology::{all_faces, face_key};

/// The elements that have each face.
pub(super) type Faces = HashMap<[u32; 4], Vec<u32>>;

/// All faces of a mesh whose interfaces are not split yet.
pub(super) fn faces(mesh: &Mesh) -> Faces {
    let mut faces = Faces::new();
    all_faces(mesh, None).for_each(|face| faces.entry(face_key(mesh, face)).or_default().push(face.element));
    faces
}
