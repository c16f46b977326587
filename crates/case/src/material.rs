//! `[material.NAME]`: a law with its parameters, and the density.

use std::ops::Range;

use toml::de::DeTable;
use tremolite_laws::parameter::{Dimension, Values};

use crate::check::{Checker, given};
use crate::fields;
use crate::keys::{Key, Kind, Limit, Table};
use crate::law_table::LawTable;
use crate::water::{MaterialWater, OF_MATERIAL_KIND};
use crate::{Spanned, law_key};

/// The keys that every material has; those of its law come from the law.
pub(crate) static MATERIAL: Table = Table {
    path: "material",
    doc: "A material: its law, its density or unit weight, and the parameters of the law.",
    keys: &[
        Key::required("law", Kind::Text, "the material law"),
        Key::optional("density", Kind::Number(Dimension::DENSITY, Limit::Positive), "", "Mass per volume"),
        Key::optional(
            "unit_weight",
            Kind::Number(Dimension::UNIT_WEIGHT, Limit::Positive),
            "",
            "Weight per volume, instead of the density",
        ),
        Key::optional(
            "water",
            OF_MATERIAL_KIND,
            "",
            "Pores, or \"none\"; laws that damage have none. Rock below the water level must say which",
        ),
    ],
    choice: &[&["density"], &["unit_weight"]],
};

/// The word that stands for no material in a region.
pub(crate) const VOID: &str = "void";

/// A law with its parameters, and the density.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// The name behind `material.`, unique.
    pub name: Spanned<String>,
    /// Name of one of the laws given to [`Case::read`](crate::Case::read).
    pub law: Spanned<String>,
    /// kg/m³. A unit weight is divided by the case's gravity.
    pub density: Spanned<f64>,
    /// Its pores, where it says something of them.
    pub water: Option<MaterialWater>,
    /// The law's parameters, defaults filled in; the law has accepted them.
    pub parameters: Values,
    /// The header `[material.NAME]`.
    pub span: Range<usize>,
}

impl Material {
    pub(crate) fn read(material: &fields::Material, gravity: f64) -> Option<Self> {
        let f = &material.fields;
        let density = f.number("density");
        let unit_weight = f.number("unit_weight").map(|w| Spanned::new(w.value / gravity, w.span));
        Some(Material {
            name: material.name.clone(),
            law: f.text("law")?,
            density: density.or(unit_weight)?,
            water: MaterialWater::read(f)?,
            parameters: f.values()?,
            span: f.span.clone(),
        })
    }
}

impl Checker<'_> {
    /// Checks all materials, each against the parameters of its law and by the law itself.
    pub(crate) fn materials(
        &mut self,
        table: &'static Table,
        written: &DeTable<'_>,
    ) -> Vec<fields::Material> {
        let mut materials = Vec::new();
        for (name, (at, value)) in given(written) {
            let span = value.span();
            if let Some(written) = value.get_ref().as_table() {
                materials.push(self.material(table, Spanned::new(name.to_owned(), at), written, span));
            } else {
                self.problem(
                    at,
                    format!("`{name}` should be a table: each material has a name"),
                    "write [material.rock] and the keys of the material below it",
                );
            }
        }
        materials.sort_by_key(|m| m.name.span.start);
        materials
    }

    fn material(
        &mut self,
        table: &'static Table,
        name: Spanned<String>,
        written: &DeTable<'_>,
        span: Range<usize>,
    ) -> fields::Material {
        if name.value == VOID {
            self.problem(
                name.span.clone(),
                "a material cannot be called `void`",
                "`void` stands for what is already excavated; choose another name",
            );
        }
        let path = format!("material.{}", name.value);
        let laws = self.laws.materials;
        let form = LawTable { table, laws, instead: &[], key: law_key::of, more: &[] };
        let fields = self.law(&form, written, span, &path);
        fields::Material { name, fields }
    }
}
