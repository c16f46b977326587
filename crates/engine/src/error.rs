//! Why a problem cannot be run.

use tremolite_laws::shapes::hex8::BadShape;
use tremolite_mesh::split::{SplitError, UnmatchedSplit};

/// Why a problem cannot be run.
#[derive(Debug, thiserror::Error)]
pub enum ModelError {
    #[error("no element belongs to a body: assign a material to at least one group")]
    Empty,
    #[error(
        "element {element} belongs to '{first}' and to '{second}': let each element be in one region only"
    )]
    Twice { element: u64, first: String, second: String },
    #[error("element {element} of '{body}' cannot be used: {reason}")]
    BadElement { element: u64, body: String, reason: BadShape },
    #[error(
        "the thickness of element {element} of '{body}' is not to be told: {reason}; give such elements a region of their own \
         with element = \"full-integration\""
    )]
    Thickness { element: u64, body: String, reason: String },
    #[error("the sides {low} and {high} cannot be periodic: {reason}")]
    Periodic { low: &'static str, high: &'static str, reason: UnmatchedSplit },
    #[error(
        "no element face lies on the plane of the {0}, so nothing can act there: the outer sides must be plane"
    )]
    NoFaces(&'static str),
    #[error("{0}")]
    Column(String),
    #[error("{0}")]
    FreeField(String),
    #[error(
        "the top of the model is not a plane at {level:.3} m, where only {:.1} % of it lies, so top = \"viscous\" has no place \
         to absorb; cut the ground level, or write top = \"free\"",
        100.0 * share.abs()
    )]
    Top { level: f64, share: f64 },
    #[error("the interface '{name}' cannot be made: {reason}")]
    Interface { name: String, reason: String },
    #[error("{0}")]
    Split(#[from] SplitError),
    #[error("the part '{name}' cannot be used: {reason}")]
    Member { name: String, reason: String },
    #[error(
        "a patch of {elements} elements of '{body}' has more nodes than its elements can number, 65,536: let \
         `patch_elements` be 8192 at most, or leave it out"
    )]
    Patch { body: String, elements: usize },
    #[error(
        "'{}' and '{}' move the same component of a node, by {} and {} m: let their nodes differ (`within`), or their ways be equal; \
         nodes of periodic sides move as one",
        names[0], names[1], ways[0], ways[1]
    )]
    MovedTwice { names: [String; 2], ways: [f64; 2] },
    #[error("the water cannot be used: {reason}")]
    Water { reason: String },
    #[error("'{body}' has density {density} kg/m³: it must be positive")]
    Density { body: String, density: f64 },
}

impl ModelError {
    /// The interface that it is about.
    pub fn interface(&self) -> Option<&str> {
        match self {
            ModelError::Interface { name, .. } => Some(name),
            ModelError::Split(error) => Some(error.interface()),
            _ => None,
        }
    }
}
