//! The eigen-decomposition over lanes: residual and orthogonality at round-off for every kind of tensor.

use crate::common::Random;
use tremolite_laws::sym3::{Eigen, Spectrum, eigen, principal_values};

const FULL: [[usize; 3]; 3] = [[0, 3, 5], [3, 1, 4], [5, 4, 2]];

/// Largest of ‖A v_i − λ_i v_i‖ over the largest component of A, and of |v_i·v_j − δ_ij|, in units of ε = 2⁻⁵².
fn defects(t: &[f64; 6], e: &Eigen<f64>) -> (f64, f64) {
    let scale = t.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    let scale = if scale == 0.0 { 1.0 } else { scale };
    let (mut residual, mut skew) = (0.0f64, 0.0f64);
    for i in 0..3 {
        let square: f64 = (0..3)
            .map(|r| {
                // Divided first, so that neither tiny nor huge tensors overflow in the test itself.
                let product: f64 = (0..3).map(|c| t[FULL[r][c]] / scale * e.vectors[i][c]).sum();
                (product - e.values[i] / scale * e.vectors[i][r]).powi(2)
            })
            .sum();
        residual = residual.max(square.sqrt());
        for j in 0..3 {
            let dot: f64 = (0..3).map(|k| e.vectors[i][k] * e.vectors[j][k]).sum();
            skew = skew.max((dot - if i == j { 1.0 } else { 0.0 }).abs());
        }
    }
    (residual / f64::EPSILON, skew / f64::EPSILON)
}

/// Round-off of a dozen operations of size a few times the tensor; measured over these tests 7.2 ε and 4 ε.
fn assert_decomposed(t: &[f64; 6]) {
    let e = eigen(t);
    let (residual, skew) = defects(t, &e);
    assert!(residual <= 10.0 && skew <= 6.0, "{t:?}: residual {residual} ε, orthogonality {skew} ε\n{e:?}");
    assert!(e.values[0] >= e.values[1] && e.values[1] >= e.values[2], "{t:?}: {:?}", e.values);
    let jacobi = principal_values(t);
    let scale = t.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    for i in 0..3 {
        assert!(
            (e.values[i] - jacobi[i]).abs() <= 16.0 * f64::EPSILON * scale,
            "{t:?}: {:?} {jacobi:?}",
            e.values
        );
    }
}

#[test]
fn zero_unit_and_diagonal_tensors() {
    assert_decomposed(&[0.0; 6]);
    assert_eq!(eigen(&[0.0; 6]).values, [0.0; 3]);
    assert_decomposed(&[-0.0; 6]);
    for x in [1.0, -1.0, 1e-300, 1e300, 0.25 * f64::MAX] {
        assert_decomposed(&[x, x, x, 0.0, 0.0, 0.0]);
        assert_decomposed(&[x, 0.0, -x, 0.0, 0.0, 0.0]);
        assert_decomposed(&[x, 0.0, 0.0, 0.0, 0.0, 0.0]);
        assert_decomposed(&[0.0, x, x, 0.0, 0.0, 0.0]);
        for k in 3..6 {
            let mut t = [0.0; 6];
            t[k] = x;
            assert_decomposed(&t);
        }
    }
    assert_decomposed(&[1.0; 6]);
    assert_decomposed(&[-1.0; 6]);
}

#[test]
fn random_tensors_of_every_size_and_shift() {
    let mut random = Random::new(1);
    for scale in [1e-290, 1e-200, 1e-9, 1.0, 1e9, 1e200, 1e307] {
        for shift in [0.0, 1.0, 1e3, 1e8, 1e15, 1e17] {
            if scale * shift > 1e308 {
                continue;
            }
            for _ in 0..2_000 {
                let mut t = [0; 6].map(|_| scale * random.symmetric());
                for c in &mut t[..3] {
                    *c += scale * shift;
                }
                assert_decomposed(&t);
            }
        }
    }
}

#[test]
fn the_ends_of_the_number_range_stay_finite_and_orthogonal() {
    // Below 1e-308 a value has fewer digits than round-off asks for; beyond half the largest number it may overflow.
    let mut random = Random::new(7);
    for scale in [5e-324, 1e-320, 1e-310, 1e307] {
        for _ in 0..2_000 {
            let t = [0; 6].map(|_| scale * random.symmetric());
            let e = eigen(&t);
            assert!(e.values.iter().all(|x| x.is_finite()) && defects(&t, &e).1 <= 16.0, "{t:?} {e:?}");
        }
    }
}

#[test]
fn equal_and_nearly_equal_values_in_random_directions() {
    let mut random = Random::new(2);
    for gap in [0.0, 1e-300, 1e-17, 1e-16, 1e-15, 1e-12, 1e-8, 1e-4] {
        for _ in 0..2_000 {
            let axes = random.rotation();
            let x = random.symmetric();
            for values in
                [[x, 1.0, 1.0 + gap], [1.0, 1.0 + gap, 1.0 - gap], [gap, -gap, x], [x, -x, -x * (1.0 + gap)]]
            {
                let frame = Eigen { values, vectors: axes };
                assert_decomposed(&frame.recompose(values));
            }
        }
    }
}

#[test]
fn components_of_very_different_size() {
    let mut random = Random::new(3);
    for _ in 0..20_000 {
        let t = [0; 6].map(|_| random.symmetric() * 10f64.powf(40.0 * random.symmetric()));
        assert_decomposed(&t);
    }
}

#[test]
fn values_alone_agree_to_the_root_of_round_off() {
    let mut random = Random::new(4);
    for _ in 0..20_000 {
        let t = [0; 6].map(|_| random.symmetric());
        let (quick, full) = (Spectrum::of(&t).values(), eigen(&t).values);
        for i in 0..3 {
            assert!((quick[i] - full[i]).abs() <= 4.0 * f64::EPSILON.sqrt());
        }
    }
}

/// Values, the tensor itself and one of a function that follows its argument no faster (positive parts, as a crack carries pressure alone), made with directions and without.
fn assert_made_alike(t: &[f64; 6]) {
    let (full, axes) = (eigen(t), Spectrum::of(t).axes());
    let scale = t.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    let near = |a: f64, b: f64, times: f64| {
        assert!((a - b).abs() <= times * f64::EPSILON * scale, "{t:?}: {a} {b}\n{full:?}\n{axes:?}");
    };
    for i in 0..3 {
        near(axes.values[i], full.values[i], 16.0);
    }
    assert!(axes.values[0] >= axes.values[1] && axes.values[1] >= axes.values[2], "{t:?}");
    for (made, given) in axes.compose(axes.values).iter().zip(t) {
        near(*made, *given, 64.0);
    }
    let positive = |values: [f64; 3]| values.map(|x| x.max(0.0));
    let with = full.recompose(positive(full.values));
    for (without, with) in axes.compose(positive(axes.values)).iter().zip(with) {
        near(*without, with, 64.0);
    }
    assert_eq!(axes.compose([0.7; 3]), [0.7, 0.7, 0.7, 0.0, 0.0, 0.0]);
}

#[test]
fn tensors_made_without_directions_are_those_with() {
    let mut random = Random::new(11);
    for scale in [1e-80, 1e-9, 1.0, 1e9, 1e80] {
        assert_made_alike(&[scale, scale, scale, 0.0, 0.0, 0.0]);
        for shift in [0.0, 1.0, 1e8] {
            for _ in 0..2_000 {
                let mut t = [0; 6].map(|_| scale * random.symmetric());
                t[..3].iter_mut().for_each(|c| *c += scale * shift);
                assert_made_alike(&t);
            }
        }
    }
    for gap in [0.0, 1e-17, 1e-16, 1e-15, 1e-14, 1e-13, 1e-12, 1e-8, 1e-4] {
        for _ in 0..2_000 {
            let (vectors, x) = (random.rotation(), random.symmetric());
            for values in
                [[x, 1.0, 1.0 + gap], [gap, -gap, x], [x, -x, -x * (1.0 + gap)], [x, 1e-3, 1e-3 - gap]]
            {
                assert_made_alike(&Eigen { values, vectors }.recompose(values));
            }
        }
    }
}

#[test]
fn recomposition_returns_the_tensor() {
    let mut random = Random::new(5);
    for _ in 0..20_000 {
        let t = [0; 6].map(|_| random.symmetric());
        let e = eigen(&t);
        for (back, given) in e.recompose(e.values).into_iter().zip(t) {
            assert!((back - given).abs() <= 16.0 * f64::EPSILON);
        }
    }
}

/// The bits of `eigen` and of the elementary functions on eight tensors.
fn bits<L: tremolite_laws::Lane>(t: &[tremolite_laws::Octet; 6]) -> Vec<[u64; 8]> {
    octets::<L>(t).into_iter().map(|o| o.0.map(f64::to_bits)).collect()
}

#[inline(always)]
fn octets<L: tremolite_laws::Lane>(t: &[tremolite_laws::Octet; 6]) -> [tremolite_laws::Octet; 17] {
    use tremolite_laws::lane::elementary::{exp, ln};
    let mut out = [tremolite_laws::Octet::ZERO; 17];
    let mut at = 0;
    while at < 8 {
        let tensor = [0, 1, 2, 3, 4, 5].map(|k: usize| t[k]);
        let lanes = [
            L::load(&tensor[0], at),
            L::load(&tensor[1], at),
            L::load(&tensor[2], at),
            L::load(&tensor[3], at),
            L::load(&tensor[4], at),
            L::load(&tensor[5], at),
        ];
        let e = eigen(&lanes);
        let quick = Spectrum::of(&lanes).values();
        for i in 0..3 {
            e.values[i].store(&mut out[i], at);
            quick[i].store(&mut out[3 + i], at);
            for k in 0..3 {
                e.vectors[i][k].store(&mut out[6 + 3 * i + k], at);
            }
        }
        exp(lanes[0]).store(&mut out[15], at);
        ln(lanes[1].abs()).store(&mut out[16], at);
        at += L::WIDTH;
    }
    out
}

#[cfg(target_arch = "x86_64")]
#[test]
fn every_width_gives_the_bits_of_the_scalar_reference() {
    use tremolite_laws::lane::{Avx2, Avx512, Enabled};
    use tremolite_laws::{Isa, Octet};

    #[derive(Clone, Copy)]
    struct Here;
    // SAFETY: named in `avx2` and `avx512` alone, which are called where the instruction set is there.
    unsafe impl Enabled for Here {}

    #[target_feature(enable = "avx2,fma")]
    fn avx2(t: &[Octet; 6]) -> Vec<[u64; 8]> {
        bits::<Avx2<Here>>(t)
    }
    #[target_feature(enable = "avx512f,avx2,fma")]
    fn avx512(t: &[Octet; 6]) -> Vec<[u64; 8]> {
        bits::<Avx512<Here>>(t)
    }
    let mut random = Random::new(6);
    for round in 0..2_000 {
        let scale = if round % 3 == 0 { 1e-310 } else { 1.0 };
        let mut t = [Octet::ZERO; 6].map(|_| Octet([0; 8].map(|_| scale * random.symmetric())));
        if round % 5 == 0 {
            t[3] = Octet::ZERO;
            t[4] = Octet::ZERO;
            t[0].0[3] = f64::NAN;
            t[1].0[2] = f64::INFINITY;
        }
        let reference = bits::<f64>(&t);
        // SAFETY: only where the instruction set is there.
        if Isa::Avx2.available() {
            assert!(same(&reference, &unsafe { avx2(&t) }));
        }
        if Isa::Avx512.available() {
            assert!(same(&reference, &unsafe { avx512(&t) }));
        }
    }
    // The sign and payload of a NaN are the hardware's business.
    fn same(a: &[[u64; 8]], b: &[[u64; 8]]) -> bool {
        let flat = |v: &[[u64; 8]]| v.iter().flatten().copied().collect::<Vec<_>>();
        flat(a)
            .into_iter()
            .zip(flat(b))
            .all(|(x, y)| x == y || (f64::from_bits(x).is_nan() && f64::from_bits(y).is_nan()))
    }
}
