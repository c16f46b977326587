//! The stable step: Δt ≤ min(2/√λmax(M⁻¹K), 2/λmax(M⁻¹C)), C Rayleigh's alone.
//!
//! Dashpots act on the mean of v⁻ and v⁺ and take energy in every step whatever its length, so they bound nothing.

use super::nodes::force;
use crate::model::Model;
use crate::parts::{ElementEnergy, Motion, Own, ProbeOut, Scratch, Tick};
use crate::phase::Phase;
use crate::state::State;
use rayon::prelude::*;
use tremolite_laws::{Octet, Row};

/// What bounds the step.
#[derive(Clone, Debug, PartialEq)]
pub enum Limit {
    /// The stiffness around an element (index in the mesh).
    Element(u32),
    /// The springs at a node of the boundary (index in the mesh).
    Boundary(u32),
    /// Rayleigh's damping.
    Damping,
}

/// The largest stable step and what it comes from.
#[derive(Clone, Debug, PartialEq)]
pub struct StableStep {
    /// Stable step by the estimate \[s\], before any safety factor.
    pub dt: f64,
    /// √λmax(M⁻¹K) \[rad/s\].
    pub frequency: f64,
    /// λmax(M⁻¹C) = ω + ξ λmax(M⁻¹K) of Rayleigh's damping \[1/s\].
    pub damping_rate: f64,
    pub limit: Limit,
    /// Iterations made, and the relative change of λ in the last one: the estimate comes from below.
    pub iterations: u32,
    pub change: f64,
}

/// K w of all parts by engine node, added up in the order of parts; a tied node's share is its master's. Without a
/// state the stiffness is elastic, with one it is what damage has left.
pub fn stiffness_times(
    phase: &Phase,
    state: Option<&State>,
    w: &[Row],
    contributions: &mut [Row],
    out: &mut [Row],
) {
    let mut rest = &mut *contributions;
    let mut jobs: Vec<(usize, &mut [Row])> = Vec::with_capacity(phase.parts.len());
    for (p, part) in phase.parts.iter().enumerate() {
        let (own, after) = std::mem::take(&mut rest).split_at_mut(part.nodes().len());
        jobs.push((p, own));
        rest = after;
    }
    jobs.into_par_iter().for_each_init(Scratch::default, |scratch, (p, own)| match state {
        Some(state) => {
            let history = &state.history[phase.slices[p].history.clone()];
            phase.parts[p].damping_times(&state.u, history, w, own, scratch);
        }
        None => phase.parts[p].stiffness_times(w, own, scratch),
    });
    let contributions = &*contributions;
    out.par_iter_mut().enumerate().for_each(|(node, out)| *out = force(phase, contributions, node));
}

/// A fixed start without symmetry, so that no mode is missed.
fn start(phase: &Phase) -> Vec<Row> {
    let mut seed = 0x9e37_79b9_7f4a_7c15_u64;
    let mut random = || {
        seed ^= seed << 13;
        seed ^= seed >> 7;
        seed ^= seed << 17;
        (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    let mut w: Vec<Row> = phase
        .inverse_mass
        .iter()
        .map(|inverse| {
            let r = Row::new([random(), random(), random()]);
            Row([0, 1, 2, 3].map(|i| if inverse.0[i] > 0.0 { r.0[i] } else { 0.0 }))
        })
        .collect();
    follow(phase, &mut w);
    w
}

fn follow(phase: &Phase, w: &mut [Row]) {
    for &(node, master) in &phase.tied {
        w[node as usize] = w[master as usize];
    }
}

const ITERATIONS: u32 = 300;
const CONVERGED: f64 = 1e-5;

/// The stable step by power iteration with the elastic stiffness (springs of the boundary included).
///
/// The Rayleigh quotient approaches λmax from below; the iteration stops when it rises by less than 10⁻⁵ a time,
/// or after 300 times. Callers keep a margin ([`crate::problem::TimeStep::safety`], 0.9 by default).
pub fn stable_step(model: &Model, phase: &Phase) -> StableStep {
    let (.., contributions, _, _) = phase.totals();
    let mut contributions = vec![Row::ZERO; contributions];
    let mut w = start(phase);
    let mut kw = vec![Row::ZERO; w.len()];
    let (mut lambda, mut change, mut iterations) = (0.0, f64::INFINITY, 0);
    while iterations < ITERATIONS && change > CONVERGED {
        stiffness_times(phase, None, &w, &mut contributions, &mut kw);
        let (mut wkw, mut wmw) = (0.0, 0.0);
        for (n, (w, kw)) in w.iter().zip(&kw).enumerate() {
            // A tied node's mass and force are its master's.
            if phase.start[n] != phase.start[n + 1] {
                wkw += w.0[0] * kw.0[0] + w.0[1] * kw.0[1] + w.0[2] * kw.0[2];
                wmw += phase.mass[n] * (w.0[0] * w.0[0] + w.0[1] * w.0[1] + w.0[2] * w.0[2]);
            }
        }
        let quotient = wkw / wmw;
        change = ((quotient - lambda) / quotient).abs();
        lambda = quotient;
        iterations += 1;
        let scale = 1.0 / (wmw.sqrt() * quotient);
        for (n, w) in w.iter_mut().enumerate() {
            for i in 0..3 {
                w.0[i] = kw[n].0[i] * phase.inverse_mass[n].0[i] * scale;
            }
        }
        follow(phase, &mut w);
    }
    let frequency = lambda.sqrt();
    let xi = model.rayleigh.stiffness;
    let damping_rate = model.rayleigh.mass + xi * lambda;
    let dt_stiffness = 2.0 / frequency;
    let dt_damping = if damping_rate > 0.0 { 2.0 / damping_rate } else { f64::INFINITY };
    let limit = if dt_stiffness <= dt_damping { hottest(model, phase, &w) } else { Limit::Damping };
    StableStep { dt: dt_stiffness.min(dt_damping), frequency, damping_rate, limit, iterations, change }
}

/// Where the mode `w` stores most energy: an element of the user's mesh, or a node on springs.
fn hottest(model: &Model, phase: &Phase, w: &[Row]) -> Limit {
    let tick = Tick { time: 0.0, dt: 0.0 };
    let motion = Motion { u: w, du: w };
    let mut scratch = Scratch::default();
    let mut best = (0.0, Limit::Element(0));
    for (p, part) in phase.parts.iter().enumerate() {
        let (elements, points) = part.elements();
        let sizes = part.state_sizes();
        let mut out = vec![Row::ZERO; part.nodes().len()];
        if elements == 0 {
            part.stiffness_times(w, &mut out, &mut scratch);
            for (&node, f) in part.nodes().iter().zip(&out) {
                let x = w[node as usize];
                let energy = 0.5 * (f.0[0] * x.0[0] + f.0[1] * x.0[1] + f.0[2] * x.0[2]);
                if energy > best.0 {
                    best = (energy, Limit::Boundary(model.mesh_node[node as usize]));
                }
            }
            continue;
        }
        let mut history = vec![Octet::ZERO; sizes.history];
        let mut overstress = vec![Octet::ZERO; sizes.overstress];
        let mut numbers = vec![0.0; sizes.numbers];
        let mut stress = vec![[0.0; 6]; elements * points];
        let mut energy = vec![ElementEnergy::default(); elements];
        let own = Own { history: &mut history, overstress: &mut overstress, numbers: &mut numbers };
        let probe = ProbeOut { stress: &mut stress, energy: &mut energy };
        part.probe(&tick, &motion, own, &mut out, probe, &mut scratch);
        for (&element, energy) in model.patches[p].elements.iter().zip(&energy) {
            if energy.held() > best.0 {
                best = (energy.held(), Limit::Element(element));
            }
        }
    }
    best.1
}
