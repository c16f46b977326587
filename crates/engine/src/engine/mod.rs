//! The step: explicit, central differences, second order in Δt with every kind of damping (`wang2018` (20)–(27)).
//!
//! With D = M⁻¹C for Rayleigh's damping and a = M⁻¹(F + P − f_int), (20) and the corrected (21), whose forces are those
//! at u^{n+1}, are exactly the leapfrog
//!
//! v̂ = v⁻ + ½Δt (a^n − D v⁻),  v⁺ = v⁻ + Δt (a^n − D v̂),  u^{n+1} = u^n + Δt v⁺,
//!
//! where v⁻ = (u^n − u^{n−1})/Δt and v̂ is the v^n of (21): insert (21) into (20). So the state is u^n and
//! u^n − u^{n−1}, and one evaluation of the forces makes a step.
//!
//! **Dashpots** of boundaries act on ½(v⁻ + v⁺) instead, which lumped matrices allow at the price of a 3×3 solve a
//! boundary node. Inside the C of (20) they would multiply the mass of their node by 1/(1 − ½Δt D); at an absorbing
//! base ½Δt D = c Δt/h is near 1, and the base would reflect with order 1 in h (verification problem
//! `incident_pulse`).
//!
//! **Passes.** A step is: evaluate the parts at u^n, combine what they push with, advance the nodes pass by pass with leaders first,
//! book, and go on with u^{n+1}. An [`Evaluated`] state is the state and the forces made from it in one value: nothing else can be
//! stepped with them. What is planned to be seen is probed as the parts are evaluated; a [look](Engine::look) at any other time
//! evaluates them on copies of their memory. So looking changes nothing. A [glance](See::Glance) probes some members alone and books
//! nothing, for those who follow stresses in every step.
//!
//! **Levels.** In the shaking nodes of level l make steps of 2^l Δt ([`Levels`](crate::Levels)), and each part steps as the finest
//! node that it pushes. The state keeps increments a step of the finest level, whoever's they are. Coarser nodes that a part pushes or
//! reads drift: they go on by that increment in every step; others jump to the end of their own step at once, since nobody asks for them
//! before. Only at steps that the coarsest level has in common with all is a state whole; nothing else is ever shown.
//!
//! A drifting node is pushed at its own times alone, while a finer part works on it at all times of the part's. What the part's
//! trapezoidal rule finds beyond the node's is the line [`Levels`](tremolite_kernels::Line::Levels) of the balance, exactly.
//!
//! **Balance.** Multiplying by the mean increment ½(Δu^n + Δu^{n+1}) makes every line of the ledger exact: the change
//! of ½ v⁻ᵀM v⁻ equals the work of all forces. Contributions of parts are summed node by node in the order of parts,
//! chunks of nodes in ascending order, so bits do not depend on threads.

mod accounts;
mod asked;
mod balance;
mod bonded;
mod drive;
mod evaluated;
mod evaluation;
mod freed;
mod gather;
mod guard;
mod hand_over;
mod highest;
mod lent;
mod measure;
mod node_step;
mod nodes;
mod power;
mod product;
mod proof;
mod rates;
mod relax;
mod snapshot;
mod soaked;
mod split;
mod start;
mod strained;
mod take_over;

pub use evaluated::{Evaluated, Look, See, Seen};
pub use guard::{Found, Halt};
pub use power::{ContactLimit, Limit, StableStep, stable_step, viscous_share};
pub use proof::{Proof, TRIED, prove};
pub use relax::{Relaxed, Release, Rest, Watch};
pub use snapshot::{BodyBooks, Snapshot};

use crate::assembly::Assembly;
use crate::bytes::{Bytes, bytes};
use crate::exchange::To;
use crate::model::Model;
use crate::phase::Phase;
use crate::ranks::Ranks;
use crate::ranks::{Tree, Words};
use crate::state::State;
use crate::sums::over_nodes;
use evaluation::Forces;
use rayon::prelude::*;
use std::collections::HashSet;
use std::ops::Range;
use std::sync::Arc;

/// The engine for a phase of a model, in one process or on one of several ranks. It shares them and owns nothing but room: a state is given
/// to it. On several ranks all of them call the same functions in the same order.
pub struct Engine {
    model: Arc<Model>,
    assembly: Arc<Assembly>,
    phase: Arc<Phase>,
    /// Of the last evaluation, and room for the next; empty while an [`Evaluated`] state has it.
    forces: Forces,
    /// Whether loads and waves stay as they are just before t = 0.
    quiet: bool,
    /// Energy that the guard leaves to noise \[J\].
    noise: f64,
    /// Whether everything that a part did not name is not a number to it.
    poisoned: bool,
    /// Members whose stresses a glance shows.
    glanced: HashSet<u32>,
    /// Room of the first of several ranks.
    shown: evaluated::Shown,
    /// The rank that it is, where several work on the model.
    ranks: Option<Arc<Ranks>>,
}

impl Engine {
    /// An engine for a phase of a model.
    pub fn new(model: &Arc<Model>, assembly: &Arc<Assembly>, phase: &Arc<Phase>) -> Self {
        Engine {
            forces: Forces::room(model, assembly, phase),
            quiet: false,
            noise: guard::noise(model, phase),
            poisoned: false,
            glanced: HashSet::new(),
            shown: Default::default(),
            ranks: None,
            model: model.clone(),
            assembly: assembly.clone(),
            phase: phase.clone(),
        }
    }

    /// An engine for what a rank has of a phase, if there are several: a state is then known to it as far as that goes, and [made
    /// whole](Engine::whole) where somebody wants it.
    pub fn among(
        model: &Arc<Model>,
        assembly: &Arc<Assembly>,
        phase: &Arc<Phase>,
        ranks: Option<&Arc<Ranks>>,
    ) -> Self {
        match ranks {
            None => Engine::new(model, assembly, phase),
            Some(ranks) => {
                let own = ranks.phase(model, assembly, phase);
                Engine { ranks: Some(ranks.clone()), ..Engine::new(model, assembly, &own) }
            }
        }
    }

    /// Makes whole on all ranks, if there are several, how nodes move in a state and what is booked.
    pub fn whole(&self, state: &mut State) {
        if let Some(ranks) = &self.ranks {
            ranks.whole(&self.model, state, To::All);
        }
    }

    /// Forgets what others have of a state, where ranks are poisoned.
    pub fn own(&self, state: &mut State) {
        if let Some(ranks) = &self.ranks {
            ranks.poison(&self.phase, state);
        }
    }

    /// The sum over all nodes of what `one` finds in a block of them.
    fn over_nodes<T: Words + Default + Send>(
        &self,
        width: usize,
        one: impl Fn(Range<usize>) -> T + Sync,
        plus: impl Fn(T, T) -> T,
    ) -> T {
        let nodes = &self.model.nodes;
        let Some(ranks) = &self.ranks else { return over_nodes(nodes, one, plus) };
        let of = &ranks.division.of_block;
        let own: Vec<_> = nodes.blocks.iter().zip(of).filter(|(_, of)| **of == ranks.rank()).collect();
        let own: Vec<T> = own.into_par_iter().map(|(block, _)| one(block.nodes.clone())).collect();
        let tree = Tree::new(of.clone(), ranks.rank(), own);
        ranks.sums(width, vec![tree], plus).pop().unwrap_or_default()
    }

    /// What some nodes have, for all: found, by place in the list, by who adds up there.
    fn at_nodes<T: Words>(&self, nodes: &[u32], width: usize, one: impl Fn(usize) -> T) -> Vec<T> {
        let Some(ranks) = &self.ranks else { return (0..nodes.len()).map(one).collect() };
        let block = |n: u32| self.model.nodes.blocks.partition_point(|block| block.nodes.end <= n as usize);
        let of: Vec<u32> = nodes.iter().map(|&n| ranks.division.of_block[block(n)]).collect();
        let own = (0..nodes.len()).filter(|&k| of[k] == ranks.rank());
        let own: Vec<T> = own.map(one).collect();
        ranks.rows(&of, &own, width)
    }

    /// Numbers that the first rank has found, for all.
    pub fn from_first(&self, words: &[f64]) -> Vec<f64> {
        self.ranks.as_ref().map_or_else(|| words.to_vec(), |ranks| ranks.from_first(words))
    }

    /// Whether this process evaluates a member.
    fn has(&self, member: usize) -> bool {
        self.ranks.as_ref().is_none_or(|ranks| ranks.division.of_member[member] == ranks.rank())
    }

    /// From now on everything that a part did not name among its nodes or in [`Part::reads`](crate::parts::Part::reads) is not a
    /// number to it: a mode for tests, many times slower, with the same bits where every part names what it reads.
    #[must_use]
    pub fn poisoned(mut self) -> Self {
        self.poisoned = true;
        self
    }

    /// Says of which members a [glance](See::Glance) shows the stresses.
    pub fn glance_at(&mut self, members: impl IntoIterator<Item = u32>) {
        self.glanced = members.into_iter().collect();
    }

    /// Bytes that this process holds of a state and its parts.
    pub fn bytes(&self, state: &State) -> Bytes {
        let pushes = [&self.forces.contributions[..], self.forces.rates.contributions()];
        bytes(&self.assembly, &self.phase, state, pushes)
    }

    pub fn phase(&self) -> &Arc<Phase> {
        &self.phase
    }

    /// One step of the coarsest level, at whose ends all levels have their own times.
    pub fn step(&mut self, state: &mut State) {
        for _ in 0..self.phase.span() {
            let evaluated = self.evaluate(std::mem::take(state), See::Nothing);
            *state = self.advance(evaluated);
        }
    }
}
