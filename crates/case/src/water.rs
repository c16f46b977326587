//! `[water]`: water in the pores of the ground, by a level; what materials, stages and interfaces say of it.

use std::ops::Range;

use tremolite_laws::parameter::Dimension;

use crate::Spanned;
use crate::fields::Fields;
use crate::keys::{Key, Kind, Limit, Table, When, words};
use crate::seepage::{self, DRAIN, Drain, HEADS, Pressure, WALLS};

const HEIGHT: Kind = Kind::Number(Dimension::LENGTH, Limit::Any);

const DRAINS: Kind = Kind::Either(&[Kind::Word(&[NONE]), Kind::Tables(&DRAIN)]);

pub(crate) static WATER: Table = Table {
    path: "water",
    doc: "Water in the pores of the ground: laws then see effective stress.",
    keys: &[
        Key::default(
            "unit_weight",
            Kind::Number(Dimension::UNIT_WEIGHT, Limit::Positive),
            r#""9.81 kN/m3""#,
            "Weight of the water per volume",
        ),
        Key::default(
            "pressure",
            Kind::Word(Pressure::WORDS),
            r#""level""#,
            "Where the pressure comes from: \"level\", the unit weight times the depth below the level, nothing above; \"seepage\", that in the \
             initial state, and steady flow to walls and drains in each stage",
        ),
        Key::required("level", HEIGHT, "height z of the water level in the ground before the first stage"),
        Key::default(
            "earthquake",
            Kind::Word(Earthquake::WORDS),
            r#""drained""#,
            "Pressures in the earthquake",
        ),
        Key::default(
            "bulk_modulus",
            Kind::Number(Dimension::PRESSURE, Limit::Positive),
            r#""2.2 GPa""#,
            "Bulk modulus of the water; only an undrained earthquake goes by it, with the `porosity` of materials",
        ),
        Key::optional("heads", HEADS, "", seepage::ABOUT_HEADS),
    ],
    choice: &[],
};

pub(crate) static OF_MATERIAL: Table = Table {
    path: "material.water",
    doc: "Pores of the material, or \"none\": water then presses on its faces alone.",
    keys: &[
        Key::default(
            "biot",
            Kind::Number(Dimension::NONE, Limit::UpTo(1.0)),
            "1",
            "Biot's coefficient α: 1 less the bulk modulus of the rock over that of its grains",
        ),
        Key::optional(
            "porosity",
            Kind::Number(Dimension::NONE, Limit::UpTo(1.0)),
            "",
            "Share of pores in the volume; at most `biot`. By it pressures change in an undrained earthquake",
        )
        .when(When::Without("skempton")),
        Key::optional(
            "skempton",
            Kind::Number(Dimension::NONE, Limit::UpTo(1.0)),
            "",
            "Skempton's coefficient B, below 1, in place of the porosity: share of a pressure all round that water takes where it cannot leave",
        )
        .when(When::Without("porosity")),
        Key::optional(
            "hydraulic_conductivity",
            Kind::Number(Dimension::VELOCITY, Limit::Positive),
            "",
            "Hydraulic conductivity K, for seepage; left out: tight",
        )
        .when(When::Without("permeability")),
        Key::optional(
            "permeability",
            Kind::Permeability,
            "",
            "In place of the conductivity: permeability k in m2, or k/μ in m2/(Pa s). K = k ρ g/μ with ρ = 1000 kg/m3, μ = 1.0e-3 Pa s and \
             g = 9.81 m/s2",
        )
        .when(When::Without("hydraulic_conductivity")),
        Key::optional(
            "saturated_unit_weight",
            Kind::Number(Dimension::UNIT_WEIGHT, Limit::Positive),
            "",
            "Weight per volume where there is water at the start; left out: as above the water",
        ),
    ],
    choice: &[],
};

/// What `water` of a material may be.
pub(crate) const OF_MATERIAL_KIND: Kind = Kind::Either(&[Kind::Word(&[NONE]), Kind::Table(&OF_MATERIAL)]);
/// The word for a material without pores.
const NONE: &str = "none";

pub(crate) static OF_STAGE: Table = Table {
    path: "stage.water",
    doc: "Water from this stage on; what is left out stays as in the stage before.",
    keys: &[
        Key::optional("level", HEIGHT, "", "Height z of the water level in the ground from here on"),
        Key::optional(
            "filled",
            Kind::Map("headrace", &HEIGHT),
            "",
            "Groups, as those of `pressure`, beside which the void is full of water from here on, each with the height z of its level: \
             it presses by its depth",
        ),
        Key::optional("heads", HEADS, "", "Heads outside from here on, in place of those of the same name"),
        Key::optional("drained", WALLS, "all walls of voids", seepage::ABOUT_DRAINED),
        Key::optional(
            "drains",
            DRAINS,
            "",
            "Lines and groups that take water from here on, in place of all before; \"none\" ends those",
        ),
    ],
    choice: &[],
};

pub(crate) static OF_INTERFACE: Table = Table {
    path: "interface.water",
    doc: "Water between the two sides: its pressure takes off what presses these together.",
    keys: &[
        Key::default(
            "factor",
            Kind::Number(Dimension::NONE, Limit::Within(1.0)),
            "1",
            "Share of the ground's water pressure that acts in the interface",
        ),
        Key::default("drained", Kind::Flag, "false", "Whether the interface is drained: no pressure in it"),
    ],
    choice: &[],
};

words! {
    /// What happens to pressures in the earthquake.
    Earthquake {
        /// they stay as the stages leave them
        Drained = "drained",
        /// water cannot leave its pores: pressures follow the volume of the ground
        Undrained = "undrained",
    }
}

words! {
    /// Of which stress `lateral` is the ratio.
    LateralOf {
        /// of effective stresses, where there is water
        Effective = "effective",
        /// of total stresses
        Total = "total",
    }
}

/// Water in the pores of the ground.
#[derive(Clone, Debug, PartialEq)]
pub struct Water {
    /// N/m³
    pub unit_weight: Spanned<f64>,
    /// Height of its level before the first stage, m.
    pub level: Spanned<f64>,
    pub earthquake: Spanned<Earthquake>,
    /// Pa
    pub bulk_modulus: Spanned<f64>,
    pub pressure: Spanned<Pressure>,
    /// Planes, faces or groups, and the head outside them, m; of seepage.
    pub heads: Vec<(Spanned<String>, Spanned<f64>)>,
    /// Its table in the case: the header, or the braces.
    pub span: Range<usize>,
}

/// Pores of a material.
#[derive(Clone, Debug, PartialEq)]
pub struct Pores {
    /// Biot's coefficient, in (0, 1].
    pub biot: Spanned<f64>,
    /// Share of pores in the volume, where it is given, at most that coefficient.
    pub porosity: Option<Spanned<f64>>,
    /// Skempton's coefficient, where it is given, in (0, 1).
    pub skempton: Option<Spanned<f64>>,
    /// Hydraulic conductivity, m/s; none: tight.
    pub hydraulic_conductivity: Option<Spanned<f64>>,
    /// N/m³, where there is water at the start.
    pub saturated_unit_weight: Option<Spanned<f64>>,
}

/// What a material says of water.
#[derive(Clone, Debug, PartialEq)]
pub enum MaterialWater {
    /// It has no pores.
    None,
    Pores(Pores),
}

/// Water from a stage on.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StageWater {
    /// Height of its level in the ground, m.
    pub level: Option<Spanned<f64>>,
    /// Groups beside which the void is full, and up to which height, m.
    pub filled: Vec<(Spanned<String>, Spanned<f64>)>,
    /// As those of [`Water`], from here on.
    pub heads: Vec<(Spanned<String>, Spanned<f64>)>,
    /// Groups whose walls are drained, where they are given.
    pub drained: Option<Vec<Spanned<String>>>,
    /// Drains, where they are given.
    pub drains: Option<Vec<Drain>>,
}

impl Water {
    pub(crate) fn read(f: &Fields) -> Option<Self> {
        Some(Water {
            unit_weight: f.number("unit_weight")?,
            level: f.number("level")?,
            earthquake: f.word("earthquake", Earthquake::from_word)?,
            bulk_modulus: f.number("bulk_modulus")?,
            pressure: f.word("pressure", Pressure::from_word)?,
            heads: seepage::heads(f)?,
            span: f.span.clone(),
        })
    }
}

impl Pores {
    fn read(f: &Fields) -> Option<Self> {
        Some(Pores {
            biot: f.number("biot")?,
            porosity: f.number("porosity"),
            skempton: f.number("skempton"),
            hydraulic_conductivity: f.number("hydraulic_conductivity").or_else(|| f.number("permeability")),
            saturated_unit_weight: f.number("saturated_unit_weight"),
        })
    }
}

impl MaterialWater {
    /// What a material says, if it says something; an error where that was refused.
    pub(crate) fn read(f: &Fields) -> Option<Option<Self>> {
        let Some(node) = f.get("water") else { return Some(None) };
        match node.table() {
            Some(table) => Some(Some(MaterialWater::Pores(Pores::read(table)?))),
            None => Some(Some(MaterialWater::None)),
        }
    }
}

impl StageWater {
    pub(crate) fn read(f: &Fields) -> Option<Self> {
        let Some(water) = f.table("water") else { return Some(StageWater::default()) };
        let filled = water.entries("filled").iter();
        Some(StageWater {
            level: water.number("level"),
            filled: filled
                .map(|(pattern, node)| Some((pattern.clone(), node.number()?)))
                .collect::<Option<_>>()?,
            heads: seepage::heads(water)?,
            drained: water.get("drained").map(|node| node.texts()),
            drains: match water.get("drains") {
                Some(node) if node.text().is_some() => Some(Vec::new()),
                Some(_) => Some(water.tables("drains").map(Drain::read).collect::<Option<_>>()?),
                None => None,
            },
        })
    }
}

/// The share of the ground's pressure in an interface, where its table is given.
pub(crate) fn of_interface(f: &Fields) -> Option<Spanned<f64>> {
    let water = f.table("water")?;
    let factor = water.number("factor")?;
    Some(Spanned::new(if water.flag("drained")? { 0.0 } else { factor.value }, factor.span))
}
