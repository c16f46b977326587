//! Faces of a mesh by their nodes.

use tremolite_mesh::topology::{all_faces, face_key};
use tremolite_mesh::{Face, Mesh};

/// The elements that have each face, by its smallest node: few faces have one.
pub(super) struct Faces {
    start: Vec<u32>,
    all: Vec<([u32; 4], u32)>,
}

impl Faces {
    /// All faces of a mesh whose interfaces are not split yet.
    pub fn of(mesh: &Mesh) -> Self {
        let keyed = || all_faces(mesh, None).map(|face| (face_key(mesh, face), face.element));
        let mut start = vec![0; mesh.nodes.len() + 1];
        keyed().for_each(|(key, _)| start[key[0] as usize + 1] += 1);
        for n in 0..mesh.nodes.len() {
            start[n + 1] += start[n];
        }
        let mut next = start.clone();
        let mut all = vec![([0; 4], 0); start[mesh.nodes.len()] as usize];
        for one in keyed() {
            let next = &mut next[one.0[0] as usize];
            all[*next as usize] = one;
            *next += 1;
        }
        Faces { start, all }
    }

    /// The elements that have the nodes of a face, ascending.
    pub fn elements(&self, mesh: &Mesh, face: Face) -> impl Iterator<Item = u32> + '_ {
        let key = face_key(mesh, face);
        // Nodes of elements that came later have none.
        let [from, to] = [0, 1].map(|k| self.start.get(key[0] as usize + k).copied());
        let own = from.zip(to).map_or(&[][..], |(from, to)| &self.all[from as usize..to as usize]);
        own.iter().filter(move |(other, _)| *other == key).map(|(_, element)| *element)
    }
}
