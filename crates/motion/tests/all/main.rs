//! The tests of this crate, one binary.

mod hostile;
mod readers;
mod reference;
