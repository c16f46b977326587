//! Ground through which water flows, and why no flow was found in it.

/// Ground through which water flows.
#[derive(Clone, Copy, Debug)]
pub struct Ground<'a> {
    /// Coordinates \[m\], z up.
    pub nodes: &'a [[f64; 3]],
    /// Corners of each element, as those of a hexahedron in the order of VTK; some may coincide.
    pub elements: &'a [[u32; 8]],
    /// Hydraulic conductivity of each element \[m/s\], positive.
    pub conductivity: &'a [f64],
}

impl Ground<'_> {
    /// Corners of an element.
    pub(crate) fn geometry(&self, element: usize) -> [[f64; 3]; 8] {
        self.elements[element].map(|n| self.nodes[n as usize])
    }
}

/// Why no flow was found.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SeepageError {
    /// Numbers that cannot be.
    #[error("{0}")]
    Input(String),
    /// An element that no hexahedron is, by its place in the list.
    #[error("element {0} of the ground has no volume, or is turned inside out")]
    Shape(usize),
    /// A region to which no water comes and which none leaves; one of its elements, by its place in the list.
    #[error("no head and no open wall bounds the ground around element {0}: its pressure is not determined")]
    Apart(usize),
    /// The linear equations were not solved.
    #[error("the equations of flow were not solved in {0} iterations of conjugate gradients")]
    Linear(usize),
    /// The free surface did not come to rest.
    #[error(
        "the free surface was not found in {iterations} iterations: heads still change by {change:.2e} of their range, and {switches} nodes of walls open or close"
    )]
    Unsettled { iterations: usize, change: f64, switches: usize },
}
