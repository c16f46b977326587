//! Tremolite: the problem and its time loop.
//!
//! [`Problem`] → [`Model`] (checked, immutable) → [`Phase`] (what is active) + [`State`] (all that evolves) →
//! [`Engine`] (the step).

pub mod bench;
pub mod boundary;
pub mod checkpoint;
pub mod column;
pub mod damage;
pub mod engine;
pub mod extent;
pub mod history;
pub mod material;
pub mod model;
pub mod observers;
pub mod parts;
pub mod phase;
pub mod plan;
pub mod problem;
pub mod quantities;
pub mod run;
pub mod setup;
pub mod stacks;
pub mod state;
pub mod summary;
pub mod survey;
pub mod ties;
mod trust;

pub use engine::{Balance, Engine, Halt, Snapshot, StableStep, stable_step};
pub use material::{AnyMaterial, Instance, Law, laws};
pub use model::{Model, ModelError};
pub use parts::Quadrature;
pub use phase::Phase;
pub use problem::{Base, Body, Incident, Problem, Rayleigh, Side, TimeStep};
pub use state::State;
