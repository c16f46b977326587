//! Geometry of one hexahedron, worked out once in scalar arithmetic.

use super::{BINARY, HOURGLASS, LINEAR};

/// Natural coordinates of the corners (VTK order).
pub const CORNERS: [[f64; 3]; 8] = [
    [-1.0, -1.0, -1.0],
    [1.0, -1.0, -1.0],
    [1.0, 1.0, -1.0],
    [-1.0, 1.0, -1.0],
    [-1.0, -1.0, 1.0],
    [1.0, -1.0, 1.0],
    [1.0, 1.0, 1.0],
    [-1.0, 1.0, 1.0],
];

/// Why an element cannot be used.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BadShape {
    /// A coordinate is not finite.
    NotFinite,
    /// The Jacobian is not positive at an integration point.
    Inverted { determinant: f64 },
}

impl std::fmt::Display for BadShape {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            BadShape::NotFinite => write!(f, "a node's coordinate is not a finite number"),
            BadShape::Inverted { determinant } => {
                write!(
                    f,
                    "the element is turned inside out at an integration point (Jacobian {determinant:.3e})"
                )
            }
        }
    }
}

/// Coordinates of integration point `p` of the 2×2×2 rule; binary order, bit 0 is ξ.
pub fn gauss_point(p: usize) -> [f64; 3] {
    let g = 1.0 / 3f64.sqrt();
    [0, 1, 2].map(|axis| if p >> axis & 1 == 1 { g } else { -g })
}

/// The eight shape functions at natural coordinates ξ.
pub fn shape_values(xi: [f64; 3]) -> [f64; 8] {
    CORNERS.map(|c| 0.125 * (1.0 + c[0] * xi[0]) * (1.0 + c[1] * xi[1]) * (1.0 + c[2] * xi[2]))
}

/// Sign of mode `mode` at corner `corner` (VTK order).
fn sign(corner: usize, mode: usize) -> f64 {
    if (!BINARY[corner] & mode & 7).count_ones().is_multiple_of(2) { 1.0 } else { -1.0 }
}

/// Geometry of one element, global axes, lengths in m.
#[derive(Clone, Debug)]
pub struct Hex8 {
    /// Corners (VTK order).
    pub corners: [[f64; 3]; 8],
    /// Volume \[m³\].
    pub volume: f64,
    /// det J at the 2×2×2 points, their weights \[m³\].
    pub weights: [f64; 8],
    /// ∫ N_I dV, the share of each corner in the volume \[m³\] (row sums of the consistent mass matrix / ρ).
    pub corner_volumes: [f64; 8],
    /// Modal coefficients b_mj of the mean gradient \[1/m\]: `[mode][j]`, mode 0 empty.
    pub gradient: [[f64; 3]; 8],
    /// Modal coordinates X_αj of the hourglass patterns \[m\].
    pub hourglass: [[f64; 3]; 4],
    /// Half-lengths ℓ_k along the natural axes, |∂x/∂ξ_k| at the centre \[m\].
    pub half_lengths: [f64; 3],
    /// Unit vectors t_k along the natural axes at the centre.
    pub directions: [[f64; 3]; 3],
}

type Mat3 = [[f64; 3]; 3];

fn determinant(m: &Mat3) -> f64 {
    m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
        + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
}

/// Cofactors: `det(m) m⁻ᵀ`.
fn cofactors(m: &Mat3) -> Mat3 {
    let mut c = [[0.0; 3]; 3];
    for r in 0..3 {
        for s in 0..3 {
            let (r1, r2, s1, s2) = ((r + 1) % 3, (r + 2) % 3, (s + 1) % 3, (s + 2) % 3);
            c[r][s] = m[r1][s1] * m[r2][s2] - m[r1][s2] * m[r2][s1];
        }
    }
    c
}

/// Natural derivatives of the shape functions.
fn natural_gradients(xi: [f64; 3]) -> [[f64; 3]; 8] {
    CORNERS.map(|c| {
        let t = [1.0 + c[0] * xi[0], 1.0 + c[1] * xi[1], 1.0 + c[2] * xi[2]];
        [0.125 * c[0] * t[1] * t[2], 0.125 * c[1] * t[0] * t[2], 0.125 * c[2] * t[0] * t[1]]
    })
}

/// J_rs = ∂x_s/∂ξ_r.
fn jacobian(corners: &[[f64; 3]; 8], gradients: &[[f64; 3]; 8]) -> Mat3 {
    let mut j = [[0.0; 3]; 3];
    for (x, d) in corners.iter().zip(gradients) {
        for r in 0..3 {
            for s in 0..3 {
                j[r][s] += d[r] * x[s];
            }
        }
    }
    j
}

/// det J \[m³\] at natural coordinates of an element with these corners.
pub(super) fn determinant_at(corners: &[[f64; 3]; 8], xi: [f64; 3]) -> f64 {
    determinant(&jacobian(corners, &natural_gradients(xi)))
}

impl Hex8 {
    /// Mean strain, with engineering shear, of displacements of the corners in VTK order.
    pub fn mean_strain(&self, u: &[[f64; 3]; 8]) -> [f64; 6] {
        let mut g = [[0.0; 3]; 3];
        for (i, g) in g.iter_mut().enumerate() {
            let mut modes = [0.0; 8];
            for (corner, u) in u.iter().enumerate() {
                modes[BINARY[corner]] = u[i];
            }
            super::to_modes(&mut modes);
            for (j, g) in g.iter_mut().enumerate() {
                *g = super::modal::MODES.into_iter().map(|mode| self.gradient[mode][j] * modes[mode]).sum();
            }
        }
        [g[0][0], g[1][1], g[2][2], g[0][1] + g[1][0], g[1][2] + g[2][1], g[0][2] + g[2][0]]
    }

    /// Works out the geometry.
    ///
    /// # Errors
    /// If a coordinate is not finite or the Jacobian is not positive at the centre and all eight points.
    pub fn new(corners: [[f64; 3]; 8]) -> Result<Self, BadShape> {
        if corners.iter().flatten().any(|x| !x.is_finite()) {
            return Err(BadShape::NotFinite);
        }
        let mut weights = [0.0; 8];
        let mut corner_volumes = [0.0; 8];
        let mut mean = [[0.0; 3]; 8];
        for (p, weight) in weights.iter_mut().enumerate() {
            let xi = gauss_point(p);
            let gradients = natural_gradients(xi);
            let j = jacobian(&corners, &gradients);
            let det = determinant(&j);
            if det.is_nan() || det <= 0.0 {
                return Err(BadShape::Inverted { determinant: det });
            }
            *weight = det;
            // det · ∂N/∂x = cofactors(J) · ∂N/∂ξ; the 2×2×2 rule integrates it and N det J exactly.
            let c = cofactors(&j);
            let n = shape_values(xi);
            for corner in 0..8 {
                corner_volumes[corner] += det * n[corner];
                for s in 0..3 {
                    mean[corner][s] += (0..3).map(|r| c[r][s] * gradients[corner][r]).sum::<f64>();
                }
            }
        }
        let volume: f64 = weights.iter().sum();
        for value in mean.iter_mut().flatten() {
            *value /= volume;
        }

        let centre = jacobian(&corners, &natural_gradients([0.0; 3]));
        let det = determinant(&centre);
        if det.is_nan() || det <= 0.0 {
            return Err(BadShape::Inverted { determinant: det });
        }
        let half_lengths = centre.map(|g| (g[0] * g[0] + g[1] * g[1] + g[2] * g[2]).sqrt());
        let directions = [0, 1, 2].map(|k| centre[k].map(|x| x / half_lengths[k]));

        let project = |values: &dyn Fn(usize) -> f64, mode: usize| -> f64 {
            (0..8).map(|corner| sign(corner, mode) * values(corner)).sum()
        };
        let mut gradient = [[0.0; 3]; 8];
        for mode in LINEAR.into_iter().chain(HOURGLASS) {
            gradient[mode] = [0, 1, 2].map(|j| 0.125 * project(&|corner| mean[corner][j], mode));
        }
        let hourglass = HOURGLASS.map(|mode| [0, 1, 2].map(|j| project(&|corner| corners[corner][j], mode)));
        Ok(Hex8 { corners, volume, weights, corner_volumes, gradient, hourglass, half_lengths, directions })
    }
}
