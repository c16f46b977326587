//! `[[mesh.caverns.gallery]]`: a gallery across.

use super::super::{COORDINATE, LENGTH};
use crate::Spanned;
use crate::fields::Fields;
use crate::keys::{Key, Kind, Table};

pub(super) static GALLERY: Table = Table {
    path: "mesh.caverns.gallery",
    doc: "A rectangular gallery across between two caverns with straight walls, from lining to lining. Its rock is the group \
          `NAME.gallery`, the linings and shotcrete it passes `NAME.opening`. Cuts between benches nearer to its floor or roof than a \
          quarter of `size_near` move there.",
    keys: &[
        Key::required("name", Kind::Name, "first part of the names of its groups"),
        Key::required("between", Kind::List(&Kind::Name, 2, 2), "names of the two caverns"),
        Key::required(
            "at",
            Kind::List(&COORDINATE, 2, 2),
            "middle in y, and floor in z above the first cavern's floor: at 0 its floor is level with the cavern's; else anywhere on the straight wall below the springing",
        ),
        Key::required("width", LENGTH, "width along y"),
        Key::required("height", LENGTH, "height"),
    ],
    choice: &[],
};

/// A gallery across. Lengths in m.
#[derive(Clone, Debug, PartialEq)]
pub struct Gallery {
    /// First part of the names of its groups.
    pub name: Spanned<String>,
    /// Names of the two caverns.
    pub between: [Spanned<String>; 2],
    /// Middle in y, and floor in z from the first cavern's.
    pub at: Spanned<[f64; 2]>,
    /// Along y.
    pub width: Spanned<f64>,
    /// Along z.
    pub height: Spanned<f64>,
}

impl Gallery {
    pub(super) fn read(f: &Fields) -> Option<Self> {
        Some(Gallery {
            name: f.text("name")?,
            between: f.texts("between").try_into().ok()?,
            at: f.numbers("at")?,
            width: f.number("width")?,
            height: f.number("height")?,
        })
    }
}
