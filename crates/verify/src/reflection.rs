//! How much of a plane wave an absorbing boundary sends back, against the angle at which it comes.
//!
//! A wave of frequency ω meets the plane boundary of homogeneous ground that is pushed, per area, by −c v − k u, with a
//! dashpot c and a spring k along the normal and along the boundary (`lysmer1969` for dashpots ρc_p and ρc_s alone). One P
//! and one SV wave run back with the slowness p along the boundary of the wave that comes in, and their two amplitudes
//! follow from the two tractions there. Beyond asin(c_s/c_p) an SV wave that comes in is sent back as SV alone; its P
//! clings to the boundary and carries no energy away.
//!
//! SH is not here: a dashpot ρc_s sends back (1 − cos θ)/(1 + cos θ) of its amplitude.

use crate::VerifyError;
use crate::simulation::Simulation;
use tremolite::{Base, Quadrature, Side};
use tremolite_mesh::boxes::BoxSpec;
use tremolite_motion::Complex64;

pub use crate::models::Solid;

/// What pushes the ground at its boundary, per area, along the normal and along the boundary.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Boundary {
    /// Pa s/m
    pub dashpots: [f64; 2],
    /// Pa/m
    pub springs: [f64; 2],
}

/// The wave that comes in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wave {
    P,
    Sv,
}

/// Homogeneous ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Medium {
    /// c_p and c_s \[m/s\].
    pub speeds: (f64, f64),
    /// kg/m³
    pub density: f64,
}

/// What runs back of a wave with a displacement of amplitude 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reflection {
    /// Amplitude of the displacement in the P wave; of one that clings to the boundary, in the unit of (p, −q_p) c_p, whose
    /// length is then more than 1.
    pub p: Complex64,
    /// In the SV wave.
    pub sv: Complex64,
    /// Energy that runs back over energy that comes in, each through an area of the boundary in a period.
    pub energy: f64,
    /// Power that the boundary takes over power that comes in, from forces and velocities on it.
    pub absorbed: f64,
}

impl Medium {
    pub fn of(solid: Solid) -> Self {
        Medium { speeds: solid.speeds(), density: solid.density }
    }

    /// The angle \[rad\] of an SV wave beyond which no P wave runs back.
    pub fn critical(&self) -> f64 {
        (self.speeds.1 / self.speeds.0).asin()
    }

    /// Slowness \[s/m\] along the normal of a wave of speed `c` and slowness `p` along the boundary. Where no wave has
    /// that slowness, it is the root of what fades into the ground.
    fn across(c: f64, p: f64) -> Complex64 {
        let square = (1.0 / c - p) * (1.0 / c + p);
        match square < 0.0 {
            true => Complex64::new(0.0, -(-square).sqrt()),
            false => Complex64::new(square.sqrt(), 0.0),
        }
    }

    /// What `boundary` sends back of a wave of `frequency` ω \[rad/s\] that comes at `angle` \[rad\] from the normal, below a
    /// right angle.
    pub fn reflection(&self, boundary: &Boundary, wave: Wave, angle: f64, frequency: f64) -> Reflection {
        let (c_p, c_s) = self.speeds;
        let (rho, mu) = (self.density, self.density * c_s * c_s);
        let lambda = rho * c_p * c_p - 2.0 * mu;
        let c = match wave {
            Wave::P => c_p,
            Wave::Sv => c_s,
        };
        // Slownesses along the boundary and, of P and of SV, along the normal. That of the wave that comes in is taken from
        // its cosine: near 90° a root would be round-off.
        let (slowness, own) = (angle.sin() / c, Complex64::from(angle.cos() / c));
        let p = Complex64::from(slowness);
        let (q_p, q_s) = match wave {
            Wave::P => (own, Medium::across(c_s, slowness)),
            Wave::Sv => (Medium::across(c_p, slowness), own),
        };
        // Displacements along the boundary and along the outward normal, and the slowness along the normal.
        let down_p = ([p * c_p, -q_p * c_p], -q_p);
        let down_s = ([q_s * c_s, p * c_s], -q_s);
        let up = match wave {
            Wave::P => ([p * c_p, q_p * c_p], q_p),
            Wave::Sv => ([q_s * c_s, -p * c_s], q_s),
        };
        // σ·n + c v + k u of e^{iω(t − px − qz)}, over −iω; zero for the three waves together.
        let push = [1, 0].map(|k| Complex64::new(boundary.dashpots[k], -boundary.springs[k] / frequency));
        let residual = |([x, z], q): ([Complex64; 2], Complex64)| {
            let along = (p * z + q * x) * mu;
            let normal = (p * x + q * z) * lambda + q * z * (2.0 * mu);
            [along - push[0] * x, normal - push[1] * z]
        };
        let ([a, c1], [b, d], [e, f]) = (residual(down_p), residual(down_s), residual(up));
        let determinant = a * d - b * c1;
        let (from_p, from_s) = ((b * f - d * e) / determinant, (c1 * e - a * f) / determinant);

        // Power through an area over ½ρω²: |A|² c² Re q.
        let flux = |amplitude: Complex64, c: f64, q: Complex64| amplitude.norm_sqr() * c * c * q.re;
        let coming = c * angle.cos();
        let energy = (flux(from_p, c_p, q_p) + flux(from_s, c_s, q_s)) / coming;
        let moved = [0, 1].map(|k| up.0[k] + from_p * down_p.0[k] + from_s * down_s.0[k]);
        let taken =
            (boundary.dashpots[1] * moved[0].norm_sqr() + boundary.dashpots[0] * moved[1].norm_sqr()) / rho;
        Reflection { p: from_p, sv: from_s, energy, absorbed: taken / coming }
    }
}

/// A brick of one element, with a side of 2 m, in which the base or the sides normal to x absorb.
fn brick(solid: Solid, base: Base, side: Side) -> Result<Simulation, VerifyError> {
    let mesh = BoxSpec::uniform([0.0; 3], [2.0; 3], [1; 3]).mesh()?;
    let mut problem = solid.fill(mesh, Quadrature::OnePoint);
    (problem.base, problem.sides) = (base, [side, Side::Free]);
    Simulation::new(problem)
}

/// What the engine puts on an area of a base, from its own matrices.
///
/// # Errors
/// If the engine refuses the brick that it is asked with.
pub fn of_base(solid: Solid, base: Base) -> Result<Boundary, VerifyError> {
    let Simulation { model, assembly, .. } = brick(solid, base, Side::Free)?;
    let mut boundary = Boundary { dashpots: [0.0; 2], springs: [0.0; 2] };
    for node in assembly.base.iter().filter(|node| model.nodes.counts(node.node as usize)) {
        for (k, component) in [2, 0].into_iter().enumerate() {
            boundary.dashpots[k] += node.dashpot[component] / 4.0;
            boundary.springs[k] += node.spring[component] / 4.0;
        }
    }
    Ok(boundary)
}

/// What the engine puts on an area of viscous sides, from its own matrices.
///
/// # Errors
/// As [`of_base`].
pub fn of_viscous_side(solid: Solid) -> Result<Boundary, VerifyError> {
    let mut dashpots = [0.0; 2];
    for (_, dashpot) in &brick(solid, Base::Free, Side::Viscous)?.phase.dashpots {
        for (k, component) in [0, 1].into_iter().enumerate() {
            // Of two sides of 4 m².
            dashpots[k] += dashpot.sides[component] / 8.0;
        }
    }
    Ok(Boundary { dashpots, springs: [0.0; 2] })
}

#[cfg(test)]
mod tests {
    use super::*;

    const WAVES: [Wave; 2] = [Wave::P, Wave::Sv];
    const NONE: Boundary = Boundary { dashpots: [0.0; 2], springs: [0.0; 2] };

    fn solid(poisson: f64) -> Solid {
        Solid::from_shear_speed(1200.0, poisson, 2700.0)
    }

    /// Degrees from the normal, short of the grazing wave itself.
    fn angles() -> impl Iterator<Item = f64> {
        (0..180).map(|half| (0.5 * f64::from(half)).to_radians())
    }

    fn springs(distance: f64) -> Base {
        Base::ViscousSpring { normal: 1.33, tangential: 0.67, distance: Some(distance) }
    }

    #[test]
    fn the_engines_base_and_sides_have_the_coefficients_of_the_theory() {
        for poisson in [0.0, 0.25, 0.4] {
            let solid = solid(poisson);
            let (p, s) = solid.speeds();
            let dashpots = [solid.density * p, solid.density * s];
            let base = of_base(solid, springs(80.0)).unwrap();
            let side = of_viscous_side(solid).unwrap();
            let g = solid.moduli().mu / 80.0;
            let near = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-12;
            for k in 0..2 {
                assert!(near(base.dashpots[k], dashpots[k]) && near(side.dashpots[k], dashpots[k]));
                assert!(near(base.springs[k], [1.33, 0.67][k] * g), "{base:?}");
            }
            assert_eq!(of_base(solid, Base::Viscous).unwrap().springs, [0.0; 2]);
        }
    }

    #[test]
    fn dashpots_send_nothing_back_of_a_wave_along_the_normal() {
        for (wave, poisson) in WAVES.into_iter().flat_map(|w| [(w, 0.0), (w, 0.25), (w, 0.4)]) {
            let boundary = of_viscous_side(solid(poisson)).unwrap();
            let back = Medium::of(solid(poisson)).reflection(&boundary, wave, 0.0, 10.0);
            assert!(back.p.norm() < 1e-14 && back.sv.norm() < 1e-14 && back.energy < 1e-28, "{back:?}");
        }
    }

    /// The power taken is summed from forces and velocities, the energy from amplitudes. One frequency stands for all: springs
    /// count by αG/(ωR).
    #[test]
    fn what_does_not_run_back_is_what_the_dashpots_take() {
        for poisson in [0.1, 0.25, 0.4] {
            let ground = Medium::of(solid(poisson));
            for base in [Base::Viscous, springs(100.0)] {
                let boundary = of_base(solid(poisson), base).unwrap();
                for (wave, angle) in WAVES.into_iter().flat_map(|w| angles().map(move |a| (w, a))) {
                    let back = ground.reflection(&boundary, wave, angle, 12.0);
                    let sum = back.energy + back.absorbed;
                    assert!((sum - 1.0).abs() < 1e-11, "{wave:?} at {angle}: {sum}");
                    assert!(back.absorbed >= 0.0);
                }
            }
        }
    }

    #[test]
    fn a_grazing_wave_is_sent_back_whole() {
        for (wave, poisson) in WAVES.into_iter().flat_map(|w| [(w, 0.25), (w, 0.4)]) {
            let ground = Medium::of(solid(poisson));
            let boundary = of_viscous_side(solid(poisson)).unwrap();
            let lost = [1e-3, 1e-4].map(|short| {
                let angle = std::f64::consts::FRAC_PI_2 - short;
                let back = ground.reflection(&boundary, wave, angle, 10.0);
                let own = if wave == Wave::P { back.p } else { back.sv };
                assert!((own.norm() - 1.0).abs() < 20.0 * short, "{own}");
                1.0 - back.energy
            });
            // Absorbed with the cosine of the angle.
            assert!((lost[0] / lost[1] / 10.0 - 1.0).abs() < 0.05, "{lost:?}");
        }
    }

    /// The free surface, whose coefficients stand in any book (`graff1975`, chapter 6).
    #[test]
    fn without_dashpots_the_coefficients_are_those_of_a_free_surface() {
        let ground = Medium::of(solid(0.25));
        let (c_p, c_s) = ground.speeds;
        let ratio = c_p / c_s;
        for degrees in [5.0, 20.0, 34.0, 35.0, 50.0, 75.0] {
            let p = f64::to_radians(degrees);
            let s = (p.sin() / ratio).asin();
            let (a, b) = ((2.0 * p).sin() * (2.0 * s).sin(), (ratio * (2.0 * s).cos()).powi(2));
            let back = ground.reflection(&NONE, Wave::P, p, 10.0);
            assert!((back.p - (a - b) / (a + b)).norm() < 1e-12, "{degrees}: {}", back.p);
            let turned = 2.0 * ratio * (2.0 * p).sin() * (2.0 * s).cos() / (a + b);
            assert!((back.sv.norm() - turned).abs() < 1e-12, "{degrees}: {} {turned}", back.sv);
            // An SV wave at the angle of that one sends as much back of itself, the other way round.
            let other = ground.reflection(&NONE, Wave::Sv, s, 10.0);
            assert!((other.sv - (b - a) / (a + b)).norm() < 1e-12, "{degrees}: {}", other.sv);
            assert!((back.energy - 1.0).abs() < 1e-12 && (other.energy - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn beyond_the_critical_angle_sv_alone_carries_energy_back() {
        let ground = Medium::of(solid(0.25));
        let boundary = of_viscous_side(solid(0.25)).unwrap();
        for over in [0.01, 0.2, 0.5] {
            let back = ground.reflection(&boundary, Wave::Sv, ground.critical() + over, 10.0);
            assert!((back.energy - back.sv.norm_sqr()).abs() < 1e-14);
            assert!(back.p.norm() > 0.0 && back.sv.im != 0.0);
            let below = ground.reflection(&boundary, Wave::Sv, ground.critical() - over, 10.0);
            assert!(below.energy > below.sv.norm_sqr() && below.sv.im == 0.0);
        }
    }

    #[test]
    fn springs_hold_slow_waves_and_fast_ones_do_not_feel_them() {
        let (ground, boundary) = (Medium::of(solid(0.25)), of_base(solid(0.25), springs(100.0)).unwrap());
        let bare = of_viscous_side(solid(0.25)).unwrap();
        for (wave, angle) in WAVES.into_iter().flat_map(|w| [(w, 0.0), (w, 0.3), (w, 0.9)]) {
            let energy = |omega: f64| ground.reflection(&boundary, wave, angle, omega).energy;
            assert!(energy(1e-6) > 0.999, "{}", energy(1e-6));
            let dashpots = ground.reflection(&bare, wave, angle, 1.0).energy;
            assert!((energy(1e9) - dashpots).abs() < 1e-6);
        }
        // Along the normal a spring k beside ρc sends back k²/(k² + 4ω²ρ²c²) of the energy.
        for (k, wave) in WAVES.into_iter().enumerate() {
            let (spring, twice) = (boundary.springs[k], 2.0 * 12.0 * boundary.dashpots[k]);
            let exact = spring * spring / (spring * spring + twice * twice);
            assert!((ground.reflection(&boundary, wave, 0.0, 12.0).energy - exact).abs() < 1e-12);
        }
    }
}
