//! `[[mesh.caverns.cavern]]`: one cavern and its lining.

use std::ops::Range;

use super::super::{COORDINATE, LENGTH};
use super::NOT_NEGATIVE;
use crate::fields::Fields;
use crate::keys::{Key, Kind, Table, When, words};
use crate::{Diagnostic, Spanned};

pub(super) static CAVERN: Table = Table {
    path: "mesh.caverns.cavern",
    doc: "One cavern.",
    keys: &[
        Key::required("name", Kind::Name, "first part of the names of its groups and points"),
        Key::default(
            "shape",
            Kind::Word(CavernShape::WORDS),
            "\"arch\"",
            "Its outline: a roof that is an arc or half an ellipse on straight walls, a rectangle, a horseshoe, a circle",
        ),
        Key::required("width", LENGTH, "clear width in x"),
        Key::required(
            "height",
            LENGTH,
            "height of the crown above the floor; of a circle the width, of a horseshoe 0.75 to 1.1 of it",
        ),
        Key::default(
            "arch_rise",
            NOT_NEGATIVE,
            r#""0 m""#,
            "Height of the crown above the springing of an arch or ellipse; 0 for other shapes",
        ),
        Key::default(
            "at",
            Kind::List(&COORDINATE, 2, 2),
            r#"["0 m", "0 m"]"#,
            "Centre line in x and lowest clear point in z, both from the first cavern's",
        ),
        Key::optional(
            "length",
            LENGTH,
            "that of the block",
            "Length along y, from end wall to end wall: beyond it is rock. End walls are plane, without lining and shotcrete",
        ),
        Key::default("middle", COORDINATE, r#""0 m""#, "Its middle along y, where its points then lie")
            .when(When::Beside("length")),
        Key::default(
            "benches",
            Kind::Count(50),
            "1",
            "Benches the excavation is cut into, each a group NAME.bench1 … from the top down, with the lining beside it in NAME.lining1 … and the shotcrete in NAME.shotcrete1 …",
        ),
        Key::optional("lining", Kind::Table(&LINING), "no lining", "Concrete lining"),
        Key::optional(
            "shotcrete",
            LENGTH,
            "no shotcrete",
            "Thickness of the shotcrete, the group NAME.shotcrete between rock and lining, or alone: on walls and crown, and under the invert of a closed outline",
        ),
        Key::default(
            "shotcrete_layers",
            Kind::Count(20),
            "1",
            "Elements through the thickness of the shotcrete",
        )
        .when(When::Beside("shotcrete")),
    ],
    choice: &[],
};

static LINING: Table = Table {
    path: "mesh.caverns.cavern.lining",
    doc: "Thickness of a cavern's lining.",
    keys: &[
        Key::required("walls", LENGTH, "thickness on the walls"),
        Key::required("crown", LENGTH, "thickness at the crown"),
        Key::default(
            "floor",
            NOT_NEGATIVE,
            r#""0 m""#,
            "Thickness on the floor or invert; 0: no lining there",
        ),
        Key::default("layers", Kind::Count(20), "1", "Elements through the thickness"),
    ],
    choice: &[],
};

words! {
    /// Outline of a cavern.
    CavernShape {
        /// Straight walls, a roof that is an arc of a circle.
        Arch = "arch",
        /// Straight walls, a roof that is half an ellipse.
        Ellipse = "ellipse",
        /// Straight walls, a flat roof.
        Rectangle = "rectangle",
        /// A semicircle over walls and an invert that are arcs.
        Horseshoe = "horseshoe",
        /// All round.
        Circle = "circle",
    }
}

impl CavernShape {
    fn has_rise(self) -> bool {
        matches!(self, CavernShape::Arch | CavernShape::Ellipse)
    }
}

/// One cavern. Lengths in m.
#[derive(Clone, Debug, PartialEq)]
pub struct Cavern {
    /// Unique; first part of the names of its groups and points.
    pub name: Spanned<String>,
    /// Its outline.
    pub shape: Spanned<CavernShape>,
    /// Clear width in x.
    pub width: Spanned<f64>,
    /// From floor to crown.
    pub height: Spanned<f64>,
    /// From the springing to the crown; below `height`, of an arch at most half the width; 0 for shapes other
    /// than arch and ellipse.
    pub arch_rise: Spanned<f64>,
    /// Centre line in x and floor in z, both from the first cavern's.
    pub at: Spanned<[f64; 2]>,
    /// Nothing: it goes through the block.
    pub length: Option<Length>,
    /// Benches of the excavation, each a group, and so are lining and shotcrete beside each.
    pub benches: Spanned<u32>,
    /// Nothing: no lining.
    pub lining: Option<Lining>,
    /// Nothing: no shotcrete.
    pub shotcrete: Option<Shotcrete>,
    /// Its table in the case: the header, or the braces.
    pub span: Range<usize>,
}

/// Where a cavern that is shorter than the block lies along y, m.
#[derive(Clone, Debug, PartialEq)]
pub struct Length {
    /// From end wall to end wall.
    pub length: Spanned<f64>,
    /// y of the middle between them.
    pub middle: Spanned<f64>,
}

/// Thickness of a lining, m.
#[derive(Clone, Debug, PartialEq)]
pub struct Lining {
    /// On the walls.
    pub walls: Spanned<f64>,
    /// At the crown.
    pub crown: Spanned<f64>,
    /// 0 where the floor has none.
    pub floor: Spanned<f64>,
    /// Elements through the thickness.
    pub layers: Spanned<u32>,
}

/// Shotcrete between rock and lining, or alone.
#[derive(Clone, Debug, PartialEq)]
pub struct Shotcrete {
    /// m
    pub thickness: Spanned<f64>,
    /// Elements through the thickness.
    pub layers: Spanned<u32>,
}

impl Cavern {
    pub(super) fn read(f: &Fields) -> Option<Self> {
        let lining = f.table("lining").map(Lining::read);
        Some(Cavern {
            name: f.text("name")?,
            shape: f.word("shape", CavernShape::from_word)?,
            width: f.number("width")?,
            height: f.number("height")?,
            arch_rise: f.number("arch_rise")?,
            at: f.numbers("at")?,
            length: match f.number("length") {
                Some(length) => Some(Length { length, middle: f.number("middle")? }),
                None => None,
            },
            benches: f.count("benches")?,
            lining: match lining {
                Some(lining) => Some(lining?),
                None => None,
            },
            shotcrete: match f.number("shotcrete") {
                Some(thickness) => Some(Shotcrete { thickness, layers: f.count("shotcrete_layers")? }),
                None => None,
            },
            span: f.span.clone(),
        })
    }

    /// What lies between its keys, and between them and the length of the block.
    pub(super) fn check(cavern: &Fields, block: Option<&Spanned<f64>>, problems: &mut Vec<Diagnostic>) {
        if let (Some(length), Some(block)) = (cavern.number("length"), block)
            && length.value > block.value
        {
            problems.push(Diagnostic::at(
                &length,
                "the cavern is longer than the block",
                "raise `length` of `mesh.caverns`, or leave this one out: the cavern then goes through the block",
            ));
        }
        let shape = cavern.word("shape", CavernShape::from_word);
        if let Some(shape) = &shape {
            let word = shape.value.word();
            match cavern.number("arch_rise") {
                Some(rise) if shape.value.has_rise() && rise.value == 0.0 => {
                    let message = format!("`arch_rise` must be above 0 where `shape` is \"{word}\"");
                    let remedy = "give the crown's height above the springing, or `shape = \"rectangle\"`";
                    problems.push(Diagnostic::at(&rise, message, remedy));
                }
                Some(rise) if !shape.value.has_rise() && rise.value > 0.0 => {
                    let message = format!("`arch_rise` has no meaning where `shape` is \"{word}\"");
                    let remedy = "leave it out, or choose the shape \"arch\" or \"ellipse\"";
                    problems.push(Diagnostic::at(&rise, message, remedy));
                }
                _ => {}
            }
        }
        if let (Some(rise), Some(width)) = (cavern.number("arch_rise"), cavern.number("width"))
            && shape.is_some_and(|s| s.value == CavernShape::Arch)
            && rise.value > width.value / 2.0
        {
            problems.push(Diagnostic::at(
                &rise,
                "`arch_rise` is more than half the width",
                "the crown is an arc: at most a semicircle, `arch_rise` half of `width`",
            ));
        }
        if let (Some(rise), Some(height)) = (cavern.number("arch_rise"), cavern.number("height"))
            && rise.value >= height.value
        {
            problems.push(Diagnostic::at(
                &rise,
                "`arch_rise` must be below `height`",
                "`height` is measured from the floor to the crown, the arch included",
            ));
        }
    }
}

impl Lining {
    fn read(f: &Fields) -> Option<Self> {
        Some(Lining {
            walls: f.number("walls")?,
            crown: f.number("crown")?,
            floor: f.number("floor")?,
            layers: f.count("layers")?,
        })
    }
}
