//! The outer faces: what holds nodes, what absorbs, what ties.

use crate::column::WIDTH;
use crate::error::ModelError;
use crate::hexahedra::centroid;
use crate::life::Stage;
use crate::model::Model;
use crate::outer_faces::nodes_of;
use crate::parts::base::BaseNode;
use crate::problem::{Base, Body, Side};
use crate::ties::Ties;
use std::collections::BTreeMap;
use tremolite_mesh::topology::{match_faces, vector_areas};
use tremolite_mesh::{Face, Mesh};

/// What holds and absorbs in a stage, on engine nodes.
#[derive(Clone, Debug, Default)]
pub struct Supports {
    /// Components of a node that are held.
    pub held: BTreeMap<u32, [bool; 3]>,
    /// Dashpots of absorbing sides \[N s/m\].
    pub dashpots: BTreeMap<u32, [f64; 6]>,
}

/// What the part at the base is made of.
#[derive(Clone, Debug, Default)]
pub struct BaseParts {
    /// Nodes of the base, the column's bottom included; empty for a base without dashpots.
    pub nodes: Vec<BaseNode>,
    /// Distance R used for the springs \[m\].
    pub spring_distance: Option<f64>,
}

const NAMES: [[&str; 2]; 2] = [["xmin", "xmax"], ["ymin", "ymax"]];

/// Ties the opposite nodes of periodic sides.
///
/// # Errors
/// If the two sides' nodes do not match.
pub fn tie_periodic(model: &Model, ties: &mut Ties) -> Result<(), ModelError> {
    let Model { mesh, faces, sides, .. } = model;
    let (low, high) = faces.bounds;
    let near = 1e-6 * (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max);
    for axis in 0..2 {
        if sides[axis] != Side::Periodic {
            continue;
        }
        let [a, b] = &faces.planes[axis];
        let [name_a, name_b] = NAMES[axis];
        if a.is_empty() || b.is_empty() {
            return Err(ModelError::NoFaces(if a.is_empty() { name_a } else { name_b }));
        }
        let pairs = match_faces(mesh, &nodes_of(mesh, a), &nodes_of(mesh, b), axis, near)
            .map_err(|reason| ModelError::Periodic { low: name_a, high: name_b, reason })?;
        for (a, b) in pairs {
            ties.join(a, b);
        }
    }
    Ok(())
}

/// Σ A (tangential I + (normal − tangential) n⊗n) by node, over faces with the two factors of each.
fn nodal_matrices(
    mesh: &Mesh,
    faces: &[Face],
    factors: impl Fn(Face) -> (f64, f64),
) -> BTreeMap<u32, [f64; 6]> {
    let mut matrices: BTreeMap<u32, [f64; 6]> = BTreeMap::new();
    for &face in faces {
        let (normal, tangential) = factors(face);
        for (node, a) in vector_areas(mesh, &[face]) {
            let area = (a[0] * a[0] + a[1] * a[1] + a[2] * a[2]).sqrt();
            if area == 0.0 {
                continue;
            }
            let n = a.map(|x| x / area);
            let matrix = matrices.entry(node).or_default();
            let pairs = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2)];
            for (m, (i, j)) in matrix.iter_mut().zip(pairs) {
                let identity = if i == j { tangential } else { 0.0 };
                *m += area * (identity + (normal - tangential) * n[i] * n[j]);
            }
        }
    }
    matrices
}

/// ρc_p and ρc_s of a body.
fn impedances(body: &Body) -> (f64, f64) {
    let (p, s) = body.material.moduli().wave_speeds(body.density);
    (body.density * p, body.density * s)
}

/// ρc_p and ρc_s behind a face. Every face belongs to an element of a body.
fn face_impedance(model: &Model, face: Face) -> (f64, f64) {
    model.body_of[face.element as usize].map_or((0.0, 0.0), |b| impedances(&model.bodies[b]))
}

/// What holds and absorbs in a stage. Before the shaking the base is fixed, and sides that are not periodic are rollers.
///
/// # Errors
/// If a plane on which something should act has no faces.
pub fn supports(model: &Model, stage: Stage) -> Result<Supports, ModelError> {
    let Model { mesh, faces, .. } = model;
    let mut out = Supports::default();
    let engine = |n: u32| model.engine_node[n as usize];
    for &(node, held) in &model.held {
        if let Some(&e) = model.engine_node.get(node as usize).filter(|&&e| e != u32::MAX) {
            hold(&mut out.held, e, held);
        }
    }
    for axis in 0..2 {
        let side = match (stage, model.sides[axis]) {
            (Stage::Shaking, side) | (_, side @ (Side::Periodic | Side::Fixed)) => side,
            (Stage::Before(_), _) => Side::Roller,
        };
        for (end, faces) in faces.planes[axis].iter().enumerate() {
            if side != Side::Free && faces.is_empty() {
                return Err(ModelError::NoFaces(NAMES[axis][end]));
            }
            let mut along = [false; 3];
            along[axis] = true;
            match side {
                Side::Free | Side::Periodic => {}
                Side::Fixed => {
                    for n in nodes_of(mesh, faces) {
                        hold(&mut out.held, engine(n), [true; 3]);
                    }
                }
                Side::Roller => {
                    for n in nodes_of(mesh, faces) {
                        hold(&mut out.held, engine(n), along);
                    }
                }
                Side::Viscous => {
                    for (n, matrix) in nodal_matrices(mesh, faces, |face| face_impedance(model, face)) {
                        add(out.dashpots.entry(engine(n)).or_default(), &matrix);
                    }
                }
            }
        }
    }
    let base = &faces.planes[2][0];
    if stage != Stage::Shaking || model.base == Base::Fixed {
        if base.is_empty() {
            return Err(ModelError::NoFaces("base"));
        }
        for n in nodes_of(mesh, base) {
            hold(&mut out.held, engine(n), [true; 3]);
        }
    }
    Ok(out)
}

/// Dashpots and springs of the base in the shaking, the column's included.
///
/// # Errors
/// If the plane of a base that should do something has no faces.
pub fn base(model: &Model) -> Result<BaseParts, ModelError> {
    let Model { mesh, bodies, .. } = model;
    let engine = |n: u32| model.engine_node[n as usize];
    let faces = &model.faces.planes[2][0];
    if model.base != Base::Free && faces.is_empty() {
        return Err(ModelError::NoFaces("base"));
    }
    let mut out = BaseParts::default();
    let springs = match model.base {
        Base::Free | Base::Fixed => return Ok(out),
        Base::Viscous => None,
        Base::ViscousSpring { normal, tangential, distance } => {
            let distance = distance.unwrap_or_else(|| scatter_distance(model));
            out.spring_distance = Some(distance);
            Some((normal, tangential, distance))
        }
    };
    let spring_of = |face: Face| match (springs, model.body_of[face.element as usize]) {
        (Some((normal, tangential, distance)), Some(body)) => {
            let g = bodies[body].material.moduli().mu;
            (normal * g / distance, tangential * g / distance)
        }
        _ => (0.0, 0.0),
    };
    let free_field = model.column.as_ref().map(|c| engine(c.bottom()[0]));
    let spring_matrices = nodal_matrices(mesh, faces, spring_of);
    for (n, dashpot) in nodal_matrices(mesh, faces, |face| face_impedance(model, face)) {
        let spring = spring_matrices.get(&n).copied().unwrap_or_default();
        out.nodes.push(BaseNode { node: engine(n), dashpot, spring, free_field, counted: true });
    }
    if let Some(column) = &model.column {
        let (p, s) = impedances(&bodies[column.bottom_body]);
        let quarter = 0.25 * WIDTH * WIDTH;
        for n in column.bottom() {
            out.nodes.push(BaseNode {
                node: engine(n),
                dashpot: [s * quarter, s * quarter, p * quarter, 0.0, 0.0, 0.0],
                spring: [0.0; 6],
                free_field: None,
                counted: false,
            });
        }
    }
    Ok(out)
}

fn hold(held: &mut BTreeMap<u32, [bool; 3]>, node: u32, more: [bool; 3]) {
    let now = held.entry(node).or_default();
    for i in 0..3 {
        now[i] |= more[i];
    }
}

fn add(to: &mut [f64; 6], more: &[f64; 6]) {
    for (a, b) in to.iter_mut().zip(more) {
        *a += b;
    }
}

/// From the centre of the excavated elements (of all, if none is) down to the base \[m\].
fn scatter_distance(model: &Model) -> f64 {
    let void: Vec<usize> = (0..model.user_elements).filter(|&e| model.body_of[e].is_none()).collect();
    let all: Vec<usize> = (0..model.user_elements).collect();
    let chosen = if void.is_empty() { &all } else { &void };
    let sum: f64 = chosen.iter().map(|&e| centroid(&model.mesh, e as u32)[2]).sum();
    (sum / chosen.len() as f64 - model.faces.bounds.0[2]).max(1.0)
}
