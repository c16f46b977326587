//! In which order nodes are advanced, and which a thread takes together.

use crate::ready::{Ready, whole};
use tremolite_engine::Side;
use tremolite_mesh::boxes::BoxSpec;

/// Nodes that a thread takes together, unless one block has more.
const TOGETHER: usize = 1024;

/// Of a block in 225 patches with three levels and slabs outside: whoever is due is advanced once, and what a thread takes is neither torn
/// nor more than it should be, nor less than it could be.
#[test]
fn threads_take_blocks_without_gaps_up_to_a_thousand_nodes() {
    let mesh = BoxSpec::uniform([0.0; 3], [15.0, 10.0, 12.0], [15, 10, 12]).mesh().unwrap();
    let mut problem = whole(mesh);
    problem.sides = [Side::FreeField; 2];
    problem.patch_elements = Some(8);
    let ready = Ready::new(problem).levelled(|[x, _, z]| ((0.2 * x + 0.15 * z) as u8).min(2));
    assert_eq!(ready.phase.beats.len(), 3);
    let (mut several, mut full) = (0, 0);
    for beat in &ready.phase.beats {
        let mut advanced = vec![0; ready.model.mesh_node.len()];
        for pass in &beat.passes {
            let nodes: usize = pass.turns.iter().map(|turn| turn.nodes.len()).sum();
            assert_eq!(pass.nodes(), nodes);
            pass.turns.iter().flat_map(|turn| turn.nodes.clone()).for_each(|n| advanced[n] += 1);
            let mut next = 0;
            for share in &pass.shares {
                assert!(share.start == next && share.end > next);
                next = share.end;
                let own = &pass.turns[share.clone()];
                for pair in own.windows(2) {
                    assert_eq!(pair[0].block + 1, pair[1].block);
                    assert_eq!(pair[0].nodes.end, pair[1].nodes.start);
                }
                let count: usize = own.iter().map(|turn| turn.nodes.len()).sum();
                assert!(count <= TOGETHER || own.len() == 1, "{count}");
                several += usize::from(own.len() > 1);
                if let Some(after) = pass.turns.get(share.end) {
                    let last = &own[own.len() - 1];
                    if (last.block + 1, last.nodes.end) == (after.block, after.nodes.start) {
                        assert!(count + after.nodes.len() > TOGETHER, "{count} with {}", after.nodes.len());
                        full += 1;
                    }
                }
            }
            assert_eq!(next, pass.turns.len());
        }
        let due = |n: usize| usize::from(ready.model.nodes.level[n] <= beat.coarsest);
        (0..advanced.len()).for_each(|n| assert_eq!(advanced[n], due(n), "node {n}"));
    }
    assert!(several > 3 && full > 0, "{several} {full}");
}
