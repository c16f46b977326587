//! The map from natural to spatial coordinates of each shape: weights, derivatives, Jacobian.
//!
//! Natural coordinates: hexahedron [-1, 1]³; wedge r, s ≥ 0, r + s ≤ 1, t in [-1, 1]; tetrahedron
//! r, s, t ≥ 0, r + s + t ≤ 1; pyramid r and s in [-1, 1], t in [0, 1], the top of a hexahedron shrunk
//! to the apex, where r and s have no meaning.

use crate::Shape;

/// Natural coordinates of the nodes of the hexahedron.
const HEX: [[f64; 3]; 8] = [
    [-1.0, -1.0, -1.0],
    [1.0, -1.0, -1.0],
    [1.0, 1.0, -1.0],
    [-1.0, 1.0, -1.0],
    [-1.0, -1.0, 1.0],
    [1.0, -1.0, 1.0],
    [1.0, 1.0, 1.0],
    [-1.0, 1.0, 1.0],
];
#[cfg(test)]
const WEDGE: [[f64; 3]; 6] =
    [[0.0, 0.0, -1.0], [1.0, 0.0, -1.0], [0.0, 1.0, -1.0], [0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0]];
const PYRAMID: [[f64; 3]; 5] =
    [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
#[cfg(test)]
const TET: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Natural coordinates of a shape's nodes.
#[cfg(test)]
pub(crate) const fn corners(shape: Shape) -> &'static [[f64; 3]] {
    match shape {
        Shape::Hex8 => &HEX,
        Shape::Wedge6 => &WEDGE,
        Shape::Pyramid5 => &PYRAMID,
        Shape::Tet4 => &TET,
    }
}

/// The shape functions at a natural point; those a shape does not have are 0.
pub(crate) fn weights(shape: Shape, [r, s, t]: [f64; 3]) -> [f64; 8] {
    let mut w = [0.0; 8];
    match shape {
        Shape::Hex8 => {
            for (w, [a, b, c]) in w.iter_mut().zip(HEX) {
                *w = 0.125 * (1.0 + a * r) * (1.0 + b * s) * (1.0 + c * t);
            }
        }
        Shape::Wedge6 => {
            let l = [1.0 - r - s, r, s];
            for k in 0..3 {
                w[k] = 0.5 * (1.0 - t) * l[k];
                w[k + 3] = 0.5 * (1.0 + t) * l[k];
            }
        }
        Shape::Pyramid5 => {
            for (w, [a, b, _]) in w.iter_mut().zip(PYRAMID).take(4) {
                *w = 0.25 * (1.0 + a * r) * (1.0 + b * s) * (1.0 - t);
            }
            w[4] = t;
        }
        Shape::Tet4 => w[..4].copy_from_slice(&[1.0 - r - s - t, r, s, t]),
    }
    w
}

/// Derivatives of the shape functions by the three natural coordinates.
pub(crate) fn derivatives(shape: Shape, [r, s, t]: [f64; 3]) -> [[f64; 3]; 8] {
    let mut d = [[0.0; 3]; 8];
    match shape {
        Shape::Hex8 => {
            for (d, [a, b, c]) in d.iter_mut().zip(HEX) {
                let (fr, fs, ft) = (1.0 + a * r, 1.0 + b * s, 1.0 + c * t);
                *d = [0.125 * a * fs * ft, 0.125 * b * fr * ft, 0.125 * c * fr * fs];
            }
        }
        Shape::Wedge6 => {
            let l = [1.0 - r - s, r, s];
            let slope = [[-1.0, -1.0], [1.0, 0.0], [0.0, 1.0]];
            for k in 0..3 {
                for (node, sign) in [(k, -1.0), (k + 3, 1.0)] {
                    let f = 0.5 * (1.0 + sign * t);
                    d[node] = [f * slope[k][0], f * slope[k][1], 0.5 * sign * l[k]];
                }
            }
        }
        Shape::Pyramid5 => {
            for (d, [a, b, _]) in d.iter_mut().zip(PYRAMID).take(4) {
                let (fr, fs, ft) = (1.0 + a * r, 1.0 + b * s, 1.0 - t);
                *d = [0.25 * a * fs * ft, 0.25 * b * fr * ft, -0.25 * fr * fs];
            }
            d[4] = [0.0, 0.0, 1.0];
        }
        Shape::Tet4 => {
            d[..4].copy_from_slice(&[[-1.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
        }
    }
    d
}

/// The point with the given weights.
pub(crate) fn point(nodes: &[[f64; 3]], weights: &[f64; 8]) -> [f64; 3] {
    let mut x = [0.0; 3];
    for (node, w) in nodes.iter().zip(weights) {
        for i in 0..3 {
            x[i] += w * node[i];
        }
    }
    x
}

/// Jacobian, `jacobian[i][j]` = ∂x_i/∂natural_j.
pub(crate) fn jacobian(nodes: &[[f64; 3]], derivatives: &[[f64; 3]; 8]) -> [[f64; 3]; 3] {
    let mut jacobian = [[0.0; 3]; 3];
    for (node, d) in nodes.iter().zip(derivatives) {
        for i in 0..3 {
            for j in 0..3 {
                jacobian[i][j] += node[i] * d[j];
            }
        }
    }
    jacobian
}

pub(crate) fn determinant(m: &[[f64; 3]; 3]) -> f64 {
    m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
        + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHAPES: [Shape; 4] = [Shape::Hex8, Shape::Wedge6, Shape::Pyramid5, Shape::Tet4];

    #[test]
    fn a_weight_is_one_at_its_node_and_zero_at_the_others() {
        for shape in SHAPES {
            for (node, &at) in corners(shape).iter().enumerate() {
                let w = weights(shape, at);
                for (other, w) in w.iter().enumerate() {
                    let wanted = if other == node { 1.0 } else { 0.0 };
                    assert_eq!(*w, wanted, "{shape:?} {node} {other}");
                }
            }
        }
    }

    #[test]
    fn derivatives_are_the_slopes_of_the_weights() {
        let step = 1e-5;
        for shape in SHAPES {
            let at = [0.21, 0.33, 0.17];
            let exact = derivatives(shape, at);
            for j in 0..3 {
                let (mut up, mut down) = (at, at);
                up[j] += step;
                down[j] -= step;
                let (up, down) = (weights(shape, up), weights(shape, down));
                for k in 0..8 {
                    // Central differences: error of the order step², round-off of 1e-16/step.
                    let slope = (up[k] - down[k]) / (2.0 * step);
                    assert!((slope - exact[k][j]).abs() < 1e-9, "{shape:?} {k} {j}");
                }
            }
        }
    }
}
