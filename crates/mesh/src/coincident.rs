//! Nodes at the same place, found.

use std::collections::HashMap;

use crate::Mesh;

/// Length of the shortest edge \[m\] of all elements; 0 for a mesh without any.
pub fn shortest_edge(mesh: &Mesh) -> f64 {
    let mut shortest = f64::INFINITY;
    for element in &mesh.elements {
        for face in element.shape.faces() {
            for k in 0..face.len() {
                let [a, b] = [face[k], face[(k + 1) % face.len()]];
                // Each edge is in two faces, once in each direction.
                if a < b {
                    let [a, b] = [a, b].map(|k| &mesh.nodes[element.nodes[k] as usize]);
                    shortest = shortest.min(squared_distance(a, b));
                }
            }
        }
    }
    if shortest.is_finite() { shortest.sqrt() } else { 0.0 }
}

/// Nodes within `tolerance` \[m\] of an earlier one, each with the first such node, ascending.
///
/// An earlier node is only one that is not itself near an even earlier one, so chains are cut, not followed.
pub fn coincident_nodes(mesh: &Mesh, tolerance: f64) -> Vec<(u32, u32)> {
    let mut pairs = Vec::new();
    let mut order: Vec<u32> = (0..mesh.nodes.len() as u32).collect();
    // Pieces of `order`, with the axis to cut along next and along how many axes in turn there was no gap.
    let mut pieces = vec![(0, order.len(), 0, 0)];
    while let Some((start, end, axis, tried)) = pieces.pop() {
        let piece = &mut order[start..end];
        if tried == 3 {
            piece.sort_unstable();
            nearest_earlier(mesh, piece, tolerance, &mut pairs);
            continue;
        }
        let x = |node: u32| mesh.nodes[node as usize][axis];
        piece.sort_unstable_by(|&a, &b| x(a).total_cmp(&x(b)));
        let mut from = start;
        for to in start + 1..=end {
            if to < end && x(order[to]) - x(order[to - 1]) <= tolerance {
                continue;
            }
            if to - from > 1 {
                let uncut = to - from == end - start;
                pieces.push((from, to, (axis + 1) % 3, if uncut { tried + 1 } else { 1 }));
            }
            from = to;
        }
    }
    pairs.sort_unstable();
    pairs
}

/// Pieces up to this size are searched all with all.
const FEW: usize = 32;

/// Adds the pairs in one piece, whose nodes are ascending.
fn nearest_earlier(mesh: &Mesh, piece: &[u32], tolerance: f64, pairs: &mut Vec<(u32, u32)>) {
    if piece.len() > FEW {
        return in_cells(mesh, piece, tolerance, pairs);
    }
    let mut firsts: Vec<u32> = Vec::new();
    for &node in piece {
        match firsts.iter().find(|&&first| near(mesh, first, node, tolerance)) {
            Some(&first) => pairs.push((node, first)),
            None => firsts.push(node),
        }
    }
}

/// The same for a piece of any size, in a time that grows with its size only: an unstructured mesh has no gaps along
/// the axes. Cells are twice as wide as what is looked for, so eight hold all that is near, and few nodes of which
/// none is near another fit into one.
fn in_cells(mesh: &Mesh, piece: &[u32], tolerance: f64, pairs: &mut Vec<(u32, u32)>) {
    let places = || piece.iter().map(|&n| &mesh.nodes[n as usize]);
    let low = [0, 1, 2].map(|i| places().map(|x| x[i]).fold(f64::INFINITY, f64::min));
    let high = [0, 1, 2].map(|i| places().map(|x| x[i]).fold(f64::NEG_INFINITY, f64::max));
    let extent = (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max);
    // Not so narrow that cells cannot be told apart.
    let width = (2.0 * tolerance).max(1e-12 * extent).max(f64::MIN_POSITIVE);
    let cell = |offset: f64| (offset / width).floor() as i64;
    let mut cells: HashMap<[i64; 3], Vec<u32>> = HashMap::new();
    for &node in piece {
        let x = mesh.nodes[node as usize];
        let around = [0, 1, 2].map(|i| {
            let offset = x[i] - low[i];
            cell(offset - tolerance)..=cell(offset + tolerance)
        });
        let mut first: Option<u32> = None;
        for i in around[0].clone() {
            for j in around[1].clone() {
                for k in around[2].clone() {
                    let others = cells.get(&[i, j, k]).map_or([].as_slice(), Vec::as_slice);
                    let nearby = others.iter().copied().find(|&o| near(mesh, o, node, tolerance));
                    first = first.into_iter().chain(nearby).min();
                }
            }
        }
        match first {
            Some(first) => pairs.push((node, first)),
            None => cells.entry([0, 1, 2].map(|i| cell(x[i] - low[i]))).or_default().push(node),
        }
    }
}

fn near(mesh: &Mesh, a: u32, b: u32, tolerance: f64) -> bool {
    squared_distance(&mesh.nodes[a as usize], &mesh.nodes[b as usize]) <= tolerance * tolerance
}

pub(crate) fn squared_distance(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    (0..3).map(|i| (a[i] - b[i]).powi(2)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::Random;

    #[test]
    fn pairs_are_those_of_a_search_of_all_with_all() {
        let mut random = Random(17);
        let nodes = (0..400).map(|_| [0; 3].map(|_| random.next())).collect();
        let mesh = Mesh { nodes, ..Mesh::default() };
        for tolerance in [0.0, 0.01, 0.05, 0.1, 2.0] {
            let mut naive: Vec<(u32, u32)> = Vec::new();
            for node in 0..400 {
                let first = |&o: &u32| naive.iter().all(|p| p.0 != o) && near(&mesh, o, node, tolerance);
                let first = (0..node).find(first);
                naive.extend(first.map(|first| (node, first)));
            }
            assert_eq!(coincident_nodes(&mesh, tolerance), naive, "{tolerance}");
        }
    }

    /// Without gaps along the axes, as in a mesh of tetrahedra; all with all would take minutes.
    #[test]
    fn many_nodes_without_gaps_are_searched_at_once() {
        let mut random = Random(23);
        let nodes: Vec<[f64; 3]> = (0..200_000).map(|_| [0; 3].map(|_| random.next())).collect();
        let mut mesh = Mesh { nodes, ..Mesh::default() };
        mesh.nodes.extend_from_within(..1000);
        let pairs = coincident_nodes(&mesh, 1e-4);
        assert!((0..1000).all(|n| pairs.iter().any(|&(node, _)| node == 200_000 + n)));
    }
}
