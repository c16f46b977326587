//! `[[mesh.group]]`: groups by place, in generated meshes and in those that are read.

use std::f64::consts::{FRAC_PI_2, PI};
use std::ops::Range;

use tremolite_laws::parameter::Dimension;

use super::{COORDINATE, LENGTH};
use crate::fields::{Fields, Node};
use crate::keys::{Key, Kind, Limit, Table};
use crate::{Diagnostic, Spanned};

pub(super) const POINT: Kind = Kind::List(&COORDINATE, 3, 3);
const DIP: Kind = Kind::Number(Dimension::ANGLE, Limit::Within(90.0 * PI / 180.0));
const DIRECTION: Kind = Kind::Number(Dimension::ANGLE, Limit::Any);

pub(super) const THROUGH: Key = Key::required("through", POINT, "a point of the plane");
pub(super) const DIPS: Key =
    Key::required("dip", DIP, "angle at which it falls, from level (0 deg) to upright (90 deg)");
pub(super) const TOWARDS: Key = Key::required(
    "dip_azimuth",
    DIRECTION,
    "direction in which it falls, clockwise from north; y is north unless `model_x_azimuth` says otherwise",
);

pub(super) static GROUP: Table = Table {
    path: "mesh.group",
    doc: "A group of the elements whose middle, the mean of their nodes, lies in a place. They leave the groups that they are taken \
          of, and stay in all others. What takes nothing, takes all that a group has, or takes what another entry has is refused.",
    keys: &[
        Key::required("name", Kind::Name, "name of the group, which no other has"),
        Key::optional(
            "of",
            Kind::List(&Kind::Text, 1, 1000),
            "",
            "Groups that it is taken of, * stands for any text; left out: `rock` and its layers of generated caverns, any group of other \
             meshes; those of earlier entries only where they are named",
        ),
        Key::optional(
            "box",
            Kind::List(&POINT, 2, 2),
            "",
            "Two opposite corners, with edges along x, y and z",
        ),
        Key::optional("halfspace", Kind::Table(&HALFSPACE), "", "All on one side of a plane"),
        Key::optional(
            "cylinder",
            Kind::Table(&CYLINDER),
            "",
            "Between two points, round the line through them",
        ),
        Key::optional("between", Kind::Table(&BETWEEN), "", "Between two levels, or between two planes"),
    ],
    choice: &[&["box"], &["halfspace"], &["cylinder"], &["between"]],
};

static HALFSPACE: Table = Table {
    path: "mesh.group.halfspace",
    doc: "All on one side of a plane.",
    keys: &[
        THROUGH,
        DIPS,
        TOWARDS,
        Key::required(
            "side",
            Kind::Word(&["above", "below"]),
            "the side of the plane; of an upright one `above` is where it would dip to",
        ),
    ],
    choice: &[],
};

static CYLINDER: Table = Table {
    path: "mesh.group.cylinder",
    doc: "A round cylinder with plane ends.",
    keys: &[
        Key::required("from", POINT, "one end of its axis"),
        Key::required("to", POINT, "the other end"),
        Key::required("radius", LENGTH, "its radius"),
    ],
    choice: &[],
};

static BETWEEN: Table = Table {
    path: "mesh.group.between",
    doc: "Between two levels, or below one plane and above another.",
    keys: &[
        Key::optional("levels", Kind::List(&COORDINATE, 2, 2), "", "Two levels, z"),
        Key::optional("planes", Kind::Tables(&PLANE), "", "The upper plane, then the lower one"),
    ],
    choice: &[&["levels"], &["planes"]],
};

static PLANE: Table = Table {
    path: "mesh.group.between.planes",
    doc: "A plane.",
    keys: &[THROUGH, DIPS, TOWARDS],
    choice: &[],
};

/// A group by place.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedGroup {
    /// Unique.
    pub name: Spanned<String>,
    /// Patterns of the groups that it is taken of; empty: all ground.
    pub of: Vec<Spanned<String>>,
    pub place: GroupPlace,
    /// Its table in the case: the header, or the braces.
    pub span: Range<usize>,
}

/// A plane as geologists give it.
#[derive(Clone, Debug, PartialEq)]
pub struct PlaneAt {
    /// m
    pub through: Spanned<[f64; 3]>,
    /// From 0 to π/2.
    pub dip: Spanned<f64>,
    /// Direction in which it falls, clockwise from the model's y seen from above, rad.
    pub dip_direction: Spanned<f64>,
}

/// Where the elements of a group lie. Lengths in m.
#[derive(Clone, Debug, PartialEq)]
pub enum GroupPlace {
    /// Two opposite corners.
    Box([Spanned<[f64; 3]>; 2]),
    /// One side of a plane.
    Halfspace { plane: PlaneAt, above: bool },
    /// The ends of the axis, and the radius.
    Cylinder { ends: [Spanned<[f64; 3]>; 2], radius: Spanned<f64> },
    /// Two z, in any order.
    Levels(Spanned<[f64; 2]>),
    /// Below the first plane and above the second.
    Planes([PlaneAt; 2]),
}

impl PlacedGroup {
    pub(super) fn read(f: &Fields, x_azimuth: f64) -> Option<Self> {
        let of = f.texts("of");
        let corners = f.get("box").map(|node| node.list());
        let (halfspace, cylinder, between) = (f.table("halfspace"), f.table("cylinder"), f.table("between"));
        let place = if let Some([one, other]) = corners {
            GroupPlace::Box([one.numbers()?, other.numbers()?])
        } else if let Some(half) = halfspace {
            GroupPlace::Halfspace {
                plane: PlaneAt::read(half, x_azimuth)?,
                above: half.text("side")?.value == "above",
            }
        } else if let Some(round) = cylinder {
            let ends = [round.numbers("from")?, round.numbers("to")?];
            GroupPlace::Cylinder { ends, radius: round.number("radius")? }
        } else {
            let between = between?;
            match (between.numbers("levels"), planes(between, x_azimuth)) {
                (Some(levels), _) => GroupPlace::Levels(levels),
                (None, planes) => GroupPlace::Planes(planes?),
            }
        };
        Some(PlacedGroup { name: f.text("name")?, of, place, span: f.span.clone() })
    }

    /// What lies between keys of an entry.
    pub(super) fn check(f: &Fields, problems: &mut Vec<Diagnostic>) {
        if let Some(round) = f.table("cylinder")
            && let (Some(from), Some(to)) = (round.numbers::<3>("from"), round.numbers::<3>("to"))
            && from.value == to.value
        {
            problems.push(Diagnostic::at(
                &to,
                "the axis has no length",
                "give its two ends, `from` and `to`",
            ));
        }
        check_box(f, problems);
        if let Some(between) = f.table("between")
            && let Some(node) = between.get("planes")
            && between.tables("planes").count() != 2
        {
            let message = format!("{} planes, where two are wanted", between.tables("planes").count());
            problems.push(Diagnostic::new(
                node.span.clone(),
                message,
                "give the upper plane, then the lower one",
            ));
        }
        if let Some(levels) = f.table("between").and_then(|between| between.numbers::<2>("levels"))
            && levels.value[0] == levels.value[1]
        {
            problems.push(Diagnostic::at(
                &levels,
                "nothing lies between a level and itself",
                "give two levels",
            ));
        }
    }
}

/// Whether a box has an extent.
pub(super) fn check_box(f: &Fields, problems: &mut Vec<Diagnostic>) {
    if let Some([one, other]) = f.get("box").map(Node::list)
        && let (Some(one), Some(other)) = (one.numbers::<3>(), other.numbers::<3>())
        && let Some(axis) = (0..3).find(|&i| one.value[i] == other.value[i])
    {
        let message = format!("the box has no extent along {}", ["x", "y", "z"][axis]);
        problems.push(Diagnostic::at(&other, message, "give two opposite corners"));
    }
}

/// Both planes.
fn planes(f: &Fields, x_azimuth: f64) -> Option<[PlaneAt; 2]> {
    f.tables("planes")
        .map(|plane| PlaneAt::read(plane, x_azimuth))
        .collect::<Option<Vec<_>>>()?
        .try_into()
        .ok()
}

impl PlaneAt {
    pub(super) fn read(f: &Fields, x_azimuth: f64) -> Option<Self> {
        let mut dip_direction = f.number("dip_azimuth")?;
        dip_direction.value -= x_azimuth - FRAC_PI_2;
        Some(PlaneAt { through: f.numbers("through")?, dip: f.number("dip")?, dip_direction })
    }
}
