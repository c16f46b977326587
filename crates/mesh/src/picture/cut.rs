//! Where a plane across y cuts the elements.

use crate::Mesh;

/// The elements that the plane cuts, and the polygon (x, z) of each.
pub(super) fn pieces(mesh: &Mesh, y: f64) -> Vec<(u32, Vec<[f64; 2]>)> {
    let mut pieces = Vec::new();
    for (e, element) in mesh.elements.iter().enumerate() {
        let at = |k: usize| mesh.nodes[element.nodes[k] as usize];
        // A node on the plane counts as above, so that of two elements that meet there one is cut.
        let above = |k: usize| at(k)[1] >= y;
        let mut points: Vec<[f64; 2]> = Vec::new();
        for face in element.shape.faces() {
            for i in 0..face.len() {
                // Each edge belongs to two faces, which run along it in opposite senses.
                let (a, b) = (face[i], face[(i + 1) % face.len()]);
                if !above(a) && above(b) {
                    let (p, q) = (at(a), at(b));
                    let s = (y - p[1]) / (q[1] - p[1]);
                    points.push([p[0] + s * (q[0] - p[0]), p[2] + s * (q[2] - p[2])]);
                }
            }
        }
        if points.len() < 3 || points.as_flattened().iter().any(|x| !x.is_finite()) {
            continue;
        }
        let n = points.len() as f64;
        let middle = [0, 1].map(|c| points.iter().map(|p| p[c]).sum::<f64>() / n);
        let angle = |p: &[f64; 2]| (p[1] - middle[1]).atan2(p[0] - middle[0]);
        points.sort_by(|p, q| angle(p).total_cmp(&angle(q)));
        pieces.push((e as u32, points));
    }
    pieces
}
