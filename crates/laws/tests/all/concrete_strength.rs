//! Concrete under static load: uniaxial, cyclic, triaxial, biaxial.

use crate::common::Random;
use crate::common::concrete::*;
use tremolite_laws::materials::Concrete;
use tremolite_laws::path::{Path, Response, drive};
use tremolite_laws::{History, Material};

const SPLITS: [&str; 2] = ["effective", "compliance"];

#[test]
fn uniaxial_tension_is_linear_to_ft_then_a_plateau_then_nothing() {
    for split in SPLITS {
        let response = uniaxial(&concrete(&[("split", split)]), &ramp(0.0, 12.0 * THRESHOLD, 1200), None);
        for (e, s) in response.strain.iter().zip(&response.stress) {
            let ratio = e[0] / THRESHOLD;
            let exact = if ratio < 1.0 - 1e-12 {
                YOUNG * e[0]
            } else if ratio < 1.0 + 1e-12 || (ratio - 10.0).abs() < 1e-12 {
                continue;
            } else if ratio < 10.0 {
                ALPHA * FT
            } else {
                0.0
            };
            // The lateral strain is solved to 1e-13 of the strain, here up to twelve times ε_ts.
            assert!((s[0] - exact).abs() <= 1e-13 * 12.0 * FT, "{split} at {ratio} ε_ts: {} {exact}", s[0]);
        }
        let damage = response.column("d_tension").unwrap();
        assert_eq!((damage[50], damage[1150]), (0.0, 1.0));
    }
}

/// Uniaxial stress with the lateral strain that belongs to a known axial stress. Solving for it would find one of
/// many: a point cracked through has no lateral stiffness.
fn known_uniaxial(law: &Concrete, split: &str, path: &[f64], stress: &[f64]) -> Response {
    let strains = path
        .iter()
        .zip(stress)
        .map(|(&e, &s)| {
            let lateral = -POISSON * if split == "compliance" { s / YOUNG } else { e };
            [e, lateral, lateral, 0.0, 0.0, 0.0]
        })
        .collect();
    drive(law, &Path::strains(vec![0.0; path.len()], strains)).unwrap()
}

/// Largest distance from E ε up to f_c and from β f_c beyond, over f_c; the row that breaks the point left out.
fn compression_error(split: &str, steps: usize) -> f64 {
    let peak = fc() / YOUNG;
    // The row just past the peak breaks the point while its lateral strain is still elastic.
    let mut path = ramp(0.0, -peak * (1.0 - 1e-9), steps);
    path.push(-peak * (1.0 + 1e-9));
    path.extend(ramp(-peak * (1.0 + 2e-9), -5.0 * peak, steps));
    let breaks = steps + 1;
    let stress: Vec<f64> =
        path.iter().enumerate().map(|(k, &e)| if k <= breaks { YOUNG * e } else { -BETA * fc() }).collect();
    let response = known_uniaxial(&concrete(&[("split", split)]), split, &path, &stress);
    let damage = response.column("d_shear").unwrap();
    assert!(damage[breaks - 1] == 0.0 && (damage[breaks] - (1.0 - BETA)).abs() < 1e-8);
    let errors = response.stress.iter().zip(&stress).enumerate().filter(|(k, _)| *k != breaks);
    errors.fold(0.0f64, |m, (_, (found, exact))| m.max((found[0] - exact).abs())) / fc()
}

#[test]
fn uniaxial_compression_reaches_fc_then_stays_at_beta_fc() {
    assert!(compression_error("effective", 500) <= 1e-14);
    // The compliance split tests shear with the damage of the step before: first order in the step.
    let [coarse, fine] = [500, 1000].map(|n| compression_error("compliance", n));
    assert!(coarse < 2e-3 && (1.8..2.2).contains(&(coarse / fine)), "{coarse} {fine}");
}

#[test]
fn a_crack_opened_far_and_closed_again_carries_compression_up_to_fc() {
    for split in SPLITS {
        for driver in ["strain", "stress"] {
            let law = concrete(&[("split", split), ("driver", driver)]);
            let mut path = ramp(0.0, 50.0 * THRESHOLD, 200);
            path.extend(ramp(50.0 * THRESHOLD, -fc() / YOUNG * (1.0 - 1e-9), 400));
            path.push(-fc() / YOUNG * (1.0 + 1e-9));
            path.push(-2.0 * fc() / YOUNG);
            // Open, only the compliance split lets go of Poisson's contraction.
            let (mut most, mut stress) = (0.0f64, Vec::new());
            for &e in &path {
                most = most.max(e / THRESHOLD);
                let left = if most < 1.0 {
                    1.0
                } else if most <= 10.0 {
                    ALPHA / most
                } else {
                    0.0
                };
                stress.push(if e > 0.0 { left * YOUNG * e } else { YOUNG * e });
            }
            let response = known_uniaxial(&law, split, &path, &stress);
            let n = path.len();
            assert_eq!(response.column("d_tension").unwrap()[200], 1.0);
            assert_eq!(response.stress[200][0], 0.0);
            let shear = response.column("d_shear").unwrap();
            assert_eq!(shear[n - 3], 0.0, "{split} {driver}");
            for (e, s) in response.strain[201..n - 2].iter().zip(&response.stress[201..n - 2]) {
                let exact = (YOUNG * e[0]).min(0.0);
                assert!(
                    (s[0] - exact).abs() <= 1e-14 * fc(),
                    "{split} {driver} at {}: {} {exact}",
                    e[0],
                    s[0]
                );
            }
            assert!(shear[n - 2] >= 1.0 - BETA - 1e-8);
            assert!((response.stress[n - 1][0] + BETA * fc()).abs() <= 1e-14 * fc());
        }
    }
}

/// At c1 = (f_c + N c3)(1 ∓ 1e-12) the point is whole, then broken.
#[test]
fn triaxial_compression_fails_at_mohr_coulomb_to_round_off() {
    for words in [
        [("split", "effective"), ("shear_tension", "nominal")],
        [("split", "compliance"), ("shear_tension", "nominal")],
    ] {
        let law = concrete(&words);
        for confinement in [0.0, 0.1e6, 1e6, 5e6, 20e6] {
            for middle in [0.0, 0.3, 1.0] {
                let strength = fc() + slope() * confinement;
                let c2 = confinement + middle * (strength - confinement) * 0.5;
                for (factor, expected) in [(1.0 - 1e-12, 0.0), (1.0 + 1e-12, 1.0 - BETA)] {
                    let strain = elastic_strain([-confinement, -c2, -strength * factor]);
                    let (_, history) = law.update(&point(0.0, 0.5), strain, History::zero());
                    assert!(
                        (history[1] - expected).abs() <= 1e-11,
                        "{words:?}, c3 {confinement}, c2 {c2}, {factor}: {}",
                        history[1]
                    );
                }
            }
        }
    }
}

/// Strength over f_t (or f_c) along a direction of principal stress: the largest multiple without damage.
fn strength(driver: &str, direction: [f64; 3]) -> f64 {
    let law = concrete(&[("driver", driver)]);
    let (mut low, mut high) = (0.0, 20.0 * fc());
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        let (_, h) =
            law.update(&point(0.0, 0.5), elastic_strain(direction.map(|x| x * middle)), History::zero());
        if h[0] > 0.0 || h[1] > 0.0 { high = middle } else { low = middle }
    }
    low
}

/// The figures of the module's documentation, printed there to 0.01.
#[test]
fn multiaxial_tensile_strength_over_uniaxial() {
    for (driver, direction, documented) in [
        ("strain", [1.0, 1.0, 0.0], 0.85),
        ("strain", [1.0, 1.0, 1.0], 0.87),
        ("strain", [1.0, 0.0, -1.0], 0.85),
        ("stress", [1.0, 1.0, 0.0], 0.71),
        ("stress", [1.0, 1.0, 1.0], 0.58),
        ("stress", [1.0, 0.0, -1.0], 1.00),
    ] {
        let found = strength(driver, direction) / FT;
        assert!((found - documented).abs() <= 0.005, "{driver} {direction:?}: {found}");
    }
}

/// Kupfer, Hilsdorf & Rüsch (1969): f_bc = 1.16 f_c; Kupfer & Gerstle (1973) in tension–compression:
/// σ_t/f_t = 1 − 0.8 σ_c/f_c. This law is asserted against its own closed forms, and the distance is printed.
#[test]
fn biaxial_envelope_beside_kupfer() {
    // Equal biaxial compression, driven by shear damage alone.
    let law = concrete(&[]);
    for (factor, broken) in [(1.0 - 1e-12, false), (1.0 + 1e-12, true)] {
        let s = fc() * factor;
        let (_, h) = law.update(&point(0.0, 0.5), elastic_strain([0.0, -s, -s]), History::zero());
        assert_eq!(h[1] > 0.0, broken);
    }
    println!("f_bc/f_c = 1.000, Kupfer 1.16: {:+.1} %", (1.0 / 1.16 - 1.0) * 100.0);
    for driver in ["strain", "stress"] {
        for compression in [0.1, 0.2, 0.3, 0.4, 0.5] {
            let c = compression * fc();
            let (mut low, mut high) = (0.0, 2.0 * FT);
            let law = concrete(&[("driver", driver)]);
            for _ in 0..200 {
                let t = 0.5 * (low + high);
                let (_, h) = law.update(&point(0.0, 0.5), elastic_strain([t, 0.0, -c]), History::zero());
                if h[0] > 0.0 || h[1] > 0.0 { high = t } else { low = t }
            }
            let exact = match driver {
                // (t + νc)² + ν²⟨c − t⟩² = f_t², and c = f_c − N t.
                "strain" => {
                    let nu = POISSON;
                    let (a, b) = (1.0 + nu * nu, nu * c * (1.0 - nu));
                    let q = 2.0 * nu * nu * c * c - FT * FT;
                    let wide = (-b + (b * b - a * q).max(0.0).sqrt()) / a;
                    let crack = if FT - nu * c >= c { FT - nu * c } else { wide };
                    crack.max(0.0).min((fc() - c) / slope())
                }
                _ => FT.min((fc() - c) / slope()),
            };
            let kupfer = 1.0 - 0.8 * compression;
            println!(
                "{driver}: σ_c = {compression} f_c: σ_t/f_t = {:.3}, Kupfer {kupfer:.3}: {:+.0} %",
                low / FT,
                (low / FT / kupfer - 1.0) * 100.0
            );
            assert!((low - exact).abs() <= 1e-9 * FT, "{driver} {compression}: {low} {exact}");
        }
    }
}

/// `shear_tension = "effective"` is the print of (13)–(14), which fails a cracked point under a trace of pressure.
#[test]
fn the_printed_criterion_fails_a_crack_and_the_corrected_one_does_not() {
    let damage = |word: &str, ratio: f64| {
        let law = concrete(&[("shear_tension", word)]);
        let mut history = History::zero();
        for k in 1..=100 {
            let s = FT * ratio * k as f64 / 100.0;
            (_, history) = law.update(&point(0.0, 0.5), elastic_strain([s, 0.0, -0.01 * s]), history);
        }
        history[1]
    };
    assert_eq!(damage("nominal", 1.4), 0.0);
    assert_eq!(damage("nominal", 9.0), 0.0);
    // N t + 0.01 t = f_c starts it, and D⁻ = 1 where ε_c = 0: f_c = (N − ν) t.
    let starts = fc() / (slope() + 0.01) / FT;
    assert!(damage("effective", starts * 0.999) == 0.0 && damage("effective", starts * 1.001) > 0.0);
    let complete = fc() / (slope() - POISSON) / FT;
    assert!((complete * (1.0 + 0.01 * POISSON) - 1.39).abs() < 0.005);
    assert!(damage("effective", complete * 0.999) < 1.0);
    assert_eq!(damage("effective", complete * 1.001), 1.0);
}

#[test]
fn mean_damage_follows_the_signs_of_stress() {
    let law = concrete(&[]);
    let mut path = ramp(0.0, 20.0 * THRESHOLD, 40);
    path.extend([-THRESHOLD]);
    let response = uniaxial(&law, &path, None);
    let (now, most) = (response.column("d_b").unwrap(), response.column("d_b_max").unwrap());
    // Open: no direction is pressed, all three count D⁺. Closed: the pressed one counts D⁻ = 0.
    assert_eq!((now[40], most[40]), (1.0, 1.0));
    assert!((now[41] - 2.0 / 3.0).abs() < 1e-15 && most[41] == 1.0);
}

/// The quick test of how much strength is used never says yes where more is, hard below that either, whatever the variant, the rate or what
/// the point remembers; and it says yes of most that are well below.
#[test]
fn no_stress_uses_more_than_it_is_said_to_use_at_most() {
    let mut random = Random::new(11);
    let (mut said, mut below) = (0, 0);
    for law in all_variants() {
        for _ in 0..300 {
            let stress = random_strain(&mut random, FT);
            let beside = if random.unit() < 0.5 { stress } else { random_strain(&mut random, FT) };
            let mut history = tremolite_laws::virgin::<Concrete>();
            history.iter_mut().for_each(|x| *x = 1e-4 * random.symmetric());
            let used = law.tension_use(&stress, &beside, &history).unwrap();
            assert!(used == 0.0 || !law.uses_at_most(&stress, used * (1.0 - 1e-9)), "{stress:?} uses {used}");
            for share in [0.3, 0.6, 0.9, 1.2] {
                let yes = law.uses_at_most(&stress, share);
                assert!(!yes || used <= share, "{stress:?} uses {used}, not at most {share}");
                let static_use = law.tension_use(&stress, &[0.0; 6], &[0.0; 21]).unwrap();
                (said, below) = (said + usize::from(yes), below + usize::from(static_use < 0.99 * share));
            }
        }
        assert!(!law.uses_at_most(&[f64::NAN; 6], 1.0));
        assert!(law.uses_at_most(&[-FT, -FT, -FT, 0.0, 0.0, 0.0], 0.1));
    }
    assert!(said >= below, "{said} of {below}");
}
