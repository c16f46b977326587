//! Strains of unit amplitudes of the assumed field: of a surface that bends, and of a fibre along an axis.

use super::{Hex8, Surface};

/// ½(u⊗v + v⊗u), as a strain with engineering shear.
pub(super) fn dyad(u: [f64; 3], v: [f64; 3]) -> [f64; 6] {
    [
        u[0] * v[0],
        u[1] * v[1],
        u[2] * v[2],
        u[0] * v[1] + u[1] * v[0],
        u[1] * v[2] + u[2] * v[1],
        u[2] * v[0] + u[0] * v[2],
    ]
}

/// Strains of the surface across axis `k` for unit s_bc, s_cb and γ, with the contraction that plane stress asks for.
pub(super) fn surface_strains(hex: &Hex8, k: usize, poisson_plane: f64) -> [[f64; 6]; 3] {
    let (t, u) = (hex.directions[(k + 1) % 3], hex.directions[(k + 2) % 3]);
    let Surface { cosine, stretch, .. } = Surface::across(hex, k);
    // Dual vectors in the surface, and its unit normal.
    let along = [0, 1, 2].map(|i| stretch * (t[i] - cosine * u[i]));
    let across = [0, 1, 2].map(|i| stretch * (u[i] - cosine * t[i]));
    let normal = [t[1] * u[2] - t[2] * u[1], t[2] * u[0] - t[0] * u[2], t[0] * u[1] - t[1] * u[0]];
    let normal = dyad(normal, normal).map(|x| x * stretch);
    let contracted = |strain: [f64; 6], trace: f64| {
        let mut strain = strain;
        for c in 0..6 {
            strain[c] -= poisson_plane * trace * normal[c];
        }
        strain
    };
    [
        contracted(dyad(along, along), stretch),
        contracted(dyad(across, across), stretch),
        contracted(dyad(along, across), -stretch * cosine),
    ]
}

/// Strain of uniaxial stress along axis `k` for a unit stretch.
pub(super) fn fibre_strain(hex: &Hex8, k: usize, poisson: f64) -> [f64; 6] {
    let t = hex.directions[k];
    let mut strain = dyad(t, t).map(|x| (1.0 + poisson) * x);
    for value in &mut strain[..3] {
        *value -= poisson;
    }
    strain
}
