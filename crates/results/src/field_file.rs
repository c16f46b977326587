//! A file of `fields/`, `stages/` or `interfaces/` as plain data: cells with their elements, groups, numbers.

use std::path::Path;

use tremolite_mesh::vtu::{Array, Grid, VtuError};

use crate::hexahedron;

/// A cell: a solid as a hexahedron (see [`hexahedron`]), or a face of an interface, of which four corners count; a
/// triangle repeats its last.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FieldCell {
    pub corners: [u32; 8],
    /// The element's number; of a face that on its first side, and then that across, else 0.
    pub element: i64,
    pub other: i64,
    /// Number of the body, or of the interface.
    pub owner: i64,
}

/// An array with one number a cell or point.
#[derive(Clone, Debug, PartialEq)]
pub struct Scalar {
    pub name: String,
    pub unit: String,
    pub at_cells: bool,
    /// By index of the cell or point.
    pub values: Vec<f32>,
}

/// What a file holds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FieldFile {
    /// Places without deformation (m).
    pub points: Vec<[f64; 3]>,
    pub cells: Vec<FieldCell>,
    /// Groups of elements, or interfaces, by name, with the cells inside.
    pub groups: Vec<(String, Vec<bool>)>,
    /// All arrays of one component but those above.
    pub scalars: Vec<Scalar>,
    /// By point (m).
    pub displacement: Option<Vec<[f32; 3]>>,
    /// By cell, specific discharge of seepage (m/s).
    pub discharge: Option<Vec<[f32; 3]>>,
    /// Names of all arrays that are no scalars and not those above.
    pub vectors: Vec<String>,
}

impl FieldFile {
    /// Reads the solids of a file in `fields/` or `stages/`.
    ///
    /// # Errors
    /// If the file cannot be read, see [`Grid::read`], or does not number its elements.
    pub fn solids(path: &Path) -> Result<Self, VtuError> {
        Self::read(path, "body", "group:", hexahedron::corners)
    }

    /// Reads the faces of a file in `interfaces/`.
    ///
    /// # Errors
    /// As of [`FieldFile::solids`].
    pub fn faces(path: &Path) -> Result<Self, VtuError> {
        let corners = |kind: u8, points: &[u32]| match (kind, points) {
            (9, &[a, b, c, d]) => Some([a, b, c, d, d, d, d, d]),
            (5, &[a, b, c]) => Some([a, b, c, c, c, c, c, c]),
            _ => None,
        };
        Self::read(path, "interface", "interface:", corners)
    }

    fn read(
        path: &Path,
        owner: &str,
        group: &str,
        corners: impl Fn(u8, &[u32]) -> Option<[u32; 8]>,
    ) -> Result<Self, VtuError> {
        let grid = Grid::read(path)?;
        let Some(elements) = grid.cell_array("element") else {
            let reason = "no array element at its cells".into();
            return Err(VtuError::Format { path: path.to_owned(), reason });
        };
        let number = |name: &str, cell: usize| {
            grid.cell_array(name).map_or(0, |array| array.values.get(cell * array.components) as i64)
        };
        let mut file = FieldFile { points: grid.points.clone(), ..FieldFile::default() };
        // Index in the file of each cell that is taken.
        let mut taken: Vec<usize> = Vec::new();
        for cell in 0..grid.types.len() {
            let Some(corners) = corners(grid.types[cell], grid.cell(cell)) else { continue };
            taken.push(cell);
            file.cells.push(FieldCell {
                corners,
                element: elements.values.get(cell * elements.components) as i64,
                other: number("other_element", cell),
                owner: number(owner, cell),
            });
        }
        for array in &grid.cell_data {
            if let Some(name) = array.name.strip_prefix(group) {
                let inside = taken.iter().map(|&cell| array.values.get(cell * array.components) != 0.0);
                file.groups.push((name.to_owned(), inside.collect()));
            } else if array.name == "seepage" && array.components == 3 {
                let at = |&cell: &usize| [0, 1, 2].map(|i| array.values.get(3 * cell + i) as f32);
                file.discharge = Some(taken.iter().map(at).collect());
            } else if !["element", "other_element", owner].contains(&array.name.as_str()) {
                file.add(array, true, taken.iter().copied());
            }
        }
        for array in &grid.point_data {
            if array.name == "displacement" && array.components == 3 {
                let at = |point: usize| [0, 1, 2].map(|i| array.values.get(3 * point + i) as f32);
                file.displacement = Some((0..grid.points.len()).map(at).collect());
            } else {
                file.add(array, false, 0..grid.points.len());
            }
        }
        Ok(file)
    }

    fn add(&mut self, array: &Array, at_cells: bool, tuples: impl Iterator<Item = usize>) {
        if array.components == 1 {
            let values = tuples.map(|k| array.values.get(k) as f32).collect();
            self.scalars.push(Scalar {
                name: array.name.clone(),
                unit: array.unit.clone(),
                at_cells,
                values,
            });
        } else {
            self.vectors.push(array.name.clone());
        }
    }
}
