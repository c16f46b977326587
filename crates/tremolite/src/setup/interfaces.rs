//! Which elements meet at interfaces, and by what law.

use crate::plan::PairMonitor;
use std::collections::BTreeSet;
use tremolite_case::{Case, Contact, Interface as Written, Place, Problem, pattern};
use tremolite_engine::{Body, Interface};
use tremolite_kernels::InterfaceLaw;
use tremolite_laws::Values;
use tremolite_laws::interface::PRESSURE_FOR_STEP;
use tremolite_mesh::Mesh;

/// Pressure \[Pa\] from which on an interface between materials without a compressive strength goes straight.
const PRESSURE: f64 = 10e6;

/// The interfaces of a case that are not tied, in its order.
pub fn build(
    case: &Case,
    mesh: &Mesh,
    bodies: &[Body],
    laws: &[InterfaceLaw],
    problems: &mut Vec<Problem>,
) -> Vec<Interface> {
    let mut solid = vec![false; mesh.elements.len()];
    bodies.iter().flat_map(|body| &body.elements).for_each(|&e| solid[e as usize] = true);
    let mut interfaces = Vec::new();
    for written in &case.interfaces {
        let Some(contact) = &written.contact else { continue };
        let Some(law) = laws.iter().find(|law| law.info.name == contact.law.value) else { continue };
        let sides = [0, 1].map(|side| elements(written, side, mesh, &solid, problems));
        let [Some(first), Some(second)] = sides else { continue };
        let [inside, other]: [BTreeSet<u32>; 2] =
            [&first, &second].map(|side| side.iter().copied().collect());
        if let Some(&both) = inside.intersection(&other).next() {
            problems.push(Problem::new(
                written.span.clone(),
                format!(
                    "element {} is on both sides of '{}'",
                    mesh.element_id(both as usize),
                    written.name.value
                ),
                "name groups that share no element",
            ));
            continue;
        }
        let values = values(contact, law, bodies, [&inside, &other]);
        interfaces.push(Interface {
            name: written.name.value.clone(),
            sides: [first, second],
            law: *law,
            values,
            corner: contact.corner.value,
            damping: contact.damping.value,
            limit: contact.limit.value,
        });
    }
    interfaces
}

/// The solid elements of a side.
fn elements(
    written: &Written,
    side: usize,
    mesh: &Mesh,
    solid: &[bool],
    problems: &mut Vec<Problem>,
) -> Option<Vec<u32>> {
    let mut all = BTreeSet::new();
    let before = problems.len();
    for pattern in &written.between[side] {
        let groups = mesh.groups.iter().filter(|(name, _)| pattern::matches(pattern, name));
        let mut fits = false;
        for (_, elements) in groups {
            fits = true;
            all.extend(elements.iter().copied().filter(|&e| solid[e as usize]));
        }
        if !fits {
            let known: Vec<&str> = mesh.groups.keys().map(String::as_str).collect();
            problems.push(Problem::at(
                pattern,
                format!("no group of the mesh fits '{}'", pattern.value),
                format!("the mesh has the groups {}", known.join(", ")),
            ));
        }
    }
    if problems.len() > before {
        return None;
    }
    if all.is_empty() {
        let names: Vec<&str> = written.between[side].iter().map(|p| p.value.as_str()).collect();
        problems.push(Problem::new(
            written.span.clone(),
            format!(
                "all elements of {} are excavated, so '{}' has one side",
                names.join(", "),
                written.name.value
            ),
            "name groups that are there in the earthquake",
        ));
        return None;
    }
    Some(all.into_iter().collect())
}

/// The law's values, with the pressure from which on it goes straight: the compressive strength of the material that damages,
/// since a lining cannot press on rock with more.
fn values(contact: &Contact, law: &InterfaceLaw, bodies: &[Body], sides: [&BTreeSet<u32>; 2]) -> Values {
    let values = contact.parameters.clone();
    let takes = law.info.parameters.iter().any(|parameter| parameter.name == PRESSURE_FOR_STEP);
    if !takes || values.optional(PRESSURE_FOR_STEP).is_some() {
        return values;
    }
    let touches = |body: &&Body| body.elements.iter().any(|e| sides.iter().any(|side| side.contains(e)));
    let strengths = bodies
        .iter()
        .filter(|body| body.material.info().damages)
        .filter(touches)
        .filter_map(|body| body.material.compressive_strength());
    values.with(PRESSURE_FOR_STEP, strengths.reduce(f64::max).unwrap_or(PRESSURE))
}

/// Monitors on interfaces that are not tied; the others are among the problems.
pub fn monitors(case: &Case, mesh: &Mesh, problems: &mut Vec<Problem>) -> Vec<PairMonitor> {
    let mut pairs = Vec::new();
    for monitor in &case.monitors {
        let Some(interface) = &monitor.interface else { continue };
        // Tied ones are none of the model's.
        let index = case.interfaces[..interface.value].iter().filter(|i| i.contact.is_some()).count();
        let point = match &monitor.at.value {
            Place::Point(point) => Some(*point),
            Place::Named(name) => super::monitors::named(mesh, name, &monitor.at.span, problems),
        };
        if let Some(point) = point {
            pairs.push(PairMonitor { name: monitor.name.value.clone(), point, interface: index });
        }
    }
    pairs
}
