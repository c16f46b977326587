//! Tests of the engine by what it shows: one binary, since each links all of it. Whole runs are tested in `crates/tremolite`.

mod balance;
mod base;
mod bolts;
mod borders;
mod dashpots;
mod joints;
mod level_bounds;
mod outside;
mod passes;
mod proof;
mod ready;
mod stable_steps;
