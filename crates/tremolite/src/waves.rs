//! Plane waves at an angle in layered ground: the free field that stands at the boundaries of a model which they reach.
//!
//! A P, SV or SH wave comes up through a half-space of the base's rock on which horizontal layers lie. All it does goes along in
//! plan with the slowness p = sin θ/c, so that the field at a place is that below or above a reference point, later by p·(x − x₀).
//! [`ground`] answers for one frequency, [`series`] makes of that what a level does in time, [`field`] hands it to the
//! boundaries of the engine, and [`surface`] says how much of a wave is seen on bare rock.

mod answered;
pub mod field;
mod grid;
pub mod ground;
pub mod heading;
pub mod heights;
mod later;
pub mod modes;
mod pore_water;
mod prepared;
mod pushed;
pub mod resolved;
pub mod rock;
mod rows;
pub mod series;
mod stacks;
pub mod surface;

pub use field::{Entering, Frame, ObliqueField, Unsuitable};
pub use ground::LayeredGround;
pub use heading::{Heading, WaveType};
pub use pore_water::PoreWater;
pub use rock::{Rock, Stratum};

#[cfg(test)]
mod tests;
