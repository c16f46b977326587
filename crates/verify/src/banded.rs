//! Stiffness of meshes whose numbers of nodes run along a strip: banded, symmetric, solved directly.

use crate::VerifyError;
use crate::dense::dot;
use crate::simulation::Simulation;
use std::collections::BTreeSet;
use tremolite::parts::Scratch;
use tremolite_laws::Row;

/// The lower half of a symmetric matrix, row by row, from the left end of the band to the diagonal.
#[derive(Clone, Debug, PartialEq)]
pub struct Banded {
    n: usize,
    /// Entries of a row.
    width: usize,
    values: Vec<f64>,
}

impl Banded {
    /// A zero matrix of `n` rows, whose entries are at most `reach` off the diagonal.
    pub fn zero(n: usize, reach: usize) -> Self {
        let width = reach + 1;
        Banded { n, width, values: vec![0.0; n * width] }
    }

    /// Adds to the entry at a row and a column of the lower half.
    fn add(&mut self, row: usize, column: usize, value: f64) {
        self.values[row * self.width + self.width - 1 - (row - column)] += value;
    }

    /// The solution of A x = b for a positive definite A by Cholesky's factors in the band (Golub & Van Loan 2013, algorithm 4.3.5).
    ///
    /// # Errors
    /// If the matrix is not positive definite to twelve digits.
    pub fn solve(mut self, b: &[f64]) -> Result<Vec<f64>, VerifyError> {
        let (n, width) = (self.n, self.width);
        let first = |row: usize| (row + 1).saturating_sub(width);
        let at = |row: usize, column: usize| row * width + width - 1 + column - row;
        for row in 0..n {
            for column in first(row)..row {
                let from = first(row).max(first(column));
                let sum = dot(
                    &self.values[at(row, from)..at(row, column)],
                    &self.values[at(column, from)..at(column, column)],
                );
                self.values[at(row, column)] =
                    (self.values[at(row, column)] - sum) / self.values[at(column, column)];
            }
            let before = self.values[at(row, row)];
            let left = &self.values[at(row, first(row))..at(row, row)];
            let pivot = before - dot(left, left);
            if pivot.is_nan() || pivot <= 1e-12 * before {
                return Err(VerifyError::Singular(row));
            }
            self.values[at(row, row)] = pivot.sqrt();
        }
        let mut x = b.to_vec();
        for row in 0..n {
            let sum = dot(&self.values[at(row, first(row))..at(row, row)], &x[first(row)..row]);
            x[row] = (x[row] - sum) / self.values[at(row, row)];
        }
        for row in (0..n).rev() {
            x[row] /= self.values[at(row, row)];
            for column in first(row)..row {
                x[column] -= self.values[at(row, column)] * x[row];
            }
        }
        Ok(x)
    }
}

/// Nodes that share an element with each node of the mesh, itself among them.
fn neighbours(simulation: &Simulation) -> Vec<BTreeSet<usize>> {
    let mesh = &simulation.model.mesh;
    let mut all = vec![BTreeSet::new(); mesh.nodes.len()];
    for element in &mesh.elements {
        for &a in element.nodes() {
            all[a as usize].extend(element.nodes().iter().map(|&b| b as usize));
        }
    }
    all
}

/// A colour for each node: nodes of one colour have no neighbour in common.
fn colours(near: &[BTreeSet<usize>]) -> Vec<usize> {
    let mut colours: Vec<Option<usize>> = vec![None; near.len()];
    for node in 0..near.len() {
        let taken: BTreeSet<usize> =
            near[node].iter().flat_map(|&m| &near[m]).filter_map(|&k| colours[k]).collect();
        colours[node] = (0..).find(|colour| !taken.contains(colour));
    }
    colours.into_iter().flatten().collect()
}

/// Displacements \[m\] by node of the mesh under forces \[N\] on its nodes. The stiffness is that of the elements which the engine runs with:
/// columns of nodes without common neighbours come from one product.
///
/// # Errors
/// If the model is not held against rigid motion.
pub fn solve(simulation: &Simulation, forces: &[(u32, [f64; 3])]) -> Result<Vec<[f64; 3]>, VerifyError> {
    let Simulation { model, assembly, phase, .. } = simulation;
    let nodes = model.mesh.nodes.len();
    let engine = |node: usize| model.engine_node[node] as usize;
    let mut place = vec![[None; 3]; nodes];
    let mut n = 0;
    for (node, place) in place.iter_mut().enumerate() {
        for (i, place) in place.iter_mut().enumerate() {
            if phase.inverse_mass[engine(node)].0[i] > 0.0 {
                *place = Some(n);
                n += 1;
            }
        }
    }
    let near = neighbours(simulation);
    let colours = colours(&near);
    let reach = near.iter().enumerate().map(|(a, near)| near.iter().map(|&b| a.abs_diff(b)).max());
    let reach = 3 * reach.flatten().max().unwrap_or(0) + 2;
    let mut matrix = Banded::zero(n, reach.min(n.saturating_sub(1)));
    let mut scratch = Scratch::default();
    for colour in 0..colours.iter().max().map_or(0, |most| most + 1) {
        let columns: Vec<usize> = (0..nodes).filter(|&node| colours[node] == colour).collect();
        for i in 0..3 {
            let mut w = vec![Row::ZERO; phase.mass.len()];
            columns.iter().filter(|&&node| place[node][i].is_some()).for_each(|&node| {
                w[engine(node)].0[i] = 1.0;
            });
            let mut sum = vec![[0.0; 3]; phase.mass.len()];
            for &member in &phase.active {
                let part = &assembly.members[member as usize].part;
                let mut out = vec![Row::ZERO; part.nodes().len()];
                part.stiffness_times(&w, &mut out, &mut scratch);
                for (&to, force) in part.nodes().iter().zip(&out) {
                    sum[to as usize].iter_mut().zip(force.xyz()).for_each(|(sum, f)| *sum += f);
                }
            }
            for &node in &columns {
                let Some(column) = place[node][i] else { continue };
                for &other in &near[node] {
                    for (j, force) in sum[engine(other)].into_iter().enumerate() {
                        if let Some(row) = place[other][j].filter(|row| *row >= column) {
                            matrix.add(row, column, force);
                        }
                    }
                }
            }
        }
    }
    let mut b = vec![0.0; n];
    for (node, force) in forces {
        for (place, force) in place[*node as usize].iter().zip(force) {
            if let Some(place) = place {
                b[*place] += force;
            }
        }
    }
    let x = matrix.solve(&b)?;
    Ok(place.iter().map(|place| place.map(|place| place.map_or(0.0, |k| x[k]))).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::{LAYERED, Solid, distorted, nodes_at_level};
    use crate::stiffness::Assembled;

    #[test]
    fn a_chain_of_springs_pulled_at_its_end_is_as_long_as_it_must_be_and_a_free_one_is_refused() {
        let chain = |held: f64| {
            let mut a = Banded::zero(20, 1);
            for i in 0..20 {
                a.add(
                    i,
                    i,
                    if i == 0 {
                        1.0 + held
                    } else if i == 19 {
                        1.0
                    } else {
                        2.0
                    },
                );
                if i > 0 {
                    a.add(i, i - 1, -1.0);
                }
            }
            a
        };
        let mut pull = [0.0; 20];
        pull[19] = 1.0;
        for (i, x) in chain(1.0).solve(&pull).unwrap().into_iter().enumerate() {
            assert!((x - (i + 1) as f64).abs() < 1e-12, "{i}: {x}");
        }
        assert!(matches!(chain(0.0).solve(&pull), Err(VerifyError::Singular(19))));
    }

    #[test]
    fn a_distorted_block_is_moved_as_by_the_dense_matrix() {
        let mesh = distorted([3.0, 2.0, 1.0], [3, 2, 2], 0.2).unwrap();
        let [held, pulled] = [0.0, 3.0].map(|x| nodes_at_level(&mesh, 0, x));
        let solid = Solid { young: 1.0, poisson: 0.3, density: 1.0 };
        let mut problem = solid.fill(mesh, LAYERED.0);
        problem.held = held.into_iter().map(|n| (n, [true; 3])).collect();
        let simulation = Simulation::on_one_level(problem).unwrap();
        let forces: Vec<(u32, [f64; 3])> = pulled.into_iter().map(|n| (n, [0.1, 0.2, 0.3])).collect();
        let dense = Assembled::new(&simulation).solve(&simulation, &forces).unwrap();
        for (node, u) in solve(&simulation, &forces).unwrap().into_iter().enumerate() {
            let other = dense[simulation.model.engine_node[node] as usize];
            assert!(u.iter().zip(other).all(|(a, b)| (a - b).abs() < 1e-10), "{node}: {u:?} and {other:?}");
        }
    }
}
