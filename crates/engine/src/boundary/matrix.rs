//! Symmetric 3×3 matrices of nodes, as their six different entries: xx, yy, zz, xy, yz, zx.

/// Product of such a matrix and a vector.
pub fn times(m: &[f64; 6], v: [f64; 3]) -> [f64; 3] {
    [
        m[0] * v[0] + m[3] * v[1] + m[5] * v[2],
        m[3] * v[0] + m[1] * v[1] + m[4] * v[2],
        m[5] * v[0] + m[4] * v[1] + m[2] * v[2],
    ]
}

/// Adds one such matrix to another.
pub fn add(to: &mut [f64; 6], more: &[f64; 6]) {
    for (a, b) in to.iter_mut().zip(more) {
        *a += b;
    }
}
