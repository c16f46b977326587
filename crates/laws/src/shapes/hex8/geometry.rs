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
pub const fn gauss_point(p: usize) -> [f64; 3] {
    // 1/√3.
    const G: f64 = 0.577_350_269_189_625_8;
    let mut xi = [-G; 3];
    let mut axis = 0;
    while axis < 3 {
        if p >> axis & 1 == 1 {
            xi[axis] = G;
        }
        axis += 1;
    }
    xi
}

/// The eight shape functions at natural coordinates ξ.
pub const fn shape_values(xi: [f64; 3]) -> [f64; 8] {
    let mut all = [0.0; 8];
    let mut k = 0;
    while k < 8 {
        let c = CORNERS[k];
        all[k] = 0.125 * (1.0 + c[0] * xi[0]) * (1.0 + c[1] * xi[1]) * (1.0 + c[2] * xi[2]);
        k += 1;
    }
    all
}

/// Signs of each mode at the corners (VTK order).
const SIGNS: [[f64; 8]; 8] = {
    let mut all = [[1.0; 8]; 8];
    let mut k = 0;
    while k < 64 {
        let (mode, corner) = (k / 8, k % 8);
        if (!BINARY[corner] & mode & 7).count_ones() % 2 == 1 {
            all[mode][corner] = -1.0;
        }
        k += 1;
    }
    all
};

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
    /// Whether this is a wedge: corners 3 and 2 fall together, and 7 and 6, and no others.
    pub is_wedge: bool,
    /// Which sides of a wedge are linked, those between corners 0 and 1, 1 and 2, 2 and 0: they must be linked by what shares them as well.
    /// [`Hex8::new`] says which may be; none of a hexahedron. Elements of one point link none.
    pub linked: [bool; 3],
}

type Mat3 = [[f64; 3]; 3];

fn determinant(m: &Mat3) -> f64 {
    m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
        + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
}

/// Natural derivatives of the shape functions.
const fn natural_gradients(xi: [f64; 3]) -> [[f64; 3]; 8] {
    let mut all = [[0.0; 3]; 8];
    let mut k = 0;
    while k < 8 {
        let c = CORNERS[k];
        let t = [1.0 + c[0] * xi[0], 1.0 + c[1] * xi[1], 1.0 + c[2] * xi[2]];
        all[k] = [0.125 * c[0] * t[1] * t[2], 0.125 * c[1] * t[0] * t[2], 0.125 * c[2] * t[0] * t[1]];
        k += 1;
    }
    all
}

/// The 2×2×2 points side by side.
type AtPoints = [f64; 8];

/// Shape functions and their natural derivatives by corner, those along r, at the points of the 2×2×2 rule.
const SHAPES: ([AtPoints; 8], [[AtPoints; 3]; 8]) = {
    let mut values = [[0.0; 8]; 8];
    let mut gradients = [[[0.0; 8]; 3]; 8];
    let mut p = 0;
    while p < 8 {
        let xi = gauss_point(p);
        let (of_values, of_gradients) = (shape_values(xi), natural_gradients(xi));
        let mut corner = 0;
        while corner < 8 {
            values[corner][p] = of_values[corner];
            let mut r = 0;
            while r < 3 {
                gradients[corner][r][p] = of_gradients[corner][r];
                r += 1;
            }
            corner += 1;
        }
        p += 1;
    }
    (values, gradients)
};

/// Natural derivatives at the centre.
const AT_CENTRE: [[f64; 3]; 8] = natural_gradients([0.0; 3]);

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

/// Share of a mode in values at the corners, times eight.
fn project(values: &[[f64; 3]; 8], mode: usize) -> [f64; 3] {
    let mut sum = [-0.0; 3];
    for (sign, x) in SIGNS[mode].iter().zip(values) {
        for j in 0..3 {
            sum[j] += sign * x[j];
        }
    }
    sum
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
        // All points at once, each in the order of its own sums.
        let (values, gradients) = &SHAPES;
        let mut j = [[[0.0; 8]; 3]; 3];
        for (x, d) in corners.iter().zip(gradients) {
            for r in 0..3 {
                for s in 0..3 {
                    for p in 0..8 {
                        j[r][s][p] += d[r][p] * x[s];
                    }
                }
            }
        }
        // det · ∂N/∂x = cofactors(J) · ∂N/∂ξ; the 2×2×2 rule integrates it and N det J exactly.
        let mut c = [[[0.0; 8]; 3]; 3];
        for r in 0..3 {
            for s in 0..3 {
                let (r1, r2, s1, s2) = ((r + 1) % 3, (r + 2) % 3, (s + 1) % 3, (s + 2) % 3);
                for p in 0..8 {
                    c[r][s][p] = j[r1][s1][p] * j[r2][s2][p] - j[r1][s2][p] * j[r2][s1][p];
                }
            }
        }
        let mut weights = [0.0; 8];
        for p in 0..8 {
            weights[p] = j[0][0][p] * c[0][0][p] + j[0][1][p] * c[0][1][p] + j[0][2][p] * c[0][2][p];
        }
        if let Some(&determinant) = weights.iter().find(|det| det.is_nan() || **det <= 0.0) {
            return Err(BadShape::Inverted { determinant });
        }
        let mut corner_volumes = [0.0; 8];
        let mut mean = [[0.0; 3]; 8];
        for corner in 0..8 {
            let (n, d) = (&values[corner], &gradients[corner]);
            for p in 0..8 {
                corner_volumes[corner] += weights[p] * n[p];
            }
            for s in 0..3 {
                let mut at = [0.0; 8];
                for p in 0..8 {
                    at[p] = c[0][s][p] * d[0][p] + c[1][s][p] * d[1][p] + c[2][s][p] * d[2][p];
                }
                for x in at {
                    mean[corner][s] += x;
                }
            }
        }
        let volume: f64 = weights.iter().sum();
        for value in mean.iter_mut().flatten() {
            *value /= volume;
        }

        let centre = jacobian(&corners, &AT_CENTRE);
        let det = determinant(&centre);
        if det.is_nan() || det <= 0.0 {
            return Err(BadShape::Inverted { determinant: det });
        }
        let half_lengths = centre.map(|g| (g[0] * g[0] + g[1] * g[1] + g[2] * g[2]).sqrt());
        let directions = [0, 1, 2].map(|k| centre[k].map(|x| x / half_lengths[k]));

        let mut gradient = [[0.0; 3]; 8];
        for mode in LINEAR.into_iter().chain(HOURGLASS) {
            let [x, y, z] = project(&mean, mode);
            gradient[mode] = [0.125 * x, 0.125 * y, 0.125 * z];
        }
        let mut hourglass = [[0.0; 3]; 4];
        for (hourglass, mode) in hourglass.iter_mut().zip(HOURGLASS) {
            *hourglass = project(&corners, mode);
        }
        let linkable = super::wedge_sides::linkable(&corners);
        Ok(Hex8 {
            corners,
            volume,
            weights,
            corner_volumes,
            gradient,
            hourglass,
            half_lengths,
            directions,
            is_wedge: linkable.is_some(),
            linked: linkable.unwrap_or_default(),
        })
    }
}
