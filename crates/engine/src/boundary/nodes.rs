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
use crate::sheet::corners;
use std::collections::BTreeMap;
use tremolite_kernels::Line;
use tremolite_mesh::Face;

/// Parts of the boundaries, in their order, and what others need to know of them.
#[derive(Default)]
pub struct Members {
    pub members: Vec<Member>,
    /// Nodes of the base, those of slabs and columns included, without their places; empty for a base without dashpots.
    pub base: Vec<BaseNode>,
    /// Springs at free-field sides, by the axis that a side lies across.
    pub sides: [Vec<BaseNode>; 2],
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
    let mut all: Vec<(_, Vec<BaseNode>, _)> =
        vec![("springs of the base", counted, true), ("base of the free field", outside, false)];
    for side in std::mem::take(&mut out.sides) {
        let (counted, outside) = side.into_iter().partition(|node| node.counted);
        all.push(("springs of the sides", counted, true));
        all.push(("sides of the free field", outside, false));
    }
    let free_field = around.asked.waves();
    for (name, nodes, counted) in all {
        let level = |base: &BaseNode| around.level[base.node as usize];
        let pieces = match around.asked.free_field {
            Some(_) => compact(nodes, PIECE, level),
            None => pieces(nodes, PIECE, level),
        };
        for nodes in pieces {
            // Of the base levels of steps know by its own list.
            let stiff = |node: &BaseNode| (node.node, 0.5 * node.spring[..3].iter().sum::<f64>());
            let springs = match name.contains("base") {
                true => Vec::new(),
                false => nodes.iter().map(stiff).collect(),
            };
            let part = Box::new(BasePart::new(nodes, free_field.clone()));
            let line = Some(Line::Springs);
            let member = Member::of(Kind::Boundary, name, part);
            out.members.push(Member { life: Life::SHAKING, line, counted, springs, ..member });
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
            let centre = scatter_centre(around);
            let distance = distance.unwrap_or_else(|| distance_to(around, centre, 2, 0));
            out.spring_distance = Some(distance);
            if around.asked.side_springs {
                out.sides = side_springs(around, centre, [normal, tangential]);
            }
            Some((normal, tangential, distance))
        }
    };
    let spring_of = |face: Face| match springs {
        Some((normal, tangential, distance)) => spring(around, face, [normal, tangential], distance),
        None => (0.0, 0.0),
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

/// Spring coefficients α G/R \[Pa/m\] behind a face, along its normal and across.
fn spring(around: Surroundings, face: Face, [normal, tangential]: [f64; 2], distance: f64) -> (f64, f64) {
    let g = around.body(face).map_or(0.0, |body| body.material.moduli().mu);
    (normal * g / distance, tangential * g / distance)
}

/// Springs between the nodes of free-field sides and those of the slabs outside, and between slabs and columns at their ends, by the
/// axis that the side lies across. They act on u − u_ff, as those of the base do: without them nothing but the base resists
/// a permanent displacement of the block against the ground around it.
fn side_springs(around: Surroundings, centre: [f64; 3], factors: [f64; 2]) -> [Vec<BaseNode>; 2] {
    let mut sides: [BTreeMap<u32, BaseNode>; 2] = Default::default();
    let slabs = around.outside.slabs.iter().map(|slab| (&slab.sheet, true));
    let columns = around.outside.columns.iter().filter_map(|column| Some((column.sheet.as_ref()?, false)));
    for (sheet, counted) in slabs.chain(columns) {
        let distance = distance_to(around, centre, sheet.axis, sheet.end);
        let twins = sheet.twins.iter().filter(|twin| around.elements.stands(twin.1 as usize, Stage::Shaking));
        for &twin in twins {
            let stiff = |face: Face| spring(around, face, factors, distance);
            let matrices = nodal_matrices(around.mesh, &[twin.0], stiff);
            for corner in corners(around.mesh, twin) {
                let Some(matrix) = matrices.get(&corner.source) else { continue };
                let (node, leader) = (around.engine(corner.source), around.engine(corner.front));
                let place =
                    || Place { at: around.mesh.nodes[corner.source as usize], ..below(vec![(leader, 1.0)]) };
                let own = || BaseNode { counted, place: place(), ..alone(node, [0.0; 6]) };
                add(&mut sides[sheet.axis].entry(node).or_insert_with(own).spring, matrix);
            }
        }
    }
    sides.map(|side| side.into_values().collect())
}

/// From a place to an outer plane of the model \[m\].
fn distance_to(around: Surroundings, from: [f64; 3], axis: usize, end: usize) -> f64 {
    let (low, high) = around.faces.bounds;
    (from[axis] - [low, high][end][axis]).abs().max(1.0)
}

/// The centre of the excavated elements, or of all if none is.
fn scatter_centre(around: Surroundings) -> [f64; 3] {
    let mut own = vec![true; around.user_elements];
    around.elements.stand_ins.iter().for_each(|(stand_in, _)| own[*stand_in as usize] = false);
    let all: Vec<usize> = (0..around.user_elements).filter(|&e| own[e]).collect();
    let stands = |e: usize| around.elements.stands(e, Stage::Shaking);
    let void: Vec<usize> = all.iter().copied().filter(|&e| !stands(e)).collect();
    let chosen = if void.is_empty() { &all } else { &void };
    let mut sum = [0.0; 3];
    for &e in chosen {
        let at = centroid(around.mesh, e as u32);
        (0..3).for_each(|i| sum[i] += at[i]);
    }
    sum.map(|sum| sum / chosen.len() as f64)
}
