//! The parts of interfaces: how stiff a pair may be for the step, and its parts.
//!
//! **ω_c.** A pair of nodes with masses m₁, m₂ and the stiffness per area k has ω_c² = Σ kA/m₁ + Σ kA/m₂, each sum over all
//! pairs of that node's tied set, with k at its stiffest: at unlike masses a node with two partners is stiffer than any pair
//! alone says. Explicit contact gains or loses energy at each impact; with a dashpot of 1 % of critical it loses on the whole
//! up to ω_cΔt = 0.8, which bounds the step ([`Interface::limit`](crate::interface::Interface)).
//!
//! **Stiffness left out.** It is what keeps that limit at the step that the elements alone allow: the interface then does not
//! set the step.

use crate::assembly::Assembly;
use crate::engine::{ContactLimit, stable_step};
use crate::error::ModelError;
use crate::interface::Seam;
use crate::life::Stage;
use crate::member::Member;
use crate::model::Model;
use crate::phase::Phase;
use crate::problem::TimeStep;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::sync::Arc;
use tremolite_kernels::AnyInterface;
use tremolite_kernels::contact::{Pair, PairSeen};
use tremolite_laws::{Octet, PairState, Values};
use tremolite_mesh::order::hilbert_order;
use tremolite_mesh::pairs::tangents;

/// Pairs that one thread works on together.
const CHUNK: usize = 256;

/// An interface with its law, ready to be looked at.
#[derive(Clone)]
pub struct Contacts {
    pub law: Arc<dyn AnyInterface>,
    /// Whether the law's stiffness was chosen.
    pub chosen: bool,
    /// Member and place in it of each pair of [`Seam::pairs`].
    places: Vec<(u32, u32)>,
    /// Largest ω_c of its pairs \[rad/s\], and that pair.
    pub frequency: f64,
    pub stiffest_pair: usize,
}

impl Contacts {
    /// A pair as it was when it was evaluated last, from the histories of all members.
    pub fn seen(&self, assembly: &Assembly, history: &[Octet], pair: usize) -> PairSeen {
        let (member, at) = self.places[pair];
        let own = &history[assembly.slices[member as usize].history.clone()];
        self.law.seen(own, at as usize)
    }

    /// Area-weighted sums over the pairs.
    pub fn totals(&self, assembly: &Assembly, seam: &Seam, history: &[Octet]) -> ContactTotals {
        let mut totals = ContactTotals::default();
        for (k, pair) in seam.pairs.iter().enumerate() {
            let seen = self.seen(assembly, history, k);
            let add = |to: &mut f64, counts: bool| *to += if counts { pair.area } else { 0.0 };
            add(&mut totals.sliding, seen.state == PairState::Sliding as u8);
            add(&mut totals.open, seen.state == PairState::Open as u8);
            add(&mut totals.ever_slid, seen.has_slid);
            add(&mut totals.ever_opened, seen.has_opened);
            totals.largest_gap = totals.largest_gap.max(seen.largest_gap);
            totals.largest_slip = totals.largest_slip.max(seen.largest_slip);
            totals.largest_pressure = totals.largest_pressure.max(seen.largest_pressure);
            totals.impact_gain += pair.normal_area * seen.impact_gain;
            let straight = self.law.straight_from().unwrap_or(f64::INFINITY);
            totals.beyond += usize::from(seen.largest_pressure > straight);
        }
        totals
    }
}

/// What an interface does as a whole.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContactTotals {
    /// Areas \[m²\] that slide and are open now.
    pub sliding: f64,
    pub open: f64,
    /// Areas \[m²\] that ever slid, that ever opened.
    pub ever_slid: f64,
    pub ever_opened: f64,
    /// Over all pairs and steps: gap, slip \[m\] and pressure \[Pa\].
    pub largest_gap: f64,
    pub largest_slip: f64,
    pub largest_pressure: f64,
    /// Pairs whose pressure went beyond that from which on the law is straight.
    pub beyond: usize,
    /// Energy \[J\] that the trapezoidal rule found or lost at impacts.
    pub impact_gain: f64,
}

/// Builds the parts of all interfaces into an assembly of everything else, behind the member `at`.
///
/// # Errors
/// If a law refuses what was chosen for it, or a pair's nodes move as one.
pub(crate) fn add(model: &Model, assembly: &mut Assembly, at: usize) -> Result<(), ModelError> {
    if model.seams.is_empty() {
        return Ok(());
    }
    let phase = Phase::of(model, assembly, Stage::Shaking)?;
    for seam in &model.seams {
        let engine = |n: u32| phase.master[model.engine_node[n as usize] as usize];
        if let Some(pair) = seam.pairs.iter().find(|pair| engine(pair.nodes[0]) == engine(pair.nodes[1])) {
            let node = model.mesh.node_id(pair.nodes[1] as usize);
            let reason = format!("both sides of node {node} are tied to one another");
            return Err(ModelError::Interface { name: seam.name.clone(), reason });
        }
    }
    let loads = Loads::of(model, &phase);
    let values = chosen(model, assembly, &phase, &loads);
    let mut laws = Vec::new();
    for (seam, values) in model.seams.iter().zip(&values) {
        let law = (seam.law.build)(values).map_err(|bad| {
            let bad: Vec<String> = bad.iter().map(ToString::to_string).collect();
            ModelError::Interface { name: seam.name.clone(), reason: bad.join("; ") }
        })?;
        laws.push(law);
    }
    let stiffest: Vec<f64> = laws.iter().map(|law| law.stiffest()[0]).collect();
    let mut members = Vec::new();
    for (s, (seam, law)) in model.seams.iter().zip(laws).enumerate() {
        let squares = loads.squares(s, |other| stiffest[other]);
        let (stiffest_pair, square) = squares
            .into_iter()
            .enumerate()
            .fold((0, 0.0), |worst, (k, square)| if square > worst.1 { (k, square) } else { worst });
        let frequency = square.sqrt();
        let damping = if frequency > 0.0 { 2.0 * seam.damping * stiffest[s] / frequency } else { 0.0 };
        let mut places = vec![(0, 0); seam.pairs.len()];
        let centres: Vec<[f64; 3]> = (0..seam.pairs.len()).map(|k| seam.place(&model.mesh, k)).collect();
        let order = hilbert_order(&centres);
        for chunk in order.chunks(CHUNK) {
            let member = (at + members.len()) as u32;
            for (place, &pair) in chunk.iter().enumerate() {
                places[pair as usize] = (member, place as u32);
            }
            let (nodes, pairs) = part(model, seam, chunk);
            let part = law.contact(nodes, &pairs, damping, model.isa);
            members.push(Member::new(format!("interface '{}'", seam.name), part));
        }
        let chosen = seam.values != *law.values();
        assembly.contacts.push(Contacts { law, chosen, places, frequency, stiffest_pair });
    }
    assembly.members.splice(at..at, members);
    Ok(())
}

/// A chunk's nodes and its pairs on them.
fn part(model: &Model, seam: &Seam, chunk: &[u32]) -> (Vec<u32>, Vec<Pair>) {
    let mut nodes: Vec<u32> = Vec::new();
    let mut local: BTreeMap<u32, u16> = BTreeMap::new();
    let mut position = |node: u32| match local.entry(node) {
        Entry::Occupied(known) => *known.get(),
        Entry::Vacant(new) => {
            nodes.push(model.engine_node[node as usize]);
            // Two nodes a pair at most.
            *new.insert(nodes.len() as u16 - 1)
        }
    };
    let pairs = chunk
        .iter()
        .map(|&k| {
            let shape = &seam.pairs[k as usize];
            let [e1, e2] = tangents(shape.normal);
            Pair {
                nodes: shape.nodes.map(&mut position),
                axes: [shape.normal, e1, e2],
                area: shape.normal_area,
            }
        })
        .collect();
    (nodes, pairs)
}

/// Pairs by the masses that they move.
struct Loads {
    /// By interface and pair: 1/m of both nodes along the normal, with their tied sets \[1/kg\].
    inverse: Vec<Vec<[f64; 2]>>,
    /// And the masters of both.
    masters: Vec<Vec<[u32; 2]>>,
    /// Area of the pairs of each interface at a master \[m²\].
    areas: Vec<BTreeMap<u32, f64>>,
}

impl Loads {
    fn of(model: &Model, phase: &Phase) -> Self {
        let mut loads = Loads { inverse: Vec::new(), masters: Vec::new(), areas: Vec::new() };
        for seam in &model.seams {
            let mut areas: BTreeMap<u32, f64> = BTreeMap::new();
            let (mut inverse, mut masters) = (Vec::new(), Vec::new());
            for pair in &seam.pairs {
                let both = pair.nodes.map(|n| phase.master[model.engine_node[n as usize] as usize]);
                both.iter().for_each(|&n| *areas.entry(n).or_default() += pair.normal_area);
                inverse.push(both.map(|n| {
                    let row = &phase.inverse_mass[n as usize];
                    (0..3).map(|i| row.0[i] * pair.normal[i] * pair.normal[i]).sum()
                }));
                masters.push(both);
            }
            loads.inverse.push(inverse);
            loads.masters.push(masters);
            loads.areas.push(areas);
        }
        loads
    }

    /// ω² of each pair of an interface, with the stiffness of each interface.
    fn squares(&self, of: usize, stiffness: impl Fn(usize) -> f64) -> Vec<f64> {
        let at = |master: u32| -> f64 {
            let area = |areas: &BTreeMap<u32, f64>| areas.get(&master).copied().unwrap_or(0.0);
            self.areas.iter().enumerate().map(|(s, areas)| area(areas) * stiffness(s)).sum()
        };
        self.masters[of]
            .iter()
            .zip(&self.inverse[of])
            .map(|(masters, inverse)| inverse[0] * at(masters[0]) + inverse[1] * at(masters[1]))
            .collect()
    }
}

/// Least share of ω_c² that is left to an interface whose stiffness is chosen, where given ones at the same nodes take it up.
const LEAST_SHARE: f64 = 0.1;

/// The values of all interfaces, with what they leave to be chosen.
fn chosen(model: &Model, assembly: &Assembly, phase: &Phase, loads: &Loads) -> Vec<Values> {
    let complete = |seam: &Seam| (seam.law.build)(&seam.values).ok();
    let given: Vec<Option<f64>> =
        model.seams.iter().map(|seam| complete(seam).map(|law| law.stiffest()[0])).collect();
    let left_out = |seam: &Seam| (seam.law.info.chosen)(&seam.values, 1.0) != seam.values;
    if !model.seams.iter().any(left_out) {
        return model.seams.iter().map(|seam| seam.values.clone()).collect();
    }
    let TimeStep { given: step, safety } = model.time_step;
    let dt = step.unwrap_or_else(|| safety * stable_step(model, assembly, phase).dt);
    let choose = |(s, seam): (usize, &Seam)| {
        let most = (seam.limit / dt).powi(2);
        let fixed = loads.squares(s, |other: usize| given[other].unwrap_or(0.0));
        let own = loads.squares(s, |other: usize| f64::from(u8::from(given[other].is_none())));
        let stiffness = fixed
            .iter()
            .zip(&own)
            .map(|(fixed, own)| (most - fixed).max(LEAST_SHARE * most) / own)
            .fold(f64::INFINITY, f64::min);
        (seam.law.info.chosen)(&seam.values, stiffness)
    };
    model.seams.iter().enumerate().map(choose).collect()
}

/// The longest step with which no pair exceeds the limit of its interface.
pub(crate) fn step_limit(model: &Model, assembly: &Assembly) -> Option<ContactLimit> {
    let bounds =
        model.seams.iter().zip(&assembly.contacts).enumerate().map(|(interface, (seam, contacts))| {
            ContactLimit { dt: seam.limit / contacts.frequency, interface, pair: contacts.stiffest_pair }
        });
    bounds.min_by(|a, b| a.dt.total_cmp(&b.dt))
}
