//! Nodes at which something begins to stand.

use crate::assembly::Assembly;
use crate::life::{Life, Stage};
use crate::model::Model;
use crate::rims::Rims;
use std::collections::{BTreeMap, BTreeSet};

/// Nodes of elements that are there in a stage, of which none was in that before: those that others hold which were, and the rest.
pub fn woken(model: &Model, assembly: &Assembly, stage: Stage) -> (Vec<(u32, Vec<u32>)>, Vec<u32>) {
    let nodes = |there: &dyn Fn(&Life) -> bool| -> BTreeSet<u32> {
        let solids =
            assembly.members.iter().filter(|member| member.part.elements().0 > 0 && there(&member.life));
        solids.flat_map(|member| member.part.nodes().iter().copied()).collect()
    };
    let begins = assembly.members.iter().any(|member| member.life.is_later() && member.life.born == stage);
    let Stage::Before(k) = stage else { return Default::default() };
    if !begins || k == 0 {
        return Default::default();
    }
    let before = nodes(&|life| life.holds(Stage::Before(k - 1)));
    let new = nodes(&|life| life.born == stage).into_iter().filter(|n| !before.contains(n));
    let rims = Rims::of(&model.parted.joints);
    let mut held: BTreeMap<u32, BTreeSet<u32>> = BTreeMap::new();
    for node in model.parted.joints.iter().flat_map(|joint| joint.nodes) {
        let engine = model.engine_node[node as usize];
        if before.contains(&engine) {
            held.entry(rims.root(stage, node)).or_default().insert(engine);
        }
    }
    let others = |node: u32| held.get(&rims.root(stage, model.mesh_node[node as usize]));
    let (joined, woken): (Vec<u32>, Vec<u32>) = new.partition(|&n| others(n).is_some());
    let with_others = |n: u32| (n, others(n).into_iter().flatten().copied().collect());
    (joined.into_iter().map(with_others).collect(), woken)
}
