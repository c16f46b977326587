//! Parts that are no elements: what enters through the base, and loads. [`Part`] and those of elements are in
//! [`tremolite_kernels`].

pub mod base;
pub mod loads;

pub use tremolite_kernels::part::*;
