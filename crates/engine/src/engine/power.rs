//! The stable step: Δt ≤ min(2/√λmax(M⁻¹K), 2/λmax(M⁻¹C)), C Rayleigh's alone.
//!
//! Artificial viscosity C′ acts at v⁻, so that Δt²K + 2Δt C′ ≤ 4M is needed, Δt ≤ 2/√λmax(M⁻¹(K + 2C′/Δt)). Since
//! 2b/ω_e K_e weighs at most as b of the element's critical damping, Δt₀(√(1 + b²) − b) with the largest b and the step Δt₀
//! without viscosity satisfies that; put in on the right it gives a step that is longer and satisfies it too. A program's own part may have any
//! C′. With Δt₀ on the right Δt₀λ/2 is at least c = λmax(M⁻¹C′), and (√(c² + 4k) − c)/k with k = λmax(M⁻¹K) satisfies it as well.
//!
//! Dashpots act on the mean of v⁻ and v⁺ and take energy in every step whatever its length, so they bound nothing.

use super::highest::{Highest, follow, highest};
use super::product::Product;
use crate::assembly::Assembly;
use crate::member::{Kind, Member};
use crate::model::Model;
use crate::parts::{ElementEnergy, Scratch};
use crate::phase::Phase;
use tremolite_laws::Row;

/// What bounds the step.
#[derive(Clone, Debug, PartialEq)]
pub enum Limit {
    /// The stiffness around an element (index in the mesh).
    Element(u32),
    /// A part without elements, at a node (index in the mesh).
    Part { member: u32, node: u32 },
    /// Rayleigh's damping.
    Damping,
}

/// What interfaces allow: impacts may gain energy beyond, though the step is stable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactLimit {
    /// The longest step \[s\], without a safety factor.
    pub dt: f64,
    /// The interface ([`Model::seams`]) and its pair that set it.
    pub interface: usize,
    pub pair: usize,
}

impl StableStep {
    /// The step to run with \[s\]: a share of the stable one, and what interfaces allow.
    pub fn to_run(&self, safety: f64) -> f64 {
        let stable = safety * self.dt;
        self.contact.map_or(stable, |contact| stable.min(contact.dt))
    }
}

impl StableStep {
    /// The same for a model cut and numbered otherwise, in whose assembly the member that sets it has another number.
    #[must_use]
    pub fn renumbered(mut self, before: &Assembly, model: &Model, assembly: &Assembly) -> Self {
        if let Limit::Part { member, node } = &mut self.limit {
            let (engine, name) = (model.engine_node[*node as usize], &before.members[*member as usize].name);
            let same = |m: &Member| m.name == *name && m.part.nodes().contains(&engine);
            let found = assembly.members.iter().position(same);
            *member = found.map_or(0, |m| m as u32);
        }
        self
    }
}

/// The largest stable step and what it comes from.
#[derive(Clone, Debug, PartialEq)]
pub struct StableStep {
    /// Stable step by the estimate \[s\], before any safety factor.
    pub dt: f64,
    /// What it would be by the stiffness alone, without artificial viscosity or ξ \[s\].
    pub undamped: f64,
    /// √λmax(M⁻¹K) \[rad/s\].
    pub frequency: f64,
    /// λmax(M⁻¹C) = ω + ξ λmax(M⁻¹K) of Rayleigh's damping \[1/s\].
    pub damping_rate: f64,
    pub limit: Limit,
    /// Of the model's interfaces, where it has any.
    pub contact: Option<ContactLimit>,
    /// Iterations made, and the relative change of λ in the last one: the estimate comes from below.
    pub iterations: u32,
    pub change: f64,
}

/// A fixed start without symmetry, so that no mode is missed: by node of the mesh, whatever its number in the engine and whoever
/// has it.
fn start(model: &Model, phase: &Phase) -> Vec<Row> {
    let all = model.mesh_node.iter().zip(&phase.inverse_mass);
    let mut w: Vec<Row> = all.map(|(&node, inverse)| noise(node, inverse)).collect();
    follow(phase, &mut w);
    w
}

/// Numbers from −½ to ½ that a node of the mesh always has, where it moves.
pub(super) fn noise(node: u32, inverse_mass: &Row) -> Row {
    let random = |i: u64| (hash(4 * u64::from(node) + i) >> 11) as f64 / (1u64 << 53) as f64 - 0.5;
    Row([0, 1, 2, 3].map(|i| if inverse_mass.0[i as usize] > 0.0 { random(i) } else { 0.0 }))
}

/// The finaliser of SplitMix64 (`steele2014`).
fn hash(x: u64) -> u64 {
    let x = x.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}

/// The stable step by the largest λ of M⁻¹K, with the elastic stiffness (springs of the boundary included).
///
/// The estimate approaches λmax from below, by less than 10⁻⁵ in its last iteration (`knyazev2001`). Callers keep a margin
/// ([`crate::problem::TimeStep::safety`], 0.9 by default).
pub fn stable_step(model: &Model, assembly: &Assembly, phase: &Phase) -> StableStep {
    let mut w = start(model, phase);
    let Highest { lambda, change, iterations } = highest(model, assembly, phase, Product::Stiffness, &mut w);
    let undamped = 2.0 / lambda.sqrt();
    let share = model.elements.viscosity[..model.user.elements].iter().copied().fold(0.0, f64::max);
    let mut dt_stiffness = undamped;
    let dashpots = model.seams.iter().any(|seam| seam.damping > 0.0);
    let own = own_viscosity(assembly, phase);
    if share > 0.0 || dashpots || own {
        let mut mode = w.clone();
        dt_stiffness = undamped * viscous_share(share);
        let mut rounds = VISCOUS_ROUNDS;
        if own {
            let with = highest(model, assembly, phase, Product::Viscous(2.0 / undamped), &mut mode);
            let c = 0.5 * undamped * with.lambda;
            dt_stiffness = ((c * c + 4.0 * lambda).sqrt() - c) / lambda;
            rounds = OWN_ROUNDS;
        }
        for _ in 0..rounds {
            let with = highest(model, assembly, phase, Product::Viscous(2.0 / dt_stiffness), &mut mode);
            dt_stiffness = 2.0 / with.lambda.sqrt();
        }
        w = mode;
    }
    let xi = model.scheme.rayleigh.stiffness;
    let damping_rate = model.scheme.rayleigh.mass + xi * lambda;
    let dt_damping = if damping_rate > 0.0 { 2.0 / damping_rate } else { f64::INFINITY };
    let limit = if dt_stiffness <= dt_damping {
        hottest(model, assembly, phase, &w, dt_stiffness)
    } else {
        Limit::Damping
    };
    StableStep {
        dt: dt_stiffness.min(dt_damping),
        undamped,
        frequency: lambda.sqrt(),
        damping_rate,
        limit,
        contact: contact_limit(model, assembly),
        iterations,
        change,
    }
}

/// Rounds that bring the step with viscosity up to its limit; the second gains less than a thousandth.
const VISCOUS_ROUNDS: usize = 2;
/// The same where a program's own part is viscous: the bound that they begin with may be a third of the limit.
const OWN_ROUNDS: usize = 8;

/// Whether a program's own part has forces that go by v⁻.
fn own_viscosity(assembly: &Assembly, phase: &Phase) -> bool {
    let own = phase.active.iter().map(|&m| &assembly.members[m as usize]);
    own.filter(|member| member.kind == Kind::Own).any(|Member { part, .. }| {
        let nodes = part.nodes();
        let still = vec![Row::ZERO; nodes.iter().max().map_or(0, |&most| most as usize + 1)];
        part.viscosity_times(&still, &mut vec![Row::ZERO; nodes.len()], &mut Scratch::default())
    })
}

/// √(1 + b²) − b: what artificial viscosity b leaves of the step where it acts on every element.
pub fn viscous_share(viscosity: f64) -> f64 {
    (1.0 + viscosity * viscosity).sqrt() - viscosity
}

/// Where the mode `w` stores most energy, or loses most to a program's own part in a step of `dt` \[s\]: an element of the mesh, or a node of
/// a part without elements.
fn hottest(model: &Model, assembly: &Assembly, phase: &Phase, w: &[Row], dt: f64) -> Limit {
    let mut scratch = Scratch::default();
    let mut best = (0.0, Limit::Element(0));
    for &m in &phase.active {
        let Member { part, kind, .. } = &assembly.members[m as usize];
        if let Some(patch) = kind.patch().map(|patch| &model.patches[patch]) {
            let mut energy = vec![ElementEnergy::default(); patch.elements.len()];
            part.stiffness_energy(w, &mut energy, &mut scratch);
            for (&element, energy) in patch.elements.iter().zip(&energy) {
                if energy.held() > best.0 {
                    best = (energy.held(), Limit::Element(element));
                }
            }
            continue;
        }
        let mut out = vec![Row::ZERO; part.nodes().len()];
        part.stiffness_times(w, &mut out, &mut scratch);
        let mut viscous = vec![Row::ZERO; out.len()];
        // Contact dashpots weigh less than the pairs that they are at.
        if *kind == Kind::Own && part.viscosity_times(w, &mut viscous, &mut scratch) {
            for (own, more) in out.iter_mut().zip(&viscous) {
                (0..3).for_each(|i| own.0[i] += 2.0 / dt * more.0[i]);
            }
        }
        for (&node, f) in part.nodes().iter().zip(&out) {
            let x = w[node as usize];
            let energy = 0.5 * (f.0[0] * x.0[0] + f.0[1] * x.0[1] + f.0[2] * x.0[2]);
            if energy > best.0 {
                best = (energy, Limit::Part { member: m, node: model.mesh_node[node as usize] });
            }
        }
    }
    best.1
}

/// The longest step with which no pair exceeds the limit of its interface.
fn contact_limit(model: &Model, assembly: &Assembly) -> Option<ContactLimit> {
    let bounds =
        model.seams.iter().zip(&assembly.contacts).enumerate().map(|(interface, (seam, contacts))| {
            ContactLimit { dt: seam.limit / contacts.frequency, interface, pair: contacts.stiffest_pair }
        });
    // What runs through a slab is as stiff as in the model but for round-off: the model's own is named.
    let users = model.user_seams().len();
    let (own, outside): (Vec<_>, Vec<_>) = bounds.partition(|bound| bound.interface < users);
    let least = |of: Vec<ContactLimit>| of.into_iter().min_by(|a, b| a.dt.total_cmp(&b.dt));
    let own = least(own)?;
    Some(least(outside).filter(|bound| bound.dt < (1.0 - 1e-6) * own.dt).unwrap_or(own))
}
