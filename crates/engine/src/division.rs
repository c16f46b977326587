//! Who has what, where several ranks work on one model.
//!
//! A division goes by the assembly and the number of ranks alone, so that every rank finds the same by itself, and it is the same in all
//! stages, so that no memory moves from one to the next. Patches of all bodies are lined up and cut into runs of equal weight on each level of
//! steps; nodes belong to whoever has the patch that first touches them, as a block of them does as a whole, and any other
//! part goes where most of its nodes are.

mod cut;
mod evened;
mod works;

use crate::assembly::Assembly;
use crate::hexahedra::centroid;
use crate::member::Member;
use crate::model::{Model, Patch};
use cut::Cut;
use works::Works;

/// Who evaluates the parts of a model and who adds up over its nodes.
#[derive(Clone, Debug, PartialEq)]
pub struct Division {
    pub ranks: u32,
    /// The rank that evaluates each member.
    pub of_member: Vec<u32>,
    /// The rank that adds up over each block of nodes, and whose motion of them is written.
    pub of_block: Vec<u32>,
    /// Work of each rank in a step of the coarsest level: 1 is an update of an elastic brick.
    pub weights: Vec<f64>,
    /// The time that such a step takes over that of ranks which never wait: in each step of the finest level all wait for the one with
    /// most to do in it. While nothing has cracked.
    pub imbalance: f64,
    /// The same once all that can crack has, or one body of it alone, such as one of two linings, whichever is worst.
    pub imbalance_cracked: f64,
}

impl Division {
    /// Even on each level of steps, with little between ranks.
    pub fn even(model: &Model, assembly: &Assembly, ranks: u32) -> Self {
        let ranks = ranks.max(1);
        let middles = middles(model);
        let touched = touched(model);
        let works = Works::new(model, assembly, &touched);
        let mut of_patch = vec![0; model.patches.len()];
        if ranks > 1 {
            let cut = Cut::new(model, &works, &middles, &touched);
            cut.among((0..model.patches.len() as u32).collect(), 0..ranks, &mut of_patch);
            evened::even_out(&cut, ranks, &mut of_patch);
        }
        Division::of(model, assembly, ranks, &of_patch, (&works, &touched))
    }

    /// Patches dealt out one by one: the worst that can be done, for tests.
    pub fn scattered(model: &Model, assembly: &Assembly, ranks: u32) -> Self {
        let ranks = ranks.max(1);
        let of_patch: Vec<u32> = (0..model.patches.len() as u32).map(|p| p % ranks).collect();
        let touched = touched(model);
        let works = Works::new(model, assembly, &touched);
        Division::of(model, assembly, ranks, &of_patch, (&works, &touched))
    }

    fn of(
        model: &Model,
        assembly: &Assembly,
        ranks: u32,
        of_patch: &[u32],
        (works, touched): (&Works, &[Vec<u32>]),
    ) -> Self {
        let of_node: Vec<u32> = touched
            .iter()
            .map(|patches| patches.first().map_or(u32::MAX, |&p| of_patch[p as usize]))
            .collect();
        let of_block = model.nodes.blocks.iter().map(|block| of_node[block.nodes.start]).collect();
        let most = |member: &Member| {
            let mut counts = vec![0u32; ranks as usize];
            member.part.nodes().iter().for_each(|&n| counts[of_node[n as usize] as usize] += 1);
            let most = counts.iter().copied().max().unwrap_or(0);
            counts.iter().position(|&count| count == most).unwrap_or(0) as u32
        };
        let of_member: Vec<u32> = assembly
            .members
            .iter()
            .map(|member| member.kind.patch().map_or_else(|| most(member), |patch| of_patch[patch]))
            .collect();
        let each = |case: usize, level: u8| {
            let mut each = vec![0.0; ranks as usize];
            (0..).zip(of_patch).for_each(|(p, &rank)| each[rank as usize] += works.up_to(p, level, case));
            each
        };
        let imbalance = |case: usize| {
            let slowest = works.by_beat(|level| each(case, level).into_iter().fold(0.0, f64::max));
            let all = works.by_beat(|level| each(case, level).into_iter().sum());
            f64::from(ranks) * slowest / all
        };
        let cracked = works.cases().map(|(case, _)| imbalance(case)).fold(1.0, f64::max);
        let weights =
            (0..ranks as usize).map(|rank| works.by_beat(|level| each(Works::SOUND, level)[rank])).collect();
        Division {
            ranks,
            of_member,
            of_block,
            weights,
            imbalance: imbalance(Works::SOUND),
            imbalance_cracked: cracked,
        }
    }
}

/// The middle of each patch.
fn middles(model: &Model) -> Vec<[f64; 3]> {
    let middle = |patch: &Patch| {
        let mut sum = [0.0; 3];
        for &e in &patch.elements {
            let at = centroid(&model.mesh, e);
            (0..3).for_each(|i| sum[i] += at[i]);
        }
        sum.map(|s| s / patch.elements.len().max(1) as f64)
    };
    model.patches.iter().map(middle).collect()
}

/// The patches of each engine node, ascending.
fn touched(model: &Model) -> Vec<Vec<u32>> {
    let mut touched = vec![Vec::new(); model.mesh_node.len()];
    for (p, patch) in (0u32..).zip(&model.patches) {
        for &node in patch.elements.iter().flat_map(|&e| model.mesh.elements[e as usize].nodes()) {
            let all: &mut Vec<u32> = &mut touched[model.engine_node[node as usize] as usize];
            if all.last() != Some(&p) {
                all.push(p);
            }
        }
    }
    touched
}
