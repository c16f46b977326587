//! The codes by which a case wants sections judged, with the elements that each is meant for.

use super::groups::nothing_fits;
use crate::sections::{is_lining, stations};
use crate::strength::JudgedBy;
use std::collections::{BTreeSet, HashMap};
use tremolite_case::{Case, Diagnostic, Section, SectionCode, Spanned, pattern};
use tremolite_engine::{Body, Life, Stage};
use tremolite_mesh::Mesh;
use tremolite_sections::{Code, Grade, Rule};

/// All that a case asks for. `lives` and `solid` are as for reinforcement, `bodies` tell which material cracks.
pub fn build(
    case: &Case,
    mesh: &Mesh,
    lives: &[Life],
    solid: &[bool],
    bodies: &[Body],
    problems: &mut Vec<Diagnostic>,
) -> Vec<JudgedBy> {
    let standing: Vec<bool> =
        lives.iter().zip(solid).map(|(life, solid)| *solid && life.holds(Stage::Shaking)).collect();
    let mut all = Vec::new();
    let mut taken: HashMap<u32, usize> = HashMap::new();
    for (k, section) in case.sections.iter().enumerate() {
        let before = problems.len();
        let mut elements = BTreeSet::new();
        for on in &section.on {
            let fits = mesh.groups.iter().filter(|(name, _)| pattern::matches(on, name));
            if fits.clone().next().is_none() {
                problems.push(nothing_fits(mesh, on));
            }
            let lined = lining(mesh, lives, bodies);
            let other = fits.clone().find(|(_, elements)| !elements.iter().any(|&e| lined[e as usize]));
            if let Some((name, _)) = other {
                problems.push(no_lining(mesh, on, name, &lined));
            }
            elements.extend(fits.flat_map(|(_, elements)| elements.iter().copied()));
        }
        let elements: Vec<u32> = elements.into_iter().collect();
        problems
            .extend(unfit(case, section, mesh, &elements, &standing).filter(|_| problems.len() == before));
        if let (Some(other), Some(on)) = (elements.iter().find_map(|e| taken.get(e)), section.on.first()) {
            problems.push(Diagnostic::at(
                on,
                format!("some of these elements are judged by [[section]] {} as well", other + 1),
                "name each group in one [[section]]",
            ));
        }
        taken.extend(elements.iter().map(|e| (*e, k)));
        let Some(grade) = grade(section, problems) else { continue };
        all.push(JudgedBy {
            elements,
            code: section.code.word().into(),
            grade: section.grade.as_ref().map_or_else(String::new, |grade| grade.value.clone()),
            rule: Rule {
                code: code(section),
                grade,
                concrete_factor: section.gamma_c,
                steel_factor: section.gamma_s,
                compression_factor: section.alpha_cc,
                tension_factor: section.alpha_ct,
                resistance_factor: section.gamma_d,
                tension: section.plain_tension,
            },
            dynamic: section.dynamic,
            bar_diameter: section.bar_diameter.as_ref().map(|diameter| diameter.value),
        });
    }
    all
}

/// Which elements are of linings: a stage installs them, their material cracks, or they are linings by [`is_lining`].
fn lining(mesh: &Mesh, lives: &[Life], bodies: &[Body]) -> Vec<bool> {
    let count = mesh.elements.len();
    let mut lined: Vec<bool> = (0..count).map(|e| lives.get(e).is_some_and(|life| life.is_later())).collect();
    for body in bodies {
        if body.material.info().damages || is_lining(body, "") {
            body.elements.iter().for_each(|&e| lined[e as usize] = true);
        }
        let named = mesh.groups.iter().filter(|(name, _)| is_lining(body, name));
        let own = named.flat_map(|(_, elements)| elements).filter(|e| body.elements.binary_search(e).is_ok());
        own.for_each(|&e| lined[e as usize] = true);
    }
    lined
}

/// That a group is no lining, with those that are.
fn no_lining(mesh: &Mesh, on: &Spanned<String>, name: &str, lined: &[bool]) -> Diagnostic {
    let all = |elements: &[u32]| !elements.is_empty() && elements.iter().all(|&e| lined[e as usize]);
    let linings: Vec<&str> =
        mesh.groups.iter().filter(|(_, e)| all(e)).map(|(name, _)| name.as_str()).collect();
    Diagnostic::at(
        on,
        format!(
            "'{name}' is no lining: no stage installs it, its elements are not layered, and its material does not crack"
        ),
        match linings.is_empty() {
            true => "write element = \"layered\" for the lining, or install it in a stage".to_owned(),
            false => format!("name linings: {}", linings.join(", ")),
        },
    )
}

fn code(section: &Section) -> Code {
    match section.code.value {
        SectionCode::En => Code::En,
        SectionCode::Gb => Code::Gb,
    }
}

/// The strengths, by grade or as they are given.
fn grade(section: &Section, problems: &mut Vec<Diagnostic>) -> Option<Grade> {
    let code = code(section);
    let Some(name) = &section.grade else {
        let [compression, tension] = section.strengths?;
        return Some(Grade { compression, tension });
    };
    let found = Grade::of(code, name);
    if found.is_none() {
        let known: Vec<&str> = Grade::names(code).collect();
        problems.push(Diagnostic::at(
            name,
            format!("{} knows no grade '{}' here", section.code.word(), name.value),
            format!(
                "known are {}; else give `compressive_strength` and `tensile_strength`, up to C50 alone",
                known.join(", ")
            ),
        ));
    }
    found
}

/// Why elements cannot be judged: they have no thickness, or bars in them that never yield.
fn unfit(
    case: &Case,
    section: &Section,
    mesh: &Mesh,
    elements: &[u32],
    standing: &[bool],
) -> Option<Diagnostic> {
    let on = section.on.first()?;
    if stations(mesh, elements, standing).is_empty() {
        return Some(Diagnostic::at(
            on,
            "there is no thickness through which a section could be taken",
            "name groups of hexahedra that are thin one way, as linings are",
        ));
    }
    let endless = case.reinforcement.iter().filter(|steel| steel.yields.is_none()).find(|steel| {
        let fits = |name: &str| steel.on.iter().any(|on| pattern::matches(on, name));
        let inside = mesh.groups.iter().filter(|(name, _)| fits(name));
        inside.flat_map(|(_, own)| own).any(|e| elements.binary_search(e).is_ok())
    })?;
    Some(Diagnostic::new(
        endless.span.clone(),
        "bars that never yield have no strength by which a section could be judged",
        "give `yield`, such as \"500 MPa\"",
    ))
}
