//! Every register width gives the rock laws the bits of the scalar reference, lane by lane.
#![cfg(target_arch = "x86_64")]

use crate::common::Random;
use crate::common::rock::*;
use tremolite_laws::lane::{Avx2, Avx512, Lane};
use tremolite_laws::materials::{DruckerPrager, HoekBrown, MohrCoulomb};
use tremolite_laws::{History, Isa, Material, Octet, Point};

const COLUMNS: usize = 10;

/// Strain in, stress out, history in place.
type Batch = ([Octet; 6], [Octet; 6], [Octet; COLUMNS]);

#[inline(always)]
fn step<L: Lane, M: Material>(law: &M, (strain, stress, history): &mut Batch) {
    let mut at = 0;
    while at < 8 {
        let mut e = [L::splat(0.0); 6];
        let mut h = <M::History<L> as History<L>>::zero();
        for k in 0..6 {
            e[k] = L::load(&strain[k], at);
        }
        for (value, octet) in h.as_mut().iter_mut().zip(&*history) {
            *value = L::load(octet, at);
        }
        let (s, h) = law.update(&Point::new(L::splat(1e-5)), e, h);
        for k in 0..6 {
            s[k].store(&mut stress[k], at);
        }
        for (value, octet) in h.as_ref().iter().zip(&mut *history) {
            value.store(octet, at);
        }
        at += L::WIDTH;
    }
}

#[target_feature(enable = "avx2,fma")]
fn avx2<M: Material>(law: &M, batch: &mut Batch) {
    step::<Avx2, M>(law, batch);
}

#[target_feature(enable = "avx512f,avx2,fma")]
fn avx512<M: Material>(law: &M, batch: &mut Batch) {
    step::<Avx512, M>(law, batch);
}

fn assert_same_bits<M: Material>(law: &M, seed: u64) {
    assert_eq!(M::HISTORY.len(), COLUMNS);
    let mut random = Random::new(seed);
    for round in 0..80 {
        // Lanes of one batch lie from far inside the surface to far beyond: early ways out must not show.
        let sizes = [0; 8].map(|_| 10f64.powf(-5.5 + 3.5 * random.unit()));
        let zero = ([Octet::ZERO; 6], [Octet::ZERO; 6], [Octet::ZERO; COLUMNS]);
        let mut batches = [zero; 3];
        for step_number in 0..12 {
            let mut strain = [Octet::ZERO; 6];
            for (lane, size) in sizes.iter().enumerate() {
                for (k, x) in random_strain(&mut random, *size).into_iter().enumerate() {
                    strain[k].0[lane] = x;
                }
            }
            if round % 7 == 0 && step_number == 5 {
                // Equal principal values, plain zero, overflow, not a number.
                for (k, component) in strain.iter_mut().enumerate() {
                    component.0[1] = if k < 3 { 1e-3 } else { 0.0 };
                    component.0[4] = 0.0;
                    component.0[6] = 1e300;
                    component.0[7] = f64::NAN;
                }
            }
            for (batch, isa) in batches.iter_mut().zip(Isa::ALL) {
                batch.0 = strain;
                // SAFETY: only where the instruction set is there.
                match isa {
                    Isa::Avx2 if isa.available() => unsafe { avx2(law, batch) },
                    Isa::Avx512 if isa.available() => unsafe { avx512(law, batch) },
                    _ => step::<f64, M>(law, batch),
                }
            }
            // A NaN's sign and payload are no result.
            let bits = |b: &Batch| {
                let plain = |x: f64| if x.is_nan() { 0x7ff8 << 48 } else { x.to_bits() };
                b.1.iter().chain(&b.2).flat_map(|o| o.0.map(plain)).collect::<Vec<_>>()
            };
            let reference = bits(&batches[0]);
            assert_eq!(reference, bits(&batches[1]), "avx2, {}", M::NAME);
            assert_eq!(reference, bits(&batches[2]), "avx512, {}", M::NAME);
        }
        // A strain that is no number leaves no trace once it is one again.
        let finite = |o: &Octet| o.0.iter().all(|x| x.is_finite());
        assert!(batches[0].1.iter().chain(&batches[0].2).all(finite), "{}", M::NAME);
    }
}

#[test]
fn every_width_gives_the_bits_of_the_scalar_reference() {
    let cone = mohr_coulomb(2.18e6, 42.0, 10.0, 1e6);
    assert_same_bits(&MohrCoulomb::new(&cone).unwrap(), 1);
    assert_same_bits(&MohrCoulomb::new(&mohr_coulomb(1e6, 0.0, 0.0, 0.0)).unwrap(), 2);
    let soft = cone.clone().with_table(
        "softening",
        &[
            ("plastic_shear_strain", &[0.0, 1e-3, 5e-3]),
            ("plastic_tension_strain", &[0.0, 1e-4, 1e-3]),
            ("cohesion", &[2.18e6, 1e6, 0.5e6]),
            ("friction_angle", &[42f64.to_radians(), 0.8, 0.5]),
            ("dilation_angle", &[10f64.to_radians(), 0.1, 0.0]),
            ("tensile_strength", &[1e6, 2e5, 0.0]),
        ],
    );
    assert_same_bits(&MohrCoulomb::new(&soft).unwrap(), 3);
    for fit in ["outer", "inner", "plane-strain"] {
        assert_same_bits(&DruckerPrager::new(&with_word(cone.clone(), "fit", fit)).unwrap(), 4);
    }
    for (gsi, psi) in [(60.0, 0.0), (100.0, 0.2), (12.0, 0.6)] {
        let mass = rock(&[("ucs", 60e6), ("gsi", gsi), ("m_i", 12.0), ("dilation_angle", psi)]);
        assert_same_bits(&HoekBrown::new(&mass).unwrap(), 5);
        assert_same_bits(&HoekBrown::new(&mass.with("tensile_strength", 1e4)).unwrap(), 6);
    }
}
