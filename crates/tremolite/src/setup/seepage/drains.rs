//! The nodes of drains.

use tremolite_mesh::Mesh;

/// Distances that are this near to one another, over their elements' size, are the same: mirror images have the same nodes.
const SAME: f64 = 1e-6;

/// Of each element that a line between two points passes, by the boxes around elements, the nodes nearest to the line.
pub(super) fn along(mesh: &Mesh, ground: &[u32], from: [f64; 3], to: [f64; 3]) -> Vec<u32> {
    let mut found = Vec::new();
    for &e in ground {
        let nodes = mesh.elements[e as usize].nodes();
        let corners = || nodes.iter().map(|&n| mesh.nodes[n as usize]);
        let extreme =
            |i: usize, pick: fn(f64, f64) -> f64, start: f64| corners().map(|x| x[i]).fold(start, pick);
        let low = [0, 1, 2].map(|i| extreme(i, f64::min, f64::INFINITY));
        let high = [0, 1, 2].map(|i| extreme(i, f64::max, f64::NEG_INFINITY));
        let size = (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max);
        if !passes(from, to, low.map(|x| x - SAME * size), high.map(|x| x + SAME * size)) {
            continue;
        }
        let nearest = corners().map(|x| distance(x, from, to)).fold(f64::INFINITY, f64::min);
        let near =
            nodes.iter().filter(|&&n| distance(mesh.nodes[n as usize], from, to) <= nearest + SAME * size);
        found.extend(near.copied());
    }
    found.sort_unstable();
    found.dedup();
    found
}

/// Whether the line between two points passes a box.
fn passes(from: [f64; 3], to: [f64; 3], low: [f64; 3], high: [f64; 3]) -> bool {
    let (mut enters, mut leaves) = (0.0_f64, 1.0_f64);
    for i in 0..3 {
        let along = to[i] - from[i];
        if along == 0.0 {
            if from[i] < low[i] || from[i] > high[i] {
                return false;
            }
            continue;
        }
        let at = [(low[i] - from[i]) / along, (high[i] - from[i]) / along];
        enters = enters.max(at[0].min(at[1]));
        leaves = leaves.min(at[0].max(at[1]));
    }
    enters <= leaves
}

/// Distance \[m\] of a point from the line between two others.
fn distance(x: [f64; 3], from: [f64; 3], to: [f64; 3]) -> f64 {
    let along: f64 = (0..3).map(|i| (to[i] - from[i]) * (x[i] - from[i])).sum();
    let square: f64 = (0..3).map(|i| (to[i] - from[i]).powi(2)).sum();
    let t = if square > 0.0 { (along / square).clamp(0.0, 1.0) } else { 0.0 };
    (0..3).map(|i| (from[i] + t * (to[i] - from[i]) - x[i]).powi(2)).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use tremolite_mesh::boxes::BoxSpec;

    #[test]
    fn a_line_has_the_nodes_beside_it_in_every_element_that_it_passes() {
        let mesh = BoxSpec::uniform([0.0; 3], [4.0; 3], [4; 3]).mesh().unwrap();
        let all: Vec<u32> = (0..mesh.elements.len() as u32).collect();
        let nodes = along(&mesh, &all, [1.1, -1.0, 2.9], [1.1, 3.2, 2.9]);
        let places: Vec<[f64; 3]> = nodes.iter().map(|&n| mesh.nodes[n as usize]).collect();
        // It ends nearer to y = 3 than to y = 4 in the last of them.
        let exact: Vec<[f64; 3]> = (0..=3).map(|j| [1.0, f64::from(j), 3.0]).collect();
        assert_eq!(places, exact);
        assert!(along(&mesh, &all, [9.0, 0.0, 0.0], [9.0, 4.0, 4.0]).is_empty());
    }
}
