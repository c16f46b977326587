//! The tests of this crate, one binary.

mod columns;
mod cut;
mod fields;
mod folder;
mod pvd;
mod summary;
mod table;
