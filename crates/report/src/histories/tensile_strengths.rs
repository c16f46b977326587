//! Strengths of the materials, to set stresses beside.

use crate::quantities::units::Kind;
use crate::source::Source;

/// Tensile strength of each material that has one, as one text; nothing where none has.
pub fn tensile(source: &Source) -> Option<String> {
    let facts = source.summary.as_ref().ok()?;
    let of = |(name, material): (&String, &tremolite_results::MaterialFacts)| {
        let strength = material.values.iter().find(|value| value.name == "tensile_strength")?.value;
        strength.is_finite().then(|| format!("{name} {}", source.quantity(Kind::Stress, strength)))
    };
    let all: Vec<String> = facts.materials.iter().filter_map(of).collect();
    (!all.is_empty()).then(|| all.join(", "))
}
