//! Nodes of opposite sides of a split mesh.

use std::collections::{BTreeMap, HashMap};

use super::UnmatchedSplit;
use crate::topology::match_faces;
use crate::{Face, Mesh};

/// Pairs of nodes of two opposite sides of a split mesh, for periodic ties; ascending.
///
/// Origins (`split_origin`: [`Split::origin`](super::Split::origin), or
/// [`Split::places`](super::Split::places) for a mesh that came split) are paired by
/// [`match_faces`]. Where they have copies on these faces, a face tells which belongs to which: its corners have those
/// of the face whose origins are the partners of its own. Without copies the pairs are those of [`match_faces`].
///
/// Faces should be those of elements that are there, since others keep the nodes of the file. A copy that reaches a
/// side with no face of its elements is no node of that side and stays without a partner.
///
/// # Errors
/// If the origins do not match, or if a copy does not have just one partner.
///
/// # Panics
/// If a face is not in the mesh, a node has no origin, or `axis` is not 0, 1 or 2.
pub fn match_split(
    mesh: &Mesh,
    split_origin: &[u32],
    faces_low: &[Face],
    faces_high: &[Face],
    axis: usize,
    tolerance: f64,
) -> Result<Vec<(u32, u32)>, UnmatchedSplit> {
    let origin = |node: u32| split_origin[node as usize];
    let [low, high] = [faces_low, faces_high].map(|faces| Copies::new(mesh, split_origin, faces));
    let of_origins = match_faces(mesh, &low.origins(), &high.origins(), axis, tolerance)?;
    let partner: BTreeMap<u32, u32> = of_origins.iter().copied().collect();

    let mut pairs: Vec<(u32, u32)> = Vec::with_capacity(of_origins.len());
    let mut split = false;
    for &(a, b) in &of_origins {
        match (low.of(a), high.of(b)) {
            (&[a], &[b]) => pairs.push((a, b)),
            _ => split = true,
        }
    }
    if split {
        let opposite: HashMap<[u32; 4], Face> =
            faces_high.iter().map(|&face| (origin_key(mesh, face, origin), face)).collect();
        let mut found: BTreeMap<u32, u32> = BTreeMap::new();
        for &face in faces_low {
            if mesh.face_nodes(face).all(|n| alone(&low, &high, &partner, origin(n))) {
                continue;
            }
            let key = origin_key(mesh, face, |n| partner[&origin(n)]);
            let Some(&other) = opposite.get(&key) else { continue };
            for a in mesh.face_nodes(face).filter(|&n| !alone(&low, &high, &partner, origin(n))) {
                let b = mesh.face_nodes(other).find(|&b| origin(b) == partner[&origin(a)]);
                let Some(b) = b else { continue };
                if found.insert(a, b).is_some_and(|before| before != b) {
                    return Err(UnmatchedSplit::Copies { node: mesh.node_id(a as usize) });
                }
            }
        }
        let mut taken: HashMap<u32, u32> = HashMap::new();
        for (&a, &b) in &found {
            if taken.insert(b, a).is_some() {
                return Err(UnmatchedSplit::Copies { node: mesh.node_id(b as usize) });
            }
        }
        for (&a, &b) in partner.iter().filter(|&(&a, _)| !alone(&low, &high, &partner, a)) {
            let lonely = low.of(a).iter().find(|node| !found.contains_key(node));
            let lonely = lonely.or(high.of(b).iter().find(|node| !taken.contains_key(node)));
            if let Some(&node) = lonely {
                return Err(UnmatchedSplit::Copies { node: mesh.node_id(node as usize) });
            }
        }
        pairs.extend(found);
    }
    pairs.sort_unstable();
    Ok(pairs)
}

/// Whether an origin and its partner have one node each.
fn alone(low: &Copies, high: &Copies, partner: &BTreeMap<u32, u32>, origin: u32) -> bool {
    low.of(origin).len() == 1 && high.of(partner[&origin]).len() == 1
}

/// The mapped nodes of a face in ascending order; a triangle's fourth is `u32::MAX`.
fn origin_key(mesh: &Mesh, face: Face, map: impl Fn(u32) -> u32) -> [u32; 4] {
    let mut key = [u32::MAX; 4];
    for (place, node) in key.iter_mut().zip(mesh.face_nodes(face)) {
        *place = map(node);
    }
    key.sort_unstable();
    key
}

/// The nodes of a side by origin, both ascending.
struct Copies(BTreeMap<u32, Vec<u32>>);

impl Copies {
    fn new(mesh: &Mesh, split_origin: &[u32], faces: &[Face]) -> Self {
        let mut copies: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        for &face in faces {
            for node in mesh.face_nodes(face) {
                copies.entry(split_origin[node as usize]).or_default().push(node);
            }
        }
        for nodes in copies.values_mut() {
            nodes.sort_unstable();
            nodes.dedup();
        }
        Copies(copies)
    }

    fn origins(&self) -> Vec<u32> {
        self.0.keys().copied().collect()
    }

    fn of(&self, origin: u32) -> &[u32] {
        self.0.get(&origin).map_or(&[], Vec::as_slice)
    }
}
