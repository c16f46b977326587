//! Face corners at the same two nodes, and which of them belong to one smooth piece of the surface.

use crate::coincident::squared_distance;
use crate::topology::{CornerArea, FaceCorners, corner_areas, cross, dot, norm, root};
use crate::{Face, Mesh};

/// Largest angle \[rad\] between normals of one pair, 60°: beyond it their mean says little of any (an assumption).
const WIDEST: f64 = std::f64::consts::FRAC_PI_3;

/// Angles \[rad\] that differ by less are equal: well above round-off, well below what a mesh maker means.
const EQUAL: f64 = 1e-6;

/// Edges are one if their far ends are within this part of their length.
const SAME_EDGE: f64 = 1e-5;

/// One corner of a face of the first side.
pub(super) struct Corner {
    /// Index of the face pair, corner of the first side's face.
    pub at: (u32, u8),
    /// ∫ N_i n dA and ∫ N_i dA.
    pub share: CornerArea,
    /// Mean normal of the face.
    normal: [f64; 3],
    /// Place of the node, and of the ends of the face's two edges there.
    place: [f64; 3],
    ends: [[f64; 3]; 2],
}

/// The corners of a pair of faces with their two nodes, if these differ.
pub(super) fn corners(
    mesh: &Mesh,
    index: u32,
    first: Face,
    second: Face,
) -> impl Iterator<Item = ([u32; 2], Corner)> {
    let place = |node: u32| mesh.nodes[node as usize];
    let (own, shares) = corner_areas(mesh, first);
    let other = FaceCorners::new(mesh, second);
    let count = own.nodes().len();
    let sum = shares[..count].iter().fold([0.0; 3], |s, (a, _)| [0, 1, 2].map(|i| s[i] + a[i]));
    let longest = (0..count)
        .map(|k| squared_distance(&place(own.nodes()[k]), &place(own.nodes()[(k + 1) % count])))
        .fold(0.0, f64::max);
    // What round-off leaves of no area is no direction.
    let count_used = if norm(sum) > 1e-12 * longest { count } else { 0 };
    (0..count_used).filter_map(move |k| {
        let node = own.nodes()[k];
        let away = |n: u32| squared_distance(&place(n), &place(node));
        let partner = other.nodes().iter().copied().min_by(|&a, &b| away(a).total_cmp(&away(b)))?;
        let ends = [k + 1, k + count - 1].map(|k| place(own.nodes()[k % count]));
        let normal = sum.map(|a| a / norm(sum));
        let corner = Corner { at: (index, k as u8), share: shares[k], normal, place: place(node), ends };
        (partner != node).then_some(([node, partner], corner))
    })
}

/// The smooth pieces of the corners at one pair of nodes, by indices, ascending.
pub(super) fn parts(corners: &[Corner], sharp: f64) -> Vec<Vec<usize>> {
    let mut edges: Vec<(usize, usize, f64)> = Vec::new();
    for j in 1..corners.len() {
        for i in 0..j {
            let angle = angle(corners[i].normal, corners[j].normal);
            if angle < sharp - EQUAL && share_edge(&corners[i], &corners[j]) {
                edges.push((i, j, angle));
            }
        }
    }
    let mut parts = Vec::new();
    let mut open: Vec<Vec<usize>> = connected((0..corners.len()).collect(), &edges);
    while let Some(part) = open.pop() {
        if span(corners, &part) <= WIDEST + EQUAL {
            parts.push(part);
            continue;
        }
        let inside = |edge: &&(usize, usize, f64)| part.contains(&edge.0);
        let sharpest = edges.iter().filter(inside).map(|e| e.2).fold(0.0, f64::max);
        edges.retain(|edge| !part.contains(&edge.0) || edge.2 < sharpest - EQUAL);
        open.extend(connected(part, &edges));
    }
    parts.sort_unstable();
    parts
}

/// Pieces of `part` (ascending) that hang together across the edges.
fn connected(part: Vec<usize>, edges: &[(usize, usize, f64)]) -> Vec<Vec<usize>> {
    let place = |corner: &usize| part.iter().position(|c| c == corner);
    let mut parent: Vec<u32> = (0..part.len() as u32).collect();
    for (i, j, _) in edges {
        if let (Some(i), Some(j)) = (place(i), place(j)) {
            let (a, b) = (root(&mut parent, i as u32), root(&mut parent, j as u32));
            parent[a.max(b) as usize] = a.min(b);
        }
    }
    let mut pieces = vec![Vec::new(); part.len()];
    for (k, &corner) in part.iter().enumerate() {
        pieces[root(&mut parent, k as u32) as usize].push(corner);
    }
    pieces.retain(|piece| !piece.is_empty());
    pieces
}

/// Whether two faces meet at an edge that ends here. By place: the far ends may be different copies.
fn share_edge(a: &Corner, b: &Corner) -> bool {
    a.ends.iter().any(|x| {
        let near = SAME_EDGE * SAME_EDGE * squared_distance(x, &a.place);
        b.ends.iter().any(|y| squared_distance(x, y) <= near)
    })
}

/// Largest angle \[rad\] between the normals of any two.
fn span(corners: &[Corner], part: &[usize]) -> f64 {
    let mut span = 0.0_f64;
    for (k, &i) in part.iter().enumerate() {
        for &j in &part[..k] {
            span = span.max(angle(corners[i].normal, corners[j].normal));
        }
    }
    span
}

/// Angle \[rad\] between two vectors, exact near 0 as well.
fn angle(a: [f64; 3], b: [f64; 3]) -> f64 {
    norm(cross(a, b)).atan2(dot(a, b))
}
