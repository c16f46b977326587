//! Small matrices as rows of numbers.

/// Rows of equal length.
pub type Matrix = Vec<Vec<f64>>;

/// The lower factor L of a symmetric matrix A = L Lᵀ; nothing where it is not positive definite.
pub fn cholesky(a: &Matrix) -> Option<Matrix> {
    let n = a.len();
    let mut l = vec![vec![0.0; n]; n];
    for i in 0..n {
        for j in 0..=i {
            let rest = a[i][j] - (0..j).map(|k| l[i][k] * l[j][k]).sum::<f64>();
            if i == j && !(rest > 1e-12) {
                return None;
            }
            l[i][j] = if i == j { rest.sqrt() } else { rest / l[j][j] };
        }
    }
    Some(l)
}

/// x of L x = b, with L lower.
pub fn solve_lower(l: &Matrix, b: &[f64]) -> Vec<f64> {
    let mut x = Vec::with_capacity(b.len());
    for i in 0..b.len() {
        let rest = b[i] - (0..i).map(|k| l[i][k] * x[k]).sum::<f64>();
        x.push(rest / l[i][i]);
    }
    x
}

/// Pearson's correlations between columns.
pub fn correlation(columns: &[Vec<f64>]) -> Matrix {
    let centred: Vec<Vec<f64>> = columns
        .iter()
        .map(|column| {
            let mean = column.iter().sum::<f64>() / column.len() as f64;
            column.iter().map(|x| x - mean).collect()
        })
        .collect();
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let sizes: Vec<f64> = centred.iter().map(|c| dot(c, c).sqrt()).collect();
    let row = |i: usize| {
        (0..columns.len()).map(|j| dot(&centred[i], &centred[j]) / (sizes[i] * sizes[j])).collect()
    };
    (0..columns.len()).map(row).collect()
}

/// The place of each value among all, from 0; equal ones in their order.
pub fn ranks(values: &[f64]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|&a, &b| values[a].total_cmp(&values[b]).then(a.cmp(&b)));
    let mut ranks = vec![0; values.len()];
    for (rank, &k) in order.iter().enumerate() {
        ranks[k] = rank;
    }
    ranks
}

/// Spearman's correlation of the ranks of two columns, equal values sharing their mean rank; nothing where one does not vary.
pub fn spearman(a: &[f64], b: &[f64]) -> Option<f64> {
    let mean_ranks = |values: &[f64]| -> Vec<f64> {
        let rank = |x: &f64| {
            let below = values.iter().filter(|y| *y < x).count() as f64;
            let equal = values.iter().filter(|y| *y == x).count() as f64;
            below + 0.5 * (equal - 1.0)
        };
        values.iter().map(rank).collect()
    };
    let found = correlation(&[mean_ranks(a), mean_ranks(b)])[0][1];
    found.is_finite().then_some(found)
}
