//! Every register width gives every law the bits of the scalar reference, lane by lane.
#![cfg(target_arch = "x86_64")]

use crate::common::Random;
use crate::common::concrete::all_variants;
use crate::common::rock::random_strain;
use crate::common::samples::samples;
use tremolite_laws::lane::{Avx2, Avx512, Enabled, Lane};
use tremolite_laws::{History, Isa, Material, Octet, Point, for_each_material};

/// Strain in, stress out, history in place.
#[derive(Clone)]
struct Batch {
    strain: [Octet; 6],
    stress: [Octet; 6],
    history: Vec<Octet>,
}

#[inline(always)]
fn step<L: Lane, M: Material>(law: &M, dt: f64, batch: &mut Batch) {
    let mut at = 0;
    while at < 8 {
        let mut point = Point::new(L::splat(dt));
        for (k, g) in [0.09, 0.16, 0.25, 0.01, -0.02, 0.03].into_iter().enumerate() {
            point.size[k] = L::splat(g);
        }
        let mut e = [L::splat(0.0); 6];
        let mut h = <M::History<L> as History<L>>::zero();
        for k in 0..6 {
            e[k] = L::load(&batch.strain[k], at);
        }
        for (value, octet) in h.as_mut().iter_mut().zip(&batch.history) {
            *value = L::load(octet, at);
        }
        let (s, h) = law.update(&point, e, h);
        for k in 0..6 {
            s[k].store(&mut batch.stress[k], at);
        }
        for (value, octet) in h.as_ref().iter().zip(&mut batch.history) {
            value.store(octet, at);
        }
        at += L::WIDTH;
    }
}

#[derive(Clone, Copy)]
struct Here;
// SAFETY: named in `avx2` and `avx512` alone, which are called where the instruction set is there.
unsafe impl Enabled for Here {}

#[target_feature(enable = "avx2,fma")]
fn avx2<M: Material>(law: &M, dt: f64, batch: &mut Batch) {
    step::<Avx2<Here>, M>(law, dt, batch);
}

#[target_feature(enable = "avx512f,avx2,fma")]
fn avx512<M: Material>(law: &M, dt: f64, batch: &mut Batch) {
    step::<Avx512<Here>, M>(law, dt, batch);
}

/// `forgets`: a strain that is no number leaves no trace once it is one again.
fn assert_same_bits<M: Material>(law: &M, which: &str, forgets: bool) {
    let mut random = Random::new(21);
    for round in 0..60 {
        // Lanes of one batch lie from far inside the elastic range to far beyond: early ways out must not show.
        let sizes = [0; 8].map(|_| 10f64.powf(-6.0 + 4.0 * random.unit()));
        let zero = Batch {
            strain: [Octet::ZERO; 6],
            stress: [Octet::ZERO; 6],
            history: vec![Octet::ZERO; M::HISTORY.len()],
        };
        let mut batches = [zero.clone(), zero.clone(), zero];
        for step_number in 0..12 {
            let mut strain = [Octet::ZERO; 6];
            for (lane, size) in sizes.iter().enumerate() {
                for (k, x) in random_strain(&mut random, *size).into_iter().enumerate() {
                    strain[k].0[lane] = x;
                }
            }
            if round % 7 == 0 && step_number == 5 {
                // Equal principal values of either sign, plain zero, overflow, not a number.
                for (k, component) in strain.iter_mut().enumerate() {
                    component.0[1] = if k < 3 { 1e-3 } else { 0.0 };
                    component.0[2] = if k < 3 { -1e-4 } else { 0.0 };
                    component.0[4] = 0.0;
                    component.0[6] = 1e300;
                    component.0[7] = f64::NAN;
                }
            }
            let dt = if step_number < 2 { 0.0 } else { 1e-5 };
            for (batch, isa) in batches.iter_mut().zip(Isa::ALL) {
                batch.strain = strain;
                // SAFETY: only where the instruction set is there.
                match isa {
                    Isa::Avx2 if isa.available() => unsafe { avx2(law, dt, batch) },
                    Isa::Avx512 if isa.available() => unsafe { avx512(law, dt, batch) },
                    _ => step::<f64, M>(law, dt, batch),
                }
            }
            // A NaN's sign and payload are no result.
            let bits = |b: &Batch| {
                let plain = |x: f64| if x.is_nan() { 0x7ff8 << 48 } else { x.to_bits() };
                b.stress.iter().chain(&b.history).flat_map(|o| o.0.map(plain)).collect::<Vec<_>>()
            };
            let reference = bits(&batches[0]);
            assert_eq!(reference, bits(&batches[1]), "avx2, {} {which}", M::NAME);
            assert_eq!(reference, bits(&batches[2]), "avx512, {} {which}", M::NAME);
        }
        let finite = |o: &Octet| o.0.iter().all(|x| x.is_finite());
        let left = batches[0].stress.iter().chain(&batches[0].history);
        assert!(!forgets || left.into_iter().all(finite), "{} {which}", M::NAME);
    }
}

macro_rules! each {
    ($($law:ty,)*) => {
        $(for sample in samples(<$law>::NAME) {
            assert_same_bits(&<$law>::new(&sample.values()).unwrap(), sample.variant, true);
        })*
    };
}

#[test]
fn every_width_gives_every_law_the_bits_of_the_scalar_reference() {
    for_each_material!(each);
}

/// Concrete takes many ways through its update, by its words. A rate's filter goes on from what it was, a NaN included.
#[test]
fn every_width_gives_every_variant_of_concrete_the_bits_of_the_scalar_reference() {
    for law in all_variants() {
        assert_same_bits(&law, &format!("{law:?}"), false);
    }
}
