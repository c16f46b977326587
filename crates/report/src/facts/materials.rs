//! What the model is made of, as tables.

use minijinja::Value;
use serde::Serialize;
use tremolite_results::{MaterialFacts, MaterialGroup, MaterialValue, Origin, Summary};

use crate::chapter::results_text::{known, told};
use crate::language::{Language, say};
use crate::quantities::scale::{count, figures, quantity, trimmed};

/// A material and its values.
#[derive(Serialize)]
pub struct MaterialTable {
    pub name: String,
    /// The law's word and what it is.
    pub law: String,
    pub summary: Value,
    /// Groups with the number and kind of their elements.
    pub groups: Vec<MadeOf>,
    pub density: String,
    pub speeds: String,
    pub damping: Value,
    /// What the case gives or the law's defaults fill in.
    pub given: Vec<MaterialRow>,
    /// What the law works out of that.
    pub derived: Vec<MaterialRow>,
}

/// Groups of elements.
#[derive(Serialize)]
pub struct MadeOf {
    pub names: String,
    pub elements: String,
}

/// One value.
#[derive(Serialize)]
pub struct MaterialRow {
    pub name: String,
    pub value: String,
    pub meaning: Value,
    /// Whether the case left it out.
    pub default: bool,
}

/// A table for each material of the summary.
pub fn tables(language: Language, summary: &Summary) -> Vec<MaterialTable> {
    summary.computed.materials.iter().map(|(name, facts)| table(language, name, facts)).collect()
}

fn table(language: Language, name: &str, facts: &MaterialFacts) -> MaterialTable {
    let speed = |v: f64| quantity("m/s", v);
    let rows = |derived: bool| {
        let own = facts.values.iter().filter(|v| (v.origin == Origin::Derived) == derived);
        own.map(|value| row(language, value)).collect()
    };
    MaterialTable {
        name: name.into(),
        law: facts.law.clone(),
        summary: known(language, &facts.summary),
        groups: facts
            .groups
            .iter()
            .map(|g| MadeOf { names: g.names.clone(), elements: elements(language, g) })
            .collect(),
        density: quantity("kg/m3", facts.density.round()),
        speeds: format!("{}, {}", speed(facts.wave_speed_p), speed(facts.wave_speed_s)),
        damping: told(language, &facts.damping_message, &facts.damping),
        given: rows(false),
        derived: rows(true),
    }
}

fn elements(language: Language, group: &MaterialGroup) -> String {
    let count = count(group.elements);
    match group.element.as_str() {
        "reduced-integration" => say!(language, "{count} elements, reduced integration", count = count),
        "full-integration" => say!(language, "{count} elements, full integration", count = count),
        "layered" => say!(language, "{count} elements, layered", count = count),
        other => say!(language, "{count} elements, {kind}", count = count, kind = other),
    }
}

fn row(language: Language, value: &MaterialValue) -> MaterialRow {
    MaterialRow {
        name: value.name.clone(),
        value: text(language, value),
        // What follows a semicolon is for who writes the case.
        meaning: known(language, value.meaning.split("; ").next().unwrap_or_default()),
        default: value.origin == Origin::Default,
    }
}

fn text(language: Language, value: &MaterialValue) -> String {
    if !value.word.is_empty() {
        return value.word.clone();
    }
    let one = |x: f64| match value.unit.as_str() {
        "rad" => format!("{}°", trimmed(&figures(x.to_degrees(), 4))),
        unit => trimmed(&quantity(unit, x)),
    };
    if value.value == value.most || value.most.is_nan() {
        one(value.value)
    } else {
        say!(language, "{least} to {most}", least = one(value.value), most = one(value.most))
    }
}
