//! The outer faces: what holds nodes, what absorbs, what ties.

use crate::column::{Column, WIDTH};
use crate::model::{ModelError, centroid};
use crate::parts::base::BaseNode;
use crate::problem::{Base, Body, Side};
use crate::ties::Ties;
use std::collections::{BTreeMap, BTreeSet};
use tremolite_mesh::topology::{exterior_faces, match_faces, vector_areas};
use tremolite_mesh::{Face, Mesh};

/// Nodal matrices and conditions, on engine nodes.
#[derive(Clone, Debug, Default)]
pub struct Boundaries {
    /// Components of a node that are held.
    pub held: BTreeMap<u32, [bool; 3]>,
    /// Nodes of the base, the column's bottom included; empty for a base without dashpots.
    pub base: Vec<BaseNode>,
    /// Dashpots of absorbing sides \[N s/m\].
    pub sides: BTreeMap<u32, [f64; 6]>,
    /// Distance R used for the springs of the base \[m\].
    pub spring_distance: Option<f64>,
}

/// Faces of active elements on the outer planes.
#[derive(Clone, Debug, Default)]
pub struct OuterFaces {
    /// `[axis][low or high]`: x, y, z (base and top).
    pub planes: [[Vec<Face>; 2]; 3],
}

const NAMES: [[&str; 2]; 2] = [["xmin", "xmax"], ["ymin", "ymax"]];

/// Sorts the exterior faces of the active elements by the plane they lie on.
pub fn outer_faces(mesh: &Mesh, body_of: &[Option<usize>]) -> OuterFaces {
    let active: Vec<u32> = (0..body_of.len()).filter(|&e| body_of[e].is_some()).map(|e| e as u32).collect();
    let (low, high) = mesh.bounds();
    let mut planes = OuterFaces::default();
    for face in exterior_faces(mesh, Some(&active)) {
        for axis in 0..3 {
            let near = 1e-6 * (high[axis] - low[axis]);
            for (end, level) in [low[axis], high[axis]].into_iter().enumerate() {
                if mesh.face_nodes(face).all(|n| (mesh.nodes[n as usize][axis] - level).abs() <= near) {
                    planes.planes[axis][end].push(face);
                }
            }
        }
    }
    planes
}

/// The nodes of some faces, ascending.
pub fn nodes_of(mesh: &Mesh, faces: &[Face]) -> Vec<u32> {
    let nodes: BTreeSet<u32> = faces.iter().flat_map(|&face| mesh.face_nodes(face)).collect();
    nodes.into_iter().collect()
}

/// Ties the opposite nodes of periodic sides.
///
/// # Errors
/// If the two sides' nodes do not match.
pub fn tie_periodic(
    mesh: &Mesh,
    faces: &OuterFaces,
    sides: [Side; 2],
    ties: &mut Ties,
) -> Result<(), ModelError> {
    let (low, high) = mesh.bounds();
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

/// Whether the base needs the free field of a reference column.
pub fn needs_column(base: &Base) -> bool {
    matches!(base, Base::ViscousSpring { normal, tangential, .. } if *normal != 0.0 || *tangential != 0.0)
}

/// What the boundaries are made from.
pub struct Input<'a> {
    pub mesh: &'a Mesh,
    pub user_elements: usize,
    pub bodies: &'a [Body],
    pub body_of: &'a [Option<usize>],
    pub faces: &'a OuterFaces,
    pub base: Base,
    pub sides: [Side; 2],
    pub held: &'a [(u32, [bool; 3])],
    pub column: Option<&'a Column>,
    pub engine_node: &'a [u32],
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

/// Supports, dashpots and springs of all boundaries.
///
/// # Errors
/// If a plane on which something should act has no faces.
pub fn collect(input: Input) -> Result<Boundaries, ModelError> {
    let Input { mesh, bodies, faces, engine_node, .. } = input;
    let mut out = Boundaries::default();
    let engine = |n: u32| engine_node[n as usize];
    // Every face belongs to an active element, so its body is known.
    let body = |face: Face| input.body_of[face.element as usize].map(|b| &bodies[b]);
    let face_impedance = |face: Face| body(face).map_or((0.0, 0.0), impedances);

    for &(node, held) in input.held {
        if let Some(&e) = engine_node.get(node as usize).filter(|&&e| e != u32::MAX) {
            hold(&mut out.held, e, held);
        }
    }
    for axis in 0..2 {
        let side = input.sides[axis];
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
                    for (n, matrix) in nodal_matrices(mesh, faces, face_impedance) {
                        add(out.sides.entry(engine(n)).or_default(), &matrix);
                    }
                }
            }
        }
    }

    let base = &faces.planes[2][0];
    if input.base != Base::Free && base.is_empty() {
        return Err(ModelError::NoFaces("base"));
    }
    let springs = match input.base {
        Base::Free => return Ok(out),
        Base::Fixed => {
            for n in nodes_of(mesh, base) {
                hold(&mut out.held, engine(n), [true; 3]);
            }
            return Ok(out);
        }
        Base::Viscous => None,
        Base::ViscousSpring { normal, tangential, distance } => {
            let distance = distance.unwrap_or_else(|| scatter_distance(&input));
            out.spring_distance = Some(distance);
            Some((normal, tangential, distance))
        }
    };
    let spring_of = |face: Face| match (springs, body(face)) {
        (Some((normal, tangential, distance)), Some(body)) => {
            let g = body.material.moduli().mu;
            (normal * g / distance, tangential * g / distance)
        }
        _ => (0.0, 0.0),
    };
    let free_field = input.column.map(|c| engine(c.bottom[0]));
    let spring_matrices = nodal_matrices(mesh, base, spring_of);
    for (n, dashpot) in nodal_matrices(mesh, base, face_impedance) {
        let spring = spring_matrices.get(&n).copied().unwrap_or_default();
        out.base.push(BaseNode { node: engine(n), dashpot, spring, free_field, counted: true });
    }
    if let Some(column) = input.column {
        let (p, s) = impedances(&bodies[column.bottom_body]);
        let quarter = 0.25 * WIDTH * WIDTH;
        for n in column.bottom {
            out.base.push(BaseNode {
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
fn scatter_distance(input: &Input) -> f64 {
    let void: Vec<usize> = (0..input.user_elements).filter(|&e| input.body_of[e].is_none()).collect();
    let all: Vec<usize> = (0..input.user_elements).collect();
    let chosen = if void.is_empty() { &all } else { &void };
    let sum: f64 = chosen.iter().map(|&e| centroid(input.mesh, e as u32)[2]).sum();
    (sum / chosen.len() as f64 - input.mesh.bounds().0[2]).max(1.0)
}
