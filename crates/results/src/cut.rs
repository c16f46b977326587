//! A cut through a field file: the outlines in which a plane y = constant meets the elements, with one value each.

use std::path::Path;

use tremolite_mesh::vtu::{Array, Grid, VtuError};

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

/// Names under which a file may keep the number of each element's group.
const GROUPS: [&str; 4] = ["body", "group", "region", "material"];

impl Cut {
    /// Cuts the field file `path` at `y` (m), or through the middle of the model.
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
        let (array, at_cells) = fields.iter().find_map(|name| {
            let at_cells = grid.cell_array(name).map(|array| (array, true));
            at_cells.or_else(|| grid.point_array(name).map(|array| (array, false)))
        })?;
        let finite = || grid.points.iter().map(|point| point[1]).filter(|y| y.is_finite());
        let low = finite().fold(f64::INFINITY, f64::min);
        let high = finite().fold(f64::NEG_INFINITY, f64::max);
        let y = y.unwrap_or(0.5 * (low + high)).clamp(low, high.max(low));
        // A plane through faces of the mesh would meet either both sides or none: a nudge decides for one.
        let nudge = 1e-6 * (high - low);
        let plane = if y + nudge < high { y + nudge } else { y - nudge };

        let groups =
            GROUPS.iter().find_map(|name| grid.cell_array(name)).filter(|array| array.components == 1);
        let mut cells = Vec::new();
        for cell in 0..grid.types.len() {
            let nodes = grid.cell(cell);
            let outline = outline(grid, nodes, edges(grid.types[cell]), plane);
            if outline.len() < 3 {
                continue;
            }
            let value = if at_cells {
                size(array, cell)
            } else {
                nodes.iter().map(|&node| size(array, node as usize)).sum::<f64>() / nodes.len() as f64
            };
            cells.push(CutCell {
                outline,
                value,
                group: groups.map_or(0, |array| array.values.get(cell) as i64),
            });
        }
        Some(Cut { field: array.name.clone(), unit: array.unit.clone(), y, time: grid.time, cells })
    }
}

/// A scalar, or the length of a vector.
fn size(array: &Array, tuple: usize) -> f64 {
    let component = |i: usize| array.values.get(tuple * array.components + i);
    match array.components {
        1 => component(0),
        n => (0..n).map(|i| component(i) * component(i)).sum::<f64>().sqrt(),
    }
}

/// Edges of a VTK cell by its local nodes; none for cells that are not solid and linear.
fn edges(kind: u8) -> &'static [(usize, usize)] {
    match kind {
        10 => &[(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)],
        12 => {
            &[(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
        }
        13 => &[(0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3), (0, 3), (1, 4), (2, 5)],
        14 => &[(0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (1, 4), (2, 4), (3, 4)],
        _ => &[],
    }
}

/// Where the plane meets the edges of a convex cell, sorted around their centre.
fn outline(grid: &Grid, nodes: &[u32], edges: &[(usize, usize)], plane: f64) -> Vec<[f64; 2]> {
    let mut corners = Vec::new();
    for &(a, b) in edges {
        let (Some(&a), Some(&b)) = (nodes.get(a), nodes.get(b)) else { return Vec::new() };
        let (a, b) = (grid.points[a as usize], grid.points[b as usize]);
        if (a[1] < plane) != (b[1] < plane) {
            let s = (plane - a[1]) / (b[1] - a[1]);
            let corner = [a[0] + s * (b[0] - a[0]), a[2] + s * (b[2] - a[2])];
            if corner.iter().all(|c| c.is_finite()) {
                corners.push(corner);
            }
        }
    }
    let number = corners.len().max(1) as f64;
    let centre = [0, 1].map(|i| corners.iter().map(|corner| corner[i]).sum::<f64>() / number);
    let angle = |corner: &[f64; 2]| (corner[1] - centre[1]).atan2(corner[0] - centre[0]);
    corners.sort_by(|a, b| angle(a).total_cmp(&angle(b)));
    corners
}
