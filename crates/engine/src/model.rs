//! The checked model: immutable, in the engine's numbering.

use crate::body::Body;
use crate::bolts::{self, BoltSet};
use crate::boundary::bed::Bed;
use crate::boundary::{Base, Side, Surroundings, Top};
use crate::column::{self, Column, Reference};
use crate::error::ModelError;
use crate::free_field::{GivenField, Incident};
use crate::hexahedra::{centroid, hex};
use crate::interface::{Seam, copies};
use crate::life::{Life, Stage};
use crate::node_table::{Domain, Nodes};
use crate::outer_faces::OuterFaces;
use crate::parts::loads::Load;
use crate::prescribed::Prescribed;
use crate::problem::{MakePart, Problem, Rayleigh, TimeStep};
use crate::rims::{Joint, Rims};
use crate::seams::{self, Seams, Standing, place_lives};
use crate::slabs::{Inside, Slab, Slabs};
use crate::traction::Traction;
use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;
use tremolite_kernels::Points;
use tremolite_laws::Isa;
use tremolite_mesh::Mesh;
use tremolite_mesh::order::hilbert_order;

/// Elements that one thread works on together.
#[derive(Clone, Debug)]
pub struct Patch {
    pub body: usize,
    /// What its elements belong to.
    pub domain: Domain,
    pub life: Life,
    /// Whether its elements have artificial viscosity ([`Model::viscosity`]).
    pub viscous: bool,
    /// Whether its elements take over from others. Each then has nodes of its own among the part's, since displacements count
    /// from other values in each.
    pub takes_over: bool,
    /// Indices into the model's elements, in the order of lanes.
    pub elements: Vec<u32>,
}

/// A checked problem, numbered for the engine.
pub struct Model {
    /// The mesh, with the nodes and elements of slabs and columns behind its own.
    pub mesh: Mesh,
    /// How many of the mesh's nodes and elements are the user's.
    pub user_nodes: usize,
    pub user_elements: usize,
    pub bodies: Vec<Body>,
    /// The body of each element of the user's, none for void ones.
    pub body_of: Vec<Option<usize>>,
    /// Of each element, those of slabs and columns included.
    pub lives: Vec<Life>,
    /// Elements that stand in the place of others before these do: (stand-in, the other).
    pub stand_ins: Vec<(u32, u32)>,
    /// Elements that take over from others: later → earlier.
    pub successors: HashMap<u32, u32>,
    /// Artificial viscosity of each element, a share of critical damping: that of its body, or of an interface that it has a
    /// node on if that is more.
    pub viscosity: Vec<f64>,
    /// Stress \[Pa\] of each element before anything moves; empty for none.
    pub initial: Vec<[f64; 6]>,
    /// m/s²
    pub gravity: f64,
    pub tractions: Vec<Traction>,
    /// How many of the bodies are the user's.
    pub user_bodies: usize,
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
    /// Bolts, cut where they leave an element.
    pub bolts: Vec<BoltSet>,
    /// Node of the mesh → one for all that interfaces part at its place; of the user's nodes.
    pub places: Vec<u32>,
    pub base: Base,
    /// Sides normal to x and to y.
    pub sides: [Side; 2],
    pub top: Top,
    /// What holds the sides and the base before the shaking.
    pub bed: Bed,
    /// What is moved before the shaking.
    pub prescribed: Vec<Prescribed>,
    /// Components held at single nodes of the mesh.
    pub held: Vec<(u32, [bool; 3])>,
    /// Copies of nodes that move as one while elements on both sides stand, at rims of interfaces.
    pub joints: Vec<Joint>,
    /// Nodes of the mesh that move as one, beside those of periodic sides, slabs and columns.
    pub ties: Vec<(u32, u32)>,
    /// Ground outside free-field sides.
    pub slabs: Vec<Slab>,
    /// At the ends of slabs, where all four sides are free field; else reference columns, where the base absorbs and there is
    /// ground along the model's vertical edges.
    pub columns: Vec<Column>,
    /// Why there are none, in words.
    pub no_column: String,
    /// Of each element, the one of the user's that it was made of, or beside which its column stands: itself if it is one.
    pub parents: Vec<u32>,
    /// Of each element, the natural axis through its thickness where its body is layered, else 2.
    pub thickness: Vec<u8>,
    pub incident: Option<Incident>,
    /// Known in advance, in place of slabs and columns.
    pub free_field: Option<Arc<dyn GivenField>>,
    pub rayleigh: Rayleigh,
    /// Loads on engine nodes.
    pub loads: Vec<Load>,
    /// Parts of the program's own.
    pub parts: Vec<MakePart>,
    pub time_step: TimeStep,
    pub isa: Isa,
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
    pub fn new(problem: Problem) -> Result<Arc<Self>, ModelError> {
        let Problem { mut mesh, mut bodies, .. } = problem;
        let body_of = check_bodies(&mesh, &bodies)?;
        let mut lives = match problem.lives {
            lives if lives.len() == mesh.elements.len() => lives,
            _ => vec![Life::ALWAYS; mesh.elements.len()],
        };
        let shaken = shaken(&body_of, &lives);
        let free_field = problem.sides.map(|side| side == Side::FreeField);
        let absorbs = matches!(problem.base, Base::Viscous | Base::ViscousSpring { .. });
        if problem.free_field.is_some() && problem.incident.is_some() {
            let reason =
                "a free field is given, and a wave that rises beside it; let the field hold all waves";
            return Err(ModelError::FreeField(reason.into()));
        }
        let grounds = if problem.free_field.is_some() {
            Err("the free field is given".to_owned())
        } else if absorbs && free_field != [true; 2] {
            column::grounds(&mesh, &bodies, &shaken, &problem.interfaces, &lives)
        } else if free_field == [true; 2] {
            Err("the slabs have columns of their own".to_owned())
        } else {
            Err("no wave enters through an absorbing base".to_owned())
        };
        let mut initial = problem.initial;
        let mut tractions = problem.tractions;
        let mut successors: HashMap<u32, u32> = problem.successors.into_iter().collect();
        let sides_of: Vec<[Vec<u32>; 2]> = problem.interfaces.iter().map(|i| i.sides.clone()).collect();
        let solid = |e: u32| body_of[e as usize].is_some();
        let Seams { mut seams, mut origin, places, mut joints } = seams::of_problem(
            &mut mesh,
            problem.interfaces,
            Standing {
                solid: &solid,
                lives: &place_lives(&lives, &successors),
                successors: &successors,
                initial: &initial,
            },
        )?;
        seams::keep_sides(&mut mesh, &successors);
        let (user_nodes, user_elements) = (mesh.nodes.len(), mesh.elements.len());
        let copies = copies(&origin);
        let held = problem.held.into_iter().flat_map(|(node, held)| {
            copies.get(&node).cloned().unwrap_or_else(|| vec![node]).into_iter().map(move |n| (n, held))
        });
        let held: Vec<(u32, [bool; 3])> = held.collect();

        let standing: Vec<u32> = (0u32..).zip(&shaken).filter(|(_, b)| b.is_some()).map(|(e, _)| e).collect();
        let bounds = mesh.bounds();
        let faces = OuterFaces::of(&mesh, bounds, &standing);
        let user_bodies = bodies.len();
        let bolts = if problem.bolts.is_empty() {
            Vec::new()
        } else {
            let ground = bolts::Hosts {
                mesh: &mesh,
                body_of: &body_of,
                lives: &lives,
                successors: &successors,
                rims: &Rims::of(&joints),
            };
            bolts::cut(&ground, problem.bolts)
        };

        let sides = free_field.map(|side| side && problem.free_field.is_none());
        let inside = Inside { bounds, body_of: &body_of, lives: &lives, sides };
        let mut outside = Slabs::beside(&mut mesh, &inside)?;
        outside.spread(&mut lives);
        outside.spread(&mut initial);
        outside.spread_pairs(&mut successors);
        if !seams.is_empty() {
            let pair_lives = place_lives(&lives, &successors);
            let sides: Vec<[Vec<u32>; 2]> = sides_of.into_iter().map(|sides| sides.map(ascending)).collect();
            outside.origins(&mesh, &mut origin);
            let parents = &outside.parents;
            let solid = |e: u32| body_of[parents[e as usize] as usize].is_some();
            let standing =
                Standing { solid: &solid, lives: &pair_lives, successors: &successors, initial: &initial };
            let mut more = Vec::new();
            for slab in &outside.slabs {
                let elements = outside.standing_alone(slab);
                let (own, held) =
                    seams::outside(&mut mesh, &mut origin, &elements, parents, &sides, &seams, standing)?;
                more.extend(own);
                joints.extend(held);
            }
            seams::keep_sides(&mut mesh, &successors);
            outside.mark_parted(&more);
            for seam in &more {
                let own = seam.of.map(|of| &mut seams[of].pressure);
                own.into_iter().for_each(|pressure| *pressure = pressure.max(seam.pressure));
            }
            seams.extend(more);
        }
        outside.press(&mesh, &mut tractions);
        let slab_bodies = outside.fill(&mesh, &mut bodies, &body_of, &lives);
        let Slabs { slabs, mut columns, mut parents } = outside;
        let no_column = match grounds {
            Ok(grounds) => {
                let Reference { columns: more, like } =
                    column::build(&mut mesh, &mut bodies, grounds, bounds);
                lives.resize(mesh.elements.len(), Life::ALWAYS);
                column::press(&mesh, &mut tractions, &more, bounds.1[2], &like);
                if !initial.is_empty() {
                    initial.extend(like.iter().map(|&element| initial[element as usize]).collect::<Vec<_>>());
                }
                parents.extend(like);
                columns.extend(more);
                String::new()
            }
            Err(reason)
                if problem.base.has_springs() && free_field != [true; 2] && problem.free_field.is_none() =>
            {
                return Err(column::refusal(&reason));
            }
            Err(reason) => reason,
        };

        let viscosity = viscosities(&mesh, &bodies, &seams, &parents);
        let thickness = crate::thickness::axes(
            &mesh,
            &bodies,
            user_elements,
            &parents,
            &successors,
            &seams,
            problem.sides,
            &held,
        )?;
        let mut patches = Vec::new();
        let size = patch_size(problem.patch_elements, bodies.iter().map(|b| b.elements.len()).sum());
        for (b, body) in bodies.iter().enumerate() {
            let mut lots: BTreeMap<(Life, bool, bool), Vec<u32>> = BTreeMap::new();
            for &e in &body.elements {
                let lot = (lives[e as usize], successors.contains_key(&e), viscosity[e as usize] > 0.0);
                lots.entry(lot).or_default().push(e);
            }
            let domain = match b {
                b if b < user_bodies => Domain::Model,
                b if b < slab_bodies => Domain::Slab,
                _ => Domain::Column,
            };
            for ((life, takes_over, viscous), lot) in lots {
                let centroids: Vec<[f64; 3]> = lot.iter().map(|&e| centroid(&mesh, e)).collect();
                let order: Vec<u32> =
                    hilbert_order(&centroids).into_iter().map(|i| lot[i as usize]).collect();
                patches.extend(order.chunks(size).map(|elements| Patch {
                    body: b,
                    domain,
                    life,
                    viscous,
                    takes_over,
                    elements: elements.to_vec(),
                }));
            }
        }

        // In the order in which the patches first touch them: a patch's nodes lie close in memory.
        let mut engine_node = vec![u32::MAX; mesh.nodes.len()];
        let mut mesh_node = Vec::new();
        let mut nodes = Nodes::default();
        // How many patches touch each: beyond one it does not matter how many.
        let mut touched = vec![(u32::MAX, 0u8); mesh.nodes.len()];
        let of_patch = |patch: &Patch| -> Vec<u32> {
            patch.elements.iter().flat_map(|&e| mesh.elements[e as usize].nodes()).copied().collect()
        };
        for (p, patch) in (0u32..).zip(&patches) {
            for n in of_patch(patch) {
                let (last, count) = &mut touched[n as usize];
                if *last != p {
                    (*last, *count) = (p, count.saturating_add(1));
                }
            }
        }
        for patch in &patches {
            for alone in [true, false] {
                let before = mesh_node.len();
                for n in of_patch(patch) {
                    if engine_node[n as usize] == u32::MAX && (touched[n as usize].1 == 1) == alone {
                        engine_node[n as usize] = mesh_node.len() as u32;
                        mesh_node.push(n);
                    }
                }
                nodes.push(patch.domain, mesh_node.len() - before);
            }
        }
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
        Ok(Arc::new(Model {
            mesh,
            user_nodes,
            user_elements,
            bodies,
            body_of,
            lives,
            stand_ins: problem.stand_ins,
            successors,
            viscosity,
            initial,
            gravity: problem.gravity,
            tractions,
            patches,
            user_bodies,
            mesh_node,
            engine_node,
            nodes,
            faces,
            seams,
            bolts,
            places,
            base: problem.base,
            sides: problem.sides,
            top: problem.top,
            bed: problem.bed,
            prescribed: problem.prescribed,
            held,
            joints,
            ties: problem.ties,
            slabs,
            columns,
            no_column,
            parents,
            thickness,
            incident: problem.incident,
            free_field: problem.free_field,
            rayleigh: problem.rayleigh,
            loads,
            parts: problem.parts,
            time_step: problem.time_step,
            isa: problem.isa,
        }))
    }

    /// Whether an element is there in a stage.
    pub fn stands(&self, element: usize, stage: Stage) -> bool {
        self.body_of.get(element).is_some_and(Option::is_some) && self.lives[element].holds(stage)
    }

    /// The user's elements that are there in a stage, ascending.
    pub fn standing(&self, stage: Stage) -> Vec<u32> {
        (0..self.user_elements).filter(|&e| self.stands(e, stage)).map(|e| e as u32).collect()
    }

    /// What boundaries are made from, with the outer faces of a stage.
    pub fn surroundings<'a>(&'a self, faces: &'a OuterFaces) -> Surroundings<'a> {
        Surroundings {
            mesh: &self.mesh,
            user_elements: self.user_elements,
            bodies: &self.bodies,
            body_of: &self.body_of,
            lives: &self.lives,
            stand_ins: &self.stand_ins,
            engine_node: &self.engine_node,
            faces,
            places: &self.places,
            base: self.base,
            sides: self.sides,
            bed: self.bed,
            held: &self.held,
            slabs: &self.slabs,
            columns: &self.columns,
            parents: &self.parents,
            top: self.top,
            incident: self.incident.as_ref(),
            free_field: self.free_field.as_ref(),
        }
    }

    /// The elements of a body that are there in the shaking.
    pub fn lasting(&self, body: &Body) -> Vec<u32> {
        body.elements.iter().copied().filter(|&e| self.stands(e as usize, Stage::Shaking)).collect()
    }

    /// What stands in a stage where an element is or will be: itself, or its stand-in.
    pub fn standing_at(&self, element: usize, stage: Stage) -> Option<usize> {
        let own = || (element, element as u32);
        let stand_ins = self.stand_ins.iter().filter(|(_, of)| *of as usize == element);
        let mut all = std::iter::once(own()).chain(stand_ins.map(|(stand_in, of)| (*stand_in as usize, *of)));
        all.find(|(e, _)| self.stands(*e, stage)).map(|(e, _)| e)
    }

    /// Where the law of a body's element is evaluated.
    pub fn points(&self, body: &Body, element: u32) -> Points {
        Points { quadrature: body.quadrature, axis: self.thickness[element as usize] as usize }
    }

    /// Interfaces of the user, without what of them runs through slabs.
    pub fn user_seams(&self) -> &[Seam] {
        &self.seams[..self.seams.iter().take_while(|seam| seam.of.is_none()).count()]
    }

    /// Bodies of the user, without those of slabs and columns.
    pub fn user_bodies(&self) -> &[Body] {
        &self.bodies[..self.user_bodies]
    }
}

/// The artificial viscosity of every element. What was made of another, outside a side, has that one's.
fn viscosities(mesh: &Mesh, bodies: &[Body], seams: &[Seam], parents: &[u32]) -> Vec<f64> {
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
    parents.iter().map(|&of| own[of as usize].max(of_nodes(of as usize))).collect()
}

fn ascending(mut elements: Vec<u32>) -> Vec<u32> {
    elements.sort_unstable();
    elements
}

/// The bodies of elements that are there in the shaking.
fn shaken(body_of: &[Option<usize>], lives: &[Life]) -> Vec<Option<usize>> {
    body_of.iter().zip(lives).map(|(body, life)| body.filter(|_| life.holds(Stage::Shaking))).collect()
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
