//! Every part that a model will ever have, made once, with its fixed slices of the state.

mod of_rank;

use crate::bolting::Bolting;
use crate::boundary;
use crate::boundary::base::BaseNode;
use crate::contacts::Contacts;
use crate::error::ModelError;
use crate::interface::traction;
use crate::life::{Life, Stage};
use crate::member::{Kind, Member};
use crate::model::Model;
use crate::parts::constant::Constant;
use crate::parts::loads::{Load, Loads};
use crate::parts::{Entry, Kept, Motion, Own, StateSizes, UNKNOWN};
use crate::patch_part::solid;
use crate::pore_forces::{Acting, in_pores};
use crate::state::{Ledger, State};
use crate::traction::Traction;
use crate::water::with_pressure;
use rayon::prelude::*;
use std::collections::{BTreeMap, HashMap};
use std::ops::Range;
use tremolite_kernels::Line;
use tremolite_laws::{Octet, Row, Values};
use tremolite_mesh::Face;
use tremolite_mesh::topology::vector_areas;

/// Nodes of a member at most, of what spans the model: weight, tractions, loads, the base.
pub(crate) const PIECE: usize = 256;

/// Behind what a rank keeps of its contributions: so that they are there on a rank without parts as well.
pub const KEPT: Row = UNKNOWN;

/// Things at nodes in pieces of a size at most, those of one level together.
pub(crate) fn pieces<T: Clone>(all: Vec<T>, size: usize, level: impl Fn(&T) -> u8) -> Vec<Vec<T>> {
    let mut of_level: BTreeMap<u8, Vec<T>> = BTreeMap::new();
    all.into_iter().for_each(|one| of_level.entry(level(&one)).or_default().push(one));
    of_level.values().flat_map(|own| own.chunks(size)).map(<[T]>::to_vec).collect()
}

/// Where a part's slices begin and end.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Slices {
    pub contributions: Range<usize>,
    pub history: Range<usize>,
    pub overstress: Range<usize>,
    pub numbers: Range<usize>,
    pub reference: Range<usize>,
    pub initial: Range<usize>,
    pub points: Range<usize>,
    pub elements: Range<usize>,
}

impl Slices {
    /// What becomes of each range.
    fn each(&self, of: impl Fn(&Range<usize>) -> Range<usize>) -> Self {
        let Slices { contributions, history, overstress, numbers, reference, initial, points, elements } =
            self;
        Slices {
            contributions: of(contributions),
            history: of(history),
            overstress: of(overstress),
            numbers: of(numbers),
            reference: of(reference),
            initial: of(initial),
            points: of(points),
            elements: of(elements),
        }
    }

    /// Slices as long as others, behind these.
    pub(crate) fn followed_by(&self, next: &Slices) -> Self {
        let after = |range: &Range<usize>, of: &Range<usize>| range.end..range.end + of.len();
        Slices {
            contributions: after(&self.contributions, &next.contributions),
            history: after(&self.history, &next.history),
            overstress: after(&self.overstress, &next.overstress),
            numbers: after(&self.numbers, &next.numbers),
            reference: after(&self.reference, &next.reference),
            initial: after(&self.initial, &next.initial),
            points: after(&self.points, &next.points),
            elements: after(&self.elements, &next.elements),
        }
    }

    /// The motion of a state, and what a part alone reads and writes of it.
    pub fn own<'s>(&self, state: &'s mut State) -> (Motion<'s>, Own<'s>) {
        let State { u, du, history, overstress, numbers, reference, initial, .. } = state;
        let own = Own {
            history: &mut history[self.history.clone()],
            overstress: &mut overstress[self.overstress.clone()],
            numbers: &mut numbers[self.numbers.clone()],
            reference: &mut reference[self.reference.clone()],
            initial: &initial[self.initial.clone()],
        };
        (Motion::new(u, du), own)
    }

    /// What a part alone keeps of what all remember.
    pub fn kept<'s>(&self, all: &Kept<'s>) -> Kept<'s> {
        Kept {
            history: &all.history[self.history.clone()],
            numbers: &all.numbers[self.numbers.clone()],
            reference: &all.reference[self.reference.clone()],
            initial: &all.initial[self.initial.clone()],
        }
    }
}

/// All parts of a model, whatever stage they live in. Slices do not change with the stage, so neither does a column of the
/// state, nor a checkpoint.
#[derive(Clone, Default)]
pub struct Assembly {
    /// In the order in which a node sums what they hold for it: patches, boundaries, loads, weight and tractions, interfaces,
    /// bolts, the program's own. What each is its [`Kind`] says, never its place.
    pub members: Vec<Member>,
    /// Of each member, where all that members have lies member by member: in checkpoints, and in what observers see.
    pub slices: Vec<Slices>,
    /// Of each member, where it lies in what this process holds. That is the same where one process works on the model; on one of several
    /// ranks the slices of others are empty.
    pub held: Vec<Slices>,
    /// Which members this process evaluates, where it is one of several ranks.
    own: Option<Vec<bool>>,
    /// The member that each of the model's patches is.
    pub of_patch: Vec<u32>,
    /// Of the model's interfaces, in their order.
    pub contacts: Vec<Contacts>,
    /// Parameters of the laws of these, with the stiffness that was chosen.
    pub(crate) values: Vec<Values>,
    /// Of the model's bolts, in their order.
    pub bolts: Vec<Bolting>,
    /// Bodies that the balance is also drawn up for, by name: those of the user, then parts of the program's own that have
    /// elements.
    pub accounts: Vec<String>,
    /// The account of each member, none for those without elements or out of the balance.
    pub account: Vec<Option<u16>>,
    /// Nodes of the base, those of slabs and columns included; empty for a base without dashpots.
    pub base: Vec<BaseNode>,
    /// Distance R used for the springs of the base \[m\].
    pub spring_distance: Option<f64>,
    /// Whether ground stands outside free-field sides.
    free_field: bool,
    /// Whether water changes its pressure in the shaking.
    undrained: bool,
    /// Strain that elements begin with, part by part.
    initial: Vec<Octet>,
    /// Number of nodes, and of blocks of them.
    nodes: usize,
    blocks: usize,
}

impl Assembly {
    /// The parts of a model but those of its interfaces.
    ///
    /// # Errors
    /// If no face lies on the plane of a base that should do something, or a part of the program's own does not fit.
    pub(crate) fn without_interfaces(model: &Model) -> Result<Self, ModelError> {
        let faces: HashMap<u32, Face> = model
            .outside
            .sheets()
            .flat_map(|sheet| sheet.twins.iter().map(|&(face, twin)| (twin, face)))
            .collect();
        let mut members: Vec<Member> = (0..model.patches.len() as u32)
            .into_par_iter()
            .map(|p| solid(model, &faces, p))
            .collect::<Result<_, _>>()?;
        let boundary::Members { members: of_boundaries, base, spring_distance, .. } =
            boundary::members(model.surroundings(&model.faces))?;
        members.extend(of_boundaries);
        for (k, load) in model.loading.loads.iter().enumerate() {
            let pieces = pieces(load.forces.clone(), PIECE, |(node, _)| model.nodes.level[*node as usize]);
            members.extend(pieces.into_iter().map(|forces| {
                let part = Box::new(Loads::new(Load { forces, factor: load.factor.clone() }));
                let line = Some(Line::Input);
                Member { line, ..Member::of(Kind::Load, format!("load {}", k + 1), part) }
            }));
        }
        members.extend(weights(model, &members));
        members.extend(model.loading.tractions.iter().flat_map(|traction| of_traction(model, traction)));
        let of_water = |acting: Acting| constant("water", &acting.forces, &acting.life, !acting.outside);
        members.extend(in_pores(model).into_iter().flat_map(of_water));
        for make in &model.loading.parts {
            let member = make(&model.mesh, &model.engine_node);
            check(model, &member)?;
            members.push(Member { kind: Kind::Own, ..member });
        }
        let free_field = !model.outside.slabs.is_empty() || model.boundaries.free_field.is_some();
        let undrained = (0..model.user.elements).any(|e| model.water.undrained(e).is_some());
        let nodes = model.mesh_node.len();
        let blocks = model.nodes.blocks.len();
        let mut assembly = Assembly {
            members,
            base,
            spring_distance,
            nodes,
            blocks,
            free_field,
            undrained,
            ..Assembly::default()
        };
        assembly.settle(model);
        Ok(assembly)
    }

    /// Lays out the slices and accounts of the members.
    pub(crate) fn settle(&mut self, model: &Model) {
        let Assembly { members, .. } = self;
        for member in members.iter_mut() {
            let level = member.part.nodes().iter().map(|&n| model.nodes.level[n as usize]).min();
            member.level = level.unwrap_or(0);
        }
        self.slices = slices(members, |_| true);
        self.held = self.slices.clone();
        self.of_patch = vec![0; model.patches.len()];
        for (m, member) in (0u32..).zip(members.iter()) {
            if let Some(patch) = member.kind.patch() {
                self.of_patch[patch] = m;
            }
        }
        self.initial = initial_strains(model, members, &self.slices);
        let mut accounts: Vec<String> = model.user_bodies().iter().map(|body| body.name.clone()).collect();
        self.account = members
            .iter()
            .map(|member| match member.body {
                Some(body) => member.counted.then_some(body as u16),
                None if member.counted && member.part.elements().0 > 0 => {
                    accounts.push(member.name.clone());
                    Some(accounts.len() as u16 - 1)
                }
                None => None,
            })
            .collect();
        self.accounts = accounts;
    }

    /// The lines of the balance that this assembly can have.
    pub fn lines(&self) -> impl Iterator<Item = Line> + use<> {
        let (interfaces, bolts) = (!self.contacts.is_empty(), !self.bolts.is_empty());
        let free_field = self.free_field;
        let levels = self.members.iter().any(|member| member.level > 0);
        let own = self.members.iter().any(|member| member.line == Some(Line::Own));
        let undrained = self.undrained;
        Line::ALL.iter().copied().filter(move |&line| {
            (interfaces || !line.of_interfaces())
                && (bolts || !line.of_bolts())
                && (free_field || line != Line::FreeField)
                && (levels || line != Line::Levels)
                && (own || line != Line::Own)
                && (undrained || !line.of_pores())
        })
    }

    /// Bytes of the strain that elements of this process begin with.
    pub(crate) fn begins_with(&self) -> usize {
        size_of_val(&self.initial[..])
    }

    /// A state at rest: no displacement, and the stress that the model begins with.
    pub fn rest(&self) -> State {
        let totals = self.held_totals();
        let mut state = State {
            u: vec![Row::ZERO; self.nodes],
            du: vec![Row::ZERO; self.nodes],
            history: vec![Octet::ZERO; totals.history.end],
            overstress: vec![Octet::ZERO; totals.overstress.end],
            numbers: vec![0.0; totals.numbers.end],
            reference: vec![Row::ZERO; totals.reference.end],
            initial: self.initial.clone(),
            ledger: Ledger::new(self.accounts.len(), self.members.len(), self.blocks),
            ..State::default()
        };
        self.contacts.iter().for_each(|contacts| contacts.begin(&mut state.history));
        // Where no stage comes first, what is there from the start begins here.
        let at_rest = vec![Row::ZERO; self.nodes];
        for (m, (member, slices)) in self.members.iter().zip(&self.held).enumerate() {
            if !self.has(m) {
                continue;
            }
            let entry = Entry { stage: member.life.born, u: &at_rest, stress: &|_| None };
            member.part.enter(&entry, slices.own(&mut state).1);
        }
        state
    }

    /// Where all slices end: the lengths of the columns.
    pub fn totals(&self) -> Slices {
        self.slices.last().cloned().unwrap_or_default()
    }

    /// The same of what this process holds.
    pub fn held_totals(&self) -> Slices {
        self.held.last().cloned().unwrap_or_default()
    }

    /// Whether this process has a member's part and what it remembers.
    pub fn has(&self, member: usize) -> bool {
        self.own.as_ref().is_none_or(|own| own[member])
    }

    /// Members of a kind, with their slices, in their order.
    pub fn of_kind(&self, kind: Kind) -> impl Iterator<Item = (&Member, &Slices)> {
        self.members.iter().zip(&self.slices).filter(move |(member, _)| member.kind == kind)
    }

    /// A member by its name, with its slices: for observers of a program's own parts.
    pub fn named(&self, name: &str) -> Option<(&Member, &Slices)> {
        self.members.iter().zip(&self.slices).find(|(member, _)| member.name == name)
    }
}

/// Refuses a program's own part that the engine could not take as it is.
fn check(model: &Model, member: &Member) -> Result<(), ModelError> {
    let Member { name, part, masses, counted, .. } = member;
    let refuse = |reason: String| Err(ModelError::Member { name: name.clone(), reason });
    let nodes = part.nodes();
    if let Some(node) = nodes.iter().find(|&&n| n as usize >= model.mesh_node.len()) {
        return refuse(format!(
            "it pushes engine node {node}, which is none: leave out nodes that no element uses"
        ));
    }
    if !masses.is_empty() && masses.len() != nodes.len() {
        return refuse(format!(
            "it has {} masses for {} nodes: give one a node, or none",
            masses.len(),
            nodes.len()
        ));
    }
    if !counted && nodes.iter().any(|&n| model.nodes.counts(n as usize)) {
        return refuse("it is left out of the balance and pushes nodes that are in it: count it".into());
    }
    Ok(())
}

/// What weighs down before the shaking: the mass of each lot, and of slabs and columns.
fn weights(model: &Model, solids: &[Member]) -> Vec<Member> {
    if model.loading.gravity == 0.0 {
        return Vec::new();
    }
    let mut lots: BTreeMap<(bool, Life), BTreeMap<u32, f64>> = BTreeMap::new();
    for member in solids.iter().filter(|member| member.kind.patch().is_some()) {
        let lot = lots.entry((!member.counted, member.life)).or_default();
        for (&node, mass) in member.part.nodes().iter().zip(&member.masses) {
            *lot.entry(node).or_default() += mass;
        }
    }
    lots.into_iter()
        .filter(|((_, life), _)| life.born < Stage::Shaking)
        .flat_map(|((outside, life), masses)| {
            let forces: Vec<_> = masses
                .into_iter()
                .map(|(node, mass)| (node, [0.0, 0.0, -mass * model.loading.gravity]))
                .collect();
            constant("weight", &forces, &life, !outside)
        })
        .collect()
}

/// A traction as nodal forces; nothing where none of its faces has nodes that move.
fn of_traction(model: &Model, of: &Traction) -> Vec<Member> {
    let mut forces: BTreeMap<u32, [f64; 3]> = BTreeMap::new();
    for (face, stress) in &of.faces {
        for (node, area) in vector_areas(&model.mesh, &[*face]) {
            let force = traction(stress, area);
            let node = model.engine_node[node as usize];
            if node != u32::MAX {
                let sum = forces.entry(node).or_default();
                (0..3).for_each(|i| sum[i] += force[i]);
            }
        }
    }
    constant(&of.name, &forces.into_iter().collect::<Vec<_>>(), &of.life, true)
}

/// Constant forces before the shaking, in pieces.
pub(crate) fn constant(name: &str, forces: &[(u32, [f64; 3])], life: &Life, counted: bool) -> Vec<Member> {
    let life = life.and(&Life::BEFORE);
    let piece = |forces: &[(u32, [f64; 3])]| {
        let part = Box::new(Constant::new(forces.iter().copied()));
        Member { life, counted, ..Member::of(Kind::Weight, name, part) }
    };
    forces.chunks(PIECE).map(piece).collect()
}

/// C⁻¹σ₀, of effective stress where there is water, of every element that begins with stress, with the elastic constants that its law has by itself.
fn initial_strains(model: &Model, members: &[Member], slices: &[Slices]) -> Vec<Octet> {
    let mut all = vec![Octet::ZERO; slices.last().map_or(0, |s| s.initial.end)];
    for (member, slices) in members.iter().zip(slices) {
        let Some(patch) = member.kind.patch().map(|patch| &model.patches[patch]) else { continue };
        let own = &mut all[slices.initial.clone()];
        if own.is_empty() || patch.takes_over {
            continue;
        }
        let moduli = model.bodies[patch.body].material.relaxed();
        // What is placed later has no total stress, and the water that is there in its pores.
        let initial = |e: usize| match patch.life.is_later() {
            true => [0.0; 6],
            false => model.elements.initial.get(e).copied().unwrap_or_default(),
        };
        for (i, &e) in patch.elements.iter().enumerate() {
            let p = model.water.pressure(e as usize, patch.life.born);
            let strain = moduli.strain(&with_pressure(initial(e as usize), p));
            for (octet, value) in own[6 * (i / 8)..].iter_mut().zip(strain) {
                octet.0[i % 8] = value;
            }
        }
    }
    all
}

/// The slices of members, which of those that are not there are empty.
fn slices(members: &[Member], there: impl Fn(usize) -> bool) -> Vec<Slices> {
    let mut last = Slices::default();
    let nothing = |range: &Range<usize>| range.end..range.end;
    let after = |range: &Range<usize>, length: usize| range.end..range.end + length;
    members
        .iter()
        .enumerate()
        .map(|(m, member)| {
            if !there(m) {
                last = last.each(nothing);
                return last.clone();
            }
            let StateSizes { history, overstress, numbers } = member.part.state_sizes();
            let (elements, points) = member.part.elements();
            last = Slices {
                contributions: after(&last.contributions, member.part.nodes().len()),
                history: after(&last.history, history),
                overstress: after(&last.overstress, overstress),
                numbers: after(&last.numbers, numbers),
                reference: after(
                    &last.reference,
                    if elements > 0 && member.life.is_later() { member.part.nodes().len() } else { 0 },
                ),
                initial: after(&last.initial, if member.initial { 6 * elements.div_ceil(8) } else { 0 }),
                points: after(&last.points, elements * points),
                elements: after(&last.elements, elements),
            };
            last.clone()
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::Body;
    use crate::problem::Problem;
    use tremolite_kernels::{Quadrature, elastic};
    use tremolite_laws::Moduli;
    use tremolite_mesh::boxes::BoxSpec;

    /// 64,000 elements in one patch have 68,921 nodes; the largest patch that the message allows has no more than 65,536.
    #[test]
    fn a_patch_with_more_nodes_than_its_elements_can_number_is_refused_with_the_way_out() {
        let assembly = |patch_elements| {
            let mesh = BoxSpec::uniform([0.0; 3], [1.0; 3], [40; 3]).mesh().unwrap();
            let body = Body {
                name: "rock".into(),
                elements: (0..mesh.elements.len() as u32).collect(),
                material: elastic(Moduli::from_young_poisson(1e10, 0.25)),
                density: 2600.0,
                quadrature: Quadrature::OnePoint,
                viscosity: 0.0,
            };
            let mut problem = Problem::new(mesh, vec![body]);
            problem.patch_elements = Some(patch_elements);
            Assembly::new(&Model::new(problem).unwrap()).map(|_| ())
        };
        let refused = assembly(64_000).unwrap_err().to_string();
        for word in ["64000 elements of 'rock'", "65,536", "`patch_elements`", "8192"] {
            assert!(refused.contains(word), "{refused}");
        }
        assert!(assembly(8192).is_ok());
    }
}
