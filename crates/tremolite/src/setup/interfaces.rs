//! Which elements meet at interfaces, and by what law.

use super::groups::nothing_fits;
use super::{places, planes};
use crate::plan::PairMonitor;
use std::collections::{BTreeMap, BTreeSet};
use tremolite_case::{self as case, Case, Diagnostic, Interface as Written, Place, pattern};
use tremolite_engine::{Body, Interface, Life, Problem, Stage};
use tremolite_kernels::InterfaceLaw;
use tremolite_laws::Choice;
use tremolite_mesh::Mesh;
use tremolite_mesh::merge::{coincident_nodes, shortest_edge};
use tremolite_mesh::plane::Plane;

/// Normal stiffness \[Pa/m\] beyond any.
const STIFF: f64 = 1e15;
/// Share of the shortest edge within which nodes are at one place, generously.
const DOUBLED: f64 = 1e-3;
/// And within which they are paired ([`tremolite_mesh::split::split`]).
const PAIRED: f64 = 1e-6;
/// Share of a plane's extent within which nodes lie on it.
const ON_PLANE: f64 = 1e-6;

/// The interfaces of a case that are not tied, in its order: through what is there in the earthquake, and through what is
/// excavated before.
pub fn build(
    case: &Case,
    mesh: &Mesh,
    bodies: &[Body],
    lives: &[Life],
    laws: &[InterfaceLaw],
    problems: &mut Vec<Diagnostic>,
) -> Vec<Interface> {
    let mut solid = vec![false; mesh.elements.len()];
    bodies.iter().flat_map(|body| &body.elements).for_each(|&e| solid[e as usize] = true);
    let mut interfaces = Vec::new();
    for written in &case.interfaces {
        let Some(contact) = &written.contact else { continue };
        let Some(law) = laws.iter().find(|law| law.info.name == contact.law.value) else { continue };
        let sides = [0, 1].map(|side| elements(written, side, mesh, &solid, lives, problems));
        let [Some(first), Some(second)] = sides else { continue };
        let [inside, other]: [BTreeSet<u32>; 2] =
            [&first, &second].map(|side| side.iter().copied().collect());
        if let Some(&both) = inside.intersection(&other).next() {
            let group = |side: usize| {
                let holds = |(name, elements): &(&String, &Vec<u32>)| {
                    written.sides_of(name)[side] && elements.binary_search(&both).is_ok()
                };
                mesh.groups.iter().find(holds).map_or("?", |(name, _)| name.as_str())
            };
            problems.push(Diagnostic::at(
                &written.between[1][0],
                format!(
                    "element {} is on both sides of '{}': it is in '{}' and in '{}'",
                    mesh.element_id(both as usize),
                    written.name.value,
                    group(0),
                    group(1)
                ),
                "name groups that share no element",
            ));
            continue;
        }
        let pressure = pressure(bodies, [&inside, &other]);
        // What is installed later is the first side, whatever the order in the case: its nodes are its own.
        let latest = |side: &[u32]| side.iter().map(|&e| lives[e as usize].born).max();
        let sides = if latest(&second) > latest(&first) { [second, first] } else { [first, second] };
        interfaces.push(Interface {
            name: written.name.value.clone(),
            sides,
            law: *law,
            values: contact.parameters.clone(),
            pressure,
            corner: contact.corner.value,
            damping: contact.damping.value,
            limit: contact.limit.value,
            viscosity: contact.viscosity.value,
            water: contact.water.as_ref().map(|share| share.value),
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
    lives: &[Life],
    problems: &mut Vec<Diagnostic>,
) -> Option<Vec<u32>> {
    let mut all: BTreeSet<u32> = BTreeSet::new();
    let before = problems.len();
    for pattern in &written.between[side] {
        let groups = mesh.groups.iter().filter(|(name, _)| pattern::matches(pattern, name));
        let mut fits = false;
        for (_, elements) in groups {
            fits = true;
            all.extend(elements.iter().copied().filter(|&e| solid[e as usize]));
        }
        if !fits {
            problems.push(nothing_fits(mesh, pattern));
        }
    }
    if problems.len() > before {
        return None;
    }
    if !all.iter().any(|&e| lives[e as usize].holds(Stage::Shaking)) {
        let names: Vec<&str> = written.between[side].iter().map(|p| p.value.as_str()).collect();
        problems.push(Diagnostic::new(
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

/// The compressive strength \[Pa\] of what cracks beside an interface: it cannot press with more.
fn pressure(bodies: &[Body], sides: [&BTreeSet<u32>; 2]) -> f64 {
    let touches = |body: &&Body| body.elements.iter().any(|e| sides.iter().any(|side| side.contains(e)));
    let strengths = bodies
        .iter()
        .filter(|body| body.material.info().damages)
        .filter(touches)
        .filter_map(|body| body.material.compressive_strength());
    strengths.reduce(f64::max).unwrap_or(Interface::PRESSURE)
}

/// Joins what a mesh brings parted where a case ties it: nodes of the two sides at one place become one.
pub fn tie(case: &Case, mesh: &mut Mesh, problems: &mut Vec<Diagnostic>) {
    for written in case.interfaces.iter().filter(|interface| interface.contact.is_none()) {
        let nodes = [0, 1].map(|side| {
            let groups = mesh.groups.iter().filter(|(name, _)| written.sides_of(name)[side]);
            let elements = groups.flat_map(|(_, elements)| elements);
            elements.flat_map(|&e| mesh.elements[e as usize].nodes().to_vec()).collect::<BTreeSet<u32>>()
        });
        let mut places: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        for (node, first) in coincident_nodes(mesh, DOUBLED * shortest_edge(mesh)) {
            places.entry(first).or_insert_with(|| vec![first]).push(node);
        }
        // Others at the same place, of bodies that are not tied here, stay apart.
        let mut into: BTreeMap<u32, u32> = BTreeMap::new();
        for place in places.into_values() {
            let own: Vec<u32> =
                place.into_iter().filter(|n| nodes.iter().any(|side| side.contains(n))).collect();
            if nodes.iter().all(|side| own.iter().any(|n| side.contains(n))) {
                into.extend(own[1..].iter().map(|&n| (n, own[0])));
            }
        }
        if into.is_empty() && nodes[0].is_disjoint(&nodes[1]) {
            problems.push(Diagnostic::new(
                written.span.clone(),
                format!("the two sides of '{}' have no node in common or at one place", written.name.value),
                "name groups that touch, or leave the interface out",
            ));
        }
        for element in &mut mesh.elements {
            for node in &mut element.nodes {
                *node = into.get(node).copied().unwrap_or(*node);
            }
        }
    }
}

/// Whether all nodes at one place lie across an interface, so that the mesh comes parted there.
pub fn explain_doubled(mesh: &Mesh, interfaces: &[Interface]) -> bool {
    let nodes = |&e: &u32| mesh.elements[e as usize].nodes().to_vec();
    let used: BTreeSet<u32> = (0..mesh.elements.len() as u32).flat_map(|e| nodes(&e)).collect();
    let sides: Vec<[BTreeSet<u32>; 2]> = interfaces
        .iter()
        .map(|interface| interface.sides.each_ref().map(|side| side.iter().flat_map(nodes).collect()))
        .collect();
    let across = |(a, b): &(u32, u32)| {
        let parts = |[first, second]: &[BTreeSet<u32>; 2]| {
            (first.contains(a) && second.contains(b)) || (first.contains(b) && second.contains(a))
        };
        // Nodes that a tied interface has joined are in no element.
        !used.contains(a) || !used.contains(b) || sides.iter().any(parts)
    };
    let shortest = shortest_edge(mesh);
    let near = coincident_nodes(mesh, DOUBLED * shortest);
    // Those beyond what pairs are made of would be left alone.
    near.len() == coincident_nodes(mesh, PAIRED * shortest).len() && near.iter().all(across)
}

/// What is unusual about the laws of interfaces though they accept it.
pub fn warnings(case: &Case, laws: &[InterfaceLaw]) -> Vec<Diagnostic> {
    let mut warnings = Vec::new();
    for written in &case.interfaces {
        let Some(contact) = &written.contact else { continue };
        let Some(law) = laws.iter().find(|law| law.info.name == contact.law.value) else { continue };
        // Stiff enough for any bond, where the stiffness is left out.
        let choice = Choice { stiffness: STIFF, least: 0.0, pressure: Interface::PRESSURE };
        let Ok(built) = (law.build)(&(law.info.chosen)(&contact.parameters, &choice)) else { continue };
        let remedy = "change the interface's parameters if this is not meant";
        warnings
            .extend(built.warnings().into_iter().map(|w| Diagnostic::new(written.span.clone(), w, remedy)));
    }
    warnings
}

/// Ground that stands in the place of what is installed later.
pub struct StandIn {
    pub element: u32,
    /// The element of the mesh in whose place it stands.
    pub of: u32,
    pub body: usize,
}

/// Puts ground that stands in the place of what is installed later on the sides of interfaces that are there from the start: on the
/// side of its place, or, where a plane passes its place by, on the side of the plane on which its middle lies. Only ground of a body
/// that has elements on that side from the start is put there.
/// `places` says of each element of the mesh as it was read when something of its own stands in its place.
pub fn part_stand_ins(case: &Case, problem: &mut Problem, places: &[Life], stand_ins: &[StandIn]) {
    let Problem { mesh, bodies, interfaces, .. } = problem;
    let mut body_of = vec![None; mesh.elements.len()];
    for (b, body) in bodies.iter().enumerate() {
        body.elements.iter().for_each(|&e| body_of[e as usize] = Some(b));
    }
    let passing: Vec<Passing> =
        case.ground.planes.iter().filter_map(|plane| Passing::of(plane, mesh)).collect();
    for interface in interfaces {
        let from_start = interface.sides.each_ref().map(|side| -> BTreeSet<usize> {
            let standing = side.iter().filter(|&&e| !places[e as usize].is_later());
            standing.filter_map(|&e| body_of[e as usize]).collect()
        });
        if from_start.iter().any(BTreeSet::is_empty) {
            continue;
        }
        let named = |e: u32| interface.sides.iter().position(|side| side.binary_search(&e).is_ok());
        let lies = passing.iter().filter_map(|plane| Some((plane, plane.is_of(named)?))).next();
        let side_of = |e: u32| {
            named(e).or_else(|| lies.and_then(|(plane, above)| Some(above ^ plane.side_below(mesh, e)?)))
        };
        let mut more: [Vec<u32>; 2] = Default::default();
        for stand_in in stand_ins {
            if let Some(side) = side_of(stand_in.of)
                && from_start[side].contains(&stand_in.body)
            {
                more[side].push(stand_in.element);
            }
        }
        interface.sides.iter_mut().zip(more).for_each(|(side, more)| side.extend(more));
    }
}

/// A plane of the case, and what it made of the mesh.
struct Passing {
    plane: Plane,
    extent: Option<f64>,
    /// Elements above and below it.
    cut: [Vec<u32>; 2],
}

impl Passing {
    /// Nothing where one of its groups is empty.
    fn of(plane: &case::CutPlane, mesh: &Mesh) -> Option<Self> {
        let [above, below] = planes::groups_of(plane).map(|group| mesh.groups.get(&group).cloned());
        let cut = [above?, below?];
        let extent = plane.extent.as_ref().map(|extent| extent.value);
        cut.iter().all(|side| !side.is_empty()).then(|| Passing {
            plane: places::plane(&plane.plane),
            extent,
            cut,
        })
    }

    /// The side of an interface on which what is above lies, where the interface is that of the plane.
    fn is_of(&self, named: impl Fn(u32) -> Option<usize>) -> Option<usize> {
        let [above, below] = self.cut.each_ref().map(|side| side.iter().find_map(|&e| named(e)));
        (above? != below?).then_some(above?)
    }

    /// 0 for an element above, and 1 for one below, that the plane does not cut; of a plane with an extent only if it has a face on it
    /// there.
    fn side_below(&self, mesh: &Mesh, element: u32) -> Option<usize> {
        if self.cut.iter().any(|side| side.binary_search(&element).is_ok()) {
            return None;
        }
        let nodes = mesh.elements[element as usize].nodes().iter().map(|&n| mesh.nodes[n as usize]);
        if let Some(extent) = self.extent {
            let on = |x: [f64; 3]| self.plane.distance(x).abs() < ON_PLANE * extent;
            if nodes.filter(|&x| on(x) && self.plane.reach(x) <= extent).count() < 3 {
                return None;
            }
        }
        let middle = tremolite_mesh::places::middle(mesh, element);
        Some(usize::from(self.plane.distance(middle) < 0.0))
    }
}

/// Monitors on interfaces that are not tied; the others are among the problems.
pub fn monitors(case: &Case, mesh: &Mesh, problems: &mut Vec<Diagnostic>) -> Vec<PairMonitor> {
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
