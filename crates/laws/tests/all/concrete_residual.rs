//! The paper's plateau, where it is named, answers in every bit as it did while it was the default.

use crate::common::Random;
use crate::common::concrete::*;
use tremolite_laws::materials::Concrete;
use tremolite_laws::parameter::position;
use tremolite_laws::{Material, Role, virgin};

/// Of each variant what a random walk of 2,000 steps ended with: stress \[Pa\], D⁺, D⁻, dissipated and created energy \[J/m³\],
/// in as many digits as tell one number from the next, and a hash of the bits of all steps. Written by the program of before
/// `exponential` and `compliance` became the defaults.
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

fn walk(law: &Concrete) -> String {
    let mut random = Random::new(17);
    let mut history = virgin::<Concrete>();
    let (mut strain, mut stress) = ([0.0; 6], [0.0; 6]);
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    for n in 0..2_000 {
        // Steps that grow from a twentieth of ε_ts to twice of it, drawn back to where it began: past ε_us in the end.
        let step = THRESHOLD * (0.05 + 1e-3 * f64::from(n));
        strain = strain.map(|e| 0.995 * e + step * random.symmetric());
        (stress, history) = law.update(&point(2e-4, 0.8), strain, history);
        // The width of cracks came later, and nothing goes by it.
        let (kept, _) = history.split_at(position(Concrete::HISTORY, Role::CrackWidth).unwrap());
        for x in stress.iter().chain(kept) {
            hash = (hash ^ x.to_bits()).wrapping_mul(0x0100_0000_01b3);
        }
    }
    assert!(history[0] > 0.5, "the walk must crack: {}", history[0]);
    let ends = stress.iter().chain([&history[0], &history[1], &history[9], &history[10]]);
    let ends: Vec<String> = ends.map(|x| format!("{x:e}")).collect();
    format!("{} {hash:016x}", ends.join(" "))
}

#[test]
fn the_named_plateau_answers_in_every_bit_as_it_did_as_the_default() {
    let mut found = String::new();
    for (name, words, energy) in VARIANTS {
        let mut all = values();
        if let Some(energy) = energy {
            all = all.with("fracture_energy", *energy);
        }
        let law = Concrete::new(&with_words(all, words)).unwrap();
        found += &format!("{name}: {}\n", walk(&law));
    }
    println!("{found}");
    assert_eq!(found, BEFORE);
}
