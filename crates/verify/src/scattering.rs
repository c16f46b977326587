//! A plane P or SV wave at a round cavity, bare or lined, in an elastic space: exact in frequency, and a step of stress in time; an SH
//! wave in [`across`].
//!
//! Plane strain, tension positive; r and θ about the axis, θ from the direction in which the wave travels; time goes as
//! e^(−iωt). With u = ∇φ + ∇×ψ and q = ω/c_p, κ = ω/c_s the incident wave is φ = φ₀ Σ ε_n iⁿ J_n(qr) cos nθ, what is
//! scattered A_n H_n⁽¹⁾(qr) cos nθ in φ and B_n H_n⁽¹⁾(κr) sin nθ in ψ, and a liner has J_n and Y_n of both. For each n
//! the tractions vanish at the wall; at a liner's outer face tractions and displacements are those of the rock, to which it is
//! bonded (`pao1973`). An incident SV wave ψ = ψ₀ Σ ε_n iⁿ J_n(κr) cos nθ has sines and cosines changed, which is the same with −n for
//! n wherever that stands alone.

pub mod across;
mod step;

use crate::bessel::Bessel;
use crate::models::Solid;
use num_complex::Complex64;

const I: Complex64 = Complex64::I;
const ZERO: Complex64 = Complex64::ZERO;

/// A round cavity in rock.
#[derive(Clone, Copy, Debug)]
pub struct Cavity {
    pub rock: Solid,
    /// Radius \[m\] of the rock's wall.
    pub radius: f64,
    /// A bonded liner and its inner radius \[m\].
    pub liner: Option<(Solid, f64)>,
}

/// Where a stress is asked for: r \[m\] and θ \[rad\].
pub type Place = [f64; 2];

/// What comes in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Incoming {
    /// σ_xx = e^(i(qx − ωt)), x along its way.
    P,
    /// σ_xy = e^(i(κx − ωt)), y a quarter of a turn further round.
    Sv,
}

impl Incoming {
    /// n with its sign.
    fn order(self, n: usize) -> f64 {
        if self == Incoming::P { n as f64 } else { -(n as f64) }
    }
}

/// The solution at one frequency.
pub struct Scattered {
    cavity: Cavity,
    incoming: Incoming,
    omega: f64,
    /// By n: P and S waves in the rock; J and Y of P and of S in the liner.
    rock: Vec<[Complex64; 2]>,
    liner: Vec<[Complex64; 4]>,
}

/// Which potential.
#[derive(Clone, Copy, PartialEq)]
enum Wave {
    P,
    S,
}

/// u_r, u_θ \[m\], σ_r, τ_rθ, σ_θ \[Pa\] of a potential at a radius, without cos nθ or sin nθ.
type Field = [Complex64; 5];

/// Of the potential f(r) cos nθ (P) or f(r) sin nθ (S), f and its derivative given; of sine and cosine changed with −n.
fn field(solid: Solid, wave: Wave, number: f64, n: f64, r: f64, f: [Complex64; 2]) -> Field {
    let moduli = solid.moduli();
    let [f, slope] = f;
    // Bessel's equation.
    let bend = -slope / r - f * (number * number - n * n / (r * r));
    let twist = n * (slope / r - f / (r * r));
    let double = 2.0 * moduli.mu;
    match wave {
        Wave::P => {
            let even = -f * moduli.lambda * number * number;
            let hoop = even + double * (slope / r - f * n * n / (r * r));
            [slope, -f * n / r, even + double * bend, -double * twist, hoop]
        }
        Wave::S => {
            let shear = moduli.mu * (slope / r - f * n * n / (r * r) - bend);
            [f * n / r, -slope, double * twist, shear, -double * twist]
        }
    }
}

/// Both kinds of cylinder functions of one wave number at one radius.
struct Cylinder {
    number: f64,
    r: f64,
    bessel: Bessel,
}

impl Cylinder {
    fn new(most: usize, number: f64, r: f64) -> Self {
        Cylinder { number, r, bessel: Bessel::new(most + 1, number * r) }
    }

    /// The function a J + b Y of order n and its derivative by r.
    fn mixed(&self, n: usize, [a, b]: [Complex64; 2]) -> [Complex64; 2] {
        let at = |n: usize| a * self.bessel.j[n] + b * self.bessel.y[n];
        [at(n), at(n) * n as f64 / self.r - at(n + 1) * self.number]
    }
}

const J: [Complex64; 2] = [Complex64::ONE, ZERO];
const Y: [Complex64; 2] = [ZERO, Complex64::ONE];
const H: [Complex64; 2] = [Complex64::ONE, I];

/// Wave numbers \[1/m\] of P and S.
fn numbers(solid: Solid, omega: f64) -> [(Wave, f64); 2] {
    let (p, s) = solid.speeds();
    [(Wave::P, omega / p), (Wave::S, omega / s)]
}

impl Cavity {
    /// The solution at ω \[rad/s\] > 0.
    pub fn scatter(&self, incoming: Incoming, omega: f64) -> Scattered {
        let [p, s] = numbers(self.rock, omega);
        // Beyond the argument terms fall faster than any power.
        let most = s.1 * self.radius;
        let most = (most + 10.0 * most.cbrt() + 15.0) as usize;
        let inertia = self.rock.density * omega * omega;
        let (carrier, potential) = match incoming {
            Incoming::P => (0, -1.0 / inertia),
            Incoming::Sv => (1, 1.0 / inertia),
        };
        let outside = [p, s].map(|(_, number)| Cylinder::new(most, number, self.radius));
        let of = |cylinder: &Cylinder, solid, wave, n, mixed| {
            field(solid, wave, cylinder.number, incoming.order(n), cylinder.r, cylinder.mixed(n, mixed))
        };
        let mut scattered = Scattered { cavity: *self, incoming, omega, rock: Vec::new(), liner: Vec::new() };
        let lined = self.liner.map(|(solid, inner)| {
            let at = |r: f64| numbers(solid, omega).map(|(_, number)| Cylinder::new(most, number, r));
            (solid, at(inner), at(self.radius))
        });
        for n in 0..=most {
            let amplitude = potential * if n == 0 { 1.0 } else { 2.0 } * I.powu(n as u32);
            let carried = if carrier == 0 { Wave::P } else { Wave::S };
            let incident = of(&outside[carrier], self.rock, carried, n, J).map(|x| x * amplitude);
            let rock = [of(&outside[0], self.rock, Wave::P, n, H), of(&outside[1], self.rock, Wave::S, n, H)];
            let Some((solid, within, without)) = &lined else {
                let row = |k: usize| vec![rock[0][k], rock[1][k], -incident[k]];
                let found = linear(vec![row(2), row(3)]);
                scattered.rock.push([found[0], found[1]]);
                continue;
            };
            let each = |at: &[Cylinder; 2]| {
                [(0, Wave::P, J), (0, Wave::P, Y), (1, Wave::S, J), (1, Wave::S, Y)]
                    .map(|(k, wave, mixed)| of(&at[k], *solid, wave, n, mixed))
            };
            let (within, without) = (each(within), each(without));
            let mut rows: Vec<Vec<Complex64>> = Vec::new();
            for k in [2, 3] {
                rows.push(within.iter().map(|f| f[k]).chain([ZERO; 3]).collect());
            }
            for k in 0..4 {
                let liner = without.iter().map(|f| f[k]);
                rows.push(liner.chain([-rock[0][k], -rock[1][k], incident[k]]).collect());
            }
            let found = linear(rows);
            scattered.liner.push([found[0], found[1], found[2], found[3]]);
            scattered.rock.push([found[4], found[5]]);
        }
        scattered
    }
}

impl Scattered {
    /// σ_θ at places, over the incident stress at the axis.
    pub fn hoops(&self, places: &[Place]) -> Vec<Complex64> {
        let mut known: Vec<(f64, Vec<Complex64>)> = Vec::new();
        let mut out = Vec::new();
        for &[r, angle] in places {
            let at = known.iter().position(|(radius, _)| *radius == r).unwrap_or_else(|| {
                known.push((r, self.orders(r)));
                known.len() - 1
            });
            let orders = &known[at].1;
            let round = |n: i32| match self.incoming {
                Incoming::P => (f64::from(n) * angle).cos(),
                Incoming::Sv => (f64::from(n) * angle).sin(),
            };
            let mut hoop: Complex64 = orders.iter().zip(0..).map(|(x, n)| x * round(n)).sum();
            if r >= self.cavity.radius {
                // The incident wave in closed form.
                let moduli = self.cavity.rock.moduli();
                let across = moduli.lambda / (moduli.lambda + 2.0 * moduli.mu);
                let (sine, cosine) = angle.sin_cos();
                let (p, s) = self.cavity.rock.speeds();
                let (share, speed) = match self.incoming {
                    Incoming::P => (sine * sine + across * cosine * cosine, p),
                    Incoming::Sv => (-2.0 * sine * cosine, s),
                };
                hoop += share * Complex64::from_polar(1.0, self.omega / speed * r * cosine);
            }
            out.push(hoop);
        }
        out
    }

    /// σ_θ by order n at a radius, the incident wave in the rock left out.
    fn orders(&self, r: f64) -> Vec<Complex64> {
        let most = self.rock.len() - 1;
        let inside = r < self.cavity.radius;
        let solid = self.cavity.liner.filter(|_| inside).map_or(self.cavity.rock, |(solid, _)| solid);
        let waves = numbers(solid, self.omega).map(|(wave, number)| (wave, Cylinder::new(most, number, r)));
        let one = |n: usize| {
            let mixed = if inside {
                let [a, b, c, d] = self.liner.get(n).copied().unwrap_or([ZERO; 4]);
                [[a, b], [c, d]]
            } else {
                self.rock[n].map(|x| [x, I * x])
            };
            let parts = waves.iter().zip(mixed).map(|((wave, cylinder), mixed)| {
                field(solid, *wave, cylinder.number, self.incoming.order(n), r, cylinder.mixed(n, mixed))[4]
            });
            parts.sum()
        };
        (0..=most).map(one).collect()
    }
}

/// Solves linear equations, each row with its right side last, by elimination with pivots, columns and rows brought to one
/// size: orders differ by hundreds of decades.
fn linear(mut rows: Vec<Vec<Complex64>>) -> Vec<Complex64> {
    let n = rows.len();
    let size = |of: &mut dyn Iterator<Item = Complex64>| of.fold(0.0, |most: f64, x| most.max(x.norm()));
    let columns: Vec<f64> = (0..n).map(|k| size(&mut rows.iter().map(|row| row[k]))).collect();
    for row in &mut rows {
        row.iter_mut().zip(&columns).for_each(|(x, size)| *x /= size);
        let size = size(&mut row[..n].iter().copied());
        row.iter_mut().for_each(|x| *x /= size);
    }
    for k in 0..n {
        let pivot = (k..n).max_by(|&i, &j| rows[i][k].norm().total_cmp(&rows[j][k].norm())).unwrap_or(k);
        rows.swap(k, pivot);
        let lead = rows[k].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(i, _)| *i != k) {
            let factor = row[k] / lead[k];
            row.iter_mut().zip(&lead).skip(k).for_each(|(x, lead)| *x -= factor * lead);
        }
    }
    (0..n).map(|k| rows[k][n] / rows[k][k] / columns[k]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    pub(super) const ROCK: Solid = Solid { young: 10e9, poisson: 0.25, density: 2752.293577981651 };
    pub(super) const LINER: Solid = Solid { young: 25e9, poisson: 0.17, density: 2752.293577981651 };
    const ANGLES: [f64; 9] = [0.0, 30.0, 45.0, 60.0, 90.0, 120.0, 135.0, 150.0, 180.0];

    pub(super) fn bare() -> Cavity {
        Cavity { rock: ROCK, radius: 8.5, liner: None }
    }

    pub(super) fn around(r: f64) -> Vec<Place> {
        ANGLES.map(|angle| [r, angle.to_radians()]).to_vec()
    }

    fn sizes(cavity: Cavity, omega: f64, r: f64) -> Vec<f64> {
        cavity.scatter(Incoming::P, omega).hoops(&around(r)).iter().map(|x| x.norm()).collect()
    }

    pub(super) fn near(found: &[f64], exact: &[f64], tolerance: f64) {
        for (k, (found, exact)) in found.iter().zip(exact).enumerate() {
            assert!((found - exact).abs() < tolerance, "{k}: {found} {exact}");
        }
    }

    /// Values of a separate program, ν = ¼.
    #[test]
    fn a_bare_wall_has_the_stresses_of_a_separate_solution() {
        for (ka, exact) in [
            (0.1, [0.045828, 0.666300, 1.365364, 2.063651, 2.758850, 2.059273, 1.363046, 0.668298, 0.045623]),
            (0.5, [0.464350, 0.941183, 1.572291, 2.143205, 2.461222, 1.766869, 1.293219, 0.869261, 0.471898]),
            (3.0, [0.668512, 0.386299, 0.640250, 0.880063, 1.235375, 1.179606, 0.811817, 0.377138, 0.062611]),
        ] {
            near(&sizes(bare(), ka * ROCK.speeds().0 / 8.5, 8.5), &exact, 1e-6);
        }
        let phases = bare().scatter(Incoming::P, 0.25 * ROCK.speeds().0 / 8.5).hoops(&around(8.5));
        let [ahead, beside] = [phases[0], phases[4]];
        near(
            &[ahead.re, ahead.im, beside.re, beside.im],
            &[0.0064499, -0.2243965, 2.8614966, 0.5203541],
            1e-6,
        );
    }

    #[test]
    fn slow_waves_concentrate_as_the_static_plane_does_and_most_at_a_quarter() {
        let beside = |ka: f64| sizes(bare(), ka * ROCK.speeds().0 / 8.5, 8.5)[4];
        near(&[beside(1e-3), beside(0.255)], &[8.0 / 3.0, 2.908_554_7], 1e-4);
        assert!(beside(0.245) < beside(0.255) && beside(0.265) < beside(0.255));
    }

    /// Values of a separate program.
    #[test]
    fn a_liner_has_the_stresses_of_a_separate_solution() {
        let lined = Cavity { liner: Some((LINER, 8.0)), ..bare() };
        let below = 8.5 * (1.0 - 1e-9);
        for (hertz, r, exact) in [
            (
                1.0,
                8.0,
                [0.238307, 1.564908, 2.891519, 4.218111, 5.544639, 4.218017, 2.891470, 1.564952, 0.238473],
            ),
            (
                15.0,
                8.0,
                [0.730274, 1.826381, 3.233704, 4.611503, 5.784955, 4.304743, 3.047590, 1.881227, 0.867016],
            ),
            (
                15.0,
                below,
                [0.878617, 1.913326, 3.039909, 4.137783, 5.079771, 3.894719, 2.879517, 1.931428, 1.071655],
            ),
            (
                15.0,
                8.5,
                [0.373429, 0.819906, 1.304191, 1.775695, 2.179677, 1.669727, 1.233299, 0.826182, 0.458713],
            ),
        ] {
            near(&sizes(lined, TAU * hertz, r), &exact, 2e-6);
        }
    }

    /// A liner of rock is a smaller cavity; so displacements and tractions are handed on as they are.
    #[test]
    fn a_liner_of_rock_is_rock() {
        let omega = 300.0;
        let lined = Cavity { liner: Some((ROCK, 8.0)), ..bare() };
        let smaller = Cavity { radius: 8.0, ..bare() };
        for (r, incoming) in
            [8.0, 8.2, 8.5, 11.0].into_iter().flat_map(|r| [(r, Incoming::P), (r, Incoming::Sv)])
        {
            let places = around(r);
            let both = [lined, smaller].map(|cavity| cavity.scatter(incoming, omega).hoops(&places));
            for (a, b) in both[0].iter().zip(&both[1]) {
                assert!((a - b).norm() < 1e-9, "{r}: {a} {b}");
            }
        }
    }

    /// Slow shear at a bare wall is that of the plane under shear, 4 sin 2θ (`kirsch1898` at 45° and 135°).
    #[test]
    fn slow_shear_is_that_of_the_static_plane() {
        let found = bare().scatter(Incoming::Sv, 1e-3 * ROCK.speeds().1 / 8.5).hoops(&around(8.5));
        for (found, angle) in found.iter().zip(ANGLES) {
            let exact = -4.0 * (2.0 * angle.to_radians()).sin();
            assert!((found - exact).norm() < 5e-3, "{angle}: {found} {exact}");
        }
    }

    /// Far from what is scattered the sum of the series is the incident wave: with a cavity that is hardly one.
    #[test]
    fn a_shear_wave_passes_a_cavity_that_is_hardly_one() {
        let tiny = Cavity { radius: 1e-4, ..bare() };
        let [r, omega] = [8.5, 200.0];
        let found = tiny.scatter(Incoming::Sv, omega).hoops(&around(r));
        for (found, angle) in found.iter().zip(ANGLES) {
            let (sine, cosine) = angle.to_radians().sin_cos();
            let exact =
                -2.0 * sine * cosine * Complex64::from_polar(1.0, omega / ROCK.speeds().1 * r * cosine);
            assert!((found - exact).norm() < 1e-6, "{angle}: {found} {exact}");
        }
    }
}
