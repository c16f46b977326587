//! Every register width gives every interface law the bits of the scalar reference, lane by lane.
#![cfg(target_arch = "x86_64")]

use crate::common::Random;
use crate::common::pair::{each_sample, on_every_interface, wandering};
use tremolite_laws::lane::{Avx2, Avx512, Enabled, Lane};
use tremolite_laws::{History, Interface, Isa, Octet};

/// Gap and slip in, traction and stored energy out, history in place.
#[derive(Clone)]
struct Batch {
    motion: [Octet; 3],
    answer: [Octet; 4],
    history: Vec<Octet>,
}

#[inline(always)]
fn step<L: Lane, I: Interface>(law: &I, batch: &mut Batch) {
    let mut at = 0;
    while at < 8 {
        let [gap, first, second] = [0, 1, 2].map(|k| L::load(&batch.motion[k], at));
        let mut h = <I::History<L> as History<L>>::zero();
        for (value, octet) in h.as_mut().iter_mut().zip(&batch.history) {
            *value = L::load(octet, at);
        }
        let (pressure, shear, h) = law.update(gap, [first, second], h);
        let stored = law.stored_energy(gap, shear, &h);
        for (k, value) in [pressure, shear[0], shear[1], stored].into_iter().enumerate() {
            value.store(&mut batch.answer[k], at);
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
fn avx2<I: Interface>(law: &I, batch: &mut Batch) {
    step::<Avx2<Here>, I>(law, batch);
}

#[target_feature(enable = "avx512f,avx2,fma")]
fn avx512<I: Interface>(law: &I, batch: &mut Batch) {
    step::<Avx512<Here>, I>(law, batch);
}

fn same_bits<I: Interface>() {
    let mut random = Random::new(22);
    each_sample::<I>(|law, sample| {
        let zero = Batch {
            motion: [Octet::ZERO; 3],
            answer: [Octet::ZERO; 4],
            history: vec![Octet::ZERO; I::HISTORY.len()],
        };
        let mut batches = [zero.clone(), zero.clone(), zero];
        // Eight pairs side by side in unlike states: bonds break in one lane while the next is open.
        let paths = [0; 8].map(|_| wandering(law, &mut random, 1500));
        for row in 0..=1500 {
            let mut motion = [Octet::ZERO; 3];
            for (lane, path) in paths.iter().enumerate() {
                let (gap, slip) = path[row];
                (motion[0].0[lane], motion[1].0[lane], motion[2].0[lane]) = (gap, slip[0], slip[1]);
            }
            if row > 1480 {
                // Far beyond anything, plain zero, not a number.
                (motion[0].0[1], motion[0].0[2], motion[0].0[3]) = (1e300, -1e300, 0.0);
                (motion[0].0[6], motion[1].0[7]) = (f64::NAN, f64::NAN);
            }
            for (batch, isa) in batches.iter_mut().zip(Isa::ALL) {
                batch.motion = motion;
                // SAFETY: only where the instruction set is there.
                match isa {
                    Isa::Avx2 if isa.available() => unsafe { avx2(law, batch) },
                    Isa::Avx512 if isa.available() => unsafe { avx512(law, batch) },
                    _ => step::<f64, I>(law, batch),
                }
            }
            // A NaN's sign and payload are no result.
            let bits = |b: &Batch| {
                let plain = |x: f64| if x.is_nan() { 0x7ff8 << 48 } else { x.to_bits() };
                b.answer.iter().chain(&b.history).flat_map(|o| o.0.map(plain)).collect::<Vec<_>>()
            };
            let reference = bits(&batches[0]);
            assert_eq!(reference, bits(&batches[1]), "avx2, {} {}, row {row}", I::NAME, sample.variant);
            assert_eq!(reference, bits(&batches[2]), "avx512, {} {}, row {row}", I::NAME, sample.variant);
        }
    });
}

#[test]
fn every_width_gives_every_interface_law_the_bits_of_the_scalar_reference() {
    on_every_interface!($ same_bits);
}
