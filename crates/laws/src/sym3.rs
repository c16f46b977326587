//! Symmetric tensors of order two in three dimensions: principal values and directions.

mod eigen;
mod eight;

pub use eigen::{Axes, Eigen, Spectrum, Spread, eigen};
pub use eight::{eigen_of_eight, extreme_values};

/// Principal values, largest first, by Jacobi's rotations (Golub & Van Loan 2013, section 8.5).
///
/// Components are xx, yy, zz, xy, yz, zx (tensor shear, not engineering). Exact to round-off of the largest value
/// for any finite tensor, equal values included; not finite where the tensor is not.
pub fn principal_values(t: &[f64; 6]) -> [f64; 3] {
    let mut a = [[t[0], t[3], t[5]], [t[3], t[1], t[4]], [t[5], t[4], t[2]]];
    let nothing = 1e-3 * f64::EPSILON * t.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    // Convergence is quadratic: six sweeps leave nothing above round-off, and mostly three do.
    for _ in 0..6 {
        if a[0][1].abs() <= nothing && a[0][2].abs() <= nothing && a[1][2].abs() <= nothing {
            break;
        }
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            if a[p][q] == 0.0 {
                continue;
            }
            let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
            let tangent = theta.signum() / (theta.abs() + (theta * theta + 1.0).sqrt());
            let cosine = 1.0 / (tangent * tangent + 1.0).sqrt();
            let sine = tangent * cosine;
            let r = 3 - p - q;
            let (rp, rq) = (a[r][p], a[r][q]);
            a[p][p] -= tangent * a[p][q];
            a[q][q] += tangent * a[p][q];
            a[p][q] = 0.0;
            a[q][p] = 0.0;
            a[r][p] = cosine * rp - sine * rq;
            a[p][r] = a[r][p];
            a[r][q] = sine * rp + cosine * rq;
            a[q][r] = a[r][q];
        }
    }
    let mut values = [a[0][0], a[1][1], a[2][2]];
    values.sort_by(|x, y| y.total_cmp(x));
    values
}

/// Whether all principal values surely lie below `most`, by more than the round-off of [`principal_values`]: a tenth of its cost. May say
/// no within 10⁻¹² of the largest component; says no where anything is not a number.
///
/// `most` I − t is positive definite where all pivots of its LDLᵀ are positive; what rounding then hides is a few ε of its largest
/// component (Golub & Van Loan 2013, section 4.2).
pub fn below(t: &[f64; 6], most: f64) -> bool {
    let [xx, yy, zz, xy, yz, zx] = *t;
    let size = t.iter().fold(most.abs(), |size, x| size.max(x.abs()));
    let most = most - 1e-12 * size;
    let first = most - xx;
    let (l, m) = (xy / first, zx / first);
    let second = (most - yy) - l * xy;
    let mixed = yz + l * zx;
    let third = (most - zz) - m * zx - mixed * (mixed / second);
    first > 0.0 && second > 0.0 && third > 0.0
}

#[cfg(test)]
mod tests {
    use super::{below, principal_values};

    #[test]
    fn principal_values_of_known_tensors() {
        assert_eq!(principal_values(&[0.0; 6]), [0.0; 3]);
        assert_eq!(principal_values(&[3.0, 1.0, 2.0, 0.0, 0.0, 0.0]), [3.0, 2.0, 1.0]);
        let shear = principal_values(&[0.0, 0.0, 0.0, 5.0, 0.0, 0.0]);
        for (found, exact) in shear.into_iter().zip([5.0, 0.0, -5.0]) {
            assert!((found - exact).abs() < 1e-14);
        }
        // All components 1: one value of 3, two of 0.
        let ones = principal_values(&[1.0; 6]);
        for (found, exact) in ones.into_iter().zip([3.0, 0.0, 0.0]) {
            assert!((found - exact).abs() < 1e-14);
        }
    }

    #[test]
    fn principal_values_keep_the_invariants() {
        let mut seed = 1u64;
        let mut random = || {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        };
        for scale in [1e-300, 1e-9, 1.0, 1e9, 1e150] {
            for _ in 0..200 {
                let t = [0; 6].map(|_| scale * random());
                let [a, b, c] = principal_values(&t);
                assert!(a >= b && b >= c);
                let trace = t[0] + t[1] + t[2];
                assert!((a + b + c - trace).abs() <= 1e-14 * scale);
                let n = t.map(|x| x / scale);
                let (a, b, c) = (a / scale, b / scale, c / scale);
                let det = n[0] * (n[1] * n[2] - n[4] * n[4]) - n[3] * (n[3] * n[2] - n[4] * n[5])
                    + n[5] * (n[3] * n[4] - n[1] * n[5]);
                assert!((a * b * c - det).abs() < 1e-14);
            }
        }
    }

    /// Never yes where a value is beyond, at the value itself or an ulp off it, equal values and large means included; always yes where
    /// all are clear of it.
    #[test]
    fn values_are_said_to_lie_below_just_where_they_do() {
        let mut seed = 7u64;
        let mut random = || {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        };
        for scale in [1e-250, 1e-9, 1.0, 1e7, 1e150] {
            for case in 0..3000 {
                let spread = [1.0, 1e-6, 1e-15, 0.0][case % 4];
                let mean = if case % 3 == 0 { 0.0 } else { scale * random() };
                let shear = if case % 5 == 0 { 0.0 } else { spread };
                let t = [0, 1, 2, 3, 4, 5].map(|c| {
                    scale * random() * if c < 3 { spread } else { shear } + if c < 3 { mean } else { 0.0 }
                });
                let values = principal_values(&t);
                let size = t.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
                for off in [0.0, 1e-16, 1e-14] {
                    assert!(!below(&t, values[0] - off * size), "{t:?}");
                }
                if size > 0.0 {
                    assert!(below(&t, values[0] + 1e-11 * size), "{t:?}");
                }
            }
        }
        let unknown = [0.0, f64::NAN, 0.0, 0.0, 0.0, 0.0];
        assert!(!below(&unknown, 1.0));
        assert!(!below(&[0.0; 6], f64::NEG_INFINITY));
        assert!(!below(&[f64::NEG_INFINITY, 0.0, 0.0, 0.0, 0.0, 0.0], 1.0));
    }
}
