//! Verification: problems with exact or published solutions, run through the engine that cases use.
//!
//! One problem a file under [`problems`]: the solution and its source, the numerical model, and what is compared.
//! [`PROBLEMS`] lists them; [`select`] takes some or all, and [`Verification::verify`] gives the [`Check`]s of one.
//!
//! A tolerance states what theory or convergence lets one expect, and its note gives the reason. It is never what
//! happens to pass.
//!
//! ```
//! use tremolite_verify::{Effort, select};
//!
//! for problem in select(&["discrete_energy"])? {
//!     let verified = problem.verify(Effort::Test);
//!     assert_eq!(verified.missed(), 0);
//! }
//! # Ok::<(), tremolite_verify::UnknownName>(())
//! ```

#![forbid(unsafe_code)]

mod banded;
mod bessel;
mod bolted;
pub mod box_size;
mod check;
mod concrete;
mod convergence;
mod dense;
mod effort;
mod error;
mod full_space;
pub mod hill;
mod id;
mod joints;
mod lattice;
mod lined;
mod michell;
mod models;
mod problem;
pub mod problems;
pub mod reflection;
mod rock;
mod scattering;
mod select;
mod sheet;
mod simulation;
pub mod specimen;
mod staged;
mod stiffness;
mod text;

pub use check::Check;
pub use effort::Effort;
pub use error::VerifyError;
pub use problem::{Verification, Verified};
pub use problems::PROBLEMS;
pub use select::{UnknownName, select};
pub use simulation::force_levels;
pub use text::text;

#[cfg(test)]
mod tests;
