//! Sparse symmetric equations and their solution by conjugate gradients (`hestenes1952`), scaled by an incomplete Cholesky factor
//! (`meijerink1977`).

use crate::element::PAIRS;

/// A symmetric matrix by rows, both halves; the pattern is that of the elements.
pub(crate) struct Matrix {
    /// Where each row begins.
    starts: Vec<u32>,
    /// Columns, ascending in a row.
    columns: Vec<u32>,
    values: Vec<f64>,
    /// Where in a row its diagonal is.
    diagonal: Vec<u32>,
    /// Where each entry of [`PAIRS`] of each element goes, and its mirror image.
    slots: Vec<[[u32; 2]; 36]>,
}

impl Matrix {
    /// The pattern of elements whose corners are rows.
    pub fn new(rows: usize, elements: &[[u32; 8]]) -> Self {
        let mut at: Vec<u32> = vec![0; rows + 1];
        elements.iter().flatten().for_each(|&n| at[n as usize + 1] += 1);
        (0..rows).for_each(|i| at[i + 1] += at[i]);
        let mut of = vec![0u32; at[rows] as usize];
        let mut next = at.clone();
        for (e, corners) in elements.iter().enumerate() {
            for &n in corners {
                of[next[n as usize] as usize] = e as u32;
                next[n as usize] += 1;
            }
        }
        let (mut starts, mut columns, mut diagonal) = (vec![0u32], Vec::new(), Vec::new());
        let mut row: Vec<u32> = Vec::new();
        for i in 0..rows {
            row.clear();
            row.push(i as u32);
            let around = &of[at[i] as usize..at[i + 1] as usize];
            row.extend(around.iter().flat_map(|&e| elements[e as usize]));
            row.sort_unstable();
            row.dedup();
            diagonal.push(columns.len() as u32 + row.partition_point(|&j| j < i as u32) as u32);
            columns.extend_from_slice(&row);
            starts.push(columns.len() as u32);
        }
        let slot = |i: u32, j: u32| {
            let (start, end) = (starts[i as usize], starts[i as usize + 1]);
            start + columns[start as usize..end as usize].partition_point(|&column| column < j) as u32
        };
        let slots = elements
            .iter()
            .map(|corners| PAIRS.map(|(a, b)| [slot(corners[a], corners[b]), slot(corners[b], corners[a])]));
        let slots = slots.collect();
        let values = vec![0.0; columns.len()];
        Matrix { starts, columns, values, diagonal, slots }
    }

    /// All entries to zero.
    pub fn clear(&mut self) {
        self.values.fill(0.0);
    }

    /// Adds an element's entries, times a factor.
    pub fn add(&mut self, element: usize, entries: &[f64; 36], factor: f64) {
        for ((entry, [there, mirrored]), (a, b)) in entries.iter().zip(self.slots[element]).zip(PAIRS) {
            self.values[there as usize] += factor * entry;
            if a != b {
                self.values[mirrored as usize] += factor * entry;
            }
        }
    }

    fn row(&self, i: usize) -> std::ops::Range<usize> {
        self.starts[i] as usize..self.starts[i + 1] as usize
    }

    /// y = K x
    pub fn times(&self, x: &[f64], y: &mut [f64]) {
        for (i, out) in y.iter_mut().enumerate() {
            let row = self.row(i);
            let entries = self.columns[row.clone()].iter().zip(&self.values[row]);
            *out = entries.map(|(&j, v)| v * x[j as usize]).sum();
        }
    }

    /// Finds x at the rows that are free, what is held staying, so that K x is 0 there, to `tolerance` of the flow that x has to balance:
    /// of what the held rows bring. Returns the iterations.
    ///
    /// # Errors
    /// The iterations made without success.
    pub fn solve(&self, held: &[bool], x: &mut [f64], tolerance: f64) -> Result<usize, usize> {
        let n = x.len();
        let most = 10_000;
        let free =
            |v: &mut [f64]| v.iter_mut().zip(held).filter(|(_, held)| **held).for_each(|(v, _)| *v = 0.0);
        let mut r = vec![0.0; n];
        let brought: Vec<f64> = x.iter().zip(held).map(|(x, held)| if *held { *x } else { 0.0 }).collect();
        self.times(&brought, &mut r);
        free(&mut r);
        // What round-off leaves of the products is no flow.
        let rounded = |(i, x): (usize, &f64)| 1e-14 * self.values[self.diagonal[i] as usize] * x;
        let rounded: Vec<f64> = x.iter().enumerate().map(rounded).collect();
        let goal = (tolerance * norm(&r)).max(norm(&rounded));
        self.times(x, &mut r);
        r.iter_mut().for_each(|r| *r = -*r);
        free(&mut r);
        if norm(&r) <= goal {
            return Ok(0);
        }
        let factor = Factor::new(self, held);
        let mut z = vec![0.0; n];
        factor.solve(&r, &mut z);
        let mut p = z.clone();
        let mut q = vec![0.0; n];
        let mut rz = dot(&r, &z);
        for iteration in 1..=most {
            self.times(&p, &mut q);
            free(&mut q);
            let step = rz / dot(&p, &q);
            if !step.is_finite() {
                return Err(iteration);
            }
            for i in 0..n {
                x[i] += step * p[i];
                r[i] -= step * q[i];
            }
            if norm(&r) <= goal {
                return Ok(iteration);
            }
            factor.solve(&r, &mut z);
            let next = dot(&r, &z);
            let ratio = next / rz;
            rz = next;
            p.iter_mut().zip(&z).for_each(|(p, z)| *p = z + ratio * *p);
        }
        Err(most)
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

/// L of L Lᵀ ≈ K among the free rows, with the pattern of K; held rows are those of the identity.
struct Factor {
    starts: Vec<u32>,
    columns: Vec<u32>,
    values: Vec<f64>,
    /// 1/L_ii
    inverse: Vec<f64>,
}

impl Factor {
    /// Where the factor of K itself does not exist, which can be since K has positive entries beside the diagonal, that of K with a larger
    /// diagonal (`manteuffel1980`).
    fn new(matrix: &Matrix, held: &[bool]) -> Self {
        let mut shift = 0.0;
        loop {
            if let Some(factor) = Factor::shifted(matrix, held, shift) {
                return factor;
            }
            shift = if shift == 0.0 { 1e-3 } else { 2.0 * shift };
        }
    }

    fn shifted(matrix: &Matrix, held: &[bool], shift: f64) -> Option<Self> {
        let n = held.len();
        let (mut starts, mut columns, mut values) = (vec![0u32], Vec::new(), Vec::<f64>::new());
        let mut inverse = vec![1.0; n];
        let mut work = vec![0.0; n];
        for i in 0..n {
            let first = columns.len();
            if !held[i] {
                let below = matrix.row(i).start..matrix.diagonal[i] as usize;
                let mut square = 0.0;
                for at in below {
                    let j = matrix.columns[at] as usize;
                    if held[j] {
                        continue;
                    }
                    let row = starts[j] as usize..starts[j + 1] as usize;
                    let known = columns[row.clone()].iter().zip(&values[row]);
                    let sum: f64 = known.map(|(&k, v): (&u32, &f64)| v * work[k as usize]).sum();
                    let entry = (matrix.values[at] - sum) * inverse[j];
                    work[j] = entry;
                    square += entry * entry;
                    columns.push(j as u32);
                    values.push(entry);
                }
                columns[first..].iter().for_each(|&j| work[j as usize] = 0.0);
                let diagonal = matrix.values[matrix.diagonal[i] as usize];
                let pivot = diagonal * (1.0 + shift) - square;
                // A pivot of next to nothing would make the factor useless.
                if pivot.is_nan() || pivot <= 1e-4 * diagonal {
                    return None;
                }
                inverse[i] = pivot.sqrt().recip();
            }
            starts.push(columns.len() as u32);
        }
        Some(Factor { starts, columns, values, inverse })
    }

    /// x of L Lᵀ x = b
    fn solve(&self, b: &[f64], x: &mut [f64]) {
        let n = b.len();
        let row = |i: usize| self.starts[i] as usize..self.starts[i + 1] as usize;
        for i in 0..n {
            let known = self.columns[row(i)].iter().zip(&self.values[row(i)]);
            let sum: f64 = known.map(|(&j, v)| v * x[j as usize]).sum();
            x[i] = (b[i] - sum) * self.inverse[i];
        }
        for i in (0..n).rev() {
            let own = x[i] * self.inverse[i];
            x[i] = own;
            for (&j, v) in self.columns[row(i)].iter().zip(&self.values[row(i)]) {
                x[j as usize] -= v * own;
            }
        }
    }
}
