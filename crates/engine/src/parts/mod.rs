//! Parts that are no elements and no boundaries. [`Part`] itself and those of elements are in [`tremolite_kernels`].

pub mod absent;
pub mod bars;
pub mod constant;
pub mod loads;
pub mod passed_on;

use tremolite_laws::Row;

pub use tremolite_kernels::part::*;

/// What is not known; the fourth number is no component.
pub(crate) const UNKNOWN: Row = Row([f64::NAN, f64::NAN, f64::NAN, 0.0]);
