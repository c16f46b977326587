//! Finding the strain that gives prescribed stresses: Levenberg–Marquardt with a numerical tangent.

use super::Control;
use crate::material::Moduli;

/// Which components are sought, and how closely.
pub(super) struct Mixed {
    moduli: Moduli,
    control: [Control; 6],
    free: Vec<usize>,
    /// Largest strain so far: a path that comes back to zero is met there as closely as elsewhere.
    level: f64,
    /// How many times as far as the elastic step the last one went.
    stretch: f64,
}

/// Where a search starts: a state that the material has reached.
#[derive(Clone, Copy)]
pub(super) struct Reached {
    pub strain: [f64; 6],
    /// \[Pa\]
    pub stress: [f64; 6],
}

/// How far from the reached strain an answer is sought.
#[derive(Clone, Copy)]
pub(super) enum Reach {
    /// A few times as far as the step before told. Where a crack carries next to nothing, Newton's steps grow without
    /// bound and would find a strain at which something else breaks.
    Near,
    Unlimited,
    /// From no strain too: no way leads out from where broken material has no stiffness.
    Elsewhere,
}

/// The closest that a search came.
pub(super) struct Missed {
    pub strain: [f64; 6],
    /// What is left of the largest component of stress \[Pa\].
    pub miss: f64,
}

/// Rounds of a search before it counts as failed; a smooth law takes two or three.
const ROUNDS: usize = 60;

/// Miss over the largest strain that is round-off of a law that switches branches at the solution.
const CLOSE: f64 = 1e-10;

/// The same of a law that stays elastic.
const ELASTIC: f64 = 1e-14;

/// The same of none; a search ends here without trying whether it can do better.
const EXACT: f64 = 1e-16;

/// Times the length of an elastic step that the next strain may be away, and that times what the last one took.
const NEAR: f64 = 4.0;

/// Damping over the trace of TᵀT that keeps a direction without stiffness where it is.
const LEAST_DAMPING: f64 = 1e-14;

/// Largest component; what is no number is larger than all.
fn size(v: &[f64]) -> f64 {
    v.iter().fold(0.0f64, |m, x| if x.is_nan() { f64::INFINITY } else { m.max(x.abs()) })
}

/// Largest difference between two strains.
fn distance(a: &[f64; 6], b: &[f64; 6]) -> f64 {
    size(&std::array::from_fn::<f64, 6, _>(|k| a[k] - b[k]))
}

impl Mixed {
    pub fn new(moduli: Moduli, control: [Control; 6]) -> Self {
        let free = (0..6).filter(|&k| control[k] == Control::Stress).collect();
        Mixed { moduli, control, free, level: 0.0, stretch: 1.0 }
    }

    /// Whether there is anything to be sought.
    pub fn seeks(&self) -> bool {
        !self.free.is_empty()
    }

    /// Remembers a strain that was reached.
    pub fn reach(&mut self, strain: &[f64; 6]) {
        self.level = self.level.max(size(strain));
    }

    /// A strain with the prescribed components put in.
    pub fn prescribed(&self, mut strain: [f64; 6], values: &[f64; 6]) -> [f64; 6] {
        for ((own, given), control) in strain.iter_mut().zip(values).zip(self.control) {
            if control == Control::Strain {
                *own = *given;
            }
        }
        strain
    }

    /// The strain that goes with `values`: they themselves where strain is prescribed, the rest so that `stress`
    /// meets them. First the elastic answer from a reached state is tried: a law that yields at the prescribed stress
    /// has many strains for it, and where it does not flow this one is the least. Then that nothing moves, which is the
    /// answer of an open crack that carries nothing. Else the strain is iterated from the elastic one, and from the
    /// reached one, as far as `reach` says.
    ///
    /// # Errors
    /// The trial with the smallest miss.
    pub fn strain(
        &mut self,
        values: &[f64; 6],
        from: &Reached,
        reach: Reach,
        stress: impl Fn(&[f64; 6]) -> [f64; 6],
    ) -> Result<[f64; 6], Missed> {
        let (elastic, holds) = self.elastic(values, from, &stress);
        if holds {
            self.stretch = 1.0;
            return Ok(elastic);
        }
        let still = self.prescribed(from.strain, values);
        if size(&self.miss(values, &stress(&still))) <= ELASTIC * self.level(&still, values) {
            return Ok(still);
        }
        let step = distance(&elastic, &from.strain);
        let mut closest = Missed { strain: elastic, miss: f64::INFINITY };
        let (starts, within) = match reach {
            Reach::Near => (2, NEAR * self.stretch * step),
            Reach::Unlimited => (2, f64::INFINITY),
            Reach::Elsewhere => (3, f64::INFINITY),
        };
        for start in [elastic, from.strain, [0.0; 6]].into_iter().take(starts) {
            match self.search(values, self.prescribed(start, values), within, &stress) {
                Ok(strain) => {
                    let stretch = distance(&strain, &from.strain) / step;
                    self.stretch = if stretch > 1.0 { stretch } else { 1.0 };
                    return Ok(strain);
                }
                Err(missed) if missed.miss < closest.miss => closest = missed,
                Err(_) => {}
            }
        }
        Err(closest)
    }

    /// The answer of an elastic step, and whether the law gives it.
    fn elastic(
        &self,
        values: &[f64; 6],
        from: &Reached,
        stress: impl Fn(&[f64; 6]) -> [f64; 6],
    ) -> ([f64; 6], bool) {
        let step = |strain: &[f64; 6]| -> [f64; 6] {
            let change: [f64; 6] = std::array::from_fn(|k| strain[k] - from.strain[k]);
            let change = self.moduli.stress(&change);
            std::array::from_fn(|k| from.stress[k] + change[k])
        };
        let modulus = self.moduli.lambda + 2.0 * self.moduli.mu;
        let mut strain = self.prescribed(from.strain, values);
        let left = self.miss(values, &step(&strain));
        for (&k, d) in self.free.iter().zip(solve(self.stiffness(), &left)) {
            strain[k] -= d;
        }
        let (expected, found) = (step(&strain), stress(&strain));
        let off = (0..6).map(|k| (found[k] - expected[k]) / modulus);
        (strain, size(&off.collect::<Vec<_>>()) <= ELASTIC * self.level(&strain, values))
    }

    /// Elastic stress in the sought components (rows) of unit strains in them (columns), over λ + 2μ.
    fn stiffness(&self) -> Vec<Vec<f64>> {
        let modulus = self.moduli.lambda + 2.0 * self.moduli.mu;
        let of_unit = |k: usize| self.moduli.stress(&std::array::from_fn(|i| f64::from(u8::from(i == k))));
        let columns: Vec<[f64; 6]> = self.free.iter().map(|&k| of_unit(k)).collect();
        self.free.iter().map(|&r| columns.iter().map(|stress| stress[r] / modulus).collect()).collect()
    }

    /// The strain that misses are measured by.
    fn level(&self, strain: &[f64; 6], values: &[f64; 6]) -> f64 {
        let load = size(values) / (self.moduli.lambda + 2.0 * self.moduli.mu);
        self.level.max(size(strain)).max(load)
    }

    /// What stress \[Pa\] is beyond the prescribed, over λ + 2μ.
    fn miss(&self, values: &[f64; 6], stress: &[f64; 6]) -> Vec<f64> {
        let modulus = self.moduli.lambda + 2.0 * self.moduli.mu;
        self.free.iter().map(|&k| (stress[k] - values[k]) / modulus).collect()
    }

    fn search(
        &self,
        values: &[f64; 6],
        start: [f64; 6],
        within: f64,
        stress: impl Fn(&[f64; 6]) -> [f64; 6],
    ) -> Result<[f64; 6], Missed> {
        let modulus = self.moduli.lambda + 2.0 * self.moduli.mu;
        let miss = |strain: &[f64; 6]| self.miss(values, &stress(strain));
        let mut tangent = self.stiffness();
        let mut strain = start;
        let mut left = miss(&strain);
        let mut damping = 0.0;
        for _ in 0..ROUNDS {
            let level = self.level(&strain, values);
            if size(&left) <= EXACT * level {
                return Ok(strain);
            }
            // So near, a step of the tangent would reach across a corner of the law: the last one serves.
            if size(&left) > CLOSE * level {
                // A step well above round-off and well below any strain that matters.
                let step = 1e-6 * level.max(1e-9);
                for (c, &k) in self.free.iter().enumerate() {
                    let mut moved = strain;
                    moved[k] += step;
                    let taken = moved[k] - strain[k];
                    for (r, x) in miss(&moved).into_iter().enumerate() {
                        tangent[r][c] = (x - left[r]) / taken;
                    }
                }
            }
            let mut tried = strain;
            for (&k, d) in self.free.iter().zip(damped_step(&tangent, &left, damping)) {
                tried[k] = (tried[k] - d).clamp(start[k] - within, start[k] + within);
            }
            let then = miss(&tried);
            if size(&then) < size(&left) {
                strain = tried;
                left = then;
                damping *= 0.01;
            } else if size(&left) <= CLOSE * level {
                // As close as round-off lets it come.
                return Ok(strain);
            } else {
                damping = (10.0 * damping).max(1e-6);
            }
        }
        if size(&left) <= CLOSE * self.level(&strain, values) {
            return Ok(strain);
        }
        Err(Missed { strain, miss: size(&left) * modulus })
    }
}

/// Solves (TᵀT + d I) x = Tᵀ r with the damping over the trace of TᵀT; without stiffness all stays where it is.
fn damped_step(tangent: &[Vec<f64>], left: &[f64], damping: f64) -> Vec<f64> {
    let n = left.len();
    let column = |i: usize, with: &dyn Fn(usize) -> f64| (0..n).map(|r| tangent[r][i] * with(r)).sum::<f64>();
    let mut square: Vec<Vec<f64>> =
        (0..n).map(|i| (0..n).map(|j| column(i, &|r| tangent[r][j])).collect()).collect();
    let trace: f64 = (0..n).map(|i| square[i][i]).sum();
    for (i, row) in square.iter_mut().enumerate() {
        row[i] += (damping + LEAST_DAMPING) * trace.max(f64::MIN_POSITIVE);
    }
    let right: Vec<f64> = (0..n).map(|i| column(i, &|r| left[r])).collect();
    solve(square, &right)
}

/// Solves a regular system by elimination with pivoting.
fn solve(mut a: Vec<Vec<f64>>, right: &[f64]) -> Vec<f64> {
    let n = right.len();
    for (row, x) in a.iter_mut().zip(right) {
        row.push(*x);
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
