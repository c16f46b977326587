//! What the model is made of, as tables.

use serde::Serialize;
use tremolite_results::{MaterialFacts, MaterialValue, Origin, Summary};

use crate::scale::{count, figures, quantity, trimmed};

/// A material and its values.
#[derive(Serialize)]
pub struct MaterialTable {
    pub name: String,
    /// The law's word and what it is.
    pub law: String,
    pub summary: String,
    /// Groups with the number and kind of their elements.
    pub groups: Vec<MadeOf>,
    pub density: String,
    pub speeds: String,
    pub damping: String,
    /// What the case gives or the law's defaults fill in.
    pub given: Vec<Row>,
    /// What the law works out of that.
    pub derived: Vec<Row>,
}

/// Groups of elements.
#[derive(Serialize)]
pub struct MadeOf {
    pub names: String,
    pub elements: String,
}

/// One value.
#[derive(Serialize)]
pub struct Row {
    pub name: String,
    pub value: String,
    pub meaning: String,
    /// Whether the case left it out.
    pub default: bool,
}

/// A table for each material of the summary.
pub fn tables(summary: &Summary) -> Vec<MaterialTable> {
    summary.materials.iter().map(|(name, facts)| table(name, facts)).collect()
}

fn table(name: &str, facts: &MaterialFacts) -> MaterialTable {
    let speed = |v: f64| quantity("m/s", v);
    let rows = |derived: bool| {
        facts.values.iter().filter(|v| (v.origin == Origin::Derived) == derived).map(row).collect()
    };
    MaterialTable {
        name: name.into(),
        law: facts.law.clone(),
        summary: facts.summary.clone(),
        groups: facts
            .groups
            .iter()
            .map(|g| MadeOf {
                names: g.names.clone(),
                elements: format!("{} elements, {}", count(g.elements), g.element),
            })
            .collect(),
        density: quantity("kg/m3", facts.density.round()),
        speeds: format!("{}, {}", speed(facts.wave_speed_p), speed(facts.wave_speed_s)),
        damping: facts.damping.clone(),
        given: rows(false),
        derived: rows(true),
    }
}

fn row(value: &MaterialValue) -> Row {
    Row {
        name: value.name.clone(),
        value: text(value),
        // What follows a semicolon is for who writes the case.
        meaning: value.meaning.split("; ").next().unwrap_or_default().into(),
        default: value.origin == Origin::Default,
    }
}

fn text(value: &MaterialValue) -> String {
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
        format!("{} to {}", one(value.value), one(value.most))
    }
}
