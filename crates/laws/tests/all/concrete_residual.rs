//! The paper's plateau, where it is named, answers as it did while it was the default.

use crate::common::Random;
use crate::common::concrete::*;
use tremolite_laws::materials::Concrete;
use tremolite_laws::{Material, virgin};

/// Of each variant what a random walk of 2,000 steps ended with: stress \[Pa\], D⁺, D⁻, dissipated and created energy \[J/m³\],
/// in as many digits as tell one number from the next. Written by the program of before `exponential` and `compliance` became the
/// defaults, which found stresses by principal directions.
const BEFORE: &str = include_str!("../data/residual.txt");

/// Key, words to be named, G_f \[N/m\] or none.
type Variant = (&'static str, &'static [(&'static str, &'static str)], Option<f64>);

const VARIANTS: &[Variant] = &[
    ("ratio", &[], None),
    ("ratio, ceb", &[("rate", "ceb")], None),
    ("energy", &[], Some(130.0)),
    ("energy, ceb", &[("rate", "ceb")], Some(130.0)),
    ("energy, ceb, compliance", &[("rate", "ceb"), ("split", "compliance")], Some(130.0)),
    ("energy, stress", &[("driver", "stress")], Some(130.0)),
    ("energy, mc2010, effective tension", &[("rate", "mc2010"), ("shear_tension", "effective")], Some(130.0)),
];

fn walk(law: &Concrete) -> Vec<f64> {
    let mut random = Random::new(17);
    let mut history = virgin::<Concrete>();
    let (mut strain, mut stress) = ([0.0; 6], [0.0; 6]);
    for n in 0..2_000 {
        // Steps that grow from a twentieth of ε_ts to twice of it, drawn back to where it began: past ε_us in the end.
        let step = THRESHOLD * (0.05 + 1e-3 * f64::from(n));
        strain = strain.map(|e| 0.995 * e + step * random.symmetric());
        (stress, history) = law.update(&point(2e-4, 0.8), strain, history);
    }
    assert!(history[0] > 0.5, "the walk must crack: {}", history[0]);
    stress.into_iter().chain([history[0], history[1], history[9], history[10]]).collect()
}

/// Relative; of numbers below 1, of 1. Largest found: 1.6e-13.
const ROUND_OFF: f64 = 1e-12;

#[test]
fn the_named_plateau_answers_as_it_did_as_the_default() {
    let before: Vec<&str> = BEFORE.lines().collect();
    assert_eq!(before.len(), VARIANTS.len());
    for ((name, words, energy), before) in VARIANTS.iter().zip(before) {
        let mut all = values();
        // The numbers on file of this law are of one reference rate in tension and in shear.
        if words.contains(&("rate", "ceb")) {
            all = all.with("reference_rate", 3e-5);
        }
        if let Some(energy) = energy {
            all = all.with("fracture_energy", *energy);
        }
        let found = walk(&Concrete::new(&with_words(all, words)).unwrap());
        let (same, numbers) = before.split_once(": ").unwrap();
        let before: Vec<f64> = numbers.split(' ').map(|x| x.parse().unwrap()).collect();
        assert_eq!((*name, found.len()), (same, before.len()));
        for (found, before) in found.into_iter().zip(before) {
            assert!((found - before).abs() <= ROUND_OFF * before.abs().max(1.0), "{name}: {found} {before}");
        }
    }
}
