//! Pairs of nodes across an interface: their normals, areas and tangents.

mod surface;

use std::collections::BTreeMap;

use crate::topology::{cross, norm};
use crate::{Face, Mesh};
use surface::{Corner, parts};

/// Angle \[rad\] from which on an edge of an interface is a corner, if nothing else is asked for: 45°.
pub const CORNER: f64 = std::f64::consts::FRAC_PI_4;

/// Two nodes that face each other across an interface. Areas in m².
#[derive(Clone, Debug, PartialEq)]
pub struct PairShape {
    /// Of the first side and of the second.
    pub nodes: [u32; 2],
    /// Unit vector out of the first side into the second: that of Σ ∫ N_i n dA over the pair's face corners.
    pub normal: [f64; 3],
    /// The length of that sum.
    pub normal_area: f64,
    /// Σ ∫ N_i dA; no less than `normal_area`, and equal to it on a plane.
    pub area: f64,
    /// The face corners of the pair, ascending: index of the face pair, corner of the first side's face.
    pub corners: Vec<(u32, u8)>,
}

/// The pairs of an interface, from its faces after the split; ordered by their nodes, then by their first corner.
///
/// Face corners with the same two nodes make one pair if their faces hang together there across edges at which they
/// meet at less than `corner` \[rad\] ([`CORNER`]), directly or through others; a sharper edge has a pair for each
/// side. The angle is that between the faces' mean normals; one that equals `corner` to round-off counts as sharp, so
/// an octagon's edges are corners at 45°. Where normals of one pair would span more than 60° it is parted at its
/// sharpest edge, at all of them if several are equally sharp, and so on.
///
/// Areas are those of the first side's faces: quadrilaterals by 2 × 2 Gauss points, which is exact for `normal_area`
/// and, if they are flat, for `area`. Corners whose two nodes are one (an interface's end) make no pair, nor do those
/// of a face without area.
///
/// # Panics
/// If a face is not in the mesh.
pub fn pairs(mesh: &Mesh, faces: &[[Face; 2]], corner: f64) -> Vec<PairShape> {
    let mut by_nodes: BTreeMap<[u32; 2], Vec<Corner>> = BTreeMap::new();
    for (index, &[first, second]) in (0..).zip(faces) {
        for (nodes, corner) in surface::corners(mesh, index, first, second) {
            by_nodes.entry(nodes).or_default().push(corner);
        }
    }
    let mut pairs = Vec::new();
    for (nodes, corners) in by_nodes {
        for part in parts(&corners, corner) {
            let mut vector = [0.0; 3];
            let mut area = 0.0;
            for own in part.iter().map(|&k| &corners[k]) {
                vector = [0, 1, 2].map(|i| vector[i] + own.share.0[i]);
                area += own.share.1;
            }
            let normal_area = norm(vector);
            if normal_area > 0.0 {
                let normal = vector.map(|a| a / normal_area);
                let corners = part.iter().map(|&k| corners[k].at).collect();
                pairs.push(PairShape { nodes, normal, normal_area, area, corners });
            }
        }
    }
    pairs
}

/// Two unit vectors that with the unit `normal` m make a right-handed frame (e1, e2, m).
///
/// e1 is horizontal, z × m normalised; where m is vertical (|m_h| < 1e-6) it is along x. e2 = m × e1 points up the
/// dip.
pub fn tangents(normal: [f64; 3]) -> [[f64; 3]; 2] {
    let m = normal;
    let horizontal = m[0].hypot(m[1]);
    let e1 = if horizontal < 1e-6 {
        // Square to m to round-off, which x itself need not be.
        let x = [1.0 - m[0] * m[0], -m[0] * m[1], -m[0] * m[2]];
        x.map(|c| c / norm(x))
    } else {
        [-m[1] / horizontal, m[0] / horizontal, 0.0]
    };
    [e1, cross(m, e1)]
}

#[cfg(test)]
mod tests;
