//! Fourier transforms of real signals.
//!
//! One way of computing for all machines, without their wide instructions: a record has the same bits wherever it is read. The planner is generic, and
//! is instantiated here alone: each crate that did so took seconds of compiling.

use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};
use std::sync::Arc;

/// So many samples to their lines.
#[inline(never)]
pub(crate) fn forward(samples: usize) -> Arc<dyn RealToComplex<f64>> {
    RealFftPlanner::new().plan_fft_forward(samples)
}

/// Lines to so many samples.
#[inline(never)]
pub(crate) fn inverse(samples: usize) -> Arc<dyn ComplexToReal<f64>> {
    RealFftPlanner::new().plan_fft_inverse(samples)
}
