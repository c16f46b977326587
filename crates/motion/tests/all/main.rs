//! The tests of this crate, one binary.

mod formats;
mod hostile;
mod inputs;
mod packing;
mod readers;
mod records;
mod reference;
