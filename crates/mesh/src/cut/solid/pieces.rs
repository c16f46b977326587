//! The elements that a plane leaves.

use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};

use super::choose::Choice;
use super::polyhedron::{self, Faces, Part, clip, divide, lid, parted, step_length};
use super::{Ground, Made};
use crate::cut::Cut;
use crate::places::middle;
use crate::quality;
use crate::topology::{face_key, minus, norm};
use crate::{Element, Face, Mesh};

/// Worth below which an element's nodes become dearer.
const POOR: f64 = 0.06;
/// What a step length counts for beside a Jacobian.
const STEP: f64 = 1.2;

/// A choice with all its elements, not yet in the mesh.
pub(super) struct Pieces {
    moves: BTreeMap<u32, [f64; 3]>,
    /// Nodes on the plane.
    on: BTreeSet<u32>,
    /// Nodes on parted edges: their numbers and places.
    between: BTreeMap<[u32; 2], u32>,
    places: Vec<[f64; 3]>,
    /// For each parted element its parts above and below.
    parts: BTreeMap<u32, [Vec<Part>; 2]>,
    /// The worst of what each element became.
    worth: Vec<(u32, f64)>,
    /// Step lengths of the parts, the smallest \[m\].
    step: f64,
}

impl Pieces {
    /// Divides the elements that a plane crosses. The error is those that cannot be.
    pub fn of(
        ground: &Ground<'_>,
        choice: &Choice,
        moves: BTreeMap<u32, [f64; 3]>,
    ) -> Result<Pieces, Vec<u32>> {
        let mesh = ground.mesh;
        let count = mesh.nodes.len() as u32;
        let moved = |n: u32| {
            let way = moves.get(&n).copied().unwrap_or_default();
            let x = mesh.nodes[n as usize];
            [0, 1, 2].map(|i| x[i] + way[i])
        };
        let (mut between, mut places) = (BTreeMap::new(), Vec::new());
        for &[above, below] in &choice.edges {
            let (a, b) = (moved(above), moved(below));
            // Through a slice the plane goes by one of its nodes: the others may lie beyond.
            let (of_a, of_b) = (ground.plane.distance(a).max(0.0), (-ground.plane.distance(b)).max(0.0));
            let t = if of_a + of_b > 0.0 { (of_a / (of_a + of_b)).clamp(0.05, 0.95) } else { 0.5 };
            between.insert([above, below], count + places.len() as u32);
            places.push([0, 1, 2].map(|i| a[i] + t * (b[i] - a[i])));
        }
        let at = |n: u32| match n.checked_sub(count) {
            Some(k) => places[k as usize],
            None => moved(n),
        };
        let sign = |n: u32| -> i8 {
            let off = ground.off.get(&n).copied().unwrap_or_default();
            if off == 0.0 || choice.nodes.contains(&n) { 0 } else { off.signum() as i8 }
        };
        let on_edge = |a: u32, b: u32| {
            let key = if sign(a) > 0 { [a, b] } else { [b, a] };
            between.get(&key).copied()
        };
        let before = |n: u32| mesh.nodes[n as usize];
        let (mut parts, mut worth) = (BTreeMap::new(), Vec::new());
        let mut step = f64::INFINITY;
        let has = |e: u32, s: i8| mesh.elements[e as usize].nodes().iter().any(|&n| sign(n) == s);
        let crossed = |e: u32| has(e, 1) && has(e, -1);
        // A quadrilateral with three corners on the plane is two triangles where a neighbour is crossed, one of them in the plane.
        let folded: HashSet<[u32; 4]> = ground
            .near
            .iter()
            .filter(|e| crossed(**e))
            .flat_map(|&e| faces_of(mesh, e))
            .filter(|face| fold(&mesh.face_nodes(*face).collect::<Vec<_>>(), sign).is_some())
            .map(|face| face_key(mesh, face))
            .collect();
        let bodies_of = |e: u32| -> Option<[Faces; 2]> {
            let is_crossed = crossed(e);
            let mut bodies: [Faces; 2] = Default::default();
            for face in faces_of(mesh, e) {
                let nodes: Vec<u32> = mesh.face_nodes(face).collect();
                let clipped = match fold(&nodes, sign).filter(|_| folded.contains(&face_key(mesh, face))) {
                    Some((off, flat, side)) => {
                        // The part in the plane bounds the body on the other side, if there is one.
                        let own = usize::from(side < 0);
                        bodies[own].push(off);
                        bodies[if is_crossed { 1 - own } else { own }].push(flat);
                        continue;
                    }
                    None => clip(&nodes, sign, on_edge)?,
                };
                for (body, polygon) in bodies.iter_mut().zip(clipped) {
                    if !polygon.is_empty() {
                        body.extend(parted(&polygon, &at));
                    }
                }
            }
            if !is_crossed {
                // Faces that lie on the plane are those of the one body.
                let own = usize::from(has(e, -1));
                for face in faces_of(mesh, e) {
                    let nodes: Vec<u32> = mesh.face_nodes(face).collect();
                    if nodes.iter().all(|&n| sign(n) == 0) {
                        bodies[own].push(nodes);
                    }
                }
            }
            if is_crossed {
                let lid = lid(&bodies[0])?;
                for face in parted(&lid, &at) {
                    bodies[1].push(face.iter().rev().copied().collect());
                    bodies[0].push(face);
                }
            }
            Some(bodies)
        };
        let mut impossible = Vec::new();
        for &e in &ground.near {
            let element = &mesh.elements[e as usize];
            let is_crossed = crossed(e);
            if !is_crossed && !faces_of(mesh, e).any(|face| folded.contains(&face_key(mesh, face))) {
                if element.nodes().iter().any(|n| moves.contains_key(n)) {
                    let length = step_length(element, &at);
                    step = step.min(length);
                    worth.push((e, jacobian(element, &at).min(STEP * length / ground.smallest)));
                }
                continue;
            }
            let Some(bodies) = bodies_of(e) else {
                impossible.push(e);
                continue;
            };
            let size = step_length(element, &before);
            let mut worst = f64::INFINITY;
            let made = bodies.map(|body| {
                if body.is_empty() {
                    return Vec::new();
                }
                let (_, made) = divide(&body, size, &at);
                for part in &made {
                    let own = match part {
                        Part::Star(faces) => polyhedron::middle(faces, &at),
                        Part::Whole(_) => [0.0; 3],
                    };
                    let with = |n: u32| if n == u32::MAX { own } else { at(n) };
                    let all = match part {
                        Part::Whole(element) => vec![*element],
                        Part::Star(faces) => polyhedron::star(faces, u32::MAX),
                    };
                    for element in all {
                        let length = step_length(&element, &with);
                        step = step.min(length);
                        worst = worst.min(jacobian(&element, &with).min(STEP * length / ground.smallest));
                    }
                }
                made
            });
            worth.push((e, worst));
            parts.insert(e, made);
        }
        if !impossible.is_empty() {
            return Err(impossible);
        }
        let on = choice.nodes.clone();
        Ok(Pieces { moves, on, between, places, parts, worth, step })
    }

    /// How good it is, and the elements that are poor.
    pub fn score(&self, ground: &Ground<'_>) -> (f64, Vec<u32>) {
        let least = self.worth.iter().map(|(_, worth)| *worth).fold(f64::INFINITY, f64::min);
        let poor = self.worth.iter().filter(|(_, worth)| *worth < POOR).map(|(e, _)| *e).collect();
        (least.min(STEP * self.step / ground.smallest), poor)
    }

    /// Nodes that stand for the plane off it.
    pub fn bent(&self, ground: &Ground<'_>) -> BTreeSet<u32> {
        let (low, high) = ground.mesh.bounds();
        let tolerance = 1e-9 * norm(minus(high, low));
        let off = |n: &u32| {
            let (x, way) = (ground.at(*n), self.moves.get(n).copied().unwrap_or_default());
            ground.plane.distance([0, 1, 2].map(|i| x[i] + way[i])).abs() > tolerance
        };
        self.on.iter().copied().filter(off).collect()
    }

    /// Makes the mesh.
    pub fn apply(self, ground: &Ground<'_>, cut: &Cut) -> Made {
        let mut mesh = ground.mesh.clone();
        let numbered = !mesh.node_ids.is_empty();
        let mut changed: BTreeSet<u32> = BTreeSet::new();
        for (&n, way) in &self.moves {
            let x = &mut mesh.nodes[n as usize];
            *x = [0, 1, 2].map(|i| x[i] + way[i]);
        }
        let is_moved = |e: &&u32| {
            let nodes = ground.mesh.elements[**e as usize].nodes();
            nodes.iter().any(|n| self.moves.contains_key(n))
        };
        changed.extend(ground.near.iter().filter(is_moved));
        let sign = |n: u32| -> i8 {
            let off = ground.off.get(&n).copied();
            match off.unwrap_or_else(|| ground.plane.distance(ground.mesh.nodes[n as usize])) {
                0.0 => 0,
                _ if self.on.contains(&n) => 0,
                off => off.signum() as i8,
            }
        };
        let mut side: Vec<i8> = Vec::with_capacity(mesh.elements.len());
        for (e, element) in ground.mesh.elements.iter().enumerate() {
            let found = element.nodes().iter().map(|&n| sign(n)).find(|s| *s != 0);
            side.push(found.unwrap_or_else(|| {
                if ground.plane.distance(middle(ground.mesh, e as u32)) < 0.0 { -1 } else { 1 }
            }));
        }
        mesh.nodes.extend(&self.places);
        let mut origin: Vec<u32> = (0..mesh.elements.len() as u32).collect();
        let mut made_of: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        for (&e, halves) in &self.parts {
            let mut list: Vec<u32> = Vec::new();
            for (half, s) in halves.iter().zip([1, -1]) {
                for part in half {
                    let elements = match part {
                        Part::Whole(element) => vec![*element],
                        Part::Star(faces) => {
                            let own = polyhedron::middle(faces, &|n| mesh.nodes[n as usize]);
                            mesh.nodes.push(own);
                            polyhedron::star(faces, mesh.nodes.len() as u32 - 1)
                        }
                    };
                    for element in elements {
                        let place = if list.is_empty() { e } else { mesh.elements.len() as u32 };
                        if list.is_empty() {
                            (mesh.elements[e as usize], side[e as usize]) = (element, s);
                        } else {
                            mesh.elements.push(element);
                            side.push(s);
                            origin.push(e);
                        }
                        list.push(place);
                    }
                }
            }
            changed.extend(&list);
            made_of.insert(e, list);
        }
        if numbered {
            number(&mut mesh.node_ids, mesh.nodes.len());
        }
        if !mesh.element_ids.is_empty() {
            number(&mut mesh.element_ids, mesh.elements.len());
        }
        for list in mesh.groups.values_mut() {
            let more: Vec<u32> =
                list.iter().filter_map(|e| made_of.get(e)).flat_map(|l| &l[1..]).copied().collect();
            list.extend(more);
            list.sort_unstable();
        }
        self.rename(ground.mesh, &mut mesh, &made_of);
        let sides = match cut.extent {
            None => [1, -1].map(|s| (0..side.len() as u32).filter(|&e| side[e as usize] == s).collect()),
            Some(extent) => {
                let on = |n: u32| (n as usize) >= ground.mesh.nodes.len() || sign(n) == 0;
                beside(&mesh, cut, extent, &side, on)
            }
        };
        let moved = self.moves.values().map(|way| norm(*way)).fold(0.0, f64::max);
        Made { mesh, changed: changed.into_iter().collect(), moved, sides, origin }
    }

    /// Face sets keep their faces where elements are divided.
    fn rename(&self, before: &Mesh, mesh: &mut Mesh, made_of: &BTreeMap<u32, Vec<u32>>) {
        let mut sets = std::mem::take(&mut mesh.faces);
        for list in sets.values_mut() {
            let new = |face: &Face| {
                let Some(pieces) = made_of.get(&face.element) else { return vec![*face] };
                let corners: Vec<u32> = before.face_nodes(*face).collect();
                let mut had: HashSet<u32> = corners.iter().copied().collect();
                for (k, &a) in corners.iter().enumerate() {
                    let b = corners[(k + 1) % corners.len()];
                    had.extend([[a, b], [b, a]].iter().filter_map(|edge| self.between.get(edge)));
                }
                let sides = pieces.iter().flat_map(|&element| {
                    let count = mesh.elements[element as usize].shape.faces().len() as u8;
                    (0..count).map(move |side| Face { element, side })
                });
                sides.filter(|&new| mesh.face_nodes(new).all(|n| had.contains(&n))).collect()
            };
            *list = list.iter().flat_map(new).collect();
            list.sort_unstable();
        }
        mesh.faces = sets;
    }
}

fn faces_of(mesh: &Mesh, element: u32) -> impl Iterator<Item = Face> + use<> {
    let count = mesh.elements[element as usize].shape.faces().len() as u8;
    (0..count).map(move |side| Face { element, side })
}

/// The triangle off the plane of a quadrilateral with three corners on it, the one in the plane, and the side of the first.
fn fold(face: &[u32], sign: impl Fn(u32) -> i8) -> Option<(Vec<u32>, Vec<u32>, i8)> {
    let off: Vec<usize> = (0..face.len()).filter(|&k| sign(face[k]) != 0).collect();
    let (4, &[k]) = (face.len(), &off[..]) else { return None };
    let at = |j: usize| face[(k + j) % 4];
    Some((vec![at(3), at(0), at(1)], vec![at(1), at(2), at(3)], sign(at(0))))
}

fn jacobian(element: &Element, at: &impl Fn(u32) -> [f64; 3]) -> f64 {
    let x: Vec<[f64; 3]> = element.nodes().iter().map(|&n| at(n)).collect();
    let jacobian = quality::scaled_jacobian(element.shape, &x);
    if jacobian.is_nan() { -1.0 } else { jacobian }
}

/// Numbers for what is new: those beyond the largest.
fn number(ids: &mut Vec<u64>, count: usize) {
    let largest = ids.iter().copied().max().unwrap_or_default();
    let more = (count - ids.len()) as u64;
    ids.extend((1..=more).map(|k| largest + k));
}

/// The elements above and below that have a face on the plane whose middle lies within its extent.
fn beside(mesh: &Mesh, cut: &Cut, extent: f64, side: &[i8], on: impl Fn(u32) -> bool) -> [Vec<u32>; 2] {
    let touches = |e: &u32| mesh.elements[*e as usize].nodes().iter().any(|&n| on(n));
    let candidates: Vec<u32> = (0..mesh.elements.len() as u32).filter(touches).collect();
    let mut owners: HashMap<[u32; 4], Vec<u32>> = HashMap::new();
    for &element in &candidates {
        for k in 0..mesh.elements[element as usize].shape.faces().len() as u8 {
            let face = Face { element, side: k };
            if mesh.face_nodes(face).all(&on) {
                let nodes: Vec<[f64; 3]> = mesh.face_nodes(face).map(|n| mesh.nodes[n as usize]).collect();
                let mean = [0, 1, 2].map(|i| nodes.iter().map(|x| x[i]).sum::<f64>() / nodes.len() as f64);
                if cut.plane.reach(mean) <= extent {
                    owners.entry(face_key(mesh, face)).or_default().push(element);
                }
            }
        }
    }
    let mut lists: [BTreeSet<u32>; 2] = Default::default();
    for pair in owners.values() {
        if let [a, b] = pair[..]
            && side[a as usize] != side[b as usize]
        {
            for e in [a, b] {
                lists[usize::from(side[e as usize] < 0)].insert(e);
            }
        }
    }
    lists.map(|list| list.into_iter().collect())
}
