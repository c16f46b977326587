//! Solid cells as hexahedra: others have corners that coincide, such that the six faces still cover them.

/// Faces by local corners in VTK's order, counter-clockwise from outside: −x, +x, −y, +y, −z, +z.
pub const FACES: [[usize; 4]; 6] =
    [[0, 4, 7, 3], [1, 2, 6, 5], [0, 1, 5, 4], [3, 7, 6, 2], [0, 3, 2, 1], [4, 5, 6, 7]];

/// The corners of a cell of VTK's type `kind`; none where it is no linear solid.
pub fn corners(kind: u8, points: &[u32]) -> Option<[u32; 8]> {
    let order: [usize; 8] = match kind {
        10 => [0, 1, 2, 2, 3, 3, 3, 3],
        12 => [0, 1, 2, 3, 4, 5, 6, 7],
        13 => [0, 1, 2, 2, 3, 4, 5, 5],
        14 => [0, 1, 2, 3, 4, 4, 4, 4],
        _ => return None,
    };
    points.len().gt(order.iter().max()?).then(|| order.map(|k| points[k]))
}

/// Volume (m³) within the faces, each cut into two triangles.
pub fn volume(corner: &[[f64; 3]; 8]) -> f64 {
    let from = |k: usize| [0, 1, 2].map(|i| corner[k][i] - corner[0][i]);
    let triple = |a: [f64; 3], b: [f64; 3], c: [f64; 3]| {
        a[0] * (b[1] * c[2] - b[2] * c[1])
            + a[1] * (b[2] * c[0] - b[0] * c[2])
            + a[2] * (b[0] * c[1] - b[1] * c[0])
    };
    let face =
        |[a, b, c, d]: [usize; 4]| triple(from(a), from(b), from(c)) + triple(from(a), from(c), from(d));
    FACES.into_iter().map(face).sum::<f64>() / 6.0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The unit tetrahedron, the unit cube, half of it, and the pyramid over its floor.
    #[test]
    fn faces_enclose_every_kind_of_cell_outward() {
        let enclosed = |points: &[[f64; 3]], kind: u8| {
            let numbers: Vec<u32> = (0..points.len() as u32).collect();
            volume(&corners(kind, &numbers).unwrap().map(|k| points[k as usize]))
        };
        let (o, x, y, z) = ([0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
        let (xy, xz, yz, xyz) = ([1.0, 1.0, 0.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0], [1.0; 3]);
        // Sums of a few halves: round-off alone.
        assert!((enclosed(&[o, x, y, z], 10) - 1.0 / 6.0).abs() < 1e-15);
        assert!((enclosed(&[o, x, xy, y, z, xz, xyz, yz], 12) - 1.0).abs() < 1e-15);
        assert!((enclosed(&[o, x, y, z, xz, yz], 13) - 0.5).abs() < 1e-15);
        assert!((enclosed(&[o, x, xy, y, z], 14) - 1.0 / 3.0).abs() < 1e-15);
        assert_eq!(corners(5, &[0, 1, 2]), None);
        assert_eq!(corners(12, &[0, 1, 2]), None);
    }
}
