//! The waves of a layer at a horizontal slowness: what they move and what they pull at, one that goes up and one that goes down
//! of each kind.
//!
//! All goes as e^(s(t − p x_h)), a wave that goes up as e^(−s q z) besides, with q² = ρI/M − p². Displacement stands in rows,
//! (u_h, u_z) or u_t, stress on a level as σ/(−s), (σ_hz, σ_zz) or σ_tz: both then do not depend on frequency without damping
//! (`kennett1983`, with other signs).

use super::rock::Seen;
use tremolite_motion::Complex64;

/// Rows of a vector, columns of modes.
pub type Square<const N: usize> = [[Complex64; N]; N];

/// The modes of a layer.
#[derive(Clone, Copy, Debug)]
pub struct Modes<const N: usize> {
    /// Vertical slowness \[s/m\], Re(s q) ≥ 0: a wave that goes up fades upwards.
    pub slowness: [Complex64; N],
    /// Displacement of the waves that go up, and down.
    pub moved: [Square<N>; 2],
    /// Stress over −s \[Pa s/m\].
    pub pulled: [Square<N>; 2],
}

/// Least |q² c²|: at grazing incidence both waves of a kind are one. As much as a change of the speed by half of it.
const GRAZING: f64 = 1e-10;

/// q of a wave with inertia over modulus `square` \[s²/m²\].
fn vertical(square: Complex64, p: f64, s: Complex64) -> Complex64 {
    let rest = square - p * p;
    if rest.norm() < GRAZING * square.norm() {
        return (GRAZING * square).sqrt();
    }
    let q = rest.sqrt();
    let fades = s * q;
    if fades.re < -1e-12 * fades.norm() { -q } else { q }
}

/// P and SV, both of length 1 without damping: P moves along its way, SV along h cos θ − z sin θ of it.
pub fn p_sv(rock: &Seen, speeds: [f64; 2], p: f64, s: Complex64) -> Modes<2> {
    let [a, b] = speeds;
    let qp = vertical(rock.inertia / rock.pressure, p, s);
    let qs = vertical(rock.inertia / rock.shear, p, s);
    let real = Complex64::from;
    let bent = rock.inertia - 2.0 * rock.shear * (p * p);
    let along = |q: Complex64| 2.0 * rock.shear * p * q;
    Modes {
        slowness: [qp, qs],
        moved: [
            [[real(a * p), b * qs], [a * qp, real(-b * p)]],
            [[real(a * p), b * qs], [-a * qp, real(b * p)]],
        ],
        pulled: [
            [[a * along(qp), b * bent], [a * bent, -b * along(qs)]],
            [[-a * along(qp), -b * bent], [a * bent, -b * along(qs)]],
        ],
    }
}

/// SH, of length 1.
pub fn sh(rock: &Seen, p: f64, s: Complex64) -> Modes<1> {
    let q = vertical(rock.inertia / rock.shear, p, s);
    let one = Complex64::from(1.0);
    Modes { slowness: [q], moved: [[[one]], [[one]]], pulled: [[[rock.shear * q]], [[-rock.shear * q]]] }
}

/// Solves A x = b for some right-hand sides, of order 4 at most, rows scaled and chosen. Not numbers where A is singular.
pub fn solve<const M: usize>(rows: &mut [[Complex64; 4]], right: &mut [[Complex64; M]]) {
    let n = rows.len();
    for (row, right) in rows.iter_mut().zip(right.iter_mut()) {
        let most = row[..n].iter().map(|x| x.norm_sqr()).fold(0.0, f64::max).sqrt();
        row.iter_mut().chain(right.iter_mut()).for_each(|x| *x /= most);
    }
    for k in 0..n {
        let size = |i: usize, rows: &[[Complex64; 4]]| rows[i][k].norm_sqr();
        let pivot = (k..n).fold(k, |best, i| if size(i, rows) > size(best, rows) { i } else { best });
        rows.swap(k, pivot);
        right.swap(k, pivot);
        for i in k + 1..n {
            let share = rows[i][k] / rows[k][k];
            for j in k..n {
                let above = rows[k][j];
                rows[i][j] -= share * above;
            }
            for j in 0..M {
                let above = right[k][j];
                right[i][j] -= share * above;
            }
        }
    }
    for k in (0..n).rev() {
        for j in 0..M {
            let known: Complex64 = (k + 1..n).map(|i| rows[k][i] * right[i][j]).sum();
            right[k][j] = (right[k][j] - known) / rows[k][k];
        }
    }
}
