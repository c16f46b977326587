//! Walls that no lining covers.

use rayon::slice::ParallelSliceMut;
use tremolite_engine::Model;
use tremolite_mesh::Face;
use tremolite_mesh::topology::all_faces;

/// Places where two faces or more lie, whatever interfaces part there.
pub(super) struct Walls {
    faces: Vec<Vec<Face>>,
    /// The element that each is, or is in the place of.
    place: Vec<u32>,
}

impl Walls {
    pub fn of(model: &Model) -> Walls {
        let elements: Vec<u32> = (0..model.user.elements as u32).collect();
        let mut keyed: Vec<([u32; 4], Face)> =
            all_faces(&model.mesh, Some(&elements)).map(|face| (key(model, face), face)).collect();
        keyed.par_sort_unstable();
        let together = keyed.chunk_by(|a, b| a.0 == b.0).filter(|same| same.len() > 1);
        let faces = together.map(|same| same.iter().map(|(_, face)| *face).collect()).collect();
        let mut place = elements;
        model.elements.stand_ins.iter().for_each(|&(stand_in, of)| place[stand_in as usize] = of);
        Walls { faces, place }
    }

    /// Area \[m²\] of faces with what stands from the start on one side and nothing on the other, where there are elements in
    /// the mesh. What is installed is lining, so its own faces do not count.
    pub fn bare(&self, model: &Model, standing: &[u32]) -> f64 {
        let mut stands = vec![false; model.user.elements];
        standing.iter().for_each(|&e| stands[e as usize] = true);
        let stands = |face: &&Face| stands[face.element as usize];
        let mut sum = 0.0;
        for faces in &self.faces {
            let mut there = faces.iter().filter(stands);
            let (Some(face), None) = (there.next(), there.next()) else { continue };
            // An element and what stands in its place are on one side.
            let place = |face: &Face| self.place[face.element as usize];
            let beyond = faces.iter().any(|other| place(other) != place(face));
            if beyond && !model.elements.lives[face.element as usize].is_later() {
                sum += area(model, *face);
            }
        }
        sum
    }
}

fn key(model: &Model, face: Face) -> [u32; 4] {
    let mut key = [u32::MAX; 4];
    for (place, node) in key.iter_mut().zip(model.mesh.face_nodes(face)) {
        *place = model.parted.places.get(node as usize).copied().unwrap_or(node);
    }
    key.sort_unstable();
    key
}

/// Half the cross product of the diagonals: exact where the face is flat.
fn area(model: &Model, face: Face) -> f64 {
    let x: Vec<[f64; 3]> = model.mesh.face_nodes(face).map(|n| model.mesh.nodes[n as usize]).collect();
    let minus = |a: [f64; 3], b: [f64; 3]| [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    let (a, b) = match x[..] {
        [p, q, r, s] => (minus(r, p), minus(s, q)),
        [p, q, r] => (minus(q, p), minus(r, p)),
        _ => return 0.0,
    };
    let cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    0.5 * cross.iter().map(|c| c * c).sum::<f64>().sqrt()
}
