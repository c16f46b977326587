//! A mesh put where a model wants it: its axis that points up, its unit, its direction, its place.

use std::f64::consts::FRAC_PI_2;

use crate::Mesh;
use crate::assembly::mirror;

/// Axis of a file's coordinates that points up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Up {
    X,
    Y,
    Z,
}

/// What is done to the coordinates, in this order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Turned upright: y up by x → x, y → z, z → −y; x up by x → z, y → y, z → −x.
    pub up: Up,
    /// Factor along each axis. An odd number of negative ones mirrors the mesh.
    pub scale: [f64; 3],
    /// About the z axis \[rad\], counter-clockwise seen from above.
    pub rotation: f64,
    /// \[m\]
    pub shift: [f64; 3],
}

impl Placement {
    /// Everything stays.
    pub const AS_IT_IS: Placement = Placement { up: Up::Z, scale: [1.0; 3], rotation: 0.0, shift: [0.0; 3] };

    /// A point once placed.
    fn point(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let upright = match self.up {
            Up::X => [-z, y, x],
            Up::Y => [x, -z, y],
            Up::Z => [x, y, z],
        };
        let [x, y, z] = std::array::from_fn(|i| upright[i] * self.scale[i]);
        let (sine, cosine) = turn(self.rotation);
        let turned = [x * cosine - y * sine, x * sine + y * cosine, z];
        std::array::from_fn(|i| turned[i] + self.shift[i])
    }

    /// Moves a mesh with its named points. Elements of a mirrored mesh are renumbered, so that they stay valid; groups and
    /// named faces stay with them.
    pub fn apply(&self, mesh: &mut Mesh) {
        for x in mesh.nodes.iter_mut().chain(mesh.points.values_mut()) {
            *x = self.point(*x);
        }
        if self.scale.iter().product::<f64>() < 0.0 {
            mirror(mesh);
        }
    }
}

/// Sine and cosine of an angle \[rad\], exact for whole right angles, which an angle in degrees misses by round-off.
pub(crate) fn turn(angle: f64) -> (f64, f64) {
    let quarters = (angle / FRAC_PI_2).round();
    if (angle - quarters * FRAC_PI_2).abs() > 4.0 * f64::EPSILON * angle.abs() {
        return angle.sin_cos();
    }
    [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)][quarters.rem_euclid(4.0) as usize]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::boxes::BoxSpec;
    use crate::quality::summary;
    use crate::{Element, Shape};

    /// One element of each shape, each with all its faces named.
    fn shapes() -> Mesh {
        let mut mesh = Mesh {
            nodes: vec![
                [0.0, 0.0, 0.0],
                [2.0, 0.0, 0.0],
                [2.0, 1.0, 0.0],
                [0.0, 1.0, 0.0],
                [0.0, 0.0, 1.0],
                [2.0, 0.0, 1.0],
                [2.0, 1.0, 1.0],
                [0.0, 1.0, 1.0],
                [1.0, 0.5, 3.0],
            ],
            elements: vec![
                Element::new(Shape::Hex8, &[0, 1, 2, 3, 4, 5, 6, 7]),
                Element::new(Shape::Wedge6, &[0, 3, 4, 1, 2, 5]),
                Element::new(Shape::Pyramid5, &[4, 5, 6, 7, 8]),
                Element::new(Shape::Tet4, &[0, 1, 3, 4]),
            ],
            ..Mesh::default()
        };
        mesh.points.insert("tip".into(), [1.0, 0.5, 3.0]);
        for e in 0..4u32 {
            for side in 0..mesh.elements[e as usize].shape.faces().len() as u8 {
                mesh.faces.insert(format!("{e} {side}"), vec![crate::Face { element: e, side }]);
            }
        }
        mesh
    }

    fn face_nodes(mesh: &Mesh) -> Vec<Vec<u32>> {
        let sorted = |face: &crate::Face| {
            let mut nodes: Vec<u32> = mesh.face_nodes(*face).collect();
            nodes.sort_unstable();
            nodes
        };
        mesh.faces.values().flatten().map(sorted).collect()
    }

    #[test]
    fn every_shape_stays_valid_in_a_mirror_and_named_faces_stay_where_they_are() {
        let before = shapes();
        for scale in [[1.0, -1.0, 1.0], [-2.0, 3.0, 0.5], [-1.0, -1.0, 1.0], [-1.0, -1.0, -1.0]] {
            let mut mesh = before.clone();
            Placement { scale, rotation: 0.7, ..Placement::AS_IT_IS }.apply(&mut mesh);
            let (old, new) = (summary(&before), summary(&mesh));
            let factor = scale.iter().product::<f64>().abs();
            assert!((new.volume - factor * old.volume).abs() < 1e-12 * new.volume, "{scale:?}");
            assert!(new.min_scaled_jacobian > 0.1, "{scale:?}");
            assert_eq!(face_nodes(&mesh), face_nodes(&before), "{scale:?}");
        }
    }

    #[test]
    fn the_order_is_up_scale_rotate_move_and_named_points_go_along() {
        let mut mesh = shapes();
        let placement = Placement {
            up: Up::Y,
            scale: [1e-3, 1e-3, 2e-3],
            rotation: 90f64.to_radians(),
            shift: [10.0, 20.0, -200.0],
        };
        placement.apply(&mut mesh);
        // (1, 0.5, 3) → upright (1, −3, 0.5) → (1e-3, −3e-3, 1e-3) → (3e-3, 1e-3, 1e-3) → moved
        let exact = [10.003, 20.001, -199.999];
        for found in [mesh.points["tip"], mesh.nodes[8]] {
            assert!((0..3).all(|i| (found[i] - exact[i]).abs() < 1e-13), "{found:?}");
        }
        let x_up = Placement { up: Up::X, ..Placement::AS_IT_IS };
        assert_eq!(x_up.point([3.0, 4.0, 5.0]), [-5.0, 4.0, 3.0]);
    }

    #[test]
    fn boxes_stay_boxes() {
        let spec = BoxSpec::uniform([0.0; 3], [4.0, 3.0, 2.0], [4, 3, 2]);
        let before = spec.mesh().unwrap();
        for (up, rotation) in [(Up::Y, 0.0), (Up::X, 30f64.to_radians()), (Up::Z, 90f64.to_radians())] {
            let mut mesh = before.clone();
            Placement { up, scale: [-1e-3; 3], rotation, shift: [1e3, -2e3, 0.0] }.apply(&mut mesh);
            // Corners are right to round-off of coordinates of 2 km in elements of a millimetre.
            let totals = summary(&mesh);
            assert!((totals.min_scaled_jacobian - 1.0).abs() < 1e-8, "{totals:?}");
            assert!((totals.volume / 24e-9 - 1.0).abs() < 1e-8, "{totals:?}");
        }
    }

    #[test]
    fn right_angles_are_exact_and_other_angles_are_what_they_are() {
        let point = |degrees: f64| {
            let placement = Placement { rotation: degrees.to_radians(), ..Placement::AS_IT_IS };
            placement.point([3.1, 4.7, 5.3])
        };
        for (degrees, exact) in [
            (0.0, [3.1, 4.7, 5.3]),
            (90.0, [-4.7, 3.1, 5.3]),
            (-90.0, [4.7, -3.1, 5.3]),
            (180.0, [-3.1, -4.7, 5.3]),
            (-180.0, [-3.1, -4.7, 5.3]),
            (270.0, [4.7, -3.1, 5.3]),
            (450.0, [-4.7, 3.1, 5.3]),
        ] {
            assert_eq!(point(degrees), exact, "{degrees}");
        }
        let [x, y, _] = point(90.0 + 1e-9);
        let angle = 1e-9_f64.to_radians();
        assert!((x + 4.7 + 3.1 * angle).abs() < 1e-15 && (y - 3.1 + 4.7 * angle).abs() < 1e-15, "{x} {y}");
    }
}
