//! Nodes of opposite sides at the same place, seen along an axis.

use std::collections::HashMap;

use crate::Mesh;

/// Why the nodes of two opposite sides could not be paired. Seen along the axis:
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Unmatched {
    /// Some nodes have no partner within the tolerance.
    #[error(
        "{count} nodes have no partner on the opposite side; node {node} is the worst, {largest} m from \
         the nearest; give both sides the same mesh, with the same openings, or choose sides of another kind"
    )]
    Apart { count: usize, node: u64, largest: f64 },
    /// Two nodes of one side have the same partner.
    #[error(
        "nodes {first} and {second} have the same partner, {partner}; where bodies have nodes at the \
         same place, match each body on its own"
    )]
    Doubled { first: u64, second: u64, partner: u64 },
}

/// Pairs of nodes of two opposite sides, for periodic ties.
///
/// Partners differ by no more than `tolerance` \[m\] in the two coordinates other than `axis` (0, 1, 2
/// for x, y, z). Pairs `(a, b)` are in the order of `nodes_a`. Every node of both sides has just one
/// partner.
///
/// # Errors
/// The worst node, by its number in the file, and how far it is from its nearest candidate; or two
/// nodes that want the same partner.
///
/// # Panics
/// If a node is not in the mesh or `axis` is not 0, 1 or 2.
pub fn match_faces(
    mesh: &Mesh,
    nodes_a: &[u32],
    nodes_b: &[u32],
    axis: usize,
    tolerance: f64,
) -> Result<Vec<(u32, u32)>, Unmatched> {
    assert!(axis < 3, "axis {axis} is none of x, y, z");
    let (a, b) = (Side::new(mesh, nodes_a, axis), Side::new(mesh, nodes_b, axis));
    let mut worst: Option<(f64, u32)> = None;
    let mut count = 0;
    let mut pairs = Vec::with_capacity(nodes_a.len());
    for (nodes, own, other) in [(nodes_a, &a, &b), (nodes_b, &b, &a)] {
        for &node in nodes {
            let (away, nearest) = other.nearest(own.flat(mesh, node));
            // Not `>`: a distance that is not a number is no match either.
            if away <= tolerance {
                pairs.push((node, nearest));
            } else {
                count += 1;
                if worst.is_none_or(|(most, _)| away > most) {
                    worst = Some((away, node));
                }
            }
        }
    }
    if let Some((largest, node)) = worst {
        return Err(Unmatched::Apart { count, node: mesh.node_id(node as usize), largest });
    }
    let back = pairs.split_off(nodes_a.len());
    for one_way in [&pairs, &back] {
        let mut taken: HashMap<u32, u32> = HashMap::new();
        for &(node, partner) in one_way {
            if let Some(first) = taken.insert(partner, node) {
                let [first, second, partner] = [first, node, partner].map(|n| mesh.node_id(n as usize));
                return Err(Unmatched::Doubled { first, second, partner });
            }
        }
    }
    Ok(pairs)
}

/// The nodes of one side, sorted for the search of the nearest.
struct Side {
    /// The two axes other than the one looked along, the side's longer one first.
    axes: [usize; 2],
    /// Coordinates along these axes, and the node; ascending.
    sorted: Vec<([f64; 2], u32)>,
}

impl Side {
    fn new(mesh: &Mesh, nodes: &[u32], axis: usize) -> Self {
        let extent = |i: usize| {
            let along = || nodes.iter().map(|&n| mesh.nodes[n as usize][i]);
            along().fold(f64::NEG_INFINITY, f64::max) - along().fold(f64::INFINITY, f64::min)
        };
        let (p, q) = ((axis + 1) % 3, (axis + 2) % 3);
        let axes = if extent(p) >= extent(q) { [p, q] } else { [q, p] };
        let mut sorted: Vec<([f64; 2], u32)> =
            nodes.iter().map(|&n| (axes.map(|i| mesh.nodes[n as usize][i]), n)).collect();
        sorted.sort_unstable_by(|a, b| {
            a.0[0].total_cmp(&b.0[0]).then(a.0[1].total_cmp(&b.0[1])).then(a.1.cmp(&b.1))
        });
        Side { axes, sorted }
    }

    /// The node's position; the coordinate looked along is no part of it.
    fn flat(&self, mesh: &Mesh, node: u32) -> [f64; 3] {
        let mut flat = [0.0; 3];
        for i in self.axes {
            flat[i] = mesh.nodes[node as usize][i];
        }
        flat
    }

    /// Distance to the nearest node seen along the axis, and that node; infinite if there is none.
    fn nearest(&self, flat: [f64; 3]) -> (f64, u32) {
        let at = self.axes.map(|i| flat[i]);
        let middle = self.sorted.partition_point(|(p, _)| p[0] < at[0]);
        let mut best = (f64::INFINITY, u32::MAX);
        // Outwards both ways, until the first coordinate alone is farther than the best.
        let mut look = |(p, node): &([f64; 2], u32)| {
            if (p[0] - at[0]).abs() > best.0 {
                return false;
            }
            let away = (p[0] - at[0]).hypot(p[1] - at[1]);
            if away < best.0 {
                best = (away, *node);
            }
            true
        };
        let _ = self.sorted[middle..].iter().all(&mut look);
        let _ = self.sorted[..middle].iter().rev().all(&mut look);
        best
    }
}
