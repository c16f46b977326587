//! What drifts between its own times, and who pushes it then.

use crate::ready::{Ready, joint, whole};
use std::collections::BTreeSet;
use tremolite_engine::{Problem, Side};
use tremolite_mesh::boxes::BoxSpec;

/// Finer towards one corner, with slabs that lead it; with a joint, whose pairs push nodes of both bodies.
fn levels() -> [Ready; 2] {
    let mesh = BoxSpec::uniform([0.0; 3], [9.0, 6.0, 8.0], [9, 6, 8]).mesh().unwrap();
    let mut whole = whole(mesh);
    whole.sides = [Side::FreeField; 2];
    whole.patch_elements = Some(8);
    let mut parted: Problem = whole.clone();
    let upper = parted.bodies[0].elements.split_off(9 * 6 * 4);
    let other = tremolite_engine::Body { elements: upper, ..parted.bodies[0].clone() };
    parted.bodies.push(other);
    parted.interfaces = vec![joint(&parted, [0, 1], 1e9)];
    [whole, parted].map(|problem| Ready::new(problem).levelled(|[x, y, z]| ((x + y + z) / 7.0) as u8))
}

/// Pushed by a finer member or read by one, and what moves as one with such a node.
#[test]
fn what_a_finer_part_pushes_or_reads_drifts_and_is_pushed_by_that_part_alone() {
    for ready in levels() {
        let Ready { model, assembly, phase } = &ready;
        assert_eq!(phase.beats.len(), 4);
        let level = |n: u32| model.nodes.level[n as usize];
        let mut drifting = BTreeSet::new();
        let mut pushes = BTreeSet::new();
        for &m in &phase.active {
            let member = &assembly.members[m as usize];
            let own = member.part.nodes().iter().zip(assembly.slices[m as usize].contributions.clone());
            for (&node, slot) in own {
                let master = phase.master[node as usize];
                if member.level < level(master) {
                    pushes.insert((master, slot as u32, member.level));
                }
            }
            let touched = member.part.nodes().iter().chain(&member.reads.nodes);
            let touched = touched.map(|&n| phase.master[n as usize]);
            drifting.extend(touched.filter(|&n| member.level < level(n)));
        }
        let tied = phase.tied.iter().filter(|(_, master)| drifting.contains(master));
        let tied: Vec<u32> = tied.map(|(node, _)| *node).collect();
        drifting.extend(tied);
        let found: BTreeSet<u32> = phase.borders.iter().map(|border| border.node).collect();
        assert_eq!(found, drifting);
        let own = |border: &tremolite_engine::phase::beats::Border| {
            assert_eq!(border.level, level(border.node));
            phase.pushes(border).iter().map(|push| (border.node, push.slot, push.level)).collect::<Vec<_>>()
        };
        let found: BTreeSet<_> = phase.borders.iter().flat_map(own).collect();
        assert!(found == pushes && pushes.len() > 100, "{} {}", found.len(), pushes.len());
    }
}

/// At a time at which levels up to one have theirs, all that drifts and is coarser, by block.
#[test]
fn what_is_coarser_than_a_beat_drifts_in_it() {
    for ready in levels() {
        let Ready { model, phase, .. } = &ready;
        for (coarsest, beat) in (0..).zip(&phase.beats) {
            assert_eq!(beat.coarsest, coarsest);
            let mut found = Vec::new();
            for drifting in &beat.drifting {
                let block = &model.nodes.blocks[drifting.block];
                assert_eq!(drifting.nodes, block.nodes);
                let own = &phase.borders[drifting.borders.clone()];
                assert!(own.iter().all(|border| block.nodes.contains(&(border.node as usize))));
                found.extend(own.iter().map(|border| border.node));
            }
            let coarser = phase.borders.iter().filter(|border| border.level > coarsest);
            assert_eq!(found, coarser.map(|border| border.node).collect::<Vec<_>>(), "{coarsest}");
        }
        assert!(!phase.beats[0].drifting.is_empty() && phase.beats[3].drifting.is_empty());
    }
}
