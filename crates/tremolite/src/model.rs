//! The checked model: immutable, in the engine's numbering.

use crate::boundary::{self, Boundaries};
use crate::column;
use crate::parts::loads::Load;
use crate::problem::{Body, Incident, Problem, Rayleigh, TimeStep};
use crate::ties::Ties;
use std::ops::Range;
use tremolite_laws::Isa;
use tremolite_laws::shapes::hex8::{BadShape, Hex8};
use tremolite_mesh::order::hilbert_order;
use tremolite_mesh::topology::Unmatched;
use tremolite_mesh::{Mesh, Shape};

/// Why a problem cannot be run.
#[derive(Debug, thiserror::Error)]
pub enum ModelError {
    #[error("no element belongs to a body: assign a material to at least one group")]
    Empty,
    #[error(
        "element {element} belongs to '{first}' and to '{second}': let each element be in one region only"
    )]
    Twice { element: u64, first: String, second: String },
    #[error("element {element} of '{body}' cannot be used: {reason}")]
    BadElement { element: u64, body: String, reason: BadShape },
    #[error("the sides {low} and {high} cannot be periodic: {reason}")]
    Periodic { low: &'static str, high: &'static str, reason: Unmatched },
    #[error(
        "no element face lies on the plane of the {0}, so nothing can act there: the outer sides must be plane"
    )]
    NoFaces(&'static str),
    #[error("{0}")]
    Column(String),
    #[error("'{body}' has density {density} kg/m³: it must be positive")]
    Density { body: String, density: f64 },
}

/// Elements that one thread works on together.
#[derive(Clone, Debug)]
pub struct Patch {
    pub body: usize,
    /// Indices into the model's elements, in the order of lanes.
    pub elements: Vec<u32>,
}

/// A checked problem, numbered for the engine.
pub struct Model {
    /// The mesh, with the reference column's nodes and elements behind its own.
    pub mesh: Mesh,
    /// How many of the mesh's nodes and elements are the user's.
    pub user_nodes: usize,
    pub user_elements: usize,
    pub bodies: Vec<Body>,
    /// Patches of the user's elements, then those of the reference column.
    pub patches: Vec<Patch>,
    pub user_patches: usize,
    /// Engine node → node of the mesh.
    pub mesh_node: Vec<u32>,
    /// Node of the mesh → engine node; `u32::MAX` if no active element uses it.
    pub engine_node: Vec<u32>,
    /// Engine nodes of the user's model; those of the column follow.
    pub counted: Range<usize>,
    /// Engine node → the engine node it moves with (itself if it is its own master).
    pub master: Vec<u32>,
    pub boundaries: Boundaries,
    pub incident: Option<Incident>,
    pub rayleigh: Rayleigh,
    /// Loads on engine nodes.
    pub loads: Vec<Load>,
    pub time_step: TimeStep,
    pub isa: Isa,
}

/// Corners of an element as a hexahedron, of which the other shapes are collapsed ones.
///
/// Collapsing keeps the patch test, the six rigid modes and the right row-sum masses, since the shape functions that
/// fall together add up to those of the smaller shape. A tetrahedron is the constant-strain one: it locks in bending
/// and at ν → ½. A wedge bends well along its axis and locks across its triangles; a pyramid is in between.
pub fn hex_nodes(mesh: &Mesh, element: usize) -> [u32; 8] {
    let e = &mesh.elements[element];
    let n = e.nodes;
    match e.shape {
        Shape::Hex8 => n,
        Shape::Wedge6 => [n[0], n[1], n[2], n[2], n[3], n[4], n[5], n[5]],
        Shape::Pyramid5 => [n[0], n[1], n[2], n[3], n[4], n[4], n[4], n[4]],
        Shape::Tet4 => [n[0], n[1], n[2], n[2], n[3], n[3], n[3], n[3]],
    }
}

/// Geometry of an element that was checked to be usable.
pub fn hex(mesh: &Mesh, element: usize) -> Result<Hex8, BadShape> {
    Hex8::new(hex_nodes(mesh, element).map(|n| mesh.nodes[n as usize]))
}

/// Elements a patch: enough patches to share out small models, large ones for locality.
fn patch_size(wanted: Option<usize>, elements: usize) -> usize {
    wanted.unwrap_or((elements / 64).clamp(64, 512)).max(1).next_multiple_of(8)
}

impl Model {
    /// Checks a problem and numbers it.
    ///
    /// # Errors
    /// The first thing that stands in the way of running it.
    pub fn new(problem: Problem) -> Result<Self, ModelError> {
        let Problem { mut mesh, mut bodies, .. } = problem;
        let (user_nodes, user_elements) = (mesh.nodes.len(), mesh.elements.len());
        let body_of = check_bodies(&mesh, &bodies)?;

        let faces = boundary::outer_faces(&mesh, &body_of);
        let mut ties = Ties::new(mesh.nodes.len());
        for (a, b) in &problem.ties {
            ties.join(*a, *b);
        }
        boundary::tie_periodic(&mesh, &faces, problem.sides, &mut ties)?;

        let user_bodies = bodies.len();
        let column = if boundary::needs_column(&problem.base) {
            Some(column::build(&mut mesh, &mut bodies, &body_of, &mut ties)?)
        } else {
            None
        };

        let mut patches = Vec::new();
        let mut user_patches = 0;
        let size = patch_size(problem.patch_elements, bodies.iter().map(|b| b.elements.len()).sum());
        for (b, body) in bodies.iter().enumerate() {
            let centroids: Vec<[f64; 3]> = body.elements.iter().map(|&e| centroid(&mesh, e)).collect();
            let order: Vec<u32> =
                hilbert_order(&centroids).into_iter().map(|i| body.elements[i as usize]).collect();
            patches.extend(order.chunks(size).map(|elements| Patch { body: b, elements: elements.to_vec() }));
            if b + 1 == user_bodies {
                user_patches = patches.len();
            }
        }

        // Nodes in the order in which the patches first touch them: a patch's nodes lie close in memory.
        let mut engine_node = vec![u32::MAX; mesh.nodes.len()];
        let mut mesh_node = Vec::new();
        let mut counted = 0..0;
        for (p, patch) in patches.iter().enumerate() {
            for &e in &patch.elements {
                for &n in mesh.elements[e as usize].nodes() {
                    if engine_node[n as usize] == u32::MAX {
                        engine_node[n as usize] = mesh_node.len() as u32;
                        mesh_node.push(n);
                    }
                }
            }
            if p + 1 == user_patches {
                counted = 0..mesh_node.len();
            }
        }
        let master: Vec<u32> = ties.masters(&mesh_node, &engine_node);
        let boundaries = boundary::collect(boundary::Input {
            mesh: &mesh,
            user_elements,
            bodies: &bodies,
            body_of: &body_of,
            faces: &faces,
            base: problem.base,
            sides: problem.sides,
            held: &problem.held,
            column: column.as_ref(),
            engine_node: &engine_node,
        })?;
        let loads = problem
            .loads
            .into_iter()
            .map(|mut load| {
                load.forces.retain_mut(|(node, _)| {
                    *node = engine_node.get(*node as usize).copied().unwrap_or(u32::MAX);
                    *node != u32::MAX
                });
                load
            })
            .collect();
        Ok(Model {
            mesh,
            user_nodes,
            user_elements,
            bodies,
            patches,
            user_patches,
            mesh_node,
            engine_node,
            counted,
            master,
            boundaries,
            incident: problem.incident,
            rayleigh: problem.rayleigh,
            loads,
            time_step: problem.time_step,
            isa: problem.isa,
        })
    }

    /// Bodies of the user, without the reference column's.
    pub fn user_bodies(&self) -> &[Body] {
        let count = self.patches[..self.user_patches].last().map_or(0, |p| p.body + 1);
        &self.bodies[..count]
    }

    /// An element by its number in the user's file, and the smallest group that holds it.
    pub fn element_name(&self, element: usize) -> String {
        let holds = |elements: &[u32]| elements.contains(&(element as u32));
        let groups = self.mesh.groups.iter().filter(|(_, elements)| holds(elements));
        let smallest = groups.min_by_key(|(_, elements)| elements.len()).map(|(name, _)| name);
        let name = smallest.or_else(|| self.bodies.iter().find(|b| holds(&b.elements)).map(|b| &b.name));
        let number = self.mesh.element_id(element);
        match name {
            Some(name) => format!("element {number} of '{name}'"),
            None => format!("element {number}"),
        }
    }
}

/// Mean of an element's nodes.
pub fn centroid(mesh: &Mesh, element: u32) -> [f64; 3] {
    let nodes = mesh.elements[element as usize].nodes();
    let mut sum = [0.0; 3];
    for &n in nodes {
        for i in 0..3 {
            sum[i] += mesh.nodes[n as usize][i];
        }
    }
    sum.map(|s| s / nodes.len() as f64)
}

/// The body of each element, none for void ones; every element of a body can be integrated.
fn check_bodies(mesh: &Mesh, bodies: &[Body]) -> Result<Vec<Option<usize>>, ModelError> {
    let mut body_of: Vec<Option<usize>> = vec![None; mesh.elements.len()];
    for (b, body) in bodies.iter().enumerate() {
        if body.density.is_nan() || body.density <= 0.0 {
            return Err(ModelError::Density { body: body.name.clone(), density: body.density });
        }
        for &e in &body.elements {
            let id = mesh.element_id(e as usize);
            if let Some(first) = body_of[e as usize] {
                let first = bodies[first].name.clone();
                return Err(ModelError::Twice { element: id, first, second: body.name.clone() });
            }
            body_of[e as usize] = Some(b);
            hex(mesh, e as usize).map_err(|reason| ModelError::BadElement {
                element: id,
                body: body.name.clone(),
                reason,
            })?;
        }
    }
    if body_of.iter().all(Option::is_none) {
        return Err(ModelError::Empty);
    }
    Ok(body_of)
}
