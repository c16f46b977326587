//! The column against closed forms, and against figures worked out elsewhere.

use super::*;
use std::f64::consts::TAU;

const NONE: Rayleigh = Rayleigh { mass: 0.0, stiffness: 0.0 };

/// Soil, which a case may put on rock.
const SOIL: Layer = Layer {
    thickness: 200.0,
    density: 2752.3,
    speed: 1000.0,
    band: None,
    rayleigh: NONE,
    damping: 0.0,
    water: None,
};
const ROCK: Layer = Layer { thickness: 100.0, speed: 2300.0, ..SOIL };
const HOMOGENEOUS: Layer = Layer { thickness: 240.0, speed: 1200.0, ..SOIL };

fn column(layers: &[Layer], top: Top) -> LayeredColumn {
    LayeredColumn::new(layers.iter().copied(), top).unwrap()
}

fn at_frequency(hertz: f64) -> Complex64 {
    Complex64::new(0.0, TAU * hertz)
}

/// A pulse of about 2 Hz around 1 s.
fn pulse(t: f64) -> f64 {
    let s = TAU * (t - 1.0);
    (1.0 - 2.0 * s * s) * (-s * s).exp()
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0_f64, |most, v| most.max(v.abs()))
}

/// Largest difference of samples every `dt` from a function of time.
fn difference(found: &[f64], dt: f64, exact: impl Fn(f64) -> f64) -> f64 {
    found.iter().enumerate().map(|(k, v)| (v - exact(k as f64 * dt)).abs()).fold(0.0, f64::max)
}

#[test]
fn without_damping_the_wave_arrives_doubled_and_late() {
    let [top, base] = column(&[HOMOGENEOUS], Top::Free).velocities(pulse, 1e-3, 3.0);
    assert!(top.len() > 3000 && difference(&top, 1e-3, |t| 2.0 * pulse(t - 0.2)) < 1e-8);
    assert!(difference(&base, 1e-3, |t| pulse(t) + pulse(t - 0.4)) < 1e-8);
}

#[test]
fn a_homogeneous_column_has_its_closed_form_with_every_damping() {
    let band = Some(Band::fit(0.03, [0.5, 20.0], 3.0).unwrap());
    let rayleigh = Rayleigh { mass: 0.5, stiffness: 1e-3 };
    for layer in [
        Layer { band, ..HOMOGENEOUS },
        Layer { rayleigh, ..HOMOGENEOUS },
        Layer { band, rayleigh, ..HOMOGENEOUS },
    ] {
        for hertz in [0.01, 0.7, 1.25, 6.0, 25.0] {
            // k = (ω/c) √((1 − iω_R/ω)/M); the balance at the base, 2v_i − v = M (c/iω) ∂v/∂z, gives
            // 2/(cos kH + i M (ck/ω) sin kH) at the top.
            let (i, omega) = (Complex64::i(), TAU * hertz);
            let elastic = layer.band.map_or(Complex64::from(1.0), |band| {
                band.stiffness(hertz) * Complex64::new(1.0, 2.0 * band.ratio(hertz))
            });
            let unrelaxed = layer.band.map_or(1.0, |band| band.unrelaxed());
            let modulus = elastic + i * omega * layer.rayleigh.stiffness * unrelaxed;
            let slowness = ((1.0 - i * layer.rayleigh.mass / omega) / modulus).sqrt();
            let angle = slowness * (omega * layer.thickness / layer.speed);
            let exact = 2.0 / (angle.cos() + i * modulus * slowness * angle.sin());
            let found = column(&[layer], Top::Free).factors(at_frequency(hertz));
            assert!((found[1] - exact).norm() < 1e-12 * exact.norm(), "{hertz} Hz: {} {exact}", found[1]);
            assert!(
                (found[0] - exact * angle.cos()).norm() < 1e-12 * found[0].norm().max(1.0),
                "{hertz} Hz at the base"
            );
        }
    }
}

/// Figures of a layer with α_M = π/20 /s and β_K = 1/(200π) s on undamped rock, from an independent computation with
/// G* = G (1 + iωβ_K)/(1 − iα_M/ω) in `kramer1996` (7.28): frequency, surface over outcrop, surface over the layer's base.
const RAYLEIGH_LAYER: [(f64, [f64; 2], [f64; 2]); 5] = [
    (0.1, [0.9912031823352467, -0.055664060623760676], [1.007942625827338, -0.0020081355099150233]),
    (1.25, [0.008222221925838805, -2.171485298332652], [0.17142593376687892, -39.17493388265786]),
    (3.75, [0.013124902875631337, 1.8469397944764379], [-0.2546861711213201, 9.593218011029734]),
    (10.0, [0.6619187309682627, 0.01892142457428792], [0.8254631956288958, 0.02219319354511903]),
    (15.0, [0.3296372719056749, 0.043058752004164966], [0.4575980571188867, 0.0645505949215922]),
];

#[test]
fn a_rayleigh_damped_layer_on_rock_has_its_tabulated_transfer() {
    let rayleigh = Rayleigh { mass: 0.15707963267948966, stiffness: 0.0015915494309189536 };
    let column = column(&[ROCK, Layer { rayleigh, ..SOIL }], Top::Free);
    for (hertz, over_outcrop, over_base) in RAYLEIGH_LAYER {
        let s = at_frequency(hertz);
        let factors = column.factors(s);
        let late = (-s * (ROCK.thickness / ROCK.speed)).exp();
        let complex = |[re, im]: [f64; 2]| Complex64::new(re, im);
        let outcrop = complex(over_outcrop);
        assert!((0.5 * factors[2] / late - outcrop).norm() < 1e-12 * outcrop.norm(), "{hertz} Hz");
        let base = complex(over_base);
        assert!(
            (factors[2] / factors[1] - base).norm() < 1e-10 * base.norm(),
            "{hertz} Hz: {}",
            factors[2] / factors[1]
        );
    }
}

/// u_s(t) = 2/(1 + α) Σ (−R)^m u_o(t − (2m + 1)H/V) of a layer on rock (`roesset1970`), u_o twice the incident wave.
fn echoes(soil: &Layer, rock: &Layer, t: f64) -> f64 {
    let alpha = soil.dashpot() / rock.dashpot();
    let r = (1.0 - alpha) / (1.0 + alpha);
    let (travel, delay) = (soil.thickness / soil.speed, rock.thickness / rock.speed);
    let first = 2.0 / (1.0 + alpha);
    (0..400).map(|m| first * (-r).powi(m) * 2.0 * pulse(t - delay - f64::from(2 * m + 1) * travel)).sum()
}

#[test]
fn an_undamped_layer_on_rock_has_all_its_echoes() {
    let [top, _] = column(&[ROCK, SOIL], Top::Free).velocities(pulse, 1e-3, 6.0);
    assert!(difference(&top, 1e-3, |t| echoes(&SOIL, &ROCK, t)) < 1e-8 * largest(&top));
}

#[test]
fn a_layer_that_rings_beyond_the_span_is_exact_as_well() {
    // R = 0.98 and 0.4 s from echo to echo: after 8 s still two thirds of the first.
    let mud = Layer { thickness: 10.0, density: 1500.0, speed: 100.0, ..SOIL };
    let rock = Layer { density: 3000.0, speed: 5000.0, ..ROCK };
    let [top, _] = column(&[rock, mud], Top::Free).velocities(pulse, 1e-3, 8.0);
    let late = largest(&top[7000..8000]);
    assert!(late > 0.5 * largest(&top), "{late}");
    assert!(difference(&top, 1e-3, |t| echoes(&mud, &rock, t)) < 1e-7 * largest(&top));
}

#[test]
fn layers_of_the_same_stuff_are_one() {
    let band = Some(Band::fit(0.03, [0.5, 20.0], 3.0).unwrap());
    let whole = Layer { band, rayleigh: Rayleigh { mass: 0.5, stiffness: 1e-3 }, ..SOIL };
    let half = Layer { thickness: 0.5 * whole.thickness, ..whole };
    // Past the constructor, which would join them.
    let parted = LayeredColumn { layers: vec![ROCK, half, half], top: Top::Free };
    let one = column(&[ROCK, whole], Top::Free);
    assert_eq!(column(&[ROCK, half, half], Top::Free), one);
    for hertz in [0.1, 1.25, 9.0] {
        let (many, few) = (parted.factors(at_frequency(hertz)), one.factors(at_frequency(hertz)));
        for (a, b) in [(many[0], few[0]), (many[1], few[1]), (many[3], few[2])] {
            assert!((a - b).norm() < 1e-13 * b.norm().max(1.0), "{hertz} Hz: {a} {b}");
        }
    }
}

#[test]
fn nothing_comes_back_from_a_viscous_top() {
    let [top, base] = column(&[HOMOGENEOUS], Top::Viscous).velocities(pulse, 1e-3, 3.0);
    assert!(difference(&base, 1e-3, pulse) < 1e-8, "as in a full space");
    assert!(difference(&top, 1e-3, |t| pulse(t - 0.2)) < 1e-8);
    // Under the boundary between unlike layers the first reflection is all there is.
    let [_, base] = column(&[ROCK, SOIL], Top::Viscous).velocities(pulse, 1e-3, 3.0);
    let (soil, rock) = (SOIL.dashpot(), ROCK.dashpot());
    let back = (rock - soil) / (rock + soil);
    assert!(difference(&base, 1e-3, |t| pulse(t) + back * pulse(t - 200.0 / 2300.0)) < 1e-8);
}

#[test]
fn what_is_damped_beyond_all_numbers_does_not_arrive() {
    let thick = Layer { thickness: 1e6, rayleigh: Rayleigh { mass: 2.0, stiffness: 0.05 }, ..SOIL };
    let factors = column(&[ROCK, thick, SOIL], Top::Free).factors(at_frequency(20.0));
    assert!(factors.iter().all(|f| f.is_finite()) && factors[0].norm() > 0.1 && factors[3].norm() == 0.0);
}

#[test]
fn between_levels_theory_is_that_of_a_column_with_a_level_there() {
    let band = Some(Band::fit(0.03, [0.5, 20.0], 3.0).unwrap());
    let soil = Layer { band, rayleigh: Rayleigh { mass: 0.5, stiffness: 1e-3 }, ..SOIL };
    let whole = column(&[ROCK, soil], Top::Free);
    for share in [0.0, 0.3, 0.75, 1.0] {
        let part = |share: f64| Layer { thickness: share * soil.thickness, ..soil };
        // Past the constructor, which would join them.
        let parted = LayeredColumn { layers: vec![ROCK, part(share), part(1.0 - share)], top: Top::Free };
        let height = ROCK.thickness + share * soil.thickness;
        for hertz in [0.1, 1.25, 9.0] {
            let (found, exact) =
                (whole.factor_at(at_frequency(hertz), height), parted.factors(at_frequency(hertz))[2]);
            assert!(
                (found - exact).norm() < 1e-12 * exact.norm().max(1.0),
                "{share} {hertz} Hz: {found} {exact}"
            );
        }
    }
    // Up, and back from the surface.
    let heights = [0.0, 60.0, 240.0];
    let found = column(&[HOMOGENEOUS], Top::Free).velocities_at(&heights, pulse, 1e-3, 3.0);
    for (found, height) in found.iter().zip(heights) {
        let exact = |t: f64| pulse(t - height / 1200.0) + pulse(t - 0.4 + height / 1200.0);
        assert!(found.len() > 3000 && difference(found, 1e-3, exact) < 1e-8, "{height}");
    }
}

#[test]
fn weak_damping_of_mass_or_stiffness_takes_what_first_order_says() {
    let travel = HOMOGENEOUS.thickness / HOMOGENEOUS.speed;
    // A long train of one wavelength a height, with which damping changes nothing at the base: to first order
    // e^(−ω_R t/2) and e^(−ξω² t/2) over the travel time.
    let omega = TAU / travel;
    let train = |t: f64| (omega * t).sin() * (0.5 * t.min(2.0) / 2.0);
    let found = |rayleigh| {
        let layer = Layer { rayleigh, ..HOMOGENEOUS };
        largest(&column(&[layer], Top::Free).velocities(train, 1e-3, 6.0)[0][4000..])
    };
    let whole = found(NONE);
    let mass = Rayleigh { mass: 0.1, stiffness: 0.0 };
    assert!((found(mass) / whole - (-0.05 * travel).exp()).abs() < 2e-4);
    let stiffness = Rayleigh { mass: 0.0, stiffness: 2e-4 };
    assert!((found(stiffness) / whole - (-1e-4 * omega * omega * travel).exp()).abs() < 5e-4);
}

#[test]
fn a_band_takes_about_its_ratio_times_the_phase() {
    let omega = TAU * HOMOGENEOUS.speed / HOMOGENEOUS.thickness;
    let train = |t: f64| (omega * t).sin() * (0.5 * t.min(2.0) / 2.0);
    let found = |band| {
        let layer = Layer { band, ..HOMOGENEOUS };
        largest(&column(&[layer], Top::Free).velocities(train, 1e-3, 6.0)[0][4000..])
    };
    let band = Band::fit(0.02, [0.5, 20.0], 5.0).unwrap();
    let exact = (-band.ratio(5.0) * omega * HOMOGENEOUS.thickness / HOMOGENEOUS.speed).exp();
    assert!((found(Some(band)) / found(None) / exact - 1.0).abs() < 3e-3);
}

/// A layer with 5 % damping at all frequencies on elastic rock, surface over outcrop: 1/(cos k*H + i α* sin k*H) with
/// k* = ω/(c √(1 + 2iD)) and α* = ρc √(1 + 2iD)/(ρ_r c_r) (`kramer1996`, section 7.2.1).
#[test]
fn damping_that_is_the_same_at_all_frequencies_has_its_closed_form() {
    let soil = Layer { thickness: 20.0, density: 1900.0, speed: 300.0, damping: 0.05, ..SOIL };
    let rock = Layer { thickness: 0.0, ..ROCK };
    let column = column(&[rock, soil], Top::Free);
    assert!((column.height() - 20.0).abs() < 1e-12 && (column.travel(10.0) - 10.0 / 300.0).abs() < 1e-12);
    for hertz in [0.5, 3.75, 11.0] {
        let slow = Complex64::new(1.0, 0.1).sqrt();
        let angle = TAU * hertz * soil.thickness / (soil.speed * slow);
        let impedance = soil.density * soil.speed * slow / (ROCK.density * ROCK.speed);
        let exact = 2.0 / (angle.cos() + Complex64::i() * impedance * angle.sin());
        let s = at_frequency(hertz);
        for found in [column.factors(s)[2], column.factor_at(s, 20.0)] {
            assert!((found - exact).norm() < 1e-12 * exact.norm(), "{hertz} Hz: {found} {exact}");
        }
        let within = exact * (0.5 * angle).cos();
        assert!((column.factor_at(s, 10.0) - within).norm() < 1e-12, "{hertz} Hz, in the middle");
        assert!((column.factor_at(s, 0.0) - exact * angle.cos()).norm() < 1e-12, "{hertz} Hz, at the base");
    }
}
