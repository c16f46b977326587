//! Lanes in AVX2 and AVX-512 registers.
//!
//! The operations may only be reached from functions that enable the instruction set: whoever names the lanes promises so
//! ([`Enabled`]), and [`Isa::available`] guards every call of such a function. Under `#[inline(always)]` they become single
//! instructions there.
//!
//! [`Isa::available`]: super::Isa::available

use super::bits::{EXPONENT_BIAS, FRACTION, TWO_52};
use super::{Lane, Octet, Row};
use core::arch::x86_64::*;
use core::marker::PhantomData;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// A promise, by a type that stands for nothing else, about where its author uses wide lanes.
///
/// Operations of lanes are safe to call, and no processor without the instruction set may meet one; so there are no lanes
/// without a type that has promised:
///
/// ```
/// use tremolite_laws::lane::{Avx2, Enabled};
/// use tremolite_laws::{Isa, Lane, Octet};
///
/// #[derive(Clone, Copy)]
/// struct Here;
/// // SAFETY: named in `double` alone.
/// unsafe impl Enabled for Here {}
///
/// #[target_feature(enable = "avx2,fma")]
/// fn double(x: &mut Octet) {
///     for at in [0, 4] {
///         let half = Avx2::<Here>::load(x, at);
///         (half + half).store(x, at);
///     }
/// }
///
/// let mut x = Octet([1.0; 8]);
/// if Isa::Avx2.available() {
///     // SAFETY: the processor has it.
///     unsafe { double(&mut x) };
///     assert_eq!(x, Octet([2.0; 8]));
/// }
/// ```
///
/// ```compile_fail,E0277
/// use tremolite_laws::lane::{Avx2, Lane};
///
/// #[derive(Clone, Copy)]
/// struct Anywhere;
/// let _ = Avx2::<Anywhere>::splat(1.0);
/// ```
///
/// # Safety
/// Lanes with this type are named only in functions that enable the lanes' instruction set and what is inlined into them,
/// and these functions are called only where the processor has it.
pub unsafe trait Enabled: Copy + 'static {}

/// Four lanes in one 256-bit register.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub struct Avx2<P>(__m256d, PhantomData<P>);

/// Eight lanes in one 512-bit register.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub struct Avx512<P>(__m512d, PhantomData<P>);

macro_rules! operators {
    ($lane:ident($register:ident), $add:ident, $sub:ident, $mul:ident, $div:ident, $splat:ident) => {
        impl<P: Enabled> $lane<P> {
            #[inline(always)]
            fn of(register: $register) -> Self {
                $lane(register, PhantomData)
            }
        }
        operators!(@ $lane, Add, add, $add);
        operators!(@ $lane, Sub, sub, $sub);
        operators!(@ $lane, Mul, mul, $mul);
        operators!(@ $lane, Div, div, $div);
        impl<P: Enabled> Neg for $lane<P> {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                // SAFETY: reached only where the instruction set is enabled (module documentation).
                // Subtraction from −0 flips the sign of every number, zeros included.
                unsafe { Self::of($sub($splat(-0.0), self.0)) }
            }
        }
    };
    (@ $lane:ident, $trait:ident, $function:ident, $intrinsic:ident) => {
        impl<P: Enabled> $trait for $lane<P> {
            type Output = Self;
            #[inline(always)]
            fn $function(self, other: Self) -> Self {
                // SAFETY: reached only where the instruction set is enabled (module documentation).
                unsafe { Self::of($intrinsic(self.0, other.0)) }
            }
        }
    };
}

operators!(Avx2(__m256d), _mm256_add_pd, _mm256_sub_pd, _mm256_mul_pd, _mm256_div_pd, _mm256_set1_pd);
operators!(Avx512(__m512d), _mm512_add_pd, _mm512_sub_pd, _mm512_mul_pd, _mm512_div_pd, _mm512_set1_pd);

/// Rows a, b, c, d to columns x, y, z, w; its own inverse.
#[inline(always)]
unsafe fn transpose(rows: [__m256d; 4]) -> [__m256d; 4] {
    // SAFETY: reached only where AVX2 is enabled.
    unsafe {
        let xz_ab = _mm256_unpacklo_pd(rows[0], rows[1]);
        let yw_ab = _mm256_unpackhi_pd(rows[0], rows[1]);
        let xz_cd = _mm256_unpacklo_pd(rows[2], rows[3]);
        let yw_cd = _mm256_unpackhi_pd(rows[2], rows[3]);
        [
            _mm256_permute2f128_pd::<0x20>(xz_ab, xz_cd),
            _mm256_permute2f128_pd::<0x20>(yw_ab, yw_cd),
            _mm256_permute2f128_pd::<0x31>(xz_ab, xz_cd),
            _mm256_permute2f128_pd::<0x31>(yw_ab, yw_cd),
        ]
    }
}

#[inline(always)]
unsafe fn load_row(rows: &[Row], index: u16) -> __m256d {
    debug_assert!((index as usize) < rows.len());
    // SAFETY: the caller keeps the index in range; rows are aligned to 32 bytes.
    unsafe { _mm256_load_pd(rows.as_ptr().add(index as usize).cast()) }
}

#[inline(always)]
unsafe fn load_two_rows(rows: &[Row], low: u16, high: u16) -> __m512d {
    // SAFETY: the caller keeps the indices in range and AVX-512F is enabled.
    unsafe {
        let low = _mm512_castpd256_pd512(load_row(rows, low));
        _mm512_insertf64x4::<1>(low, load_row(rows, high))
    }
}

#[inline(always)]
unsafe fn add_to_row(rows: &mut [Row], index: u16, vector: __m256d) {
    debug_assert!((index as usize) < rows.len());
    // SAFETY: the caller keeps the index in range; rows are aligned to 32 bytes.
    unsafe {
        let row: *mut f64 = rows.as_mut_ptr().add(index as usize).cast();
        _mm256_store_pd(row, _mm256_add_pd(_mm256_load_pd(row), vector));
    }
}

impl<P: Enabled> Lane for Avx2<P> {
    type Mask = __m256d;
    const WIDTH: usize = 4;

    #[inline(always)]
    fn splat(x: f64) -> Self {
        // SAFETY: reached only where AVX2 is enabled; so below.
        unsafe { Self::of(_mm256_set1_pd(x)) }
    }
    #[inline(always)]
    fn load(from: &Octet, at: usize) -> Self {
        debug_assert!(at == 0 || at == 4);
        // SAFETY: as of `splat`.
        unsafe { Self::of(_mm256_load_pd(from.0.as_ptr().add(at & 4))) }
    }
    #[inline(always)]
    fn store(self, to: &mut Octet, at: usize) {
        debug_assert!(at == 0 || at == 4);
        // SAFETY: as of `splat`.
        unsafe { _mm256_store_pd(to.0.as_mut_ptr().add(at & 4), self.0) }
    }
    #[inline(always)]
    fn mul_add(self, b: Self, c: Self) -> Self {
        // SAFETY: as of `splat`.
        unsafe { Self::of(_mm256_fmadd_pd(self.0, b.0, c.0)) }
    }
    #[inline(always)]
    fn neg_mul_add(self, b: Self, c: Self) -> Self {
        // SAFETY: as of `splat`.
        unsafe { Self::of(_mm256_fnmadd_pd(self.0, b.0, c.0)) }
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        // SAFETY: as of `splat`.
        unsafe { Self::of(_mm256_sqrt_pd(self.0)) }
    }
    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: as of `splat`.
        unsafe { Self::of(_mm256_andnot_pd(_mm256_set1_pd(-0.0), self.0)) }
    }
    #[inline(always)]
    fn less(self, other: Self) -> __m256d {
        // SAFETY: as of `splat`.
        unsafe { _mm256_cmp_pd::<_CMP_LT_OQ>(self.0, other.0) }
    }
    #[inline(always)]
    fn select(mask: __m256d, yes: Self, no: Self) -> Self {
        // SAFETY: as of `splat`.
        unsafe { Self::of(_mm256_blendv_pd(no.0, yes.0, mask)) }
    }
    #[inline(always)]
    fn any(mask: __m256d) -> bool {
        // SAFETY: as of `splat`.
        unsafe { _mm256_movemask_pd(mask) != 0 }
    }
    #[inline(always)]
    fn both(a: __m256d, b: __m256d) -> __m256d {
        // SAFETY: as of `splat`.
        unsafe { _mm256_and_pd(a, b) }
    }
    #[inline(always)]
    fn either(a: __m256d, b: __m256d) -> __m256d {
        // SAFETY: as of `splat`.
        unsafe { _mm256_or_pd(a, b) }
    }
    #[inline(always)]
    fn not(mask: __m256d) -> __m256d {
        // SAFETY: as of `splat`.
        unsafe { _mm256_xor_pd(mask, _mm256_castsi256_pd(_mm256_set1_epi64x(-1))) }
    }
    #[inline(always)]
    fn exponent(self) -> Self {
        // SAFETY: as of `splat`.
        unsafe {
            let shifted = _mm256_castsi256_pd(_mm256_srli_epi64::<52>(_mm256_castpd_si256(self.0)));
            let integer = _mm256_or_pd(shifted, _mm256_set1_pd(TWO_52));
            Self::of(_mm256_sub_pd(integer, _mm256_set1_pd(EXPONENT_BIAS)))
        }
    }
    #[inline(always)]
    fn significand(self) -> Self {
        // SAFETY: as of `splat`.
        unsafe {
            let fraction = _mm256_and_pd(self.0, _mm256_castsi256_pd(_mm256_set1_epi64x(FRACTION as i64)));
            Self::of(_mm256_or_pd(fraction, _mm256_set1_pd(1.0)))
        }
    }
    #[inline(always)]
    fn power_of_two(self) -> Self {
        // SAFETY: as of `splat`.
        unsafe {
            let biased = _mm256_castpd_si256(_mm256_add_pd(self.0, _mm256_set1_pd(EXPONENT_BIAS)));
            Self::of(_mm256_castsi256_pd(_mm256_slli_epi64::<52>(biased)))
        }
    }
    #[inline(always)]
    unsafe fn gather(rows: &[Row], index: &[u16; 8], at: usize) -> [Self; 3] {
        // SAFETY: as of `splat`.
        unsafe {
            let [x, y, z, _] = transpose([
                load_row(rows, index[at]),
                load_row(rows, index[at + 1]),
                load_row(rows, index[at + 2]),
                load_row(rows, index[at + 3]),
            ]);
            [Self::of(x), Self::of(y), Self::of(z)]
        }
    }
    #[inline(always)]
    unsafe fn scatter_add(rows: &mut [Row], index: &[u16; 8], vector: &[Octet; 3]) {
        // SAFETY: as of `splat`.
        unsafe {
            for at in [0, 4] {
                let x = _mm256_load_pd(vector[0].0.as_ptr().add(at));
                let y = _mm256_load_pd(vector[1].0.as_ptr().add(at));
                let z = _mm256_load_pd(vector[2].0.as_ptr().add(at));
                let lanes = transpose([x, y, z, _mm256_setzero_pd()]);
                add_to_row(rows, index[at], lanes[0]);
                add_to_row(rows, index[at + 1], lanes[1]);
                add_to_row(rows, index[at + 2], lanes[2]);
                add_to_row(rows, index[at + 3], lanes[3]);
            }
        }
    }
}

impl<P: Enabled> Lane for Avx512<P> {
    type Mask = __mmask8;
    const WIDTH: usize = 8;

    #[inline(always)]
    fn splat(x: f64) -> Self {
        // SAFETY: reached only where AVX-512F is enabled; so below.
        unsafe { Self::of(_mm512_set1_pd(x)) }
    }
    #[inline(always)]
    fn load(from: &Octet, _: usize) -> Self {
        // SAFETY: as of `splat`.
        unsafe { Self::of(_mm512_load_pd(from.0.as_ptr())) }
    }
    #[inline(always)]
    fn store(self, to: &mut Octet, _: usize) {
        // SAFETY: as of `splat`.
        unsafe { _mm512_store_pd(to.0.as_mut_ptr(), self.0) }
    }
    #[inline(always)]
    fn mul_add(self, b: Self, c: Self) -> Self {
        // SAFETY: as of `splat`.
        unsafe { Self::of(_mm512_fmadd_pd(self.0, b.0, c.0)) }
    }
    #[inline(always)]
    fn neg_mul_add(self, b: Self, c: Self) -> Self {
        // SAFETY: as of `splat`.
        unsafe { Self::of(_mm512_fnmadd_pd(self.0, b.0, c.0)) }
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        // SAFETY: as of `splat`.
        unsafe { Self::of(_mm512_sqrt_pd(self.0)) }
    }
    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: as of `splat`.
        unsafe { Self::of(_mm512_abs_pd(self.0)) }
    }
    #[inline(always)]
    fn less(self, other: Self) -> __mmask8 {
        // SAFETY: as of `splat`.
        unsafe { _mm512_cmp_pd_mask::<_CMP_LT_OQ>(self.0, other.0) }
    }
    #[inline(always)]
    fn select(mask: __mmask8, yes: Self, no: Self) -> Self {
        // SAFETY: as of `splat`.
        unsafe { Self::of(_mm512_mask_blend_pd(mask, no.0, yes.0)) }
    }
    #[inline(always)]
    fn any(mask: __mmask8) -> bool {
        mask != 0
    }
    #[inline(always)]
    fn both(a: __mmask8, b: __mmask8) -> __mmask8 {
        a & b
    }
    #[inline(always)]
    fn either(a: __mmask8, b: __mmask8) -> __mmask8 {
        a | b
    }
    #[inline(always)]
    fn not(mask: __mmask8) -> __mmask8 {
        !mask
    }
    #[inline(always)]
    fn exponent(self) -> Self {
        // SAFETY: as of `splat`.
        unsafe {
            let shifted = _mm512_srli_epi64::<52>(_mm512_castpd_si512(self.0));
            let integer = _mm512_or_si512(shifted, _mm512_castpd_si512(_mm512_set1_pd(TWO_52)));
            Self::of(_mm512_sub_pd(_mm512_castsi512_pd(integer), _mm512_set1_pd(EXPONENT_BIAS)))
        }
    }
    #[inline(always)]
    fn significand(self) -> Self {
        // SAFETY: as of `splat`.
        unsafe {
            let fraction = _mm512_and_si512(_mm512_castpd_si512(self.0), _mm512_set1_epi64(FRACTION as i64));
            let one = _mm512_castpd_si512(_mm512_set1_pd(1.0));
            Self::of(_mm512_castsi512_pd(_mm512_or_si512(fraction, one)))
        }
    }
    #[inline(always)]
    fn power_of_two(self) -> Self {
        // SAFETY: as of `splat`.
        unsafe {
            let biased = _mm512_castpd_si512(_mm512_add_pd(self.0, _mm512_set1_pd(EXPONENT_BIAS)));
            Self::of(_mm512_castsi512_pd(_mm512_slli_epi64::<52>(biased)))
        }
    }
    #[inline(always)]
    unsafe fn gather(rows: &[Row], index: &[u16; 8], _: usize) -> [Self; 3] {
        // SAFETY: as of `splat`.
        unsafe {
            // Lanes l and l + 4 share a register; unpacking pairs of them leaves x and z in the even half, y in
            // the odd one, and one permutation of two registers puts eight lanes in order.
            let r0 = load_two_rows(rows, index[0], index[4]);
            let r1 = load_two_rows(rows, index[1], index[5]);
            let r2 = load_two_rows(rows, index[2], index[6]);
            let r3 = load_two_rows(rows, index[3], index[7]);
            let (xz01, y01) = (_mm512_unpacklo_pd(r0, r1), _mm512_unpackhi_pd(r0, r1));
            let (xz23, y23) = (_mm512_unpacklo_pd(r2, r3), _mm512_unpackhi_pd(r2, r3));
            let first = _mm512_set_epi64(13, 12, 5, 4, 9, 8, 1, 0);
            let second = _mm512_set_epi64(15, 14, 7, 6, 11, 10, 3, 2);
            [
                Self::of(_mm512_permutex2var_pd(xz01, first, xz23)),
                Self::of(_mm512_permutex2var_pd(y01, first, y23)),
                Self::of(_mm512_permutex2var_pd(xz01, second, xz23)),
            ]
        }
    }
    #[inline(always)]
    unsafe fn scatter_add(rows: &mut [Row], index: &[u16; 8], vector: &[Octet; 3]) {
        // SAFETY: as of `splat`.
        unsafe {
            let x = _mm512_load_pd(vector[0].0.as_ptr());
            let y = _mm512_load_pd(vector[1].0.as_ptr());
            let z = _mm512_load_pd(vector[2].0.as_ptr());
            let zero = _mm512_setzero_pd();
            let (xy_even, xy_odd) = (_mm512_unpacklo_pd(x, y), _mm512_unpackhi_pd(x, y));
            let (z_even, z_odd) = (_mm512_unpacklo_pd(z, zero), _mm512_unpackhi_pd(z, zero));
            let first = _mm512_set_epi64(13, 12, 5, 4, 9, 8, 1, 0);
            let second = _mm512_set_epi64(15, 14, 7, 6, 11, 10, 3, 2);
            let r0 = _mm512_permutex2var_pd(xy_even, first, z_even);
            let r1 = _mm512_permutex2var_pd(xy_odd, first, z_odd);
            let r2 = _mm512_permutex2var_pd(xy_even, second, z_even);
            let r3 = _mm512_permutex2var_pd(xy_odd, second, z_odd);
            add_to_row(rows, index[0], _mm512_castpd512_pd256(r0));
            add_to_row(rows, index[1], _mm512_castpd512_pd256(r1));
            add_to_row(rows, index[2], _mm512_castpd512_pd256(r2));
            add_to_row(rows, index[3], _mm512_castpd512_pd256(r3));
            add_to_row(rows, index[4], _mm512_extractf64x4_pd::<1>(r0));
            add_to_row(rows, index[5], _mm512_extractf64x4_pd::<1>(r1));
            add_to_row(rows, index[6], _mm512_extractf64x4_pd::<1>(r2));
            add_to_row(rows, index[7], _mm512_extractf64x4_pd::<1>(r3));
        }
    }
}
