//! Steady seepage to walls and drains: what `[water]` and stages say of it.

use crate::Spanned;
use crate::fields::Fields;
use crate::keys::{Key, Kind, Limit, Table, When, words};
use tremolite_laws::parameter::Dimension;

const HEIGHT: Kind = Kind::Number(Dimension::LENGTH, Limit::Any);
const POINT: Kind = Kind::List(&HEIGHT, 3, 3);
pub(crate) const HEADS: Kind = Kind::Map("sides", &HEIGHT);
pub(crate) const WALLS: Kind = Kind::List(&Kind::Text, 0, 1000);
pub(crate) const ABOUT_HEADS: &str = "With seepage: heads outside the ground, heights z, at `sides` (all four), `xmin`, `xmax`, `ymin`, `ymax`, \
                                      `base`, `top`, at a face or the outer faces of a group of the mesh; below it they hold, and all else is tight";
pub(crate) const ABOUT_DRAINED: &str = "With seepage: groups whose walls are drained from here on, those behind a tight lining too; \
                                        an empty list closes all";

pub(crate) static DRAIN: Table = Table {
    path: "stage.water.drains",
    doc: "A drain: it takes water at the pressure of the air where there is some.",
    keys: &[
        Key::required("from", POINT, "one end of a line of boreholes or of a gallery")
            .when(When::Without("on")),
        Key::required("to", POINT, "its other end").when(When::Without("on")),
        Key::optional("on", Kind::Text, "", "Group of the mesh, in place of a line: all nodes of its ground"),
    ],
    choice: &[],
};

words! {
    /// Where the pressure in the ground comes from.
    Pressure {
        /// still water up to a level
        Level = "level",
        /// steady flow in the stages
        Seepage = "seepage",
    }
}

/// Where water is taken.
#[derive(Clone, Debug, PartialEq)]
pub enum Drain {
    /// Between two points, m.
    Line(Spanned<[f64; 3]>, Spanned<[f64; 3]>),
    /// Groups of the mesh, `*` standing for any text.
    Group(Spanned<String>),
}

impl Drain {
    pub(crate) fn read(f: &Fields) -> Option<Self> {
        match f.text("on") {
            Some(group) => Some(Drain::Group(group)),
            None => Some(Drain::Line(f.numbers("from")?, f.numbers("to")?)),
        }
    }
}

/// Heads by the names of where they are.
pub(crate) fn heads(f: &Fields) -> Option<Vec<(Spanned<String>, Spanned<f64>)>> {
    f.entries("heads").iter().map(|(name, node)| Some((name.clone(), node.number()?))).collect()
}

/// The field of results that has the flow.
pub(crate) const FIELD: &str = "seepage";

/// Whether a case has pressures from seepage.
pub(crate) fn flows(case: &Fields) -> bool {
    let pressure = case.table("water").and_then(|water| water.word("pressure", Pressure::from_word));
    pressure.is_some_and(|pressure| pressure.value == Pressure::Seepage)
}
