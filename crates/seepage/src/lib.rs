//! Steady flow of water in ground with a free surface, on hexahedra.
//!
//! div(k_r(p) k ∇h) = 0 with the head h = z + p/γ_w \[m\] (Darcy), trilinear hexahedra with 2×2×2 points; corners may coincide, so wedges,
//! pyramids and tetrahedra are hexahedra as well. Above the free surface (p < 0) the conductivity falls with the suction, in line, to
//! 10⁻³ of k at a suction of the element's own height (`bathe1979`; one value an element, by its upper corners along the flow): the mesh
//! stays where it is. Where a wall is open water leaves at the
//! pressure of the air or nothing flows; which of the two is found beside k_r, face node by face node.
//!
//! Not modelled: time (storage), capillary rise as such (suction means a place to which little flows), hysteresis, conductivity that goes by
//! direction, by stress or by the opening of joints, flow along joints.

mod element;
mod matrix;
mod places;
mod regions;
mod steady;

pub use places::{Holds, Place};
pub use steady::{Flow, steady};

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
