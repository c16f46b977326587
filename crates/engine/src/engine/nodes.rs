//! The passes over nodes: contributions to forces, forces to motion.

use super::accounts::Accounts;
use super::gather::{dot, force, net};
use super::node_step::{Damping, Dashpots, Lead, NodeStep, Products, damping, node_step};
use super::split::split;
use crate::model::Model;
use crate::phase::Phase;
use crate::phase::passes::{BLOCK, Block};
use crate::state::State;
use rayon::prelude::*;
use tremolite_kernels::{Line, Lines};
use tremolite_laws::{Isa, Row};

/// What a pass adds up over the nodes that count \[J\].
#[derive(Clone, Debug, Default)]
pub struct NodeSums {
    /// Of v⁻ when advancing, of v̂ when measuring.
    pub kinetic: f64,
    /// Work against each damping over the half-steps that meet at u^n; only the first of them when measuring.
    pub rayleigh: f64,
    pub base_dashpots: f64,
    pub side_dashpots: f64,
    /// Work of the dashpots of free-field sides on the nodes, likewise.
    pub free_field: f64,
    /// Work against the forces of elements by account, likewise.
    pub bodies: Vec<f64>,
    /// ⅛Δt²aᵀMa when measuring: by so much ½v̂ᵀMv̂ exceeds the kinetic energy that the scheme conserves.
    pub scheme: f64,
}

impl NodeSums {
    /// Work against the dampings, by line.
    pub fn dampings(&self) -> Lines {
        let mut taken = Lines::default();
        taken[Line::Rayleigh] = self.rayleigh;
        taken[Line::BaseDashpots] = self.base_dashpots;
        taken[Line::SideDashpots] = self.side_dashpots;
        taken
    }

    fn plus(mut self, o: NodeSums) -> NodeSums {
        self.kinetic += o.kinetic;
        self.rayleigh += o.rayleigh;
        self.base_dashpots += o.base_dashpots;
        self.side_dashpots += o.side_dashpots;
        self.free_field += o.free_field;
        self.scheme += o.scheme;
        self.bodies.resize(o.bodies.len(), 0.0);
        for (own, more) in self.bodies.iter_mut().zip(o.bodies) {
            *own += more;
        }
        self
    }
}

impl NodeSums {
    /// Books the work of a node's dampings over an increment.
    #[inline(always)]
    fn book(&mut self, step: &NodeStep, du: Row) {
        self.rayleigh += 0.5 * dot(step.rayleigh, du);
        self.base_dashpots += 0.5 * dot(step.base, du);
        self.side_dashpots += 0.5 * dot(step.sides, du);
        self.free_field += 0.5 * dot(step.free_field, du);
    }
}

/// Leaders that one thread advances: so few that another barrier would cost more.
const FEW: usize = BLOCK;

/// Nodes that one thread works on, with two columns of their rows.
struct Chunk<'c> {
    block: &'c Block,
    rows: [&'c mut [Row]; 2],
    /// Those of them that others follow, and where to leave their velocities.
    leaders: &'c [u32],
    own: &'c mut [Lead],
    /// Velocities of those that were advanced before.
    before: &'c [Lead],
}

/// Works on two columns of rows pass by pass, and adds up by blocks in ascending order.
fn by_passes(
    phase: &Phase,
    leads: &mut [Lead],
    [a, b]: [&mut [Row]; 2],
    one: impl Fn(Chunk) -> NodeSums + Sync,
) -> NodeSums {
    let mut total = NodeSums::default();
    for pass in &phase.passes {
        let first = pass.blocks.first().map_or(0, |block| block.leaders.start);
        let (before, own) = leads.split_at_mut(first);
        let before = &*before;
        let nodes = |block: &Block| block.nodes.clone();
        let rows = split(a, &pass.blocks, nodes).into_iter().zip(split(b, &pass.blocks, nodes));
        let own = split(own, &pass.blocks, |block| block.leaders.start - first..block.leaders.end - first);
        let leads_on = own.iter().any(|own| !own.is_empty());
        let chunks = pass.blocks.iter().zip(rows).zip(own).map(|((block, (a, b)), own)| {
            let leaders = &phase.leaders[block.leaders.clone()];
            Chunk { block, rows: [a, b], leaders, own, before }
        });
        let sums: Vec<NodeSums> = if leads_on && pass.nodes() <= FEW {
            chunks.map(&one).collect()
        } else {
            chunks.collect::<Vec<_>>().into_par_iter().with_max_len(1).map(&one).collect()
        };
        total = sums.into_iter().fold(total, NodeSums::plus);
    }
    total
}

/// u^n to u^{n+1}; `leads` is room for what leaders leave.
pub fn advance(
    model: &Model,
    phase: &Phase,
    contributions: &[Row],
    products: &Products,
    leads: &mut [Lead],
    state: &mut State,
) -> NodeSums {
    let damping = damping(model, state);
    let accounts = state.ledger.bodies.len();
    let State { u, du, held, .. } = state;
    let wide = Isa::Avx2.available();
    let pass = Advance { phase, contributions, held, products, damping, accounts, wide };
    let mut sums = by_passes(phase, leads, [u, du], |chunk| pass.chunk(chunk));
    for &(node, master) in &phase.tied {
        let next = state.du[master as usize];
        for i in 0..4 {
            state.u[node as usize].0[i] += next.0[i];
        }
        state.du[node as usize] = next;
    }
    sums.kinetic /= state.dt * state.dt;
    sums
}

/// What a chunk's advance needs besides its rows.
struct Advance<'a> {
    phase: &'a Phase,
    contributions: &'a [Row],
    held: &'a [Row],
    products: &'a Products,
    damping: Damping,
    accounts: usize,
    /// Whether the processor has AVX2. No operation is fused, so the bits are the same without it.
    wide: bool,
}

impl Advance<'_> {
    fn chunk(&self, chunk: Chunk) -> NodeSums {
        #[cfg(target_arch = "x86_64")]
        if self.wide {
            #[target_feature(enable = "avx2")]
            unsafe fn wide(pass: &Advance, chunk: Chunk) -> NodeSums {
                pass.nodes(chunk)
            }
            // SAFETY: `wide` says that the processor has AVX2.
            return unsafe { wide(self, chunk) };
        }
        let _ = self.wide;
        self.nodes(chunk)
    }

    #[inline(always)]
    fn nodes(&self, chunk: Chunk) -> NodeSums {
        match chunk.own.is_empty() {
            true => self.nodes_of::<false>(chunk),
            false => self.nodes_of::<true>(chunk),
        }
    }

    /// With `LEADS` the nodes leave their velocities to those who follow.
    #[inline(always)]
    fn nodes_of<const LEADS: bool>(&self, chunk: Chunk) -> NodeSums {
        let Chunk { block, rows: [u, du], leaders, own, before } = chunk;
        let (first, counts) = (block.nodes.start, block.counts);
        let mut leaders = leaders.iter().zip(own).peekable();
        let Advance { phase, contributions, held, products, damping, .. } = self;
        let (dt, omega) = (damping.dt, damping.mass_proportional);
        let mut dashpots = Dashpots::from(phase, first);
        let mut sums = NodeSums::default();
        let mut accounts = Accounts::new(phase, contributions, self.accounts);
        // Without dashpots and ξ the step is Δu ← keep Δu + push a, and v̂ = (fade Δu/Δt) + ½Δt a.
        let fade = 1.0 - 0.5 * omega * dt;
        let (keep, push) = (1.0 - omega * dt * fade, dt * dt * fade);
        let simple = damping.stiffness_proportional == 0.0;
        for (k, (u, du)) in u.iter_mut().zip(du).enumerate() {
            let node = first + k;
            let dashpot = dashpots.take(node);
            let mut lead = match LEADS {
                true => leaders.next_if(|(leader, _)| **leader as usize == node).map(|(_, lead)| lead),
                false => None,
            };
            // Tied nodes follow their master; nodes that no part pushes stay.
            if phase.start[node] == phase.start[node + 1] {
                continue;
            }
            let force = force(phase, contributions, node);
            let net = net(held, node, force);
            let mut next = Row::ZERO;
            let mass = if counts { phase.mass[node] } else { 0.0 };
            if simple && dashpot.is_none() {
                let inverse = &phase.inverse_mass[node];
                let mut rayleigh = 0.0;
                for i in 0..4 {
                    let a = -net.0[i] * inverse.0[i];
                    next.0[i] = keep * du.0[i] + push * a;
                    rayleigh += (fade * du.0[i] + 0.5 * dt * dt * a) * (du.0[i] + next.0[i]);
                    if LEADS && let Some(lead) = &mut lead {
                        lead.mean.0[i] = 0.5 * (du.0[i] + next.0[i]) / dt;
                        lead.hat.0[i] = (fade * du.0[i] + 0.5 * dt * dt * a) / dt;
                    }
                }
                sums.rayleigh += 0.5 * omega / dt * mass * rayleigh;
            } else {
                let step = node_step(damping, phase, products, before, dashpot, node, net, *du);
                for i in 0..4 {
                    next.0[i] = du.0[i] + dt * dt * step.acceleration.0[i];
                }
                if let Some(lead) = lead {
                    *lead = Lead { mean: step.mean, hat: step.velocity };
                }
                if counts {
                    sums.book(&step, Row([0, 1, 2, 3].map(|i| du.0[i] + next.0[i])));
                }
            }
            if counts {
                let twice = Row([0, 1, 2, 3].map(|i| du.0[i] + next.0[i]));
                accounts.book(node, force, twice);
            }
            sums.kinetic += 0.5 * mass * dot(*du, *du);
            for i in 0..4 {
                u.0[i] += next.0[i];
            }
            *du = next;
        }
        NodeSums { bodies: accounts.close(), ..sums }
    }
}

/// v̂ and dv/dt by engine node at u^n; the state is left alone.
pub fn measure(
    model: &Model,
    phase: &Phase,
    contributions: &[Row],
    products: &Products,
    state: &State,
) -> (NodeSums, Vec<Row>, Vec<Row>) {
    let damping = damping(model, state);
    let accounts = state.ledger.bodies.len();
    let mut velocity = vec![Row::ZERO; state.u.len()];
    let mut acceleration = vec![Row::ZERO; state.u.len()];
    let mut leads = vec![Lead::default(); phase.leaders.len()];
    let sums = by_passes(
        phase,
        &mut leads,
        [&mut velocity, &mut acceleration],
        |Chunk { block, rows: [velocity, acceleration], leaders, own: leading, before }| {
            let first = block.nodes.start;
            let mut leaders = leaders.iter().zip(leading).peekable();
            let mut dashpots = Dashpots::from(phase, first);
            let mut sums = NodeSums::default();
            let mut own = Accounts::new(phase, contributions, accounts);
            for (k, (velocity, acceleration)) in velocity.iter_mut().zip(acceleration).enumerate() {
                let node = first + k;
                let dashpot = dashpots.take(node);
                let lead = leaders.next_if(|(leader, _)| **leader as usize == node).map(|(_, lead)| lead);
                // As when advancing: nodes that no part pushes stay.
                if phase.start[node] == phase.start[node + 1] {
                    continue;
                }
                let du = state.du[node];
                let force = force(phase, contributions, node);
                let net = net(&state.held, node, force);
                let step = node_step(&damping, phase, products, before, dashpot, node, net, du);
                if let Some(lead) = lead {
                    *lead = Lead { mean: step.mean, hat: step.velocity };
                }
                if block.counts {
                    let mass = phase.mass[node];
                    sums.kinetic += 0.5 * mass * dot(step.velocity, step.velocity);
                    sums.scheme +=
                        0.125 * state.dt * state.dt * mass * dot(step.acceleration, step.acceleration);
                    sums.book(&step, du);
                    own.book(node, force, du);
                }
                *velocity = step.velocity;
                *acceleration = step.acceleration;
            }
            NodeSums { bodies: own.close(), ..sums }
        },
    );
    for &(node, master) in &phase.tied {
        velocity[node as usize] = velocity[master as usize];
        acceleration[node as usize] = acceleration[master as usize];
    }
    (sums, velocity, acceleration)
}
