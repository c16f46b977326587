//! What an element conducts.

use tremolite_laws::shapes::hex8::{CORNERS, gauss_point};

/// Row and column of the lower half of a symmetric matrix of the eight corners.
pub(crate) const PAIRS: [(usize, usize); 36] = {
    let mut pairs = [(0, 0); 36];
    let (mut k, mut i) = (0, 0);
    while i < 8 {
        let mut j = 0;
        while j <= i {
            pairs[k] = (i, j);
            k += 1;
            j += 1;
        }
        i += 1;
    }
    pairs
};

/// Of each corner.
pub(crate) type Gradients = [[f64; 3]; 8];

/// Gradients of the eight shape functions \[1/m\] at each of the 2×2×2 points, and the points' volumes \[m³\]; none if a volume is not
/// positive.
pub(crate) fn gradients(corners: &[[f64; 3]; 8]) -> Option<([Gradients; 8], [f64; 8])> {
    let mut of_points = [[[0.0; 3]; 8]; 8];
    let mut volumes = [0.0; 8];
    for q in 0..8 {
        let natural = natural(gauss_point(q));
        // J_ij = ∂x_j/∂ξ_i
        let mut j = [[0.0; 3]; 3];
        for (n, x) in natural.iter().zip(corners) {
            for a in 0..3 {
                for b in 0..3 {
                    j[a][b] += n[a] * x[b];
                }
            }
        }
        // Rows of the cofactors: the inverse is their transpose over the determinant.
        let cross = |u: [f64; 3], v: [f64; 3]| {
            [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
        };
        let cofactors = [cross(j[1], j[2]), cross(j[2], j[0]), cross(j[0], j[1])];
        let volume = j[0].iter().zip(cofactors[0]).map(|(a, b)| a * b).sum::<f64>();
        if !(volume > 0.0 && volume.is_finite()) {
            return None;
        }
        volumes[q] = volume;
        for (gradient, n) in of_points[q].iter_mut().zip(natural) {
            for b in 0..3 {
                gradient[b] = (0..3).map(|a| cofactors[a][b] * n[a]).sum::<f64>() / volume;
            }
        }
    }
    Some((of_points, volumes))
}

/// Derivatives of the shape functions by the natural coordinates.
fn natural(at: [f64; 3]) -> [[f64; 3]; 8] {
    CORNERS.map(|c| {
        let f = [0, 1, 2].map(|i| 1.0 + c[i] * at[i]);
        [c[0] * f[1] * f[2] / 8.0, c[1] * f[2] * f[0] / 8.0, c[2] * f[0] * f[1] / 8.0]
    })
}

/// Σ over points of the volume × ∇N·∇N, by [`PAIRS`] \[m\].
pub(crate) fn conductance(corners: &[[f64; 3]; 8]) -> Option<[f64; 36]> {
    let (gradients, volumes) = gradients(corners)?;
    let mut sum = [0.0; 36];
    for (g, volume) in gradients.iter().zip(volumes) {
        for (entry, &(i, j)) in sum.iter_mut().zip(&PAIRS) {
            *entry += volume * (g[i][0] * g[j][0] + g[i][1] * g[j][1] + g[i][2] * g[j][2]);
        }
    }
    Some(sum)
}

/// k_r under a pressure head p/γ_w \[m\] in an element of a height \[m\]: 1 under pressure, in line down to what is left at the suction of
/// that height.
fn relative(pressure_head: f64, height: f64, left: f64) -> f64 {
    if pressure_head >= 0.0 { 1.0 } else { (1.0 + (1.0 - left) * pressure_head / height).max(left) }
}

/// k_r of an element: of its corners, each as far as its head is above the lowest of them. So it goes by where the water comes from; by the
/// mean of the points what trickles down through dry ground would swing from iteration to iteration. Corners that fall together count once.
pub(crate) fn relative_of(
    corners: &[u32; 8],
    heads: &[f64; 8],
    pressure_heads: &[f64; 8],
    height: f64,
    left: f64,
) -> f64 {
    let lowest = heads.iter().copied().fold(f64::INFINITY, f64::min);
    let highest = heads.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    // In still water all count the same.
    let even = 1e-9 * height + f64::EPSILON * highest.abs().max(lowest.abs());
    let (mut sum, mut weights) = (0.0, 0.0);
    for (i, (h, p)) in heads.iter().zip(pressure_heads).enumerate() {
        if corners[..i].contains(&corners[i]) {
            continue;
        }
        let weight = h - lowest + even;
        sum += weight * relative(*p, height, left);
        weights += weight;
    }
    sum / weights
}

/// Extent along z \[m\].
pub(crate) fn height(corners: &[[f64; 3]; 8]) -> f64 {
    let z = corners.iter().map(|x| x[2]);
    z.clone().fold(f64::NEG_INFINITY, f64::max) - z.fold(f64::INFINITY, f64::min)
}
