//! The tests of this crate, one binary.

mod cut;
mod folder;
mod pvd;
mod summary;
mod table;
