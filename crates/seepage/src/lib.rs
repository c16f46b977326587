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
mod ground;
mod matrix;
mod places;
mod regions;
mod steady;

pub use ground::{Ground, SeepageError};
pub use places::{Holds, Place};
pub use steady::{Flow, steady};
