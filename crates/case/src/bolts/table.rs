//! The keys of bolts.

use std::f64::consts::PI;

use tremolite_laws::parameter::Dimension;

use super::{BoltedFaces, Plate};
use crate::keys::{Key, Kind, Limit, Table, When};

const COORDINATE: Kind = Kind::Number(Dimension::LENGTH, Limit::Any);
const LENGTH: Kind = Kind::Number(Dimension::LENGTH, Limit::Positive);
const POINT: Kind = Kind::List(&COORDINATE, 3, 3);
const RATIO: Kind = Kind::Number(Dimension::NONE, Limit::Any);
const FORCE: Kind = Kind::Number(Dimension::FORCE, Limit::Positive);
const STRESS: Kind = Kind::Number(Dimension::PRESSURE, Limit::Positive);
/// Keys that have a meaning for a pattern alone.
const OF_A_PATTERN: When = When::Beside("pattern");
/// Bolts in a list of points; longer ones are files.
const MOST_POINTS: usize = 10_000;

/// What may stand at `bolts` of a stage: entries, or one alone.
pub(crate) const BOLTS_KIND: Kind = Kind::Either(&[Kind::Tables(&BOLTS), Kind::Table(&BOLTS)]);

pub(crate) static BOLTS: Table = Table {
    path: "stage.bolts",
    doc: "Rock bolts or anchors that a stage places: by a pattern on the faces that it exposes, by points, or by a file.",
    keys: &[
        Key::optional(
            "name",
            Kind::Text,
            "its pattern (or \"bolts\") and the stage, as in \"crown of bench 1\"",
            "What they are called in results; unique in the case",
        ),
        Key::optional(
            "pattern",
            Kind::Word(BoltedFaces::WORDS),
            "",
            "Which of the faces that the stage exposes are bolted: crown, walls, or both (systematic); never the floor",
        ),
        Key::optional(
            "points",
            Kind::List(&Kind::List(&POINT, 2, 2), 1, MOST_POINTS),
            "",
            "Each bolt by its head and its other end, [[x, y, z], [x, y, z]]",
        ),
        Key::optional(
            "file",
            Kind::File,
            "",
            "CSV file, a bolt a row: x1,y1,z1,x2,y2,z2 in m, head first, with or without these names in its first line",
        ),
        Key::optional(
            "on",
            Kind::List(&Kind::Text, 1, 1000),
            "all faces that the stage exposes",
            "Groups on either side of the faces that are bolted: what is excavated or what stands; * stands for any text",
        )
        .when(OF_A_PATTERN),
        Key::required(
            "spacing",
            Kind::Either(&[LENGTH, Kind::List(&LENGTH, 2, 2)]),
            "distance between bolts: one, or two, between rows along the cavern and around it in a row",
        )
        .when(OF_A_PATTERN),
        Key::required("length", LENGTH, "length of each bolt from the wall").when(OF_A_PATTERN),
        Key::default(
            "direction",
            Kind::Either(&[Kind::Word(&["normal"]), Kind::List(&RATIO, 3, 3)]),
            r#""normal""#,
            "Where they point: \"normal\" to the face, or along [x, y, z], in the sense that leads into the rock",
        )
        .when(OF_A_PATTERN),
        Key::required("diameter", Kind::Number(Dimension::LENGTH, Limit::UpTo(1.0)), "diameter of the steel"),
        Key::default("young", STRESS, r#""200 GPa""#, "Young's modulus of the steel"),
        Key::optional(
            "yield",
            STRESS,
            "never: the steel stays elastic whatever its force",
            "Stress at which the steel yields, in tension and in compression",
        ),
        Key::optional(
            "breaking_strain",
            Kind::Number(Dimension::NONE, Limit::UpTo(1.0)),
            "never: however far it is drawn, it does not break",
            "Strain at which the steel breaks, plastic strain included",
        ),
        Key::optional("pretension", FORCE, "none", "Tension kept through the stage that places them; from then on their length is kept"),
        Key::optional(
            "free_length",
            LENGTH,
            "none: bonded from the head on",
            "Length from the head on which they touch nothing; needs a plate at the head",
        ),
        Key::default(
            "plate",
            Kind::Either(&[Kind::Word(Plate::WORDS), Kind::Flag]),
            r#""none""#,
            "Where a plate holds the bolt to the rock: head (or true), both ends, or none (or false)",
        ),
        Key::optional(
            "bond",
            Kind::Table(&BOND),
            "none: they move with the rock",
            "How they are grouted, where they may slip along the rock",
        ),
    ],
    choice: &[&["pattern"], &["points"], &["file"]],
};

pub(crate) static BOND: Table = Table {
    path: "stage.bolts.bond",
    doc: "How a bolt is joined to the rock along its length.",
    keys: &[
        Key::required(
            "stiffness",
            STRESS,
            "force per length of bolt and slip, about the shear modulus of the grout",
        ),
        Key::required(
            "strength",
            Kind::Number(Dimension::FRACTURE_ENERGY, Limit::Positive),
            "force per length at which it slips, without confinement",
        ),
        Key::default(
            "friction_angle",
            Kind::Number(Dimension::ANGLE, Limit::Within(80.0 * PI / 180.0)),
            r#""0 deg""#,
            "Friction on the steel's perimeter by the stress that the rock had across it when the stage began",
        ),
        Key::optional(
            "segment",
            LENGTH,
            "cut where it leaves an element alone",
            "Longest segment of a bolt, where √(EA/stiffness), the length over which force is passed on, must be resolved",
        ),
    ],
    choice: &[],
};
