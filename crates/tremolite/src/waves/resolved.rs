//! A motion of three components as one P, one SV and one SH wave of given ways.
//!
//! Each wave of amplitude 1 moves a place by a column of a matrix M: its polarisation, or what bare rock shows of it
//! ([`super::surface`]), complex beyond a critical angle. The waves that together move it as recorded are M⁻¹ times the record.

use super::heading::Heading;
use tremolite_motion::Complex64;

/// Rows east, north, up; a column for each wave.
pub type Square = [[Complex64; 3]; 3];

/// What three waves are of a record.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Resolved {
    /// By wave, what each component of the record is times in it.
    pub factors: Square,
    /// The least motion that waves of unit size together may make of the place: where it is small, some motion of it asks for
    /// waves far larger.
    pub least: f64,
    /// The largest such over that: by so much errors of the record may grow.
    pub condition: f64,
}

/// The motion in the axes of `heading` of a wave that moves a place by these along its way in plan, across it and up.
pub fn column(heading: &Heading, [along, across, up]: [Complex64; 3]) -> [Complex64; 3] {
    let ([x, y], [s, t]) = (heading.along, heading.across());
    [along * x + across * s, along * y + across * t, up]
}

/// The waves of columns; nothing where some motion cannot be made by them at all.
pub fn resolve(columns: [[Complex64; 3]; 3]) -> Option<Resolved> {
    let matrix: Square = [0, 1, 2].map(|i| [0, 1, 2].map(|j| columns[j][i]));
    let factors = inverse(&matrix)?;
    let least = 1.0 / norm(&factors);
    Some(Resolved { factors, least, condition: norm(&matrix) / least })
}

/// By the adjugate; nothing for a matrix that has none.
fn inverse(m: &Square) -> Option<Square> {
    let minor = |i: usize, j: usize| {
        let [a, b] = [(i + 1) % 3, (i + 2) % 3];
        let [c, d] = [(j + 1) % 3, (j + 2) % 3];
        m[a][c] * m[b][d] - m[a][d] * m[b][c]
    };
    let determinant: Complex64 = (0..3).map(|j| m[0][j] * minor(0, j)).sum();
    let scale = m.iter().flatten().map(|x| x.norm_sqr()).sum::<f64>().sqrt();
    (determinant.norm() > 1e-12 * scale.powi(3))
        .then(|| [0, 1, 2].map(|i| [0, 1, 2].map(|j| minor(j, i) / determinant)))
}

/// The largest singular value, the root of the largest eigenvalue of M*M. That matrix squared again and again, as here, is in the
/// end the projection on its vector, times what has been taken out: after 50 times eigenvalues apart by 10⁻¹⁴ are.
fn norm(m: &Square) -> f64 {
    let times = |a: &Square, b: &Square| -> Square {
        [0, 1, 2].map(|i| [0, 1, 2].map(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
    };
    let adjoint: Square = [0, 1, 2].map(|i| [0, 1, 2].map(|j| m[j][i].conj()));
    let gram = times(&adjoint, m);
    let trace = |a: &Square| (0..3).map(|i| a[i][i].re).sum::<f64>();
    let mut power = gram;
    for _ in 0..50 {
        let size = trace(&power);
        power = power.map(|row| row.map(|x| x / size));
        power = times(&power, &power);
    }
    let size = trace(&power);
    (trace(&times(&gram, &power)) / size).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::waves::WaveType;

    #[test]
    fn an_inverse_and_its_condition_are_what_they_say() {
        let c = |re: f64, im: f64| Complex64::new(re, im);
        let columns = [
            [c(1.0, 0.5), c(0.2, 0.0), c(0.0, 0.0)],
            [c(0.3, -0.4), c(2.0, 0.0), c(0.1, 0.0)],
            [c(0.0, 0.0), c(0.1, 1.0), c(-1.5, 0.2)],
        ];
        let Resolved { factors, .. } = resolve(columns).unwrap();
        for i in 0..3 {
            for j in 0..3 {
                let found: Complex64 = (0..3).map(|k| columns[k][i] * factors[k][j]).sum();
                assert!((found - f64::from(u8::from(i == j))).norm() < 1e-14, "{i} {j}: {found}");
            }
        }
        // Polarisations at right angles; and sizes apart by 2, 4 and 8.
        let one = |i: usize, x: f64| [0, 1, 2].map(|k| c(if k == i { x } else { 0.0 }, 0.0));
        let equal = resolve([one(0, 1.0), one(1, 1.0), one(2, 1.0)]).unwrap();
        assert!((equal.condition - 1.0).abs() < 1e-12 && (equal.least - 1.0).abs() < 1e-12);
        let apart = resolve([one(2, 8.0), one(0, 2.0), one(1, 4.0)]).unwrap();
        assert!((apart.condition - 4.0).abs() < 1e-12 && (apart.least - 2.0).abs() < 1e-12);
        assert!(resolve([one(0, 1.0), one(1, 1.0), one(0, 3.0)]).is_none());
    }

    #[test]
    fn columns_of_polarisations_are_polarisations() {
        for kind in [WaveType::P, WaveType::Sv, WaveType::Sh] {
            let heading = Heading { kind, angle: 0.4, along: [0.6, 0.8] };
            let (sin, cos) = heading.angle.sin_cos();
            let [zero, one] = [0.0, 1.0].map(Complex64::from);
            let own = match kind {
                WaveType::P => [sin.into(), zero, cos.into()],
                WaveType::Sv => [cos.into(), zero, (-sin).into()],
                WaveType::Sh => [zero, one, zero],
            };
            let found = column(&heading, own);
            let apart =
                found.iter().zip(heading.polarisation()).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max);
            assert!(apart < 1e-15, "{kind:?}: {apart}");
        }
    }
}
