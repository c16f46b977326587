//! Which nodes move onto a plane, and which edges take a node of their own.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use super::flow::Flow;

/// What it costs to move a node or to part an edge.
#[derive(Clone, Debug, Default)]
pub(super) struct Prices {
    /// Of nodes near the plane; those not here cannot come onto it.
    pub nodes: BTreeMap<u32, f64>,
    /// Of edges that it crosses, the node above first.
    pub edges: BTreeMap<[u32; 2], f64>,
}

/// What was chosen.
#[derive(Clone, Debug, Default)]
pub(super) struct Choice {
    /// Nodes that come onto the plane.
    pub nodes: BTreeSet<u32>,
    /// Edges that are parted, the node above first.
    pub edges: BTreeSet<[u32; 2]>,
}

/// More than any sum of prices.
const NEVER: f64 = 1e9;

/// The cheapest choice by which every crossed edge has an end on the plane or is parted: a minimum cut between the nodes above and those
/// below.
pub(super) fn cheapest(prices: &Prices) -> Choice {
    let mut place: HashMap<u32, usize> = HashMap::new();
    let mut order: Vec<(u32, bool)> = Vec::new();
    for &[above, below] in prices.edges.keys() {
        for (n, is_above) in [(above, true), (below, false)] {
            place.entry(n).or_insert_with(|| {
                order.push((n, is_above));
                order.len() + 1
            });
        }
    }
    let mut flow = Flow::new(order.len());
    for (k, (n, above)) in order.iter().enumerate() {
        let price = prices.nodes.get(n).copied().unwrap_or(NEVER);
        match above {
            true => flow.link(0, k + 2, price),
            false => flow.link(k + 2, 1, price),
        }
    }
    for ([above, below], price) in &prices.edges {
        flow.link(place[above], place[below], *price);
    }
    let near = flow.cut();
    let taken = |n: u32, above: bool| near[place[&n]] != above;
    let nodes = order.iter().filter(|(n, above)| taken(*n, *above)).map(|(n, _)| *n).collect();
    let open = |[a, b]: &&[u32; 2]| !taken(*a, true) && !taken(*b, false);
    Choice { nodes, edges: prices.edges.keys().filter(open).copied().collect() }
}
