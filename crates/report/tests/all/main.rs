//! The tests of this crate, one binary.

mod further_quantities;
mod interface_results;
mod interfaces;
mod report;
mod stages;
