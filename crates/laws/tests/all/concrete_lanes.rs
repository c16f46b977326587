//! Every register width gives concrete the bits of the scalar reference, lane by lane.
#![cfg(target_arch = "x86_64")]

use crate::common::Random;
use crate::common::concrete::*;
use tremolite_laws::lane::{Avx2, Avx512, Lane};
use tremolite_laws::materials::Concrete;
use tremolite_laws::{Isa, Material, Octet, Point};

/// Strain in, stress out, history in place.
type Batch = ([Octet; 6], [Octet; 6], [Octet; 14]);

#[inline(always)]
fn step<L: Lane>(law: &Concrete, dt: f64, (strain, stress, history): &mut Batch) {
    let mut at = 0;
    while at < 8 {
        let mut point = Point::new(L::splat(dt));
        for (k, g) in [0.09, 0.16, 0.25, 0.01, -0.02, 0.03].into_iter().enumerate() {
            point.size[k] = L::splat(g);
        }
        let mut e = [L::splat(0.0); 6];
        let mut h = [L::splat(0.0); 14];
        for k in 0..6 {
            e[k] = L::load(&strain[k], at);
        }
        for k in 0..14 {
            h[k] = L::load(&history[k], at);
        }
        let (s, h) = law.update(&point, e, h);
        for k in 0..6 {
            s[k].store(&mut stress[k], at);
        }
        for k in 0..14 {
            h[k].store(&mut history[k], at);
        }
        at += L::WIDTH;
    }
}

#[target_feature(enable = "avx2,fma")]
fn avx2(law: &Concrete, dt: f64, batch: &mut Batch) {
    step::<Avx2>(law, dt, batch);
}

#[target_feature(enable = "avx512f,avx2,fma")]
fn avx512(law: &Concrete, dt: f64, batch: &mut Batch) {
    step::<Avx512>(law, dt, batch);
}

#[test]
fn every_width_gives_the_bits_of_the_scalar_reference() {
    let mut random = Random::new(21);
    for law in all_variants() {
        for round in 0..60 {
            // Lanes of one batch lie from far below the thresholds to far beyond: early ways out must not show.
            let sizes = [0; 8].map(|_| 10f64.powf(-6.0 + 4.0 * random.unit()));
            let zero = ([Octet::ZERO; 6], [Octet::ZERO; 6], [Octet::ZERO; 14]);
            let mut batches = [zero, zero, zero];
            for step_number in 0..12 {
                let mut strain = [Octet::ZERO; 6];
                for component in &mut strain {
                    for (lane, size) in sizes.iter().enumerate() {
                        component.0[lane] = size * random.symmetric();
                    }
                }
                if round % 7 == 0 && step_number == 5 {
                    // Equal principal values, plain zero, overflow.
                    for (k, component) in strain.iter_mut().enumerate() {
                        component.0[1] = if k < 3 { -1e-4 } else { 0.0 };
                        component.0[4] = 0.0;
                        component.0[6] = 1e300;
                    }
                }
                let dt = if step_number < 2 { 0.0 } else { 1e-5 };
                for (batch, isa) in batches.iter_mut().zip(Isa::ALL) {
                    batch.0 = strain;
                    // SAFETY: only where the instruction set is there.
                    match isa {
                        Isa::Avx2 if isa.available() => unsafe { avx2(&law, dt, batch) },
                        Isa::Avx512 if isa.available() => unsafe { avx512(&law, dt, batch) },
                        _ => step::<f64>(&law, dt, batch),
                    }
                }
                let bits = |b: &Batch| {
                    b.1.iter().chain(&b.2).flat_map(|o| o.0.map(f64::to_bits)).collect::<Vec<_>>()
                };
                let reference = bits(&batches[0]);
                assert_eq!(reference, bits(&batches[1]), "avx2, {law:?}");
                assert_eq!(reference, bits(&batches[2]), "avx512, {law:?}");
            }
        }
    }
}
