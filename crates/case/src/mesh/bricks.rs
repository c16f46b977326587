//! `[mesh.box]`: a box of bricks.

use std::ops::Range;

use tremolite_laws::parameter::Dimension;

use super::COORDINATE;
use crate::fields::Fields;
use crate::keys::{Key, Kind, Limit, Table};
use crate::{Problem, Spanned};

const RATIO: Kind = Kind::Number(Dimension::NONE, Limit::Positive);

pub(super) static BOX: Table = Table {
    path: "mesh.box",
    doc: "A box of bricks, from and to along each axis.",
    keys: &[
        Key::required("x", Kind::Table(&AXIS), "extent along x"),
        Key::required("y", Kind::Table(&AXIS), "extent along y"),
        Key::required("z", Kind::Table(&AXIS), "extent along z, upwards"),
        Key::default("group", Kind::Name, r#""rock""#, "Name of the group of all elements"),
    ],
    choice: &[],
};

static AXIS: Table = Table {
    path: "mesh.box.x",
    doc: "Extent and elements along one axis.",
    keys: &[
        Key::default("from", COORDINATE, r#""0 m""#, "Smallest coordinate"),
        Key::required("to", COORDINATE, "largest coordinate"),
        Key::required("elements", Kind::Count(100_000), "number of elements"),
        Key::default("growth", RATIO, "1", "Size of an element over that of the one before it"),
    ],
    choice: &[],
};

/// A box of bricks.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshBox {
    /// x, y, z.
    pub axes: [Axis; 3],
    /// Name of the group of all elements.
    pub group: Spanned<String>,
    /// Its table in the case: the header, or the braces.
    pub span: Range<usize>,
}

/// Extent and elements of a box along one axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// m
    pub from: Spanned<f64>,
    /// m, above `from`
    pub to: Spanned<f64>,
    /// Number of elements.
    pub elements: Spanned<u32>,
    /// Size of an element over that of the one before it, towards larger coordinates.
    pub growth: Spanned<f64>,
}

impl MeshBox {
    pub(super) fn read(f: &Fields) -> Option<Self> {
        let axis = |name| f.table(name).and_then(Axis::read);
        Some(MeshBox {
            axes: [axis("x")?, axis("y")?, axis("z")?],
            group: f.text("group")?,
            span: f.span.clone(),
        })
    }

    pub(super) fn check(f: &Fields, problems: &mut Vec<Problem>) {
        for axis in ["x", "y", "z"].iter().filter_map(|name| f.table(name)) {
            if let (Some(from), Some(to)) = (axis.number("from"), axis.number("to"))
                && to.value <= from.value
            {
                problems.push(Problem::at(&to, "`to` must be above `from`", "swap the two, or mend one"));
            }
        }
    }
}

impl Axis {
    fn read(f: &Fields) -> Option<Self> {
        Some(Axis {
            from: f.number("from")?,
            to: f.number("to")?,
            elements: f.count("elements")?,
            growth: f.number("growth")?,
        })
    }
}
