//! What a model knows of each of its elements, beside their nodes.

use crate::body::Body;
use crate::column;
use crate::hexahedra::hex;
use crate::life::{Life, Stage};
use rayon::prelude::*;
use std::collections::HashMap;
use std::ops::Range;
use tremolite_laws::shapes::hex8::{BadShape, Hex8, element_frequencies};
use tremolite_mesh::Mesh;

/// Lists by element of the mesh; those of slabs and columns lie behind the user's.
#[derive(Clone, Debug, Default)]
pub struct Elements {
    /// The body of each element of the user's, none for void ones.
    pub body_of: Vec<Option<usize>>,
    /// When each is there.
    pub lives: Vec<Life>,
    /// Elements that stand in the place of others before these do: (stand-in, the other).
    pub stand_ins: Vec<(u32, u32)>,
    /// Elements that take over from others: later → earlier.
    pub successors: HashMap<u32, u32>,
    /// Of each element, the one of the user's that it was made of, or beside which its column stands: itself if it is one.
    pub parents: Vec<u32>,
    /// Stress \[Pa\] of each element before anything moves; empty for none.
    pub initial: Vec<[f64; 6]>,
    /// Artificial viscosity of each element, a share of critical damping: that of its body, or of an interface that it has a
    /// node on if that is more.
    pub viscosity: Vec<f64>,
    /// Of each element, the natural axis through its thickness where its body is layered, else 2.
    pub thickness: Vec<u8>,
    /// Elements of reference columns, behind all others.
    pub columns: Range<usize>,
    /// Of wedges of several points the sides by which they are linked.
    pub linked: HashMap<u32, [bool; 3]>,
    /// The highest frequency of each element alone \[rad/s\], with its undamaged stiffness and without water; 0 of void ones.
    pub frequencies: Vec<f64>,
}

impl Elements {
    /// Geometry of an element as its kernel has it, but for the order of its corners.
    ///
    /// # Errors
    /// If it cannot be integrated.
    pub fn shape(&self, mesh: &Mesh, element: u32) -> Result<Hex8, BadShape> {
        let mut hex = hex(mesh, element as usize)?;
        hex.linked = self.linked.get(&element).copied().unwrap_or(hex.linked);
        Ok(hex)
    }

    /// The user's elements that are there in the shaking, ascending.
    pub(super) fn shaken(&self) -> Vec<u32> {
        (0..self.body_of.len()).filter(|&e| self.stands(e, Stage::Shaking)).map(|e| e as u32).collect()
    }

    /// Whether an element stands in a stage. An element of a free-field slab or column needs a body of its parent.
    pub fn stands(&self, element: usize, stage: Stage) -> bool {
        let parent = self.parents.get(element).map_or(element, |&parent| parent as usize);
        self.body_of[parent].is_some() && self.lives[element].holds(stage)
    }
}

/// The shape by which an element's highest frequency is found: its own, or that of a layer of a reference column.
pub(super) fn vibrating(mesh: &Mesh, known: &Elements, element: u32) -> Option<Hex8> {
    let own = known.shape(mesh, element).ok()?;
    if known.columns.contains(&(element as usize)) { column::widened(&own) } else { Some(own) }
}

/// [`Elements::frequencies`] of a mesh and its bodies.
pub(super) fn frequencies(mesh: &Mesh, bodies: &[Body], known: &Elements) -> Vec<f64> {
    const AT_ONCE: usize = 1024;
    let mut all = vec![0.0; mesh.elements.len()];
    for body in bodies {
        let of = |elements: &[u32]| {
            let usable = elements.iter().filter_map(|&e| Some((e, vibrating(mesh, known, e)?)));
            let (elements, shapes): (Vec<u32>, Vec<_>) = usable.unzip();
            let omegas =
                element_frequencies(&shapes, body.material.stiffest(), body.density, body.quadrature);
            elements.into_iter().zip(omegas).collect::<Vec<(u32, f64)>>()
        };
        let found: Vec<_> = body.elements.par_chunks(AT_ONCE).map(of).collect();
        found.into_iter().flatten().for_each(|(e, omega)| all[e as usize] = omega);
    }
    all
}
