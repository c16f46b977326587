//! Bodies with plane faces of any number of corners: the parts of an element on either side of a plane, and their division.

use std::collections::{BTreeMap, BTreeSet};

use crate::quality;
use crate::topology::{cross, dot, minus, norm};
use crate::{Element, Shape};

/// Faces by their nodes, each seen from outside counter-clockwise.
pub(super) type Faces = Vec<Vec<u32>>;

/// A part of a body.
#[derive(Clone, Debug)]
pub(super) enum Part {
    Whole(Element),
    /// All its faces with a node of its own, the mean of its corners.
    Star(Faces),
}

/// How often a body is parted before it takes a node of its own.
const DEPTH: usize = 3;
/// By how much a tetrahedron makes a division worse: it is stiff where rock yields.
const TETRAHEDRON: f64 = 0.04;

/// The polygon above a plane and the one below, of a face whose corners have the signs of their sides, 0 on it; `between` are nodes on its
/// edges. Nothing if it does not fall into two.
pub(super) fn clip(
    face: &[u32],
    sign: impl Fn(u32) -> i8,
    between: impl Fn(u32, u32) -> Option<u32>,
) -> Option<[Vec<u32>; 2]> {
    let mut ring: Vec<(u32, i8)> = Vec::with_capacity(8);
    for (k, &a) in face.iter().enumerate() {
        let b = face[(k + 1) % face.len()];
        ring.push((a, sign(a)));
        if sign(a) * sign(b) < 0 {
            ring.push((between(a, b)?, 0));
        }
    }
    let has = |s: i8| ring.iter().any(|(_, sign)| *sign == s);
    match (has(1), has(-1)) {
        (false, false) => return Some([Vec::new(), Vec::new()]),
        (true, false) => return Some([face.to_vec(), Vec::new()]),
        (false, true) => return Some([Vec::new(), face.to_vec()]),
        (true, true) => {}
    }
    // Begins with the first that is above behind one that is not.
    let n = ring.len();
    let start = (0..n).find(|&k| ring[k].1 == 1 && ring[(k + n - 1) % n].1 != 1)?;
    ring.rotate_left(start);
    let runs: Vec<(i8, Vec<u32>)> =
        ring.iter().fold(Vec::new(), |mut runs: Vec<(i8, Vec<u32>)>, (node, s)| {
            match runs.last_mut() {
                Some((last, nodes)) if last == s => nodes.push(*node),
                _ => runs.push((*s, vec![*node])),
            }
            runs
        });
    let [(1, above), (0, first), (-1, below), (0, second)] = &runs[..] else { return None };
    // Of several nodes on the plane the one with the smallest number is the corner, for both neighbours.
    let smallest = |run: &Vec<u32>| run.iter().enumerate().min_by_key(|(_, n)| **n).map(|(k, _)| k);
    let (i, j) = (smallest(first)?, smallest(second)?);
    Some([
        [&above[..], &first[..=i], &second[j..]].concat(),
        [&first[i..], &below[..], &second[..=j]].concat(),
    ])
}

/// Parts a polygon of five or more corners into triangles and quadrilaterals, the same whichever way round it is seen.
pub(super) fn parted(polygon: &[u32], at: &impl Fn(u32) -> [f64; 3]) -> Faces {
    let n = polygon.len();
    if n <= 4 {
        return vec![polygon.to_vec()];
    }
    let mut ring = polygon.to_vec();
    let first = (0..n).min_by_key(|&k| ring[k]).unwrap_or_default();
    ring.rotate_left(first);
    if ring[n - 1] < ring[1] {
        ring[1..].reverse();
    }
    let mut best: Option<(f64, [u32; 2])> = None;
    for i in 0..n {
        for j in i + 2..n {
            let sizes = [j - i + 1, n - (j - i) + 1];
            // Halves of like numbers of corners.
            if sizes[0].min(sizes[1]) < 3 || sizes[0].max(sizes[1]) > n.div_ceil(2) + 1 {
                continue;
            }
            let one: Vec<u32> = ring[i..=j].to_vec();
            let two: Vec<u32> = ring[j..].iter().chain(&ring[..=i]).copied().collect();
            let worth = flatness(&one, at).min(flatness(&two, at));
            if best.as_ref().is_none_or(|b| worth > b.0) {
                best = Some((worth, [ring[i], ring[j]]));
            }
        }
    }
    let Some((_, ends)) = best else { return vec![polygon.to_vec()] };
    let place = |node: u32| polygon.iter().position(|p| *p == node).unwrap_or_default();
    let (i, j) = (place(ends[0]).min(place(ends[1])), place(ends[0]).max(place(ends[1])));
    let one: Vec<u32> = polygon[i..=j].to_vec();
    let two: Vec<u32> = polygon[j..].iter().chain(&polygon[..=i]).copied().collect();
    [parted(&one, at), parted(&two, at)].concat()
}

/// How good a polygon is: the smallest sine of its corners' angles, negative where one turns in.
fn flatness(ring: &[u32], at: &impl Fn(u32) -> [f64; 3]) -> f64 {
    let x: Vec<[f64; 3]> = ring.iter().map(|&n| at(n)).collect();
    let n = x.len();
    let mut normal = [0.0; 3];
    for k in 1..n - 1 {
        let c = cross(minus(x[k], x[0]), minus(x[k + 1], x[0]));
        (0..3).for_each(|i| normal[i] += c[i]);
    }
    let size = norm(normal);
    let corner = |k: usize| {
        let (a, b) = (minus(x[(k + 1) % n], x[k]), minus(x[(k + n - 1) % n], x[k]));
        dot(cross(a, b), normal) / (norm(a) * norm(b) * size)
    };
    (0..n).map(corner).fold(f64::INFINITY, f64::min)
}

/// The element whose faces these are, if there is such a shape.
pub(super) fn element(faces: &Faces) -> Option<Element> {
    let corners: BTreeSet<u32> = faces.iter().flatten().copied().collect();
    let triangles = faces.iter().filter(|f| f.len() == 3).count();
    let shape = match (corners.len(), triangles, faces.len() - triangles) {
        (4, 4, 0) => Shape::Tet4,
        (5, 4, 1) => Shape::Pyramid5,
        (6, 2, 3) => Shape::Wedge6,
        (8, 0, 6) => Shape::Hex8,
        _ => return None,
    };
    // The first face of every shape is its lower one.
    let size = shape.faces()[0].len();
    let base = faces.iter().find(|f| f.len() == size)?;
    let mut lower = base.clone();
    lower[1..].reverse();
    let mut beyond: BTreeMap<u32, u32> = BTreeMap::new();
    for face in faces {
        for (k, &a) in face.iter().enumerate() {
            let b = face[(k + 1) % face.len()];
            if base.contains(&a) && !base.contains(&b) {
                beyond.insert(a, b);
            }
        }
    }
    let mut upper: Vec<u32> = lower.iter().map(|n| beyond.get(n).copied()).collect::<Option<_>>()?;
    if matches!(shape, Shape::Tet4 | Shape::Pyramid5) {
        upper.truncate(1);
    }
    let nodes = [lower, upper].concat();
    if nodes.iter().collect::<BTreeSet<_>>().len() != nodes.len() {
        return None;
    }
    let made = Element::new(shape, &nodes);
    let sorted = |mut face: Vec<u32>| {
        face.sort_unstable();
        face
    };
    let own: BTreeSet<Vec<u32>> =
        shape.faces().iter().map(|f| sorted(f.iter().map(|&k| made.nodes[k]).collect())).collect();
    let given: BTreeSet<Vec<u32>> = faces.iter().cloned().map(sorted).collect();
    (own == given).then_some(made)
}

/// Elements on all faces of a body with a common node, `centre`.
pub(super) fn star(faces: &Faces, centre: u32) -> Vec<Element> {
    let made = faces.iter().map(|face| {
        let mut nodes = face.clone();
        nodes[1..].reverse();
        nodes.push(centre);
        Element::new(if face.len() == 3 { Shape::Tet4 } else { Shape::Pyramid5 }, &nodes)
    });
    made.collect()
}

/// The mean of a body's corners.
pub(super) fn middle(faces: &Faces, at: &impl Fn(u32) -> [f64; 3]) -> [f64; 3] {
    let corners: BTreeSet<u32> = faces.iter().flatten().copied().collect();
    let sum = |i: usize| corners.iter().map(|&n| at(n)[i]).sum::<f64>();
    [0, 1, 2].map(|i| sum(i) / corners.len() as f64)
}

/// V b of an element's corners \[m²\], b their mean gradients: of each face a part as large as those of its other corners.
pub(super) fn corner_areas(shape: Shape, x: &[[f64; 3]]) -> [[f64; 3]; 8] {
    let mut areas = [[0.0; 3]; 8];
    for face in shape.faces() {
        let (a, b) = match face[..] {
            [p, q, r] => (minus(x[q], x[p]), minus(x[r], x[p])),
            [p, q, r, s] => (minus(x[r], x[p]), minus(x[s], x[q])),
            _ => continue,
        };
        let area = cross(a, b).map(|c| 0.5 * c / face.len() as f64);
        for &k in *face {
            (0..3).for_each(|i| areas[k][i] += area[i]);
        }
    }
    areas
}

/// A length that goes with an element's own stable step: by the squares of its mean gradients, that of a cube is its edge.
pub(super) fn step_length(element: &Element, at: &impl Fn(u32) -> [f64; 3]) -> f64 {
    let x: Vec<[f64; 3]> = element.nodes().iter().map(|&n| at(n)).collect();
    let areas = corner_areas(element.shape, &x);
    let volume = quality::volume(element.shape, &x);
    let squares: f64 = areas.iter().map(|a| dot(*a, *a)).sum();
    if volume > 0.0 { volume * (1.5 / squares).sqrt() } else { 0.0 }
}

/// How good an element is beside one of `size`, by its Jacobian and its stable step.
fn worth(element: &Element, size: f64, at: &impl Fn(u32) -> [f64; 3]) -> f64 {
    let x: Vec<[f64; 3]> = element.nodes().iter().map(|&n| at(n)).collect();
    let jacobian = quality::scaled_jacobian(element.shape, &x);
    let jacobian = if jacobian.is_nan() { -1.0 } else { jacobian };
    jacobian.min(step_length(element, at) / size)
}

/// Divides a body whose faces are triangles and quadrilaterals, which stay, into elements of an edge of about `size`, and says how good the
/// worst of them is.
pub(super) fn divide(faces: &Faces, size: f64, at: &impl Fn(u32) -> [f64; 3]) -> (f64, Vec<Part>) {
    let (worth, parts, _) = search(faces, size, at, DEPTH);
    (worth, parts)
}

fn search(faces: &Faces, size: f64, at: &impl Fn(u32) -> [f64; 3], depth: usize) -> (f64, Vec<Part>, usize) {
    if let Some(made) = element(faces) {
        let tetrahedra = usize::from(made.shape == Shape::Tet4);
        return (worth(&made, size, at), vec![Part::Whole(made)], tetrahedra);
    }
    let own = middle(faces, at);
    let with = |n: u32| if n == u32::MAX { own } else { at(n) };
    let pieces = star(faces, u32::MAX);
    let least = pieces.iter().map(|e| worth(e, size, &with)).fold(f64::INFINITY, f64::min);
    let mut best = (least, vec![Part::Star(faces.clone())], faces.iter().filter(|f| f.len() == 3).count());
    if depth == 0 {
        return best;
    }
    let value = |found: &(f64, Vec<Part>, usize)| found.0 - TETRAHEDRON * found.2 as f64;
    for ring in rings(faces) {
        let Some([one, two]) = apart(faces, &ring) else { continue };
        let first = search(&one, size, at, depth - 1);
        if value(&first) <= value(&best) {
            continue;
        }
        let second = search(&two, size, at, depth - 1);
        let both = (first.0.min(second.0), [first.1, second.1].concat(), first.2 + second.2);
        if value(&both) > value(&best) {
            best = both;
        }
    }
    best
}

/// Rings of three and four edges that are no face.
fn rings(faces: &Faces) -> Vec<Vec<u32>> {
    let mut beside: BTreeMap<u32, BTreeSet<u32>> = BTreeMap::new();
    for face in faces {
        for (k, &a) in face.iter().enumerate() {
            let b = face[(k + 1) % face.len()];
            beside.entry(a).or_default().insert(b);
            beside.entry(b).or_default().insert(a);
        }
    }
    let known: BTreeSet<Vec<u32>> = faces
        .iter()
        .map(|face| {
            let mut face = face.clone();
            face.sort_unstable();
            face
        })
        .collect();
    let mut found = Vec::new();
    for (&a, of_a) in &beside {
        for &b in of_a.range(a + 1..) {
            for &c in beside[&b].range(a + 1..).filter(|c| **c != b) {
                if of_a.contains(&c) && b < c {
                    found.push(vec![a, b, c]);
                }
                // b < d, so that each ring is met once.
                for &d in beside[&c].range(b + 1..).filter(|d| **d != c && of_a.contains(d)) {
                    found.push(vec![a, b, c, d]);
                }
            }
        }
    }
    found.retain(|ring| {
        let mut ring = ring.clone();
        ring.sort_unstable();
        !known.contains(&ring)
    });
    found
}

/// The two bodies that a ring of edges parts, each closed by it; nothing if there are not two.
fn apart(faces: &Faces, ring: &[u32]) -> Option<[Faces; 2]> {
    let n = ring.len();
    let is = |a: u32, b: u32| (0..n).any(|k| ring[k] == a && ring[(k + 1) % n] == b);
    let mut side = vec![None; faces.len()];
    // Faces that have an edge of the ring in its direction are on one side, those against it on the other.
    for (f, face) in faces.iter().enumerate() {
        for (k, &a) in face.iter().enumerate() {
            let b = face[(k + 1) % face.len()];
            let here = if is(a, b) {
                0
            } else if is(b, a) {
                1
            } else {
                continue;
            };
            if side[f].replace(here).is_some_and(|s| s != here) {
                return None;
            }
        }
    }
    loop {
        let mut grown = false;
        for f in 0..faces.len() {
            if side[f].is_some() {
                continue;
            }
            let touches = |g: usize| {
                let edge = |k: usize| (faces[f][k], faces[f][(k + 1) % faces[f].len()]);
                (0..faces[f].len()).map(edge).any(|(a, b)| {
                    let m = faces[g].len();
                    !is(a, b) && !is(b, a) && (0..m).any(|k| faces[g][k] == b && faces[g][(k + 1) % m] == a)
                })
            };
            if let Some(g) = (0..faces.len()).find(|&g| side[g].is_some() && touches(g)) {
                side[f] = side[g];
                grown = true;
            }
        }
        if !grown {
            break;
        }
    }
    let mut halves: [Faces; 2] = Default::default();
    for (face, side) in faces.iter().zip(side) {
        halves[side?].push(face.clone());
    }
    if halves.iter().any(|half| half.len() < 3) {
        return None;
    }
    let mut back = ring.to_vec();
    back.reverse();
    // Faces of side 0 run along the ring, so their lid runs against it.
    halves[0].push(back);
    halves[1].push(ring.to_vec());
    halves.iter().all(closed).then_some(halves)
}

/// Whether every edge is met once each way.
fn closed(faces: &Faces) -> bool {
    let mut edges: BTreeSet<(u32, u32)> = BTreeSet::new();
    for face in faces {
        for (k, &a) in face.iter().enumerate() {
            if !edges.insert((a, face[(k + 1) % face.len()])) {
                return false;
            }
        }
    }
    edges.iter().all(|(a, b)| edges.contains(&(*b, *a)))
}

/// Closes a body by the ring of edges that its faces leave open; the lid as it is seen from outside it. Nothing if these are no ring.
pub(super) fn lid(faces: &Faces) -> Option<Vec<u32>> {
    let mut edges: BTreeSet<(u32, u32)> = BTreeSet::new();
    for face in faces {
        for (k, &a) in face.iter().enumerate() {
            if !edges.insert((a, face[(k + 1) % face.len()])) {
                return None;
            }
        }
    }
    let mut next: BTreeMap<u32, u32> = BTreeMap::new();
    for &(a, b) in edges.iter().filter(|(a, b)| !edges.contains(&(*b, *a))) {
        if next.insert(b, a).is_some() {
            return None;
        }
    }
    let first = *next.keys().next()?;
    let mut ring = vec![first];
    while let Some(&to) = next.get(&ring[ring.len() - 1]) {
        if to == first {
            return (ring.len() == next.len() && ring.len() >= 3).then_some(ring);
        }
        if ring.len() > next.len() {
            return None;
        }
        ring.push(to);
    }
    None
}
