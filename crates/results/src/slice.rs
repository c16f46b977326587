//! Where a plane y = constant meets the elements of a grid.

use std::collections::HashMap;

use tremolite_mesh::vtu::Grid;

use crate::arrays::{groups, scalar};

/// A corner of a piece: a point on an edge of the mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// (x, z) in m.
    pub at: [f64; 2],
    /// The edge's points, and how far from the first to the second it lies, 0 to 1.
    pub ends: [u32; 2],
    pub part: f64,
}

/// What the plane cuts out of one element.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// Index of the element's cell.
    pub cell: usize,
    /// In order around the outline; three to six of them.
    pub corners: Vec<Corner>,
    /// Number of the element's group; 0 where the file has none.
    pub group: i64,
}

/// A plane through a grid. Several fields may be looked at on it.
#[derive(Clone, Debug, PartialEq)]
pub struct Slice {
    /// Where the plane lies (m).
    pub y: f64,
    /// Elements that it meets, in the grid's order.
    pub pieces: Vec<Piece>,
}

impl Slice {
    /// Cuts a grid, which must pass [`Grid::check`], at `y` (m), or through the middle of the model.
    pub fn of(grid: &Grid, y: Option<f64>) -> Slice {
        let finite = || grid.points.iter().map(|point| point[1]).filter(|y| y.is_finite());
        let low = finite().fold(f64::INFINITY, f64::min);
        let high = finite().fold(f64::NEG_INFINITY, f64::max);
        let y = y.unwrap_or(0.5 * (low + high)).clamp(low, high.max(low));
        // A plane through faces of the mesh would meet either both sides or none: a nudge decides for one.
        let nudge = 1e-6 * (high - low);
        let plane = if y + nudge < high { y + nudge } else { y - nudge };
        let groups = groups(grid);
        let piece = |cell: usize| {
            let corners = corners(grid, grid.cell(cell), edges(grid.types[cell]), plane);
            let group = groups.map_or(0, |array| array.values.get(cell) as i64);
            (corners.len() >= 3).then_some(Piece { cell, corners, group })
        };
        Slice { y, pieces: (0..grid.types.len()).filter_map(piece).collect() }
    }

    /// A field of elements, smoothed: at each corner of each piece. A node gets the mean of its elements that are of the
    /// piece's own group, each counting alike, and what lies between nodes is interpolated; so what jumps between two groups
    /// goes on jumping. Values that are no numbers count for nothing. Nothing where the grid has no such field of elements.
    pub fn smooth(&self, grid: &Grid, field: &str) -> Option<Vec<Vec<f64>>> {
        let array = grid.cell_array(field)?;
        let groups = groups(grid);
        let mut near = vec![false; grid.points.len()];
        for corner in self.pieces.iter().flat_map(|piece| &piece.corners) {
            corner.ends.iter().for_each(|&end| near[end as usize] = true);
        }
        let mut sums: HashMap<(i64, u32), (f64, f64)> = HashMap::new();
        for cell in 0..grid.types.len() {
            let nodes = grid.cell(cell);
            if !nodes.iter().any(|&node| near[node as usize]) {
                continue;
            }
            let value = scalar(array, cell);
            if value.is_finite() {
                let group = groups.map_or(0, |array| array.values.get(cell) as i64);
                for &node in nodes {
                    let (sum, number) = sums.entry((group, node)).or_default();
                    (*sum, *number) = (*sum + value, *number + 1.0);
                }
            }
        }
        let mean =
            |group: i64, node: u32| sums.get(&(group, node)).map_or(f64::NAN, |(sum, number)| sum / number);
        let at = |piece: &Piece| {
            let between = |corner: &Corner| {
                let [a, b] = corner.ends.map(|end| mean(piece.group, end));
                a + corner.part * (b - a)
            };
            piece.corners.iter().map(between).collect()
        };
        Some(self.pieces.iter().map(at).collect())
    }

    /// A vector of the points, at each corner of each piece. Nothing where the grid has no such field of three components.
    pub fn vectors(&self, grid: &Grid, field: &str) -> Option<Vec<Vec<[f64; 3]>>> {
        let array = grid.point_array(field).filter(|array| array.components == 3)?;
        let at = |corner: &Corner| {
            [0, 1, 2].map(|i| {
                let [a, b] = corner.ends.map(|end| array.values.get(3 * end as usize + i));
                a + corner.part * (b - a)
            })
        };
        Some(self.pieces.iter().map(|piece| piece.corners.iter().map(at).collect()).collect())
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
fn corners(grid: &Grid, nodes: &[u32], edges: &[(usize, usize)], plane: f64) -> Vec<Corner> {
    let mut corners = Vec::new();
    for &(a, b) in edges {
        let (Some(&from), Some(&to)) = (nodes.get(a), nodes.get(b)) else { return Vec::new() };
        let (a, b) = (grid.points[from as usize], grid.points[to as usize]);
        if (a[1] < plane) != (b[1] < plane) {
            let part = (plane - a[1]) / (b[1] - a[1]);
            let at = [a[0] + part * (b[0] - a[0]), a[2] + part * (b[2] - a[2])];
            if at.iter().all(|c| c.is_finite()) {
                corners.push(Corner { at, ends: [from, to], part });
            }
        }
    }
    let number = corners.len().max(1) as f64;
    let centre = [0, 1].map(|i| corners.iter().map(|corner| corner.at[i]).sum::<f64>() / number);
    let angle = |corner: &Corner| (corner.at[1] - centre[1]).atan2(corner.at[0] - centre[0]);
    corners.sort_by(|a, b| angle(a).total_cmp(&angle(b)));
    corners
}
