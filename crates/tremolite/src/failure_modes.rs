//! What judges the modes of failure of each lining, and tension beyond the strength of elastic ones.

use crate::groups::{all_groups, groups};
use crate::observers::SectionForces;
use crate::places::point;
use indexmap::IndexMap;
use tremolite_engine::{Model, Quadrature};
use tremolite_results::{
    FailureModes, Finding, GroupStress, JudgedBy, SectionStrength, Severity, said, snake,
};

/// By lining; empty without linings.
pub fn failure_modes(
    model: &Model,
    sections: &IndexMap<String, SectionStrength>,
) -> IndexMap<String, FailureModes> {
    let measured: Vec<&str> = groups(model).iter().map(|group| group.name).collect();
    let all = all_groups(model);
    let of = |(lining, stations): (String, u64)| {
        let body = all.iter().find(|group| group.name == lining)?.body;
        let section = sections.get(&lining).filter(|of| of.stations == stations);
        let by_section = |judged: bool| if judged { JudgedBy::Section } else { JudgedBy::Nothing };
        let by_law = measured.contains(&lining.as_str());
        // Layers follow bending: their law computes no failure by shear across the thickness.
        let in_shear = by_law && !matches!(body.quadrature, Quadrature::Layered(_));
        let modes = FailureModes {
            law: body.material.info().name.into(),
            thrust_moment: match by_law {
                true => JudgedBy::Law,
                false => by_section(section.is_some_and(|of| of.bending.is_some())),
            },
            shear: match in_shear {
                true => JudgedBy::Law,
                false => by_section(section.is_some_and(|of| of.shear.is_some())),
            },
            stations,
        };
        Some((lining, modes))
    };
    SectionForces::of(model).counts().into_iter().filter_map(of).collect()
}

/// Tension above the design strength of a `[[section]]`, in linings whose law neither cracks nor yields and that have stations without bars:
/// bars carry the tension of the others.
pub fn tension(
    sections: &IndexMap<String, SectionStrength>,
    stress: &IndexMap<String, GroupStress>,
) -> Vec<Finding> {
    let elastic = sections.iter().filter(|(_, of)| !of.yields && of.reinforced < of.stations);
    let of = |(lining, of): (&String, &SectionStrength)| {
        let peak = &stress.get(lining)?.s1;
        (peak.value > of.tension).then(|| {
            let mega = |x: f64| format!("{:.2}", x / 1e6);
            let headline = said!(
                "tension {stress} MPa (limit {strength} MPa, f_ctd by [[section]])",
                stress = mega(peak.value),
                strength = mega(of.tension),
            );
            let text = said!(
                "Largest at {time} s in element {element} at {place}. Its law is elastic and does not crack.",
                time = format!("{:.2}", peak.time),
                element = peak.element.to_string(),
                place = point(peak.at),
            );
            Finding::new(format!("tension_{}", snake(lining)), lining, Severity::Damaged, headline, text)
                .with("tension", peak.value)
                .with("strength", of.tension)
                .with("element", peak.element as f64)
                .with_place("tension", peak.at)
        })
    };
    elastic.filter_map(of).collect()
}
