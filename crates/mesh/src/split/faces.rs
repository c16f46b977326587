//! The faces of an interface: shared by its two sides, or at the same place where a mesh comes split.

use std::collections::{BTreeMap, HashMap};
use std::ops::Range;

use super::{Cut, SplitError, meet};
use crate::coincident::{coincident_nodes, shortest_edge, squared_distance};
use crate::topology::{all_faces, corner_areas, dot, exterior_faces, face_key};
use crate::{Face, Mesh};

/// Nodes nearer than this times the shortest edge are at the same place.
const SAME_PLACE: f64 = 1e-6;

/// Faces of all interfaces.
pub(super) struct Found {
    /// By cut, ascending.
    pub faces: Vec<Vec<[Face; 2]>>,
    /// Those of them that came split.
    pub apart: Vec<[Face; 2]>,
    /// Nodes at the place of an earlier one, with that.
    pub earlier: BTreeMap<u32, u32>,
}

/// # Errors
/// All that [`SplitError`] knows.
pub(super) fn find(mesh: &Mesh, cuts: &[Cut], times: &[Range<u32>]) -> Result<Found, SplitError> {
    let earlier: BTreeMap<u32, u32> =
        coincident_nodes(mesh, SAME_PLACE * shortest_edge(mesh)).into_iter().collect();
    let touching = touching_faces(mesh, times, &earlier);
    let mut found = Found { faces: Vec::new(), apart: Vec::new(), earlier };
    let mut claims: HashMap<[Face; 2], usize> = HashMap::new();
    let mut side_of = vec![0_u8; mesh.elements.len()];
    for (c, cut) in cuts.iter().enumerate() {
        let sides = sides(mesh, cut, times, &mut side_of)?;
        let mut faces = shared(mesh, cut, times, &sides)?;
        let side = |face: Face| (side_of[face.element as usize], face);
        for same in touching.chunk_by(|a, b| a.0 == b.0) {
            let same: Vec<(u8, Face)> = same.iter().map(|&(_, face)| side(face)).collect();
            let pairs = across(mesh, cut, times, &same, |pair| opposed(mesh, pair))?;
            faces.extend_from_slice(&pairs);
            found.apart.extend(pairs);
        }
        if faces.is_empty() {
            return Err(SplitError::Apart { name: cut.name.to_owned(), distance: distance(mesh, &sides) });
        }
        for &pair in &faces {
            if let Some(first) = claims.insert(sorted(pair), c) {
                return Err(SplitError::Claimed {
                    first: cuts[first].name.to_owned(),
                    second: cut.name.to_owned(),
                    element: mesh.element_id(pair[0].element as usize),
                });
            }
        }
        faces.sort_unstable();
        found.faces.push(faces);
        for &element in sides.iter().flatten() {
            side_of[element as usize] = 0;
        }
    }
    Ok(found)
}

/// The elements of both sides that are there, each once; marks them with 1 and 2.
fn sides(
    mesh: &Mesh,
    cut: &Cut,
    times: &[Range<u32>],
    side_of: &mut [u8],
) -> Result<[Vec<u32>; 2], SplitError> {
    let name = || cut.name.to_owned();
    let sides = cut.sides.map(|elements| {
        let mut sorted = elements.to_vec();
        sorted.sort_unstable();
        sorted.dedup();
        sorted
    });
    if let Some(&both) = sides[1].iter().find(|e| sides[0].binary_search(e).is_ok()) {
        return Err(SplitError::BothSides { name: name(), element: mesh.element_id(both as usize) });
    }
    let there = |e: &u32| !times[*e as usize].is_empty();
    let sides = sides.map(|side| side.into_iter().filter(there).collect::<Vec<_>>());
    for (side, number) in sides.iter().zip([1, 2]) {
        if side.is_empty() {
            return Err(SplitError::Empty { name: name(), side: number });
        }
        for &element in side {
            side_of[element as usize] = number;
        }
    }
    Ok(sides)
}

/// Faces that an element of one side shares with one of the other.
fn shared(
    mesh: &Mesh,
    cut: &Cut,
    times: &[Range<u32>],
    sides: &[Vec<u32>; 2],
) -> Result<Vec<[Face; 2]>, SplitError> {
    // Only a face with all its nodes in both sides can be one, so few keys are made.
    let mut reached = vec![0_u8; mesh.nodes.len()];
    for (side, mark) in sides.iter().zip([1, 2]) {
        for &element in side {
            for &node in mesh.elements[element as usize].nodes() {
                reached[node as usize] |= mark;
            }
        }
    }
    let mut keyed = Vec::new();
    for (side, mark) in sides.iter().zip([1_u8, 2]) {
        for face in all_faces(mesh, Some(side)) {
            if mesh.face_nodes(face).all(|n| reached[n as usize] == 3) {
                keyed.push((face_key(mesh, face), mark, face));
            }
        }
    }
    keyed.sort_unstable();
    let mut pairs = Vec::new();
    for same in keyed.chunk_by(|a, b| a.0 == b.0) {
        let same: Vec<(u8, Face)> = same.iter().map(|&(_, mark, face)| (mark, face)).collect();
        pairs.extend(across(mesh, cut, times, &same, |_| true)?);
    }
    Ok(pairs)
}

/// Of faces at one place with their sides, each of the first side with that of the second that is there at the same time, if
/// that suits.
fn across(
    mesh: &Mesh,
    cut: &Cut,
    times: &[Range<u32>],
    same: &[(u8, Face)],
    suits: impl Fn([Face; 2]) -> bool,
) -> Result<Vec<[Face; 2]>, SplitError> {
    let of = |side: u8| same.iter().filter(move |(mark, _)| *mark == side).map(|(_, face)| *face);
    let together = |a: Face, b: Face| meet(&times[a.element as usize], &times[b.element as usize]);
    let mut pairs = Vec::new();
    for first in of(1) {
        for second in of(2).filter(|&second| together(first, second)) {
            let twin = |side: u8, own: Face| {
                of(side).find(|&f| f != own && together(f, first) && together(f, second)).map(|f| [own, f])
            };
            if let Some([own, other]) = twin(1, first).or(twin(2, second)) {
                return Err(crowded(mesh, cut, own.min(other), own.max(other)));
            }
            if suits([first, second]) {
                pairs.push([first, second]);
            }
        }
    }
    Ok(pairs)
}

/// The two faces of a pair, ascending.
pub(super) fn sorted([a, b]: [Face; 2]) -> [Face; 2] {
    [a.min(b), a.max(b)]
}

/// Faces that no other shares at the same time, but which are at the place of another, by place.
fn touching_faces(mesh: &Mesh, times: &[Range<u32>], earlier: &BTreeMap<u32, u32>) -> Vec<([u32; 4], Face)> {
    if earlier.is_empty() {
        return Vec::new();
    }
    let mut place: Vec<u32> = (0..mesh.nodes.len() as u32).collect();
    let mut twin = vec![false; mesh.nodes.len()];
    for (&node, &first) in earlier {
        place[node as usize] = first;
        twin[node as usize] = true;
        twin[first as usize] = true;
    }
    let time = |face: Face| &times[face.element as usize];
    let near = |face: &Face| !time(*face).is_empty() && mesh.face_nodes(*face).any(|n| twin[n as usize]);
    let mut keyed: Vec<([u32; 4], Face)> =
        all_faces(mesh, None).filter(near).map(|face| (face_key(mesh, face), face)).collect();
    keyed.sort_unstable();
    let alone = keyed.chunk_by(|a, b| a.0 == b.0).flat_map(|same| {
        let shared = |own: Face| same.iter().any(|&(_, f)| f != own && meet(time(f), time(own)));
        same.iter().copied().filter(move |&(_, own)| !shared(own))
    });
    let mut placed: Vec<([u32; 4], Face)> = alone
        .map(|(key, face)| {
            let mut key = key.map(|n| place.get(n as usize).copied().unwrap_or(n));
            key.sort_unstable();
            (key, face)
        })
        .collect();
    placed.sort_unstable();
    placed.chunk_by(|a, b| a.0 == b.0).filter(|same| same.len() > 1).flatten().copied().collect()
}

/// Whether two faces at one place look at each other: bodies that overlap may end at the same place, and do not touch there.
fn opposed(mesh: &Mesh, [first, second]: [Face; 2]) -> bool {
    let outward = |face| {
        let (_, shares) = corner_areas(mesh, face);
        shares.iter().fold([0.0; 3], |sum, (a, _)| [0, 1, 2].map(|i| sum[i] + a[i]))
    };
    dot(outward(first), outward(second)) < 0.0
}

fn crowded(mesh: &Mesh, cut: &Cut, first: Face, second: Face) -> SplitError {
    let [first, second] = [first, second].map(|face| mesh.element_id(face.element as usize));
    SplitError::Crowded { name: cut.name.to_owned(), first, second }
}

/// Smallest distance \[m\] between nodes of the faces of two sides.
fn distance(mesh: &Mesh, sides: &[Vec<u32>; 2]) -> f64 {
    let [own, mut other] = [&sides[0], &sides[1]].map(|side| {
        let mut nodes: Vec<u32> = exterior_faces(mesh, Some(side))
            .into_iter()
            .flat_map(|face| mesh.face_nodes(face).collect::<Vec<_>>())
            .collect();
        nodes.sort_unstable();
        nodes.dedup();
        nodes.into_iter().map(|n| mesh.nodes[n as usize]).collect::<Vec<_>>()
    });
    other.sort_unstable_by(|a, b| a[0].total_cmp(&b[0]));
    let mut best = f64::INFINITY;
    for x in &own {
        let middle = other.partition_point(|y| y[0] < x[0]);
        // Outwards both ways, until the first coordinate alone is farther than the best.
        let mut look = |y: &[f64; 3]| {
            best = best.min(squared_distance(x, y));
            (y[0] - x[0]).powi(2) <= best
        };
        let _ = other[middle..].iter().all(&mut look) & other[..middle].iter().rev().all(&mut look);
    }
    best.sqrt()
}
