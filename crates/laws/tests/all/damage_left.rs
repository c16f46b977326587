//! What damage leaves of damping stresses and of the resistance to hourglass modes.

use crate::common::Random;
use crate::common::concrete::with_words;
use tremolite_laws::materials::{Concrete, MohrCoulomb};
use tremolite_laws::{History, Material, Moduli, Point, Sym, Values};

const MODULI: Moduli = Moduli { lambda: 5e9, mu: 10e9 };

fn concrete() -> Concrete {
    let values = Values::default()
        .with("young", 25e9)
        .with("poisson", 0.17)
        .with("tensile_strength", 1.2e6)
        .with("cohesion", 2e6)
        .with("friction_angle", 0.8);
    Concrete::new(&with_words(values, &[("evolution", "residual"), ("split", "effective")])).unwrap()
}

/// The state after a strain came at once.
fn after<M: Material>(law: &M, strain: Sym<f64>) -> M::History<f64> {
    law.update(&Point::new(0.0), strain, <M::History<f64> as History<f64>>::zero()).1
}

fn product(a: &Sym<f64>, b: &Sym<f64>) -> f64 {
    (0..6).map(|c| a[c] * b[c]).sum()
}

#[test]
fn virgin_concrete_carries_damping_as_elasticity_does() {
    let law = concrete();
    let strain = [1e-6, -2e-6, 3e-6, 1e-6, -1e-6, 2e-6];
    let v = law.integrity(&strain, &after(&law, strain));
    let e = [0.3, -0.2, 0.9, 0.5, -0.7, 0.1];
    assert_eq!(MODULI.stress_left(&e, &v), MODULI.stress(&e));
    assert_eq!(law.hourglass_share(&after(&law, strain)), 1.0);
}

#[test]
fn an_open_crack_carries_no_damping_across_and_all_of_it_along() {
    let law = concrete();
    let strain = [1e-3, 0.0, 0.0, 0.0, 0.0, 0.0];
    let v = law.integrity(&strain, &after(&law, strain));
    let across = MODULI.stress_left(&[1.0, 0.0, 0.0, 1.0, 0.0, 1.0], &v);
    // D⁺ = 1 exactly: ν > 0 makes the two other effective stresses tensile as well, so nothing is left there either.
    assert_eq!(across, [0.0; 6]);
    // Pressed along the crack, whose D⁻ is 0.
    let pressed = [1e-3, -2e-3, -2e-3, 0.0, 0.0, 0.0];
    let mut history = after(&law, strain);
    history[1] = 0.0;
    let v = law.integrity(&pressed, &history);
    let stress = MODULI.stress_left(&[0.7, 1.0, 2.0, 0.3, 0.5, 0.4], &v);
    let plane = [0.0, 10e9 * 2.0 + 15e9, 10e9 * 4.0 + 15e9, 0.0, 5e9, 0.0];
    for c in 0..6 {
        assert!((stress[c] - plane[c]).abs() < 1e-5, "{stress:?}");
    }
}

#[test]
fn damping_takes_energy_in_every_state() {
    let law = concrete();
    let mut random = Random::new(11);
    for _ in 0..10_000 {
        let strain = std::array::from_fn(|_| 1e-3 * random.symmetric());
        let v = law.integrity(&strain, &after(&law, strain));
        let e = std::array::from_fn(|_| random.symmetric());
        let stress = MODULI.stress_left(&e, &v);
        assert!(product(&stress, &e) >= 0.0);
        // Symmetric in two stretches, as a stiffness is.
        let other = std::array::from_fn(|_| random.symmetric());
        let swapped = product(&MODULI.stress_left(&other, &v), &e);
        // Round-off of sums of 36 terms of up to 4e10.
        assert!((product(&stress, &other) - swapped).abs() < 1e-4, "{swapped:e}");
    }
}

#[test]
fn the_update_tells_what_its_new_state_has_left() {
    let law = concrete();
    let mut random = Random::new(5);
    let mut history = <<Concrete as Material>::History<f64> as History<f64>>::zero();
    let mut unbroken = 1.0;
    for n in 0..5_000 {
        let size = 2e-7 * f64::from(n);
        let strain = std::array::from_fn(|_| size * random.symmetric());
        let (stress, new, left) = law.update_left(&Point::new(1e-3), strain, history);
        assert_eq!((stress, new), law.update(&Point::new(1e-3), strain, history));
        let asked = law.integrity(&strain, &new);
        for c in 0..6 {
            // Axes of the same strain, found twice.
            assert!((left[c] - asked[c]).abs() < 1e-9, "{left:?} {asked:?}");
        }
        assert!(law.unbroken(&new) <= unbroken);
        (history, unbroken) = (new, law.unbroken(&new));
    }
    assert_eq!(unbroken, 0.0);
}

#[test]
fn the_hourglass_share_only_falls_and_stays_above_its_floor() {
    fn walk<M: Material>(law: &M, random: &mut Random) {
        let mut history = <M::History<f64> as History<f64>>::zero();
        let mut last = 1.0;
        for _ in 0..50 {
            let strain = std::array::from_fn(|_| 2e-3 * random.symmetric());
            history = law.update(&Point::new(1e-3), strain, history).1;
            let share = law.hourglass_share(&history);
            assert!(share <= last && share >= 0.001, "{share} after {last}");
            last = share;
        }
        assert!(last < 0.9, "the walk breaks the material: {last}");
    }
    let mut random = Random::new(5);
    let rock = Values::default()
        .with("young", 10e9)
        .with("poisson", 0.25)
        .with("cohesion", 2.18e6)
        .with("friction_angle", 0.73)
        .with("tensile_strength", 1e6);
    for _ in 0..200 {
        walk(&concrete(), &mut random);
        walk(&MohrCoulomb::new(&rock).unwrap(), &mut random);
    }
}
