//! Damped least squares (`levenberg1944`).

/// x of length n that makes |Ax − b|² + λ²|x|² least, for A by rows: (AᵀA + λ²) x = Aᵀb by Cholesky's factors.
pub(super) fn damped_least_squares(a: &[f64], b: &[f64], n: usize, lambda: f64) -> Vec<f64> {
    let mut m = vec![0.0; n * n];
    let mut x = vec![0.0; n];
    for (line, b) in a.chunks(n).zip(b) {
        for i in 0..n {
            x[i] += line[i] * b;
            for j in 0..=i {
                m[i * n + j] += line[i] * line[j];
            }
        }
    }
    for i in 0..n {
        m[i * n + i] += lambda * lambda;
        for j in 0..=i {
            let sum: f64 = (0..j).map(|k| m[i * n + k] * m[j * n + k]).sum();
            let rest = m[i * n + j] - sum;
            m[i * n + j] = if i == j { rest.sqrt() } else { rest / m[j * n + j] };
        }
    }
    for i in 0..n {
        let sum: f64 = (0..i).map(|k| m[i * n + k] * x[k]).sum();
        x[i] = (x[i] - sum) / m[i * n + i];
    }
    for i in (0..n).rev() {
        let sum: f64 = (i + 1..n).map(|k| m[k * n + i] * x[k]).sum();
        x[i] = (x[i] - sum) / m[i * n + i];
    }
    x
}
