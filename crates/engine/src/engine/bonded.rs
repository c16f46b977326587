//! The initial equilibrium of ground with interfaces that begin under load: found as if they were not there, so that it is the same
//! whatever their stiffness; then their pairs are given what passes between their sides, which the forces of both say exactly.

use super::Engine;
use super::evaluation::Forces;
use super::gather::{dot, force};
use super::relax::{Relaxed, Release, Rest, Watch};
use crate::contacts::LoadedPair;
use crate::phase::Phase;
use crate::state::{Relaxing, State};
use std::collections::BTreeMap;
use std::ops::Range;
use tremolite_laws::Row;
use tremolite_mesh::pairs::tangents;

/// How much further from balance a model may be once pairs are freed that hold: what is left at a node is then shared by two.
const SHARED: f64 = 2.0;
impl Engine {
    /// Brings a state to the initial equilibrium, and on from there if pairs cannot bear what passes.
    pub(super) fn bonded_then_free(
        &mut self,
        state: &mut State,
        release: &Release,
        watch: &mut Watch,
    ) -> Relaxed {
        // It has all the faces that this engine's own phase has, so it can be made.
        let Ok(phase) = Phase::bonded(&self.model, &self.assembly) else {
            return self.come_to_rest(state, release, watch);
        };
        let mut bonded = Engine::among(&self.model, &self.assembly, &phase, self.ranks.as_ref());
        bonded.poisoned = self.poisoned;
        let bonded = bonded.come_to_rest(state, release, watch);
        let Relaxed::AtRest(rest) = bonded else { return bonded };
        self.whole(state);
        state.relaxing = Relaxing { freed: 1, ..Relaxing::default() };
        self.free_loaded(state);
        self.own(state);
        self.evaluate_at(state, None);
        if self.out_of_balance() <= SHARED * release.tolerance[0] {
            return bonded;
        }
        match self.come_to_rest(state, release, watch) {
            Relaxed::AtRest(more) => Relaxed::AtRest(Rest { cycles: rest.cycles + more.cycles, ..more }),
            other => other,
        }
    }

    /// Σ|R| over Σ|contributions| of the forces last evaluated, with nothing held.
    fn out_of_balance(&self) -> f64 {
        let Engine { phase, forces: Forces { contributions, .. }, .. } = self;
        let one = |nodes: Range<usize>| {
            let mut sums = [0.0; 2];
            for node in nodes {
                let force = force(phase, contributions, node);
                let free = phase.inverse_mass[node].0.map(|w| f64::from(u8::from(w > 0.0)));
                sums[0] += length(Row([0, 1, 2, 3].map(|i| free[i] * force.0[i])));
                let slots = phase.start[node] as usize..phase.start[node + 1] as usize;
                let all = phase.slot[slots].iter().map(|&slot| length(contributions[slot as usize]));
                sums[1] += all.sum::<f64>();
            }
            sums
        };
        let [unbalanced, whole] = self.over_nodes(2, one, |a, b| [a[0] + b[0], a[1] + b[1]]);
        if whole > 0.0 { unbalanced / whole } else { 0.0 }
    }

    /// Gives pairs that begin under load what passes between their sides in a state that came to rest as if they were one
    /// ([`crate::Phase::bonded`]): their traction so far and, where that leaves the sides out of balance with each other, the least
    /// that is missing, by area.
    fn free_loaded(&mut self, state: &mut State) {
        self.evaluate_at(state, None);
        let Engine { model, assembly, phase, forces, .. } = &*self;
        let mut links: Vec<Link> = Vec::new();
        for (s, (seam, contacts)) in model.seams.iter().zip(&assembly.contacts).enumerate() {
            for loaded in &contacts.loaded {
                let pair = &seam.pairs[loaded.pair as usize];
                let nodes = pair.nodes.map(|n| phase.master[model.engine_node[n as usize] as usize]);
                links.push(Link { seam: s, loaded: *loaded, nodes, area: pair.normal_area, more: [0.0; 3] });
            }
        }
        let mut nodes: Vec<u32> = links.iter().flat_map(|link| link.nodes).collect();
        nodes.sort_unstable();
        nodes.dedup();
        let out = self.at_nodes(&nodes, 4, |k| force(phase, &forces.contributions, nodes[k] as usize));
        for i in 0..3 {
            let free = |n: u32| phase.inverse_mass[n as usize].0[i] > 0.0;
            let out = |n: u32| nodes.binary_search(&n).map_or(0.0, |k| out[k].0[i]);
            let open: Vec<usize> =
                (0..links.len()).filter(|&k| links[k].nodes.iter().all(|&n| free(n))).collect();
            let edges: Vec<([u32; 2], f64)> = open.iter().map(|&k| (links[k].nodes, links[k].area)).collect();
            for (&k, more) in open.iter().zip(passed_on(&edges, out)) {
                links[k].more[i] = more;
            }
        }
        for Link { seam, loaded, area, more, .. } in links {
            let pair = &model.seams[seam].pairs[loaded.pair as usize];
            let [e1, e2] = tangents(pair.normal);
            let axes = [pair.normal, e1, e2];
            let along = |axis: [f64; 3]| (0..3).map(|i| axis[i] * more[i]).sum::<f64>() / area;
            let traction = [0, 1, 2].map(|k| loaded.traction[k] + along(axes[k]));
            let [a, b] = pair.nodes.map(|n| state.u[model.engine_node[n as usize] as usize]);
            let d = [0, 1, 2].map(|i| b.0[i] - a.0[i]);
            assembly.contacts[seam].load(&mut state.history, &LoadedPair { traction, ..loaded }, d);
        }
    }
}

fn length(row: Row) -> f64 {
    dot(row, row).sqrt()
}

/// A pair between two nodes.
struct Link {
    seam: usize,
    loaded: LoadedPair,
    nodes: [u32; 2],
    /// m²
    area: f64,
    /// Force on the second node beyond that of its traction \[N\].
    more: [f64; 3],
}

/// What each pair of nodes must pass on to the second, so that all nodes that hang together by pairs are as far out of balance as
/// their mean: of all that do, the one with the least Σ force²/area. `out` is what resists at a node.
fn passed_on(edges: &[([u32; 2], f64)], out: impl Fn(u32) -> f64) -> Vec<f64> {
    let mut neighbours: BTreeMap<u32, Vec<(u32, f64)>> = BTreeMap::new();
    for &([a, b], area) in edges {
        neighbours.entry(a).or_default().push((b, area));
        neighbours.entry(b).or_default().push((a, area));
    }
    // A potential at each node, whose differences times the areas are the forces.
    let mut potential: BTreeMap<u32, f64> = BTreeMap::new();
    for &start in neighbours.keys() {
        if potential.contains_key(&start) {
            continue;
        }
        let mut own = vec![start];
        let mut next = 0;
        while let Some(&node) = own.get(next) {
            let found: Vec<u32> =
                neighbours[&node].iter().map(|(n, _)| *n).filter(|n| !own.contains(n)).collect();
            for n in found {
                if !own.contains(&n) {
                    own.push(n);
                }
            }
            next += 1;
        }
        let right: Vec<f64> = own.iter().map(|&n| out(n)).collect();
        let mean = right.iter().sum::<f64>() / own.len() as f64;
        let place = |n: u32| own.iter().position(|o| *o == n).unwrap_or(0);
        // The first is zero, which leaves a matrix that is positive definite.
        let rows: Vec<Vec<f64>> = own[1..]
            .iter()
            .zip(&right[1..])
            .map(|(node, right)| {
                let mut row = vec![0.0; own.len() + 1];
                for &(other, area) in &neighbours[node] {
                    row[place(*node)] += area;
                    row[place(other)] -= area;
                }
                row[own.len()] = right - mean;
                row[1..].to_vec()
            })
            .collect();
        let solved = eliminated(rows);
        potential.insert(start, 0.0);
        potential.extend(own[1..].iter().copied().zip(solved));
    }
    edges.iter().map(|&([a, b], area)| area * (potential[&b] - potential[&a])).collect()
}

/// The solution of equations with a positive definite matrix, whose right side is each row's last number.
fn eliminated(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    let count = rows.len();
    for k in 0..count {
        let (above, below) = rows.split_at_mut(k + 1);
        for row in below {
            let factor = row[k] / above[k][k];
            for (x, y) in row.iter_mut().zip(&above[k]).skip(k) {
                *x -= factor * y;
            }
        }
    }
    let mut solved = vec![0.0; count];
    for k in (0..count).rev() {
        let known: f64 = (k + 1..count).map(|j| rows[k][j] * solved[j]).sum();
        solved[k] = (rows[k][count] - known) / rows[k][k];
    }
    solved
}

#[cfg(test)]
mod tests {
    use super::passed_on;
    use crate::{Assembly, Body, Engine, Model, Phase, Problem, Quadrature, Stage, elastic};
    use std::sync::Arc;
    use tremolite_laws::Moduli;
    use tremolite_mesh::boxes::BoxSpec;

    /// It has no unit, and its sums are over all blocks of nodes: displacements of whatever size leave it as it is.
    #[test]
    fn how_far_a_model_is_out_of_balance_does_not_go_by_the_size_of_its_forces() {
        let mesh = BoxSpec::uniform([0.0; 3], [32.0, 16.0, 8.0], [32, 16, 8]).mesh().unwrap();
        let material = elastic(Moduli::from_young_poisson(1e9, 0.25));
        let elements = (0..4096).collect();
        let quadrature = Quadrature::Full;
        let body =
            Body { name: "rock".into(), elements, material, density: 2500.0, quadrature, viscosity: 0.0 };
        let model = Arc::new(Model::new(Problem::new(mesh, vec![body])).unwrap());
        let assembly = Arc::new(Assembly::new(&model).unwrap());
        let phase = Arc::new(Phase::of(&model, &assembly, Stage::Shaking).unwrap());
        assert!(model.nodes.blocks.len() > 2);
        let found = |size: f64| {
            let mut engine = Engine::new(&model, &assembly, &phase);
            let mut state = assembly.rest();
            for (n, u) in (0_u32..).zip(&mut state.u) {
                *u = super::super::power::noise(n, &phase.inverse_mass[n as usize]);
                (0..3).for_each(|i| u.0[i] *= size);
            }
            state.du.copy_from_slice(&state.u);
            engine.evaluate_at(&mut state, None);
            engine.out_of_balance()
        };
        let [small, large] = [found(1e-6), found(2e-6)];
        assert!((0.1..1.0).contains(&small) && (large / small - 1.0).abs() < 1e-12, "{small} {large}");
    }

    /// Four nodes in a ring, as where two faults cross, and two by themselves with two pairs.
    #[test]
    fn nodes_that_hang_together_by_pairs_are_left_as_far_out_of_balance_as_their_mean() {
        let edges =
            [([1, 2], 1.0), ([2, 3], 2.0), ([3, 4], 0.5), ([4, 1], 1.5), ([7, 9], 3.0), ([7, 9], 1.0)];
        let out = |n: u32| [0.0, 5.0, -3.0, 8.0, 1.0, 0.0, 0.0, 4.0, 0.0, -2.0][n as usize];
        let passed = passed_on(&edges, out);
        let mut left: Vec<f64> = (0..10).map(out).collect();
        for (([a, b], _), force) in edges.iter().zip(&passed) {
            left[*a as usize] += force;
            left[*b as usize] -= force;
        }
        for (node, mean) in [(1, 2.75), (2, 2.75), (3, 2.75), (4, 2.75), (7, 1.0), (9, 1.0)] {
            assert!((left[node] - mean).abs() < 1e-12, "{left:?}");
        }
        assert!((passed[4] - 3.0 * passed[5]).abs() < 1e-12, "shared by area");
        // No flow goes round: Σ force/area is zero around the ring.
        let round: f64 = edges[..4].iter().zip(&passed).map(|((_, area), force)| force / area).sum();
        assert!(round.abs() < 1e-12, "{round}");
    }
}
