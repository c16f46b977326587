//! The engine's stiffness, mass and dashpots as small dense matrices.
//!
//! K is found column by column from the parts' own products, so that it is the stiffness the engine runs with and no
//! second implementation.

use crate::VerifyError;
use crate::dense::Dense;
use crate::simulation::Simulation;
use tremolite::parts::Scratch;
use tremolite_laws::Row;

/// M, K and the dashpots on the free components of the master nodes.
pub struct Assembled {
    /// Engine node and component of each unknown.
    pub unknowns: Vec<(usize, usize)>,
    /// Lumped mass \[kg\].
    pub mass: Vec<f64>,
    pub stiffness: Dense,
    /// Matrix of the dashpots of base and sides \[N s/m\], without Rayleigh damping.
    pub dashpots: Dense,
}

impl Assembled {
    /// Assembles a simulation's matrices.
    pub fn new(simulation: &Simulation) -> Self {
        let phase = &simulation.phase;
        let nodes = phase.mass.len();
        let master = &phase.master;
        let unknowns: Vec<(usize, usize)> = (0..nodes)
            .filter(|&n| master[n] as usize == n)
            .flat_map(|n| (0..3).map(move |i| (n, i)))
            .filter(|&(n, i)| phase.inverse_mass[n].0[i] > 0.0)
            .collect();
        let n = unknowns.len();
        let mut place = vec![[None; 3]; nodes];
        for (k, &(node, i)) in unknowns.iter().enumerate() {
            place[node][i] = Some(k);
        }

        let mut stiffness = Dense::zero(n);
        let mut scratch = Scratch::default();
        let mut w = vec![Row::ZERO; nodes];
        for (column, &(node, i)) in unknowns.iter().enumerate() {
            for (row, m) in w.iter_mut().zip(master) {
                *row = Row::ZERO;
                if *m as usize == node {
                    row.0[i] = 1.0;
                }
            }
            for &member in &phase.active {
                let part = &simulation.assembly.members[member as usize].part;
                let mut out = vec![Row::ZERO; part.nodes().len()];
                part.stiffness_times(&w, &mut out, &mut scratch);
                for (&to, force) in part.nodes().iter().zip(&out) {
                    for (j, f) in force.xyz().into_iter().enumerate() {
                        if let Some(k) = place[master[to as usize] as usize][j] {
                            stiffness.values[k * n + column] += f;
                        }
                    }
                }
            }
        }

        let mut dashpots = Dense::zero(n);
        for (node, dashpot) in &phase.dashpots {
            let m = [0, 1, 2, 3, 4, 5].map(|c| dashpot.base[c] + dashpot.sides[c]);
            let full = [[m[0], m[3], m[5]], [m[3], m[1], m[4]], [m[5], m[4], m[2]]];
            for i in 0..3 {
                for j in 0..3 {
                    if let (Some(k), Some(l)) = (place[*node as usize][i], place[*node as usize][j]) {
                        dashpots.set(k, l, full[i][j]);
                    }
                }
            }
        }
        let mass = unknowns.iter().map(|&(node, _)| phase.mass[node]).collect();
        Assembled { unknowns, mass, stiffness, dashpots }
    }

    /// Static displacement \[m\] by engine node under forces \[N\] on nodes of the mesh.
    ///
    /// # Errors
    /// If the model is not held against rigid motion.
    pub fn solve(
        &self,
        simulation: &Simulation,
        forces: &[(u32, [f64; 3])],
    ) -> Result<Vec<[f64; 3]>, VerifyError> {
        let model = &simulation.model;
        let mut by_node = vec![[0.0; 3]; model.mesh_node.len()];
        for (node, force) in forces {
            let to =
                &mut by_node[simulation.phase.master[model.engine_node[*node as usize] as usize] as usize];
            (0..3).for_each(|i| to[i] += force[i]);
        }
        let b: Vec<f64> = self.unknowns.iter().map(|&(n, i)| by_node[n][i]).collect();
        Ok(self.spread(simulation, &self.stiffness.solve(&b)?))
    }

    /// Unknowns as vectors by engine node; tied nodes take their master's, held components are zero.
    pub fn spread(&self, simulation: &Simulation, x: &[f64]) -> Vec<[f64; 3]> {
        let mut out = vec![[0.0; 3]; simulation.phase.mass.len()];
        for (&(node, i), value) in self.unknowns.iter().zip(x) {
            out[node][i] = *value;
        }
        for &(node, master) in &simulation.phase.tied {
            out[node as usize] = out[master as usize];
        }
        out
    }

    /// The unknowns out of rows by engine node.
    pub fn gather(&self, rows: &[Row]) -> Vec<f64> {
        self.unknowns.iter().map(|&(n, i)| rows[n].0[i]).collect()
    }

    /// Squared frequencies λ \[1/s²\], ascending, and mode shapes as rows, normalised to φᵀMφ = 1.
    pub fn modes(&self) -> (Vec<f64>, Dense) {
        let n = self.mass.len();
        let root: Vec<f64> = self.mass.iter().map(|m| m.sqrt()).collect();
        let mut a = Dense::zero(n);
        for i in 0..n {
            for j in 0..n {
                // The mean of both halves: products are symmetric to round-off only.
                let k = 0.5 * (self.stiffness.at(i, j) + self.stiffness.at(j, i));
                a.set(i, j, k / (root[i] * root[j]));
            }
        }
        let (values, mut shapes) = a.eigen();
        for row in shapes.values.chunks_exact_mut(n) {
            row.iter_mut().zip(&root).for_each(|(x, r)| *x /= r);
        }
        (values, shapes)
    }
}
