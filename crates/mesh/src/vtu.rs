//! VTU files: an unstructured grid with named arrays, as ParaView, VTK and meshio read it.
//!
//! [`Grid`] is the file in memory. [`Grid::write`] makes `UnstructuredGrid` XML, version 1.0, little
//! endian, with raw appended data in zlib blocks and 64-bit block headers. [`Grid::read`] reads these and
//! the other layouts of the format, and PVTU files, which name the files of several pieces. Units travel in VTK's own information key `UNITS_LABEL`.
//!
//! As a mesh file, a VTU holds groups as cell arrays `group:NAME` (0 or 1), named faces as `faces:NAME` (one
//! bit a face), named points as field arrays `point:NAME`, and numbers other than 1, 2, 3 … as the arrays
//! `node number` and `element number`. Of other programs' files, arrays such as `MaterialIds` make groups.

mod base64;
mod cells;
mod data;
mod header;
mod kind;
mod outline;
mod pieces;
mod read;
mod write;

use std::io;
use std::path::PathBuf;

use crate::{Mesh, Shape};

pub(crate) use cells::{FORMAT, NO_SOLIDS, means_something, solids, write_mesh};
pub(crate) use kind::Kind;
pub use pieces::{NODE, write_list};
pub(crate) use read::append_indices;

/// Numbers of one array, tuple after tuple.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    Float32(Vec<f32>),
    Float64(Vec<f64>),
    Int32(Vec<i32>),
    Int64(Vec<i64>),
    UInt8(Vec<u8>),
}

impl Values {
    /// How many numbers there are (tuples times components).
    pub fn len(&self) -> usize {
        match self {
            Values::Float32(v) => v.len(),
            Values::Float64(v) => v.len(),
            Values::Int32(v) => v.len(),
            Values::Int64(v) => v.len(),
            Values::UInt8(v) => v.len(),
        }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Adds the numbers of another array of the same type; whether it is of the same type.
    pub(crate) fn append(&mut self, other: &Values) -> bool {
        match (self, other) {
            (Values::Float32(a), Values::Float32(b)) => a.extend(b),
            (Values::Float64(a), Values::Float64(b)) => a.extend(b),
            (Values::Int32(a), Values::Int32(b)) => a.extend(b),
            (Values::Int64(a), Values::Int64(b)) => a.extend(b),
            (Values::UInt8(a), Values::UInt8(b)) => a.extend(b),
            _ => return false,
        }
        true
    }

    /// Number `i` as f64 (exact, but for Int64 beyond 2⁵³).
    ///
    /// # Panics
    /// If `i` is not less than [`Values::len`].
    pub fn get(&self, i: usize) -> f64 {
        match self {
            Values::Float32(v) => f64::from(v[i]),
            Values::Float64(v) => v[i],
            Values::Int32(v) => f64::from(v[i]),
            Values::Int64(v) => v[i] as f64,
            Values::UInt8(v) => f64::from(v[i]),
        }
    }
}

/// A named array with one tuple for each point or cell.
#[derive(Clone, Debug, PartialEq)]
pub struct Array {
    /// Name shown in ParaView.
    pub name: String,
    /// Unit such as `m` or `Pa`; empty if the numbers have none.
    pub unit: String,
    /// Numbers in a tuple: 1 scalar, 3 vector, 6 symmetric tensor (VTK order xx, yy, zz, xy, yz, xz).
    pub components: usize,
    pub values: Values,
}

impl Array {
    /// An array from its parts; nothing is checked before [`Grid::write`].
    pub fn new(name: impl Into<String>, unit: impl Into<String>, components: usize, values: Values) -> Self {
        Array { name: name.into(), unit: unit.into(), components, values }
    }
}

/// An unstructured grid with its arrays: the contents of one VTU file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Grid {
    /// Coordinates \[m\].
    pub points: Vec<[f64; 3]>,
    /// Points of all cells, cell after cell, in VTK's node order.
    pub connectivity: Vec<u32>,
    /// For each cell, where its points end in `connectivity`.
    pub offsets: Vec<u32>,
    /// VTK cell types, see [`vtk_type`].
    pub types: Vec<u8>,
    /// Arrays with one tuple a point.
    pub point_data: Vec<Array>,
    /// Arrays with one tuple a cell.
    pub cell_data: Vec<Array>,
    /// Arrays that belong to the grid as a whole.
    pub field_data: Vec<Array>,
    /// Time of the data \[s\], written as the field array `TimeValue`, which ParaView shows.
    pub time: Option<f64>,
}

/// Why a VTU file could not be written or read.
#[derive(Debug, thiserror::Error)]
pub enum VtuError {
    /// The operating system refused.
    #[error("{}: {source}", path.display())]
    Io { path: PathBuf, source: io::Error },
    /// The grid to be written contradicts itself.
    #[error("{}: not written: {reason}", path.display())]
    Grid { path: PathBuf, reason: String },
    /// The file is damaged, or no unstructured grid.
    #[error("{}: not a readable VTU file: {reason}", path.display())]
    Format { path: PathBuf, reason: String },
}

/// VTK's number of a shape.
///
/// The node order is VTK's for every shape. For the wedge that is true from VTK 9.7 on: older ones
/// took the opposite triangle first, draw these wedges the same but give them a negative volume.
pub const fn vtk_type(shape: Shape) -> u8 {
    match shape {
        Shape::Tet4 => 10,
        Shape::Hex8 => 12,
        Shape::Wedge6 => 13,
        Shape::Pyramid5 => 14,
    }
}

impl Grid {
    /// The grid of a mesh, or of some of its elements, and the mesh node that each point came from.
    ///
    /// Cells are in the order of `elements` (indices into [`Mesh::elements`]); points are the nodes
    /// these use, ascending. Without `elements` all of both are taken, so points and nodes agree.
    ///
    /// # Panics
    /// If an element or one of its nodes is not in the mesh.
    pub fn from_mesh(mesh: &Mesh, elements: Option<&[u32]>) -> (Grid, Vec<u32>) {
        let all: Vec<u32>;
        let (cells, nodes) = match elements {
            Some(some) => {
                let mut used: Vec<u32> =
                    some.iter().flat_map(|&e| mesh.elements[e as usize].nodes()).copied().collect();
                used.sort_unstable();
                used.dedup();
                (some, used)
            }
            None => {
                all = (0..mesh.elements.len() as u32).collect();
                (all.as_slice(), (0..mesh.nodes.len() as u32).collect())
            }
        };
        let mut point_of = vec![u32::MAX; mesh.nodes.len()];
        for (point, &node) in nodes.iter().enumerate() {
            point_of[node as usize] = point as u32;
        }
        let mut grid = Grid {
            points: nodes.iter().map(|&n| mesh.nodes[n as usize]).collect(),
            connectivity: Vec::with_capacity(cells.len() * 8),
            offsets: Vec::with_capacity(cells.len()),
            types: Vec::with_capacity(cells.len()),
            ..Grid::default()
        };
        for &cell in cells {
            let element = &mesh.elements[cell as usize];
            grid.connectivity.extend(element.nodes().iter().map(|&n| point_of[n as usize]));
            grid.offsets.push(grid.connectivity.len() as u32);
            grid.types.push(vtk_type(element.shape));
        }
        (grid, nodes)
    }

    /// The points of cell `cell`.
    ///
    /// # Panics
    /// If there is no such cell.
    pub fn cell(&self, cell: usize) -> &[u32] {
        let start = if cell == 0 { 0 } else { self.offsets[cell - 1] as usize };
        &self.connectivity[start..self.offsets[cell] as usize]
    }

    /// The point array of that name.
    pub fn point_array(&self, name: &str) -> Option<&Array> {
        self.point_data.iter().find(|a| a.name == name)
    }

    /// The cell array of that name.
    pub fn cell_array(&self, name: &str) -> Option<&Array> {
        self.cell_data.iter().find(|a| a.name == name)
    }

    /// Checks that lengths and indices agree, so that a reader can rely on them.
    ///
    /// # Errors
    /// The first disagreement, in words.
    pub fn check(&self) -> Result<(), String> {
        if self.types.len() != self.offsets.len() {
            return Err(format!("{} cell types for {} cells", self.types.len(), self.offsets.len()));
        }
        let mut start = 0;
        for (cell, &end) in self.offsets.iter().enumerate() {
            if end < start || end as usize > self.connectivity.len() {
                return Err(format!("cell {cell} ends at {end}, outside its connectivity"));
            }
            start = end;
        }
        if start as usize != self.connectivity.len() {
            return Err(format!("{} points of cells, offsets end at {start}", self.connectivity.len()));
        }
        if let Some(point) = self.connectivity.iter().find(|&&p| p as usize >= self.points.len()) {
            return Err(format!("a cell uses point {point}, there are {}", self.points.len()));
        }
        for (arrays, tuples, kind) in
            [(&self.point_data, self.points.len(), "points"), (&self.cell_data, self.offsets.len(), "cells")]
        {
            for array in arrays {
                if array.components == 0 || array.components.checked_mul(tuples) != Some(array.values.len()) {
                    return Err(format!(
                        "array `{}` has {} numbers for {tuples} {kind} of {} components",
                        array.name,
                        array.values.len(),
                        array.components
                    ));
                }
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests;
