//! Nodes that boundaries let move as one.

use super::{Side, Surroundings};
use crate::column::SIDES;
use crate::error::ModelError;
use crate::outer_faces::near;
use crate::sheet::{Corner, Sheet, corners};
use crate::ties::Ties;
use std::collections::BTreeMap;
use tremolite_mesh::Mesh;
use tremolite_mesh::split::match_split;

/// Ties what stands one behind the other in slabs and columns, and the levels of columns.
pub fn tie_outside(around: Surroundings, ties: &mut Ties) {
    for sheet in around.outside.sheets() {
        for corner in sheet.twins.iter().flat_map(|&twin| corners(around.mesh, twin)) {
            ties.join(corner.front, corner.back);
        }
    }
    for slab in &around.outside.slabs {
        let pairs: Vec<Corner> =
            slab.sheet.twins.iter().flat_map(|&twin| corners(around.mesh, twin)).collect();
        for sheet in slab.columns.iter().flatten().filter_map(|&c| around.outside.columns[c].sheet.as_ref()) {
            let fronts = fronts(around.mesh, sheet);
            for pair in &pairs {
                let both = [pair.front, pair.back].map(|n| fronts.get(&n).map_or(&[][..], Vec::as_slice));
                let mut level = both.into_iter().flatten();
                if let Some(&first) = level.next() {
                    level.for_each(|&node| ties.join(first, node));
                }
            }
        }
    }
    for ring in around.outside.columns.iter().flat_map(|column| &column.rings) {
        ring[1..].iter().for_each(|&node| ties.join(ring[0], node));
    }
}

/// Nodes in front of a sheet by the node that each was made of.
fn fronts(mesh: &Mesh, sheet: &Sheet) -> BTreeMap<u32, Vec<u32>> {
    let mut fronts: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for corner in sheet.twins.iter().flat_map(|&twin| corners(mesh, twin)) {
        let known = fronts.entry(corner.source).or_default();
        if !known.contains(&corner.front) {
            known.push(corner.front);
        }
    }
    fronts
}

/// Ties the opposite nodes of periodic sides, and those outside them at the ends of slabs.
///
/// # Errors
/// If the two sides' nodes do not match.
pub fn tie_periodic(around: Surroundings, ties: &mut Ties) -> Result<(), ModelError> {
    let Surroundings { mesh, faces, places, .. } = around;
    let near = near(faces.bounds);
    for axis in 0..2 {
        if around.asked.sides[axis] != Side::Periodic {
            continue;
        }
        let [a, b] = &faces.planes[axis];
        let [name_a, name_b] = SIDES[axis];
        if a.is_empty() || b.is_empty() {
            return Err(ModelError::NoFaces(if a.is_empty() { name_a } else { name_b }));
        }
        let pairs = match_split(mesh, places, a, b, axis, near).map_err(|reason| ModelError::Periodic {
            low: name_a,
            high: name_b,
            reason,
        })?;
        let ends: Vec<_> = around
            .outside
            .slabs
            .iter()
            .filter(|slab| slab.sheet.axis != axis)
            .map(|slab| fronts(mesh, &slab.sheet))
            .collect();
        for (a, b) in pairs {
            ties.join(a, b);
            for (a, b) in ends.iter().filter_map(|fronts| fronts.get(&a).zip(fronts.get(&b))) {
                a.iter().zip(b).for_each(|(&a, &b)| ties.join(a, b));
            }
        }
    }
    Ok(())
}
