//! What each patch costs in a step, sound or cracked.

use crate::assembly::Assembly;
use crate::member::Kind;
use crate::model::Model;
use std::collections::BTreeMap;
use tremolite_kernels::Quadrature;

/// Moving a node once, with its share in the balance, where 1 is an update of an elastic brick (some 45 ns on an EPYC). Here and below: as
/// measured part by part in `cases/yingxiuwan/quick.toml`.
pub(super) const MOVED: f64 = 1.0;
/// What cracks takes this much more work once it has, of what it took sound.
const CRACKED: f64 = 0.7;
/// A pair of an interface, by each node that it pushes.
const PAIR: f64 = 0.25;
/// A base or another boundary, and what else is no element, by node.
const BOUNDARY: f64 = 1.5;
/// Elements that a kernel takes at once: a patch of one more costs as much as one of so many more.
const LANES: usize = 8;
/// The history by which a law is known that cracks.
const CRACKS: &str = "d_tension";

/// Work of each patch once its elements and nodes are due, by the level at which they are, as it is while all is sound and in cases of what has
/// cracked.
pub(super) struct Works {
    levels: usize,
    cases: Vec<Case>,
    /// Of all cases by their weights.
    mean: Vec<f64>,
}

/// Bodies that crack by themselves are cases of their own only if they have this share of all that cracks.
const LARGE: f64 = 0.05;
/// Parts of a body, each of which may crack while the others are sound; of all bodies together no more than [`PARTS_OF_ALL`].
const PARTS: usize = 4;
const PARTS_OF_ALL: usize = 12;

/// What may have cracked, and how much it counts beside others; all weights are 1 together.
struct Case {
    weight: f64,
    /// Work in a step at which levels up to one are due, by patch and level.
    up_to: Vec<f64>,
}

impl Works {
    /// The case in which nothing has cracked.
    pub const SOUND: usize = 0;

    /// `touched` are the patches of each node, of which the first has it.
    pub fn new(model: &Model, assembly: &Assembly, touched: &[Vec<u32>]) -> Self {
        let levels = usize::from(model.nodes.coarsest()) + 1;
        let mut sound = vec![0.0; levels * model.patches.len()];
        let mut more = vec![0.0; model.patches.len()];
        for (p, patch) in model.patches.iter().enumerate() {
            let update = update(model, assembly, p);
            sound[levels * p + usize::from(patch.level)] += update;
            let part = &assembly.members[assembly.of_patch[p] as usize].part;
            if part.columns().iter().any(|column| column.name == CRACKS) {
                more[p] = CRACKED * update;
            }
        }
        for member in &assembly.members {
            let each = match member.kind {
                Kind::Patch(_) | Kind::Weight => continue,
                Kind::Pairs(_) => PAIR,
                _ => BOUNDARY,
            };
            // Counted where the node is: a member goes to the rank that has most of its nodes.
            for &node in member.part.nodes() {
                if let Some(&first) = touched[node as usize].first() {
                    sound[levels * first as usize + usize::from(model.nodes.level[node as usize])] += each;
                }
            }
        }
        for (patches, &level) in touched.iter().zip(&model.nodes.level) {
            if let Some(&first) = patches.first() {
                sound[levels * first as usize + usize::from(level)] += MOVED;
            }
        }
        let case = |weight: f64, cracked: &mut dyn Iterator<Item = (u32, f64)>| {
            let mut up_to = sound.clone();
            for (p, share) in cracked {
                let p = p as usize;
                up_to[levels * p + usize::from(model.patches[p].level)] += share * more[p];
            }
            for own in up_to.chunks_exact_mut(levels) {
                (1..levels).for_each(|l| own[l] += own[l - 1]);
            }
            Case { weight, up_to }
        };
        let mut cases = vec![case(1.0, &mut std::iter::empty())];
        let bodies = connected(model, &more);
        if !bodies.is_empty() {
            cases.push(case(1.0, &mut (0..more.len() as u32).map(|p| (p, 1.0))));
        }
        // One lining may crack before the other, and walls before a roof.
        let parts = (PARTS_OF_ALL / bodies.len().max(1)).clamp(1, PARTS);
        let parts: Vec<_> = bodies.iter().flat_map(|body| body.chunks(body.len().div_ceil(parts))).collect();
        let bodies: Vec<_> = bodies.iter().map(Vec::as_slice).collect();
        for alone in [bodies, parts].iter().filter(|alone| alone.len() > 1) {
            let share = 1.0 / alone.len() as f64;
            cases.extend(alone.iter().map(|one| case(share, &mut one.iter().copied())));
        }
        let whole: f64 = cases.iter().map(|case| case.weight).sum();
        cases.iter_mut().for_each(|case| case.weight /= whole);
        let mean = |at: usize| cases.iter().map(|case| case.weight * case.up_to[at]).sum();
        Works { levels, mean: (0..sound.len()).map(mean).collect(), cases }
    }

    /// What may have cracked, by its weight.
    pub fn cases(&self) -> impl Iterator<Item = (usize, f64)> {
        self.cases.iter().map(|case| case.weight).enumerate()
    }

    pub fn levels(&self) -> usize {
        self.levels
    }

    /// Work of a patch in a step at which levels up to one are due.
    pub fn up_to(&self, patch: usize, level: u8, case: usize) -> f64 {
        self.cases[case].up_to[self.levels * patch + usize::from(level)]
    }

    /// The same in the mean over the cases.
    pub fn mean(&self, patch: usize, level: u8) -> f64 {
        self.mean[self.levels * patch + usize::from(level)]
    }

    /// The sum over the steps of the finest level in one of the coarsest of what is found for the levels that are due in it.
    pub fn by_beat(&self, one: impl Fn(u8) -> f64) -> f64 {
        (0..self.levels as u8).map(|level| self.often(level) * one(level)).sum()
    }

    /// Steps of the finest level in one of the coarsest in which levels up to one are due, and no coarser one.
    pub fn often(&self, level: u8) -> f64 {
        f64::from(1u32 << (self.levels as u8 - 1 - level).saturating_sub(1))
    }
}

/// Elements of patches that crack, `more` of whose work is above 0, as bodies that have no node in common: by body the patches, ascending, with
/// the share of their elements that is in it. Small ones are left out.
fn connected(model: &Model, more: &[f64]) -> Vec<Vec<(u32, f64)>> {
    let mut root: Vec<u32> = (0..model.nodes.level.len() as u32).collect();
    let find = |root: &[u32], mut n: u32| {
        while root[n as usize] != n {
            n = root[n as usize];
        }
        n
    };
    let nodes =
        |e: u32| model.mesh.elements[e as usize].nodes().iter().map(|&n| model.engine_node[n as usize]);
    let cracks = || (0..more.len()).filter(|&p| more[p] > 0.0);
    for e in cracks().flat_map(|p| model.patches[p].elements.iter().copied()) {
        let least = nodes(e).map(|n| find(&root, n)).min().unwrap_or_default();
        for n in nodes(e) {
            let old = find(&root, n);
            [old, n].into_iter().for_each(|n| root[n as usize] = least);
        }
    }
    let mut bodies = BTreeMap::<u32, BTreeMap<u32, f64>>::new();
    for p in cracks() {
        let each = 1.0 / model.patches[p].elements.len() as f64;
        for root in model.patches[p].elements.iter().filter_map(|&e| Some(find(&root, nodes(e).next()?))) {
            *bodies.entry(root).or_default().entry(p as u32).or_default() += each;
        }
    }
    let whole: f64 = more.iter().sum();
    let bodies = bodies.into_values().map(|body| body.into_iter().collect::<Vec<_>>());
    let work = |body: &[(u32, f64)]| body.iter().map(|&(p, share)| share * more[p as usize]).sum::<f64>();
    bodies.filter(|body| work(body) >= LARGE * whole).collect()
}

/// One update of a patch, where 1 is that of an elastic brick. What points and columns of their history cost was measured.
fn update(model: &Model, assembly: &Assembly, patch: usize) -> f64 {
    let part = &assembly.members[assembly.of_patch[patch] as usize].part;
    let patch = &model.patches[patch];
    let (elements, points) = part.elements();
    let of_point = match model.bodies[patch.body].quadrature {
        Quadrature::Layered(_) => 0.65,
        Quadrature::OnePoint | Quadrature::Full => 1.0,
    };
    let element = 0.9 + points as f64 * of_point * (0.06 + 0.022 * part.columns().len() as f64);
    let shape = if patch.bricks || points > 1 { 1.0 } else { 1.6 };
    elements.next_multiple_of(LANES) as f64 * element * shape
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Body, Problem, elastic};
    use tremolite_laws::Moduli;
    use tremolite_mesh::boxes::BoxSpec;

    /// Sixteen bricks in one patch cost as many updates, and what has eight points in each more.
    #[test]
    fn an_update_of_an_elastic_brick_is_one() {
        let of = |quadrature: Quadrature| {
            let mesh = BoxSpec::uniform([0.0; 3], [4.0, 2.0, 2.0], [4, 2, 2]).mesh().unwrap();
            let material = elastic(Moduli::from_young_poisson(1e9, 0.25));
            let elements = (0..16).collect();
            let body =
                Body { name: "rock".into(), elements, material, density: 2500.0, quadrature, viscosity: 0.0 };
            let model = Model::new(Problem::new(mesh, vec![body])).unwrap();
            let assembly = Assembly::new(&model).unwrap();
            assert_eq!(model.patches.len(), 1);
            update(&model, &assembly, 0) / 16.0
        };
        let [one, full] = [Quadrature::OnePoint, Quadrature::Full].map(of);
        assert!((0.9..1.1).contains(&one) && full > 1.2 * one, "{one} {full}");
    }
}
