//! The tests of this crate, one binary.

mod follow;
mod line;
mod stress_forces;
