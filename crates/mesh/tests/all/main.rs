//! The tests of this crate, one binary.

mod files;
mod inputs;
mod round_trip;
