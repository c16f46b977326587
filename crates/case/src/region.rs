//! `[[region]]`: which groups of the mesh are made of what.

use std::ops::Range;

use crate::Spanned;
use crate::fields::Fields;
use crate::keys::{Key, Kind, Limit, Table, When, words};
use crate::material::VOID;
use crate::pattern;
use tremolite_laws::Dimension;

pub(crate) static REGION: Table = Table {
    path: "region",
    doc: "Groups of elements and what they are made of.",
    keys: &[
        Key::required(
            "groups",
            Kind::List(&Kind::Text, 1, 1000),
            "groups of the mesh; * stands for any text",
        ),
        Key::required(
            "material",
            Kind::Text,
            "name of a material, or \"void\" for what is already excavated",
        ),
        Key::optional(
            "element",
            Kind::Word(Element::WORDS),
            "of linings and shotcrete that [mesh.caverns] makes layered in one layer, full in several; else it must be given",
            "reduced-integration: one point, fast, for rock; full-integration: 2×2×2 points, for linings of two and more elements through their thickness; \
             layered: 2×2 points in layers through the thickness, for linings one element thick",
        )
        .when(When::IsNot("material", VOID)),
        Key::optional(
            "points_through",
            Kind::Count(13),
            "9",
            "points through the thickness of layered elements, both faces included: 7, 9 or 13",
        )
        .when(When::Is("element", "layered")),
        Key::optional(
            "viscosity",
            Kind::Number(Dimension::NONE, Limit::NotNegative),
            "0.06 for laws that damage, else 0",
            "artificial viscosity: share of critical damping at each element's own highest frequency, against the ringing \
             of pieces between cracks; at most 0.5, shortens the step",
        )
        .when(When::IsNot("material", VOID)),
        Key::optional(
            "before",
            Kind::Text,
            "",
            "material that stands in the place until it is excavated, of what a stage installs; left out, that of the \
             neighbour it shares most faces with",
        )
        .when(When::IsNot("material", VOID)),
    ],
    choice: &[],
};

words! {
    /// How an element is integrated.
    Element {
        /// One point and assumed-strain stabilisation.
        OnePoint = "reduced-integration",
        /// The same assumed strain at 2×2×2 points.
        Full = "full-integration",
        /// The same at 2×2 points in several layers through the thickness.
        Layered = "layered",
    }
}

/// Groups of elements and what they are made of.
#[derive(Clone, Debug, PartialEq)]
pub struct Region {
    /// Group names, in which `*` stands for any text (see [`pattern::matches`]).
    pub groups: Vec<Spanned<String>>,
    /// What they are made of.
    pub fill: Fill,
    /// Its table in the case: the header, or the braces.
    pub span: Range<usize>,
}

/// What a region is made of.
#[derive(Clone, Debug, PartialEq)]
pub enum Fill {
    /// Already excavated: the elements are left out.
    Void,
    /// Made of a material.
    Solid {
        /// Index into [`Case::materials`](crate::Case::materials).
        material: Spanned<usize>,
        /// How the elements are integrated; left out of generated linings and shotcrete alone.
        element: Option<Spanned<Element>>,
        /// Points through the thickness of layered elements, where they are given: 7, 9 or 13.
        through: Option<Spanned<u32>>,
        /// Artificial viscosity b, where it is given.
        viscosity: Option<Spanned<f64>>,
        /// What stands in the place until it is excavated, where it is given: an index likewise.
        before: Option<Spanned<usize>>,
    },
}

impl Region {
    /// Whether the region holds a group of this name.
    pub fn holds(&self, group: &str) -> bool {
        self.groups.iter().any(|p| pattern::matches(p, group))
    }

    /// `names` are those of all materials, in order.
    pub(crate) fn read(f: &Fields, names: &[&str]) -> Option<Self> {
        let material = f.text("material");
        let element = f.word("element", Element::from_word);
        let groups = f.texts("groups");
        let material = material?;
        let fill = if *material == VOID {
            Fill::Void
        } else {
            let index = |name: Spanned<String>| {
                Some(Spanned::new(names.iter().position(|n| *n == name.value)?, name.span))
            };
            let viscosity = f.number("viscosity");
            let before = match f.text("before") {
                Some(name) => Some(index(name)?),
                None => None,
            };
            let through = f.count("points_through");
            Fill::Solid { material: index(material)?, element, through, viscosity, before }
        };
        Some(Region { groups, fill, span: f.span.clone() })
    }
}
