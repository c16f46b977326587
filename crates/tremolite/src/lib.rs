//! Tremolite: from a case to results.
//!
//! [`setup`] makes a [`Problem`] and a [`plan::Plan`] of a case; a [`simulation::Simulation`] takes them through the engine
//! ([`tremolite_engine`], whose modules are passed on here) and lets [`observers`] look, [`run`] drives it to its end, and
//! [`summary`] says what came out. A [`job::Job`] holds all of that for a case.

#![forbid(unsafe_code)]

pub mod checkpoint;
pub mod damage;
pub mod deconvolution;
pub mod disk;
pub mod equivalent_linear;
pub mod error;
pub mod evidence;
mod failure_modes;
mod fingerprint;
mod groups;
pub mod history;
pub mod interfaces;
pub mod job;
pub mod layered_column;
pub mod levels;
mod motion_table;
mod moved;
pub mod near_sides;
pub mod observers;
mod outcome;
pub mod outlook;
mod phrases;
pub mod places;
pub mod plan;
pub mod point_stress;
pub mod quantities;
mod rate_factors;
pub mod run;
pub mod scaling;
pub mod sections;
pub mod seepage;
pub mod setup;
pub mod simulation;
pub mod spectra;
pub mod stacks;
pub mod stages;
pub mod step_cost;
pub mod strength;
pub mod stress;
pub mod summary;
pub mod support;
pub mod survey;
mod synchrony;
mod transfer_table;
mod trust;
mod units;
pub mod waves;

pub use error::RunError;
pub use tremolite_engine::*;
