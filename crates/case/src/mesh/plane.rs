//! `[[mesh.plane]]`: planes that cut generated ground.

use std::ops::Range;

use super::LENGTH;
use super::place::{DIPS, PlaneAt, THROUGH, TOWARDS};
use super::seam::{SEAM, Seam};
use crate::Spanned;
use crate::fields::Fields;
use crate::keys::{Key, Kind, Table};

pub(super) static PLANE: Table = Table {
    path: "mesh.plane",
    doc: "A plane that cuts generated ground, a fault or the border of a layer: nodes move onto it and elements part along it. One \
          that strikes along y, as the caverns do, leaves wedges alone; others divide elements into pyramids and tetrahedra as well. Its \
          sides are the groups `NAME.above` and `NAME.below`, beside those that are there: \
          all elements but linings and shotcrete that stay whole (`across`), which belong to neither; of a plane with an `extent` those that \
          touch it. An [[interface]] between the two lets it slide and open.",
    keys: &[
        Key::required("name", Kind::Name, "first part of the names of its groups"),
        THROUGH,
        DIPS,
        TOWARDS,
        Key::optional(
            "extent",
            LENGTH,
            "",
            "How far it reaches from the point, up and down the dip; left out: through all the ground",
        ),
        Key::default(
            "across",
            Kind::Word(&["cut", "whole"]),
            r#""cut""#,
            "Shotcrete of generated caverns that shares nodes with the rock, where an [[interface]] parts the sides of the plane: `cut` divides \
             it with the rock; `whole` leaves it whole, and it ties the two sides. Linings, and shotcrete that an [[interface]] separates \
             from the rock, stay whole under both",
        ),
        Key::optional(
            "seam",
            Kind::Table(&SEAM),
            "its sides share their nodes unless an [[interface]] parts them",
            "A thin layer in it, as an interface",
        ),
    ],
    choice: &[],
};

/// A plane that cuts generated ground.
#[derive(Clone, Debug, PartialEq)]
pub struct CutPlane {
    /// Unique; first part of the names of its groups.
    pub name: Spanned<String>,
    pub plane: PlaneAt,
    /// From the point up and down the dip, m; nothing: through all the ground.
    pub extent: Option<Spanned<f64>>,
    /// Whether shotcrete that shares nodes with the rock stays whole.
    pub whole: bool,
    /// A thin layer in it.
    pub seam: Option<Seam>,
    /// Its table in the case: the header, or the braces.
    pub span: Range<usize>,
}

impl CutPlane {
    pub(super) fn read(f: &Fields, x_azimuth: f64) -> Option<Self> {
        let extent = f.number("extent");
        let whole = f.text("across")?.value == "whole";
        let seam = match f.table("seam") {
            Some(seam) => Some(Seam::read(seam)?),
            None => None,
        };
        Some(CutPlane {
            name: f.text("name")?,
            plane: PlaneAt::read(f, x_azimuth)?,
            extent,
            whole,
            seam,
            span: f.span.clone(),
        })
    }
}
