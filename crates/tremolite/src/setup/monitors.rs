//! Where the monitors are.

use crate::plan::Monitor;
use tremolite_case::{Case, Diagnostic, Place};
use tremolite_engine::Body;
use tremolite_mesh::Mesh;
use tremolite_mesh::locate::Locator;

/// A monitor outside the mesh by up to this \[m\] is taken to lie on its surface.
const TOLERANCE: f64 = 0.01;

/// A coordinate \[m\] to the millimetre, without needless zeros.
fn short(x: f64) -> String {
    let text = format!("{x:.3}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// Least and largest coordinates \[m\] along each axis of the nodes of some elements.
fn span(mesh: &Mesh, elements: &[u32]) -> [[f64; 2]; 3] {
    let mut span = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
    let nodes = elements.iter().flat_map(|e| mesh.elements[*e as usize].nodes);
    for point in nodes.map(|n| mesh.nodes[n as usize]) {
        for (ends, x) in span.iter_mut().zip(point) {
            *ends = [ends[0].min(x), ends[1].max(x)];
        }
    }
    span
}

/// A point that the mesh has a name for.
pub fn named(
    mesh: &Mesh,
    name: &str,
    span: &std::ops::Range<usize>,
    problems: &mut Vec<Diagnostic>,
) -> Option<[f64; 3]> {
    if let Some(point) = mesh.points.get(name) {
        return Some(*point);
    }
    let known: Vec<&str> = mesh.points.keys().map(String::as_str).collect();
    let remedy = if known.is_empty() {
        "the mesh has no named points: give coordinates, at = [\"x\", \"y\", \"z\"]".to_owned()
    } else {
        format!("the mesh has the points {}", known.join(", "))
    };
    problems.push(Diagnostic::new(span.clone(), format!("there is no point '{name}' in the mesh"), remedy));
    None
}

/// All monitors in elements that could be placed; the others are among the problems.
pub fn build(case: &Case, mesh: &Mesh, bodies: &[Body], problems: &mut Vec<Diagnostic>) -> Vec<Monitor> {
    let mut solid: Vec<u32> = bodies.iter().flat_map(|b| b.elements.iter().copied()).collect();
    solid.sort_unstable();
    let mut monitors = Vec::new();
    // Monitors mostly share their bodies: one locator for each set of groups.
    let mut locators: Vec<(Vec<&str>, Locator)> = Vec::new();
    for monitor in case.monitors.iter().filter(|monitor| monitor.is_in_element()) {
        let point = match &monitor.at.value {
            Place::Point(point) => *point,
            Place::Named(name) => match named(mesh, name, &monitor.at.span, problems) {
                Some(point) => point,
                None => continue,
            },
        };
        let groups: Vec<&str> =
            mesh.groups.keys().map(String::as_str).filter(|g| monitor.lies_in(g)).collect();
        if let (Some(body), true) = (&monitor.body, groups.is_empty()) {
            let known: Vec<&str> = mesh.groups.keys().map(String::as_str).collect();
            let message = format!("no group of the mesh is called '{}' or ends so", body.value);
            problems.push(Diagnostic::at(
                body,
                message,
                format!("the mesh has the groups {}", known.join(", ")),
            ));
            continue;
        }
        let at = match locators.iter().position(|(g, _)| *g == groups) {
            Some(at) => at,
            None => {
                let mut elements = solid.clone();
                if monitor.body.is_some() {
                    let mut wanted = vec![false; mesh.elements.len()];
                    groups.iter().flat_map(|g| &mesh.groups[*g]).for_each(|&e| wanted[e as usize] = true);
                    elements.retain(|&e| wanted[e as usize]);
                }
                locators.push((groups, Locator::new(mesh, Some(&elements))));
                locators.len() - 1
            }
        };
        match locators[at].1.locate(point, TOLERANCE) {
            Some(location) => {
                monitors.push(Monitor { name: monitor.name.value.clone(), point, location });
            }
            None => {
                let of_groups = locators[at].0.iter().flat_map(|g| &mesh.groups[*g]);
                let (what, own): (_, Vec<u32>) = match monitor.body {
                    Some(_) => {
                        ("its body", of_groups.filter(|e| solid.binary_search(e).is_ok()).copied().collect())
                    }
                    None => ("the mesh", solid.clone()),
                };
                let [x, y, z] =
                    span(mesh, &own).map(|[low, high]| format!("{} to {}", short(low), short(high)));
                let remedy = match own.is_empty() {
                    true => format!("nothing of {what} is there when the ground shakes"),
                    false => format!("{what} spans x {x}, y {y}, z {z} m; excavated elements do not count"),
                };
                let [px, py, pz] = point;
                let name = &monitor.name.value;
                let message =
                    format!("monitor {name} at ({px:.3}, {py:.3}, {pz:.3}) m lies in no element of its body");
                problems.push(Diagnostic::at(&monitor.at, message, remedy));
            }
        }
    }
    monitors
}
