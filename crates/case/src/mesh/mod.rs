//! `[mesh]`: where the mesh comes from.

mod bricks;
mod caverns;
mod ground;
mod lining;
mod place;
mod plane;
mod seam;

use std::path::PathBuf;

use tremolite_laws::parameter::Dimension;

pub use bricks::{Axis, MeshBox, MeshPart};
pub use caverns::{
    Cavern, CavernShape, Caverns, Gallery, GroundSurface, Length, Lining, RockLayer, Shotcrete,
};
pub use ground::Ground;
pub use lining::HoleLining;
pub use place::{GroupPlace, PlacedGroup, PlaneAt};
pub use plane::CutPlane;
pub(crate) use seam::check as check_seams;
pub use seam::{Seam, Stand};

use crate::fields::Fields;
use crate::keys::{Key, Kind, Limit, Table};
use crate::{Diagnostic, Spanned};

const LENGTH: Kind = Kind::Number(Dimension::LENGTH, Limit::Positive);
const COORDINATE: Kind = Kind::Number(Dimension::LENGTH, Limit::Any);

pub(crate) static MESH: Table = Table {
    path: "mesh",
    doc: "Where the mesh comes from: generated around caverns, a plain box, or a file.",
    keys: &[
        Key::optional(
            "caverns",
            Kind::Table(&caverns::CAVERNS),
            "",
            "A block of rock with caverns, generated",
        ),
        Key::optional("box", Kind::Table(&bricks::BOX), "", "A box of bricks"),
        Key::optional("file", Kind::Table(&FILE), "", "A mesh made by another program"),
        Key::optional("plane", Kind::Tables(&plane::PLANE), "", "Planes that cut generated ground"),
        Key::optional("group", Kind::Tables(&place::GROUP), "", "Groups by place, one after the other"),
        Key::optional("lining", Kind::Tables(&lining::LINING), "", "Linings of holes, one after the other"),
    ],
    choice: &[&["caverns"], &["box"], &["file"]],
};

static FILE: Table = Table {
    path: "mesh.file",
    doc: "A mesh made by another program.",
    keys: &[
        Key::required("path", Kind::File, "the file, relative to the case"),
        Key::default("unit", LENGTH, r#""1 m""#, "Length of one unit of the file's coordinates"),
        Key::default(
            "rotate",
            Kind::Number(Dimension::ANGLE, Limit::Any),
            r#""0 deg""#,
            "Angle by which the mesh is turned about the z axis through the origin as it is read, counter-clockwise seen from \
             above; every coordinate and stress of the case and its results, and model_x_azimuth, are in the axes after it",
        ),
        Key::optional(
            "encoding",
            Kind::Text,
            "",
            "Encoding of the file's text, where it is neither UTF-8 nor GB18030: \"big5\", \"shift_jis\", \"windows-1252\" …",
        ),
    ],
    choice: &[],
};

/// Where the mesh comes from.
#[derive(Clone, Debug, PartialEq)]
pub enum Mesh {
    /// Generated around caverns.
    Caverns(Caverns),
    /// A plain box.
    Box(MeshBox),
    /// Made by another program.
    File(MeshFile),
}

/// A mesh made by another program.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshFile {
    /// As written; relative to the case's directory.
    pub path: Spanned<PathBuf>,
    /// Length of one unit of the file's coordinates, m.
    pub unit: Spanned<f64>,
    /// Angle by which it is turned about the z axis, counter-clockwise seen from above, rad. All else in the case is meant
    /// in the axes after it.
    pub rotate: Spanned<f64>,
    /// Encoding of the file's text, as written.
    pub encoding: Option<Spanned<String>>,
}

impl Mesh {
    /// `x_azimuth` \[rad\] is that of the model's x axis.
    pub(crate) fn read(mesh: &Fields, x_azimuth: f64) -> Option<Mesh> {
        let caverns = mesh.table("caverns").map(|caverns| Caverns::read(caverns, x_azimuth));
        let boxes = mesh.table("box").map(MeshBox::read);
        let file = mesh.table("file").map(MeshFile::read);
        match (caverns, boxes, file) {
            (Some(caverns), ..) => caverns.map(Mesh::Caverns),
            (_, Some(mesh), _) => mesh.map(Mesh::Box),
            (_, _, Some(file)) => file.map(Mesh::File),
            _ => None,
        }
    }

    /// What lies between keys; looks at each value that is good, whatever the others are.
    pub(crate) fn check(mesh: &Fields, problems: &mut Vec<Diagnostic>) {
        if let Some(caverns) = mesh.table("caverns") {
            Caverns::check(caverns, problems);
        }
        if let Some(bricks) = mesh.table("box") {
            MeshBox::check(bricks, problems);
        }
        Ground::check(mesh, problems);
    }
}

impl MeshFile {
    fn read(f: &Fields) -> Option<Self> {
        let path = f.text("path")?;
        Some(MeshFile {
            path: Spanned::new(path.value.into(), path.span),
            unit: f.number("unit")?,
            rotate: f.number("rotate")?,
            encoding: f.text("encoding"),
        })
    }
}
