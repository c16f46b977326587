//! Parts that are no elements and no boundaries. [`Part`] itself and those of elements are in [`tremolite_kernels`].

pub mod bars;
pub mod constant;
pub mod loads;
pub mod passed_on;

pub use tremolite_kernels::part::*;
