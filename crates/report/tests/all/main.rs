//! The tests of this crate, one binary.

mod bolts;
mod free_field;
mod further_quantities;
mod interface_results;
mod interfaces;
mod report;
mod spectra;
mod stages;
