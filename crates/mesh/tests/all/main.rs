//! The tests of this crate, one binary.

mod files;
mod round_trip;
