//! What a case left out, with the values that the run used in its place.

use crate::plan::Plan;
use crate::setup::MotionFacts;
use indexmap::IndexMap;
use tremolite_case::{Case, Mesh, units};
use tremolite_engine::{Assembly, Model};
use tremolite_laws::{Dimension, Kind};
use tremolite_results::{Defaulted, MaterialFacts, MaterialValue};

/// What the values of left-out keys follow from.
pub struct Known<'a> {
    pub case: &'a Case,
    pub model: &'a Model,
    pub assembly: &'a Assembly,
    pub plan: &'a Plan,
    /// Nothing without an earthquake.
    pub motion: Option<&'a MotionFacts>,
    pub materials: &'a IndexMap<String, MaterialFacts>,
    /// Frequency at which moduli are meant \[Hz\].
    pub reference: Option<f64>,
    /// The step used \[s\].
    pub dt: f64,
}

/// Every key that was left out, with its value. Where one follows from others, the case's words of that stand behind
/// it; a parameter that nothing takes the place of is `none`.
pub fn defaulted(known: &Known) -> Vec<Defaulted> {
    let line = |d: &tremolite_case::Defaulted| match used(known, &d.key) {
        Some(value) if value == d.value => Defaulted::new(&d.key, value),
        Some(value) => Defaulted::new(&d.key, format!("{value} ({})", d.value)),
        None => Defaulted::new(&d.key, &d.value),
    };
    known.case.defaulted.iter().map(line).collect()
}

/// The value used for a key whose default is no value itself.
fn used(known: &Known, key: &str) -> Option<String> {
    let seconds = |t: f64| units::format(t, Dimension::TIME);
    match key {
        "dynamic.duration" => Some(seconds(known.plan.duration)),
        "dynamic.time_step" => Some(seconds(known.dt)),
        "dynamic.base.distance" => {
            known.assembly.spring_distance.map(|r| units::format(r, Dimension::LENGTH))
        }
        "dynamic.damping.reference" => known.reference.map(|f| units::format(f, Dimension::RATE)),
        "motion.window" => {
            let [from, to] = known.motion?.window;
            Some(format!("{} to {}", seconds(from), seconds(to)))
        }
        "mesh.caverns.size_along" => match &known.case.mesh {
            Mesh::Caverns(caverns) => Some(units::format(caverns.near.value, Dimension::LENGTH)),
            _ => None,
        },
        _ if key.starts_with("interface[") => {
            let (name, parameter) = key.strip_prefix("interface[")?.split_once("].")?;
            let at = known.model.user_seams().iter().position(|seam| seam.name == name)?;
            let law = &known.assembly.contacts[at].law;
            let x = law.values().optional(parameter)?;
            let dimension = law.info().parameters.iter().find(|p| p.name == parameter).map(|p| p.kind);
            let Some(Kind::Number(dimension)) = dimension else { return None };
            let lowered = x < known.model.seams[at].pressure && parameter == "pressure_for_step";
            let why = if lowered { ", lowered as the chosen stiffness wants it" } else { "" };
            let value = units::format(format!("{x:.3e}").parse().unwrap_or(x), dimension);
            Some(value + why)
        }
        _ => {
            let (name, parameter) = key.strip_prefix("material.")?.rsplit_once('.')?;
            let values = &known.materials.get(name)?.values;
            let found = values.iter().find(|v| v.name == parameter);
            Some(found.map_or_else(|| "none".to_owned(), text))
        }
    }
}

/// A material's value as one would write it in a case; two values where it goes by the size of elements.
pub fn text(value: &MaterialValue) -> String {
    if !value.word.is_empty() {
        return value.word.clone();
    }
    let dimension = match value.unit.as_str() {
        "Pa" => Dimension::PRESSURE,
        "N/m" => Dimension::FRACTURE_ENERGY,
        "m" => Dimension::LENGTH,
        "s" => Dimension::TIME,
        "1/s" => Dimension::RATE,
        "rad" => Dimension::ANGLE,
        _ => Dimension::NONE,
    };
    let one = |x: f64| {
        // Six digits of what was worked out would say more than is known.
        let digits = if value.origin == tremolite_results::Origin::Derived { 3 } else { 5 };
        units::format(format!("{x:.digits$e}").parse().unwrap_or(x), dimension)
    };
    if value.value == value.most {
        one(value.value)
    } else {
        format!("{} to {}", one(value.value), one(value.most))
    }
}
