//! Whether a relaxation has gone beyond what small strains can be.

use crate::assembly::Assembly;
use crate::hexahedra::hex_nodes;
use crate::model::{Model, Patch};
use crate::phase::Phase;
use crate::state::State;
use rayon::prelude::*;
use tremolite_laws::Row;

/// Strain beyond which a body comes apart.
const MOST: f64 = 0.1;

/// Pairs of corners that an edge joins.
const EDGES: [[usize; 2]; 12] =
    [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4], [0, 4], [1, 5], [2, 6], [3, 7]];

/// The first active element one of whose edges has strained by a tenth since the relaxation began, or that has moved by more
/// than its longest edge: its member and itself. On a rank, of those that it has.
pub(super) fn torn(model: &Model, assembly: &Assembly, phase: &Phase, state: &State) -> Option<[u32; 2]> {
    let moved = |node: u32| -> [f64; 3] {
        let node = model.engine_node[node as usize] as usize;
        let (u, start): (Row, Row) = (state.u[node], state.start[node]);
        [0, 1, 2].map(|i| u.0[i] - start.0[i])
    };
    let between = |a: [f64; 3], b: [f64; 3]| (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt();
    let is_torn = |element: u32| {
        let nodes = hex_nodes(&model.mesh, element as usize);
        let motion = nodes.map(moved);
        let mut longest = 0.0f64;
        for [a, b] in EDGES {
            let length = between(model.mesh.nodes[nodes[a] as usize], model.mesh.nodes[nodes[b] as usize]);
            longest = longest.max(length);
            if between(motion[a], motion[b]) > MOST * length && length > 0.0 {
                return true;
            }
        }
        motion.iter().any(|&d| between(d, [0.0; 3]) > longest)
    };
    let of = |&m: &u32| Some((m, &model.patches[assembly.members[m as usize].kind.patch()?]));
    let patches: Vec<(u32, &Patch)> = phase.members().iter().filter_map(of).collect();
    let first =
        |(m, patch): &(u32, &Patch)| Some([*m, patch.elements.iter().copied().find(|&e| is_torn(e))?]);
    patches.par_iter().find_map_first(first)
}
