//! Who has what, where several ranks work on one model.
//!
//! A division goes by the assembly and the number of ranks alone, so that every rank finds the same by itself, and it is the same in all
//! stages, so that no memory moves from one to the next. Patches of all bodies are lined up along one Hilbert curve through the model
//! and cut into runs of equal weight; nodes belong to whoever has the patch that first touches them, as a block of them does as a whole, and any other
//! part goes where most of its nodes are.

use crate::assembly::Assembly;
use crate::hexahedra::centroid;
use crate::member::Member;
use crate::model::{Model, Patch};
use tremolite_kernels::Quadrature;
use tremolite_mesh::order::hilbert_order;

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
}

impl Division {
    /// Runs of equal weight along a Hilbert curve.
    pub fn along_a_curve(model: &Model, assembly: &Assembly, ranks: u32) -> Self {
        let ranks = ranks.max(1);
        let middle = |patch: &Patch| {
            let mut sum = [0.0; 3];
            for &e in &patch.elements {
                let at = centroid(&model.mesh, e);
                (0..3).for_each(|i| sum[i] += at[i]);
            }
            sum.map(|s| s / patch.elements.len().max(1) as f64)
        };
        let middles: Vec<[f64; 3]> = model.patches.iter().map(middle).collect();
        let weights: Vec<f64> = (0..model.patches.len()).map(|p| weight(model, assembly, p)).collect();
        let mut of_patch = vec![0; model.patches.len()];
        let order = hilbert_order(&middles);
        cut(&order, &weights, 0..ranks, &mut of_patch);
        Division::of(model, assembly, ranks, &of_patch)
    }

    /// Patches dealt out one by one: the worst that can be done, for tests.
    pub fn scattered(model: &Model, assembly: &Assembly, ranks: u32) -> Self {
        let ranks = ranks.max(1);
        let of_patch: Vec<u32> = (0..model.patches.len() as u32).map(|p| p % ranks).collect();
        Division::of(model, assembly, ranks, &of_patch)
    }

    fn of(model: &Model, assembly: &Assembly, ranks: u32, of_patch: &[u32]) -> Self {
        let mut of_node = vec![u32::MAX; model.mesh_node.len()];
        for (patch, &rank) in model.patches.iter().zip(of_patch) {
            for &node in patch.elements.iter().flat_map(|&e| model.mesh.elements[e as usize].nodes()) {
                let of = &mut of_node[model.engine_node[node as usize] as usize];
                if *of == u32::MAX {
                    *of = rank;
                }
            }
        }
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
        let mut weights = vec![0.0; ranks as usize];
        for (patch, &rank) in of_patch.iter().enumerate() {
            weights[rank as usize] += weight(model, assembly, patch);
        }
        Division { ranks, of_member, of_block, weights }
    }

    /// The largest weight of a rank over the mean.
    pub fn imbalance(&self) -> f64 {
        let mean = self.weights.iter().sum::<f64>() / self.weights.len() as f64;
        self.weights.iter().copied().fold(0.0, f64::max) / mean
    }
}

/// Cuts an order into runs for some ranks, in halves as equal as may be.
fn cut(order: &[u32], weights: &[f64], ranks: std::ops::Range<u32>, of: &mut [u32]) {
    if ranks.len() <= 1 {
        order.iter().for_each(|&p| of[p as usize] = ranks.start);
        return;
    }
    let half = ranks.start + ranks.len() as u32 / 2;
    let whole: f64 = order.iter().map(|&p| weights[p as usize]).sum();
    let wanted = whole * f64::from(half - ranks.start) / ranks.len() as f64;
    let mut sum = 0.0;
    // A patch goes where more of it lies.
    let before = order.iter().take_while(|&&p| {
        let weight = weights[p as usize];
        sum += weight;
        sum - 0.5 * weight < wanted
    });
    let (first, second) = order.split_at(before.count());
    cut(first, weights, ranks.start..half, of);
    cut(second, weights, half..ranks.end, of);
}

/// Work of a patch in a step of the coarsest level, where an update of an elastic brick is 1. What points and columns of their history
/// cost is about what docs/performance.md has measured.
fn weight(model: &Model, assembly: &Assembly, patch: usize) -> f64 {
    let part = &assembly.members[assembly.of_patch[patch] as usize].part;
    let patch = &model.patches[patch];
    let (elements, points) = part.elements();
    let of_point = match model.bodies[patch.body].quadrature {
        Quadrature::Layered(_) => 0.55,
        Quadrature::OnePoint | Quadrature::Full => 1.0,
    };
    let element = 0.6 + points as f64 * of_point * (0.4 + 0.03 * part.columns().len() as f64);
    let shape = if patch.bricks || points > 1 { 1.0 } else { 1.5 };
    let updates = 1u32 << (model.nodes.coarsest() - patch.level);
    elements as f64 * element * shape * f64::from(updates)
}
