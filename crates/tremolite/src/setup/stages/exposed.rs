//! Faces that a stage lays bare.

use super::{Staged, before};
use std::collections::HashMap;
use tremolite_engine::{Life, Stage};
use tremolite_mesh::merge::{coincident_nodes, shortest_edge};
use tremolite_mesh::topology::all_faces;
use tremolite_mesh::{Face, Mesh};

/// Share of the shortest edge within which nodes are at one place, as where a mesh comes parted at an interface.
const DOUBLED: f64 = 1e-3;

/// A face that a stage lays bare.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Exposed {
    /// Of an element that stands from the start to the end.
    pub face: Face,
    /// The element in front of it, which is gone, or whose stand-in is.
    pub gone: u32,
}

impl Staged {
    /// Whether anything stands in the place of an element in a stage.
    pub fn stands(&self, element: u32, stage: Stage) -> bool {
        let e = element as usize;
        let in_place = || {
            let of = self.stand_ins.partition_point(|&(other, ..)| other < element);
            self.stand_ins.get(of).is_some_and(|&(other, _, life)| other == element && life.holds(stage))
        };
        self.body_of[e].is_some() && (self.places[e].holds(stage) || in_place())
    }

    /// Faces of the ground that the k-th stage of the case lays bare for good: what is behind them is there from the start to the
    /// end, what was in front goes. A lining that the stage installs there hides nothing, and linings have no such faces, nor has
    /// what a later stage takes: the next bench, the face of a heading. With them all elements that go.
    pub fn exposed(&self, mesh: &Mesh, k: usize) -> (Vec<Exposed>, Vec<u32>) {
        let (earlier, now) = (Stage::Before(k as u16), before(k));
        let mut first: Vec<u32> = (0..mesh.nodes.len() as u32).collect();
        for (node, other) in coincident_nodes(mesh, DOUBLED * shortest_edge(mesh)) {
            first[node as usize] = other;
        }
        let key = |face: Face| {
            let mut key = [u32::MAX; 4];
            key.iter_mut().zip(mesh.face_nodes(face)).for_each(|(k, n)| *k = first[n as usize]);
            key.sort_unstable();
            key
        };
        // What begins with the stage is no ground.
        let goes =
            |e: u32| self.stands(e, earlier) && (!self.stands(e, now) || self.places[e as usize].born == now);
        let stays = |e: u32| self.body_of[e as usize].is_some() && self.places[e as usize] == Life::ALWAYS;
        let all = 0..mesh.elements.len() as u32;
        let going: Vec<u32> = all.clone().filter(|&e| goes(e)).collect();
        let gone: HashMap<[u32; 4], u32> =
            all_faces(mesh, Some(&going)).map(|face| (key(face), face.element)).collect();
        let staying: Vec<u32> = all.filter(|&e| stays(e)).collect();
        let exposed = all_faces(mesh, Some(&staying))
            .filter_map(|face| Some(Exposed { face, gone: *gone.get(&key(face))? }))
            .collect();
        (exposed, going)
    }
}
