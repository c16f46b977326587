//! Interfaces opened: nodes copied so that what lies on either side of a face no longer shares them.

mod around;
mod error;
mod faces;
mod periodic;

use std::ops::Range;

use around::Around;
pub use error::{SplitError, UnmatchedSplit};
pub use periodic::match_split;

use crate::{Face, Mesh};

/// An interface asked for: its name and the elements of its two sides (indices into [`Mesh::elements`]).
#[derive(Clone, Copy, Debug)]
pub struct Cut<'a> {
    pub name: &'a str,
    pub sides: [&'a [u32]; 2],
}

/// Two nodes at one place that move as one while both of these elements are there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Joint {
    /// Ascending.
    pub nodes: [u32; 2],
    /// Of the first and of the second node.
    pub elements: [u32; 2],
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
    /// Copies that elements hold together for a time: where an interface meets what goes or comes while other things stay.
    pub joints: Vec<Joint>,
}

/// Opens interfaces in a mesh.
///
/// The faces of a cut are those that an element of its first side shares with one of its second, and exterior faces of
/// both that look at each other from the same place (within 1e-6 of the shortest edge), as in meshes that come split.
/// `times` says when each element is there, from the first time on and until before the second; two elements meet only where
/// their times do, and one whose time is empty does not count.
///
/// At each node of a shared face the elements around it fall into components, which hang together at some time through shared
/// faces with that node which are on no interface. One component keeps the node: that with the fewest faces of first sides at
/// it, or else the smallest element, of those that are there in the end; so second sides keep the nodes of the file, and so do
/// elements that are never there. Each other one has a copy of its own, with the number of the original, behind all nodes of the
/// file. Bodies that touch along no more than an edge part there too, if an interface comes by.
///
/// What holds a component together may be there for a part of its time alone: rock that is excavated later, at the rim of an
/// interface. Where two elements of one component are there at a time at which nothing holds them together, all elements of it
/// that are there at the same times and hang together have a copy of their own instead, or one with others that are there in the end
/// and never without being held; and [`Split::joints`] says which copies move as one, and when.
///
/// Faces keep their elements and sides, so named sets of faces stay as they are; what is exterior changes. Elements
/// that are never there stay with the file's nodes, so their faces may lose the neighbour. The mesh is unchanged on an
/// error.
///
/// # Errors
/// If a side is empty, an element in both sides, or a face in two cuts; if two sides do not touch; or if more than two
/// elements have a face at a time.
///
/// # Panics
/// If an element is not in the mesh, or `times` has not an entry for each.
pub fn split(mesh: &mut Mesh, cuts: &[Cut], times: &[Range<u32>]) -> Result<Split, SplitError> {
    assert_eq!(times.len(), mesh.elements.len(), "an entry an element");
    let found = faces::find(mesh, cuts, times)?;
    let before = mesh.nodes.len();
    let around = Around::new(mesh, &found, times);
    let mut origin: Vec<u32> = (0..before as u32).collect();
    let joints = around.copy_nodes(mesh, times, &mut origin);
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
    Ok(Split { faces: found.faces, origin, places, ends, joints })
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

/// Whether two elements are there at the same time.
fn meet(a: &Range<u32>, b: &Range<u32>) -> bool {
    a.start.max(b.start) < a.end.min(b.end)
}

#[cfg(test)]
mod tests;
