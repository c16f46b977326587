//! The faces of an interface: shared by its two sides, or at the same place where a mesh comes split.

use std::collections::{BTreeMap, HashMap};

use super::{Cut, SplitError};
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
pub(super) fn find(mesh: &Mesh, cuts: &[Cut], there: &[bool]) -> Result<Found, SplitError> {
    let earlier: BTreeMap<u32, u32> =
        coincident_nodes(mesh, SAME_PLACE * shortest_edge(mesh)).into_iter().collect();
    let touching = touching_faces(mesh, there, &earlier);
    let mut found = Found { faces: Vec::new(), apart: Vec::new(), earlier };
    let mut claims: HashMap<Face, usize> = HashMap::new();
    let mut side_of = vec![0_u8; mesh.elements.len()];
    for (c, cut) in cuts.iter().enumerate() {
        let sides = sides(mesh, cut, there, &mut side_of)?;
        let mut faces = shared(mesh, cut, &sides)?;
        let of_side = |face: &Face| side_of[face.element as usize];
        for same in touching.chunk_by(|a, b| a.0 == b.0) {
            let same = same.iter().map(|&(_, face)| face);
            let pair = opposed(mesh, cut, same, of_side)?;
            faces.extend(pair);
            found.apart.extend(pair);
        }
        if faces.is_empty() {
            return Err(SplitError::Apart { name: cut.name.to_owned(), distance: distance(mesh, &sides) });
        }
        for &face in faces.iter().flatten() {
            if let Some(first) = claims.insert(face, c) {
                return Err(SplitError::Claimed {
                    first: cuts[first].name.to_owned(),
                    second: cut.name.to_owned(),
                    element: mesh.element_id(face.element as usize),
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
fn sides(mesh: &Mesh, cut: &Cut, there: &[bool], side_of: &mut [u8]) -> Result<[Vec<u32>; 2], SplitError> {
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
    let sides = sides.map(|side| side.into_iter().filter(|&e| there[e as usize]).collect::<Vec<_>>());
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
fn shared(mesh: &Mesh, cut: &Cut, sides: &[Vec<u32>; 2]) -> Result<Vec<[Face; 2]>, SplitError> {
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
        match same {
            [(_, 1, first), (_, 2, second)] => pairs.push([*first, *second]),
            [(_, 1, _), .., (_, 2, second)] => return Err(crowded(mesh, cut, same[1].2, *second)),
            _ => {}
        }
    }
    Ok(pairs)
}

/// Faces of elements that are there which no other shares, but which are at the place of another, by place.
fn touching_faces(mesh: &Mesh, there: &[bool], earlier: &BTreeMap<u32, u32>) -> Vec<([u32; 4], Face)> {
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
    let near = |face: &Face| there[face.element as usize] && mesh.face_nodes(*face).any(|n| twin[n as usize]);
    let mut keyed: Vec<([u32; 4], Face)> =
        all_faces(mesh, None).filter(near).map(|face| (face_key(mesh, face), face)).collect();
    keyed.sort_unstable();
    let alone = keyed.chunk_by(|a, b| a.0 == b.0).filter(|same| same.len() == 1);
    let mut placed: Vec<([u32; 4], Face)> = alone
        .map(|same| {
            let (key, face) = same[0];
            let mut key = key.map(|n| place.get(n as usize).copied().unwrap_or(n));
            key.sort_unstable();
            (key, face)
        })
        .collect();
    placed.sort_unstable();
    placed.chunk_by(|a, b| a.0 == b.0).filter(|same| same.len() > 1).flatten().copied().collect()
}

/// Of faces at one place, that of the first side with that of the second, if both are there and look at each other.
fn opposed(
    mesh: &Mesh,
    cut: &Cut,
    same: impl Iterator<Item = Face> + Clone,
    of_side: impl Fn(&Face) -> u8,
) -> Result<Option<[Face; 2]>, SplitError> {
    let mut own = same.clone().filter(|face| of_side(face) == 1);
    let mut other = same.filter(|face| of_side(face) == 2);
    let (Some(first), Some(second)) = (own.next(), other.next()) else { return Ok(None) };
    if let Some(third) = own.next().or(other.next()) {
        return Err(crowded(mesh, cut, first, third));
    }
    // Bodies that overlap may end at the same place; they do not touch there.
    let outward = |face| {
        let (_, shares) = corner_areas(mesh, face);
        shares.iter().fold([0.0; 3], |sum, (a, _)| [0, 1, 2].map(|i| sum[i] + a[i]))
    };
    Ok((dot(outward(first), outward(second)) < 0.0).then_some([first, second]))
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
