//! The checked model: immutable, in the engine's numbering.

mod draft;
mod elements;
mod linked;
mod numbering;
mod outside;
mod patches;

pub use elements::Elements;
pub use outside::Outside;
pub use patches::Patch;

use crate::body::Body;
use crate::bolts::BoltSet;
use crate::boundary::{Boundaries, Surroundings};
use crate::error::ModelError;
use crate::interface::Seam;
use crate::levels::Levels;
use crate::life::Stage;
use crate::node_table::{Domain, Nodes};
use crate::outer_faces::OuterFaces;
use crate::parts::loads::Load;
use crate::problem::{MakePart, Problem, Rayleigh, TimeStep};
use crate::rims::Joint;
use crate::traction::Traction;
use crate::water::Water;
use draft::Draft;
use numbering::Numbering;
use std::sync::Arc;
use tremolite_kernels::Points;
use tremolite_laws::Isa;
use tremolite_mesh::Mesh;

/// A checked problem, numbered for the engine.
#[derive(Clone)]
pub struct Model {
    /// The mesh, with the nodes and elements of slabs and columns behind its own.
    pub mesh: Mesh,
    /// How much of mesh and bodies is the user's.
    pub user: Counts,
    /// Those of the user, then of slabs, then of columns.
    pub bodies: Vec<Body>,
    /// What is known of each element of the mesh.
    pub elements: Elements,
    pub patches: Vec<Patch>,
    /// Engine node → node of the mesh.
    pub mesh_node: Vec<u32>,
    /// Node of the mesh → engine node; `u32::MAX` if no active element uses it.
    pub engine_node: Vec<u32>,
    /// What is known of each engine node.
    pub nodes: Nodes,
    /// Faces on the outer planes of the user's elements that are there in the shaking.
    pub faces: OuterFaces,
    /// Interfaces, split: those of the user, then what of them runs through slabs.
    pub seams: Vec<Seam>,
    /// Nodes that interfaces part.
    pub parted: Parted,
    /// Bolts, cut where they leave an element.
    pub bolts: Vec<BoltSet>,
    /// How many of its bodies are the user's, and how many those with what stands outside sides in slabs.
    pub domains: [usize; 2],
    /// What its boundaries are asked to do.
    pub boundaries: Boundaries,
    /// Ground outside its sides.
    pub outside: Outside,
    /// Water in the pores of its ground, said of slabs and columns as well.
    pub water: Water,
    /// What acts on it beside them.
    pub loading: Loading,
    /// How it is advanced.
    pub scheme: Scheme,
}

/// How many there are of the user's; what stands outside the sides lies behind them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Counts {
    /// Of the mesh.
    pub nodes: usize,
    /// Of the mesh, void ones included.
    pub elements: usize,
    pub bodies: usize,
}

/// Nodes of the mesh that were one before interfaces parted them.
#[derive(Clone, Debug, Default)]
pub struct Parted {
    /// Node of the mesh → one for all that interfaces part at its place; of the user's nodes.
    pub places: Vec<u32>,
    /// Copies of nodes that move as one while elements on both sides stand, at rims of interfaces.
    pub joints: Vec<Joint>,
}

/// What acts on a model, beside what its boundaries do.
#[derive(Clone)]
pub struct Loading {
    /// Acceleration \[m/s²\] along −z with which masses weigh down before the shaking.
    pub gravity: f64,
    /// On faces before the shaking.
    pub tractions: Vec<Traction>,
    /// Loads on engine nodes.
    pub loads: Vec<Load>,
    /// Parts of the program's own.
    pub parts: Vec<MakePart>,
}

/// How a model is advanced in time.
#[derive(Clone, Copy, Debug)]
pub struct Scheme {
    pub rayleigh: Rayleigh,
    pub time_step: TimeStep,
    /// Instructions that kernels are compiled for.
    pub isa: Isa,
    /// Elements a patch, if that is wished.
    pub patch_elements: Option<usize>,
}

/// Patches, and the nodes in the order in which these touch them.
struct Cut {
    patches: Vec<Patch>,
    numbering: Numbering,
}

/// Cuts a model into patches; its bodies are the user's and those of slabs up to these numbers.
fn cut(
    whole: (&Mesh, &[Body], &Elements),
    levels: &Levels,
    [users, slabs]: [usize; 2],
    wanted: Option<usize>,
) -> Cut {
    let patches = patches::cut(whole, levels, wanted, |body| match body {
        body if body < users => Domain::Model,
        body if body < slabs => Domain::Slab,
        _ => Domain::Column,
    });
    let numbering = Numbering::of(whole.0, &patches, levels);
    Cut { patches, numbering }
}

impl Model {
    /// Checks a problem and numbers it.
    ///
    /// # Errors
    /// The first thing that stands in the way of running it.
    pub fn new(problem: Problem) -> Result<Arc<Self>, ModelError> {
        let elements = Elements {
            lives: problem.lives,
            stand_ins: problem.stand_ins,
            successors: problem.successors.into_iter().collect(),
            initial: problem.initial,
            ..Elements::default()
        };
        let mut draft = Draft::of(problem.mesh, problem.bodies, elements, problem.tractions)?;
        let mut water = problem.water;
        water.check(&draft.mesh, &draft.elements.successors)?;
        let mut boundaries = Boundaries {
            base: problem.base,
            sides: problem.sides,
            side_springs: problem.side_springs,
            top: problem.top,
            bed: problem.bed,
            prescribed: problem.prescribed,
            held: problem.held,
            ties: problem.ties,
            incident: problem.incident,
            free_field: problem.free_field,
        };
        boundaries.check()?;
        let grounds = draft.grounds(&boundaries, &problem.interfaces);
        let sides_of = problem.interfaces.iter().map(|interface| interface.sides.clone()).collect();
        draft.part(problem.interfaces)?;
        boundaries.held = draft.at_copies(boundaries.held);
        let user = draft.counts();
        let faces = OuterFaces::of(&draft.mesh, draft.mesh.bounds(), &draft.elements.shaken());
        let bolts = draft.cut(problem.bolts);
        let (outside, slab_bodies) = draft.add_outside(&boundaries, faces.bounds, sides_of, grounds)?;
        draft.finish(user.elements, &boundaries)?;
        let Draft { mesh, bodies, mut elements, tractions, seams, parted, origin } = draft;
        elements.frequencies = elements::frequencies(&mesh, &bodies, &elements);
        water.spread(&mesh, user.nodes, &elements.parents, &origin, outside.sheets());
        let domains = [user.bodies, slab_bodies];
        let whole = (&mesh, &bodies[..], &elements);
        let Cut { patches, numbering } = cut(whole, &Levels::one(), domains, problem.patch_elements);
        let loads = numbering.of_loads(problem.loads);
        let Numbering { mesh_node, engine_node, nodes } = numbering;
        Ok(Arc::new(Model {
            mesh,
            user,
            bodies,
            elements,
            patches,
            mesh_node,
            engine_node,
            nodes,
            faces,
            seams,
            parted,
            bolts,
            boundaries,
            outside,
            water,
            loading: Loading { gravity: problem.gravity, tractions, loads, parts: problem.parts },
            domains,
            scheme: Scheme {
                rayleigh: problem.rayleigh,
                time_step: problem.time_step,
                isa: problem.isa,
                patch_elements: problem.patch_elements,
            },
        }))
    }

    /// The same model with these levels of steps: cut into patches and numbered by them.
    #[must_use]
    pub fn at_levels(&self, levels: &Levels) -> Arc<Self> {
        let whole = (&self.mesh, &self.bodies[..], &self.elements);
        let Cut { patches, numbering } = cut(whole, levels, self.domains, self.scheme.patch_elements);
        let mut loads = self.loading.loads.clone();
        for (node, _) in loads.iter_mut().flat_map(|load| &mut load.forces) {
            *node = self.mesh_node[*node as usize];
        }
        let loads = numbering.of_loads(loads);
        let Numbering { mesh_node, engine_node, nodes } = numbering;
        let loading = Loading { loads, ..self.loading.clone() };
        Arc::new(Model { patches, mesh_node, engine_node, nodes, loading, ..self.clone() })
    }

    /// Whether an element stands in a stage: one of the user's, of a slab or of a column.
    pub fn stands(&self, element: usize, stage: Stage) -> bool {
        self.elements.stands(element, stage)
    }

    /// The user's elements that are there in a stage, ascending.
    pub fn standing(&self, stage: Stage) -> Vec<u32> {
        (0..self.user.elements).filter(|&e| self.stands(e, stage)).map(|e| e as u32).collect()
    }

    /// What boundaries are made from, with the outer faces of a stage.
    pub fn surroundings<'a>(&'a self, faces: &'a OuterFaces) -> Surroundings<'a> {
        Surroundings {
            mesh: &self.mesh,
            user_elements: self.user.elements,
            bodies: &self.bodies,
            elements: &self.elements,
            engine_node: &self.engine_node,
            level: &self.nodes.level,
            faces,
            places: &self.parted.places,
            asked: &self.boundaries,
            outside: &self.outside,
            water: &self.water,
        }
    }

    /// The elements of a body that stand in the shaking, of slabs and columns as well.
    pub fn lasting(&self, body: &Body) -> Vec<u32> {
        body.elements.iter().copied().filter(|&e| self.stands(e as usize, Stage::Shaking)).collect()
    }

    /// What stands in a stage where an element is or will be: itself, or its stand-in.
    pub fn standing_at(&self, element: usize, stage: Stage) -> Option<usize> {
        let own = || (element, element as u32);
        let stand_ins = self.elements.stand_ins.iter().filter(|(_, of)| *of as usize == element);
        let mut all = std::iter::once(own()).chain(stand_ins.map(|(stand_in, of)| (*stand_in as usize, *of)));
        all.find(|(e, _)| self.stands(*e, stage)).map(|(e, _)| e)
    }

    /// The highest frequency of each of some elements of a body alone in the shaking \[rad/s\], water included.
    pub fn frequencies(&self, body: &Body, elements: &[u32]) -> Vec<f64> {
        let dry = elements.iter().map(|&e| self.elements.frequencies[e as usize]).collect();
        let shape = |i: usize| elements::vibrating(&self.mesh, &self.elements, elements[i]);
        self.water.frequencies(body, elements, dry, shape)
    }

    /// Where the law of a body's element is evaluated.
    pub fn points(&self, body: &Body, element: u32) -> Points {
        Points { quadrature: body.quadrature, axis: self.elements.thickness[element as usize] as usize }
    }

    /// Interfaces of the user, without what of them runs through slabs.
    pub fn user_seams(&self) -> &[Seam] {
        &self.seams[..self.seams.iter().take_while(|seam| seam.of.is_none()).count()]
    }

    /// Bodies of the user, without those of slabs and columns.
    pub fn user_bodies(&self) -> &[Body] {
        &self.bodies[..self.user.bodies]
    }
}
