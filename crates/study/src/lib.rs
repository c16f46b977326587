//! Studies: which cases are run beside one another, and what is made of their results.
//!
//! [`Plan::of`] makes of a study file ([`StudyFile`](tremolite_case::study::StudyFile)) the list of its runs, which is a function of
//! file and seed alone. [`prepare`] makes the case of each. Whoever runs them leaves a result folder each; [`outcome`] says what became
//! of it, [`measure`] takes numbers out of it, and [`results`] puts all of them together, with fragility curves.
//!
//! The crate knows no engine and starts no process.

#![forbid(unsafe_code)]
#![allow(clippy::neg_cmp_op_on_partial_ord, reason = "a negated comparison refuses NaN as well")]

pub mod bootstrap;
pub mod codes;
pub mod distribution;
pub mod fragility;
pub mod intensity;
pub mod latin_hypercube;
pub mod matrix;
pub mod measure;
pub mod measure_paths;
pub mod normal;
pub mod outcome;
pub mod plan;
pub mod prepare;
pub mod random;
pub mod results;
pub mod sobol;
pub mod table;

pub use plan::Plan;
