//! Small dense symmetric matrices: products, Cholesky's solution, Jacobi's eigenvalues.

use crate::VerifyError;

/// A square matrix, row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct Dense {
    pub n: usize,
    pub values: Vec<f64>,
}

impl Dense {
    pub fn zero(n: usize) -> Self {
        Dense { n, values: vec![0.0; n * n] }
    }

    pub fn at(&self, i: usize, j: usize) -> f64 {
        self.values[i * self.n + j]
    }

    pub fn set(&mut self, i: usize, j: usize, value: f64) {
        self.values[i * self.n + j] = value;
    }

    /// A x
    pub fn times(&self, x: &[f64]) -> Vec<f64> {
        self.values.chunks_exact(self.n).map(|row| dot(row, x)).collect()
    }

    /// Solution of A x = b for a symmetric positive definite A (Golub & Van Loan 2013, algorithm 4.2.1).
    ///
    /// # Errors
    /// If the matrix is not positive definite to twelve digits.
    pub fn solve(&self, b: &[f64]) -> Result<Vec<f64>, VerifyError> {
        let n = self.n;
        let mut l = self.values.clone();
        for j in 0..n {
            let before = l[j * n + j];
            let pivot = before - dot(&l[j * n..j * n + j], &l[j * n..j * n + j]);
            if pivot.is_nan() || pivot <= 1e-12 * before {
                return Err(VerifyError::Singular(j));
            }
            l[j * n + j] = pivot.sqrt();
            for i in j + 1..n {
                let sum = dot(&l[i * n..i * n + j], &l[j * n..j * n + j]);
                l[i * n + j] = (l[i * n + j] - sum) / l[j * n + j];
            }
        }
        let mut x = b.to_vec();
        for i in 0..n {
            x[i] = (x[i] - dot(&l[i * n..i * n + i], &x[..i])) / l[i * n + i];
        }
        for i in (0..n).rev() {
            let sum: f64 = (i + 1..n).map(|k| l[k * n + i] * x[k]).sum();
            x[i] = (x[i] - sum) / l[i * n + i];
        }
        Ok(x)
    }

    /// Eigenvalues, and eigenvectors as the rows of a matrix, of a symmetric matrix: cyclic Jacobi rotations (Golub &
    /// Van Loan 2013, section 8.5), ascending.
    pub fn eigen(&self) -> (Vec<f64>, Dense) {
        let n = self.n;
        let mut a = self.clone();
        let mut vectors = Dense::zero(n);
        (0..n).for_each(|i| vectors.set(i, i, 1.0));
        // Convergence is quadratic after the first few sweeps; a dozen serve any matrix of this size.
        for _ in 0..12 {
            for p in 0..n {
                for q in p + 1..n {
                    rotate(&mut a, &mut vectors, p, q);
                }
            }
        }
        let mut order: Vec<usize> = (0..n).collect();
        order.sort_by(|&i, &j| a.at(i, i).total_cmp(&a.at(j, j)));
        let values = order.iter().map(|&i| a.at(i, i)).collect();
        let rows = order.iter().flat_map(|&i| vectors.values[i * n..(i + 1) * n].to_vec()).collect();
        (values, Dense { n, values: rows })
    }
}

/// One rotation that clears a(p, q); the rows of `vectors` turn along.
fn rotate(a: &mut Dense, vectors: &mut Dense, p: usize, q: usize) {
    let (apq, n) = (a.at(p, q), a.n);
    if apq == 0.0 {
        return;
    }
    let theta = (a.at(q, q) - a.at(p, p)) / (2.0 * apq);
    let t = theta.signum() / (theta.abs() + theta.hypot(1.0));
    let c = 1.0 / t.hypot(1.0);
    let s = t * c;
    for k in 0..n {
        let (x, y) = (a.at(k, p), a.at(k, q));
        a.set(k, p, c * x - s * y);
        a.set(k, q, s * x + c * y);
    }
    for k in 0..n {
        let (x, y) = (a.at(p, k), a.at(q, k));
        a.set(p, k, c * x - s * y);
        a.set(q, k, s * x + c * y);
        let (x, y) = (vectors.at(p, k), vectors.at(q, k));
        vectors.set(p, k, c * x - s * y);
        vectors.set(q, k, s * x + c * y);
    }
    a.set(p, q, 0.0);
    a.set(q, p, 0.0);
}

pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The chain of equal springs, whose eigenvalues are 2 − 2 cos(iπ/(n + 1)).
    fn chain(n: usize) -> Dense {
        let mut a = Dense::zero(n);
        for i in 0..n {
            a.set(i, i, 2.0);
            if i > 0 {
                a.set(i, i - 1, -1.0);
                a.set(i - 1, i, -1.0);
            }
        }
        a
    }

    #[test]
    fn the_chain_has_its_known_eigenvalues_and_vectors() {
        let n = 20;
        let (values, vectors) = chain(n).eigen();
        for (i, value) in values.iter().enumerate() {
            let exact = 2.0 - 2.0 * (std::f64::consts::PI * (i + 1) as f64 / (n + 1) as f64).cos();
            assert!((value - exact).abs() < 1e-13, "{value} against {exact}");
            let v = &vectors.values[i * n..(i + 1) * n];
            assert!((dot(v, v) - 1.0).abs() < 1e-13);
            for (av, v) in chain(n).times(v).iter().zip(v) {
                assert!((av - exact * v).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn a_solution_satisfies_its_equations_and_a_singular_matrix_is_refused() {
        let a = chain(30);
        let b: Vec<f64> = (0..30).map(|i| f64::from(i).sin()).collect();
        let x = a.solve(&b).unwrap();
        for (ax, b) in a.times(&x).iter().zip(&b) {
            assert!((ax - b).abs() < 1e-12);
        }
        let mut free = chain(5);
        free.set(0, 0, 1.0);
        free.set(4, 4, 1.0);
        assert!(matches!(free.solve(&[1.0; 5]), Err(VerifyError::Singular(4))));
    }
}
