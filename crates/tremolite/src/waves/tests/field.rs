//! The field in time: by geometry, by the complex coefficient of the surface, by its own stresses.

use super::super::field::{Frame, ObliqueField};
use super::super::heading::{Heading, WaveType};
use super::super::surface::coefficients;
use super::{EVERY, RISE, SIZE, START, entering, frame, rock, step_up, uniform};
use tremolite_engine::Top;
use tremolite_engine::free_field::GivenField;
use tremolite_motion::{Complex64, Motion, Sample};

/// By geometry alone: when a wave comes to the corners of the box, which way they move first, and how far. Axes are told by east,
/// north and up, so that nothing is shared with the code; x points to 120° from north.
#[test]
fn waves_come_to_corners_in_time_and_move_them_the_right_way_in_full_space() {
    let ground = uniform(Top::Viscous);
    let frame = frame(ground.clone());
    let x_azimuth = f64::to_radians(120.0);
    let (x, y) = ([x_azimuth.sin(), x_azimuth.cos()], [-x_azimuth.cos(), x_azimuth.sin()]);
    for (kind, degrees) in EVERY {
        // All three for one of each type.
        let one =
            [(WaveType::P, 20.0), (WaveType::Sv, 25.0), (WaveType::Sh, 30.0)].contains(&(kind, degrees));
        for azimuth in if one { &[0.0, 30.0, 90.0_f64][..] } else { &[30.0] } {
            let (theta, psi) = (f64::to_radians(degrees), azimuth.to_radians());
            // East, north, up.
            let way = [theta.sin() * psi.sin(), theta.sin() * psi.cos(), theta.cos()];
            let moves = match kind {
                WaveType::P => way,
                WaveType::Sv => [theta.cos() * psi.sin(), theta.cos() * psi.cos(), -theta.sin()],
                WaveType::Sh => [-psi.cos(), psi.sin(), 0.0],
            };
            let model = |v: [f64; 3]| [v[0] * x[0] + v[1] * x[1], v[0] * y[0] + v[1] * y[1], v[2]];
            let (way, moves) = (model(way), model(moves));
            let heading = Heading::new(kind, theta, psi, x_azimuth);
            let speed = kind.speed(&ground.below());
            let field = ObliqueField::new(&frame, &[entering(heading, step_up())]).unwrap();
            for corner in 0..8 {
                let at = [0, 1, 2].map(|i| frame.bounds[corner >> i & 1][i]);
                let from = [frame.at[0], frame.at[1], frame.bounds[0][2]];
                let late: f64 = (0..3).map(|i| (at[i] - from[i]) * way[i]).sum::<f64>() / speed;
                let arrival = field.lead() + START + late;
                assert!(arrival > 0.0, "{kind:?} {degrees} {azimuth}: moves before time 0");
                let peak = |u: [f64; 3]| u.iter().fold(0.0_f64, |most, u| most.max(u.abs()));
                assert!(peak(field.displacement(at, arrival)) < 1e-4, "{kind:?} {degrees} {azimuth}");
                for (part, size) in [(0.25, 0.070_556_640_625), (0.5, 0.5), (1.0, 1.0)] {
                    let found = field.displacement(at, arrival + part * RISE);
                    for i in 0..3 {
                        let exact = size * moves[i];
                        assert!(
                            (found[i] - exact).abs() < 1e-4,
                            "{kind:?} {degrees} {azimuth} {part}: {found:?} {moves:?}"
                        );
                    }
                }
            }
        }
    }
}

/// (a − i(t − t₀))⁻⁴, whose spectrum lies at ω > 0 alone: a wave that is its real part becomes Re(c z) where the transfer is c.
fn one_sided(t: f64) -> Complex64 {
    (Complex64::new(WIDTH, MIDDLE - t) / WIDTH).powi(-4)
}

const WIDTH: f64 = 0.06;
const MIDDLE: f64 = 1.5;

fn real_part() -> Motion {
    Motion::sampled(0.005, 3.0, |t| {
        let over = Complex64::new(WIDTH, MIDDLE - t);
        let z = one_sided(t);
        let i = Complex64::new(0.0, 1.0);
        let (v, a) = (4.0 * i * z / over, -20.0 * z / (over * over));
        Sample { a: [a.re; 3], v: [v.re; 3], u: [z.re; 3] }
    })
    .unwrap()
}

#[test]
fn beyond_the_critical_angle_the_surface_moves_as_the_complex_coefficient_says() {
    let ground = uniform(Top::Free);
    let frame = Frame { frequency: 20.0, duration: Some(3.0), ..frame(ground.clone()) };
    for degrees in [40.0, 55.0] {
        let angle = f64::to_radians(degrees);
        let heading = Heading { kind: WaveType::Sv, angle, along: [0.6, 0.8] };
        let coefficient = coefficients(WaveType::Sv, angle, &ground.below());
        let field = ObliqueField::new(&frame, &[entering(heading, real_part())]).unwrap();
        let p = heading.slowness(&ground.below());
        let q = angle.cos() / ground.below().s;
        let at = [frame.bounds[1][0], frame.bounds[0][1], frame.bounds[1][2]];
        let late = p * (0.6 * (at[0] - frame.at[0]) + 0.8 * (at[1] - frame.at[1])) + q * SIZE[2];
        let exact = |t: f64| {
            let z = one_sided(t);
            [(coefficient[0] * z).re * 0.6, (coefficient[0] * z).re * 0.8, (coefficient[2] * z).re]
        };
        // Where it begins is rest by the series' own choice.
        let rest: [f64; 3] = [0, 1, 2].map(|i| {
            let t = 0.2;
            exact(t)[i] - field.displacement(at, field.lead() + late + t)[i]
        });
        for k in 0..250 {
            let t = 0.4 + 0.01 * f64::from(k);
            let found = field.displacement(at, field.lead() + late + t);
            for i in 0..3 {
                let off = found[i] + rest[i] - exact(t)[i];
                assert!(off.abs() < 2e-3, "{degrees} {t}: {found:?} {:?} {rest:?}", exact(t));
            }
        }
        assert_eq!(field.displacement(at, 0.0), [0.0; 3]);
    }
}

/// Stress is what the law makes of strain, and balances what is accelerated; none at the surface.
#[test]
fn stresses_belong_to_displacements() {
    let rock = rock(2600.0, 2000.0);
    let ground = uniform(Top::Free);
    let frame = frame(ground.clone());
    for (kind, degrees) in
        [(WaveType::P, 50.0), (WaveType::Sv, 25.0), (WaveType::Sv, 55.0), (WaveType::Sh, 60.0)]
    {
        let heading = Heading { kind, angle: f64::to_radians(degrees), along: [0.6, -0.8] };
        let field = ObliqueField::new(&frame, &[entering(heading, step_up())]).unwrap();
        let (mut worst, mut most) = (0.0_f64, 0.0_f64);
        for k in 0..60 {
            let t = field.lead() + START - 0.05 + 0.005 * f64::from(k);
            let at = [33.0, -4.0, -77.3];
            let h = 0.05;
            let mut gradient = [[0.0; 3]; 3];
            for j in 0..3 {
                let moved = |by: f64| {
                    let mut at = at;
                    at[j] += by;
                    field.displacement(at, t)
                };
                let (a, b) = (moved(h), moved(-h));
                (0..3).for_each(|i| gradient[i][j] = (a[i] - b[i]) / (2.0 * h));
            }
            let shear = rock.density * rock.s * rock.s;
            let lame = rock.density * rock.p * rock.p - 2.0 * shear;
            let volume: f64 = (0..3).map(|i| gradient[i][i]).sum();
            let found = field.stress(at, t);
            for (found, (i, j)) in found.into_iter().zip([(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)]) {
                let exact =
                    if i == j { lame * volume } else { 0.0 } + shear * (gradient[i][j] + gradient[j][i]);
                worst = worst.max((found - exact).abs());
                most = most.max(exact.abs());
            }
            let surface = field.stress([at[0], at[1], frame.bounds[1][2]], t);
            assert!(surface[2].abs().max(surface[4].abs()).max(surface[5].abs()) < 1e-6 * most.max(1e6));
        }
        // What cubics leave of slopes, and round-off of displacements of four bytes over 0.1 m.
        assert!(worst < 2e-3 * most, "{kind:?} {degrees}: {worst:e} of {most:e}");
    }
}
