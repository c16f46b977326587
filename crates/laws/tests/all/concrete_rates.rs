//! Rates, filter and freezing; time that stands still.

use crate::common::concrete::*;
use std::f64::consts::TAU;
use tremolite_laws::materials::Concrete;
use tremolite_laws::path::{Path, drive};
use tremolite_laws::{Material, Point, virgin};

const LAST_RATE: f64 = 30.0;

fn law(rate: &str, filter: f64) -> Concrete {
    Concrete::new(&with_words(values().with("rate_filter_time", filter), &[("rate", rate)])).unwrap()
}

/// Strain along x at a constant rate without a filter, until damage: (factor, strain) at first damage.
fn first_damage(law: &Concrete, rate: f64, column: usize) -> (f64, f64) {
    let mut history = tremolite_laws::virgin::<Concrete>();
    let mut strain = 0.0;
    let step: f64 = 1e-4 * if column == 6 { THRESHOLD } else { fc() / YOUNG };
    while history[column] == 0.0 {
        strain += step;
        let e = match column {
            6 => [strain, 0.0, 0.0, 0.0, 0.0, 0.0],
            _ => [-strain, POISSON * strain, POISSON * strain, 0.0, 0.0, 0.0],
        };
        (_, history) = law.update(&point(step / rate, 0.5), e, history);
    }
    (history[column], strain)
}

/// Factors (12) and (16) with Model Code's reference rates in tension and in compression; beyond 30 s⁻¹ and below the reference they
/// stand.
#[test]
fn dynamic_factors_are_the_ceb_values() {
    let law = law("ceb", 0.0);
    let xi = 1.0 / (5.0 + 0.75 * fc() / 1e6);
    for rate in [1e-6f64, 3e-6, 3e-5, 1e-4, 1e-2, 1.0, 30.0, 300.0] {
        let ratio = |reference: f64| rate.clamp(reference, LAST_RATE) / reference;
        for (column, exact, start) in
            [(6, ratio(3e-6).powf(0.020), THRESHOLD), (7, ratio(3e-5).powf(1.026 * xi), fc() / YOUNG)]
        {
            let (factor, strain) = first_damage(&law, rate, column);
            // Rate from a difference of strains: their round-off over a step of 1e-4 of the strain at damage.
            assert!((factor / exact - 1.0).abs() <= 1e-12, "{rate} 1/s, column {column}: {factor} {exact}");
            // Found on a grid of steps of 1e-4 of the static strain.
            assert!(strain >= exact * start * (1.0 - 1e-9) && strain <= exact * start + 1.01e-4 * start);
        }
    }
    // By hand: (1/3e-6)^0.02 = e^(0.02 · 12.7169) = 1.28964.
    assert!((first_damage(&law, 1.0, 6).0 - 1.28964).abs() < 5e-5);
}

/// Model Code 2010: 1.018 and 1.014 to the power of decades, from its own references.
#[test]
fn other_rate_laws_use_their_own_exponents_and_references() {
    let mpa = fc() / 1e6;
    for (word, rate, column, exact) in [
        ("mc2010", 1.0, 6, 1e6f64.powf(0.018)),
        ("mc2010", 1.0, 7, (1.0f64 / 3e-5).powf(0.014)),
        ("mc90", 1.0, 6, (1.0f64 / 3e-6).powf(1.016 / (10.0 + 0.6 * mpa))),
        ("mc90", 1.0, 7, (1.0f64 / 3e-5).powf(1.026 / (5.0 + 0.9 * mpa))),
    ] {
        let (factor, _) = first_damage(&law(word, 0.0), rate, column);
        assert!((factor / exact - 1.0).abs() <= 1e-12, "{word} {column}: {factor} {exact}");
    }
    let printed = Concrete::new(&with_words(
        values().with("reference_rate", 0.3).with("rate_filter_time", 0.0),
        &[("rate", "ceb")],
    ))
    .unwrap();
    assert_eq!(first_damage(&printed, 1e-2, 6).0, 1.0);
    assert!((first_damage(&printed, 3.0, 6).0 - 10f64.powf(0.02)).abs() < 1e-12);
}

/// r ← r + Δt/(τ + Δt)(rate − r), written out, gives the factor that the smoothed strain gives.
#[test]
fn the_filter_is_the_signed_rate_through_a_first_order_low_pass() {
    let tau = 5e-3;
    let law = law("ceb", tau);
    let mut history = tremolite_laws::virgin::<Concrete>();
    let (mut r, mut last) = (0.0f64, 0.0f64);
    let mut t = 0.0;
    for k in 0.. {
        // Steps of changing length, strain that grows and swings.
        let dt = 1e-4 * (1.0 + 0.5 * (k as f64 * 0.7).sin());
        t += dt;
        let strain = (2e-3 * t + 0.2 * THRESHOLD * (900.0 * t).sin()).max(0.0);
        r += dt / (tau + dt) * ((strain - last) / dt - r);
        last = strain;
        (_, history) = law.update(&point(dt, 0.5), [strain, 0.0, 0.0, 0.0, 0.0, 0.0], history);
        assert!((history[4] - (strain - tau * r)).abs() <= 1e-12 * THRESHOLD);
        if history[6] > 0.0 {
            break;
        }
    }
    let exact = (r.abs().clamp(3e-6, LAST_RATE) / 3e-6).powf(0.02);
    assert!((history[6] / exact - 1.0).abs() <= 1e-12);
}

#[test]
fn factors_are_frozen_at_first_damage() {
    let law = law("ceb", 0.0);
    let mut history = tremolite_laws::virgin::<Concrete>();
    for (dt, strain) in [(1.0, 0.9), (0.01, 1.3), (1e-9, 2.0), (1.0, 3.0)] {
        (_, history) = law.update(&point(dt, 0.5), [strain * THRESHOLD, 0.0, 0.0, 0.0, 0.0, 0.0], history);
    }
    let exact = (0.4 * THRESHOLD / 0.01 / 3e-6f64).powf(0.02);
    assert!((history[6] / exact - 1.0).abs() < 1e-12, "{} {exact}", history[6]);
    // D⁺ of the plateau at 3 ε_ts, thresholds times the frozen factor.
    assert!((history[0] - (1.0 - ALPHA * exact / 3.0)).abs() < 1e-12);
}

#[test]
fn while_time_stands_still_rates_are_off_and_the_filter_starts_from_rest() {
    let law = law("ceb", 5e-3);
    let mut history = tremolite_laws::virgin::<Concrete>();
    for k in 1..=50 {
        let strain = 0.9 * THRESHOLD * k as f64 / 50.0;
        (_, history) = law.update(&point(0.0, 0.5), [strain, 0.0, 0.0, 0.0, 0.0, 0.0], history);
        assert!((history[4] - strain).abs() <= 1e-14 * THRESHOLD);
    }
    // Quiet after the stages: no rate, so the static threshold holds.
    let strain = |x: f64| [x * THRESHOLD, 0.0, 0.0, 0.0, 0.0, 0.0];
    let (_, rest) = law.update(&point(1e-5, 0.5), strain(0.9), history);
    assert!((rest[4] - 0.9 * THRESHOLD).abs() < 1e-18);
    let (_, broken) = law.update(&point(0.0, 0.5), strain(1.01), history);
    assert_eq!(broken[6], 1.0);
}

/// Through the path driver: the time column sets the rate, the first row takes none.
#[test]
fn a_path_with_time_shows_the_rate_and_one_without_does_not() {
    let law = law("ceb", 0.0);
    let strain = ramp(0.0, 1.5 * THRESHOLD, 300);
    for (rate, exact) in [(Some(1e-2), (1e-2f64 / 3e-6).powf(0.02)), (None, 1.0)] {
        let time = strain.iter().map(|e| rate.map_or(0.0, |r: f64| e / r)).collect();
        let path = Path::strains(time, strain.iter().map(|&e| [e, 0.0, 0.0, 0.0, 0.0, 0.0]).collect());
        let factor = *drive(&law, &path).unwrap().column("factor_tension").unwrap().last().unwrap();
        assert!((factor / exact - 1.0).abs() < 1e-10, "{factor} {exact}");
    }
}

/// Smoothed strains are brought on every few steps. A steady rate then gives the factor of every step once the filter has forgotten
/// its beginning. Over seismic strains with noise of the mesh on top, whose rates pass through zero where cracks begin, the factors
/// differ from those of every step by at most twice what these differ by among phases of the noise. On average they differ by less than
/// 0.2 % with a reference rate of 3·10⁻⁵ 1/s. With that of Model Code in tension, to which smaller rates count, phases differ more, and the
/// difference of two means is known to √2/√32 of their standard deviation: three times that is allowed.
#[test]
fn smoothed_strains_brought_on_every_few_steps_give_the_same_factors() {
    let (own, dt) = (law("ceb", 5e-3), 6e-5);
    let values = values().with("rate_filter_time", 5e-3).with("reference_rate", 3e-5);
    let larger = Concrete::new(&with_words(values, &[("rate", "ceb")])).unwrap();
    let law = &own;
    let every = law.slow_steps(dt);
    assert_eq!(every, 4);
    assert_eq!((law.slow_steps(0.0), law.slow_steps(1.3e-4), law.slow_steps(1e-6)), (1, 1, 8));
    let factor_of = |law: &Concrete, every: u64, strain: &dyn Fn(f64) -> f64| {
        let mut history = virgin::<Concrete>();
        for n in 1..400_000 {
            let late = match n % every {
                0 => every,
                late => late,
            };
            let point = Point { brings: late == every, since: late as f64 * dt, ..point(dt, 0.5) };
            let e = strain(n as f64 * dt);
            (_, history) = law.update(&point, [e, -POISSON * e, -POISSON * e, 0.0, 0.0, 0.0], history);
            if history[6] > 0.0 {
                return history[6];
            }
        }
        panic!("no damage")
    };
    for rate in [1e-4, 5e-4] {
        let steady = |t: f64| rate * t;
        let (few, exact) = (factor_of(law, every, &steady), factor_of(law, 1, &steady));
        assert!((few - exact).abs() < 1e-7, "{few} {exact}");
    }
    for (law, frequency) in
        [&own, &larger].into_iter().flat_map(|law| [0.5, 2.0, 8.0, 20.0].map(|f| (law, f)))
    {
        let swings = (0..32).map(|phase| {
            move |t: f64| {
                let slow = (TAU * frequency * t).sin() * (1.0 + 0.3 * t);
                let noise = (TAU * (400.0 * t + f64::from(phase) / 32.0)).sin();
                THRESHOLD * (0.9 * slow + 0.02 * noise)
            }
        });
        let pairs: Vec<[f64; 2]> =
            swings.map(|swing| [1, every].map(|every| factor_of(law, every, &swing))).collect();
        let mean = |k: usize| pairs.iter().map(|pair| pair[k]).sum::<f64>() / pairs.len() as f64;
        let spread = pairs.iter().map(|pair| (pair[0] - mean(0)).abs()).fold(0.0, f64::max);
        let apart = pairs.iter().map(|pair| (pair[1] - pair[0]).abs()).fold(0.0, f64::max);
        let drift = mean(1) - mean(0);
        println!(
            "{frequency} Hz: {:.4}, among phases {spread:.1e}, off {apart:.1e}, mean off {drift:.1e}",
            mean(0)
        );
        let variance = pairs.iter().map(|pair| (pair[0] - mean(0)).powi(2)).sum::<f64>() / pairs.len() as f64;
        let known = if std::ptr::eq(law, &own) { 3.0 * (2.0 * variance / 32.0).sqrt() } else { 0.0 };
        assert!(apart < 2.0 * spread && drift.abs() < known.max(2e-3));
    }
}
