//! Eight tensors at once on the widest instruction set of this processor, for who looks at many: the bits are those of one at a time.

use super::eigen::{Eigen, eigen};
use crate::lane::{Isa, Lane, Octet};

/// [`eigen`] of eight tensors, component by component.
pub fn eigen_of_eight(t: &[Octet; 6]) -> Eigen<Octet> {
    let mut found = Eigen { values: [Octet::ZERO; 3], vectors: [[Octet::ZERO; 3]; 3] };
    match Isa::best() {
        // SAFETY: the processor has the instruction set.
        #[cfg(target_arch = "x86_64")]
        Isa::Avx512 => unsafe { instances::avx512(t, &mut found) },
        // SAFETY: as above.
        #[cfg(target_arch = "x86_64")]
        Isa::Avx2 => unsafe { instances::avx2(t, &mut found) },
        _ => all::<f64>(t, &mut found),
    }
    found
}

/// Largest and smallest principal value of each of many tensors (xx, yy, zz, xy, yz, zx; tensor shear).
pub fn extreme_values(tensors: &[[f64; 6]]) -> Vec<[f64; 2]> {
    let mut found = Vec::with_capacity(tensors.len());
    for some in tensors.chunks(8) {
        let mut t = [Octet::ZERO; 6];
        for (lane, tensor) in some.iter().enumerate() {
            t.iter_mut().zip(tensor).for_each(|(octet, x)| octet.0[lane] = *x);
        }
        let [most, _, least] = eigen_of_eight(&t).values;
        found.extend((0..some.len()).map(|lane| [most.0[lane], least.0[lane]]));
    }
    found
}

#[inline(always)]
fn all<L: Lane>(t: &[Octet; 6], found: &mut Eigen<Octet>) {
    let mut at = 0;
    while at < 8 {
        let mut some = [L::splat(0.0); 6];
        for (some, octet) in some.iter_mut().zip(t) {
            *some = L::load(octet, at);
        }
        let Eigen { values, vectors } = eigen(&some);
        for i in 0..3 {
            values[i].store(&mut found.values[i], at);
            for k in 0..3 {
                vectors[i][k].store(&mut found.vectors[i][k], at);
            }
        }
        at += L::WIDTH;
    }
}

#[cfg(target_arch = "x86_64")]
mod instances {
    use super::{Eigen, Octet, all};
    use crate::lane::{Avx2, Avx512, Enabled};

    #[derive(Clone, Copy)]
    struct Here;
    // SAFETY: named below alone, in functions that are called where the instruction set is there.
    unsafe impl Enabled for Here {}

    #[target_feature(enable = "avx512f,avx2,fma")]
    pub(super) unsafe fn avx512(t: &[Octet; 6], found: &mut Eigen<Octet>) {
        all::<Avx512<Here>>(t, found);
    }

    #[target_feature(enable = "avx2,fma")]
    pub(super) unsafe fn avx2(t: &[Octet; 6], found: &mut Eigen<Octet>) {
        all::<Avx2<Here>>(t, found);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sym3::principal_values;

    /// Tensors of every size and with equal values, eight side by side: one at a time has the same bits, and Jacobi's rotations the same values.
    #[test]
    fn eight_at_once_have_the_bits_of_one_and_the_values_of_rotations() {
        let mut seed = 3u64;
        let mut random = || {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        };
        let tensors: Vec<[f64; 6]> = (0..8 * 400 + 5)
            .map(|k| {
                let scale = [1.0, 1e-200, 1e7, 1e150, 0.0][k % 5];
                let shear = if k % 3 == 0 { 0.0 } else { scale };
                let same = scale * random();
                let normal = [0; 3].map(|_| if k % 7 == 0 { same } else { scale * random() });
                let [xy, yz, zx] = [0; 3].map(|_| shear * random());
                [normal[0], normal[1], normal[2], xy, yz, zx]
            })
            .collect();
        let extremes = extreme_values(&tensors);
        assert_eq!(extremes.len(), tensors.len());
        for (some, extremes) in tensors.chunks(8).zip(extremes.chunks(8)) {
            let mut t = [Octet::ZERO; 6];
            for (lane, tensor) in some.iter().enumerate() {
                t.iter_mut().zip(tensor).for_each(|(octet, x)| octet.0[lane] = *x);
            }
            let found = eigen_of_eight(&t);
            for (lane, (tensor, extreme)) in some.iter().zip(extremes).enumerate() {
                let one = eigen(tensor);
                assert_eq!(found.values.map(|value| value.0[lane]), one.values, "{tensor:?}");
                assert_eq!(found.vectors.map(|v| v.map(|x| x.0[lane])), one.vectors, "{tensor:?}");
                assert_eq!(*extreme, [one.values[0], one.values[2]]);
                let rotated = principal_values(tensor);
                let size = tensor.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
                for (a, b) in one.values.iter().zip(rotated) {
                    assert!((a - b).abs() <= 4e-15 * size, "{tensor:?} {a} {b}");
                }
            }
        }
    }

    #[test]
    fn what_is_no_number_stays_none_and_spoils_no_other() {
        let known = [3.0, 1.0, 2.0, 0.5, 0.0, 0.0];
        let mut tensors = vec![known; 8];
        tensors[2][4] = f64::NAN;
        tensors[5][0] = f64::INFINITY;
        let found = extreme_values(&tensors);
        for (lane, extremes) in found.iter().enumerate() {
            match lane {
                2 | 5 => assert!(extremes.iter().all(|x| !x.is_finite()), "{extremes:?}"),
                _ => assert_eq!(*extremes, extreme_values(&[known])[0]),
            }
        }
    }
}
