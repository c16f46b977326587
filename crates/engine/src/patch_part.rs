//! A patch as a part: its elements numbered among its nodes, what they weigh, and what of them a side is told.

use crate::error::ModelError;
use crate::extent::size_tensor;
use crate::hexahedra::{hex, hex_nodes};
use crate::life::Stage;
use crate::member::{Kind, Member};
use crate::model::{Elements, Model, Patch};
use crate::node_table::Domain;
use crate::parts::passed_on::PassedOn;
use crate::sheet;
use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use tremolite_kernels::{PoresOf, Quadrature};
use tremolite_laws::shapes::hex8::{Hex8, element_frequencies, turned};
use tremolite_mesh::Face;

/// The part of the patch of this number, with the mass of each of its nodes. `faces` are those that elements outside sides were made of: they pass
/// on to these what they feel.
pub fn solid(model: &Model, faces: &HashMap<u32, Face>, number: u32) -> Result<Member, ModelError> {
    let patch = &model.patches[number as usize];
    let body = &model.bodies[patch.body];
    let mut nodes: Vec<u32> = Vec::new();
    // By node; in a patch that takes over by element and corner as well.
    let mut local: BTreeMap<(usize, u32), u16> = BTreeMap::new();
    let mut corners = Vec::with_capacity(patch.elements.len());
    let mut geometry = Vec::with_capacity(patch.elements.len());
    let mut masses: Vec<f64> = Vec::new();
    let mut sides: BTreeSet<(u32, [u16; 2])> = BTreeSet::new();
    for (i, &e) in patch.elements.iter().enumerate() {
        let unusable = |reason| ModelError::BadElement {
            element: model.mesh.element_id(e as usize),
            body: body.name.clone(),
            reason,
        };
        let hex = model.elements.shape(&model.mesh, e).map_err(unusable)?;
        let mut corner = [0; 8];
        let mesh_nodes = hex_nodes(&model.mesh, e as usize);
        for k in 0..8 {
            let node = model.engine_node[mesh_nodes[k] as usize];
            let owner = if patch.takes_over { 1 + 8 * i + k } else { 0 };
            corner[k] = match local.entry((owner, node)) {
                Entry::Occupied(known) => *known.get(),
                Entry::Vacant(new) => {
                    let next = u16::try_from(nodes.len()).map_err(|_| ModelError::Patch {
                        body: body.name.clone(),
                        elements: patch.elements.len(),
                    })?;
                    nodes.push(node);
                    masses.push(0.0);
                    *new.insert(next)
                }
            };
            masses[corner[k] as usize] += body.density * hex.corner_volumes[k];
        }
        for pair in faces.get(&e).into_iter().flat_map(|&face| sheet::corners(&model.mesh, (face, e))) {
            let place = |node: u32| mesh_nodes.iter().position(|&n| n == node).map_or(0, |k| corner[k]);
            let source = model.engine_node[pair.source as usize];
            sides.insert((source, [place(pair.front), place(pair.back)]));
        }
        let (corner, hex) = match order(model, patch, e, &hex) {
            None | Some([0, 1, 2, 3, 4, 5, 6, 7]) => (corner, hex),
            Some(order) => {
                let hex = Hex8::new(order.map(|k| hex.corners[k])).map_err(unusable)?;
                (order.map(|k| corner[k]), hex)
            }
        };
        corners.push(corner);
        geometry.push(hex);
    }
    // What is made of another element is as viscous and cracks as that does, whatever its own thickness.
    let own = |&e: &u32| model.elements.shape(&model.mesh, model.elements.parents[e as usize]);
    let parents = || -> Vec<Hex8> { patch.elements.iter().filter_map(|e| own(e).ok()).collect() };
    let viscosity = viscosity(model, patch, parents);
    let outside = patch.elements.iter().any(|&e| e as usize >= model.user.elements);
    let sizes: Vec<[f64; 6]> = if outside { parents().iter().map(size_tensor).collect() } else { Vec::new() };
    let part = body.material.patch(
        body.quadrature,
        nodes,
        &corners,
        &geometry,
        &viscosity,
        &sizes,
        &pores(model, patch),
        model.scheme.isa,
    );
    let part = match sides.is_empty() {
        true => part,
        false => {
            let booked = sides.iter().all(|(node, _)| model.nodes.counts(*node as usize));
            Box::new(PassedOn::new(part, sides.into_iter().collect(), booked))
        }
    };
    let wet = patch.elements.iter().any(|&e| model.water.wets(e as usize));
    let initial = patch.takes_over || wet || (!model.elements.initial.is_empty() && !patch.life.is_later());
    let member = Member::of(Kind::Patch(number), body.name.clone(), part);
    let mut reads = member.reads.clone();
    reads.elements.extend(patch.elements.iter().filter_map(|e| model.elements.successors.get(e)));
    Ok(Member {
        body: Some(patch.body as u32),
        reads,
        masses,
        initial,
        life: patch.life,
        counted: patch.domain == Domain::Model,
        ..member
    })
}

/// Pores of each element whose water changes its pressure in the shaking; empty where that of none does.
fn pores(model: &Model, patch: &Patch) -> Vec<PoresOf> {
    let undrained = |e: &u32| model.water.undrained(*e as usize);
    match patch.life.holds(Stage::Shaking) && patch.elements.iter().any(|e| undrained(e).is_some()) {
        true => patch.elements.iter().map(|e| undrained(e).unwrap_or_default()).collect(),
        false => Vec::new(),
    }
}

/// 2b/ω_e of each element \[s\]: stress 2b/ω_e C:ε̇ damps the element's highest mode by the share b; empty without. What damps is the
/// rock's C alone: where water makes the highest mode faster, ω_u for ω_e, it takes 2b ω_u/ω_e².
fn viscosity(model: &Model, patch: &Patch, geometry: impl Fn() -> Vec<Hex8>) -> Vec<f64> {
    if !patch.viscous {
        return Vec::new();
    }
    let body = &model.bodies[patch.body];
    let Elements { parents, frequencies, .. } = &model.elements;
    let omegas: Vec<f64> = match patch.elements.iter().all(|&e| parents[e as usize] == e) {
        true => patch.elements.iter().map(|&e| frequencies[e as usize]).collect(),
        false => element_frequencies(&geometry(), body.material.stiffest(), body.density, body.quadrature),
    };
    let share = |e: u32| model.elements.viscosity[e as usize];
    if !patch.elements.iter().any(|&e| model.water.undrained(e as usize).is_some()) {
        return patch.elements.iter().zip(omegas).map(|(&e, omega)| 2.0 * share(e) / omega).collect();
    }
    let geometry = geometry();
    let wet = model.water.frequencies(body, &patch.elements, omegas.clone(), |i| Some(geometry[i].clone()));
    let each = patch.elements.iter().zip(omegas.iter().zip(wet));
    each.map(|(&e, (dry, wet))| 2.0 * share(e) / dry * (wet / dry)).collect()
}

/// The order of an element's corners for its kernel: that has the thickness along ζ, and the edges of bricks along x, y and z; nothing else goes by it.
fn order(model: &Model, patch: &Patch, e: u32, hex: &Hex8) -> Option<[usize; 8]> {
    match model.bodies[patch.body].quadrature {
        Quadrature::Layered(_) => Some(turned(model.elements.thickness[e as usize] as usize)),
        Quadrature::OnePoint if patch.bricks => hex.upright(),
        Quadrature::OnePoint | Quadrature::Full => None,
    }
}

/// Unit vectors of the axes, one a row, in which the law of an element of a patch sees strains and its history keeps tensors: x, y and z, or those
/// along the edges of a brick of several points.
pub fn law_axes(model: &Model, patch: &Patch, e: u32) -> [[f64; 3]; 3] {
    const GLOBAL: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    if !patch.bricks || model.bodies[patch.body].quadrature == Quadrature::OnePoint {
        return GLOBAL;
    }
    let own = hex(&model.mesh, e as usize).and_then(|hex| match order(model, patch, e, &hex) {
        Some(order) => Hex8::new(order.map(|k| hex.corners[k])),
        None => Ok(hex),
    });
    own.map_or(GLOBAL, |hex| hex.directions)
}
