//! A state measured node by node, and left alone: velocities, accelerations, energies, and what the first half of its step would book.

use super::accounts::Accounts;
use super::gather::{dot, expect, force, net};
use super::node_step::{Damping, Dashpots, Lead, Products, damping, free_node_step, node_step};
use super::nodes::{Borders, Chunk, Damped, Share, by_passes, given};
use crate::free_field::Leader;
use crate::model::Model;
use crate::phase::Phase;
use crate::phase::beats::span;
use crate::state::{OF_NODES, State};
use tremolite_laws::{Isa, Row};

/// What is measured over the nodes that count.
#[derive(Default)]
pub struct Measured {
    /// By block that was measured, ascending: the kinetic energy of v̂ \[J\], and ⅛Δt²aᵀMa, by so much ½v̂ᵀMv̂ exceeds the kinetic energy that the
    /// scheme conserves.
    pub energies: Vec<(usize, [f64; 2])>,
    /// What the first half of the step at u^n would book, as [`crate::state::Ledger::blocks`] does.
    pub books: Vec<f64>,
    /// v̂ and dv/dt by engine node.
    pub velocity: Vec<Row>,
    pub acceleration: Vec<Row>,
}

/// Measures a state, which is left alone.
pub fn measure(
    model: &Model,
    phase: &Phase,
    contributions: &[Row],
    products: &Products,
    state: &State,
) -> Measured {
    let damping = damping(model, state);
    let mut velocity = vec![Row::ZERO; state.u.len()];
    let mut acceleration = vec![Row::ZERO; state.u.len()];
    let mut leads = vec![Lead::default(); phase.leaders.len()];
    let beat = phase.beat(state);
    given(model, phase, beat, Some(state.time()), state.dt, &mut leads);
    let mut books = vec![0.0; state.ledger.blocks.len()];
    let width = state.ledger.width();
    let wide = Isa::Avx2.available();
    let pass = Measuring { phase, contributions, products, state, damping, wide };
    let found = by_passes(
        (phase, &beat.passes),
        &mut leads,
        [&mut velocity, &mut acceleration],
        (&mut books, width),
        |share| pass.share(share),
    );
    for &(node, master) in &phase.tied {
        velocity[node as usize] = velocity[master as usize];
        acceleration[node as usize] = acceleration[master as usize];
    }
    let mut energies: Vec<(usize, [f64; 2])> = found.into_iter().flatten().collect();
    energies.sort_unstable_by_key(|(block, _)| *block);
    Measured { energies, books, velocity, acceleration }
}

/// What a chunk's measuring needs besides its rows.
struct Measuring<'a> {
    phase: &'a Phase,
    contributions: &'a [Row],
    products: &'a Products,
    state: &'a State,
    damping: Damping,
    /// Whether the processor has AVX2. No operation is fused, so the bits are the same without it.
    wide: bool,
}

impl Measuring<'_> {
    fn share(&self, share: Share) -> Vec<(usize, [f64; 2])> {
        #[cfg(target_arch = "x86_64")]
        if self.wide {
            #[target_feature(enable = "avx2")]
            unsafe fn wide(pass: &Measuring, share: Share) -> Vec<(usize, [f64; 2])> {
                pass.nodes(share)
            }
            // SAFETY: `wide` says that the processor has AVX2.
            return unsafe { wide(self, share) };
        }
        let _ = self.wide;
        self.nodes(share)
    }

    #[inline(always)]
    fn nodes(&self, mut share: Share) -> Vec<(usize, [f64; 2])> {
        let mut found = Vec::new();
        while let Some(chunk) = share.next() {
            found.push((chunk.turn.block, self.nodes_of(chunk)));
        }
        found
    }

    #[inline(always)]
    fn nodes_of(&self, chunk: Chunk) -> [f64; 2] {
        let Chunk { turn, rows: [velocity, acceleration], leaders, own, before, books } = chunk;
        let Measuring { phase, contributions, products, state, .. } = self;
        let first = turn.nodes.start;
        let (books, of_accounts) = books.split_at_mut(OF_NODES);
        let mut leaders = leaders.iter().zip(own).peekable();
        let mut dashpots = Dashpots::from(phase, first);
        let steps = if phase.beats.len() > 1 { span(turn.level) as f64 } else { 1.0 };
        let damping = &Damping { dt: steps * self.damping.dt, ..self.damping };
        let simple = damping.stiffness_proportional == 0.0;
        let mut borders = Borders::from(phase, first);
        let mut sums = Damped::default();
        let mut energies = [0.0; 2];
        let mut accounts = Accounts::new(phase, contributions, of_accounts);
        for (k, (velocity, acceleration)) in velocity.iter_mut().zip(acceleration).enumerate() {
            let node = first + k;
            expect(phase, contributions, node);
            let dashpot = dashpots.take(node);
            let lead = match leaders.peek() {
                None => None,
                Some(_) => leaders.next_if(|(leader, _)| **leader == Leader::Node(node as u32)),
            };
            // As when advancing: nodes that no part pushes stay.
            if phase.start[node] == phase.start[node + 1] {
                continue;
            }
            let mut du = state.du[node];
            for i in 0..4 {
                du.0[i] *= steps;
            }
            let force = force(phase, contributions, node);
            let net = net(&state.held, node, force);
            let step = match simple && dashpot.is_none() {
                true => free_node_step(damping, phase, node, net, du),
                false => node_step(damping, phase, products, before, dashpot, node, net, du),
            };
            if let Some((_, lead)) = lead {
                *lead = Lead { mean: step.mean, hat: step.velocity };
            }
            if turn.counts {
                let mass = phase.mass[node];
                energies[0] += 0.5 * mass * dot(step.velocity, step.velocity);
                energies[1] +=
                    0.125 * damping.dt * damping.dt * mass * dot(step.acceleration, step.acceleration);
                sums.book(&step, du);
                accounts.book(node, force, du);
                if let Some(border) = borders.take(node) {
                    sums.levels += border.meet(phase, contributions, steps, state.du[node], accounts.sums());
                }
            }
            *velocity = step.velocity;
            *acceleration = step.acceleration;
        }
        accounts.close();
        sums.onto(books);
        energies
    }
}
