//! The natural axis of layered elements that leads through the lining's thickness.

use crate::body::Body;
use crate::boundary::{Boundaries, Side};
use crate::error::ModelError;
use crate::hexahedra::hex;
use crate::interface::Seam;
use crate::model::Elements;
use found::{Found, bad, usable};
use std::collections::{BTreeMap, BTreeSet};
use tremolite_kernels::{Points, Quadrature};
use tremolite_laws::shapes::hex8::BadShape;
use tremolite_mesh::{Face, Mesh};

mod found;

/// Of each element the axis through its thickness, where its body is layered; else 2.
///
/// From each element ways lead along its natural axes, from face to opposite face, until the layered elements end; the shortest is
/// through the thickness, and interfaces at its ends speak for it. Ways that come back, or end at a side of the model that is a cut
/// and no free surface, count for nothing, unless nothing else tells in all that hangs together. Where no way is clearly the
/// shortest, or the shortest leads through elements that have a clearly shorter one, as where walls meet, an element has the axis of
/// a neighbour: any is as good there, and integrates elastic stress exactly; of several its shape chooses. Elements that take over
/// from others, and those outside sides, have the axis of what they were made of.
///
/// # Errors
/// The first element whose thickness is not to be told, or lies across that of its neighbour.
pub fn axes(
    mesh: &Mesh,
    bodies: &[Body],
    user_elements: usize,
    elements: &Elements,
    seams: &[Seam],
    asked: &Boundaries,
) -> Result<Vec<u8>, ModelError> {
    let Elements { parents, successors, .. } = elements;
    let mut axes = vec![2; mesh.elements.len()];
    let layered = || bodies.iter().filter(|body| matches!(body.quadrature, Quadrature::Layered(_)));
    if layered().next().is_none() {
        return Ok(axes);
    }
    let mut found = Found {
        mesh,
        bounds: mesh.bounds(),
        cut: asked.sides.map(|side| side != Side::Free),
        held: asked.held.iter().copied().collect(),
        body_of: BTreeMap::new(),
        lengths: BTreeMap::new(),
        sharing: BTreeMap::new(),
        neighbours: BTreeMap::new(),
        axis: BTreeMap::new(),
    };
    for body in layered() {
        let own = |e: &u32| (*e as usize) < user_elements && !successors.contains_key(e);
        for &element in body.elements.iter().filter(|e| own(e)) {
            found.add(element, body)?;
        }
    }
    let beside: BTreeSet<Face> = seams
        .iter()
        .filter(|seam| seam.of.is_none())
        .flat_map(|seam| seam.faces.iter().flatten().copied())
        .collect();
    found.meet();
    // Between cuts alone lie pieces such as an element on its own between supports.
    for cuts in [true, false] {
        found.tell(&beside, cuts)?;
        found.ask_neighbours();
    }
    if let Some(&element) = found.body_of.keys().find(|e| !found.axis.contains_key(e)) {
        let reason =
            "the ways through it are about equally long, and neither an interface nor a neighbour tells";
        return Err(found.refusal(element, reason.to_owned()));
    }
    for (element, axis) in &found.axis {
        axes[*element as usize] = *axis as u8;
    }
    for body in layered() {
        for &e in &body.elements {
            let mut first = e;
            while let Some(&earlier) = successors.get(&first) {
                first = earlier;
            }
            let axis = match (first as usize) < user_elements {
                true => axes[first as usize] as usize,
                false => alike(mesh, parents[first as usize], axes[parents[first as usize] as usize], e),
            };
            axes[e as usize] = axis as u8;
            // Points at the faces of an element may lie where those of 2×2×2 points do not.
            let points = Points { quadrature: body.quadrature, axis };
            let hex = usable(mesh, e, body)?;
            let least = points.weights(&hex).into_iter().fold(f64::INFINITY, f64::min);
            if least < -1e-12 * hex.volume {
                return Err(bad(mesh, e, body, BadShape::Inverted { determinant: least }));
            }
        }
    }
    Ok(axes)
}

/// The axis of an element that lies along that of another.
fn alike(mesh: &Mesh, other: u32, axis: u8, element: u32) -> usize {
    let (Ok(other), Ok(own)) = (hex(mesh, other as usize), hex(mesh, element as usize)) else { return 2 };
    let along = |k: usize| -> f64 {
        (0..3).map(|i| own.directions[k][i] * other.directions[axis as usize][i]).sum::<f64>().abs()
    };
    (0..3).max_by(|&a, &b| along(a).total_cmp(&along(b))).unwrap_or(2)
}

#[cfg(test)]
mod tests;
