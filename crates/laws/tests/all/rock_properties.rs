//! Random paths of random rock: energy, axes, steps, admissible stress, no NaN. 10,000 paths a law.

use crate::common::Random;
use crate::common::concrete::{contract, turn, turn_strain};
use crate::common::rock::*;
use proptest::test_runner::{Config, TestError, TestRunner};
use std::cell::RefCell;
use tremolite_laws::materials::{DruckerPrager, HoekBrown, MohrCoulomb};
use tremolite_laws::sym3::principal_values;
use tremolite_laws::{History, Material, Point, Values};

const PATHS: u32 = 10_000;

/// Errors of 4 and 16 steps a leg against 64, summed over paths.
#[derive(Default)]
struct Convergence {
    four: f64,
    sixteen: f64,
    worst: f64,
}

fn distance(a: &[f64; 6], b: &[f64; 6]) -> f64 {
    (0..6).map(|c| (a[c] - b[c]).abs()).fold(0.0, f64::max)
}

/// One path of one rock. `excess` is the yield function that remains, from principal stresses.
fn check<M: Material>(
    law: &M,
    seed: u64,
    excess: impl Fn(&M, &[f64; 3], &[f64]) -> f64,
    convergence: &RefCell<Convergence>,
) -> Result<(), String> {
    let mut random = Random::new(seed);
    let size = 10f64.powf(-4.5 + 2.5 * random.unit());
    let corners = [0; 3].map(|_| random_strain(&mut random, size));
    let scale = corners.iter().fold(0.0f64, |m, e| m.max(largest(&elastic_stress(e))));
    let axes = random.rotation();

    let zero = <M::History<f64> as History<f64>>::zero();
    let (mut history, mut turned_history) = (zero, zero);
    let mut last = [0.0; 6];
    for corner in &corners {
        for step in 1..=4 {
            let strain = std::array::from_fn(|c| last[c] + (corner[c] - last[c]) * 0.25 * step as f64);
            let (stress, new) = law.update(&Point::new(0.0), strain, history);
            let (h, n) = (history.as_ref(), new.as_ref());
            if !stress.iter().chain(n).all(|x| x.is_finite()) {
                return Err(format!("not finite: {stress:?} {n:?}"));
            }
            let flow: [f64; 6] = std::array::from_fn(|c| n[3 + c] - h[3 + c]);
            let work = contract(&stress, &flow);
            if work < -1e-13 * scale * size {
                return Err(format!("gives out {work:e} J/m³ of {:e}: {stress:?} {flow:?}", scale * size));
            }
            if n[0] < h[0] || n[1] < h[1] {
                return Err(format!("accumulated strain falls: {h:?} {n:?}"));
            }
            let elastic: [f64; 6] = std::array::from_fn(|c| strain[c] - n[3 + c]);
            if distance(&elastic_stress(&elastic), &stress) > 1e-12 * scale {
                return Err(format!("stress is not that of the elastic strain: {stress:?} {elastic:?}"));
            }
            let stored = law.stored_energy(&strain, &stress, &new);
            if (stored - 0.5 * contract(&stress, &elastic)).abs() > 1e-12 * scale * size {
                return Err(format!(
                    "stored energy {stored:e} J/m³ is not that of the elastic strain: {stress:?}"
                ));
            }
            let over = excess(law, &principal_values(&stress), h);
            if over > 1e-11 * scale + 2e-14 * YOUNG {
                return Err(format!("{over:e} Pa outside the yield surface: {stress:?}"));
            }
            let (turned, new_turned) =
                law.update(&Point::new(0.0), turn_strain(&strain, &axes), turned_history);
            if distance(&turn(&stress, &axes), &turned) > 1e-9 * scale {
                return Err(format!("depends on the axes: {stress:?} {turned:?}"));
            }
            for c in 0..2 {
                if (n[c] - new_turned.as_ref()[c]).abs() > 1e-9 * size {
                    return Err(format!("history depends on the axes: {n:?} {:?}", new_turned.as_ref()));
                }
            }
            (history, turned_history) = (new, new_turned);
        }
        last = *corner;
    }

    let [four, sixteen, fine] = [4, 16, 64].map(|steps| follow(law, &corners, steps).0);
    let mut sums = convergence.borrow_mut();
    sums.four += distance(&four, &fine) / scale;
    sums.sixteen += distance(&sixteen, &fine) / scale;
    sums.worst = sums.worst.max(distance(&sixteen, &fine) / scale);
    Ok(())
}

/// 10,000 paths; `draw` makes a rock from random numbers. `worst` bounds the error of 16 steps a leg, over the path's
/// largest elastic stress.
fn properties<M: Material + std::fmt::Debug>(
    draw: impl Fn(&mut Random) -> Values,
    excess: impl Fn(&M, &[f64; 3], &[f64]) -> f64,
    worst: f64,
) {
    let convergence = RefCell::new(Convergence::default());
    let config = Config { cases: PATHS, failure_persistence: None, ..Config::default() };
    let mut runner = TestRunner::new_with_rng(
        config,
        proptest::test_runner::TestRng::deterministic_rng(proptest::test_runner::RngAlgorithm::XorShift),
    );
    let outcome = runner.run(&(0u64..1 << 40), |seed| {
        let mut random = Random::new(seed ^ 0x5555);
        let law = M::new(&draw(&mut random)).expect("the draw gives valid parameters");
        check(&law, seed, &excess, &convergence)
            .map_err(|text| proptest::test_runner::TestCaseError::fail(format!("{text}\n{law:?}")))
    });
    if let Err(TestError::Fail(reason, seed)) = outcome {
        panic!("seed {seed}: {reason}");
    }
    let sums = convergence.into_inner();
    let paths = f64::from(PATHS);
    println!(
        "{}: mean error of 4 steps a leg {:.2e}, of 16 {:.2e}, worst of 16 {:.2e}",
        M::NAME,
        sums.four / paths,
        sums.sixteen / paths,
        sums.worst
    );
    // First order: (1/16 − 1/64)/(1/4 − 1/64) = 0.2.
    assert!(sums.sixteen < 0.3 * sums.four);
    assert!(sums.worst < worst, "{}", sums.worst);
}

fn angle(random: &mut Random, low: f64, high: f64) -> f64 {
    (low + (high - low) * random.unit()).to_radians()
}

fn any_mohr_coulomb(random: &mut Random) -> Values {
    let phi = if random.unit() < 0.1 { 0.0 } else { angle(random, 5.0, 60.0) };
    let psi = phi * [0.0, random.unit(), 1.0][(3.0 * random.unit()) as usize];
    rock(&[
        ("cohesion", 10f64.powf(4.0 + 3.0 * random.unit())),
        ("friction_angle", phi),
        ("dilation_angle", psi),
        ("tensile_strength", if random.unit() < 0.2 { 0.0 } else { 10f64.powf(4.0 + 3.0 * random.unit()) }),
    ])
}

fn pyramid(c: f64, phi: f64, ft: f64, s: &[f64; 3]) -> f64 {
    let surface = Surface::Linear { k: slope(phi), fc: 2.0 * c * slope(phi).sqrt() };
    // Per unit of the larger slope, so that a steep surface is not asked for more digits than stresses have.
    let apex = surface.apex();
    (surface.excess(s[0], s[2]) / slope(phi)).max(s[0] - ft.min(if apex.is_nan() { ft } else { apex }))
}

#[test]
fn mohr_coulomb() {
    properties::<MohrCoulomb>(
        any_mohr_coulomb,
        |law, s, _| {
            let [c, phi, ft] = law.strength(0.0, 0.0);
            pyramid(c, phi, ft, s)
        },
        0.05,
    );
}

/// A table that goes down, up or both, with or without its column of tension strains.
fn any_softening(random: &mut Random, peak: Values) -> Values {
    let rows = 2 + (3.0 * random.unit()) as usize;
    let strains = |random: &mut Random| {
        let mut at = 0.0;
        let mut next = || 10f64.powf(-3.0 + 2.0 * random.unit());
        let mut all = vec![0.0];
        all.extend((1..rows).map(|_| {
            at += next();
            at
        }));
        all
    };
    let (shear, tension) = (strains(random), strains(random));
    let mut column = |key: &str, least: f64, most: f64| {
        let first = peak.optional(key).unwrap_or(0.0);
        let mut all = vec![first];
        all.extend((1..rows).map(|_| first * (least + (most - least) * random.unit())));
        all
    };
    let cohesion = column("cohesion", 0.1, 1.2);
    let friction = column("friction_angle", 0.3, 1.0);
    let tensile = column("tensile_strength", 0.0, 1.1);
    let dilation = vec![peak.optional("dilation_angle").unwrap_or(0.0)];
    let dilation: Vec<f64> =
        dilation.into_iter().chain(friction[1..].iter().map(|phi| phi * random.unit())).collect();
    let mut columns = vec![
        ("plastic_shear_strain", &shear[..]),
        ("cohesion", &cohesion),
        ("friction_angle", &friction),
        ("dilation_angle", &dilation),
        ("tensile_strength", &tensile),
    ];
    if random.unit() < 0.5 {
        columns.push(("plastic_tension_strain", &tension));
    }
    peak.with_table("softening", &columns)
}

#[test]
fn softening_mohr_coulomb() {
    let draw = |random: &mut Random| {
        let values = any_mohr_coulomb(random);
        any_softening(random, values)
    };
    // One step may run through the whole table, and every step lags behind by itself.
    properties::<MohrCoulomb>(
        draw,
        |law, s, before| {
            let [c, phi, ft] = law.strength(before[0], before[1]);
            pyramid(c, phi, ft, s)
        },
        0.2,
    );
}

#[test]
fn drucker_prager() {
    let draw = |random: &mut Random| {
        let fit = ["outer", "inner", "plane-strain"][(3.0 * random.unit()) as usize];
        with_word(any_mohr_coulomb(random), "fit", fit)
    };
    properties::<DruckerPrager>(
        draw,
        |law, s, _| {
            let [q, k, _] = law.cone();
            let mean = (s[0] + s[1] + s[2]) / 3.0;
            let second = s.iter().map(|x| 0.5 * (x - mean).powi(2)).sum::<f64>().sqrt();
            (second + q * mean - k).max(mean - law.tensile_strength())
        },
        0.05,
    );
}

#[test]
fn hoek_brown() {
    let draw = |random: &mut Random| {
        let values = rock(&[
            ("compressive_strength", 10f64.powf(6.5 + 2.0 * random.unit())),
            ("gsi", 10.0 + 90.0 * random.unit()),
            ("m_i", 4.0 + 28.0 * random.unit()),
            ("disturbance", random.unit()),
            (
                "dilation_angle",
                [0.0, angle(random, 0.0, 20.0), angle(random, 20.0, 60.0)][(3.0 * random.unit()) as usize],
            ),
        ]);
        if random.unit() < 0.5 { values } else { values.with("tensile_strength", 1e6 * random.unit()) }
    };
    properties::<HoekBrown>(
        draw,
        |law, s, _| {
            let [mb, _, a] = law.constants();
            let sci = law.intact_strength();
            let ft = law.tensile_strength();
            // Measured in σ₁, where the envelope is never vertical: u^a = (σ₁ − σ₃)/σ_ci.
            let first = (law.constants()[1] - (((s[0] - s[2]) / sci).powf(1.0 / a))) * sci / mb;
            ((s[0] - first).min(s[0] - s[2] - 1e-12 * sci)).max(s[0] - ft)
        },
        0.05,
    );
}
