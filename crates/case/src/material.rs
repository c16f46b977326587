//! `[material.NAME]`: a law with its parameters, and the density.

use std::collections::BTreeMap;
use std::ops::Range;

use toml::de::DeTable;
use tremolite_laws::parameter::{self, Dimension, LawInfo, Parameter, Value, Values};

use crate::check::{Checker, given};
use crate::fields::{self, Item};
use crate::keys::{Key, Kind, Limit, Table};
use crate::{Problem, Spanned, law_key, suggest};

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
    ],
    choice: &[&["density"], &["unit_weight"]],
};

/// A table of columns; which they may be, its entry in the law's parameters says.
pub(crate) static COLUMNS: Table =
    Table { path: "", doc: "Columns of numbers, as many in each.", keys: &[], choice: &[] };

/// Modulus (Pa) below which a bare number must be a slip: soft soil has as much, rock and concrete a thousand times more.
const LEAST_MODULUS: f64 = 1e6;

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
            parameters: values(material)?,
            span: f.span.clone(),
        })
    }
}

/// The law's parameters; nothing if the law is unknown.
pub(crate) fn values(material: &fields::Material) -> Option<Values> {
    let mut values = Values::default();
    for name in material.parameters.as_ref()? {
        let value = match material.fields.nodes.get(name).map(|n| &n.item) {
            Some(Item::Number(x)) => Value::Number(*x),
            Some(Item::Text(word)) => Value::Word(word.clone()),
            Some(Item::Table(table)) => Value::Table(columns(table)),
            _ => continue,
        };
        values.0.insert((*name).to_owned(), value);
    }
    Some(values)
}

/// The columns of a checked table of them.
fn columns(fields: &fields::Fields) -> BTreeMap<String, Vec<f64>> {
    let column = |(name, node): (&&'static str, &fields::Node)| match &node.item {
        Item::List(numbers) => {
            let numbers = numbers.iter().filter_map(|n| Some(n.number()?.value));
            Some(((*name).to_owned(), numbers.collect()))
        }
        _ => None,
    };
    fields.nodes.iter().filter_map(column).collect()
}

impl fields::Material {
    /// Whether all that is wrong with it is what it leaves out; a refused column of a table would not be seen here.
    fn merely_incomplete(&self, written: &DeTable<'_>) -> bool {
        written.iter().all(|(key, value)| {
            !value.get_ref().is_table() && self.fields.nodes.contains_key(key.get_ref().as_ref())
        })
    }
}

impl Checker<'_> {
    /// Checks all materials, each against the parameters of its law and by the law itself.
    pub(crate) fn materials(&mut self, written: &DeTable<'_>) -> Vec<fields::Material> {
        let mut materials = Vec::new();
        for (name, (at, value)) in given(written) {
            let span = value.span();
            if let Some(table) = value.get_ref().as_table() {
                materials.push(self.material(Spanned::new(name.to_owned(), at), table, span));
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
        name: Spanned<String>,
        table: &DeTable<'_>,
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
        self.law(&MATERIAL, &[], name, table, span, &path)
    }

    /// Checks the table of one law: the keys of `table`, those of the law it names, and `more`.
    pub(crate) fn law(
        &mut self,
        table: &'static Table,
        more: &[Key],
        name: Spanned<String>,
        written: &DeTable<'_>,
        span: Range<usize>,
        path: &str,
    ) -> fields::Material {
        let laws = self.laws;
        let law = written.get("law").and_then(|v| Some((v.get_ref().as_str()?, v.span())));
        let info = law.as_ref().and_then(|(law, _)| laws.iter().find(|l| l.name == *law));
        if let (Some((law, at)), None) = (law, info) {
            let names: Vec<&'static str> = laws.iter().map(|l| l.name).collect();
            self.word(&names, law, &at, "law");
        }
        let keys: Option<Vec<Key>> =
            info.map(|i| i.parameters.iter().map(law_key::of).chain(more.iter().copied()).collect());
        let before = self.problems.len();
        let mut fields = self.table(table, keys.as_deref(), written, span, path);
        for key in keys.iter().flatten().filter(|key| suggest::is_modulus(key)) {
            self.bare_modulus(key.name, written, &mut fields);
        }
        let parameters = info.map(|i| i.parameters.iter().map(|p| p.name).collect());
        let material = fields::Material { name, fields, parameters };
        if let Some(info) = info
            && (self.problems.len() == before || material.merely_incomplete(written))
        {
            self.ask_law(info, &material);
        }
        material
    }

    /// Refuses a modulus that is a bare number, so in Pa, and far below that of any rock or concrete.
    fn bare_modulus(&mut self, key: &'static str, written: &DeTable<'_>, fields: &mut fields::Fields) {
        let bare = written.get(key).is_some_and(|v| !v.get_ref().is_str());
        let value = fields.nodes.get(key).and_then(fields::Node::number);
        let Some(value) = value.filter(|e| bare && e.value > 0.0 && e.value < LEAST_MODULUS) else { return };
        // Nothing is stiffer than some hundred GPa.
        let unit = if value.value < 1e3 { "GPa" } else { "MPa" };
        let message = format!("`{key}` = {} has no unit, and a bare number is in Pa", value.value);
        self.problem(value.span, message, format!("write the unit: \"{} {unit}\"?", value.value));
        fields.nodes.remove(key);
    }

    /// Places what the law refuses at the offending key. Every key that is given has been read, so what the law misses is
    /// missing; required keys have been reported already.
    fn ask_law(&mut self, info: &LawInfo, material: &fields::Material) {
        let Some(values) = values(material) else { return };
        let Err(refused) = (info.check)(&values) else { return };
        for bad in refused {
            let required = |p: &Parameter| p.name == bad.name && p.need == parameter::Need::Required;
            if info.parameters.iter().any(required) && !material.fields.nodes.contains_key(bad.name) {
                continue;
            }
            // The key, or a column and the table it is missing in.
            let (key, column) = bad.name.split_once('.').unwrap_or((bad.name, ""));
            let node = material.fields.nodes.get(key);
            let inner = node.and_then(fields::Node::table).and_then(|table| table.nodes.get(column));
            let span = inner.or(node).map_or_else(|| material.fields.span.clone(), |n| n.span.clone());
            self.problems.push(Problem::new(span, format!("`{}` {}", bad.name, bad.problem), bad.remedy));
        }
    }
}
