//! The tests of this crate, one binary.

mod bolts;
mod change;
mod displacement;
mod files;
mod good_case;
mod hostile_input;
mod initial;
mod interface;
mod law_file;
mod problems;
mod renamed;
mod schema;
mod stage;
mod units;
