//! The passes over nodes: contributions to forces, forces to motion.

use super::accounts::Accounts;
use super::gather::{dot, force, net};
use super::product::{self, Product};
use crate::assembly::Assembly;
use crate::boundary::base::times;
use crate::model::Model;
use crate::phase::{Dashpot, Phase};
use crate::state::State;
use rayon::prelude::*;
use tremolite_kernels::{Line, Lines};
use tremolite_laws::{Isa, Row};

/// Nodes a chunk: the unit of threads and of sums, whatever their number.
pub(super) const CHUNK: usize = 2048;

/// What a pass adds up over the nodes that count \[J\].
#[derive(Clone, Debug, Default)]
pub struct NodeSums {
    /// Of v⁻ when advancing, of v̂ when measuring.
    pub kinetic: f64,
    /// Work against each damping over the half-steps that meet at u^n; only the first of them when measuring.
    pub rayleigh: f64,
    pub base_dashpots: f64,
    pub side_dashpots: f64,
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

    fn new(accounts: usize) -> NodeSums {
        NodeSums { bodies: vec![0.0; accounts], ..NodeSums::default() }
    }

    fn plus(mut self, o: NodeSums) -> NodeSums {
        self.kinetic += o.kinetic;
        self.rayleigh += o.rayleigh;
        self.base_dashpots += o.base_dashpots;
        self.side_dashpots += o.side_dashpots;
        self.scheme += o.scheme;
        for (own, more) in self.bodies.iter_mut().zip(o.bodies) {
            *own += more;
        }
        self
    }
}

/// Products with K for ξ ≠ 0; empty otherwise.
#[derive(Clone, Debug, Default)]
pub struct Rates {
    /// K v⁻ and K v̂ by engine node \[N\].
    minus: Vec<Row>,
    hat: Vec<Row>,
    velocity: Vec<Row>,
    contributions: Vec<Row>,
}

impl Rates {
    /// Room for the products, if the model needs them.
    pub fn new(model: &Model, assembly: &Assembly) -> Self {
        if model.rayleigh.stiffness == 0.0 {
            return Rates::default();
        }
        let zero = vec![Row::ZERO; model.mesh_node.len()];
        Rates {
            minus: zero.clone(),
            hat: zero.clone(),
            velocity: zero,
            contributions: vec![Row::ZERO; assembly.totals().contributions.end],
        }
    }

    /// Both products at the state, whose forces are in `contributions`.
    pub fn update(
        &mut self,
        model: &Model,
        assembly: &Assembly,
        phase: &Phase,
        contributions: &[Row],
        state: &State,
    ) {
        if model.rayleigh.stiffness == 0.0 {
            return;
        }
        for (v, du) in self.velocity.iter_mut().zip(&state.du) {
            *v = Row(du.0.map(|d| d / state.dt));
        }
        let damping = Product::Damping(state);
        product::times(assembly, phase, damping, &self.velocity, &mut self.contributions, &mut self.minus);
        // Tied nodes move as their masters, of which alone v̂ is worked out.
        let (_, hat, _) = measure(model, phase, contributions, self, state);
        self.velocity = hat;
        product::times(assembly, phase, damping, &self.velocity, &mut self.contributions, &mut self.hat);
    }

    fn at(rows: &[Row], node: usize) -> Row {
        rows.get(node).copied().unwrap_or(Row::ZERO)
    }
}

/// v̂, dv/dt and the forces of the dampings at a node.
#[derive(Default)]
struct NodeStep {
    velocity: Row,
    acceleration: Row,
    /// Forces at v̂ \[N\]: Rayleigh's, of the base's dashpots, of the sides'.
    rayleigh: Row,
    base: Row,
    sides: Row,
}

/// What a node's step needs besides its rows.
struct Damping {
    dt: f64,
    mass_proportional: f64,
    stiffness_proportional: f64,
}

#[inline(always)]
fn node_step(
    damping: &Damping,
    phase: &Phase,
    rates: &Rates,
    dashpot: Option<&Dashpot>,
    node: usize,
    force: Row,
    du: Row,
) -> NodeStep {
    let inverse = phase.inverse_mass[node];
    let mass = phase.mass[node];
    let Damping { dt, mass_proportional: omega, stiffness_proportional: xi } = *damping;
    let mut step = NodeStep::default();
    let minus = du.xyz().map(|d| d / dt);
    let (k_minus, k_hat) = (Rates::at(&rates.minus, node), Rates::at(&rates.hat, node));
    // Acceleration without the dashpots, Rayleigh's damping at `v` with the product `k`.
    let free = |v: [f64; 3], k: &Row| {
        [0, 1, 2].map(|i| -force.0[i] * inverse.0[i] - omega * v[i] - xi * inverse.0[i] * k.0[i])
    };
    let hat = mean_velocity(dashpot, inverse, dt, minus, free(minus, &k_minus));
    let mean = mean_velocity(dashpot, inverse, dt, minus, free(hat, &k_hat));
    let (base, side) = dashpot_forces(dashpot, mean);
    for i in 0..3 {
        step.velocity.0[i] = hat[i];
        step.acceleration.0[i] = 2.0 * (mean[i] - minus[i]) / dt;
        step.rayleigh.0[i] = omega * mass * hat[i] + xi * k_hat.0[i];
    }
    step.base = Row::new(base);
    step.sides = Row::new(side);
    step
}

/// ½(v⁻ + v⁺) of a node whose dashpots act on that very mean, as lumped dashpots can at no cost: with
/// v⁺ = v⁻ + Δt (a − M⁻¹D ½(v⁻ + v⁺)) it solves (I + ½Δt M⁻¹D)(v̄ − v⁻) = ½Δt (a − M⁻¹D v⁻).
#[inline(always)]
fn mean_velocity(dashpot: Option<&Dashpot>, inverse: Row, dt: f64, minus: [f64; 3], a: [f64; 3]) -> [f64; 3] {
    let Some(dashpot) = dashpot else { return [0, 1, 2].map(|i| minus[i] + 0.5 * dt * a[i]) };
    let d = [0, 1, 2, 3, 4, 5].map(|c| dashpot.base[c] + dashpot.sides[c]);
    let resisted = times(&d, minus);
    let b = [0, 1, 2].map(|i| 0.5 * dt * (a[i] - inverse.0[i] * resisted[i]));
    let w = [0, 1, 2].map(|i| 0.5 * dt * inverse.0[i]);
    let m = [
        [1.0 + w[0] * d[0], w[0] * d[3], w[0] * d[5]],
        [w[1] * d[3], 1.0 + w[1] * d[1], w[1] * d[4]],
        [w[2] * d[5], w[2] * d[4], 1.0 + w[2] * d[2]],
    ];
    let cross = |p: [f64; 3], q: [f64; 3]| {
        [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
    };
    let c = [cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])];
    let determinant = m[0][0] * c[0][0] + m[0][1] * c[0][1] + m[0][2] * c[0][2];
    [0, 1, 2].map(|i| minus[i] + (c[0][i] * b[0] + c[1][i] * b[1] + c[2][i] * b[2]) / determinant)
}

fn dashpot_forces(dashpot: Option<&Dashpot>, v: [f64; 3]) -> ([f64; 3], [f64; 3]) {
    dashpot.map_or(([0.0; 3], [0.0; 3]), |d| (times(&d.base, v), times(&d.sides, v)))
}

impl NodeSums {
    /// Books the work of a node's dampings over an increment.
    #[inline(always)]
    fn book(&mut self, step: &NodeStep, du: Row) {
        self.rayleigh += 0.5 * dot(step.rayleigh, du);
        self.base_dashpots += 0.5 * dot(step.base, du);
        self.side_dashpots += 0.5 * dot(step.sides, du);
    }
}

fn damping(model: &Model, state: &State) -> Damping {
    Damping {
        dt: state.dt,
        mass_proportional: model.rayleigh.mass,
        stiffness_proportional: model.rayleigh.stiffness,
    }
}

/// Dashpots from a node on, in ascending order.
struct Dashpots<'a> {
    rest: &'a [(u32, Dashpot)],
}

impl<'a> Dashpots<'a> {
    fn from(phase: &'a Phase, node: usize) -> Self {
        let first = phase.dashpots.partition_point(|(n, _)| (*n as usize) < node);
        Dashpots { rest: &phase.dashpots[first..] }
    }

    /// The dashpot of a node; nodes must be asked for in ascending order.
    #[inline(always)]
    fn take(&mut self, node: usize) -> Option<&'a Dashpot> {
        match self.rest.first() {
            Some((n, dashpot)) if *n as usize == node => {
                self.rest = &self.rest[1..];
                Some(dashpot)
            }
            _ => None,
        }
    }
}

/// u^n to u^{n+1}.
pub fn advance(
    model: &Model,
    phase: &Phase,
    contributions: &[Row],
    rates: &Rates,
    state: &mut State,
) -> NodeSums {
    let damping = damping(model, state);
    let accounts = state.ledger.bodies.len();
    let State { u, du, held, .. } = state;
    let wide = Isa::Avx2.available();
    let pass = Advance { phase, contributions, held, rates, damping, accounts, wide };
    let sums: Vec<NodeSums> = u
        .par_chunks_mut(CHUNK)
        .zip(du.par_chunks_mut(CHUNK))
        .enumerate()
        .map(|(chunk, (u, du))| pass.chunk(chunk * CHUNK, u, du))
        .collect();
    for &(node, master) in &phase.tied {
        let next = state.du[master as usize];
        for i in 0..4 {
            state.u[node as usize].0[i] += next.0[i];
        }
        state.du[node as usize] = next;
    }
    let mut sums = sums.into_iter().fold(NodeSums::new(accounts), NodeSums::plus);
    sums.kinetic /= state.dt * state.dt;
    sums
}

/// What a chunk's advance needs besides its rows.
struct Advance<'a> {
    phase: &'a Phase,
    contributions: &'a [Row],
    held: &'a [Row],
    rates: &'a Rates,
    damping: Damping,
    accounts: usize,
    /// Whether the processor has AVX2. No operation is fused, so the bits are the same without it.
    wide: bool,
}

impl Advance<'_> {
    fn chunk(&self, first: usize, u: &mut [Row], du: &mut [Row]) -> NodeSums {
        #[cfg(target_arch = "x86_64")]
        if self.wide {
            #[target_feature(enable = "avx2")]
            unsafe fn wide(pass: &Advance, first: usize, u: &mut [Row], du: &mut [Row]) -> NodeSums {
                pass.nodes(first, u, du)
            }
            // SAFETY: `wide` says that the processor has AVX2.
            return unsafe { wide(self, first, u, du) };
        }
        let _ = self.wide;
        self.nodes(first, u, du)
    }

    #[inline(always)]
    fn nodes(&self, first: usize, u: &mut [Row], du: &mut [Row]) -> NodeSums {
        let Advance { phase, contributions, held, rates, damping, .. } = self;
        let (dt, omega) = (damping.dt, damping.mass_proportional);
        let counted = phase.counted_nodes.end;
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
            // Tied nodes follow their master; nodes that no part pushes stay.
            if phase.start[node] == phase.start[node + 1] {
                continue;
            }
            let force = force(phase, contributions, node);
            let net = net(held, node, force);
            let mut next = Row::ZERO;
            let own = if node < counted { phase.mass[node] } else { 0.0 };
            if simple && dashpot.is_none() {
                let inverse = &phase.inverse_mass[node];
                let mut rayleigh = 0.0;
                for i in 0..4 {
                    let a = -net.0[i] * inverse.0[i];
                    next.0[i] = keep * du.0[i] + push * a;
                    rayleigh += (fade * du.0[i] + 0.5 * dt * dt * a) * (du.0[i] + next.0[i]);
                }
                sums.rayleigh += 0.5 * omega / dt * own * rayleigh;
            } else {
                let step = node_step(damping, phase, rates, dashpot, node, net, *du);
                for i in 0..4 {
                    next.0[i] = du.0[i] + dt * dt * step.acceleration.0[i];
                }
                if node < counted {
                    sums.book(&step, Row([0, 1, 2, 3].map(|i| du.0[i] + next.0[i])));
                }
            }
            if node < counted {
                let twice = Row([0, 1, 2, 3].map(|i| du.0[i] + next.0[i]));
                accounts.book(node, force, twice);
            }
            sums.kinetic += 0.5 * own * dot(*du, *du);
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
    rates: &Rates,
    state: &State,
) -> (NodeSums, Vec<Row>, Vec<Row>) {
    let damping = damping(model, state);
    let counted = phase.counted_nodes.end;
    let accounts = state.ledger.bodies.len();
    let mut velocity = vec![Row::ZERO; state.u.len()];
    let mut acceleration = vec![Row::ZERO; state.u.len()];
    let sums: Vec<NodeSums> = velocity
        .par_chunks_mut(CHUNK)
        .zip(acceleration.par_chunks_mut(CHUNK))
        .enumerate()
        .map(|(chunk, (velocity, acceleration))| {
            let first = chunk * CHUNK;
            let mut dashpots = Dashpots::from(phase, first);
            let mut sums = NodeSums::default();
            let mut own = Accounts::new(phase, contributions, accounts);
            for (k, (velocity, acceleration)) in velocity.iter_mut().zip(acceleration).enumerate() {
                let node = first + k;
                let dashpot = dashpots.take(node);
                // As when advancing: nodes that no part pushes stay.
                if phase.start[node] == phase.start[node + 1] {
                    continue;
                }
                let du = state.du[node];
                let force = force(phase, contributions, node);
                let net = net(&state.held, node, force);
                let step = node_step(&damping, phase, rates, dashpot, node, net, du);
                if node < counted {
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
        })
        .collect();
    for &(node, master) in &phase.tied {
        velocity[node as usize] = velocity[master as usize];
        acceleration[node as usize] = acceleration[master as usize];
    }
    (sums.into_iter().fold(NodeSums::new(accounts), NodeSums::plus), velocity, acceleration)
}
