//! Tremolite: the problem and its time loop.
//!
//! [`Problem`] → [`Model`] (checked, immutable) → [`Assembly`] (every part it will ever have) → [`Phase`] (what of it is
//! active in a stage) + [`State`] (all that evolves) → [`Engine`] (the step).

pub mod assembly;
pub mod bench;
pub mod boundary;
pub mod checkpoint;
pub mod column;
pub mod damage;
pub mod engine;
pub mod error;
pub mod evidence;
pub mod extent;
mod groups;
pub mod hexahedra;
pub mod history;
pub mod life;
pub mod member;
pub mod model;
pub mod observers;
pub mod outer_faces;
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

pub use assembly::Assembly;
pub use engine::{Engine, Halt, Limit, Snapshot, StableStep, stable_step};
pub use error::{ModelError, RunError};
pub use life::{Life, Stage};
pub use member::Member;
pub use model::Model;
pub use phase::Phase;
pub use problem::{Base, Body, Incident, Problem, Rayleigh, Side, TimeStep};
pub use state::State;
pub use tremolite_kernels::{AnyMaterial, Law, Line, Lines, Quadrature, elastic, laws};
