//! The tests of this crate, one binary.

mod bolts;
mod compare;
mod free_field;
mod further_quantities;
mod interface_results;
mod interfaces;
mod page;
mod report;
mod stages;
