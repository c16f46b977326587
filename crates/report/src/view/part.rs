//! A part of the view as the files give it: a body or an interface, over all times.

use tremolite_results::FieldFile;

use super::columns::Columns;
use super::mesh::{Mesh, Taken};

/// A body or an interface.
pub struct Part {
    /// Its number in the files.
    pub owner: i64,
    pub mesh: Mesh,
    /// Groups by name, with the cells inside; shorter than the part where cells came later.
    pub groups: Vec<(String, Vec<bool>)>,
    pub columns: Columns,
    /// By time, by point: displacement less the mean of the model (m).
    pub displacement: Vec<Option<Vec<[f32; 3]>>>,
    /// Names of the arrays of all files that are no scalars.
    pub vectors: Vec<String>,
}

impl Part {
    fn new(owner: i64, per: usize) -> Self {
        Part {
            owner,
            mesh: Mesh::new(per),
            groups: Vec::new(),
            columns: Columns::default(),
            displacement: Vec::new(),
            vectors: Vec::new(),
        }
    }

    /// The cells of a group.
    pub fn size(inside: &[bool]) -> usize {
        inside.iter().filter(|inside| **inside).count()
    }

    fn take(&mut self, time: usize, file: &FieldFile, mean: [f64; 3]) {
        let own = file.cells.iter().enumerate().filter(|(_, cell)| cell.owner == self.owner);
        let taken = self.mesh.take(&file.points, &own.collect::<Vec<_>>());
        self.take_groups(file, &taken);
        for scalar in &file.scalars {
            let (count, pairs) = if scalar.at_cells {
                (self.mesh.elements.len(), &taken.cells)
            } else {
                (self.mesh.points.len(), &taken.points)
            };
            let mut values = vec![f32::NAN; count];
            pairs.iter().for_each(|&(from, to)| values[to] = scalar.values[from]);
            self.columns.add(time, &scalar.name, &scalar.unit, scalar.at_cells, values);
        }
        self.displacement.resize(time, None);
        self.displacement.push(file.displacement.as_ref().map(|displacement| {
            let mut values = vec![[0.0; 3]; self.mesh.points.len()];
            for &(from, to) in &taken.points {
                values[to] = [0, 1, 2].map(|i| (f64::from(displacement[from][i]) - mean[i]) as f32);
            }
            values
        }));
        for name in &file.vectors {
            if !self.vectors.contains(name) {
                self.vectors.push(name.clone());
            }
        }
    }

    fn take_groups(&mut self, file: &FieldFile, taken: &Taken) {
        for (name, inside) in &file.groups {
            if !taken.cells.iter().any(|&(from, _)| inside[from]) {
                continue;
            }
            let known = self.groups.iter().position(|(known, _)| known == name).unwrap_or_else(|| {
                self.groups.push((name.clone(), Vec::new()));
                self.groups.len() - 1
            });
            let own = &mut self.groups[known].1;
            own.resize(self.mesh.elements.len(), false);
            taken.cells.iter().for_each(|&(from, to)| own[to] |= inside[from]);
        }
    }
}

/// Takes in the file of time number `time`: its cells go to the parts of their owners, by these numbers. Cells have `per`
/// corners, and displacement is counted from `mean`.
pub fn take(parts: &mut Vec<Part>, time: usize, file: &FieldFile, per: usize, mean: [f64; 3]) {
    let mut owners: Vec<i64> = file.cells.iter().map(|cell| cell.owner).collect();
    owners.sort_unstable();
    owners.dedup();
    for owner in owners {
        if !parts.iter().any(|part| part.owner == owner) {
            parts.push(Part::new(owner, per));
        }
    }
    parts.sort_by_key(|part| part.owner);
    parts.iter_mut().for_each(|part| part.take(time, file, mean));
}
