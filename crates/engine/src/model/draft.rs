//! A model in the making: the mesh, and what is said of its elements and nodes while it grows and is parted.

mod outside;

use super::{Counts, Elements, Parted};
use crate::body::Body;
use crate::bolts::{self, BoltSet, Bolts};
use crate::boundary::Boundaries;
use crate::error::ModelError;
use crate::hexahedra::hex;
use crate::interface::{Interface, Seam, copies};
use crate::life::Life;
use crate::rims::Rims;
use crate::seams::{self, Seams, Standing, place_lives};
use crate::thickness;
use crate::traction::Traction;
use rayon::prelude::*;
use tremolite_mesh::Mesh;

/// What a model is made of before it is numbered. Lives, parents and initial stress grow with the mesh.
pub(super) struct Draft {
    pub mesh: Mesh,
    pub bodies: Vec<Body>,
    /// Viscosity, thickness and linked sides come last, by [`Draft::finish`].
    pub elements: Elements,
    pub tractions: Vec<Traction>,
    pub seams: Vec<Seam>,
    pub parted: Parted,
    /// The node that each node was before interfaces parted the mesh; empty without interfaces.
    pub origin: Vec<u32>,
}

impl Draft {
    /// A mesh of a problem, checked: every element is in one body at most, and can be integrated if it is in one.
    ///
    /// # Errors
    /// The first body or element that is none.
    pub fn of(
        mesh: Mesh,
        bodies: Vec<Body>,
        mut elements: Elements,
        tractions: Vec<Traction>,
    ) -> Result<Self, ModelError> {
        elements.body_of = check_bodies(&mesh, &bodies)?;
        if elements.lives.len() != mesh.elements.len() {
            elements.lives = vec![Life::ALWAYS; mesh.elements.len()];
        }
        let (seams, parted, origin) = (Vec::new(), Parted::default(), Vec::new());
        Ok(Draft { mesh, bodies, elements, tractions, seams, parted, origin })
    }

    /// Parts the mesh along interfaces.
    ///
    /// # Errors
    /// If it cannot be parted there.
    pub fn part(&mut self, interfaces: Vec<Interface>) -> Result<(), ModelError> {
        let Elements { body_of, lives, successors, initial, .. } = &self.elements;
        let solid = |e: u32| body_of[e as usize].is_some();
        let lives = &place_lives(lives, successors);
        let standing = Standing { solid: &solid, lives, successors, initial };
        let Seams { seams, origin, places, joints } =
            seams::of_problem(&mut self.mesh, interfaces, standing)?;
        seams::keep_sides(&mut self.mesh, successors);
        (self.seams, self.parted, self.origin) = (seams, Parted { places, joints }, origin);
        Ok(())
    }

    /// How much there is of mesh and bodies.
    pub fn counts(&self) -> Counts {
        Counts { nodes: self.mesh.nodes.len(), elements: self.mesh.elements.len(), bodies: self.bodies.len() }
    }

    /// What is said of nodes, said of all copies of those that interfaces parted.
    pub fn at_copies<T: Copy>(&self, nodes: Vec<(u32, T)>) -> Vec<(u32, T)> {
        let copies = copies(&self.origin);
        let all = nodes.into_iter().flat_map(|(node, said)| {
            copies.get(&node).cloned().unwrap_or_else(|| vec![node]).into_iter().map(move |n| (n, said))
        });
        all.collect()
    }

    /// Bolts cut where they leave an element.
    pub fn cut(&self, bolts: Vec<Bolts>) -> Vec<BoltSet> {
        if bolts.is_empty() {
            return Vec::new();
        }
        let Elements { body_of, lives, successors, .. } = &self.elements;
        let rims = &Rims::of(&self.parted.joints);
        bolts::cut(&bolts::Hosts { mesh: &self.mesh, body_of, lives, successors, rims }, bolts)
    }

    /// Says of each element what follows from the finished mesh.
    ///
    /// # Errors
    /// If the thickness of a layered element is not to be told.
    pub fn finish(&mut self, user_elements: usize, asked: &Boundaries) -> Result<(), ModelError> {
        self.elements.viscosity = self.viscosities();
        self.elements.linked = super::linked::linked(&self.mesh, &self.bodies);
        let Draft { mesh, bodies, elements, seams, .. } = &*self;
        self.elements.thickness = thickness::axes(mesh, bodies, user_elements, elements, seams, asked)?;
        Ok(())
    }

    /// The artificial viscosity of every element. What was made of another, outside a side, has that one's.
    fn viscosities(&self) -> Vec<f64> {
        let Draft { mesh, bodies, elements, seams, .. } = self;
        let mut own = vec![0.0; mesh.elements.len()];
        for body in bodies {
            body.elements.iter().for_each(|&e| own[e as usize] = body.viscosity);
        }
        let mut beside = vec![0.0_f64; mesh.nodes.len()];
        for seam in seams {
            for node in seam.pairs.iter().flat_map(|pair| pair.nodes) {
                beside[node as usize] = beside[node as usize].max(seam.viscosity);
            }
        }
        let of_nodes =
            |e: usize| mesh.elements[e].nodes().iter().map(|&n| beside[n as usize]).fold(0.0, f64::max);
        elements.parents.iter().map(|&of| own[of as usize].max(of_nodes(of as usize))).collect()
    }
}

/// The body of each element, none for void ones; every element of a body can be integrated.
fn check_bodies(mesh: &Mesh, bodies: &[Body]) -> Result<Vec<Option<usize>>, ModelError> {
    let mut body_of: Vec<Option<usize>> = vec![None; mesh.elements.len()];
    for (b, body) in bodies.iter().enumerate() {
        if body.density.is_nan() || body.density <= 0.0 {
            return Err(ModelError::Density { body: body.name.clone(), density: body.density });
        }
        for &e in &body.elements {
            if let Some(first) = body_of[e as usize] {
                let first = bodies[first].name.clone();
                return Err(ModelError::Twice {
                    element: mesh.element_id(e as usize),
                    first,
                    second: body.name.clone(),
                });
            }
            body_of[e as usize] = Some(b);
        }
        let usable = |&e: &u32| {
            hex(mesh, e as usize).map(drop).map_err(|reason| ModelError::BadElement {
                element: mesh.element_id(e as usize),
                body: body.name.clone(),
                reason,
            })
        };
        // The first of all, whoever finds it.
        let refused: Vec<ModelError> = body
            .elements
            .par_chunks(1024)
            .filter_map(|some| some.iter().find_map(|e| usable(e).err()))
            .collect();
        if let Some(first) = refused.into_iter().next() {
            return Err(first);
        }
    }
    if body_of.iter().all(Option::is_none) {
        return Err(ModelError::Empty);
    }
    Ok(body_of)
}
