//! What a stage lays bare, opening by opening.

use super::super::stages::Staged;
use super::wall::Wall;
use std::collections::HashMap;
use tremolite_mesh::Mesh;
use tremolite_mesh::topology::components;

/// The faces that are bare around what belongs together of what a stage takes out.
#[derive(Clone, Debug, Default)]
pub struct Opening {
    pub walls: Vec<Wall>,
    /// The elements on the two sides of each: what stands, and what is gone.
    pub sides: Vec<[u32; 2]>,
}

/// The openings that the k-th stage makes.
pub fn openings(mesh: &Mesh, staged: &Staged, k: usize) -> Vec<Opening> {
    let (exposed, gone) = staged.exposed(mesh, k);
    let parts = components(mesh, Some(&gone));
    let numbers: HashMap<u32, usize> =
        parts.iter().enumerate().flat_map(|(k, part)| part.iter().map(move |&e| (e, k))).collect();
    let mut all = vec![Opening::default(); parts.len()];
    for face in exposed {
        let opening = &mut all[numbers[&face.gone]];
        if let Some(wall) = Wall::new(mesh, face.face) {
            opening.walls.push(wall);
            opening.sides.push([face.face.element, face.gone]);
        }
    }
    all
}
