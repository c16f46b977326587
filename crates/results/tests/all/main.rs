//! The tests of this crate, one binary.

mod assessment;
mod columns;
mod cut;
mod fields;
mod folder;
mod pvd;
mod summary;
mod table;
