//! Why a plane does not cut a mesh.

use std::fmt;

use super::LEAST_JACOBIAN;

/// The way that is always open.
const GMSH: &str = "mesh the ground with the plane in Gmsh and read it as [mesh.file] (docs/meshes.md)";

/// Why a plane does not cut a mesh.
#[derive(Clone, Debug, PartialEq)]
pub enum CutError {
    /// The mesh has such a group.
    Known { name: String, group: String },
    /// The section is not the same all along y.
    Section { name: String },
    /// No two sides of it have elements.
    Misses { name: String },
    /// No way of nodes leads along it; at x and z.
    NoWay { name: String, at: [f64; 2] },
    /// Elements come out too poor.
    Poor { name: String, jacobian: f64, at: [f64; 3] },
}

impl CutError {
    /// The plane that is meant.
    pub fn plane(&self) -> &str {
        match self {
            Self::Known { name, .. }
            | Self::Section { name }
            | Self::Misses { name }
            | Self::NoWay { name, .. }
            | Self::Poor { name, .. } => name,
        }
    }
}

impl fmt::Display for CutError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Known { name, group } => {
                write!(f, "the mesh has a group '{group}' already; give the plane '{name}' another name")
            }
            Self::Section { name } => write!(
                f,
                "plane '{name}' meets ground whose section is not the same all along y; let the ground's surface not vary along y, or \
                 {GMSH}"
            ),
            Self::Misses { name } => write!(
                f,
                "plane '{name}' parts nothing: all elements lie on one side of it; move `through` or raise `extent`"
            ),
            Self::NoWay { name, at: [x, z] } => write!(
                f,
                "no nodes near plane '{name}' can be moved onto it about x = {x:.1} m, z = {z:.1} m without leaving elements too poor; move \
                 `through` by half an element, lower `size_near`, or {GMSH}"
            ),
            Self::Poor { name, jacobian, at: [x, y, z] } => write!(
                f,
                "plane '{name}' cannot be meshed at ({x:.1}, {y:.1}, {z:.1}) m: it would distort an element there to a scaled Jacobian of \
                 {jacobian:.3}, and {LEAST_JACOBIAN} is the least allowed; move `through` by half an element, lower `size_near`, or {GMSH}"
            ),
        }
    }
}

impl std::error::Error for CutError {}
