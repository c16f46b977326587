//! Finding the strain that gives prescribed stresses: Levenberg–Marquardt with a numerical tangent.

use super::Control;
use crate::material::Moduli;

/// Strain under mixed control, kept from row to row as the next guess.
pub(super) struct Mixed {
    moduli: Moduli,
    control: [Control; 6],
    free: Vec<usize>,
    strain: [f64; 6],
    /// Largest strain before: a path that comes back to zero is met there as closely as elsewhere.
    level: f64,
}

/// Rounds of a search before it counts as failed; a smooth law takes two or three.
const ROUNDS: usize = 200;

impl Mixed {
    pub fn new(moduli: Moduli, control: [Control; 6]) -> Self {
        let free = (0..6).filter(|&k| control[k] == Control::Stress).collect();
        Mixed { moduli, control, free, strain: [0.0; 6], level: 0.0 }
    }

    /// The strain of a row: `values` where strain is prescribed, the rest so that `stress` meets them.
    ///
    /// # Errors
    /// What is left of the largest component of stress \[Pa\].
    pub fn strain(
        &mut self,
        values: &[f64; 6],
        stress: impl Fn(&[f64; 6]) -> [f64; 6],
    ) -> Result<[f64; 6], f64> {
        // Here it is still the strain of the row before.
        self.level = self.strain.iter().fold(self.level, |most, e| most.max(e.abs()));
        for ((own, given), control) in self.strain.iter_mut().zip(values).zip(self.control) {
            if control == Control::Strain {
                *own = *given;
            }
        }
        if self.free.is_empty() {
            return Ok(self.strain);
        }
        let n = self.free.len();
        let modulus = self.moduli.lambda + 2.0 * self.moduli.mu;
        let miss = |strain: &[f64; 6]| -> Vec<f64> {
            let found = stress(strain);
            self.free.iter().map(|&k| (found[k] - values[k]) / modulus).collect()
        };
        let size =
            |v: &[f64]| v.iter().fold(0.0f64, |m, x| if x.is_nan() { f64::INFINITY } else { m.max(x.abs()) });
        let mut left = miss(&self.strain);
        let mut damping = 0.0;
        for _ in 0..ROUNDS {
            let level = self.level.max(size(&self.strain)).max(size(values) / modulus);
            if size(&left) <= 1e-13 * level {
                return Ok(self.strain);
            }
            // A step well above round-off and well below any strain that matters.
            let step = 1e-7 * level.max(1e-9);
            let mut tangent = vec![vec![0.0; n]; n];
            for (c, &k) in self.free.iter().enumerate() {
                let mut moved = self.strain;
                moved[k] += step;
                let taken = moved[k] - self.strain[k];
                for (r, x) in miss(&moved).into_iter().enumerate() {
                    tangent[r][c] = (x - left[r]) / taken;
                }
            }
            let change = damped_step(&tangent, &left, damping);
            let mut tried = self.strain;
            for (&k, d) in self.free.iter().zip(&change) {
                tried[k] -= d;
            }
            let then = miss(&tried);
            if size(&then) < size(&left) {
                self.strain = tried;
                left = then;
                damping *= 0.01;
            } else if size(&left) <= 1e-10 * level {
                // Round-off of a law that switches branches at the solution.
                return Ok(self.strain);
            } else {
                damping = (10.0 * damping).max(1e-6);
            }
        }
        Err(size(&left) * modulus)
    }
}

/// Solves (TᵀT + d I) x = Tᵀ r by elimination with pivoting; a direction without stiffness stays where it is.
fn damped_step(tangent: &[Vec<f64>], left: &[f64], damping: f64) -> Vec<f64> {
    let n = left.len();
    let mut a = vec![vec![0.0; n + 1]; n];
    for i in 0..n {
        for j in 0..n {
            a[i][j] = (0..n).map(|r| tangent[r][i] * tangent[r][j]).sum();
        }
        a[i][i] += damping + 1e-14;
        a[i][n] = (0..n).map(|r| tangent[r][i] * left[r]).sum();
    }
    for i in 0..n {
        let pivot = (i..n).max_by(|&p, &q| a[p][i].abs().total_cmp(&a[q][i].abs())).unwrap_or(i);
        a.swap(i, pivot);
        let pivot = a[i].clone();
        for row in &mut a[i + 1..] {
            let factor = row[i] / pivot[i];
            row.iter_mut().zip(&pivot).for_each(|(x, p)| *x -= factor * p);
        }
    }
    let mut x = vec![0.0; n];
    for i in (0..n).rev() {
        let rest: f64 = (i + 1..n).map(|c| a[i][c] * x[c]).sum();
        x[i] = (a[i][n] - rest) / a[i][i];
    }
    x
}
