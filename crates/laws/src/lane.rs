//! Lanes: one number, or several in lock-step, behind one set of operations.
//!
//! A kernel is written once over [`Lane`] and instantiated inside one `#[target_feature]` function per instruction
//! set ([`Isa`]). Every function below such an instance is `#[inline(always)]`; one that is not falls out of the
//! feature context, keeps its bits and loses most of its speed. All instances give the same bits: the operations
//! are the IEEE ones, `mul_add` is fused everywhere, and comparisons select instead of branching.

use core::ops::{Add, Div, Mul, Neg, Sub};

/// Eight values side by side, the unit in which element data is stored whatever the register width.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C, align(64))]
pub struct Octet(pub [f64; 8]);

impl Octet {
    pub const ZERO: Octet = Octet([0.0; 8]);
}

/// A vector at a node, x, y, z and a zero, so that a node is one aligned 256-bit load.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C, align(32))]
pub struct Row(pub [f64; 4]);

impl Row {
    pub const ZERO: Row = Row([0.0; 4]);

    pub fn new(v: [f64; 3]) -> Self {
        Row([v[0], v[1], v[2], 0.0])
    }

    pub fn xyz(&self) -> [f64; 3] {
        [self.0[0], self.0[1], self.0[2]]
    }
}

/// One f64, or [`Lane::WIDTH`] of them in lock-step.
pub trait Lane:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + 'static
{
    /// Result of a comparison, lane by lane.
    type Mask: Copy;
    const WIDTH: usize;

    fn splat(x: f64) -> Self;
    /// Values `at .. at + WIDTH` of an octet; `at` is a multiple of the width.
    fn load(from: &Octet, at: usize) -> Self;
    fn store(self, to: &mut Octet, at: usize);
    /// `self * b + c` with one rounding.
    fn mul_add(self, b: Self, c: Self) -> Self;
    /// `c - self * b` with one rounding.
    fn neg_mul_add(self, b: Self, c: Self) -> Self;
    fn sqrt(self) -> Self;
    fn abs(self) -> Self;
    fn less(self, other: Self) -> Self::Mask;
    /// `yes` where the mask is set, else `no`.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
    /// Whether any lane is set: the one thing to branch on, and to pass over work alone. Whoever skips work by it leaves
    /// every lane what it would be with the work done, so that the bits do not depend on which lanes lie side by side.
    fn any(mask: Self::Mask) -> bool;
    /// Where both masks are set.
    fn both(a: Self::Mask, b: Self::Mask) -> Self::Mask;
    /// Where at least one of two masks is set.
    fn either(a: Self::Mask, b: Self::Mask) -> Self::Mask;
    /// Where the mask is not set.
    fn not(mask: Self::Mask) -> Self::Mask;
    /// The binary exponent of a positive normal number, ⌊log₂ x⌋; meaningless for any other.
    fn exponent(self) -> Self;
    /// The number over the power of two that [`Lane::exponent`] stands for, in \[1, 2); meaningless where that is.
    fn significand(self) -> Self;
    /// 2ⁿ for an integral n from −1022 to 1023; meaningless for any other.
    fn power_of_two(self) -> Self;
    /// The larger of two; `other` where one of them is not a number.
    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        Self::select(other.less(self), self, other)
    }
    /// The smaller of two; `other` where one of them is not a number.
    #[inline(always)]
    fn smaller(self, other: Self) -> Self {
        Self::select(self.less(other), self, other)
    }
    /// The three components of the rows `index[at .. at + WIDTH]`.
    ///
    /// # Safety
    /// Those indices must be below `rows.len()`.
    unsafe fn gather(rows: &[Row], index: &[u16; 8], at: usize) -> [Self; 3];
    /// Adds the vectors of eight lanes to the rows `index`, one lane after the other in ascending order, so that
    /// lanes which share a row cannot collide and every width sums in the same order.
    ///
    /// # Safety
    /// All eight indices must be below `rows.len()`.
    unsafe fn scatter_add(rows: &mut [Row], index: &[u16; 8], vector: &[Octet; 3]);
}

impl Lane for f64 {
    type Mask = bool;
    const WIDTH: usize = 1;

    #[inline(always)]
    fn splat(x: f64) -> f64 {
        x
    }
    #[inline(always)]
    fn load(from: &Octet, at: usize) -> f64 {
        from.0[at]
    }
    #[inline(always)]
    fn store(self, to: &mut Octet, at: usize) {
        to.0[at] = self;
    }
    #[inline(always)]
    fn mul_add(self, b: f64, c: f64) -> f64 {
        f64::mul_add(self, b, c)
    }
    #[inline(always)]
    fn neg_mul_add(self, b: f64, c: f64) -> f64 {
        f64::mul_add(-self, b, c)
    }
    #[inline(always)]
    fn sqrt(self) -> f64 {
        f64::sqrt(self)
    }
    #[inline(always)]
    fn abs(self) -> f64 {
        f64::abs(self)
    }
    #[inline(always)]
    fn less(self, other: f64) -> bool {
        self < other
    }
    #[inline(always)]
    fn select(mask: bool, yes: f64, no: f64) -> f64 {
        if mask { yes } else { no }
    }
    #[inline(always)]
    fn any(mask: bool) -> bool {
        mask
    }
    #[inline(always)]
    fn both(a: bool, b: bool) -> bool {
        a & b
    }
    #[inline(always)]
    fn either(a: bool, b: bool) -> bool {
        a | b
    }
    #[inline(always)]
    fn not(mask: bool) -> bool {
        !mask
    }
    #[inline(always)]
    fn exponent(self) -> f64 {
        f64::from_bits((self.to_bits() >> 52) | bits::TWO_52.to_bits()) - bits::EXPONENT_BIAS
    }
    #[inline(always)]
    fn significand(self) -> f64 {
        f64::from_bits(self.to_bits() & bits::FRACTION | 1.0f64.to_bits())
    }
    #[inline(always)]
    fn power_of_two(self) -> f64 {
        f64::from_bits((self + bits::EXPONENT_BIAS).to_bits() << 52)
    }
    #[inline(always)]
    unsafe fn gather(rows: &[Row], index: &[u16; 8], at: usize) -> [f64; 3] {
        debug_assert!((index[at] as usize) < rows.len());
        // SAFETY: the caller keeps the indices in range.
        let row = unsafe { rows.get_unchecked(index[at] as usize) };
        row.xyz()
    }
    #[inline(always)]
    unsafe fn scatter_add(rows: &mut [Row], index: &[u16; 8], vector: &[Octet; 3]) {
        for lane in 0..8 {
            debug_assert!((index[lane] as usize) < rows.len());
            // SAFETY: the caller keeps the indices in range.
            let row = unsafe { rows.get_unchecked_mut(index[lane] as usize) };
            for i in 0..3 {
                row.0[i] += vector[i].0[lane];
            }
        }
    }
}

/// Constants that turn exponents into numbers and back by integer operations every register width has.
mod bits {
    /// 2⁵²: a number this large holds an integer in the low bits of its fraction.
    pub const TWO_52: f64 = 4_503_599_627_370_496.0;
    /// 2⁵² plus the bias of the exponent.
    pub const EXPONENT_BIAS: f64 = TWO_52 + 1023.0;
    /// The bits of the fraction.
    pub const FRACTION: u64 = (1 << 52) - 1;
}

/// Instruction set that the kernels run with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Isa {
    /// One number at a time: the reference.
    Scalar,
    /// Four lanes, x86-64 with AVX2 and FMA.
    Avx2,
    /// Eight lanes, x86-64 with AVX-512F.
    Avx512,
}

impl Isa {
    /// Every instruction set this program has kernels for.
    pub const ALL: [Isa; 3] = [Isa::Scalar, Isa::Avx2, Isa::Avx512];

    /// Name as given to `--isa`.
    pub const fn name(self) -> &'static str {
        match self {
            Isa::Scalar => "scalar",
            Isa::Avx2 => "avx2",
            Isa::Avx512 => "avx512",
        }
    }

    /// Whether this processor has it.
    pub fn available(self) -> bool {
        match self {
            Isa::Scalar => true,
            #[cfg(target_arch = "x86_64")]
            Isa::Avx2 => is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma"),
            #[cfg(target_arch = "x86_64")]
            Isa::Avx512 => is_x86_feature_detected!("avx512f") && Isa::Avx2.available(),
            #[cfg(not(target_arch = "x86_64"))]
            _ => false,
        }
    }

    /// The widest one that this processor has.
    pub fn best() -> Isa {
        Isa::ALL.into_iter().rev().find(|isa| isa.available()).unwrap_or(Isa::Scalar)
    }
}

pub mod elementary;

#[cfg(target_arch = "x86_64")]
pub use x86::{Avx2, Avx512, Enabled};

#[cfg(target_arch = "x86_64")]
mod x86;
