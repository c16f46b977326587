//! The passes over nodes: contributions to forces, forces to motion.

use super::accounts::Accounts;
use super::gather::{dot, expect, force, net};
use super::node_step::{Damping, Dashpots, Lead, NodeStep, Products, damping, node_step};
use super::split::split;
use crate::free_field::{Leader, Spot};
use crate::model::Model;
use crate::phase::Phase;
use crate::phase::beats::{Beat, Border, Drifting, span};
use crate::phase::passes::{Pass, Turn};
use crate::soon::soon;
use crate::state::{OF_NODES, State};
use rayon::prelude::*;
use std::cmp::Ordering;
use std::ops::Range;
use tremolite_laws::{Isa, Row};

/// Work against the dampings of a block's nodes over the half-steps that meet at u^n \[J\], and of the dashpots of free-field sides
/// on them, and what is taken where levels of steps meet; only the first half when measuring.
#[derive(Default)]
pub(super) struct Damped {
    rayleigh: f64,
    base: f64,
    sides: f64,
    free_field: f64,
    pub levels: f64,
}

impl Damped {
    /// Books the work of a node's dampings over an increment.
    #[inline(always)]
    pub fn book(&mut self, step: &NodeStep, du: Row) {
        self.rayleigh += 0.5 * dot(step.rayleigh, du);
        self.base += 0.5 * dot(step.base, du);
        self.sides += 0.5 * dot(step.sides, du);
        self.free_field += 0.5 * dot(step.free_field, du);
    }

    pub fn onto(self, books: &mut [f64]) {
        let all = [self.rayleigh, self.base, self.sides, self.free_field, self.levels];
        for (book, more) in books.iter_mut().zip(all) {
            *book += more;
        }
    }
}

/// Leaders that one thread advances: so few that another barrier would cost more.
const FEW: usize = 2048;

/// Blocks of nodes that one thread works on, with two columns of their rows.
pub(super) struct Share<'c> {
    turns: &'c [Turn],
    rows: [&'c mut [Row]; 2],
    /// Those of them that others follow, and where to leave their velocities.
    leaders: &'c [Leader],
    own: &'c mut [Lead],
    /// Velocities of those that were advanced before.
    before: &'c [Lead],
    /// What they book, so many numbers each.
    books: &'c mut [f64],
    width: usize,
}

/// One of them.
pub(super) struct Chunk<'c> {
    pub turn: &'c Turn,
    pub rows: [&'c mut [Row]; 2],
    pub leaders: &'c [Leader],
    pub own: &'c mut [Lead],
    pub before: &'c [Lead],
    pub books: &'c mut [f64],
}

impl<'c> Share<'c> {
    /// The next of its blocks.
    #[inline(always)]
    pub fn next(&mut self) -> Option<Chunk<'c>> {
        let (turn, turns) = self.turns.split_first()?;
        self.turns = turns;
        let rows = self.rows.each_mut().map(|rows| take(rows, turn.nodes.len()));
        let (leaders, rest) = self.leaders.split_at(turn.leaders.len());
        self.leaders = rest;
        let own = take(&mut self.own, leaders.len());
        Some(Chunk {
            turn,
            rows,
            leaders,
            own,
            before: self.before,
            books: take(&mut self.books, self.width),
        })
    }
}

/// Takes the first of some.
#[inline(always)]
fn take<'t, T>(all: &mut &'t mut [T], count: usize) -> &'t mut [T] {
    let (first, rest) = std::mem::take(all).split_at_mut(count);
    *all = rest;
    first
}

/// Works on two columns of rows pass by pass, share by share; what `one` finds comes in that order.
pub(super) fn by_passes<T: Send>(
    (phase, passes): (&Phase, &[Pass]),
    leads: &mut [Lead],
    [a, b]: [&mut [Row]; 2],
    (books, width): (&mut [f64], usize),
    one: impl Fn(Share) -> T + Sync,
) -> Vec<T> {
    let mut found = Vec::new();
    for pass @ Pass { turns, shares } in passes {
        let first = turns.first().map_or(0, |turn| turn.leaders.start);
        let (before, own) = leads.split_at_mut(first);
        let before = &*before;
        let ends = |share: &Range<usize>| (&turns[share.start], &turns[share.end - 1]);
        let nodes = |share: &Range<usize>| {
            let (first, last) = ends(share);
            first.nodes.start..last.nodes.end
        };
        let leaders = |share: &Range<usize>| {
            let (first, last) = ends(share);
            first.leaders.start..last.leaders.end
        };
        let rows = split(a, shares, nodes).into_iter().zip(split(b, shares, nodes));
        let own = split(own, shares, |share| {
            let leaders = leaders(share);
            leaders.start - first..leaders.end - first
        });
        let books = split(books, shares, |share| {
            let (first, last) = ends(share);
            width * first.block..width * (last.block + 1)
        });
        let all =
            shares.iter().zip(rows).zip(own.into_iter().zip(books)).map(|((share, (a, b)), (own, books))| {
                Share {
                    turns: &turns[share.clone()],
                    rows: [a, b],
                    leaders: &phase.leaders[leaders(share)],
                    own,
                    before,
                    books,
                    width,
                }
            });
        let leads_on = turns.iter().any(|turn| !turn.leaders.is_empty());
        if leads_on && pass.nodes() <= FEW {
            found.extend(all.map(&one));
        } else {
            found.par_extend(all.collect::<Vec<_>>().into_par_iter().with_max_len(1).map(&one));
        }
    }
    found
}

/// Velocities of a given free field that one thread finds at once.
const AT_ONCE: usize = 256;

/// Velocities at a time, in steps of the followers' own over the finest `dt`, that a given free field leaves to those who follow it.
pub(super) fn given(
    model: &Model,
    phase: &Phase,
    beat: &Beat,
    time: Option<f64>,
    dt: f64,
    leads: &mut [Lead],
) {
    let Some(field) = &model.boundaries.free_field else { return };
    let one_level = phase.beats.len() == 1;
    let level = |place: &u32| match one_level {
        true => 0,
        false => model.nodes.level[phase.leaders[*place as usize].node() as usize],
    };
    // Leads from the first of some places to the last.
    let velocities = |(places, leads): (&&[u32], &mut [Lead])| {
        let mut found = [[0.0; 3]; AT_ONCE];
        let found = &mut found[..places.len()];
        let mut first = 0;
        // Those of a level have one step.
        for alike in places.chunk_by(|a, b| level(a) == level(b)) {
            let Some(time) = time else { break };
            let dt = dt * span(level(&alike[0])) as f64;
            let found = &mut found[first..first + alike.len()];
            let from = alike[0] as usize;
            match phase.given.get(from..from + alike.len()) {
                // Each follows the one before: nothing is gathered.
                Some(spots) if alike[alike.len() - 1] as usize + 1 == from + alike.len() => {
                    field.velocities(spots, time, dt, found);
                }
                _ => {
                    let spots: Vec<Spot> = alike.iter().map(|&place| phase.given[place as usize]).collect();
                    field.velocities(&spots, time, dt, found);
                }
            }
            first += alike.len();
        }
        for (place, velocity) in places.iter().zip(found) {
            let velocity = Row::new(*velocity);
            leads[(place - places[0]) as usize] = Lead { mean: velocity, hat: velocity };
        }
    };
    let chunks: Vec<&[u32]> = beat.given.chunks(AT_ONCE).collect();
    let leads = split(leads, &chunks, |places| {
        let [first, last] = [0, places.len() - 1].map(|k| places[k] as usize);
        first..last + 1
    });
    chunks.par_iter().zip(leads).for_each(velocities);
}

/// u^n to u^{n+1}, with room for what leaders leave; `time` is that of a given free field, which else is at rest. Blocks book onto the
/// state's ledger.
pub fn advance(
    model: &Model,
    phase: &Phase,
    time: Option<f64>,
    contributions: &[Row],
    products: &Products,
    leads: &mut [Lead],
    state: &mut State,
) {
    let damping = damping(model, state);
    let width = state.ledger.width();
    let dt = state.dt;
    let beat = phase.beat(state);
    let State { u, du, held, ledger, .. } = state;
    let wide = Isa::Avx2.available();
    let pass = Advance { phase, contributions, held, products, damping, wide };
    given(model, phase, beat, time, dt, leads);
    let books = (&mut ledger.blocks[..], width);
    by_passes((phase, &beat.passes), leads, [u, du], books, |share| pass.share(share));
    let mut borders = Borders::from(phase, 0);
    for &(node, master) in &beat.tied {
        let next = du[master as usize];
        let steps = match borders.take(node as usize) {
            Some(_) => 1.0,
            None => phase.span_of_node(model, node) as f64,
        };
        for i in 0..4 {
            u[node as usize].0[i] += steps * next.0[i];
        }
        du[node as usize] = next;
    }
    drift(phase, beat, contributions, u, du, (&mut ledger.blocks, width));
}

/// Nodes that a thread lets drift together.
const DRIFTING: usize = 512;

/// So many drifting nodes before their turn, what they need is asked for.
const DRIFT_AHEAD: usize = 8;

/// Lets nodes between their own times go on, and books what finer parts take of it. `books` are those of all blocks, so many numbers
/// each.
fn drift(
    phase: &Phase,
    beat: &Beat,
    contributions: &[Row],
    u: &mut [Row],
    du: &[Row],
    (books, width): (&mut [f64], usize),
) {
    if beat.drifting.is_empty() {
        return;
    }
    let rows = split(u, &beat.drifting, |one| one.nodes.clone());
    let books = split(books, &beat.drifting, |one| width * one.block..width * (one.block + 1));
    let mut jobs: Vec<_> = beat.drifting.iter().zip(rows).zip(books).collect();
    let one = |((drifting, u), books): &mut ((&Drifting, &mut [Row]), &mut [f64])| {
        let (of_nodes, of_accounts) = books.split_at_mut(OF_NODES);
        let borders = &phase.borders[drifting.borders.clone()];
        for (k, border) in borders.iter().enumerate() {
            if let Some(later) = borders.get(k + DRIFT_AHEAD) {
                soon(du, later.node as usize);
                soon(u, later.node as usize - drifting.nodes.start);
                phase.pushes(later).iter().for_each(|push| soon(contributions, push.slot as usize));
            }
            let du = &du[border.node as usize];
            let u = &mut u[border.node as usize - drifting.nodes.start];
            (0..4).for_each(|i| u.0[i] += du.0[i]);
            if !border.counts {
                continue;
            }
            for push in phase.pushes(border).iter().filter(|push| push.level <= beat.coarsest) {
                let work = span(push.level) as f64 * dot(contributions[push.slot as usize], *du);
                of_nodes[LEVELS] -= work;
                if let Some(account) = of_accounts.get_mut(push.account as usize) {
                    *account += work;
                }
            }
        }
    };
    let nodes: usize = beat.drifting.iter().map(|one| one.borders.len()).sum();
    match nodes <= DRIFTING {
        true => jobs.iter_mut().for_each(one),
        false => jobs.par_chunks_mut(8).for_each(|jobs| jobs.iter_mut().for_each(one)),
    }
}

/// The place of what is taken where levels meet among what a block books.
const LEVELS: usize = 4;

/// Nodes that drift, from one on, in ascending order.
pub(super) struct Borders<'a> {
    rest: &'a [Border],
}

impl<'a> Borders<'a> {
    pub fn from(phase: &'a Phase, node: usize) -> Self {
        let first = phase.borders.partition_point(|border| (border.node as usize) < node);
        Borders { rest: &phase.borders[first..] }
    }

    /// A node, if it drifts; nodes must be asked for in ascending order.
    #[inline(always)]
    pub fn take(&mut self, node: usize) -> Option<&'a Border> {
        while let [first, rest @ ..] = self.rest {
            match (first.node as usize).cmp(&node) {
                Ordering::Less => self.rest = rest,
                Ordering::Equal => return Some(first),
                Ordering::Greater => return None,
            }
        }
        None
    }
}

impl Border {
    /// What finer parts take of a node's own step of `span` steps beyond what the node gives there, where all have their own times:
    /// half of it over `twice`, its increments a step of the finest level before and after. Booked on accounts, and left.
    pub(super) fn meet(
        &self,
        phase: &Phase,
        contributions: &[Row],
        span_of_node: f64,
        twice: Row,
        accounts: &mut [f64],
    ) -> f64 {
        let mut taken = 0.0;
        for push in phase.pushes(self) {
            let longer = span_of_node - span(push.level) as f64;
            let work = -0.5 * longer * dot(contributions[push.slot as usize], twice);
            taken -= work;
            if let Some(account) = accounts.get_mut(push.account as usize) {
                *account += work;
            }
        }
        taken
    }
}

/// What a chunk's advance needs besides its rows.
struct Advance<'a> {
    phase: &'a Phase,
    contributions: &'a [Row],
    held: &'a [Row],
    products: &'a Products,
    damping: Damping,
    /// Whether the processor has AVX2. No operation is fused, so the bits are the same without it.
    wide: bool,
}

impl Advance<'_> {
    fn share(&self, share: Share) {
        #[cfg(target_arch = "x86_64")]
        if self.wide {
            #[target_feature(enable = "avx2")]
            unsafe fn wide(pass: &Advance, share: Share) {
                pass.nodes(share)
            }
            // SAFETY: `wide` says that the processor has AVX2.
            return unsafe { wide(self, share) };
        }
        let _ = self.wide;
        self.nodes(share)
    }

    #[inline(always)]
    fn nodes(&self, mut share: Share) {
        while let Some(chunk) = share.next() {
            match (chunk.own.is_empty(), chunk.turn.level == 0) {
                (true, true) => self.nodes_of::<false, false>(chunk),
                (true, false) => self.nodes_of::<false, true>(chunk),
                (false, true) => self.nodes_of::<true, false>(chunk),
                (false, false) => self.nodes_of::<true, true>(chunk),
            }
        }
    }

    /// With `LEADS` the nodes leave their velocities to those who follow; with `COARSE` their steps are longer than the finest.
    #[inline(always)]
    fn nodes_of<const LEADS: bool, const COARSE: bool>(&self, chunk: Chunk) {
        let Chunk { turn, rows: [u, du], leaders, own, before, books } = chunk;
        let (first, counts) = (turn.nodes.start, turn.counts);
        let (books, of_accounts) = books.split_at_mut(OF_NODES);
        let mut leaders = leaders.iter().zip(own).peekable();
        let Advance { phase, contributions, held, products, .. } = self;
        let steps = if COARSE { span(turn.level) as f64 } else { 1.0 };
        // A power of two, so its inverse is exact.
        let inverse_steps = 1.0 / steps;
        let damping = &Damping { dt: steps * self.damping.dt, ..self.damping };
        let (dt, omega) = (damping.dt, damping.mass_proportional);
        let mut borders = Borders::from(phase, if COARSE { first } else { usize::MAX });
        let mut dashpots = Dashpots::from(phase, first);
        let mut sums = Damped::default();
        let mut accounts = Accounts::new(phase, contributions, of_accounts);
        // Without dashpots and ξ the step is Δu ← keep Δu + push a, and v̂ = (fade Δu/Δt) + ½Δt a.
        let fade = 1.0 - 0.5 * omega * dt;
        let (keep, push) = (1.0 - omega * dt * fade, dt * dt * fade);
        let simple = damping.stiffness_proportional == 0.0;
        for (k, (u, du)) in u.iter_mut().zip(du).enumerate() {
            let node = first + k;
            expect(phase, contributions, node);
            let dashpot = dashpots.take(node);
            let mut lead = match LEADS {
                true => {
                    leaders.next_if(|(leader, _)| **leader == Leader::Node(node as u32)).map(|(_, lead)| lead)
                }
                false => None,
            };
            // Tied nodes follow their master; nodes that no part pushes stay.
            if phase.start[node] == phase.start[node + 1] {
                continue;
            }
            let force = force(phase, contributions, node);
            let net = net(held, node, force);
            let old = if COARSE { Row(du.0.map(|d| steps * d)) } else { *du };
            let mut next = Row::ZERO;
            let mass = if counts { phase.mass[node] } else { 0.0 };
            if simple && dashpot.is_none() {
                let inverse = &phase.inverse_mass[node];
                let mut rayleigh = 0.0;
                for i in 0..4 {
                    let a = -net.0[i] * inverse.0[i];
                    next.0[i] = keep * old.0[i] + push * a;
                    rayleigh += (fade * old.0[i] + 0.5 * dt * dt * a) * (old.0[i] + next.0[i]);
                    if LEADS && let Some(lead) = &mut lead {
                        lead.mean.0[i] = 0.5 * (old.0[i] + next.0[i]) / dt;
                        lead.hat.0[i] = (fade * old.0[i] + 0.5 * dt * dt * a) / dt;
                    }
                }
                sums.rayleigh += 0.5 * omega / dt * mass * rayleigh;
            } else {
                let step = node_step(damping, phase, products, before, dashpot, node, net, old);
                for i in 0..4 {
                    next.0[i] = old.0[i] + dt * dt * step.acceleration.0[i];
                }
                if let Some(lead) = lead {
                    *lead = Lead { mean: step.mean, hat: step.velocity };
                }
                if counts {
                    sums.book(&step, Row([0, 1, 2, 3].map(|i| old.0[i] + next.0[i])));
                }
            }
            let border = if COARSE { borders.take(node) } else { None };
            if counts {
                let twice = Row([0, 1, 2, 3].map(|i| old.0[i] + next.0[i]));
                accounts.book(node, force, twice);
                if let Some(border) = border {
                    let twice = Row(twice.0.map(|d| d * inverse_steps));
                    sums.levels += border.meet(phase, contributions, steps, twice, accounts.sums());
                }
            }
            // Others are not asked for before the end of their step.
            let drifts = border.is_some();
            let one = if COARSE { Row(next.0.map(|d| d * inverse_steps)) } else { next };
            let moved = if COARSE && drifts { one } else { next };
            for i in 0..4 {
                u.0[i] += moved.0[i];
            }
            *du = one;
        }
        accounts.close();
        sums.onto(books);
    }
}
