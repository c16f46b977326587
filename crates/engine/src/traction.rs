//! Tractions before the shaking.

use crate::life::Life;
use tremolite_mesh::Face;

/// Constant tractions σ·n on faces.
#[derive(Clone, Debug)]
pub struct Traction {
    /// For messages.
    pub name: String,
    /// Faces, each with a stress \[Pa\] in the order of Voigt; n points out of the face's element. A pressure p is −p I.
    pub faces: Vec<(Face, [f64; 6])>,
    /// When it acts; it goes with the shaking at the latest.
    pub life: Life,
}
