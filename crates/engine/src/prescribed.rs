//! Displacements that a stage gives to nodes, as a machine does that tests a specimen.

use crate::life::Life;

/// Nodes that are brought to a displacement while a stage comes to rest, evenly over the cycles of its release.
#[derive(Clone, Debug, PartialEq)]
pub struct Prescribed {
    /// For results and messages.
    pub name: String,
    /// The nodes, as corners of elements of the mesh: the element, and bit k for its node k. So where an interface parts a place,
    /// that element's side of it is meant.
    pub corners: Vec<(u32, u8)>,
    /// Displacement \[m\] along x, y and z at the end, counted from the initial equilibrium; a component without one is not held.
    pub to: [Option<f64>; 3],
    pub life: Life,
}
