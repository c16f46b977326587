//! Files of meshes.

use std::path::Path;
use tremolite_mesh::read::{read_bytes, recognised};
use tremolite_mesh::sound;

/// Reads content of one format. A mesh that is handed out is sound.
pub fn read(format: &str, bytes: &[u8]) -> bool {
    if recognised(bytes).is_none_or(|known| !known.name.starts_with(format)) {
        return false;
    }
    match read_bytes(Path::new("no folder/mesh"), bytes) {
        Err(error) => assert!(!error.to_string().is_empty()),
        Ok((mesh, _)) => {
            let (again, _) = sound(mesh.clone()).expect("a mesh that a reader hands out is sound");
            assert_eq!(again.elements, mesh.elements, "and comes back as it is");
            assert_eq!(again.nodes.len(), mesh.nodes.len());
        }
    }
    true
}
