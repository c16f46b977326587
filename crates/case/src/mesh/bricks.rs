//! `[mesh.box]`: a box of bricks.

use std::ops::Range;

use tremolite_laws::parameter::Dimension;

use super::COORDINATE;
use crate::fields::Fields;
use crate::keys::{Key, Kind, Limit, Table};
use crate::{Diagnostic, Spanned};

const RATIO: Kind = Kind::Number(Dimension::NONE, Limit::Positive);

pub(super) static BOX: Table = Table {
    path: "mesh.box",
    doc: "A box of bricks, from and to along each axis.",
    keys: &[
        Key::required("x", Kind::Table(&AXIS), "extent along x"),
        Key::required("y", Kind::Table(&AXIS), "extent along y"),
        Key::required("z", Kind::Table(&AXIS), "extent along z, upwards"),
        Key::default(
            "group",
            Kind::Name,
            r#""rock""#,
            "Name of the group of all elements that are in no part",
        ),
        Key::optional(
            "part",
            Kind::Tables(&PART),
            "",
            "Parts of the box with groups of their own; where two meet, the later",
        ),
    ],
    choice: &[],
};

const RANGE: Kind = Kind::List(&COORDINATE, 2, 2);

static PART: Table = Table {
    path: "mesh.box.part",
    doc: "The elements of a box whose middle lies in a range of coordinates.",
    keys: &[
        Key::required("group", Kind::Name, "name of the group"),
        Key::optional("x", RANGE, "", "Smallest and largest x"),
        Key::optional("y", RANGE, "", "Smallest and largest y"),
        Key::optional("z", RANGE, "", "Smallest and largest z"),
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
    /// Name of the group of all elements that are in no part.
    pub group: Spanned<String>,
    /// Parts with groups of their own; where two meet, the later.
    pub parts: Vec<MeshPart>,
    /// Its table in the case: the header, or the braces.
    pub span: Range<usize>,
}

/// The elements of a box whose middle lies in a range of coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshPart {
    pub group: Spanned<String>,
    /// Smallest and largest x, y, z, m; nothing: all.
    pub ranges: [Option<Spanned<[f64; 2]>>; 3],
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
            parts: f.tables("part").map(MeshPart::read).collect::<Option<_>>()?,
            span: f.span.clone(),
        })
    }

    pub(super) fn check(f: &Fields, problems: &mut Vec<Diagnostic>) {
        for axis in ["x", "y", "z"].iter().filter_map(|name| f.table(name)) {
            if let (Some(from), Some(to)) = (axis.number("from"), axis.number("to"))
                && to.value <= from.value
            {
                problems.push(Diagnostic::at(&to, "`to` must be above `from`", "swap the two, or mend one"));
            }
        }
        let parts = f.tables("part");
        let ranges =
            parts.flat_map(|part| ["x", "y", "z"].into_iter().filter_map(|axis| part.numbers::<2>(axis)));
        problems.extend(ranges.filter(|range| range.value[0] >= range.value[1]).map(|range| {
            Diagnostic::at(&range, "the larger coordinate must stand second", "swap the two, or mend one")
        }));
    }
}

impl MeshPart {
    fn read(f: &Fields) -> Option<Self> {
        Some(MeshPart {
            group: f.text("group")?,
            ranges: ["x", "y", "z"].map(|axis| f.numbers(axis)),
            span: f.span.clone(),
        })
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
