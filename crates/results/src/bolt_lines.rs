//! Bolts as lines: the segments of a file in `bolts/`, with what they did.

use std::path::Path;

use tremolite_mesh::vtu::{Array, Grid, VtuError};

/// A segment at one time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BoltLine {
    /// Which group of the file it belongs to, as an index of [`BoltLines::groups`]; the bolt's number in it, from 1.
    pub group: usize,
    pub bolt: u32,
    /// Ends, from the head on (m), and their distances from the head along the bolt (m).
    pub ends: [[f64; 3]; 2],
    pub at: [f64; 2],
    /// Force (N), tension positive, and its size over what it yields at; the same at its largest in any step since the stage,
    /// or the shaking, began.
    pub force: f64,
    pub force_over_yield: f64,
    pub force_max: f64,
    pub force_over_yield_max: f64,
    /// Largest slip so far (m).
    pub slip_max: f64,
    /// 0 elastic, 1 slid, 2 yielded, 3 broken, 4 cut off.
    pub state: u8,
}

/// All segments of a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BoltLines {
    /// Names of the groups, from the arrays `group:NAME`.
    pub groups: Vec<String>,
    pub lines: Vec<BoltLine>,
}

impl BoltLines {
    /// Reads a file.
    ///
    /// # Errors
    /// If it cannot be read, see [`Grid::read`], or lacks an array.
    pub fn read(path: &Path) -> Result<BoltLines, VtuError> {
        let grid = Grid::read(path)?;
        Self::of(&grid).map_err(|reason| VtuError::Format { path: path.to_owned(), reason })
    }

    /// As [`BoltLines::read`] of a grid in memory, which must pass [`Grid::check`].
    ///
    /// # Errors
    /// If it lacks an array, in words.
    pub fn of(grid: &Grid) -> Result<BoltLines, String> {
        let of_cells = |name: &str| {
            let array = grid.cell_array(name).filter(|a| a.components == 1);
            array.ok_or_else(|| format!("no array {name} at its cells"))
        };
        let at = grid.point_array("from_head").filter(|a| a.components == 1);
        let at = at.ok_or("no array from_head at its points")?;
        let [group, bolt, force, over, most, over_most, slip, state] = [
            of_cells("group")?,
            of_cells("bolt")?,
            of_cells("force")?,
            of_cells("force_over_yield")?,
            of_cells("force_max")?,
            of_cells("force_over_yield_max")?,
            of_cells("slip_max")?,
            of_cells("state")?,
        ];
        let marked = |array: &Array| array.name.strip_prefix("group:").map(str::to_owned);
        let groups: Vec<String> = grid.cell_data.iter().filter_map(marked).collect();
        let mut lines = Vec::with_capacity(grid.types.len());
        for cell in 0..grid.types.len() {
            let &[a, b] = grid.cell(cell) else { return Err(format!("cell {cell} is no line")) };
            let group = group.values.get(cell).max(0.0) as usize;
            if group >= groups.len() {
                return Err(format!("cell {cell} is of group {group}, of which there is no array"));
            }
            let of = |array: &Array| array.values.get(cell);
            lines.push(BoltLine {
                group,
                bolt: of(bolt) as u32,
                ends: [a, b].map(|point| grid.points[point as usize]),
                at: [a, b].map(|point| at.values.get(point as usize)),
                force: of(force),
                force_over_yield: of(over),
                force_max: of(most),
                force_over_yield_max: of(over_most),
                slip_max: of(slip),
                state: of(state) as u8,
            });
        }
        Ok(BoltLines { groups, lines })
    }
}
