//! Every law with its moduli scaled, as damping over a band wants it.

use crate::common::Random;
use crate::common::rock::random_strain;
use crate::common::samples::{MODULI, samples};
use tremolite_laws::{Material, Point, for_each_material, virgin};

/// The law asked to scale itself is the law made with its moduli scaled: strengths stay, moduli do not.
fn scales<M: Material>() {
    for sample in samples(M::NAME) {
        let values = sample.values();
        let law = M::new(&values).unwrap();
        let factor = 0.81;
        let scaled = law.scaled(factor);
        let (own, less) = (law.moduli(), scaled.moduli());
        assert!(
            (less.mu / own.mu - factor).abs() < 1e-14 && (less.lambda / own.lambda - factor).abs() < 1e-14
        );
        let moduli: Vec<_> = MODULI.iter().filter_map(|&name| Some((name, values.optional(name)?))).collect();
        assert!(!moduli.is_empty(), "{}: none of its parameters is among MODULI", M::NAME);
        let made = moduli.into_iter().fold(values, |values, (name, value)| values.with(name, factor * value));
        let made = M::new(&made).unwrap();
        let mut random = Random::new(5);
        let (mut a, mut b) = (virgin::<M>(), virgin::<M>());
        for step in 0..200 {
            let mut point = Point::new(1e-3);
            point.size = [0.25, 0.25, 0.25, 0.0, 0.0, 0.0];
            let strain = random_strain(&mut random, 1e-3);
            let (s, t);
            (s, a) = scaled.update(&point, strain, a);
            (t, b) = made.update(&point, strain, b);
            let most = t.iter().fold(1e3_f64, |m, x| m.max(x.abs()));
            for k in 0..6 {
                let which = sample.variant;
                assert!((s[k] - t[k]).abs() < 1e-9 * most, "{} {which}, step {step}: {s:?} {t:?}", M::NAME);
            }
        }
    }
}

macro_rules! all {
    ($($law:ty,)*) => { $(scales::<$law>();)* };
}

#[test]
fn every_law_scales_its_moduli_and_keeps_its_strengths() {
    for_each_material!(all);
}
