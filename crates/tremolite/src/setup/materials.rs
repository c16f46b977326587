//! What reports say of the materials: what was given, what was filled in, what the laws made of it.

use super::{regions, undrained};
use crate::phrases::clauses;
use crate::units::unit;
use indexmap::IndexMap;
use rayon::prelude::*;
use tremolite_case::{Case, Fill, Material};
use tremolite_engine::Body;
use tremolite_engine::extent::extents;
use tremolite_engine::hexahedra::hex;
use tremolite_kernels::{AnyMaterial, Law, Quadrature};
use tremolite_laws::{Parameter, Value};
use tremolite_mesh::Mesh;
use tremolite_results::{MaterialFacts, MaterialGroup, MaterialValue, Origin, Said, said};

/// The materials that bodies are made of, by name, in the order of the case's regions. `bodies` are those of the
/// solid regions, then others, of which `more` are to be told as well, each with its material in the case's list; `reference` is the frequency \[Hz\] at which moduli are meant with damping over a band.
pub fn facts(
    case: &Case,
    mesh: &Mesh,
    laws: &[Law],
    bodies: &[Body],
    more: &[(usize, usize)],
    reference: Option<f64>,
) -> IndexMap<String, MaterialFacts> {
    let damping = damping(case, reference);
    let mut all: IndexMap<String, MaterialFacts> = IndexMap::new();
    let solid = case.regions.iter().filter_map(|r| match &r.fill {
        Fill::Solid { material, .. } => Some((r, &case.materials[material.value])),
        _ => None,
    });
    let of_regions = bodies.iter().zip(solid).map(|(body, (region, material))| {
        let names = regions::groups(mesh, region).join(", ");
        (body, material, names)
    });
    let others =
        more.iter().map(|&(body, of)| (&bodies[body], &case.materials[of], bodies[body].name.clone()));
    let told: Vec<(&Body, &Material, String)> = of_regions.chain(others).collect();
    for &(body, material, ref names) in &told {
        let facts = all.entry(material.name.value.clone()).or_insert_with(|| {
            let made_of_it = told.iter().filter(|(_, m, _)| m.name.value == material.name.value);
            let elements: Vec<u32> = made_of_it.flat_map(|(body, ..)| &body.elements).copied().collect();
            let law = laws.iter().find(|l| l.info.name == material.law.value);
            let parameters = law.map_or(&[][..], |l| l.info.parameters);
            let (wave_speed_p, wave_speed_s) = body.material.moduli().wave_speeds(body.density);
            MaterialFacts {
                law: material.law.value.clone(),
                summary: body.material.info().summary.into(),
                density: body.density,
                wave_speed_p,
                wave_speed_s,
                damping: damping.to_string(),
                damping_message: damping.clone(),
                groups: Vec::new(),
                values: [
                    values(case, material, parameters, &*body.material, range(mesh, &elements)),
                    undrained::values(case, material, body),
                ]
                .concat(),
            }
        });
        facts.groups.push(MaterialGroup {
            names: names.clone(),
            body: body.name.clone(),
            elements: body.elements.len() as u64,
            element: match body.quadrature {
                Quadrature::OnePoint => "reduced-integration".into(),
                Quadrature::Full => "full-integration".into(),
                Quadrature::Layered(_) => "layered".into(),
            },
        });
    }
    all
}

/// Shortest and longest extent of some elements \[m\].
fn range(mesh: &Mesh, elements: &[u32]) -> [f64; 2] {
    let found = elements.par_iter().filter_map(|&e| hex(mesh, e as usize).ok()).map(|hex| extents(&hex));
    found.reduce(|| [f64::INFINITY, 0.0], |[least, most], [a, b]| [least.min(a), most.max(b)])
}

fn values(
    case: &Case,
    material: &Material,
    parameters: &[Parameter],
    law: &dyn AnyMaterial,
    extents: [f64; 2],
) -> Vec<MaterialValue> {
    let mut all = Vec::new();
    for parameter in parameters {
        let key = format!("material.{}.{}", material.name.value, parameter.name);
        let defaulted = case.defaulted.iter().any(|d| d.key == key);
        let (value, word) = match material.parameters.0.get(parameter.name) {
            Some(Value::Number(x)) => (*x, String::new()),
            Some(Value::Word(word)) => (f64::NAN, word.clone()),
            Some(Value::Table(columns)) => {
                let rows = columns.values().map(Vec::len).max().unwrap_or(0);
                let names: Vec<&str> = columns.keys().map(String::as_str).collect();
                (f64::NAN, format!("{rows} rows of {}", names.join(", ")))
            }
            None => continue,
        };
        all.push(MaterialValue {
            name: parameter.name.into(),
            value,
            most: value,
            word,
            unit: unit(parameter.kind).into(),
            meaning: parameter.doc.into(),
            origin: if defaulted { Origin::Default } else { Origin::Given },
        });
    }
    for derived in law.derived(extents) {
        let [value, most] = derived.range;
        // What the law does with a given value as it stands would be said twice.
        if all.iter().any(|v| v.name == derived.name && v.value == value && v.most == most) {
            continue;
        }
        all.push(MaterialValue {
            name: derived.name.into(),
            value,
            most,
            word: String::new(),
            unit: if derived.unit == "1" { String::new() } else { derived.unit.into() },
            meaning: derived.doc.into(),
            origin: Origin::Derived,
        });
    }
    all
}

/// The damping that all materials have, in words.
fn damping(case: &Case, reference: Option<f64>) -> Said {
    let dynamic = &case.dynamic;
    let (mass, stiffness) = (dynamic.rayleigh.mass.value, dynamic.rayleigh.stiffness.value);
    let mut parts = Vec::new();
    if mass > 0.0 || stiffness > 0.0 {
        let percent = |f: f64| {
            let ratio = mass / (4.0 * std::f64::consts::PI * f) + std::f64::consts::PI * f * stiffness;
            format!("{:.2}", 100.0 * ratio)
        };
        parts.push(said!(
            "Rayleigh, {mass} 1/s of the mass and {stiffness} s of the stiffness: {at_1} % at 1 Hz, {at_10} % at 10 Hz",
            mass = mass.to_string(),
            stiffness = stiffness.to_string(),
            at_1 = percent(1.0),
            at_10 = percent(10.0),
        ));
    }
    if let Some(band) = &dynamic.band {
        let [low, high] = band.band.value;
        let part = said!(
            "{ratio} % over {low} to {high} Hz by three Maxwell bodies",
            ratio = format!("{:.2}", 100.0 * band.ratio.value),
            low = low.to_string(),
            high = high.to_string(),
        );
        parts.push(part);
        parts.extend(reference.map(|f| match f {
            0.0 => said!("E is that of slow loading"),
            _ => said!("E is meant at {frequency} Hz", frequency = format!("{f:.2}")),
        }));
    }
    if parts.is_empty() { said!("none") } else { clauses(parts) }
}
