//! Meshes as arrays, both ways; and the grids of field files.

use crate::arrays::{column, matrix, rows};
use crate::errors::{refused, unusable};
use numpy::{PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use std::path::PathBuf;
use tremolite::Model;
use tremolite::setup::{Inputs, free_sides, mesh_of};
use tremolite_case::Case;
use tremolite_mesh::vtu::{Array, Grid, Values};
use tremolite_mesh::{Element, Face, Mesh, Shape, quality, read_with_notes, sound, write};

const SHAPES: [Shape; 4] = [Shape::Hex8, Shape::Wedge6, Shape::Pyramid5, Shape::Tet4];

/// An array (n,) of indices that has been given.
type Indices<'py> = PyReadonlyArray1<'py, i64>;

/// A mesh of a Python `Mesh`, whose arrays have been brought into form.
///
/// # Errors
/// If an index is none, or a shape is not known.
pub fn of_python(mesh: &Bound<'_, PyAny>) -> PyResult<Mesh> {
    let points: PyReadonlyArray2<f64> = field(mesh, "points")?;
    let mut made = Mesh {
        nodes: points.as_array().rows().into_iter().map(|x| [x[0], x[1], x[2]]).collect(),
        ..Mesh::default()
    };
    let cells: Vec<(String, PyReadonlyArray2<i64>)> = field(mesh, "cells")?;
    for (name, block) in cells {
        let Some(shape) = SHAPES.into_iter().find(|shape| shape.name() == name) else {
            return Err(unusable(format!(
                "no element is called {name:?}; there are hex8, wedge6, pyramid5 and tet4"
            )));
        };
        for nodes in block.as_array().rows() {
            let nodes =
                nodes.iter().map(|&n| index(n, "a node of an element")).collect::<PyResult<Vec<u32>>>()?;
            if nodes.len() != shape.nodes() {
                return Err(unusable(format!("a {name} has {} nodes, not {}", shape.nodes(), nodes.len())));
            }
            made.elements.push(Element::new(shape, &nodes));
        }
    }
    let count = made.elements.len();
    let element = |e: i64| -> PyResult<u32> {
        let e = index(e, "an element of a group")?;
        if (e as usize) < count {
            Ok(e)
        } else {
            Err(unusable(format!("there is no element {e}: {count} are given, from 0")))
        }
    };
    for (name, group) in field::<Bound<'_, PyDict>>(mesh, "groups")? {
        let group: Indices = group.extract()?;
        let mut group = group.as_array().iter().map(|&e| element(e)).collect::<PyResult<Vec<u32>>>()?;
        group.sort_unstable();
        group.dedup();
        made.groups.insert(name.extract()?, group);
    }
    for (name, faces) in field::<Bound<'_, PyDict>>(mesh, "faces")? {
        let faces: PyReadonlyArray2<i64> = faces.extract()?;
        let mut list = Vec::new();
        for face in faces.as_array().rows() {
            let (element, side) = (element(face[0])?, face[1]);
            let sides = made.elements[element as usize].shape.faces().len();
            match u8::try_from(side) {
                Ok(side) if usize::from(side) < sides => list.push(Face { element, side }),
                _ => {
                    return Err(unusable(format!(
                        "element {element} has {sides} faces, from 0; {side} is none of them"
                    )));
                }
            }
        }
        made.faces.insert(name.extract()?, list);
    }
    for (name, point) in field::<Bound<'_, PyDict>>(mesh, "named_points")? {
        made.points.insert(name.extract()?, point.extract()?);
    }
    Ok(made)
}

/// Lines (n, 6): head and other end.
///
/// # Errors
/// If the array has another shape.
pub fn lines_of(ends: &Bound<'_, PyAny>) -> PyResult<Vec<[[f64; 3]; 2]>> {
    let array = ends.py().import("numpy")?.call_method1("asarray", (ends, "float64"))?;
    let ends: PyReadonlyArray2<f64> = array
        .extract()
        .map_err(|_| unusable("bolts are an array (n, 6): head and other end of each, x y z in m"))?;
    if ends.as_array().ncols() != 6 {
        return Err(unusable("bolts are an array (n, 6): head and other end of each, x y z in m"));
    }
    Ok(ends.as_array().rows().into_iter().map(|x| [[x[0], x[1], x[2]], [x[3], x[4], x[5]]]).collect())
}

/// What of a model's mesh is the user's, without the ground outside its sides.
pub fn of_user(model: &Model) -> Mesh {
    let mut mesh = model.mesh.clone();
    let inside = |e: &u32| (*e as usize) < model.user.elements;
    mesh.nodes.truncate(model.user.nodes);
    mesh.elements.truncate(model.user.elements);
    mesh.groups.values_mut().for_each(|group| group.retain(inside));
    mesh.faces.values_mut().for_each(|faces| faces.retain(|face| inside(&face.element)));
    mesh
}

/// A mesh as a Python `Mesh`. Elements stand in the same order; blocks are runs of one shape.
///
/// # Errors
/// If the class cannot be imported.
pub fn to_python<'py>(py: Python<'py>, mesh: &Mesh) -> PyResult<Bound<'py, PyAny>> {
    let cells = PyList::empty(py);
    for run in mesh.elements.chunk_by(|a, b| a.shape == b.shape) {
        let shape = run[0].shape;
        let nodes: Vec<i64> = run.iter().flat_map(|e| e.nodes().iter().map(|&n| i64::from(n))).collect();
        cells.append((shape.name(), matrix(py, shape.nodes(), nodes)?))?;
    }
    let groups = PyDict::new(py);
    for (name, group) in &mesh.groups {
        groups.set_item(name, column(py, group.iter().map(|&e| i64::from(e)).collect())?)?;
    }
    let faces = PyDict::new(py);
    for (name, list) in &mesh.faces {
        let list = list.iter().map(|face| [i64::from(face.element), i64::from(face.side)]).collect();
        faces.set_item(name, rows(py, list)?)?;
    }
    let points = PyDict::new(py);
    for (name, point) in &mesh.points {
        points.set_item(name, *point)?;
    }
    let made = (rows(py, mesh.nodes.clone())?, cells, groups, faces, points);
    py.import("tremolite._mesh")?.getattr("Mesh")?.call1(made)
}

/// The mesh of a case, in m, with what is in memory, for Python.
///
/// # Errors
/// Why it cannot be made or read.
pub fn of_case<'py>(py: Python<'py>, case: &Case, inputs: &Inputs) -> PyResult<Bound<'py, PyAny>> {
    let made =
        || mesh_of(&case.mesh, &case.ground, &case.interfaces, free_sides(case), &case.directory, inputs);
    match py.detach(made) {
        Ok((mesh, _)) => to_python(py, &mesh),
        Err(problems) => Err(refused(py, &case.report(problems))),
    }
}

fn field<'py, T>(mesh: &Bound<'py, PyAny>, name: &str) -> PyResult<T>
where
    T: for<'a> FromPyObject<'a, 'py>,
{
    let value = mesh
        .getattr(name)
        .map_err(|_| unusable("a mesh is a tremolite.Mesh: Mesh.from_meshio or Mesh.read makes one"))?;
    value
        .extract()
        .map_err(|_| unusable(format!("`{name}` of the mesh is not what Mesh makes of it; make a Mesh anew")))
}

fn index(n: i64, what: &str) -> PyResult<u32> {
    u32::try_from(n).map_err(|_| unusable(format!("{n} is no index of {what}; they count from 0")))
}

/// Reads a mesh file; a `Mesh` and what reading did beside reading, a sentence each.
#[pyfunction]
fn read_mesh(py: Python<'_>, path: PathBuf) -> PyResult<(Bound<'_, PyAny>, Vec<String>)> {
    let (mesh, notes) = py.detach(|| read_with_notes(path)).map_err(unusable)?;
    Ok((to_python(py, &mesh)?, notes.iter().map(ToString::to_string).collect()))
}

/// Writes a mesh in the format of the file's ending; what could not be kept, a sentence each.
#[pyfunction]
fn write_mesh(mesh: &Bound<'_, PyAny>, path: PathBuf) -> PyResult<Vec<String>> {
    let (mesh, mut notes) = sound(of_python(mesh)?).map_err(unusable)?;
    notes.extend(write(path, &mesh).map_err(unusable)?);
    Ok(notes.iter().map(ToString::to_string).collect())
}

/// A mesh as a run would take it, and what was done to it, a sentence each.
#[pyfunction]
fn sound_mesh<'py>(mesh: &Bound<'py, PyAny>) -> PyResult<(Bound<'py, PyAny>, Vec<String>)> {
    let (made, notes) = sound(of_python(mesh)?).map_err(unusable)?;
    Ok((to_python(mesh.py(), &made)?, notes.iter().map(ToString::to_string).collect()))
}

/// Volume [m³], scaled Jacobian, shortest and longest edge [m] of each element: an array (elements, 4).
#[pyfunction]
fn mesh_quality<'py>(mesh: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    let made = of_python(mesh)?;
    if let Some(n) = made.elements.iter().flat_map(|e| e.nodes()).find(|&&n| n as usize >= made.nodes.len()) {
        return Err(unusable(format!(
            "an element has the node {n}, where there are {}, from 0",
            made.nodes.len()
        )));
    }
    let of = |e| {
        let quality::Quality { volume, scaled_jacobian, shortest_edge, longest_edge } = quality::of(&made, e);
        [volume, scaled_jacobian, shortest_edge, longest_edge]
    };
    rows(mesh.py(), (0..made.elements.len()).map(of).collect())
}

/// Reads a VTU file into a dict: `points` (n, 3) [m], `connectivity`, `offsets` and `types` as VTK has them, `point_data`,
/// `cell_data` and `field_data` by name, `units` by name, `time` [s] or None.
#[pyfunction]
fn read_vtu(py: Python<'_>, path: PathBuf) -> PyResult<Bound<'_, PyDict>> {
    let grid = py.detach(|| Grid::read(&path)).map_err(unusable)?;
    let made = PyDict::new(py);
    let units = PyDict::new(py);
    for (name, arrays) in
        [("point_data", grid.point_data), ("cell_data", grid.cell_data), ("field_data", grid.field_data)]
    {
        let by_name = PyDict::new(py);
        for array in arrays {
            units.set_item(&array.name, &array.unit)?;
            by_name.set_item(array.name.clone(), numbers(py, array)?)?;
        }
        made.set_item(name, by_name)?;
    }
    made.set_item("units", units)?;
    made.set_item("points", rows(py, grid.points)?)?;
    made.set_item("connectivity", column(py, grid.connectivity.into_iter().map(i64::from).collect())?)?;
    made.set_item("offsets", column(py, grid.offsets.into_iter().map(i64::from).collect())?)?;
    made.set_item("types", column(py, grid.types)?)?;
    made.set_item("time", grid.time)?;
    Ok(made)
}

fn numbers(py: Python<'_>, array: Array) -> PyResult<Bound<'_, PyAny>> {
    let columns = array.components;
    match array.values {
        Values::Float32(values) => shaped(py, columns, values),
        Values::Float64(values) => shaped(py, columns, values),
        Values::Int32(values) => shaped(py, columns, values),
        Values::Int64(values) => shaped(py, columns, values),
        Values::UInt8(values) => shaped(py, columns, values),
    }
}

fn shaped<T: numpy::Element>(py: Python<'_>, columns: usize, values: Vec<T>) -> PyResult<Bound<'_, PyAny>> {
    if columns == 1 { column(py, values) } else { matrix(py, columns, values) }
}

pub fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(read_mesh, module)?)?;
    module.add_function(wrap_pyfunction!(write_mesh, module)?)?;
    module.add_function(wrap_pyfunction!(sound_mesh, module)?)?;
    module.add_function(wrap_pyfunction!(mesh_quality, module)?)?;
    module.add_function(wrap_pyfunction!(read_vtu, module)?)
}
