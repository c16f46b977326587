//! `[mesh.caverns]`: a block of rock with caverns, generated.

use std::collections::BTreeSet;
use std::ops::Range;

use tremolite_laws::parameter::Dimension;

use super::{COORDINATE, LENGTH};
use crate::fields::Fields;
use crate::keys::{Key, Kind, Limit, Table};
use crate::{Problem, Spanned};

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
    ],
    choice: &[],
};

static CAVERN: Table = Table {
    path: "mesh.caverns.cavern",
    doc: "One cavern: a box with an arched crown.",
    keys: &[
        Key::required("name", Kind::Name, "first part of the names of its groups and points"),
        Key::required("width", LENGTH, "clear width in x"),
        Key::required("height", LENGTH, "height of the crown above the floor"),
        Key::required("arch_rise", LENGTH, "height of the crown above the springing of the arch"),
        Key::default(
            "at",
            Kind::List(&COORDINATE, 2, 2),
            r#"["0 m", "0 m"]"#,
            "Centre line in x and floor in z, both from the first cavern's",
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
        Key::default("floor", NOT_NEGATIVE, r#""0 m""#, "Thickness on the floor; 0: no lining there"),
        Key::default("layers", Kind::Count(20), "1", "Elements through the thickness"),
    ],
    choice: &[],
};

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
    /// Its table in the case: the header, or the braces.
    pub span: Range<usize>,
}

/// One cavern: a box with an arched crown. Lengths in m.
#[derive(Clone, Debug, PartialEq)]
pub struct Cavern {
    /// Unique; first part of the names of its groups and points.
    pub name: Spanned<String>,
    /// Clear width in x.
    pub width: Spanned<f64>,
    /// From floor to crown.
    pub height: Spanned<f64>,
    /// From the springing of the arch to the crown; below `height`, at most half the width.
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
        Some(Caverns {
            overburden: f.number("overburden")?,
            below: f.number("below")?,
            sides: f.number("sides")?,
            length: f.number("length")?,
            near: f.number("near")?,
            far: f.number("far")?,
            along,
            caverns: caverns.into_iter().collect::<Option<_>>()?,
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
            if let (Some(rise), Some(width)) = (cavern.number("arch_rise"), cavern.number("width"))
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
