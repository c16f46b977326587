//! The assumed strain of a six-node wedge, a hexahedron whose corners fall together in two triangles.
//!
//! The thickness ζ leads from triangle to triangle. With x the place in the plane of the triangle, x̄ its centroid and
//! Θ = ∂u/∂x ∂ζ, the strain beside the mean strain has three parts:
//!
//! | part | strain | stress |
//! |---|---|---|
//! | bending, times ζ | sym Θ in the plane, and the contraction −ν/(1 − ν) tr Θ | plane, across ζ |
//! | stretch of the thickness, linear in x | ε_zz, and the contraction −ν ε_zz in the plane | uniaxial |
//! | turn of the edges through the thickness | γ = ω e_z × (x − x̄), ω of the antisymmetric part of Θ | shear |
//!
//! **Linked shear.** The shear of a side along its edge is linear in the displacements of its four nodes, though in pure bending
//! it vanishes. As in MITC3 (`lee2004`) it is made constant along the edge: the side bulges by β(1 − s²) across its edge, as much
//! as makes the linear part vanish. The mean of the bulges over the sides adds to the mean strain, so u = (xz, 0, −x²/2) has no shear in any wedge.
//!
//! **Patch test.** The bulge of a flat side goes by the side's own nodes. Two wedges that share the side have the same, and their forces under
//! a constant stress cancel. So a side is linked where it is free, or where both elements are wedges that link it ([`Hex8::linked`]).
//! A twisted side cannot tell a linear field by its four nodes: the mean strain of the element does. Strains of linear fields stay exact;
//! the transverse shear stress of a twisted side leaves forces at its nodes in proportion to the twist, about a hundredth of
//! those of the stress at 5°. Sides twisted by more than [`TWIST`](super::wedge_sides::TWIST) are not linked, nor those of wedges whose edges do not lead along the normal.

use super::unit_strains::{dyad, fibre_strain};
use super::wedge_sides::{SIDES, Side, cross, dot, length, plus};
use super::{HOURGLASS, Hex8, Stabilisation};

/// ⅛ of these times the modes ξ and η (ξζ and ηζ) of a side's ends is the derivative along it (and along it and ζ).
const ALONG: [[f64; 2]; 3] = [[2.0, 0.0], [-1.0, 1.0], [-1.0, -1.0]];
/// ⅛ of the mode ζ, and of these times ξζ and ηζ, is the derivative along ζ at the middle of a side.
const THROUGH: [[f64; 2]; 3] = [[0.0, -1.0], [1.0, 0.0], [-1.0, 0.0]];

/// What the fields of several points hold of a wedge in the places of what it lacks.
pub(super) struct WedgeField {
    /// Strain for unit s_z2 times ξ − ξη, and s_z1 times η.
    pub stretch: [f64; 6],
    /// Strain for unit γ′ = s_y2 ℓ_y/ℓ_x − s_x1 ℓ_x/ℓ_y, times ξ − ξη and η.
    pub turn: [[f64; 6]; 2],
    /// Mean strain of a unit linear shear of each side; zero of sides that are not linked.
    pub sides: [[f64; 6]; 3],
    /// The linear shear of each side for unit s_x2, s_y1, s_x1 and s_y2.
    pub shears: [[f64; 4]; 3],
}

impl WedgeField {
    pub fn of(hex: &Hex8, elastic: &Stabilisation) -> WedgeField {
        let (turn, _) = turn(hex);
        let mut field = WedgeField {
            stretch: fibre_strain(hex, 2, elastic.poisson),
            turn,
            sides: [[0.0; 6]; 3],
            shears: [[0.0; 4]; 3],
        };
        let linear = linear_modes(hex);
        for k in (0..3).filter(|&k| hex.linked[k]) {
            let Side { along, through, parts: [alpha, beta], .. } = Side::of(&hex.corners, SIDES[k]);
            // Across the edge, in the side, with through·bulge = 1.
            let bulge = plus(through, -dot(through, along) / dot(along, along), along);
            let square = dot(bulge, bulge);
            // ∫(1 − s²) over the side, whose area is 4 |along × through|, times ½.
            let scale = 4.0 / (3.0 * square * hex.volume);
            field.sides[k] = dyad(cross(along, through), bulge).map(|x| x * scale);
            let ([xi, eta], through) = (ALONG[k], THROUGH[k]);
            // Of ηζ and ξζ.
            let by = [0, 1].map(|m| {
                let [of_xi, of_eta, of_zeta] = linear[m];
                let both = [eta, xi][m] - beta * [through[1], through[0]][m];
                0.125 * (both - alpha * (xi * of_xi + eta * of_eta) - beta * of_zeta)
            });
            let [x, y] = [0, 1].map(|axis| 8.0 * hex.half_lengths[axis].powi(2) * [xi, eta][axis]);
            field.shears[k] = [by[1] * x, by[0] * y, by[0] * x, by[1] * y];
        }
        field
    }
}

/// Deviation of the modes ξ, η and ζ from the linear field of the mean gradient, for those of ηζ and of ξζ: Σ_m b_mj q_m = 0.
fn linear_modes(hex: &Hex8) -> [[f64; 3]; 2] {
    let b = &hex.gradient;
    // Corners that fall together make ξη of −ξ and ξηζ of −ξζ.
    let [xi, of_xi_zeta] =
        [(1, HOURGLASS[2]), (HOURGLASS[1], HOURGLASS[3])].map(|(m, n)| plus(b[m], -1.0, b[n]));
    let (eta, zeta) = (b[2], b[4]);
    let det = dot(xi, cross(eta, zeta));
    [b[HOURGLASS[0]], of_xi_zeta].map(|rest| {
        [
            -dot(rest, cross(eta, zeta)) / det,
            -dot(rest, cross(zeta, xi)) / det,
            -dot(rest, cross(xi, eta)) / det,
        ]
    })
}

/// Strains of the turn of the edges through the thickness for unit γ′, times ξ − ξη and η; and the mean of its square over a prism.
fn turn(hex: &Hex8) -> ([[f64; 6]; 2], f64) {
    let [x, y] = [0, 1].map(|k| hex.directions[k].map(|t| t * hex.half_lengths[k]));
    let area = cross(hex.directions[0], hex.directions[1]);
    let sine = length(area);
    let normal = area.map(|x| x / sine);
    // Of the turn for unit γ′, over the thickness along the normal.
    let scale = 0.5 / (sine * hex.half_lengths[2] * dot(normal, hex.directions[2]));
    let strains = [x, y].map(|edge| dyad(cross(normal, edge), normal).map(|e| e * scale));
    // Means of (ξ − ξη)² and of (η − η̄)² over a triangle.
    let square = scale * scale * (2.0 / 3.0 * dot(x, x) + 2.0 / 9.0 * dot(y, y));
    (strains, square)
}

/// The mean of the square of the shear that unit γ′ gives a prism.
pub(super) fn turn_square(hex: &Hex8) -> f64 {
    turn(hex).1
}
