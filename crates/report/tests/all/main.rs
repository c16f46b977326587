//! The tests of this crate, one binary.

mod further_quantities;
mod report;
