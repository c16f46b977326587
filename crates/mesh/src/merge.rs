//! Nodes at the same place, merged where parts of a mesh should be joined.

use std::collections::BTreeMap;

use crate::Mesh;
use crate::assembly::drop_unused_nodes;

pub use crate::coincident::{coincident_nodes, shortest_edge};

/// Why nodes were not merged.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MergeError {
    /// Two nodes of one element would become one.
    #[error(
        "merging nodes within {tolerance} m would collapse element {element}: nodes {first} and {second} of it are \
         closer than that; use a smaller tolerance"
    )]
    Collapses { tolerance: f64, element: u64, first: u64, second: u64 },
    /// The tolerance is negative or not finite.
    #[error("the tolerance for merging nodes is {tolerance} m, expected a small positive length")]
    Tolerance { tolerance: f64 },
}

/// Merges nodes within `tolerance` \[m\] of an earlier one into that one; how many disappear.
///
/// Groups and named faces and points stay. The mesh is unchanged on an error.
///
/// # Errors
/// If two nodes of one element are within the tolerance, or that is no length.
pub fn merge_nodes(mesh: &mut Mesh, tolerance: f64) -> Result<usize, MergeError> {
    if !tolerance.is_finite() || tolerance < 0.0 {
        return Err(MergeError::Tolerance { tolerance });
    }
    let into: BTreeMap<u32, u32> = coincident_nodes(mesh, tolerance).into_iter().collect();
    let target = |node: u32| into.get(&node).copied().unwrap_or(node);
    for (e, element) in mesh.elements.iter().enumerate() {
        let nodes = element.nodes();
        for (i, &node) in nodes.iter().enumerate() {
            let twin = nodes[..i].iter().find(|&&other| other != node && target(other) == target(node));
            if let Some(&twin) = twin {
                let [first, second] = [twin, node].map(|n| mesh.node_id(n as usize));
                return Err(MergeError::Collapses { tolerance, element: mesh.element_id(e), first, second });
            }
        }
    }
    for node in mesh.elements.iter_mut().flat_map(|e| &mut e.nodes) {
        *node = target(*node);
    }
    drop_unused_nodes(mesh);
    Ok(into.len())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::{Random, distorted_box};

    /// Two boxes side by side that share no nodes; those of the second are up to 1e-5 m off.
    fn two_boxes() -> Mesh {
        let mut mesh = distorted_box(4);
        let mut random = Random(3);
        let mut second = distorted_box(4);
        for node in &mut second.nodes {
            for x in &mut *node {
                *x += 5e-6 * random.next();
            }
            node[0] += 4.0;
        }
        let offset = mesh.nodes.len() as u32;
        mesh.nodes.extend(second.nodes);
        for mut element in second.elements {
            element.nodes = element.nodes.map(|n| n + offset);
            mesh.elements.push(element);
        }
        mesh
    }

    #[test]
    fn nodes_of_two_boxes_are_found_and_merged_within_the_tolerance() {
        let mut mesh = two_boxes();
        assert_eq!(coincident_nodes(&mesh, 0.0), []);
        let pairs = coincident_nodes(&mesh, 1e-5);
        assert_eq!(pairs.len(), 25);
        for &(node, first) in &pairs {
            assert!(node >= 125 && first < 125);
            assert!((mesh.nodes[node as usize][1] - mesh.nodes[first as usize][1]).abs() <= 1e-5);
        }
        assert_eq!(crate::topology::components(&mesh, None).len(), 2);
        assert_eq!(merge_nodes(&mut mesh, 1e-5), Ok(25));
        assert_eq!(mesh.nodes.len(), 225);
        assert_eq!(crate::topology::components(&mesh, None).len(), 1);
    }

    #[test]
    fn a_tolerance_that_would_collapse_an_element_is_refused() {
        let mut mesh = distorted_box(2);
        let before = mesh.clone();
        let error = merge_nodes(&mut mesh, 1.1).unwrap_err();
        assert!(error.to_string().contains("would collapse element 1"), "{error}");
        assert!(matches!(merge_nodes(&mut mesh, f64::NAN), Err(MergeError::Tolerance { .. })));
        assert!(shortest_edge(&mesh) > 0.3 && shortest_edge(&mesh) < 1.1);
        assert_eq!(mesh, before);
    }
}
