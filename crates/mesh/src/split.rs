//! Interfaces opened: nodes copied so that what lies on either side of a face no longer shares them.

mod error;
mod faces;
mod periodic;

use std::collections::HashSet;

pub use error::{SplitError, UnmatchedSplit};
pub use periodic::match_split;

use crate::topology::{all_faces, face_key, root};
use crate::{Face, Mesh};

/// An interface asked for: its name and the elements of its two sides (indices into [`Mesh::elements`]).
#[derive(Clone, Copy, Debug)]
pub struct Cut<'a> {
    pub name: &'a str,
    pub sides: [&'a [u32]; 2],
}

/// What [`split`] found and did.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Split {
    /// By cut: faces of the first side's elements with the coincident face of the second side's, ascending.
    pub faces: Vec<Vec<[Face; 2]>>,
    /// Node of the split mesh -> node before (itself for those of the file, which come first).
    pub origin: Vec<u32>,
    /// As `origin`, but where the mesh came split along an interface its nodes at one place are one as well.
    pub places: Vec<u32>,
    /// By cut, ascending: nodes that both faces of one of its pairs still have, since what lies on the two sides hangs
    /// together around them. The interface ends there, closed.
    pub ends: Vec<Vec<u32>>,
}

/// Opens interfaces in a mesh.
///
/// The faces of a cut are those that an element of its first side shares with one of its second, and exterior faces of
/// both that look at each other from the same place (within 1e-6 of the shortest edge), as in meshes that come split.
/// Only elements that are `there` count, one entry an element.
///
/// At each node of a shared face the elements around it fall into components, which hang together through shared faces
/// with that node which are on no interface. One component keeps the node: that with the fewest faces of first sides at
/// it, or else the smallest element; so second sides keep the nodes of the file, and so do elements that are not there.
/// Each other one has a copy of its own, with the number of the original, behind all nodes of the file. Bodies that
/// touch along no more than an edge part there too, if an interface comes by.
///
/// Faces keep their elements and sides, so named sets of faces stay as they are; what is exterior changes. Elements
/// that are not there stay with the file's nodes, so their faces may lose the neighbour. The mesh is unchanged on an
/// error.
///
/// # Errors
/// If a side is empty, an element in both sides, or a face in two cuts; if two sides do not touch; or if more than two
/// elements have a face.
///
/// # Panics
/// If an element is not in the mesh, or `there` has not an entry for each.
pub fn split(mesh: &mut Mesh, cuts: &[Cut], there: &[bool]) -> Result<Split, SplitError> {
    assert_eq!(there.len(), mesh.elements.len(), "an entry an element");
    let found = faces::find(mesh, cuts, there)?;
    let before = mesh.nodes.len();
    let around = Around::new(mesh, &found, there);
    let mut origin: Vec<u32> = (0..before as u32).collect();
    around.copy_nodes(mesh, &mut origin);
    if origin.len() > before {
        mesh.node_ids = origin.iter().map(|&n| mesh.node_id(n as usize)).collect();
    }

    let mut came_split = vec![false; before];
    for &face in found.apart.iter().flatten() {
        for node in mesh.face_nodes(face) {
            came_split[origin[node as usize] as usize] = true;
        }
    }
    let place = |&node: &u32| match came_split[node as usize] {
        true => found.earlier.get(&node).copied().unwrap_or(node),
        false => node,
    };
    let places = origin.iter().map(place).collect();
    let ends = found.faces.iter().map(|faces| closed_nodes(mesh, faces)).collect();
    Ok(Split { faces: found.faces, origin, places, ends })
}

/// Nodes that two faces of a pair have in common, ascending.
fn closed_nodes(mesh: &Mesh, faces: &[[Face; 2]]) -> Vec<u32> {
    let common = |&[first, second]: &[Face; 2]| {
        mesh.face_nodes(first).filter(|&n| mesh.face_nodes(second).any(|m| m == n)).collect::<Vec<_>>()
    };
    let mut nodes: Vec<u32> = faces.iter().flat_map(common).collect();
    nodes.sort_unstable();
    nodes.dedup();
    nodes
}

/// The elements around each node of an interface.
struct Around {
    /// Node and element, ascending.
    slots: Vec<(u32, u32)>,
    /// Faces of first sides that a slot's element has at its node.
    firsts: Vec<u32>,
    /// Slots that hang together, as trees.
    parent: Vec<u32>,
}

impl Around {
    fn new(mesh: &Mesh, found: &faces::Found, there: &[bool]) -> Self {
        let came_split: HashSet<Face> = found.apart.iter().flatten().copied().collect();
        let mut open = vec![false; mesh.nodes.len()];
        for &face in found.faces.iter().flatten().flatten().filter(|face| !came_split.contains(face)) {
            for node in mesh.face_nodes(face) {
                open[node as usize] = true;
            }
        }
        let mut slots = Vec::new();
        let mut elements = Vec::new();
        for (e, element) in (0..).zip(&mesh.elements).filter(|(e, _)| there[*e as usize]) {
            let before = slots.len();
            slots.extend(element.nodes().iter().filter(|&&n| open[n as usize]).map(|&n| (n, e)));
            if slots.len() > before {
                elements.push(e);
            }
        }
        slots.sort_unstable();
        let parent = (0..slots.len() as u32).collect();
        let mut around = Around { firsts: vec![0; slots.len()], slots, parent };
        for &[first, _] in found.faces.iter().flatten() {
            for node in mesh.face_nodes(first).filter(|&n| open[n as usize]) {
                let slot = around.slot(node, first.element);
                around.firsts[slot as usize] += 1;
            }
        }
        let interface: HashSet<Face> = found.faces.iter().flatten().flatten().copied().collect();
        let near = |face: &Face| mesh.face_nodes(*face).any(|n| open[n as usize]);
        let mut keyed: Vec<([u32; 4], Face)> =
            all_faces(mesh, Some(&elements)).filter(near).map(|face| (face_key(mesh, face), face)).collect();
        keyed.sort_unstable();
        for same in keyed.windows(2).filter(|w| w[0].0 == w[1].0 && !interface.contains(&w[0].1)) {
            for node in mesh.face_nodes(same[0].1).filter(|&n| open[n as usize]) {
                around.join(node, [same[0].1.element, same[1].1.element]);
            }
        }
        around
    }

    /// Place of a node and an element that are in the list.
    fn slot(&self, node: u32, element: u32) -> u32 {
        self.slots.partition_point(|&slot| slot < (node, element)) as u32
    }

    fn join(&mut self, node: u32, elements: [u32; 2]) {
        let [a, b] = elements.map(|e| self.slot(node, e)).map(|slot| root(&mut self.parent, slot));
        self.parent[a.max(b) as usize] = a.min(b);
    }

    /// Gives every component but one of each node a copy, and says of which node it is one.
    fn copy_nodes(mut self, mesh: &mut Mesh, origin: &mut Vec<u32>) {
        let mut start = 0;
        while let Some(&(node, _)) = self.slots.get(start) {
            let end = start + self.slots[start..].partition_point(|slot| slot.0 == node);
            // A root is its component's first slot, so its smallest element.
            let roots: Vec<u32> = (start..end).map(|s| root(&mut self.parent, s as u32)).collect();
            let mut components: Vec<(u32, u32)> = roots.iter().map(|&root| (root, 0)).collect();
            components.sort_unstable();
            components.dedup();
            for component in &mut components {
                let own = (start..end).filter(|slot| roots[slot - start] == component.0);
                component.1 = own.map(|slot| self.firsts[slot]).sum();
            }
            let keeper = components.iter().min_by_key(|&&(root, firsts)| (firsts, root)).map(|c| c.0);
            for &(component, _) in components.iter().filter(|c| Some(c.0) != keeper) {
                let copy = mesh.nodes.len() as u32;
                mesh.nodes.push(mesh.nodes[node as usize]);
                origin.push(node);
                for slot in (start..end).filter(|slot| roots[slot - start] == component) {
                    // The unused tail of an element's nodes repeats the last of them.
                    for own in &mut mesh.elements[self.slots[slot].1 as usize].nodes {
                        *own = if *own == node { copy } else { *own };
                    }
                }
            }
            start = end;
        }
    }
}

#[cfg(test)]
mod tests;
