//! Steady seepage to walls and drains: what `[water]` and stages say of it.

use crate::fields::{Fields, Material};
use crate::keys::{Key, Kind, Limit, Table, When, words};
use crate::material::VOID;
use crate::stage::Written;
use crate::water::path;
use crate::{Diagnostic, Spanned};
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

/// What has a meaning with seepage alone, or with a level alone, and what seepage needs.
pub(crate) fn check(
    case: &Fields,
    water: &Fields,
    materials: &[Material],
    written: &Written,
    problems: &mut Vec<Diagnostic>,
) {
    let Some(pressure) = water.word("pressure", Pressure::from_word) else { return };
    let stages: Vec<&Fields> = case.tables("stage").filter_map(|stage| stage.table("water")).collect();
    if pressure.value == Pressure::Level {
        let of_stages =
            stages.iter().flat_map(|stage| ["heads", "drained", "drains"].map(|key| (stage.get(key), key)));
        let all = of_stages.chain([(water.get("heads"), "heads")]);
        problems.extend(all.filter_map(|(node, key)| Some((node?, key))).map(|(node, key)| {
            Diagnostic::new(
                node.span.clone(),
                format!("`{key}` has a meaning only with steady seepage, and pressures go by a level here"),
                "write pressure = \"seepage\" in [water], or leave it out",
            )
        }));
        return;
    }
    problems.extend(stages.iter().filter_map(|stage| stage.number("level")).map(|level| {
        Diagnostic::at(
            &level,
            "`level` of a stage does nothing where pressures come from seepage",
            "give `heads` in its place: where water comes from",
        )
    }));
    if water.get("heads").is_none() && !written.is_refused("water") {
        problems.push(Diagnostic::at(
            &pressure,
            "nothing says where the water of the seepage comes from",
            "give heads, such as heads = { sides = \"-50 m\" }",
        ));
    }
    let used: Vec<String> =
        case.tables("region").filter_map(|region| region.text("material")).map(|name| name.value).collect();
    let flows = |material: &&Material| {
        let pores = material.fields.get("water").and_then(|node| node.table());
        pores.is_some_and(|pores| pores.get("permeability").is_some())
    };
    let of_regions: Vec<&Material> =
        materials.iter().filter(|material| used.contains(&material.name.value)).collect();
    let is_known = |name: &String| name == VOID || materials.iter().any(|m| m.name.value == *name);
    let is_refused = written.is_refused("region")
        || !used.iter().all(is_known)
        || of_regions.iter().any(|material| written.is_refused(&path(material)));
    if !(is_refused || of_regions.iter().any(flows)) {
        problems.push(Diagnostic::at(
            &pressure,
            "no material of a region has a permeability, so that no water flows",
            "give the rock one: water = { permeability = \"1e-7 m/s\" }",
        ));
    }
}
