//! Boundaries: what holds the outer faces, what absorbs there, what ties them, what enters.
//!
//! A boundary is a variant of [`Side`] or [`Base`] and what it does with its faces: components held, ties and dashpots
//! are filled in here; one that pushes with more is a part in a file below this one, made in [`members`].

pub mod base;

use crate::body::Body;
use crate::column::{Column, WIDTH};
use crate::error::ModelError;
use crate::hexahedra::centroid;
use crate::life::{Life, Stage};
use crate::member::Member;
use crate::outer_faces::{OuterFaces, nodes_of};
use crate::ties::Ties;
use base::{BaseNode, BasePart, add};
use std::collections::BTreeMap;
use tremolite_kernels::Line;
use tremolite_mesh::split::match_split;
use tremolite_mesh::topology::vector_areas;
use tremolite_mesh::{Face, Mesh};
use tremolite_motion::Motion;

/// What holds or leaves a pair of opposite vertical sides.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Side {
    /// No traction.
    #[default]
    Free,
    /// No displacement.
    Fixed,
    /// No displacement normal to the side.
    Roller,
    /// Dashpots ρc_p, ρc_s (Lysmer & Kuhlemeyer 1969).
    Viscous,
    /// Opposite nodes move as one.
    Periodic,
    /// A slab of the same ground stands outside, moves as the ground would without end, and passes on what it feels.
    FreeField,
}

impl Side {
    /// One of each, for tests that go over all: enter what is added.
    pub const EXAMPLES: [Side; 6] =
        [Side::Free, Side::Fixed, Side::Roller, Side::Viscous, Side::Periodic, Side::FreeField];
}

/// What acts on the top plane in the shaking.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Top {
    /// No traction: the surface of the ground.
    #[default]
    Free,
    /// Dashpots ρc_p, ρc_s: ground goes on above, and what its surface would send back is missing.
    Viscous,
}

/// What holds or drives the base.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Base {
    #[default]
    Free,
    Fixed,
    /// Dashpots, through which the incident wave enters.
    Viscous,
    /// Dashpots and springs α G/R on the motion scattered by the caverns.
    ViscousSpring {
        /// α_N (normal).
        normal: f64,
        /// α_T (tangential).
        tangential: f64,
        /// R \[m\], from the source of scattering to the base; by default from the centre of what is excavated.
        distance: Option<f64>,
    },
}

impl Base {
    /// Whether springs act, which need the free field of a reference column.
    pub fn has_springs(&self) -> bool {
        matches!(self, Base::ViscousSpring { normal, tangential, .. } if *normal != 0.0 || *tangential != 0.0)
    }
}

/// An incident wave, travelling up through the base.
#[derive(Clone)]
pub struct Incident {
    /// Motion in the model's axes.
    pub motion: Motion,
    /// Factor from that motion to the incident wave: ½ for an outcrop's.
    pub factor: f64,
}

/// What boundaries are made from: a checked model, as far as they need it.
#[derive(Clone, Copy)]
pub struct Surroundings<'a> {
    pub mesh: &'a Mesh,
    pub user_elements: usize,
    pub bodies: &'a [Body],
    /// The body of each element of the user's, none for void ones.
    pub body_of: &'a [Option<usize>],
    pub lives: &'a [Life],
    pub stand_ins: &'a [(u32, u32)],
    pub engine_node: &'a [u32],
    /// Of a stage.
    pub faces: &'a OuterFaces,
    /// Node of the mesh → one for all that interfaces part at its place.
    pub places: &'a [u32],
    pub base: Base,
    pub sides: [Side; 2],
    pub held: &'a [(u32, [bool; 3])],
    pub column: Option<&'a Column>,
    pub incident: Option<&'a Incident>,
}

impl Surroundings<'_> {
    /// Whether an element is there in the shaking.
    fn stands(&self, element: usize) -> bool {
        self.body_of[element].is_some() && self.lives[element].holds(Stage::Shaking)
    }

    fn engine(&self, node: u32) -> u32 {
        self.engine_node[node as usize]
    }

    /// The body behind a face. Every face belongs to an element of a body.
    fn body(&self, face: Face) -> Option<&Body> {
        self.body_of[face.element as usize].map(|b| &self.bodies[b])
    }

    /// ρc_p and ρc_s behind a face.
    fn impedance(&self, face: Face) -> (f64, f64) {
        self.body(face).map_or((0.0, 0.0), impedances)
    }
}

/// What holds and absorbs in a stage, on engine nodes.
#[derive(Clone, Debug, Default)]
pub struct Supports {
    /// Components of a node that are held.
    pub held: BTreeMap<u32, [bool; 3]>,
    /// Dashpots of absorbing sides \[N s/m\].
    pub dashpots: BTreeMap<u32, [f64; 6]>,
}

/// Parts of the boundaries, in their order, and what others need to know of them.
#[derive(Default)]
pub struct Members {
    pub members: Vec<Member>,
    /// Nodes of the base, the column's bottom included; empty for a base without dashpots.
    pub base: Vec<BaseNode>,
    /// Distance R used for the springs of the base \[m\].
    pub spring_distance: Option<f64>,
}

const NAMES: [[&str; 2]; 2] = [["xmin", "xmax"], ["ymin", "ymax"]];

/// Ties the opposite nodes of periodic sides.
///
/// # Errors
/// If the two sides' nodes do not match.
pub fn tie_periodic(around: Surroundings, ties: &mut Ties) -> Result<(), ModelError> {
    let Surroundings { mesh, faces, places, sides, .. } = around;
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
        let pairs = match_split(mesh, places, a, b, axis, near).map_err(|reason| ModelError::Periodic {
            low: name_a,
            high: name_b,
            reason,
        })?;
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

/// What holds and absorbs in a stage. Before the shaking the base is fixed, the column's too, and sides that are neither
/// periodic nor fixed are rollers.
///
/// # Errors
/// If a plane on which something should act has no faces.
pub fn supports(around: Surroundings, stage: Stage) -> Result<Supports, ModelError> {
    let Surroundings { mesh, faces, .. } = around;
    let mut out = Supports::default();
    let engine = |n: u32| around.engine(n);
    for &(node, held) in around.held {
        if let Some(&e) = around.engine_node.get(node as usize).filter(|&&e| e != u32::MAX) {
            hold(&mut out.held, e, held);
        }
    }
    for axis in 0..2 {
        let side = match (stage, around.sides[axis]) {
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
                Side::Free | Side::Periodic | Side::FreeField => {}
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
                    for (n, matrix) in nodal_matrices(mesh, faces, |face| around.impedance(face)) {
                        add(out.dashpots.entry(engine(n)).or_default(), &matrix);
                    }
                }
            }
        }
    }
    let base = &faces.planes[2][0];
    if stage != Stage::Shaking || around.base == Base::Fixed {
        if base.is_empty() {
            return Err(ModelError::NoFaces("base"));
        }
        let column = around.column.filter(|_| stage != Stage::Shaking);
        let below = column.iter().flat_map(|column| column.bottom());
        for n in nodes_of(mesh, base).into_iter().chain(below) {
            hold(&mut out.held, engine(n), [true; 3]);
        }
    }
    Ok(out)
}

/// The parts of boundaries that push with more than dashpots.
///
/// # Errors
/// If the plane of a base that should do something has no faces.
pub fn members(around: Surroundings) -> Result<Members, ModelError> {
    let mut out = base_nodes(around)?;
    if !out.base.is_empty() {
        let incident = around.incident.map(|i| (i.motion.clone(), i.factor));
        let part = Box::new(BasePart::new(out.base.clone(), incident));
        let line = Some(Line::Springs);
        out.members.push(Member { life: Life::SHAKING, line, ..Member::new("springs of the base", part) });
    }
    Ok(out)
}

/// Dashpots and springs of the base in the shaking, the column's included.
fn base_nodes(around: Surroundings) -> Result<Members, ModelError> {
    let Surroundings { mesh, bodies, .. } = around;
    let engine = |n: u32| around.engine(n);
    let faces = &around.faces.planes[2][0];
    if around.base != Base::Free && faces.is_empty() {
        return Err(ModelError::NoFaces("base"));
    }
    let mut out = Members::default();
    let springs = match around.base {
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
    let free_field = around.column.map(|c| engine(c.bottom()[0]));
    let spring_matrices = nodal_matrices(mesh, faces, spring_of);
    for (n, dashpot) in nodal_matrices(mesh, faces, |face| around.impedance(face)) {
        let spring = spring_matrices.get(&n).copied().unwrap_or_default();
        out.base.push(BaseNode { node: engine(n), dashpot, spring, free_field, counted: true });
    }
    if let Some(column) = around.column {
        let (p, s) = impedances(&bodies[column.bottom_body]);
        let quarter = 0.25 * WIDTH * WIDTH;
        for n in column.bottom() {
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

/// From the centre of the excavated elements (of all, if none is) down to the base \[m\].
fn scatter_distance(around: Surroundings) -> f64 {
    let mut own = vec![true; around.user_elements];
    around.stand_ins.iter().for_each(|(stand_in, _)| own[*stand_in as usize] = false);
    let all: Vec<usize> = (0..around.user_elements).filter(|&e| own[e]).collect();
    let void: Vec<usize> = all.iter().copied().filter(|&e| !around.stands(e)).collect();
    let chosen = if void.is_empty() { &all } else { &void };
    let sum: f64 = chosen.iter().map(|&e| centroid(around.mesh, e as u32)[2]).sum();
    (sum / chosen.len() as f64 - around.faces.bounds.0[2]).max(1.0)
}
