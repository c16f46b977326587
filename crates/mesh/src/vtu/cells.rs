//! Cells of a grid as elements of a mesh, and back. Groups, named faces, named points and the numbers of nodes
//! and elements travel in arrays of their own, so that nothing is lost between writing and reading.

use std::collections::BTreeMap;
use std::io::Write;
use std::path::Path;

use super::read::{append_indices, parse};
use super::{Array, Grid, Values};
use crate::assembly::Draft;
use crate::fault::Fault;
use crate::format::{Format, Outcome};
use crate::input::Input;
use crate::note::Note;
use crate::trouble::Trouble;
use crate::{Face, Mesh, Shape};

/// VTU, for [`crate::read::read`].
pub(crate) const FORMAT: Format = Format { name: "VTU (VTK's XML)", recognises: is_vtu, parse: read };

/// Cell arrays with this prefix are 1 where a cell belongs to the group named after it.
const GROUP: &str = "group:";
/// Cell arrays with this prefix have bit `s` set where face `s` of a cell belongs to the surface.
const FACES: &str = "faces:";
/// Field arrays with this prefix are a named point.
const POINT: &str = "point:";
/// Cell array in which bit 0 marks a cell that another piece of a distributed grid has too.
const GHOST: &str = "vtkGhostType";
const NODE_NUMBER: &str = "node number";
const ELEMENT_NUMBER: &str = "element number";
/// Cell arrays by which other programs tell parts of a mesh apart; each value becomes a group.
const LABELS: [&str; 14] = [
    "group",
    "groupids",
    "region",
    "regionid",
    "regions",
    "material",
    "materialid",
    "materialids",
    "material_id",
    "cellentityids",
    "gmsh:physical",
    "medit:ref",
    "partid",
    "attribute",
];
/// What to do about a file without solids.
pub(crate) const NO_SOLIDS: &str =
    "save the volume cells (in ParaView, of the mesh itself, not of a surface or slice)";

fn is_vtu(head: &[u8]) -> bool {
    let head = head.trim_ascii_start();
    head.starts_with(b"<") && head.windows(8).any(|w| w == b"<VTKFile")
}

fn read(input: &mut Input, _: &Path) -> Outcome {
    let grid = parse(input.source(), means_something).map_err(Fault::whole)?;
    solids(grid).map_err(Fault::whole)?.finish(NO_SOLIDS)
}

/// Whether an array of this name says something about a mesh.
pub(crate) fn means_something(name: &str) -> bool {
    [GROUP, FACES, POINT].iter().any(|prefix| name.starts_with(prefix))
        || [NODE_NUMBER, ELEMENT_NUMBER, GHOST].contains(&name)
        || LABELS.contains(&name.to_lowercase().as_str())
}

/// Writes a mesh as VTU.
pub(crate) fn write_mesh(mesh: &Mesh, out: &mut dyn Write) -> Result<Vec<Note>, Trouble> {
    let grid = grid(mesh).map_err(Trouble::Mesh)?;
    grid.check().map_err(Trouble::Mesh)?;
    grid.write_to(out)?;
    Ok(Vec::new())
}

/// What a cell is to a mesh of solids.
enum Role {
    Solid(Shape),
    /// An axis-parallel brick, whose nodes are in another order.
    Voxel,
    /// Points, lines and surfaces.
    Flat(&'static str),
}

fn role(cell: u8) -> Option<Role> {
    Some(match cell {
        10 | 24 => Role::Solid(Shape::Tet4),
        12 | 25 | 29 | 33 => Role::Solid(Shape::Hex8),
        13 | 26 | 31 | 32 => Role::Solid(Shape::Wedge6),
        14 | 27 | 37 => Role::Solid(Shape::Pyramid5),
        11 => Role::Voxel,
        1 | 2 => Role::Flat("points"),
        3 | 4 | 21 | 35 => Role::Flat("lines"),
        5..=9 | 22 | 23 | 28 | 30 | 34 | 36 => Role::Flat("triangles, quadrilaterals or polygons"),
        _ => return None,
    })
}

/// The number of nodes of a cell type.
fn nodes(cell: u8) -> usize {
    match cell {
        10 => 4,
        14 => 5,
        13 => 6,
        24 => 10,
        31 => 12,
        27 => 13,
        26 => 15,
        32 => 18,
        37 => 19,
        25 => 20,
        33 => 24,
        29 => 27,
        _ => 8,
    }
}

/// The solid cells of a grid.
pub(crate) fn solids(grid: Grid) -> Result<Draft, String> {
    let mut draft = Draft::default();
    // The element of each cell.
    let mut element_of = vec![u32::MAX; grid.types.len()];
    let mut doubled = 0;
    let ghosts = grid.cell_array(GHOST).filter(|a| a.components == 1 && whole(a));
    for (cell, &kind) in grid.types.iter().enumerate() {
        let points = grid.cell(cell);
        let mut corners = [0; 8];
        let shape = match role(kind) {
            None => {
                return Err(format!(
                    "cell {cell} has VTK's type {kind}, which is not supported; only tetrahedra, pyramids, wedges \
                     and hexahedra of first or second order are"
                ));
            }
            Some(Role::Flat(name)) => {
                draft.skip(name, 1);
                continue;
            }
            Some(_) if ghosts.is_some_and(|a| a.values.get(cell) as i64 & 1 == 1) => {
                doubled += 1;
                continue;
            }
            Some(Role::Solid(shape)) => shape,
            Some(Role::Voxel) => Shape::Hex8,
        };
        if points.len() != nodes(kind) {
            return Err(format!(
                "cell {cell} of VTK's type {kind} has {} points, expected {}",
                points.len(),
                nodes(kind)
            ));
        }
        corners[..shape.nodes()].copy_from_slice(&points[..shape.nodes()]);
        if kind == 11 {
            corners = [0, 1, 3, 2, 4, 5, 7, 6].map(|k: usize| corners[k]);
        }
        element_of[cell] = draft.mesh.elements.len() as u32;
        draft.push(cell as u64 + 1, shape, &corners[..shape.nodes()]);
        draft.reduce(points.len(), shape);
    }
    if doubled > 0 {
        let what = "ghost cells, which another piece has too,".to_owned();
        draft.notes.push(Note::NotTaken { what, count: doubled });
    }
    if let Some(node) = grid.points.iter().position(|x| x.iter().any(|x| !x.is_finite())) {
        return Err(format!("point {node} has a coordinate that is no finite number"));
    }
    let mesh = &mut draft.mesh;
    mesh.node_ids = match grid.point_array(NODE_NUMBER) {
        Some(array) => numbers(array, grid.points.len())?,
        None => (1..=grid.points.len() as u64).collect(),
    };
    let elements =
        || element_of.iter().enumerate().filter(|(_, e)| **e != u32::MAX).map(|(cell, &e)| (cell, e));
    if let Some(array) = grid.cell_array(ELEMENT_NUMBER) {
        let numbers = numbers(array, grid.types.len())?;
        mesh.element_ids = elements().map(|(cell, _)| numbers[cell]).collect();
    }
    for array in grid.cell_data.iter().filter(|a| a.components == 1) {
        if let Some(name) = array.name.strip_prefix(GROUP) {
            let members = elements().filter(|&(cell, _)| array.values.get(cell) != 0.0).map(|(_, e)| e);
            mesh.groups.insert(name.to_owned(), members.collect());
        } else if let (Some(name), Values::UInt8(bits)) = (array.name.strip_prefix(FACES), &array.values) {
            let mut faces = Vec::new();
            for (cell, element) in elements() {
                let sides = mesh.elements[element as usize].shape.faces().len() as u8;
                faces.extend(
                    (0..sides).filter(|s| bits[cell] >> s & 1 == 1).map(|side| Face { element, side }),
                );
            }
            mesh.faces.insert(name.to_owned(), faces);
        } else if LABELS.contains(&array.name.to_lowercase().as_str()) && whole(array) {
            let mut members: BTreeMap<i64, Vec<u32>> = BTreeMap::new();
            for (cell, element) in elements() {
                members.entry(array.values.get(cell) as i64).or_default().push(element);
            }
            for (value, list) in members {
                mesh.groups.insert(format!("{} {value}", array.name), list);
            }
        }
    }
    for array in &grid.field_data {
        if let (Some(name), 3) = (array.name.strip_prefix(POINT), array.values.len()) {
            mesh.points.insert(name.to_owned(), [0, 1, 2].map(|i| array.values.get(i)));
        }
    }
    mesh.nodes = grid.points;
    Ok(draft)
}

fn whole(array: &Array) -> bool {
    matches!(array.values, Values::Int32(_) | Values::Int64(_) | Values::UInt8(_))
}

fn numbers(array: &Array, count: usize) -> Result<Vec<u64>, String> {
    let numbers: Vec<u64> = match &array.values {
        Values::Int64(values) => values.iter().filter_map(|&n| u64::try_from(n).ok()).collect(),
        values => {
            let mut numbers = Vec::new();
            append_indices(&mut numbers, values).map_err(|e| format!("array `{}`: {e}", array.name))?;
            numbers.into_iter().map(u64::from).collect()
        }
    };
    if numbers.len() == count {
        return Ok(numbers);
    }
    Err(format!("array `{}` does not hold a number for each", array.name))
}

/// A mesh as a grid, with all that belongs to it.
fn grid(mesh: &Mesh) -> Result<Grid, String> {
    let (mut grid, _) = Grid::from_mesh(mesh, None);
    let signed = |numbers: &[u64]| -> Result<Values, String> {
        let one = |&n: &u64| {
            i64::try_from(n).map_err(|_| format!("VTU cannot hold the number {n}; renumber the mesh"))
        };
        Ok(Values::Int64(numbers.iter().map(one).collect::<Result<_, _>>()?))
    };
    if !mesh.node_ids.is_empty() {
        grid.point_data.push(Array::new(NODE_NUMBER, "", 1, signed(&mesh.node_ids)?));
    }
    if !mesh.element_ids.is_empty() {
        grid.cell_data.push(Array::new(ELEMENT_NUMBER, "", 1, signed(&mesh.element_ids)?));
    }
    for (name, list) in &mesh.groups {
        let mut member = vec![0; mesh.elements.len()];
        for &element in list {
            member[element as usize] = 1;
        }
        grid.cell_data.push(Array::new(format!("{GROUP}{name}"), "", 1, Values::UInt8(member)));
    }
    for (name, list) in &mesh.faces {
        let mut bits = vec![0; mesh.elements.len()];
        for face in list {
            bits[face.element as usize] |= 1 << face.side;
        }
        grid.cell_data.push(Array::new(format!("{FACES}{name}"), "", 1, Values::UInt8(bits)));
    }
    for (name, place) in &mesh.points {
        grid.field_data.push(Array::new(format!("{POINT}{name}"), "m", 3, Values::Float64(place.to_vec())));
    }
    let names = grid.cell_data.iter().chain(&grid.field_data).map(|a| &a.name);
    match names.into_iter().find(|n| n.contains(char::is_control)) {
        Some(name) => {
            Err(format!("VTU cannot hold the name {name:?}, which has a control character; rename it"))
        }
        None => Ok(grid),
    }
}
