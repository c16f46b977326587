//! Hints to the processor of what will be read soon. They change no number.

/// Asks for an item of a slice, which may lie wherever it likes; beyond the end nothing comes of it.
#[inline(always)]
pub fn soon<T>(all: &[T], at: usize) {
    #[cfg(target_arch = "x86_64")]
    {
        use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        let item = all.as_ptr().wrapping_add(at);
        // SAFETY: a hint, which touches nothing.
        unsafe { _mm_prefetch::<_MM_HINT_T0>(item.cast()) };
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = (all, at);
}
