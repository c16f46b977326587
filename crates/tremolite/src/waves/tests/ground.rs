//! The ground's answer at one frequency, against closed forms and the equations of motion.

use super::super::ground::LayeredGround;
use super::super::heading::{Heading, WaveType};
use super::super::modes;
use super::super::rock::{Rock, Stratum};
use super::super::surface::coefficients;
use super::{EVERY, layered, rock, uniform};
use crate::layered_column::{Layer, LayeredColumn};
use std::f64::consts::{PI, TAU};
use tremolite_engine::Top;
use tremolite_motion::Complex64;

/// Displacement along h, t and up at the top of the ground over the incident wave's at the base.
fn at_top(ground: &LayeredGround, kind: WaveType, angle: f64, s: Complex64) -> [Complex64; 3] {
    let heading = Heading { kind, angle, along: [1.0, 0.0] };
    let p = heading.slowness(&ground.below());
    let (layer, above) = ground.stratum_at(ground.height());
    let [zero, one] = [0.0, 1.0].map(Complex64::from);
    match kind {
        WaveType::Sh => [zero, ground.sh(s, p).at(layer, above).value[0], zero],
        WaveType::P => {
            let [along, up, ..] = ground.p_sv(s, p, [one, zero]).at(layer, above).value;
            [along, zero, up]
        }
        WaveType::Sv => {
            let [along, up, ..] = ground.p_sv(s, p, [zero, one]).at(layer, above).value;
            [along, zero, up]
        }
    }
}

#[test]
fn bare_rock_moves_as_the_closed_forms_say_up_to_and_beyond_the_critical_angle() {
    let ground = uniform(Top::Free);
    for (kind, degrees) in EVERY {
        let (angle, s) = (f64::to_radians(degrees), Complex64::new(0.0, TAU * 7.0));
        let exact = coefficients(kind, angle, &ground.below());
        let q = angle.cos() / kind.speed(&ground.below());
        let late = (-s * q * ground.height()).exp();
        for (found, exact) in at_top(&ground, kind, angle, s).into_iter().zip(exact) {
            assert!((found - exact * late).norm() < 1e-12, "{kind:?} {degrees}: {found} {exact}");
        }
        let beyond = kind == WaveType::Sv && angle.sin() > 3.5_f64.sqrt().recip();
        assert_eq!(exact[0].im.abs() > 1e-3, beyond, "{kind:?} {degrees}");
    }
    // Straight up the surface doubles; SV at 45° moves along it alone, 1/sin 45° times (`aki2002`).
    assert!((coefficients(WaveType::P, 0.0, &ground.below())[2] - 2.0).norm() < 1e-14);
    let [along, _, up] = coefficients(WaveType::Sv, PI / 4.0, &ground.below());
    assert!(
        (along - 2.0_f64.sqrt()).norm() < 1e-12 && up.norm() > 0.0 || along.norm() < 1e-12,
        "{along} {up}"
    );
}

/// d(u_h, u_z, σ_hz, σ_zz)/dz, or of (u_t, σ_tz): the equations of motion and the law, without waves.
fn rates(rock: &Rock, p: f64, s: Complex64) -> [[Complex64; 4]; 4] {
    let seen = rock.at(s);
    let (lame, stiff, z) = (seen.lame(), seen.pressure, Complex64::default());
    let sp = s * p;
    let mut a = [[z; 4]; 4];
    a[0][1] = sp;
    a[0][2] = 1.0 / seen.shear;
    a[1][0] = lame * sp / stiff;
    a[1][3] = 1.0 / stiff;
    // σ_hh = −(λ + 2G) sp u_h + λ u_z′
    a[2][0] = seen.inertia * s * s + sp * (-stiff * sp + lame * a[1][0]);
    a[2][3] = sp * lame * a[1][3];
    a[3][1] = seen.inertia * s * s;
    a[3][2] = sp;
    a
}

/// `state` carried through a thickness by Runge and Kutta, a way that knows nothing of modes.
fn carried(a: &[[Complex64; 4]; 4], mut state: [Complex64; 4], thickness: f64) -> [Complex64; 4] {
    let steps = 2_000;
    let h = thickness / f64::from(steps);
    let rate = |x: &[Complex64; 4]| [0, 1, 2, 3].map(|i| (0..4).map(|j| a[i][j] * x[j]).sum::<Complex64>());
    let to = |x: &[Complex64; 4], k: &[Complex64; 4], h: f64| [0, 1, 2, 3].map(|i| x[i] + k[i] * h);
    for _ in 0..steps {
        let k1 = rate(&state);
        let k2 = rate(&to(&state, &k1, h / 2.0));
        let k3 = rate(&to(&state, &k2, h / 2.0));
        let k4 = rate(&to(&state, &k3, h));
        state = [0, 1, 2, 3].map(|i| state[i] + (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]) * (h / 6.0));
    }
    state
}

/// What stands at the base is carried up by the equations of motion themselves: it must be what the modes have there, at each
/// interface and at a surface without traction; and at the base it must be the incident wave and waves that go down.
#[test]
fn layers_obey_the_equations_of_motion() {
    let ground = LayeredGround::new(layered(), Top::Free).unwrap();
    for (kind, degrees) in EVERY.into_iter().filter(|(kind, _)| *kind != WaveType::Sh) {
        for hertz in [0.7, 9.0] {
            let s = Complex64::new(0.3, TAU * hertz);
            let heading = Heading { kind, angle: f64::to_radians(degrees), along: [1.0, 0.0] };
            let p = heading.slowness(&ground.below());
            let incident =
                [WaveType::P, WaveType::Sv].map(|k| Complex64::from(if k == kind { 1.0 } else { 0.0 }));
            let waves = ground.p_sv(s, p, incident);
            let state = |layer: usize, above: f64| {
                let [uh, uz, _, _, zz, hz] = waves.at(layer, above).value;
                [uh, uz, hz, zz]
            };
            let mut carried_up = state(0, 0.0);
            let scale = [1.0, 1.0, 2e8 * hertz, 2e8 * hertz];
            let near = |a: &[Complex64; 4], b: &[Complex64; 4]| {
                (0..4).map(|i| (a[i] - b[i]).norm() / scale[i]).fold(0.0, f64::max)
            };
            for (k, stratum) in ground.strata().iter().enumerate() {
                assert!(near(&carried_up, &state(k, 0.0)) < 1e-9, "{kind:?} {degrees} {hertz} {k}");
                carried_up = carried(&rates(&stratum.rock, p, s), carried_up, stratum.thickness);
            }
            let zero = Complex64::default();
            let surface = [carried_up[0], carried_up[1], zero, zero];
            assert!(near(&carried_up, &surface) < 1e-9, "{kind:?} {degrees} {hertz}: {carried_up:?}");
            // The half-space: its modes solve the equations, and the incident one is as asked.
            let below = ground.below();
            let modes = modes::p_sv(&below.at(s), [below.p, below.s], p, s);
            let mut rows = [[zero; 4]; 4];
            let mut right = state(0, 0.0).map(|x| [x]);
            for i in 0..2 {
                for j in 0..2 {
                    for d in 0..2 {
                        rows[i][2 * d + j] = modes.moved[d][i][j];
                        rows[2 + i][2 * d + j] = -s * modes.pulled[d][i][j];
                    }
                }
            }
            modes::solve(&mut rows, &mut right);
            for j in 0..2 {
                assert!((right[j][0] - incident[j]).norm() < 1e-9, "{kind:?} {degrees}: {right:?}");
            }
        }
    }
}

#[test]
fn straight_up_it_is_the_layered_column() {
    for top in [Top::Free, Top::Viscous] {
        let ground = LayeredGround::new(layered(), top).unwrap();
        for (kind, axis) in [(WaveType::P, 2), (WaveType::Sv, 0), (WaveType::Sh, 1)] {
            let layers = layered().into_iter().map(|Stratum { thickness, rock }| Layer {
                thickness,
                density: rock.density,
                speed: if axis == 2 { rock.p } else { rock.s },
                band: rock.band,
                rayleigh: rock.rayleigh,
                damping: 0.0,
                water: None,
            });
            let column = LayeredColumn::new(layers, top).unwrap();
            for hertz in [0.5, 3.0, 15.0] {
                let s = Complex64::new(0.2, TAU * hertz);
                let exact = column.factor_at(s, column.height());
                let found = at_top(&ground, kind, 0.0, s);
                let part = if axis == 2 { found[2] } else { found[axis] };
                assert!((part - exact).norm() < 1e-11 * exact.norm(), "{kind:?} {hertz}: {part} {exact}");
            }
        }
    }
}

/// One layer on a half-space under SH: 1/(cos kh + i (G₁q₁/G₀q₀) sin kh), `kramer1996` for vertical waves.
#[test]
fn one_layer_under_sh_is_the_closed_form() {
    let (base, soft) = (rock(2600.0, 2000.0), rock(2000.0, 500.0));
    let thickness = [1e-9, 30.0];
    let strata =
        [Stratum { thickness: thickness[0], rock: base }, Stratum { thickness: thickness[1], rock: soft }];
    let ground = LayeredGround::new(strata, Top::Free).unwrap();
    for degrees in [10.0, 30.0, 60.0, 89.0] {
        for hertz in [0.5, 4.0, 11.0] {
            let angle = f64::to_radians(degrees);
            let (p, omega) = (angle.sin() / base.s, TAU * hertz);
            let q = |rock: &Rock| (rock.s.powi(-2) - p * p).sqrt();
            let z = |rock: &Rock| rock.density * rock.s * rock.s * q(rock);
            let way = omega * q(&soft) * thickness[1];
            let exact = 2.0 / Complex64::new(way.cos(), z(&soft) / z(&base) * way.sin());
            let found = at_top(&ground, WaveType::Sh, angle, Complex64::new(0.0, omega))[1];
            assert!((found - exact).norm() < 1e-7, "{degrees} {hertz}: {found} {exact}");
        }
    }
}
