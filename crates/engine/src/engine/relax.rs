//! Adaptive dynamic relaxation: to rest without a system of equations (`underwood1983`).
//!
//! With Δτ = 1 and masses scaled so that each element alone has ω_e Δτ = 1.8,
//!
//! Δu⁺ = \[(1 − c/2) Δu + M⁻¹R\]/(1 + c/2),  R = −f + s H,
//!
//! where f is the force of all parts and H what f was at the start: held, so that nothing moves, and let go over the first
//! cycles down to the share that stays, s from 1 to 1 − λ. So a load, a weight, a part that is gone and one that is new are all
//! the same thing: what they leave out of balance.
//!
//! The damping is critical for what moves: c = 2 √(Δu·(fⁿ − fⁿ⁻¹)/(Δu·MΔu)), the secant along the motion; where that is
//! negative the last value stays. It is followed by a tenth a cycle, as sums of one cycle serve the next.
//!
//! The damping takes c v̄·Mv̄ a cycle, v̄ = ½(Δuⁿ + Δuⁿ⁺¹), exactly: what is let go at once goes there, and so does what a specimen
//! lets go that snaps back.
//!
//! Nodes that a stage moves go evenly from where they are to where they shall be, over the same cycles.
//!
//! **At rest** when what is out of balance is a small share of all contributions, and the motion that is left, max |Δu|/(c/2), is
//! a small share of the stage's own; never before all is let go that shall be. By the largest motion of any stage a lining that is
//! placed behind a large excavation would be at rest with a third of its forces missing.

use super::Engine;
use super::evaluation::Forces;
use super::gather::{dot, expect, force};
use super::split::split;
use super::strained;
use crate::assembly::Assembly;
use crate::hexahedra::hex;
use crate::life::Stage;
use crate::model::Model;
use crate::node_table::{Block, Domain};
use crate::phase::Phase;
use crate::ranks::{Tree, Words};
use crate::state::{Relaxing, State};
use crate::sums::tree;
use rayon::prelude::*;
use tremolite_laws::Row;
use tremolite_laws::shapes::hex8::Hex8;

/// How a state is brought to rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Release {
    /// Share λ of what is held that goes.
    pub share: f64,
    /// Cycles over which it goes.
    pub cycles: u64,
    /// Σ|R| over Σ|contributions|, and motion left over the stage's own (or a hundredth of the largest before), at rest.
    pub tolerance: [f64; 2],
    /// Cycles after which it is given up.
    pub most: u64,
}

impl Default for Release {
    fn default() -> Self {
        Release { share: 1.0, cycles: 200, tolerance: [1e-5, 1e-3], most: 20_000 }
    }
}

/// How near to rest a state is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rest {
    pub cycles: u64,
    /// Σ|R| over Σ|contributions|.
    pub ratio: f64,
    /// Estimate of the motion that is left \[m\].
    pub left: f64,
    /// Largest motion since the start of the relaxation \[m\].
    pub motion: f64,
    /// The engine node that moves fastest.
    pub fastest: u32,
    /// Work \[J\] that its damping took: what went neither into what is held by the parts nor into what they dissipate.
    pub damped: f64,
    /// Σ|forces of parts| over Σ|contributions|, where nothing is held: what is not let go yet counts as out of balance.
    pub unreleased: f64,
}

/// How a relaxation ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Relaxed {
    AtRest(Rest),
    /// It was told to stop before its next cycle.
    Stopped(Rest),
    /// Not at rest after the most cycles, or with numbers that are not finite.
    Restless(Rest),
    /// An element strains by a tenth or moves by more than its own length: what is not held falls.
    Torn(Rest, u32),
}

/// Told of every cycle before it is made; says whether to go on.
pub type Watch<'w> = dyn FnMut(&mut State, &Rest) -> bool + 'w;

/// ω_e Δτ of each element alone: 2 would be its limit.
const COURANT: f64 = 1.8;
/// c² below this share is no estimate of what is left.
const LEAST_DAMPING: f64 = 1e-3;
/// Beyond this, motion would turn back in every cycle.
const MOST_DAMPING: f64 = 1.9;
/// How far c follows its estimate in a cycle.
const FOLLOW: f64 = 0.1;
/// Share of the largest motion of the stages before that a stage may count as its own: a lining that is placed moves a
/// hundredth of what the excavation did, and what is left must be small beside that.
const SMALL: f64 = 0.01;
/// Share of the largest contributions of a stage below which there are no forces left.
const GONE: f64 = 1e-8;
/// Motion \[m\] that is none.
const STILL: f64 = 1e-9;
/// Cycles between looks at how far elements have strained.
const LOOK: u64 = 100;

/// Sums of a node pass.
#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    unbalanced: f64,
    unreleased: f64,
    contributions: f64,
    /// Δuⁿ·fⁿ, Δuⁿ·MΔuⁿ, and Δuⁿ⁺¹·fⁿ.
    work: f64,
    inertia: f64,
    next_work: f64,
    /// c v̄·Mv̄.
    damped: f64,
    /// max |Δuⁿ| with its node, and max |uⁿ − u⁰|.
    step: f64,
    fastest: u32,
    motion: f64,
}

impl Sums {
    fn plus(self, o: Sums) -> Sums {
        let (step, fastest) =
            if o.step > self.step { (o.step, o.fastest) } else { (self.step, self.fastest) };
        Sums {
            unbalanced: self.unbalanced + o.unbalanced,
            unreleased: self.unreleased + o.unreleased,
            contributions: self.contributions + o.contributions,
            work: self.work + o.work,
            inertia: self.inertia + o.inertia,
            next_work: self.next_work + o.next_work,
            damped: self.damped + o.damped,
            step,
            fastest,
            motion: self.motion.max(o.motion),
        }
    }
}

impl Sums {
    const WIDTH: usize = 10;
}

impl Words for Sums {
    fn put(&self, words: &mut Vec<f64>) {
        let Sums {
            unbalanced,
            unreleased,
            contributions,
            work,
            inertia,
            next_work,
            damped,
            step,
            fastest,
            motion,
        } = *self;
        let sums = [unbalanced, unreleased, contributions, work, inertia, next_work, damped];
        words.extend(sums);
        words.extend([step, f64::from(fastest), motion]);
    }

    fn take(words: &[f64]) -> Self {
        let [unbalanced, unreleased, contributions, work, inertia, next_work, damped, step, fastest, motion] =
            Words::take(words);
        let fastest = fastest as u32;
        Sums {
            unbalanced,
            unreleased,
            contributions,
            work,
            inertia,
            next_work,
            damped,
            step,
            fastest,
            motion,
        }
    }
}

fn length(row: Row) -> f64 {
    dot(row, row).sqrt()
}

/// Masses by engine node, tied ones with their master, such that every element alone has the same ω_e.
pub fn masses(model: &Model, assembly: &Assembly, phase: &Phase) -> Vec<f64> {
    let mut masses = vec![0.0; phase.master.len()];
    let mut add = |node: u32, mass: f64| masses[phase.master[node as usize] as usize] += mass;
    // Shapes side by side, some members at a time; added in the order of members.
    for some in phase.active.chunks(MEMBERS_AT_ONCE) {
        let of_patches: Vec<_> = some.par_iter().map(|&m| patch_masses(model, assembly, m)).collect();
        for (&m, of_patch) in some.iter().zip(of_patches) {
            for &(node, stiffness) in &assembly.members[m as usize].springs {
                add(node, 2.0 * stiffness / (COURANT * COURANT));
            }
            of_patch.into_iter().for_each(|(node, mass)| add(node, mass));
        }
    }
    masses
}

/// Members whose masses are found at once: so many bound the room that these take.
const MEMBERS_AT_ONCE: usize = 256;

/// The same of a patch's elements at their nodes, element by element; none of another member.
fn patch_masses(model: &Model, assembly: &Assembly, member: u32) -> Vec<(u32, f64)> {
    let Some(patch) = assembly.members[member as usize].kind.patch() else { return Vec::new() };
    let patch = &model.patches[patch];
    let body = &model.bodies[patch.body];
    // `Assembly::new` has checked every element.
    let own = patch.elements.iter().filter_map(|&e| Some((e, hex(&model.mesh, e as usize).ok()?)));
    let of_element = |(element, hex): (u32, Hex8)| {
        let density = body.density * (model.elements.frequencies[element as usize] / COURANT).powi(2);
        let nodes = crate::hexahedra::hex_nodes(&model.mesh, element as usize);
        let engine_nodes = nodes.map(|node| model.engine_node[node as usize]);
        std::iter::zip(engine_nodes, hex.corner_volumes.map(|volume| density * volume))
    };
    own.flat_map(of_element).collect()
}

impl Engine {
    /// Brings a state to rest under all active parts of a phase before the shaking. What is out of balance at first is held,
    /// and `release` says how much of it goes; the rest stays in [`State::held`]. A state whose relaxation was begun goes on.
    ///
    /// # Errors
    /// How far it is from rest after the most cycles; the state is then that of the last one.
    pub fn relax(&mut self, state: &mut State, release: &Release) -> Result<Rest, Rest> {
        match self.relax_watched(state, release, &mut |_, _| true) {
            Relaxed::AtRest(rest) => Ok(rest),
            Relaxed::Stopped(rest) | Relaxed::Restless(rest) | Relaxed::Torn(rest, _) => Err(rest),
        }
    }

    /// The same, watched.
    ///
    /// The initial equilibrium is found first as if interfaces that begin under load were not there, so that it is the same
    /// whatever their stiffness. Then their pairs are given what passed between their sides, and if some cannot bear it, it goes
    /// on with them.
    pub fn relax_watched(&mut self, state: &mut State, release: &Release, watch: &mut Watch) -> Relaxed {
        let begins = self.phase.stage == Stage::Before(0) && state.relaxing.freed == 0;
        let relaxed =
            match begins && self.assembly.contacts.iter().any(|contacts| !contacts.loaded.is_empty()) {
                true => self.bonded_then_free(state, release, watch),
                false => self.come_to_rest(state, release, watch),
            };
        if let Relaxed::AtRest(rest) = &relaxed {
            state.relaxing = Relaxing::default();
            state.moved = state.moved.max(rest.motion);
            if let Stage::Before(k) = self.phase.stage {
                state.stage = u64::from(k) + 1;
                if k == 0 {
                    state.datum = state.u.clone();
                }
            }
            // What laws remember of the strain is that of the end.
            self.evaluate_at(state, None);
        }
        relaxed
    }

    /// Until it is at rest, or given up.
    pub(super) fn come_to_rest(
        &mut self,
        state: &mut State,
        release: &Release,
        watch: &mut Watch,
    ) -> Relaxed {
        let masses = masses(&self.model, &self.assembly, &self.phase);
        if state.relaxing.cycle == 0 {
            // Who begins takes over from others, or follows other nodes than before.
            self.whole(state);
            self.wake(state);
            self.enter(state);
            self.evaluate_at(state, None);
            state.held = self.forces_now(state.u.len());
            let freed = state.relaxing.freed;
            if freed == 0 {
                state.start = state.u.clone();
            }
            state.du.fill(Row::ZERO);
            state.relaxing = Relaxing { cycle: 1, freed, ..Relaxing::default() };
        }
        self.own(state);
        let mut rest = Rest::default();
        loop {
            if !watch(state, &rest) {
                return Relaxed::Stopped(rest);
            }
            self.evaluate_at(state, None);
            let let_go = (state.relaxing.cycle as f64 / release.cycles.max(1) as f64).min(1.0);
            let share = 1.0 - release.share * let_go;
            let sums = self.relaxation_step(state, &masses, share, let_go);
            let Relaxing { cycle, damping, work, damped, most, .. } = &mut state.relaxing;
            *damped += sums.damped;
            let squared = (sums.work - *work) / sums.inertia;
            if squared > 0.0 {
                let wanted = 2.0 * squared.sqrt();
                *damping = (*damping + FOLLOW * (wanted - *damping)).min(MOST_DAMPING);
            }
            *work = sums.next_work;
            *most = most.max(sums.contributions);
            // What is left of forces that are gone balances nothing: it is round-off.
            let gone = sums.contributions <= GONE * *most;
            rest = Rest {
                cycles: *cycle,
                ratio: if gone { 0.0 } else { sums.unbalanced / sums.contributions },
                left: sums.step / (0.5 * *damping).max(LEAST_DAMPING),
                motion: sums.motion,
                fastest: sums.fastest,
                damped: *damped,
                unreleased: if sums.contributions > 0.0 { sums.unreleased / sums.contributions } else { 0.0 },
            };
            let enough = release.tolerance[1] * rest.motion.max(SMALL * state.moved);
            let still = rest.left <= STILL.max(enough);
            if *cycle > release.cycles && rest.ratio <= release.tolerance[0] && still {
                state.du.fill(Row::ZERO);
                for held in &mut state.held {
                    *held = Row(held.0.map(|h| share * h));
                }
                return Relaxed::AtRest(rest);
            }
            // A ratio that is not a number is no rest either.
            if *cycle >= release.most || !rest.ratio.is_finite() {
                return Relaxed::Restless(rest);
            }
            *cycle += 1;
            if state.relaxing.cycle.is_multiple_of(LOOK)
                && let Some(element) = self.torn(state)
            {
                return Relaxed::Torn(rest, element);
            }
        }
    }

    /// The first element that is torn.
    fn torn(&self, state: &State) -> Option<u32> {
        let own = strained::torn(&self.model, &self.assembly, &self.phase, state);
        let Some(ranks) = &self.ranks else { return own.map(|[_, element]| element) };
        let of: Vec<u32> = (0..ranks.division.ranks).collect();
        let own = own.map_or([f64::INFINITY; 2], |own| own.map(f64::from));
        let all = ranks.rows(&of, &[own], 2);
        let first = all.into_iter().min_by(|a, b| a[0].total_cmp(&b[0]))?;
        first[0].is_finite().then_some(first[1] as u32)
    }

    /// uⁿ to uⁿ⁺¹ with the forces just evaluated, this share of what is held, and this share of the way of what is moved.
    fn relaxation_step(&self, state: &mut State, masses: &[f64], share: f64, way: f64) -> Sums {
        let Engine { phase, forces: Forces { contributions, .. }, .. } = self;
        let c = state.relaxing.damping;
        let (keep, push) = ((1.0 - 0.5 * c) / (1.0 + 0.5 * c), 1.0 / (1.0 + 0.5 * c));
        let (held, start) = (&state.held, &state.start);
        let all = &self.model.nodes.blocks;
        let some: Vec<&Block> = match &phase.ours {
            None => all.iter().collect(),
            Some(ours) => ours.blocks.iter().map(|&b| &all[b as usize]).collect(),
        };
        let blocks = &some[..];
        let rows = split(&mut state.u, blocks, |block| block.nodes.clone()).into_iter().zip(split(
            &mut state.du,
            blocks,
            |block| block.nodes.clone(),
        ));
        let sums: Vec<Sums> = blocks
            .iter()
            .zip(rows)
            .collect::<Vec<_>>()
            .into_par_iter()
            .map(|(block, (u, du))| {
                let counts = block.domain == Domain::Model;
                let mut sums = Sums::default();
                for (k, (u, du)) in u.iter_mut().zip(du).enumerate() {
                    let node = block.nodes.start + k;
                    expect(phase, contributions, node);
                    let slots = phase.start[node] as usize..phase.start[node + 1] as usize;
                    if slots.is_empty() {
                        continue;
                    }
                    let force = force(phase, contributions, node);
                    let free = phase.inverse_mass[node].0.map(|w| f64::from(u8::from(w > 0.0)));
                    let mut out = Row::ZERO;
                    let mut next = Row::ZERO;
                    for i in 0..3 {
                        out.0[i] = free[i] * (share * held[node].0[i] - force.0[i]);
                        next.0[i] = free[i] * (keep * du.0[i] + push * out.0[i] / masses[node]);
                    }
                    sums.unbalanced += length(out);
                    sums.unreleased += length(Row([0, 1, 2, 3].map(|i| free[i] * force.0[i])));
                    for &slot in &phase.slot[slots] {
                        sums.contributions += length(contributions[slot as usize]);
                    }
                    sums.work += dot(*du, force);
                    sums.inertia += masses[node] * dot(*du, *du);
                    sums.next_work += dot(next, force);
                    // Over the free components alone: what is moved has no inertia.
                    let mean = Row([0, 1, 2, 3].map(|i| 0.5 * free[i] * (du.0[i] + next.0[i])));
                    sums.damped += c * masses[node] * dot(mean, mean);
                    // The reference column is at rest with what is out of balance.
                    if counts {
                        let step = length(*du);
                        if step > sums.step {
                            (sums.step, sums.fastest) = (step, node as u32);
                        }
                        let moved = Row([0, 1, 2, 3].map(|i| u.0[i] - start[node].0[i]));
                        sums.motion = sums.motion.max(length(moved));
                    }
                    for i in 0..3 {
                        u.0[i] += next.0[i];
                    }
                    *du = next;
                }
                sums
            })
            .collect();
        let moved = self.move_driven(state, way);
        for &(node, master) in phase.tied.iter().filter(|(node, _)| phase.holds(*node)) {
            let next = state.du[master as usize];
            for i in 0..3 {
                state.u[node as usize].0[i] += next.0[i];
            }
            state.du[node as usize] = next;
        }
        let mut sums = match (&self.ranks, &phase.ours) {
            (Some(ranks), Some(ours)) => {
                let of = &ranks.division.of_block;
                let own = ours.blocks.iter().zip(sums).filter(|(b, _)| of[**b as usize] == ranks.rank());
                let tree = Tree::new(of.clone(), ranks.rank(), own.map(|(_, sums)| sums));
                ranks.sums(Sums::WIDTH, vec![tree], Sums::plus).pop().unwrap_or_default()
            }
            _ => tree(sums, Sums::plus),
        };
        sums.next_work += moved;
        sums
    }
}
