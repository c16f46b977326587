//! How the nodes of a mesh may move where a plane needs it, in space.

use std::collections::{BTreeMap, HashMap, HashSet};

use crate::plane::Plane;
use crate::topology::{cross, dot, face_key, minus, norm};
use crate::{Face, Mesh};

/// cos of the turn beyond which a border has an edge, or an edge a corner, which must stay.
const CORNER: f64 = 0.77;
/// Normals of faces that differ by less are one plane's.
const FLAT: f64 = 1e-9;

/// How a node may move.
#[derive(Clone, Debug, Default)]
pub(super) enum Freedom {
    #[default]
    Free,
    /// In the plane border that it lies on, by its normal.
    Flat([f64; 3]),
    /// Along one of the borders' lines through it: the way to the node before and to the one behind.
    Lines(Vec<[[f64; 3]; 2]>),
}

impl Freedom {
    /// The shortest way onto a plane; nothing if there is none.
    pub fn onto(&self, plane: &Plane, x: [f64; 3]) -> Option<[f64; 3]> {
        let off = plane.distance(x);
        match self {
            Freedom::Free => Some(plane.normal.map(|n| -off * n)),
            Freedom::Flat(normal) => {
                let across = dot(plane.normal, *normal);
                let along: [f64; 3] = std::array::from_fn(|i| plane.normal[i] - across * normal[i]);
                let square = dot(along, along);
                (square > 1e-6).then(|| along.map(|a| -off * a / square))
            }
            Freedom::Lines(lines) => {
                let ways = lines.iter().filter_map(|line| meets(line, plane.normal, -off));
                ways.min_by(|a, b| norm(*a).total_cmp(&norm(*b)))
            }
        }
    }

    /// What of a way is open.
    pub fn follow(&self, way: [f64; 3]) -> [f64; 3] {
        match self {
            Freedom::Free => way,
            Freedom::Flat(normal) => {
                let across = dot(way, *normal);
                std::array::from_fn(|i| way[i] - across * normal[i])
            }
            Freedom::Lines(lines) => {
                let along = lines.iter().map(|line| {
                    let half = half(line);
                    at(line, (dot(way, half) / dot(half, half)).clamp(-0.5, 0.5))
                });
                along.max_by(|a, b| dot(*a, way).total_cmp(&dot(*b, way))).unwrap_or_default()
            }
        }
    }
}

fn half([before, behind]: &[[f64; 3]; 2]) -> [f64; 3] {
    std::array::from_fn(|i| 0.5 * (behind[i] - before[i]))
}

/// The way to the place `t` of the parabola through both neighbours, which are at −1 and 1.
fn at(line: &[[f64; 3]; 2], t: f64) -> [f64; 3] {
    let [before, behind] = line;
    let half = half(line);
    std::array::from_fn(|i| t * (half[i] + t * 0.5 * (behind[i] + before[i])))
}

/// The nearest way along a line at which n·way = `short`, up to the neighbours.
fn meets(line: &[[f64; 3]; 2], normal: [f64; 3], short: f64) -> Option<[f64; 3]> {
    let [before, behind] = line;
    let bend: [f64; 3] = std::array::from_fn(|i| 0.5 * (behind[i] + before[i]));
    let (a, b) = (dot(normal, bend), dot(normal, half(line)));
    if short == 0.0 {
        return Some([0.0; 3]);
    }
    // a t² + b t = short, without loss where a is small.
    let root = (b * b + 4.0 * a * short).max(0.0).sqrt();
    let t = 2.0 * short / (b + b.signum() * root);
    let meets = t.is_finite() && (a * t * t + b * t - short).abs() <= 1e-9 * short.abs().max(1e-12);
    (meets && t.abs() <= 1.0).then(|| at(line, t))
}

/// The freedom of the nodes of `near`, elements beside a plane. Borders are the mesh's outer faces, those between elements of unlike
/// `parts`, and those on `earlier` planes.
pub(super) fn of(mesh: &Mesh, near: &[u32], parts: &[u32], earlier: &[Plane]) -> HashMap<u32, Freedom> {
    let mut owners: BTreeMap<[u32; 4], Vec<Face>> = BTreeMap::new();
    for &element in near {
        for side in 0..mesh.elements[element as usize].shape.faces().len() as u8 {
            let face = Face { element, side };
            owners.entry(face_key(mesh, face)).or_default().push(face);
        }
    }
    let tolerance = {
        let (low, high) = mesh.bounds();
        1e-9 * norm(minus(high, low))
    };
    let cut = |face: Face| {
        let on = |plane: &Plane| {
            mesh.face_nodes(face).all(|n| plane.distance(mesh.nodes[n as usize]).abs() < tolerance)
        };
        earlier.iter().any(on)
    };
    // The normals of borders at nodes and at edges, as lines without direction.
    let mut edges: BTreeMap<[u32; 2], Vec<[f64; 3]>> = BTreeMap::new();
    let mut normals: BTreeMap<u32, Vec<[f64; 3]>> = BTreeMap::new();
    let mut seen: HashSet<u32> = HashSet::new();
    for faces in owners.values() {
        seen.extend(mesh.face_nodes(faces[0]));
        let border = match faces[..] {
            [a, b] => parts[a.element as usize] != parts[b.element as usize] || cut(a),
            _ => true,
        };
        if !border {
            continue;
        }
        let nodes: Vec<u32> = mesh.face_nodes(faces[0]).collect();
        let x: Vec<[f64; 3]> = nodes.iter().map(|&n| mesh.nodes[n as usize]).collect();
        let across = match x[..] {
            [a, b, c] => cross(minus(b, a), minus(c, a)),
            [a, b, c, d] => cross(minus(c, a), minus(d, b)),
            _ => continue,
        };
        let size = norm(across);
        let normal = across.map(|c| c / size);
        for (k, &a) in nodes.iter().enumerate() {
            let b = nodes[(k + 1) % nodes.len()];
            edges.entry([a.min(b), a.max(b)]).or_default().push(normal);
            normals.entry(a).or_default().push(normal);
        }
    }
    let mut at: BTreeMap<u32, Vec<(u32, bool)>> = BTreeMap::new();
    for (&[a, b], faces) in &edges {
        let sharp = match faces[..] {
            [one, two] => dot(one, two).abs() < CORNER,
            _ => true,
        };
        at.entry(a).or_default().push((b, sharp));
        at.entry(b).or_default().push((a, sharp));
    }
    let freedom = |n: u32| -> Freedom {
        let Some(normals) = normals.get(&n) else { return Freedom::Free };
        let first = normals[0];
        if normals.iter().all(|m| 1.0 - dot(first, *m).abs() < FLAT) {
            return Freedom::Flat(first);
        }
        let none = Vec::new();
        let beside = at.get(&n).unwrap_or(&none);
        let sharp: Vec<u32> = beside.iter().filter(|(_, sharp)| *sharp).map(|(m, _)| *m).collect();
        let way = |m: u32| minus(mesh.nodes[m as usize], mesh.nodes[n as usize]);
        let line = |a: u32, b: u32| {
            let (one, two) = (way(a), way(b));
            (dot(one, two) < -CORNER * norm(one) * norm(two)).then_some([one, two])
        };
        let mut lines = Vec::new();
        match sharp[..] {
            [] => {
                for (k, &(a, _)) in beside.iter().enumerate() {
                    lines.extend(beside[k + 1..].iter().filter_map(|&(b, _)| line(a, b)));
                }
            }
            [a, b] => lines.extend(line(a, b)),
            _ => {}
        }
        Freedom::Lines(lines)
    };
    seen.into_iter().map(|n| (n, freedom(n))).collect()
}
