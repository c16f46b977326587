//! Gmsh's element types.

use crate::Shape;

/// What an element of a type is to a mesh of solids.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Role {
    /// A solid; its corners come first.
    Solid(Shape),
    /// A face with that many corners, which come first.
    Facet(usize),
    /// A point.
    Point,
    /// A line, or a solid or face of higher order than two.
    Other,
}

/// A type of element.
#[derive(Clone, Copy, Debug)]
pub(super) struct Kind {
    pub name: &'static str,
    pub nodes: usize,
    pub role: Role,
}

/// The type of that number, if it is one of Gmsh's common ones.
pub(super) fn kind(number: u64) -> Option<Kind> {
    let (name, nodes, role) = match number {
        1 => ("2-node lines", 2, Role::Other),
        2 => ("3-node triangles", 3, Role::Facet(3)),
        3 => ("4-node quadrilaterals", 4, Role::Facet(4)),
        4 => ("4-node tetrahedra", 4, Role::Solid(Shape::Tet4)),
        5 => ("8-node hexahedra", 8, Role::Solid(Shape::Hex8)),
        6 => ("6-node wedges", 6, Role::Solid(Shape::Wedge6)),
        7 => ("5-node pyramids", 5, Role::Solid(Shape::Pyramid5)),
        8 => ("3-node lines", 3, Role::Other),
        9 => ("6-node triangles", 6, Role::Facet(3)),
        10 => ("9-node quadrilaterals", 9, Role::Facet(4)),
        11 => ("10-node tetrahedra", 10, Role::Solid(Shape::Tet4)),
        12 => ("27-node hexahedra", 27, Role::Solid(Shape::Hex8)),
        13 => ("18-node wedges", 18, Role::Solid(Shape::Wedge6)),
        14 => ("14-node pyramids", 14, Role::Solid(Shape::Pyramid5)),
        15 => ("points", 1, Role::Point),
        16 => ("8-node quadrilaterals", 8, Role::Facet(4)),
        17 => ("20-node hexahedra", 20, Role::Solid(Shape::Hex8)),
        18 => ("15-node wedges", 15, Role::Solid(Shape::Wedge6)),
        19 => ("13-node pyramids", 13, Role::Solid(Shape::Pyramid5)),
        21 => ("10-node triangles", 10, Role::Other),
        26 => ("4-node lines", 4, Role::Other),
        29 => ("20-node tetrahedra", 20, Role::Other),
        36 => ("16-node quadrilaterals", 16, Role::Other),
        92 => ("64-node hexahedra", 64, Role::Other),
        _ => return None,
    };
    Some(Kind { name, nodes, role })
}

/// The type of a shape.
pub(super) const fn number(shape: Shape) -> u32 {
    match shape {
        Shape::Tet4 => 4,
        Shape::Hex8 => 5,
        Shape::Wedge6 => 6,
        Shape::Pyramid5 => 7,
    }
}

/// Why a block of elements cannot be used.
pub(super) fn unusable(number: u64, usable: &str) -> String {
    let name =
        kind(number).map_or_else(|| format!("elements of Gmsh's type {number}"), |k| k.name.to_owned());
    format!("{name} are not supported, only {usable}; set Mesh.ElementOrder = 1 and mesh again")
}

/// The solids that can be read.
pub(super) const SOLIDS: &str = "tetrahedra, pyramids, wedges and hexahedra of first or second order";
/// The faces that can be read.
pub(super) const FACETS: &str = "triangles and quadrilaterals of first or second order";
