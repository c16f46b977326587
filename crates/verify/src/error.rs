//! Why a verification problem could not be run.

use tremolite::{Halt, ModelError};
use tremolite_mesh::boxes::BoxError;

/// Why a problem could not be run to its end.
#[derive(Debug, thiserror::Error)]
pub enum VerifyError {
    #[error("the mesh could not be made: {0}")]
    Box(#[from] BoxError),
    #[error("the model could not be built: {0}")]
    Model(#[from] ModelError),
    #[error("the incident motion could not be made: {0}")]
    Motion(#[from] tremolite_motion::Error),
    #[error("the problem could not be set up: {0}")]
    Setup(String),
    #[error("the run became unstable: {0:?}")]
    Halt(Halt),
    #[error(
        "the stiffness matrix is not positive definite at its row {0}: a rigid motion or a mode without energy"
    )]
    Singular(usize),
    #[error("two figures have the id {0}: let their quantities differ in words or numbers")]
    SameId(String),
    #[error("no node of the model lies at ({0} m, {1} m, {2} m)")]
    NoNode(f64, f64, f64),
}

impl From<Halt> for VerifyError {
    fn from(halt: Halt) -> Self {
        VerifyError::Halt(halt)
    }
}
