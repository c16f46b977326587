//! What is active in a stage: which parts, what moves as one, what is held, what absorbs. Scratch, made from the model and
//! its assembly.

pub mod beats;
mod driven;
pub mod ours;
pub mod passes;
mod woken;

use crate::assembly::Assembly;
use crate::boundary;
use crate::boundary::matrix::add;
use crate::contacts::Contacts;
use crate::error::ModelError;
use crate::free_field::{Leader, Spot};
use crate::interface::Seam;
use crate::life::Stage;
use crate::member::{Kind, Member};
use crate::model::Model;
use crate::node_table::Domain;
use crate::outer_faces::OuterFaces;
use crate::parts::Tick;
use crate::rims::Joint;
use crate::state::State;
use crate::ties::Ties;
use beats::{Beat, Border, Meeting, Push, span};
pub use driven::Driven;
use ours::Ours;
use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;
use tremolite_kernels::Points;
use tremolite_laws::Row;

/// The dashpots of a node, as symmetric matrices (xx, yy, zz, xy, yz, zx) \[N s/m\].
#[derive(Clone, Debug, Default)]
pub struct Dashpot {
    /// Of the base and of the sides.
    pub base: [f64; 6],
    pub sides: [f64; 6],
    /// Of free-field sides: on the velocity of others less its own.
    pub follows: Vec<Follow>,
    /// The sum of all.
    pub whole: [f64; 6],
}

/// A dashpot between a node and a leader, whose velocity is known before.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Follow {
    pub leader: Leader,
    /// Its place in [`Phase::leaders`].
    pub place: u32,
    /// N s/m
    pub matrix: [f64; 6],
}

/// How time goes for laws and loads while the scheme makes its steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Drive {
    /// It stands still at 0: laws know no rates and Maxwell bodies are away.
    Quasistatic,
    /// It is the scheme's.
    Dynamic,
}

/// Where an element's results lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ElementSlot {
    /// Index of its first point among all points.
    pub point: u32,
    pub points: u8,
    /// Where they lie.
    pub places: Points,
    /// Index among all elements, in the order of members.
    pub element: u32,
    pub member: u32,
    /// The patch that this member is.
    pub patch: u32,
}

/// In [`Phase::slot_account`]: a part without an account.
pub const NO_ACCOUNT: u16 = u16::MAX;
/// In [`Phase::account`]: ask the slots.
pub const SEVERAL: u16 = u16::MAX - 1;

/// The active parts of an assembly, and the nodes they act on.
#[derive(Clone)]
pub struct Phase {
    pub stage: Stage,
    pub drive: Drive,
    /// Nodes of elements that begin with this stage, of which none was there before, nor anything that moves as one with them;
    /// ascending.
    pub woken: Vec<u32>,
    /// Nodes of elements that begin with this stage, with those that were there before and hold them from now on.
    pub joined: Vec<(u32, Vec<u32>)>,
    /// Members that are there, ascending.
    pub active: Vec<u32>,
    /// Elements whose energy counts.
    pub counted_elements: usize,
    /// How many of these have each level's step, the finest first.
    pub elements_of_level: Vec<usize>,
    /// How many of them are evaluated in a step of the finest level, in the mean.
    pub evaluated_elements: f64,
    /// Whether the counted parts keep books of all that they take and give out.
    pub keeps_books: bool,
    /// Engine node → the engine node it moves with (itself if it is its own master).
    pub master: Vec<u32>,
    /// Mass by engine node \[kg\], tied nodes' mass with their master.
    pub mass: Vec<f64>,
    /// 1/m, zero for held components, tied nodes and nodes without mass.
    pub inverse_mass: Vec<Row>,
    /// Nodes that the stage moves.
    pub driven: Vec<Driven>,
    /// Contributions of node n are `slot[start[n] .. start[n + 1]]`, in the order of members.
    pub start: Vec<u32>,
    pub slot: Vec<u32>,
    /// The account ([`Assembly::accounts`]) whose elements alone are at a node; [`SEVERAL`] where there are more.
    pub account: Vec<u16>,
    /// How many of a node's contributions, the last ones, are of parts without an account, where it has one.
    pub others: Vec<u8>,
    /// Of each slot, [`NO_ACCOUNT`] for parts that have none.
    pub slot_account: Vec<u16>,
    /// (tied node, master), ascending.
    pub tied: Vec<(u32, u32)>,
    /// Ascending by node.
    pub dashpots: Vec<(u32, Dashpot)>,
    /// What nodes follow by dashpots: the places of a given free field, then engine nodes in the order in which they are advanced.
    pub leaders: Vec<Leader>,
    /// The first of them, those of a given free field, as it knows them.
    pub given: Vec<Spot>,
    /// What takes part in a step, by the coarsest level that has an own step there. The last has everything; before the shaking
    /// it is the only one.
    pub beats: Vec<Beat>,
    /// Nodes with longer steps than what pushes or reads them, ascending.
    pub borders: Vec<Border>,
    /// What pushes them between their own times, in the order of borders.
    pub pushes: Vec<Push>,
    /// Element of the mesh → its slot; for active elements of the user. A rank has slots of its own elements alone, where it holds them.
    pub element_slot: Vec<Option<ElementSlot>>,
    /// What of it one rank has, where several work on the model: beats are then that rank's.
    pub ours: Option<Ours>,
}

/// What a given free field knows of the places at which others follow it, which are the first of all leaders.
fn given(model: &Model, leaders: &[Leader]) -> Vec<Spot> {
    let Some(field) = &model.boundaries.free_field else { return Vec::new() };
    let given = leaders.iter().take_while(|leader| matches!(leader, Leader::Given(_)));
    let at = |leader: &Leader| model.mesh.nodes[model.mesh_node[leader.node() as usize] as usize];
    given.map(|leader| field.spot(at(leader))).collect()
}

impl Phase {
    /// What is active in a stage. Before the shaking the base is fixed, sides that are neither periodic nor fixed are rollers,
    /// unless the model's bed says otherwise, and no dashpots act.
    ///
    /// # Errors
    /// If sides cannot be tied, or no face lies on a plane on which something should act.
    pub fn of(model: &Model, assembly: &Assembly, stage: Stage) -> Result<Arc<Self>, ModelError> {
        Phase::tied(model, assembly, stage, std::iter::empty(), |_| true)
    }

    /// That of the initial equilibrium before interfaces that begin under load are there: their two sides move as one.
    ///
    /// # Errors
    /// As [`Phase::of`].
    pub fn bonded(model: &Model, assembly: &Assembly) -> Result<Arc<Self>, ModelError> {
        let of = |(seam, contacts): (&Seam, &Contacts)| -> Vec<[u32; 2]> {
            contacts.loaded.iter().map(|loaded| seam.pairs[loaded.pair as usize].nodes).collect()
        };
        let nodes = model.seams.iter().zip(&assembly.contacts).flat_map(of);
        let without = |member: &Member| !matches!(member.kind, Kind::Pairs(_));
        Phase::tied(model, assembly, Stage::Before(0), nodes, without)
    }

    /// What is active in a stage where more nodes of the mesh move as one, of these parts.
    fn tied(
        model: &Model,
        assembly: &Assembly,
        stage: Stage,
        more: impl Iterator<Item = [u32; 2]>,
        of: impl Fn(&Member) -> bool,
    ) -> Result<Arc<Self>, ModelError> {
        let drive = if stage == Stage::Shaking { Drive::Dynamic } else { Drive::Quasistatic };
        let active: Vec<u32> = (0u32..)
            .zip(&assembly.members)
            .filter(|(_, member)| member.life.holds(stage) && of(member))
            .map(|(m, _)| m)
            .collect();
        let there = |m: &u32| &assembly.members[*m as usize];

        let mut ties = Ties::new(model.mesh.nodes.len());
        for &(a, b) in &model.boundaries.ties {
            ties.join(a, b);
        }
        for &Joint { nodes: [a, b], .. } in model.parted.joints.iter().filter(|joint| joint.life.holds(stage))
        {
            ties.join(a, b);
        }
        more.for_each(|[a, b]| ties.join(a, b));
        let before;
        let faces = if stage == Stage::Shaking {
            &model.faces
        } else {
            before = OuterFaces::of(&model.mesh, model.faces.bounds, &model.standing(stage));
            &before
        };
        let around = model.surroundings(faces);
        boundary::tie_periodic(around, &mut ties)?;
        boundary::tie_outside(around, &mut ties);
        let master = ties.masters(&model.mesh_node, &model.engine_node);
        let mut supports = boundary::supports(around, stage)?;

        let mut mass = vec![0.0; model.mesh_node.len()];
        for Member { part, masses, .. } in active.iter().map(there) {
            for (&node, m) in part.nodes().iter().zip(masses) {
                mass[master[node as usize] as usize] += m;
            }
        }
        let tied: Vec<(u32, u32)> =
            (0u32..).zip(&master).filter(|(n, m)| n != *m).map(|(n, &m)| (n, m)).collect();
        let mut inverse_mass: Vec<Row> =
            mass.iter().map(|&m| if m > 0.0 { Row::new([1.0 / m; 3]) } else { Row::ZERO }).collect();
        for (&node, held) in &supports.held {
            // A held node holds all that is tied to it.
            let row = &mut inverse_mass[master[node as usize] as usize];
            for i in 0..3 {
                if held[i] {
                    row.0[i] = 0.0;
                }
            }
        }

        let driven = driven::driven(model, stage, &master)?;
        for moved in &driven {
            let row = &mut inverse_mass[moved.node as usize];
            (0..3).filter(|&i| moved.to[i].is_some()).for_each(|i| row.0[i] = 0.0);
        }

        let mut dashpots: BTreeMap<u32, Dashpot> = BTreeMap::new();
        if stage == Stage::Shaking {
            for base in &assembly.base {
                match model.boundaries.free_field {
                    None => {
                        add(&mut dashpots.entry(master[base.node as usize]).or_default().base, &base.dashpot)
                    }
                    Some(_) => supports.follow(base.node, Leader::Given(base.node), &base.dashpot),
                }
            }
        }
        for (&node, matrix) in &supports.dashpots {
            add(&mut dashpots.entry(master[node as usize]).or_default().sides, matrix);
        }
        for (&(node, leader), matrix) in &supports.following {
            let follows = &mut dashpots.entry(master[node as usize]).or_default().follows;
            let leader = match leader {
                Leader::Node(node) => Leader::Node(master[node as usize]),
                given @ Leader::Given(_) => given,
            };
            match follows.iter_mut().find(|follow| follow.leader == leader) {
                Some(known) => add(&mut known.matrix, matrix),
                None => follows.push(Follow { leader, place: 0, matrix: *matrix }),
            }
        }
        for dashpot in dashpots.values_mut() {
            let Dashpot { base, sides, follows, whole } = dashpot;
            *whole = *base;
            add(whole, sides);
            follows.iter().for_each(|follow| add(whole, &follow.matrix));
        }
        let (leaders, passes) = passes::passes(model, dashpots.values());
        let place: HashMap<Leader, u32> = leaders.iter().copied().zip(0..).collect();
        for follow in dashpots.values_mut().flat_map(|dashpot| &mut dashpot.follows) {
            follow.place = place[&follow.leader];
        }

        let (start, slot, slot_account) = sources(assembly, &active, &master);
        let (account, others) = (0..master.len())
            .map(|n| {
                let all = &slot_account[start[n] as usize..start[n + 1] as usize];
                // Elements come first.
                let own = all.iter().take_while(|account| **account != NO_ACCOUNT).count();
                let (own, others) = all.split_at(own);
                match (own, u8::try_from(others.len())) {
                    ([first, rest @ ..], Ok(count))
                        if rest.iter().all(|a| a == first) && others.iter().all(|a| *a == NO_ACCOUNT) =>
                    {
                        (*first, count)
                    }
                    _ => (SEVERAL, 0),
                }
            })
            .unzip();
        let meeting = Meeting {
            model,
            assembly,
            active: &active,
            master: &master,
            start: &start,
            slot: &slot,
            slot_account: &slot_account,
            tied: &tied,
            leaders: &leaders,
            passes,
        };
        let (beats, (borders, pushes)) = match drive {
            Drive::Dynamic => {
                let borders = meeting.borders();
                (meeting.beats(&borders.0), borders)
            }
            Drive::Quasistatic => (vec![meeting.one()], (Vec::new(), Vec::new())),
        };
        let counted = || active.iter().map(there).filter(|member| member.counted);
        let mut elements_of_level = vec![0; beats.len()];
        for member in counted() {
            let level = if beats.len() > 1 { usize::from(member.level) } else { 0 };
            elements_of_level[level] += member.part.elements().0;
        }
        let evaluated = (0u8..).zip(&elements_of_level).map(|(l, &count)| count as f64 / span(l) as f64);
        let (joined, woken) = woken::woken(model, assembly, stage);
        Ok(Arc::new(Phase {
            stage,
            drive,
            woken,
            joined,
            counted_elements: counted().map(|member| member.part.elements().0).sum(),
            evaluated_elements: evaluated.sum(),
            elements_of_level,
            keeps_books: counted().all(|member| member.part.keeps_books()),
            element_slot: element_slots(model, assembly, &active),
            active,
            master,
            mass,
            inverse_mass,
            driven,
            start,
            slot,
            account,
            others,
            slot_account,
            tied,
            dashpots: dashpots.into_iter().collect(),
            given: given(model, &leaders),
            leaders,
            beats,
            borders,
            pushes,
            ours: None,
        }))
    }

    /// The number of what takes part in the step that begins at a state, in [`Phase::beats`].
    pub fn beat_number(&self, state: &State) -> usize {
        let coarsest = state.steps().trailing_zeros() as usize;
        coarsest.min(self.beats.len() - 1)
    }

    /// What takes part in the step that begins at a state.
    pub fn beat(&self, state: &State) -> &Beat {
        &self.beats[self.beat_number(state)]
    }

    /// Members that are there and that this process evaluates, ascending.
    pub fn members(&self) -> &[u32] {
        self.ours.as_ref().map_or(&self.active, |ours| &ours.members)
    }

    /// Whether this process knows how a node moves.
    pub fn holds(&self, node: u32) -> bool {
        self.ours.as_ref().is_none_or(|ours| ours.holds[node as usize])
    }

    /// Steps of the finest level in one of the coarsest.
    pub fn span(&self) -> u64 {
        span(self.beats.len() as u8 - 1)
    }

    /// Whether a state is one at which all levels have their own times: nothing outside sees another.
    pub fn is_common(&self, state: &State) -> bool {
        state.steps().is_multiple_of(self.span())
    }

    /// Steps of the finest level in one of a member's own.
    pub fn span_of(&self, member: &Member) -> u64 {
        if self.beats.len() > 1 { span(member.level) } else { 1 }
    }

    /// The same in one of a node's own.
    pub fn span_of_node(&self, model: &Model, node: u32) -> u64 {
        if self.beats.len() > 1 { span(model.nodes.level[node as usize]) } else { 1 }
    }

    /// What laws and loads know of the time at a state.
    pub fn tick(&self, state: &State) -> Tick {
        match self.drive {
            Drive::Quasistatic => Tick { time: 0.0, dt: 0.0, step: 0 },
            Drive::Dynamic => Tick { time: state.time(), dt: state.dt, step: state.steps() },
        }
    }
}

/// Which contributions make up each node's force, and whose they are: by master, in the order of members.
fn sources(assembly: &Assembly, active: &[u32], master: &[u32]) -> (Vec<u32>, Vec<u32>, Vec<u16>) {
    let parts = || active.iter().map(|&m| (&assembly.members[m as usize].part, m as usize));
    let mut start = vec![0u32; master.len() + 1];
    for (part, _) in parts() {
        for &node in part.nodes() {
            start[master[node as usize] as usize + 1] += 1;
        }
    }
    for n in 0..master.len() {
        start[n + 1] += start[n];
    }
    let mut next = start.clone();
    let mut slot = vec![0u32; start[master.len()] as usize];
    let mut account = vec![NO_ACCOUNT; slot.len()];
    for (part, m) in parts() {
        for (i, &node) in part.nodes().iter().enumerate() {
            let at = &mut next[master[node as usize] as usize];
            slot[*at as usize] = (assembly.slices[m].contributions.start + i) as u32;
            account[*at as usize] = assembly.account[m].unwrap_or(NO_ACCOUNT);
            *at += 1;
        }
    }
    (start, slot, account)
}

impl Phase {
    /// What pushes a node between its own times.
    #[inline(always)]
    pub fn pushes(&self, border: &Border) -> &[Push] {
        &self.pushes[border.pushes.start as usize..border.pushes.end as usize]
    }

    /// Whether each of the user's elements is there, on this rank or another.
    pub fn stands(&self, model: &Model, assembly: &Assembly) -> Vec<bool> {
        let mut stands = vec![false; model.user.elements];
        let numbers = self.active.iter().filter_map(|&m| assembly.members[m as usize].kind.patch());
        for patch in numbers.map(|number| &model.patches[number]).filter(|p| p.domain == Domain::Model) {
            patch.elements.iter().for_each(|&e| stands[e as usize] = true);
        }
        stands
    }
}

/// Where the results of each of the user's elements lie.
fn element_slots(model: &Model, assembly: &Assembly, active: &[u32]) -> Vec<Option<ElementSlot>> {
    let mut slots = vec![None; model.user.elements];
    for &m in active {
        let (member, slices) = (&assembly.members[m as usize], &assembly.slices[m as usize]);
        let Some(number) = member.kind.patch() else { continue };
        let patch = &model.patches[number];
        if patch.domain != Domain::Model {
            continue;
        }
        let (_, points) = member.part.elements();
        for (i, &e) in patch.elements.iter().enumerate() {
            slots[e as usize] = Some(ElementSlot {
                point: (slices.points.start + i * points) as u32,
                points: points as u8,
                places: model.points(&model.bodies[patch.body], e),
                element: (slices.elements.start + i) as u32,
                member: m,
                patch: number as u32,
            });
        }
    }
    slots
}
