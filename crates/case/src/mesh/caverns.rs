//! `[mesh.caverns]`: a block of rock with caverns, generated.

use std::collections::BTreeSet;
use std::ops::Range;

use tremolite_laws::parameter::Dimension;

use super::{COORDINATE, LENGTH};
use crate::fields::Fields;
use crate::keys::{Key, Kind, Limit, Table, When, words};
use crate::{Problem, Spanned};

const ANGLE: Kind = Kind::Number(Dimension::ANGLE, Limit::Any);
const DIP: Kind = Kind::Number(Dimension::ANGLE, Limit::NotNegative);
const PLACES: Kind = Kind::List(&COORDINATE, 1, 100_000);
const NOT_NEGATIVE: Kind = Kind::Number(Dimension::LENGTH, Limit::NotNegative);

pub(super) static CAVERNS: Table = Table {
    path: "mesh.caverns",
    doc: "A block of rock with caverns along y, generated. x runs across the caverns, from the first one's axis; y from \
          the middle of the block; z upwards from the ground.",
    keys: &[
        Key::required("overburden", LENGTH, "rock from the ground down to the first cavern's crown"),
        Key::required("below", LENGTH, "rock from the lowest floor down to the base of the block"),
        Key::required("sides", LENGTH, "rock from the outermost linings to the sides of the block"),
        Key::required("length", LENGTH, "length of the block along the caverns"),
        Key::required("near", LENGTH, "element size at the caverns"),
        Key::required("far", LENGTH, "element size far from the caverns"),
        Key::optional("along", LENGTH, "the size `near`", "Element size along the caverns"),
        Key::required("cavern", Kind::Tables(&CAVERN), "the caverns"),
        Key::optional(
            "gallery",
            Kind::Tables(&GALLERY),
            "",
            "Straight galleries across, between two caverns",
        ),
        Key::optional("layer", Kind::Tables(&LAYER), "", "Layers of rock, from the ground down"),
        Key::optional(
            "ground",
            Kind::Table(&GROUND),
            "",
            "Surface of the ground; without it level, at z = 0",
        ),
    ],
    choice: &[],
};

static CAVERN: Table = Table {
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
        Key::default("benches", Kind::Count(50), "1", "Benches the excavation is cut into, each a group"),
        Key::optional("lining", Kind::Table(&LINING), "no lining", "Concrete lining"),
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

static LAYER: Table = Table {
    path: "mesh.caverns.layer",
    doc: "A layer of rock under a plane, down to the next layer's plane. Its elements are the group `rock.NAME`, beside \
          `rock`.",
    keys: &[
        Key::required("name", Kind::Name, "last part of the name of its group"),
        Key::default(
            "depth",
            NOT_NEGATIVE,
            r#""0 m""#,
            "Upper plane below z = 0 at x = y = 0; 0 for the first",
        ),
        Key::default("dip", DIP, r#""0 deg""#, "Angle at which the upper plane falls; 0 for the first"),
        Key::default("dip_direction", ANGLE, r#""0 deg""#, "Direction in which it falls, from x towards y"),
    ],
    choice: &[],
};

static GALLERY: Table = Table {
    path: "mesh.caverns.gallery",
    doc: "A rectangular gallery across between two caverns with straight walls. Its rock is the group `NAME.gallery`, the \
          linings it passes `NAME.opening`.",
    keys: &[
        Key::required("name", Kind::Name, "first part of the names of its groups"),
        Key::required("between", Kind::List(&Kind::Name, 2, 2), "names of the two caverns"),
        Key::required(
            "at",
            Kind::List(&COORDINATE, 2, 2),
            "middle in y, and floor in z above the first cavern's lowest clear point",
        ),
        Key::required("width", LENGTH, "width along y"),
        Key::required("height", LENGTH, "height"),
    ],
    choice: &[],
};

static GROUND: Table = Table {
    path: "mesh.caverns.ground",
    doc: "Surface of the ground: a plane through z = 0 at x = y = 0, or a table of heights above z = 0. The rock above \
          the caverns is stretched to meet it.",
    keys: &[
        Key::optional("slope", Kind::List(&ANGLE, 2, 2), "", "Angles at which it rises along x and along y"),
        Key::optional("heights", PLACES, "", "Heights, for each of `y` those at all of `x`"),
        Key::optional(
            "x",
            PLACES,
            "",
            "Places of the heights along x, rising; beyond them the ground is level",
        )
        .when(When::Beside("heights")),
        Key::optional("y", PLACES, "", "Places along y, rising; without it the heights are the same along y")
            .when(When::Beside("heights")),
    ],
    choice: &[&["slope"], &["heights"]],
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

/// A block of rock with caverns along y. Lengths in m.
#[derive(Clone, Debug, PartialEq)]
pub struct Caverns {
    /// From the ground down to the first cavern's crown.
    pub overburden: Spanned<f64>,
    /// From the lowest floor down to the base.
    pub below: Spanned<f64>,
    /// From the outermost linings to the sides.
    pub sides: Spanned<f64>,
    /// Length of the block along y.
    pub length: Spanned<f64>,
    /// Element size at the caverns.
    pub near: Spanned<f64>,
    /// Element size far from the caverns.
    pub far: Spanned<f64>,
    /// Element size along y; nothing: `near`.
    pub along: Option<Spanned<f64>>,
    /// At least one, names unique.
    pub caverns: Vec<Cavern>,
    /// From the ground down; names unique.
    pub layers: Vec<RockLayer>,
    /// Across, between caverns.
    pub galleries: Vec<Gallery>,
    /// Nothing: level, at z = 0.
    pub ground: Option<Ground>,
    /// Its table in the case: the header, or the braces.
    pub span: Range<usize>,
}

/// A layer of rock.
#[derive(Clone, Debug, PartialEq)]
pub struct RockLayer {
    /// Unique; last part of the name of its group.
    pub name: Spanned<String>,
    /// Upper plane below z = 0 at x = y = 0, m; 0 for the first layer.
    pub depth: Spanned<f64>,
    /// rad
    pub dip: Spanned<f64>,
    /// Direction in which the upper plane falls, from x towards y, rad.
    pub dip_direction: Spanned<f64>,
}

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

/// Surface of the ground above z = 0.
#[derive(Clone, Debug, PartialEq)]
pub enum Ground {
    /// Angles at which it rises along x and along y, rad.
    Slope(Spanned<[f64; 2]>),
    /// Heights at places, m.
    Heights {
        /// Rising.
        x: Vec<f64>,
        /// Rising; empty: the same heights along y.
        y: Vec<f64>,
        /// For each of `y` those at all of `x`.
        heights: Vec<f64>,
    },
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
    /// Benches of the excavation, each a group.
    pub benches: Spanned<u32>,
    /// Nothing: no lining.
    pub lining: Option<Lining>,
    /// Its table in the case: the header, or the braces.
    pub span: Range<usize>,
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

impl Caverns {
    pub(super) fn read(f: &Fields) -> Option<Self> {
        let caverns: Vec<Option<Cavern>> = f.tables("cavern").map(Cavern::read).collect();
        let along = f.number("along");
        let layers: Vec<Option<RockLayer>> = f.tables("layer").map(RockLayer::read).collect();
        let galleries: Vec<Option<Gallery>> = f.tables("gallery").map(Gallery::read).collect();
        let ground = f.table("ground").map(Ground::read);
        Some(Caverns {
            overburden: f.number("overburden")?,
            below: f.number("below")?,
            sides: f.number("sides")?,
            length: f.number("length")?,
            near: f.number("near")?,
            far: f.number("far")?,
            along,
            caverns: caverns.into_iter().collect::<Option<_>>()?,
            layers: layers.into_iter().collect::<Option<_>>()?,
            galleries: galleries.into_iter().collect::<Option<_>>()?,
            ground: match ground {
                Some(ground) => Some(ground?),
                None => None,
            },
            span: f.span.clone(),
        })
    }

    pub(super) fn check(f: &Fields, problems: &mut Vec<Problem>) {
        if let (Some(near), Some(far)) = (f.number("near"), f.number("far"))
            && near.value > far.value
        {
            problems.push(Problem::at(
                &near,
                "`near` is larger than `far`",
                "elements grow from `near` at the caverns to `far`: give `near` the smaller size",
            ));
        }
        let mut names = BTreeSet::new();
        for cavern in f.tables("cavern") {
            let shape = cavern.word("shape", CavernShape::from_word);
            if let Some(shape) = &shape {
                let word = shape.value.word();
                match cavern.number("arch_rise") {
                    Some(rise) if shape.value.has_rise() && rise.value == 0.0 => {
                        let message = format!("`arch_rise` must be above 0 where `shape` is \"{word}\"");
                        let remedy =
                            "give the crown's height above the springing, or `shape = \"rectangle\"`";
                        problems.push(Problem::at(&rise, message, remedy));
                    }
                    Some(rise) if !shape.value.has_rise() && rise.value > 0.0 => {
                        let message = format!("`arch_rise` has no meaning where `shape` is \"{word}\"");
                        let remedy = "leave it out, or choose the shape \"arch\" or \"ellipse\"";
                        problems.push(Problem::at(&rise, message, remedy));
                    }
                    _ => {}
                }
            }
            if let (Some(rise), Some(width)) = (cavern.number("arch_rise"), cavern.number("width"))
                && shape.is_some_and(|s| s.value == CavernShape::Arch)
                && rise.value > width.value / 2.0
            {
                problems.push(Problem::at(
                    &rise,
                    "`arch_rise` is more than half the width",
                    "the crown is an arc: at most a semicircle, `arch_rise` half of `width`",
                ));
            }
            if let (Some(rise), Some(height)) = (cavern.number("arch_rise"), cavern.number("height"))
                && rise.value >= height.value
            {
                problems.push(Problem::at(
                    &rise,
                    "`arch_rise` must be below `height`",
                    "`height` is measured from the floor to the crown, the arch included",
                ));
            }
            if let Some(name) = cavern.text("name")
                && !names.insert(name.value.clone())
            {
                let message = format!("two caverns are called `{}`", name.value);
                problems.push(Problem::at(&name, message, "give each cavern its own name"));
            }
        }
    }
}

impl Cavern {
    fn read(f: &Fields) -> Option<Self> {
        let lining = f.table("lining").map(Lining::read);
        Some(Cavern {
            name: f.text("name")?,
            shape: f.word("shape", CavernShape::from_word)?,
            width: f.number("width")?,
            height: f.number("height")?,
            arch_rise: f.number("arch_rise")?,
            at: f.numbers("at")?,
            benches: f.count("benches")?,
            lining: match lining {
                Some(lining) => Some(lining?),
                None => None,
            },
            span: f.span.clone(),
        })
    }
}

impl RockLayer {
    fn read(f: &Fields) -> Option<Self> {
        Some(RockLayer {
            name: f.text("name")?,
            depth: f.number("depth")?,
            dip: f.number("dip")?,
            dip_direction: f.number("dip_direction")?,
        })
    }
}

impl Gallery {
    fn read(f: &Fields) -> Option<Self> {
        Some(Gallery {
            name: f.text("name")?,
            between: f.texts("between").try_into().ok()?,
            at: f.numbers("at")?,
            width: f.number("width")?,
            height: f.number("height")?,
        })
    }
}

impl Ground {
    fn read(f: &Fields) -> Option<Self> {
        let places = |key| f.list(key).iter().filter_map(|n| Some(n.number()?.value)).collect::<Vec<f64>>();
        let (x, y, heights) = (places("x"), places("y"), places("heights"));
        match f.numbers("slope") {
            Some(slope) => Some(Ground::Slope(slope)),
            None if heights.is_empty() => None,
            None => Some(Ground::Heights { x, y, heights }),
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
