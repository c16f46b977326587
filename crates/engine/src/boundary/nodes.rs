//! The nodes of the base in the shaking: what absorbs there and what holds, of the model and of what stands outside its sides.

use super::base::{BaseNode, BasePart};
use super::face_shares::face_shares;
use super::far_field::{along_slab, between_corners};
use super::matrix::add;
use super::{Base, Side, Surroundings, Top, nodal_matrices};
use crate::assembly::{PIECE, pieces};
use crate::error::ModelError;
use crate::free_field::Place;
use crate::hexahedra::centroid;
use crate::life::{Life, Stage};
use crate::member::{Kind, Member};
use std::collections::BTreeMap;
use tremolite_kernels::Line;
use tremolite_mesh::Face;

/// Parts of the boundaries, in their order, and what others need to know of them.
#[derive(Default)]
pub struct Members {
    pub members: Vec<Member>,
    /// Nodes of the base, those of slabs and columns included, without their places; empty for a base without dashpots.
    pub base: Vec<BaseNode>,
    /// Distance R used for the springs of the base \[m\].
    pub spring_distance: Option<f64>,
}

/// The parts of boundaries that push with more than dashpots.
///
/// # Errors
/// If the plane of a base that should do something has no faces.
pub fn members(around: Surroundings) -> Result<Members, ModelError> {
    let mut out = base_nodes(around)?;
    if let Some(field) = &around.asked.free_field {
        field.prepare(&out.base.iter().map(|base| &base.place).collect::<Vec<_>>());
    }
    // Shares of faces go to the parts: the phases need none, and they are the most of a given field's memory beside its series.
    let whole = |base: &mut BaseNode| {
        let place = std::mem::take(&mut base.place);
        BaseNode { place, ..base.clone() }
    };
    let (counted, outside): (Vec<_>, Vec<_>) = out.base.iter_mut().map(whole).partition(|node| node.counted);
    let all: [(_, Vec<BaseNode>, _); 2] =
        [("springs of the base", counted, true), ("base of the free field", outside, false)];
    let free_field = around.asked.waves();
    for (name, nodes, counted) in all {
        let level = |base: &BaseNode| around.level[base.node as usize];
        let pieces = match around.asked.free_field {
            Some(_) => compact(nodes, PIECE, level),
            None => pieces(nodes, PIECE, level),
        };
        for nodes in pieces {
            let part = Box::new(BasePart::new(nodes, free_field.clone()));
            let line = Some(Line::Springs);
            let member = Member::of(Kind::Boundary, name, part);
            out.members.push(Member { life: Life::SHAKING, line, counted, ..member });
        }
    }
    Ok(out)
}

/// Nodes of a level together that lie near one another, in pieces of a size at most: points of faces between two pieces are asked for by
/// both.
fn compact(nodes: Vec<BaseNode>, size: usize, level: impl Fn(&BaseNode) -> u8) -> Vec<Vec<BaseNode>> {
    let mut of_level: BTreeMap<u8, Vec<BaseNode>> = BTreeMap::new();
    nodes.into_iter().for_each(|base| of_level.entry(level(&base)).or_default().push(base));
    let mut out = Vec::new();
    let mut left: Vec<Vec<BaseNode>> = of_level.into_values().rev().collect();
    while let Some(mut own) = left.pop() {
        if own.len() <= size {
            // As the engine's nodes lie in memory.
            own.sort_by_key(|base| base.node);
            out.push(own);
            continue;
        }
        let along = |axis: usize, pick: fn(f64, f64) -> f64, from: f64| {
            own.iter().map(|base| base.place.at[axis]).fold(from, pick)
        };
        let length = |axis| along(axis, f64::max, f64::NEG_INFINITY) - along(axis, f64::min, f64::INFINITY);
        let lengths = [length(0), length(1), length(2)];
        let longest = (0..3).fold(0, |most, axis| if lengths[axis] > lengths[most] { axis } else { most });
        let order = [longest, (longest + 1) % 3, (longest + 2) % 3];
        own.sort_by(|a, b| {
            let [a, b] = [a, b].map(|base| order.map(|axis| base.place.at[axis]));
            let compared = a.iter().zip(&b).map(|(a, b)| a.total_cmp(b));
            compared.fold(std::cmp::Ordering::Equal, std::cmp::Ordering::then)
        });
        let half = own.len().div_ceil(size) / 2 * size;
        let behind = own.split_off(half);
        left.extend([behind, own]);
    }
    out
}

/// Dashpots and springs of the base in the shaking, those of slabs and columns included.
fn base_nodes(around: Surroundings) -> Result<Members, ModelError> {
    let Surroundings { mesh, .. } = around;
    let engine = |n: u32| around.engine(n);
    let faces = &around.faces.planes[2][0];
    if around.asked.base != Base::Free && faces.is_empty() {
        return Err(ModelError::NoFaces("base"));
    }
    let mut out = Members::default();
    let springs = match around.asked.base {
        Base::Free | Base::Fixed => return Ok(out),
        Base::Viscous => None,
        Base::ViscousSpring { normal, tangential, distance } => {
            let distance = distance.unwrap_or_else(|| scatter_distance(around));
            out.spring_distance = Some(distance);
            Some((normal, tangential, distance))
        }
    };
    let spring_of = |face: Face| match (springs, around.body(face)) {
        (Some((normal, tangential, distance)), Some(body)) => {
            let g = body.material.moduli().mu;
            (normal * g / distance, tangential * g / distance)
        }
        _ => (0.0, 0.0),
    };
    let dashpots = |faces: &[Face]| nodal_matrices(mesh, faces, |face| around.impedance(face));
    let springs = |faces: &[Face]| nodal_matrices(mesh, faces, spring_of);
    let stiff = springs(faces);
    for (n, dashpot) in dashpots(faces) {
        let spring = stiff.get(&n).copied().unwrap_or_default();
        let bottoms = between_corners(around, mesh.nodes[n as usize]);
        out.base.push(BaseNode { node: engine(n), dashpot, spring, place: below(bottoms), counted: true });
    }
    for slab in &around.outside.slabs {
        let faces = around.of_sheet(&slab.sheet, 2, 0, Stage::Shaking);
        let stiff = springs(&faces);
        for (n, dashpot) in dashpots(&faces) {
            let spring = stiff.get(&n).copied().unwrap_or_default();
            let place = below(along_slab(around, slab, mesh.nodes[n as usize]));
            out.base.push(BaseNode { node: engine(n), dashpot, spring, place, counted: false });
        }
        for column in slab.columns.iter().flatten().filter_map(|&c| around.outside.columns[c].sheet.as_ref())
        {
            let faces = around.of_sheet(column, 2, 0, Stage::Shaking);
            out.base.extend(dashpots(&faces).into_iter().map(|(n, dashpot)| alone(engine(n), dashpot)));
        }
    }
    for column in &around.outside.columns {
        let (Some(ring), Some(layer)) = (column.rings.first(), column.layers.first()) else { continue };
        out.base.extend(ring.iter().map(|&n| alone(engine(n), around.quarter(layer))));
    }
    if around.asked.free_field.is_some() {
        given(around, &mut out.base);
    }
    Ok(out)
}

/// The place of a node above the bottoms of columns.
fn below(bottoms: Vec<(u32, f64)>) -> Place {
    Place { bottoms, ..Place::default() }
}

/// A node outside that has dashpots alone.
fn alone(node: u32, dashpot: [f64; 6]) -> BaseNode {
    BaseNode { node, dashpot, spring: [0.0; 6], place: Place::default(), counted: false }
}

/// Gives the nodes of the base their places in a given free field, and adds those of free-field sides and of a viscous top.
fn given(around: Surroundings, nodes: &mut Vec<BaseNode>) {
    let Surroundings { mesh, faces, .. } = around;
    let mut planes: Vec<&Vec<Face>> = (0..2)
        .filter(|&axis| around.asked.sides[axis] == Side::FreeField)
        .flat_map(|axis| &faces.planes[axis])
        .collect();
    if around.asked.top == Top::Viscous {
        planes.push(&faces.planes[2][1]);
    }
    let all: Vec<Face> = planes.iter().flat_map(|faces| faces.iter().copied()).collect();
    let known: BTreeMap<u32, usize> = nodes.iter().map(|node| node.node).zip(0..).collect();
    for (n, dashpot) in nodal_matrices(mesh, &all, |face| around.impedance(face)) {
        let node = around.engine(n);
        match known.get(&node) {
            Some(&k) => add(&mut nodes[k].dashpot, &dashpot),
            None => nodes.push(BaseNode { counted: true, ..alone(node, dashpot) }),
        }
    }
    planes.push(&faces.planes[2][0]);
    let mut places: BTreeMap<u32, Place> = BTreeMap::new();
    for faces in planes {
        for (n, of_face) in face_shares(mesh, faces, |face| around.lacking(face)) {
            let place = places.entry(around.engine(n)).or_default();
            place.shares.extend(of_face.shares);
            place.ends.extend(of_face.ends);
        }
    }
    let at: BTreeMap<u32, u32> = (0u32..).zip(around.engine_node).map(|(n, &engine)| (engine, n)).collect();
    for node in nodes {
        let of_faces = places.remove(&node.node).unwrap_or_default();
        node.place = Place { at: mesh.nodes[at[&node.node] as usize], ..of_faces };
    }
}

/// From the centre of the excavated elements (of all, if none is) down to the base \[m\].
fn scatter_distance(around: Surroundings) -> f64 {
    let mut own = vec![true; around.user_elements];
    around.elements.stand_ins.iter().for_each(|(stand_in, _)| own[*stand_in as usize] = false);
    let all: Vec<usize> = (0..around.user_elements).filter(|&e| own[e]).collect();
    let void: Vec<usize> = all.iter().copied().filter(|&e| !around.stands(e, Stage::Shaking)).collect();
    let chosen = if void.is_empty() { &all } else { &void };
    let sum: f64 = chosen.iter().map(|&e| centroid(around.mesh, e as u32)[2]).sum();
    (sum / chosen.len() as f64 - around.faces.bounds.0[2]).max(1.0)
}
