//! What is active: parts, masses, ties and where a node's contributions lie. Scratch, rebuilt from model and state.

use crate::model::{Model, ModelError, Patch, hex, hex_nodes};
use crate::parts::base::Base;
use crate::parts::loads::Loads;
use crate::parts::{Part, Slices, StateSizes};
use crate::state::State;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::ops::Range;
use tremolite_laws::Row;

/// A node with dashpots: C/M beside Rayleigh's ω.
#[derive(Clone, Copy, Debug)]
pub struct Dashpot {
    /// Dashpots of the base and of the sides \[N s/m\].
    pub base: [f64; 6],
    pub sides: [f64; 6],
}

/// The active parts of a model, and the nodes they act on.
pub struct Phase {
    pub parts: Vec<Box<dyn Part>>,
    pub slices: Vec<Slices>,
    /// Parts whose energy counts (not the reference column's).
    pub counted_parts: usize,
    /// Nodes whose energy counts.
    pub counted_nodes: Range<usize>,
    /// Mass by engine node \[kg\], tied nodes' mass with their master.
    pub mass: Vec<f64>,
    /// 1/m, zero for held components, tied nodes and nodes without mass.
    pub inverse_mass: Vec<Row>,
    /// Contributions of node n are `slot[start[n] .. start[n + 1]]`, in the order of parts.
    pub start: Vec<u32>,
    pub slot: Vec<u32>,
    /// (tied node, master), ascending.
    pub tied: Vec<(u32, u32)>,
    /// Ascending by node.
    pub dashpots: Vec<(u32, Dashpot)>,
    /// Element of the mesh → (first point, first element slot); for active elements of the user.
    pub element_slot: Vec<Option<ElementSlot>>,
}

/// Where an element's results lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ElementSlot {
    /// Index of its first point among all points.
    pub point: u32,
    pub points: u8,
    /// Index among all elements, in the order of parts.
    pub element: u32,
    pub part: u32,
}

impl Phase {
    /// The dynamic phase of a model.
    ///
    /// # Errors
    /// If an element's geometry cannot be used; [`Model::new`] has checked that.
    pub fn dynamic(model: &Model) -> Result<Self, ModelError> {
        let solids: Vec<(Box<dyn Part>, Vec<f64>)> =
            model.patches.par_iter().map(|patch| solid(model, patch)).collect::<Result<_, _>>()?;

        let nodes = model.mesh_node.len();
        let mut mass = vec![0.0; nodes];
        let mut parts: Vec<Box<dyn Part>> = Vec::with_capacity(solids.len() + 1 + model.loads.len());
        for (part, masses) in solids {
            for (&node, m) in part.nodes().iter().zip(masses) {
                mass[model.master[node as usize] as usize] += m;
            }
            parts.push(part);
        }
        if !model.boundaries.base.is_empty() {
            let incident = model.incident.as_ref().map(|i| (i.motion.clone(), i.factor));
            parts.push(Box::new(Base::new(model.boundaries.base.clone(), incident)));
        }
        for load in &model.loads {
            parts.push(Box::new(Loads::new(load.clone())));
        }

        let tied: Vec<(u32, u32)> =
            (0u32..).zip(&model.master).filter(|(n, m)| n != *m).map(|(n, &m)| (n, m)).collect();
        let mut inverse_mass: Vec<Row> =
            mass.iter().map(|&m| if m > 0.0 { Row::new([1.0 / m; 3]) } else { Row::ZERO }).collect();
        for (&node, held) in &model.boundaries.held {
            // A held node holds all that is tied to it.
            let row = &mut inverse_mass[model.master[node as usize] as usize];
            for i in 0..3 {
                if held[i] {
                    row.0[i] = 0.0;
                }
            }
        }

        let mut dashpots: BTreeMap<u32, Dashpot> = BTreeMap::new();
        let none = Dashpot { base: [0.0; 6], sides: [0.0; 6] };
        for base in &model.boundaries.base {
            let d = dashpots.entry(model.master[base.node as usize]).or_insert(none);
            add(&mut d.base, &base.dashpot);
        }
        for (&node, matrix) in &model.boundaries.sides {
            let d = dashpots.entry(model.master[node as usize]).or_insert(none);
            add(&mut d.sides, matrix);
        }

        let slices = slices(&parts);
        let (start, slot) = sources(&parts, &slices, &model.master);
        let element_slot = element_slots(model, &parts, &slices);
        Ok(Phase {
            parts,
            slices,
            counted_parts: model.user_patches,
            counted_nodes: model.counted.clone(),
            mass,
            inverse_mass,
            start,
            slot,
            tied,
            dashpots: dashpots.into_iter().collect(),
            element_slot,
        })
    }

    /// A state at rest.
    pub fn rest(&self) -> State {
        let (history, numbers, ..) = self.totals();
        let overstress = self.slices.last().map_or(0, |s| s.overstress.end);
        State {
            u: vec![Row::ZERO; self.mass.len()],
            du: vec![Row::ZERO; self.mass.len()],
            history: vec![tremolite_laws::Octet::ZERO; history],
            overstress: vec![tremolite_laws::Octet::ZERO; overstress],
            numbers: vec![0.0; numbers],
            ..State::default()
        }
    }

    /// Whether the counted parts keep books of all that their laws take and give out.
    pub fn keeps_books(&self) -> bool {
        self.parts[..self.counted_parts].iter().all(|part| part.keeps_books())
    }

    /// Octets of history, other numbers, contributions, points and elements.
    pub fn totals(&self) -> (usize, usize, usize, usize, usize) {
        self.slices.last().map_or((0, 0, 0, 0, 0), |s| {
            (s.history.end, s.numbers.end, s.contributions.end, s.points.end, s.elements.end)
        })
    }
}

fn add(to: &mut [f64; 6], more: &[f64; 6]) {
    for (a, b) in to.iter_mut().zip(more) {
        *a += b;
    }
}

/// The part of a patch, and the mass of each of its nodes.
fn solid(model: &Model, patch: &Patch) -> Result<(Box<dyn Part>, Vec<f64>), ModelError> {
    let body = &model.bodies[patch.body];
    let mut nodes: Vec<u32> = Vec::new();
    let mut local: BTreeMap<u32, u16> = BTreeMap::new();
    let mut corners = Vec::with_capacity(patch.elements.len());
    let mut geometry = Vec::with_capacity(patch.elements.len());
    let mut masses: Vec<f64> = Vec::new();
    for &e in &patch.elements {
        let hex = hex(&model.mesh, e as usize).map_err(|reason| ModelError::BadElement {
            element: model.mesh.element_id(e as usize),
            body: body.name.clone(),
            reason,
        })?;
        let mut corner = [0; 8];
        let mesh_nodes = hex_nodes(&model.mesh, e as usize);
        for k in 0..8 {
            let node = model.engine_node[mesh_nodes[k] as usize];
            corner[k] = *local.entry(node).or_insert_with(|| {
                nodes.push(node);
                masses.push(0.0);
                (nodes.len() - 1) as u16
            });
            masses[corner[k] as usize] += body.density * hex.corner_volumes[k];
        }
        corners.push(corner);
        geometry.push(hex);
    }
    Ok((body.material.patch(body.quadrature, nodes, &corners, &geometry, model.isa), masses))
}

fn slices(parts: &[Box<dyn Part>]) -> Vec<Slices> {
    let (mut c, mut h, mut o, mut n, mut p, mut e) = (0, 0, 0, 0, 0, 0);
    parts
        .iter()
        .map(|part| {
            let StateSizes { history, overstress, numbers } = part.state_sizes();
            let (elements, points) = part.elements();
            let slices = Slices {
                contributions: c..c + part.nodes().len(),
                history: h..h + history,
                overstress: o..o + overstress,
                numbers: n..n + numbers,
                points: p..p + elements * points,
                elements: e..e + elements,
            };
            c = slices.contributions.end;
            h = slices.history.end;
            o = slices.overstress.end;
            n = slices.numbers.end;
            p = slices.points.end;
            e = slices.elements.end;
            slices
        })
        .collect()
}

/// Which contributions make up each node's force: by master, in the order of parts.
fn sources(parts: &[Box<dyn Part>], slices: &[Slices], master: &[u32]) -> (Vec<u32>, Vec<u32>) {
    let mut start = vec![0u32; master.len() + 1];
    for part in parts {
        for &node in part.nodes() {
            start[master[node as usize] as usize + 1] += 1;
        }
    }
    for n in 0..master.len() {
        start[n + 1] += start[n];
    }
    let mut next = start.clone();
    let mut slot = vec![0u32; start[master.len()] as usize];
    for (part, slices) in parts.iter().zip(slices) {
        for (i, &node) in part.nodes().iter().enumerate() {
            let at = &mut next[master[node as usize] as usize];
            slot[*at as usize] = (slices.contributions.start + i) as u32;
            *at += 1;
        }
    }
    (start, slot)
}

fn element_slots(model: &Model, parts: &[Box<dyn Part>], slices: &[Slices]) -> Vec<Option<ElementSlot>> {
    let mut slots = vec![None; model.user_elements];
    for (p, patch) in model.patches[..model.user_patches].iter().enumerate() {
        let (_, points) = parts[p].elements();
        for (i, &e) in patch.elements.iter().enumerate() {
            slots[e as usize] = Some(ElementSlot {
                point: (slices[p].points.start + i * points) as u32,
                points: points as u8,
                element: (slices[p].elements.start + i) as u32,
                part: p as u32,
            });
        }
    }
    slots
}
