//! A plane SH wave at a round cavity, bare or lined, in an elastic space, and at a half-round canyon.
//!
//! w along the axis, r and θ about it, θ from the way of the wave, time as e^(−iωt). The incident wave e^(iκx) = Σ ε_n iⁿ J_n(κr) cos nθ
//! comes back as A_n H_n⁽¹⁾(κr) cos nθ, a liner has J_n and Y_n; there is no traction μ ∂w/∂r at the wall, and a liner moves and pulls with
//! the rock it is bonded to (`pao1973`, chapter 3).
//!
//! A canyon half round in a free surface is half of a cavity on which a wave comes and its image in the surface, which together leave
//! the surface free: the solution of `trifunac1973`.

use super::{Cavity, H, I, J, Place, Y, linear};
use crate::bessel::Bessel;
use num_complex::Complex64;

/// The solution at one frequency: w over that of the incident wave at the axis.
pub struct Across {
    cavity: Cavity,
    /// κ \[1/m\] in the rock and in the liner.
    numbers: [f64; 2],
    /// By n: in the rock A_n; in the liner of J and Y.
    rock: Vec<Complex64>,
    liner: Vec<[Complex64; 2]>,
}

/// The function a J + b Y of order n and its derivative by r.
fn mixed(bessel: &Bessel, number: f64, r: f64, n: usize, [a, b]: [Complex64; 2]) -> [Complex64; 2] {
    let at = |n: usize| a * bessel.j[n] + b * bessel.y[n];
    [at(n), at(n) * n as f64 / r - at(n + 1) * number]
}

fn incident(n: usize) -> Complex64 {
    I.powu(n as u32) * if n == 0 { 1.0 } else { 2.0 }
}

impl Across {
    /// At ω \[rad/s\] > 0.
    pub fn new(cavity: Cavity, omega: f64) -> Across {
        let outside = omega / cavity.rock.speeds().1;
        let inside = cavity.liner.map_or(outside, |(solid, _)| omega / solid.speeds().1);
        let most = outside.max(inside) * cavity.radius;
        let most = (most + 10.0 * most.cbrt() + 15.0) as usize;
        let mut found = Across { cavity, numbers: [outside, inside], rock: Vec::new(), liner: Vec::new() };
        let wall = Bessel::new(most + 1, outside * cavity.radius);
        let lined = cavity.liner.map(|(solid, inner)| {
            let stiff = solid.moduli().mu / cavity.rock.moduli().mu;
            let at = |r: f64| (Bessel::new(most + 1, inside * r), r);
            (stiff, at(inner), at(cavity.radius))
        });
        for n in 0..=most {
            let of = |f| mixed(&wall, outside, cavity.radius, n, f);
            let (come, scattered) = (of(J).map(|x| x * incident(n)), of(H));
            let Some((stiff, (within, inner), (without, outer))) = &lined else {
                found.rock.push(-come[1] / scattered[1]);
                continue;
            };
            let [at_inner, at_outer] = [(within, *inner), (without, *outer)]
                .map(|(bessel, r)| [J, Y].map(|f| mixed(bessel, inside, r, n, f)));
            let zero = Complex64::ZERO;
            let a = linear(vec![
                vec![at_inner[0][1], at_inner[1][1], zero, zero],
                vec![at_outer[0][0], at_outer[1][0], -scattered[0], come[0]],
                vec![at_outer[0][1] * *stiff, at_outer[1][1] * *stiff, -scattered[1], come[1]],
            ]);
            found.liner.push([a[0], a[1]]);
            found.rock.push(a[2]);
        }
        found
    }

    /// By order n at a radius w and its derivative by r, the incident wave left out in the rock.
    fn orders(&self, r: f64) -> Vec<[Complex64; 2]> {
        let most = self.rock.len() - 1;
        let inside = r < self.cavity.radius && self.cavity.liner.is_some();
        let number = self.numbers[usize::from(inside)];
        let bessel = Bessel::new(most + 1, number * r);
        let of = |n: usize| match inside {
            true => mixed(&bessel, number, r, n, self.liner[n]),
            false => mixed(&bessel, number, r, n, [self.rock[n], I * self.rock[n]]),
        };
        (0..=most).map(of).collect()
    }

    /// w at places.
    pub fn moved(&self, places: &[Place]) -> Vec<Complex64> {
        let of = |&[r, angle]: &Place| {
            let sum = |(n, f): (usize, [Complex64; 2])| f[0] * (n as f64 * angle).cos();
            let scattered: Complex64 = self.orders(r).into_iter().enumerate().map(sum).sum();
            scattered + self.come(r) * Complex64::from_polar(1.0, self.numbers[0] * r * angle.cos())
        };
        places.iter().map(of).collect()
    }

    /// μ ∂w/∂θ/r at places over the incident μ ∂w/∂x at the axis.
    pub fn hoops(&self, places: &[Place]) -> Vec<Complex64> {
        let axis = I * self.numbers[0];
        let of = |&[r, angle]: &Place| {
            let sum = |(n, f): (usize, [Complex64; 2])| -f[0] * n as f64 / r * (n as f64 * angle).sin();
            let scattered: Complex64 = self.orders(r).into_iter().enumerate().map(sum).sum();
            let wave = Complex64::from_polar(1.0, self.numbers[0] * r * angle.cos());
            let stiff = match self.cavity.liner {
                Some((solid, _)) if r < self.cavity.radius => {
                    solid.moduli().mu / self.cavity.rock.moduli().mu
                }
                _ => 1.0,
            };
            (scattered * stiff - self.come(r) * axis * angle.sin() * wave) / axis
        };
        places.iter().map(of).collect()
    }

    /// Whether the incident wave is there beside what is found by orders.
    fn come(&self, r: f64) -> f64 {
        f64::from(u8::from(r >= self.cavity.radius || self.cavity.liner.is_none()))
    }

    /// w at places of a half-round canyon whose surface lies along θ = 0 and π, over that of a wave which comes from below towards an angle
    /// \[rad\] from there, at the middle.
    pub fn canyon(&self, places: &[Place], towards: f64) -> Vec<Complex64> {
        let turned = |by: f64| places.iter().map(|[r, angle]| [*r, angle - by]).collect::<Vec<Place>>();
        let [own, image] = [towards, -towards].map(|by| self.moved(&turned(by)));
        own.iter().zip(image).map(|(a, b)| a + b).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{LINER, ROCK, around, bare};
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn slow_shear_across_doubles_at_the_wall_and_is_sent_round_a_stiff_liner() {
        let slow = 1e-3 * ROCK.speeds().1 / 8.5;
        let found = Across::new(bare(), slow).hoops(&around(8.5));
        for (found, [_, angle]) in found.iter().zip(around(8.5)) {
            assert!((found + 2.0 * angle.sin()).norm() < 5e-3, "{angle}: {found}");
        }
        // A ring in the static field of antiplane shear: w = (A r + B/r) cos θ in it, no traction within, both at the outer face.
        let [inner, outer, m] = [8.0_f64, 8.5, LINER.moduli().mu / ROCK.moduli().mu];
        let q = (inner / outer).powi(2);
        let a = 2.0 / ((1.0 + q) + m * (1.0 - q));
        let lined = Cavity { liner: Some((LINER, inner)), ..bare() };
        for (found, [_, angle]) in Across::new(lined, slow).hoops(&around(inner)).iter().zip(around(inner)) {
            let exact = -2.0 * m * a * angle.sin();
            assert!((found - exact).norm() < 5e-3, "{angle}: {found} {exact}");
        }
    }

    #[test]
    fn a_liner_of_rock_is_rock() {
        let lined = Cavity { liner: Some((ROCK, 8.0)), ..bare() };
        let smaller = Cavity { radius: 8.0, ..bare() };
        for r in [8.0, 8.2, 8.5, 11.0] {
            let both = [lined, smaller].map(|cavity| Across::new(cavity, 300.0).hoops(&around(r)));
            for (a, b) in both[0].iter().zip(&both[1]) {
                assert!((a - b).norm() < 1e-9, "{r}: {a} {b}");
            }
        }
    }

    /// Long waves do not see the canyon; at its wall there is no traction, whatever comes.
    #[test]
    fn a_canyon_hardly_moves_otherwise_than_flat_ground_under_long_waves() {
        let places: Vec<Place> = (0..=12).map(|k| [8.5, PI * f64::from(k) / 12.0]).collect();
        let slow = Across::new(bare(), 1e-3 * ROCK.speeds().1 / 8.5).canyon(&places, 1.0);
        assert!(slow.iter().all(|w| (w - 2.0).norm() < 5e-3), "{slow:?}");
        let fast = Across::new(bare(), 1.5 * ROCK.speeds().1 / 8.5);
        let step = 1e-5;
        let away: Vec<Place> = places.iter().map(|[r, angle]| [r + step, *angle]).collect();
        for (a, b) in fast.canyon(&places, 1.0).iter().zip(fast.canyon(&away, 1.0)) {
            assert!((b - a).norm() / step < 1e-4, "{a} {b}");
        }
    }
}
