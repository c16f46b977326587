//! Cuts through field files: what a plane y = constant shows of the elements, with one value each.

use std::path::Path;

use tremolite_mesh::vtu::{Grid, VtuError};

use crate::arrays::scalar;
use crate::slice::Slice;

/// Where the plane met one element.
#[derive(Clone, Debug, PartialEq)]
pub struct CutCell {
    /// Corners (x, z) in m, in order around the outline; three to six of them.
    pub outline: Vec<[f64; 2]>,
    /// The field's value, in its unit.
    pub value: f64,
    /// Number of the element's group; 0 where the file has none.
    pub group: i64,
}

/// A field on the plane y = constant.
#[derive(Clone, Debug, PartialEq)]
pub struct Cut {
    /// Name of the field.
    pub field: String,
    /// Its unit; empty if the file gives none.
    pub unit: String,
    /// Where the plane lies (m).
    pub y: f64,
    /// Time of the file (s), if it says.
    pub time: Option<f64>,
    /// Elements that the plane meets, in the file's order.
    pub cells: Vec<CutCell>,
}

impl Cut {
    /// Cuts the field file `path` at `y` (m), or through the middle of the model. Who wants several fields reads
    /// [`Fields`](crate::Fields) once.
    ///
    /// `fields` are names of arrays in order of preference; the first that the file has is taken, from the
    /// elements or else from the nodes (then averaged over each element's). Of a vector the length is taken.
    /// None if the file has none of them.
    ///
    /// # Errors
    /// If the file cannot be read, see [`Grid::read`].
    pub fn read(path: &Path, y: Option<f64>, fields: &[&str]) -> Result<Option<Cut>, VtuError> {
        Ok(Self::of(&Grid::read(path)?, y, fields))
    }

    /// As [`Cut::read`] of a grid in memory, which must pass [`Grid::check`].
    pub fn of(grid: &Grid, y: Option<f64>, fields: &[&str]) -> Option<Cut> {
        Self::on(grid, &Slice::of(grid, y), fields)
    }

    /// As [`Cut::of`] on a plane that was cut before.
    pub fn on(grid: &Grid, slice: &Slice, fields: &[&str]) -> Option<Cut> {
        let (array, at_cells) = fields.iter().find_map(|name| {
            let at_cells = grid.cell_array(name).map(|array| (array, true));
            at_cells.or_else(|| grid.point_array(name).map(|array| (array, false)))
        })?;
        let value = |cell: usize| match at_cells {
            true => scalar(array, cell),
            false => {
                let nodes = grid.cell(cell);
                nodes.iter().map(|&node| scalar(array, node as usize)).sum::<f64>() / nodes.len() as f64
            }
        };
        let cells = slice.pieces.iter().map(|piece| CutCell {
            outline: piece.corners.iter().map(|corner| corner.at).collect(),
            value: value(piece.cell),
            group: piece.group,
        });
        Some(Cut {
            field: array.name.clone(),
            unit: array.unit.clone(),
            y: slice.y,
            time: grid.time,
            cells: cells.collect(),
        })
    }
}
