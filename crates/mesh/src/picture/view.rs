//! A mesh seen from outside.

use std::f64::consts::FRAC_1_SQRT_2;

use super::canvas::{Canvas, Legend};
use crate::Mesh;
use crate::topology::exterior_faces;

/// Directions of the picture's right and up, and towards the eye: from lower x and y, and above. All three axes
/// are shortened alike.
const RIGHT: [f64; 3] = [FRAC_1_SQRT_2, -FRAC_1_SQRT_2, 0.0];
const UP: [f64; 3] = [SIXTH, SIXTH, 2.0 * SIXTH];
const EYE: [f64; 3] = [-THIRD, -THIRD, THIRD];

/// 1/√6 and 1/√3.
const SIXTH: f64 = 0.408_248_290_463_863;
const THIRD: f64 = 0.577_350_269_189_625_8;

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// An isometric view of the given elements (indices into [`Mesh::elements`]) or of all, as SVG: seen from above,
/// from lower x and y.
///
/// Outer faces are drawn from the farthest to the nearest, by their middles, so faces of very unequal size may
/// hide one another wrongly. Sides that look along x are darker than those along y, tops lighter. Faces with nodes
/// that are not finite numbers are left out.
///
/// # Panics
/// If an element is not in the mesh.
pub fn view(mesh: &Mesh, elements: Option<&[u32]>) -> String {
    struct Facet {
        element: u32,
        depth: f64,
        light: f64,
        outline: Vec<[f64; 2]>,
    }
    let mut facets = Vec::new();
    let mut window = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
    for face in exterior_faces(mesh, elements) {
        let x: Vec<[f64; 3]> = mesh.face_nodes(face).map(|n| mesh.nodes[n as usize]).collect();
        let [a, b] = match x.len() {
            3 => [[0, 1], [0, 2]],
            _ => [[0, 2], [1, 3]],
        }
        .map(|[i, j]| [0, 1, 2].map(|c| x[j][c] - x[i][c]));
        let normal = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
        let length = dot(normal, normal).sqrt();
        // Not seen from its front; nor without an area, nor with a node that is no number.
        let front = dot(normal, EYE) > 1e-9 * length;
        if !front || x.as_flattened().iter().any(|c| !c.is_finite()) {
            continue;
        }
        let outline: Vec<[f64; 2]> = x.iter().map(|&p| [dot(p, RIGHT), dot(p, UP)]).collect();
        for p in &outline {
            for c in 0..2 {
                window[0][c] = window[0][c].min(p[c]);
                window[1][c] = window[1][c].max(p[c]);
            }
        }
        let depth = x.iter().map(|&p| dot(p, EYE)).sum::<f64>() / x.len() as f64;
        let light = (0.85 - 0.2 * (normal[0] / length).abs() + 0.15 * normal[2] / length).clamp(0.4, 1.0);
        facets.push(Facet { element: face.element, depth, light, outline });
    }
    facets.sort_by(|a, b| a.depth.total_cmp(&b.depth));
    let legend = Legend::new(mesh, facets.iter().map(|f| f.element));
    let mut canvas = Canvas::new(window, legend.rows());
    for facet in &facets {
        canvas.polygon(&facet.outline, legend.colour(facet.element), facet.light);
    }
    canvas.finish(&legend, "seen from lower x and y, above")
}
