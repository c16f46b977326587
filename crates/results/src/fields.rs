//! A field file, read once for all that is to be seen of it.

use std::path::Path;

use tremolite_mesh::vtu::{Grid, VtuError};

use crate::arrays::{groups, scalar};
use crate::cut::Cut;
use crate::skin::Skin;
use crate::slice::Slice;
use crate::surface::ElementGroups;

/// A file of `fields/` or `stages/`.
#[derive(Clone, Debug)]
pub struct Fields {
    grid: Grid,
}

impl Fields {
    /// Reads the whole file.
    ///
    /// # Errors
    /// If the file cannot be read, see [`Grid::read`].
    pub fn read(path: &Path) -> Result<Self, VtuError> {
        Ok(Fields { grid: Grid::read(path)? })
    }

    /// A grid in memory, which must pass [`Grid::check`].
    pub fn of(grid: Grid) -> Self {
        Fields { grid }
    }

    /// The plane at `y` (m), or through the middle of the model.
    pub fn slice(&self, y: Option<f64>) -> Slice {
        Slice::of(&self.grid, y)
    }

    /// A field on such a plane, as [`Cut::read`].
    pub fn cut(&self, slice: &Slice, names: &[&str]) -> Option<Cut> {
        Cut::on(&self.grid, slice, names)
    }

    /// As [`Slice::smooth`].
    pub fn smooth(&self, slice: &Slice, name: &str) -> Option<Vec<Vec<f64>>> {
        slice.smooth(&self.grid, name)
    }

    /// As [`Slice::vectors`].
    pub fn vectors(&self, slice: &Slice, name: &str) -> Option<Vec<Vec<[f64; 3]>>> {
        slice.vectors(&self.grid, name)
    }

    /// A field's value in each element, by index of its cell: the length of a vector. Nothing where no element has it.
    pub fn values(&self, name: &str) -> Option<Vec<f64>> {
        let array = self.grid.cell_array(name)?;
        Some((0..self.grid.types.len()).map(|cell| scalar(array, cell)).collect())
    }

    /// A vector of the elements, by index of their cells. Nothing where the file has no such field of three components.
    pub fn of_elements(&self, name: &str) -> Option<Vec<[f64; 3]>> {
        let array = self.grid.cell_array(name).filter(|array| array.components == 3)?;
        Some(
            (0..self.grid.types.len())
                .map(|cell| [0, 1, 2].map(|i| array.values.get(3 * cell + i)))
                .collect(),
        )
    }

    /// Number of each element as the run knows it, by index of its cell.
    pub fn numbers(&self) -> Option<Vec<i64>> {
        let array = self.grid.cell_array("element").filter(|array| array.components == 1)?;
        Some((0..self.grid.types.len()).map(|cell| array.values.get(cell) as i64).collect())
    }

    /// Number of each element's group, by index of its cell; 0 where the file has none.
    pub fn group_numbers(&self) -> Vec<i64> {
        let array = groups(&self.grid);
        (0..self.grid.types.len()).map(|cell| array.map_or(0, |a| a.values.get(cell) as i64)).collect()
    }

    /// Whether each element is in any of these groups, by index of its cell.
    pub fn members<'a>(&self, names: impl Iterator<Item = &'a str>) -> Vec<bool> {
        let arrays: Vec<_> =
            names.filter_map(|name| self.grid.cell_array(&format!("group:{name}"))).collect();
        let inside = |cell: usize| arrays.iter().any(|a| a.values.get(cell * a.components) != 0.0);
        (0..self.grid.types.len()).map(inside).collect()
    }

    /// Which elements its groups hold.
    pub fn groups(&self) -> ElementGroups {
        ElementGroups::of(&self.grid)
    }

    /// The outside of some elements, by index of their cells, where it lies on others.
    pub fn skin(&self, inside: &[bool]) -> Skin {
        Skin::of(&self.grid, inside)
    }
}
