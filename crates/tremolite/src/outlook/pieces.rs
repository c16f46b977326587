//! Pieces of what stands that nothing holds up.

use super::smallest_groups;
use std::collections::{BTreeMap, BTreeSet};
use tremolite_engine::hexahedra::hex;
use tremolite_engine::{Model, Phase};

/// What holds a piece that is not joined to what is held.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Hold {
    /// Nothing: it comes down.
    Nothing,
    /// Bond and friction of these interfaces, none of which it rests on.
    Hangs(Vec<String>),
}

/// Connected elements that neither the base nor a fixed side holds up.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// The smallest group of most of its elements.
    pub group: String,
    /// Ascending, by their numbers in the mesh.
    pub elements: Vec<u32>,
    /// m³
    pub volume: f64,
    /// Smallest and largest coordinates \[m\].
    pub bounds: ([f64; 3], [f64; 3]),
    pub held: Hold,
}

/// Share of the area of a piece's interfaces that faces up into it from below, from which on it rests there: more than
/// round-off of what is vertical.
const RESTS: f64 = 1e-6;

/// Two pieces with pairs of an interface between them.
#[derive(Default)]
struct Contact {
    interfaces: BTreeSet<usize>,
    /// m², and of it what carries the first on the second, and the second on the first.
    area: f64,
    first_rests: f64,
    second_rests: f64,
}

/// Pieces that stand in a phase and are not held up: joined through shared or tied nodes to the base or a side that is fixed.
/// What rests on a piece that is held up, through an interface, is so too.
pub(super) fn pieces(model: &Model, phase: &Phase, standing: &[u32]) -> Vec<Piece> {
    let mut parent: Vec<u32> = (0..phase.master.len() as u32).collect();
    let of = |node: u32| phase.master[model.engine_node[node as usize] as usize];
    for &e in standing {
        let nodes = model.mesh.elements[e as usize].nodes();
        for &node in &nodes[1..] {
            let (a, b) = (root(&mut parent, of(nodes[0])), root(&mut parent, of(node)));
            parent[a.max(b) as usize] = a.min(b);
        }
    }
    let mut parts: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for &e in standing {
        let piece = root(&mut parent, of(model.mesh.elements[e as usize].nodes()[0]));
        parts.entry(piece).or_default().push(e);
    }
    let mut held: BTreeSet<u32> = BTreeSet::new();
    for n in 0..phase.master.len() as u32 {
        let master = phase.master[n as usize] as usize;
        if phase.mass[master] > 0.0 && phase.inverse_mass[master].0[2] == 0.0 {
            held.insert(root(&mut parent, master as u32));
        }
    }
    if parts.keys().all(|piece| held.contains(piece)) {
        return Vec::new();
    }
    let mut contacts: BTreeMap<[u32; 2], Contact> = BTreeMap::new();
    for (i, seam) in model.user_seams().iter().enumerate() {
        for (pair, life) in seam.pairs.iter().zip(&seam.lives) {
            let [a, b] = pair.nodes.map(|node| root(&mut parent, of(node)));
            if a == b || !life.holds(phase.stage) {
                continue;
            }
            let contact = contacts.entry([a, b]).or_default();
            contact.interfaces.insert(i);
            contact.area += pair.area;
            // The normal points out of the first into the second: where it points up the second rests on the first.
            contact.second_rests += pair.area * pair.normal[2].max(0.0);
            contact.first_rests += pair.area * (-pair.normal[2]).max(0.0);
        }
    }
    loop {
        let before = held.len();
        for ([a, b], contact) in &contacts {
            let least = RESTS * contact.area;
            if held.contains(b) && contact.first_rests > least {
                held.insert(*a);
            }
            if held.contains(a) && contact.second_rests > least {
                held.insert(*b);
            }
        }
        if held.len() == before {
            break;
        }
    }
    let smallest = smallest_groups(model);
    parts
        .into_iter()
        .filter(|(piece, _)| !held.contains(piece))
        .map(|(piece, elements)| {
            let touching = contacts.iter().filter(|(sides, _)| sides.contains(&piece));
            let interfaces: BTreeSet<usize> =
                touching.flat_map(|(_, contact)| contact.interfaces.iter().copied()).collect();
            let names = interfaces.into_iter().map(|i| model.seams[i].name.clone()).collect::<Vec<_>>();
            let held = if names.is_empty() { Hold::Nothing } else { Hold::Hangs(names) };
            describe(model, &smallest, elements, held)
        })
        .collect()
}

fn describe(model: &Model, smallest: &[&str], elements: Vec<u32>, held: Hold) -> Piece {
    let mut groups: BTreeMap<&str, usize> = BTreeMap::new();
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    let mut volume = 0.0;
    for &e in &elements {
        *groups.entry(smallest[e as usize]).or_default() += 1;
        // The model has checked every element.
        volume += hex(&model.mesh, e as usize).map_or(0.0, |hex| hex.volume);
        for &node in model.mesh.elements[e as usize].nodes() {
            for (i, x) in model.mesh.nodes[node as usize].into_iter().enumerate() {
                (low[i], high[i]) = (low[i].min(x), high[i].max(x));
            }
        }
    }
    let most = groups.into_iter().max_by_key(|(name, count)| (*count, std::cmp::Reverse(*name)));
    let group = most.map_or(String::new(), |(name, _)| name.to_owned());
    Piece { group, elements, volume, bounds: (low, high), held }
}

/// The root of a node's tree, halving the path on the way.
fn root(parent: &mut [u32], mut node: u32) -> u32 {
    while parent[node as usize] != node {
        parent[node as usize] = parent[parent[node as usize] as usize];
        node = parent[node as usize];
    }
    node
}
