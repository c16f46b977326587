//! Orientation, collapsed hexahedra, unused nodes: what makes the elements of a file fit for use.

use std::collections::BTreeMap;

use super::degenerate::{collapse, is_degenerate};
use super::kept;
use crate::fault::Fault;
use crate::note::Note;
use crate::quality::scaled_jacobian;
use crate::{Element, Face, Mesh, Shape};

/// Scaled Jacobian below which an element is flat: a thousand times round-off, far below any element
/// one could compute with.
const FLAT: f64 = 1e-12;

/// The node order of the mirror image.
const fn mirrored(shape: Shape) -> &'static [usize] {
    match shape {
        Shape::Hex8 => &[4, 5, 6, 7, 0, 1, 2, 3],
        Shape::Wedge6 => &[3, 4, 5, 0, 1, 2],
        Shape::Pyramid5 => &[0, 3, 2, 1, 4],
        Shape::Tet4 => &[0, 2, 1, 3],
    }
}

/// An element with the node order of its mirror image.
fn turned(element: &Element) -> Element {
    let mut nodes = [0; 8];
    for (place, &from) in nodes.iter_mut().zip(mirrored(element.shape)) {
        *place = element.nodes[from];
    }
    Element::new(element.shape, &nodes[..element.shape.nodes()])
}

/// Renumbers all elements as their mirror images, for a mesh whose nodes were mirrored. Named faces keep their nodes.
pub(crate) fn mirror(mesh: &mut Mesh) {
    let mut changed = Changed::new();
    for (index, element) in mesh.elements.iter_mut().enumerate() {
        let other = turned(element);
        changed.insert(index as u32, (std::mem::replace(element, other), None));
    }
    renumber_sides(mesh, &changed);
}

/// The elements as the file has them, where they were changed, and the second pyramid of a split one.
pub(super) type Changed = BTreeMap<u32, (Element, Option<u32>)>;

/// Replaces hexahedra with repeated nodes by what they are. The second pyramid of a split one comes last,
/// in the same groups. Those that are no such body are left, for [`orient`] to refuse.
pub(super) fn collapse_degenerate(mesh: &mut Mesh, notes: &mut Vec<Note>) -> Changed {
    let mut changed = Changed::new();
    let mut counts: BTreeMap<Shape, usize> = BTreeMap::new();
    let mut split = Vec::new();
    for index in 0..mesh.elements.len() {
        let old = mesh.elements[index];
        if !is_degenerate(&old) {
            continue;
        }
        let Some((first, second)) = collapse(&old) else { continue };
        mesh.elements[index] = first;
        let second = second.map(|second| {
            split.push(index as u32);
            mesh.elements.push(second);
            mesh.elements.len() as u32 - 1
        });
        if second.is_none() {
            *counts.entry(first.shape).or_default() += 1;
        }
        changed.insert(index as u32, (old, second));
    }
    notes.extend(counts.into_iter().map(|(shape, count)| Note::Collapsed { shape, count }));
    let Some(&first) = split.first() else { return changed };
    notes.push(Note::Split { count: split.len(), first: mesh.element_id(first as usize) });
    let second = (mesh.elements.len() - split.len()) as u32;
    for list in mesh.groups.values_mut() {
        let member = |e: &u32| list.binary_search(e).is_ok();
        let more: Vec<u32> = split.iter().zip(second..).filter(|(e, _)| member(e)).map(|(_, s)| s).collect();
        list.extend(more);
    }
    if !mesh.element_ids.is_empty() {
        let largest = mesh.element_ids.iter().copied().max().unwrap_or(0);
        // Numbers that cannot be continued are given up.
        match largest.checked_add(split.len() as u64) {
            Some(last) => mesh.element_ids.extend(largest + 1..=last),
            None => mesh.element_ids.clear(),
        }
    }
    changed
}

/// Renumbers the elements whose Jacobian is negative at all corners.
///
/// # Errors
/// The elements, by number, whose Jacobian is zero or of both signs.
pub(super) fn orient(mesh: &mut Mesh, notes: &mut Vec<Note>, changed: &mut Changed) -> Result<(), Fault> {
    let mut bad = Vec::new();
    let mut renumbered = Vec::new();
    for index in 0..mesh.elements.len() {
        let element = &mesh.elements[index];
        let shape = element.shape;
        let jacobian = |element: &Element| {
            let mut x = [[0.0; 3]; 8];
            for (x, &node) in x.iter_mut().zip(element.nodes()) {
                *x = mesh.nodes[node as usize];
            }
            scaled_jacobian(shape, &x[..shape.nodes()])
        };
        if jacobian(element) > FLAT {
            continue;
        }
        let other = turned(element);
        if jacobian(&other) > FLAT {
            if !mesh.faces.is_empty() {
                changed.entry(index as u32).or_insert((*element, None));
            }
            mesh.elements[index] = other;
            renumbered.push(index);
        } else {
            bad.push(mesh.element_id(index));
        }
    }
    if let Some(&first) = renumbered.first() {
        notes.push(Note::Turned { count: renumbered.len(), first: mesh.element_id(first) });
    }
    match bad.as_slice() {
        [] => Ok(()),
        [one] => Err(Fault::whole(format!(
            "element {one} is flat or partly inside out (its Jacobian is not of one sign); repair the mesh there"
        ))),
        [first, second, ..] => Err(Fault::whole(format!(
            "{} elements are flat or partly inside out (their Jacobian is not of one sign), among them {first} \
             and {second}; repair the mesh there",
            bad.len()
        ))),
    }
}

/// Makes the named faces, which number the sides of the elements as the file has them, fit the changed ones.
pub(super) fn renumber_sides(mesh: &mut Mesh, changed: &Changed) {
    if changed.is_empty() {
        return;
    }
    let mut faces = std::mem::take(&mut mesh.faces);
    for list in faces.values_mut() {
        let mut new = Vec::with_capacity(list.len());
        for &face in list.iter() {
            let Some((old, second)) = changed.get(&face.element) else {
                new.push(face);
                continue;
            };
            let side = old.shape.faces()[face.side as usize].iter();
            let nodes: Vec<u32> = side.map(|&k| old.nodes[k]).collect();
            for element in [Some(face.element), *second].into_iter().flatten() {
                let sides = mesh.elements[element as usize].shape.faces().len() as u8;
                let candidates = (0..sides).map(|side| Face { element, side });
                new.extend(candidates.filter(|&f| mesh.face_nodes(f).all(|n| nodes.contains(&n))));
            }
        }
        *list = new;
    }
    mesh.faces = faces;
}

/// Removes the nodes that no element uses; how many these are.
pub(crate) fn drop_unused_nodes(mesh: &mut Mesh) -> usize {
    let mut used = vec![false; mesh.nodes.len()];
    for element in &mesh.elements {
        for &node in element.nodes() {
            used[node as usize] = true;
        }
    }
    let unused = used.iter().filter(|&&u| !u).count();
    if unused == 0 {
        return 0;
    }
    if mesh.node_ids.is_empty() {
        mesh.node_ids = (1..=mesh.nodes.len() as u64).collect();
    }
    let mut index = vec![u32::MAX; used.len()];
    let mut next = 0;
    for (new, &used) in index.iter_mut().zip(&used) {
        if used {
            *new = next;
            next += 1;
        }
    }
    let mut flags = used.iter();
    mesh.nodes.retain(|_| flags.next() == Some(&true));
    let mut flags = used.iter();
    mesh.node_ids.retain(|_| flags.next() == Some(&true));
    mesh.node_ids = kept(std::mem::take(&mut mesh.node_ids));
    for element in &mut mesh.elements {
        for node in &mut element.nodes {
            *node = index[*node as usize];
        }
    }
    unused
}
