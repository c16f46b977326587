use super::field::{Entering, Frame, ObliqueField};
use super::ground::LayeredGround;
use super::heading::{Heading, WaveType};
use super::rock::{Rock, Stratum};
use super::surface::coefficients;
use crate::layered_column::{Layer, LayeredColumn};
use std::f64::consts::{PI, TAU};
use std::sync::Arc;
use tremolite_engine::Top;
use tremolite_engine::free_field::{End, GivenField, Place};
use tremolite_engine::problem::Rayleigh;
use tremolite_laws::band::Band;
use tremolite_motion::{Complex64, Motion, Sample};

/// ν = 0.3: at 0.25 several angles are special.
fn rock(density: f64, s: f64) -> Rock {
    Rock { density, s, p: s * 3.5_f64.sqrt(), band: None, rayleigh: Rayleigh::default(), water: None }
}

fn stratum(thickness: f64, density: f64, s: f64) -> Stratum {
    Stratum { thickness, rock: rock(density, s) }
}

fn uniform(top: Top) -> LayeredGround {
    LayeredGround::new([stratum(60.0, 2600.0, 2000.0)], top).unwrap()
}

/// Three layers with all kinds of damping.
fn layered() -> Vec<Stratum> {
    let rayleigh = Rayleigh { mass: 0.4, stiffness: 2e-4 };
    let band = Band::fit(0.02, [0.5, 20.0], 3.0).ok();
    let damped = |mut stratum: Stratum, band| {
        stratum.rock = Rock { rayleigh, band, ..stratum.rock };
        stratum
    };
    vec![
        damped(stratum(40.0, 2700.0, 2400.0), band),
        damped(stratum(25.0, 2500.0, 1500.0), None),
        damped(stratum(12.0, 2100.0, 600.0), band),
    ]
}

const EVERY: [(WaveType, f64); 10] = [
    (WaveType::P, 0.0),
    (WaveType::P, 20.0),
    (WaveType::P, 50.0),
    (WaveType::Sv, 0.0),
    (WaveType::Sv, 15.0),
    (WaveType::Sv, 25.0),
    (WaveType::Sv, 40.0),
    (WaveType::Sv, 55.0),
    (WaveType::Sh, 30.0),
    (WaveType::Sh, 60.0),
];

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
            let modes = super::modes::p_sv(&below.at(s), [below.p, below.s], p, s);
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
            super::modes::solve(&mut rows, &mut right);
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

const START: f64 = 0.3;
const RISE: f64 = 0.2;

/// u rises from 0 to 1 m over [`RISE`], once it has [started](START).
fn step_up() -> Motion {
    Motion::sampled(0.002, 2.0, |t| {
        let x = ((t - START) / RISE).clamp(0.0, 1.0);
        let u = x.powi(4) * (35.0 - 84.0 * x + 70.0 * x * x - 20.0 * x * x * x);
        let v = 140.0 * (x * (1.0 - x)).powi(3) / RISE;
        let a = 420.0 * (x * (1.0 - x)).powi(2) * (1.0 - 2.0 * x) / (RISE * RISE);
        Sample { a: [a; 3], v: [v; 3], u: [u; 3] }
    })
    .unwrap()
}

const SIZE: [f64; 3] = [80.0, 50.0, 60.0];

fn frame(ground: LayeredGround) -> Frame {
    let low = [10.0, -20.0, -100.0];
    let high = [0, 1, 2].map(|i| low[i] + SIZE[i]);
    Frame {
        ground,
        bounds: [low, high],
        at: [0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])],
        frequency: 25.0,
        duration: Some(2.0),
    }
}

fn entering(heading: Heading, motion: Motion) -> Entering {
    Entering::of(heading, Arc::new(motion), 0, Complex64::from(1.0))
}

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

/// Nodes of a side across x in rows, with the points of faces between them, one at an edge, and points at heights of their own.
fn places() -> Vec<Place> {
    let mut places = Vec::new();
    for (j, k) in (0..4).flat_map(|j| (0..5).map(move |k| (j, k))) {
        let at = [60.0, 9.0 * f64::from(j), 11.0 * f64::from(k)];
        let near = [-0.4, 0.3].into_iter().flat_map(|y| [-0.6, 0.2, 0.9].map(|z| (y, z)));
        let shares = near
            .map(|(y, z)| {
                ([at[0], at[1] + 9.0 * y, (at[2] + 11.0 * z).max(0.0)], [(1.0 + y) * (2.0 - z), 0.0, 0.0])
            })
            .collect();
        places.push(Place { at, shares, ..Place::default() });
    }
    let end = End {
        at: [60.0, 4.0, 50.0],
        normal: [1.0, 0.0, 0.0],
        along: [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        lacking: [0.4, 0.1],
        beside: [0.7, -0.2],
    };
    places[7].ends.push(end);
    for k in 0..6 {
        let at = [7.0 * f64::from(k), 3.1 * f64::from(k), 2.7 * f64::from(k)];
        places.push(Place { at, shares: vec![(at, [0.3, -0.2, 0.5])], ..Place::default() });
    }
    places
}

/// What is kept for the places of a model is what is found anywhere else, to round-off of four bytes, and what pushes them is the sum over
/// their points, whether all sums are kept or few.
#[test]
fn prepared_places_answer_as_all_others_do() {
    let ground = LayeredGround::new(layered(), Top::Free).unwrap();
    let frame = Frame {
        bounds: [[0.0; 3], [60.0, 40.0, ground.height()]],
        at: [30.0, 20.0],
        ..frame(ground.clone())
    };
    let wave = |kind, degrees: f64| {
        let heading = Heading { kind, angle: degrees.to_radians(), along: [0.6, 0.8] };
        entering(heading, step_up())
    };
    let waves = [wave(WaveType::Sv, 25.0), wave(WaveType::Sh, 60.0)];
    let [plain, ready] = [0, 1].map(|_| ObliqueField::new(&frame, &waves).unwrap());
    let places = places();
    let places: Vec<&Place> = places.iter().collect();
    assert!(plain.pushes(&places).is_none());
    ready.prepare(&places);
    assert!(ready.bytes() > plain.bytes());
    let pushes = [ready.pushes(&places).unwrap(), ready.with_sums_of(5, &places)];
    let mut of = Largest::default();
    let mut of_forces = Largest::default();
    for k in 0..40 {
        let t = plain.lead() + START - 0.02 + 0.0071 * f64::from(k);
        let at = places.iter().map(|place| place.at).chain([[13.0, 29.0, 3.7], [13.0, 29.0, 70.3]]);
        for at in at {
            of.compare(&plain.displacement(at, t), &ready.displacement(at, t));
            let dt = 0.003 + 0.001 * f64::from(k);
            let mut v = [[0.0; 3]];
            ready.velocities(&[ready.spot(at)], t, dt, &mut v);
            let moved = v[0].map(|v| 2.0 * dt * v);
            let [before, after] = [t - dt, t + dt].map(|t| plain.displacement(at, t));
            of.compare(&[0, 1, 2].map(|i| after[i] - before[i]), &moved);
        }
        for pushes in &pushes {
            let mut found = vec![[0.0; 3]; places.len()];
            pushes.forces(t, &mut found);
            for (place, found) in places.iter().zip(found) {
                let mut sum = [0.0; 3];
                let shares = place.shares.iter().map(|&(at, area)| {
                    let [xx, yy, zz, xy, yz, zx] = plain.stress(at, t);
                    let [x, y, z] = area;
                    [xx * x + xy * y + zx * z, xy * x + yy * y + yz * z, zx * x + yz * y + zz * z]
                });
                let ends = place.ends.iter().map(|end| end.force(&plain.stress(end.at, t)));
                shares.chain(ends).for_each(|force| (0..3).for_each(|i| sum[i] += force[i]));
                of_forces.compare(&sum, &found);
            }
        }
    }
    for Largest { off, most } in [of, of_forces] {
        assert!(most > 0.0 && off < 1e-6 * most, "{off:e} of {most:e}");
    }
    // Nodes in rows ask for few series: of 4 × 5 nodes with two delays each those of a row are one, and the one with an end has its own.
    assert!(ready.sums() < 2 * (5 + 1 + 2 + 6 + 4), "{}", ready.sums());
}

/// The largest of some numbers, and of what others differ from them by.
#[derive(Default)]
struct Largest {
    off: f64,
    most: f64,
}

impl Largest {
    fn compare(&mut self, right: &[f64; 3], found: &[f64; 3]) {
        for (a, b) in right.iter().zip(found) {
            self.most = self.most.max(a.abs());
            self.off = self.off.max((a - b).abs());
        }
    }
}
