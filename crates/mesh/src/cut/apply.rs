//! Moves the nodes of a mesh onto a plane and parts its elements.

use std::collections::{BTreeMap, BTreeSet};

use super::curve::length;
use super::path::{Way, width};
use super::section::{Section, ends, key, renamed};
use crate::mesh::{Element, Shape};
use crate::{Face, Mesh, quality};

/// What was done.
pub(super) struct Applied {
    /// Elements whose nodes moved, or that were parted, with the parts, ascending.
    pub changed: Vec<u32>,
    /// Greatest way of a node \[m\].
    pub moved: f64,
    /// Elements that were parted, by the element that their second piece became.
    parted: BTreeMap<u32, u32>,
}

impl Applied {
    /// The element that one is a part of, or itself.
    pub fn origin(&self, element: u32) -> u32 {
        self.parted.get(&element).copied().unwrap_or(element)
    }
}

/// Moves the points of a section and parts the elements along its way.
pub(super) fn apply(
    mesh: &mut Mesh,
    section: &Section,
    way: &Way,
    moves: &BTreeMap<u32, [f64; 2]>,
) -> Applied {
    let mut changed: BTreeSet<u32> = BTreeSet::new();
    for (&p, shift) in moves {
        for &n in &section.columns[p as usize] {
            let x = &mut mesh.nodes[n as usize];
            (x[0], x[2]) = (x[0] + shift[0], x[2] + shift[1]);
        }
        for &c in &section.round[p as usize] {
            changed.extend(&section.cells[c as usize].elements);
        }
    }
    let mut pieces: BTreeMap<u32, u32> = BTreeMap::new();
    let mut old: BTreeMap<u32, Element> = BTreeMap::new();
    for &[p, q] in &way.steps {
        if section.edges.contains_key(&key(p, q)) {
            continue;
        }
        let Some(c) = section.shared(p, q) else { continue };
        let cell = &section.cells[c as usize];
        for &e in &cell.elements {
            let whole = mesh.elements[e as usize];
            let Some((lower, upper)) = ends(mesh, &whole) else { continue };
            let places = [p, q].map(|p| {
                lower.iter().position(|n| section.columns[p as usize].contains(n)).unwrap_or_default()
            });
            let from = places[0];
            let wedge = |k: [usize; 3]| {
                let [a, b, c] = k.map(|k| (from + k) % 4);
                // The first triangle is seen from inside.
                Element::new(Shape::Wedge6, &[lower[a], lower[c], lower[b], upper[a], upper[c], upper[b]])
            };
            let other = mesh.elements.len() as u32;
            mesh.elements[e as usize] = wedge([0, 1, 2]);
            mesh.elements.push(wedge([0, 2, 3]));
            old.insert(e, whole);
            pieces.insert(e, other);
            changed.extend([e, other]);
        }
    }
    for list in mesh.groups.values_mut() {
        let more: Vec<u32> = list.iter().filter_map(|e| pieces.get(e).copied()).collect();
        list.extend(more);
        list.sort_unstable();
    }
    let mut faces = std::mem::take(&mut mesh.faces);
    for list in faces.values_mut() {
        let new = |face: &Face| match (old.get(&face.element), pieces.get(&face.element)) {
            (Some(whole), Some(&other)) => renamed(mesh, *face, whole, [face.element, other]),
            _ => vec![*face],
        };
        *list = list.iter().flat_map(new).collect();
        list.sort_unstable();
    }
    mesh.faces = faces;
    let moved = moves.values().map(|way| length(*way)).fold(0.0, f64::max);
    let parted = pieces.into_iter().map(|(e, piece)| (piece, e)).collect();
    Applied { changed: changed.into_iter().collect(), moved, parted }
}

/// How good a cut mesh is: the smaller of its worst scaled Jacobian, against what is wanted, and of the smallest width of an element's
/// section over that before. Elements that were not cut do not count.
pub(super) fn score(before: &Mesh, after: &Mesh, applied: &Applied) -> f64 {
    let jacobian = quality::summary_of(after, applied.changed.iter().copied()).min_scaled_jacobian;
    let smallest = |mesh: &Mesh| {
        let here = applied.changed.iter().filter(|e| (**e as usize) < mesh.elements.len());
        let widths = here.filter_map(|&e| {
            let (lower, _) = ends(mesh, &mesh.elements[e as usize])?;
            let shape = lower.iter().map(|&n| [mesh.nodes[n as usize][0], mesh.nodes[n as usize][2]]);
            Some(width(&shape.collect::<Vec<_>>()))
        });
        widths.fold(f64::INFINITY, f64::min)
    };
    (0.5 * jacobian).min(smallest(after) / smallest(before))
}
