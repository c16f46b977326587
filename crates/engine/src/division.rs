//! Who has what, where several ranks work on one model.
//!
//! A division goes by the assembly and the number of ranks alone, so that every rank finds the same by itself, and it is the same in all
//! stages, so that no memory moves from one to the next. Patches of all bodies are lined up and cut into runs of equal weight on each level of
//! steps; nodes belong to whoever has the patch that first touches them, as a block of them does as a whole, and any other
//! part goes where most of its nodes are.

mod cut;

use crate::assembly::Assembly;
use crate::hexahedra::centroid;
use crate::member::Member;
use crate::model::{Model, Patch};
use cut::Cut;
use tremolite_kernels::Quadrature;

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
    /// most to do in it.
    pub imbalance: f64,
}

/// Moving a node once, where 1 is an update of an elastic brick.
const MOVED: f64 = 0.25;

/// What cracks takes this much more work once it has, of what it took sound.
const CRACKED: f64 = 1.0;
/// The history by which a law is known that cracks.
const CRACKS: &str = "d_tension";

/// Work of each patch once its elements and nodes are due, by the level at which they are.
struct Works {
    levels: usize,
    all: Vec<f64>,
    /// What cracks adds.
    cracked: Vec<f64>,
}

impl Works {
    /// `touched` are the patches of each node, of which the first has it.
    fn new(model: &Model, assembly: &Assembly, touched: &[Vec<u32>]) -> Self {
        let levels = usize::from(model.nodes.coarsest()) + 1;
        let mut all = vec![0.0; levels * model.patches.len()];
        let mut cracked = all.clone();
        for (p, patch) in model.patches.iter().enumerate() {
            let (update, at) = (update(model, assembly, p), levels * p + usize::from(patch.level));
            all[at] += update;
            let part = &assembly.members[assembly.of_patch[p] as usize].part;
            if part.columns().iter().any(|column| column.name == CRACKS) {
                cracked[at] += CRACKED * update;
            }
        }
        for (patches, &level) in touched.iter().zip(&model.nodes.level) {
            if let Some(&first) = patches.first() {
                all[levels * first as usize + usize::from(level)] += MOVED;
            }
        }
        Works { levels, all, cracked }
    }

    /// Work of a patch in a step at which levels up to one are due, with a share of all cracked that may crack.
    fn up_to(&self, patch: usize, level: u8, cracked: f64) -> f64 {
        let sum = |of: &[f64]| of[self.levels * patch..][..=usize::from(level)].iter().sum::<f64>();
        sum(&self.all) + cracked * sum(&self.cracked)
    }

    /// The sum over the steps of the finest level in one of the coarsest of what is found for the levels that are due in it.
    fn by_beat(&self, one: impl Fn(u8) -> f64) -> f64 {
        let coarsest = self.levels as u8 - 1;
        let often = |level: u8| f64::from(1u32 << (coarsest - level).saturating_sub(1));
        (0..=coarsest).map(|level| often(level) * one(level)).sum()
    }
}

impl Division {
    /// Even on each level of steps, with little between ranks.
    pub fn even(model: &Model, assembly: &Assembly, ranks: u32) -> Self {
        let ranks = ranks.max(1);
        let middle = |patch: &Patch| {
            let mut sum = [0.0; 3];
            for &e in &patch.elements {
                let at = centroid(&model.mesh, e);
                (0..3).for_each(|i| sum[i] += at[i]);
            }
            sum.map(|s| s / patch.elements.len().max(1) as f64)
        };
        let touched = touched(model);
        let works = Works::new(model, assembly, &touched);
        let mut of_patch = vec![0; model.patches.len()];
        if ranks > 1 {
            let middles: Vec<[f64; 3]> = model.patches.iter().map(middle).collect();
            let cut = Cut::new(model, &works, &middles, &touched);
            cut.among((0..model.patches.len() as u32).collect(), 0..ranks, &mut of_patch);
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
        let each = |level: u8| {
            let mut each = vec![0.0; ranks as usize];
            (0..).zip(of_patch).for_each(|(p, &rank)| each[rank as usize] += works.up_to(p, level, 0.0));
            each
        };
        let slowest = works.by_beat(|level| each(level).into_iter().fold(0.0, f64::max));
        let weights: Vec<f64> =
            (0..ranks as usize).map(|rank| works.by_beat(|level| each(level)[rank])).collect();
        let mean = weights.iter().sum::<f64>() / f64::from(ranks);
        Division { ranks, of_member, of_block, weights, imbalance: slowest / mean }
    }
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

/// One update of a patch, where 1 is that of an elastic brick. What points and columns of their history
/// cost is about what docs/performance.md has measured.
fn update(model: &Model, assembly: &Assembly, patch: usize) -> f64 {
    let part = &assembly.members[assembly.of_patch[patch] as usize].part;
    let patch = &model.patches[patch];
    let (elements, points) = part.elements();
    let of_point = match model.bodies[patch.body].quadrature {
        Quadrature::Layered(_) => 0.9,
        Quadrature::OnePoint | Quadrature::Full => 1.0,
    };
    let element = 0.6 + points as f64 * of_point * (0.4 + 0.03 * part.columns().len() as f64);
    let shape = if patch.bricks || points > 1 { 1.0 } else { 1.5 };
    elements as f64 * element * shape
}
