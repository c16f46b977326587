//! Parts: everything that pushes on nodes, and the fused kernels of those made of elements.
//!
//! A kernel is compiled for each law, quadrature and instruction set, which takes most of the time of a build. All of that
//! happens in this crate: a change to the time loop, an observer or the case reader compiles none of it again. So whoever
//! wants a material asks [`laws`] or [`elastic`] for it; only a law of one's own is made with [`Law::of`].

pub mod contact;
pub mod follow;
pub mod interface;
pub mod line;
pub mod material;
pub mod part;
pub mod solid;
pub mod stage;

pub use interface::{AnyInterface, InterfaceLaw, interface_laws};
pub use line::{Booked, Line, Lines};
pub use material::{AnyMaterial, Law, elastic, laws};
pub use part::{ElementEnergy, Entry, Motion, Own, Part, ProbeOut, Reads, Scratch, StateSizes, Tick};
pub use solid::PoresOf;
pub use stage::Stage;
pub use tremolite_laws::shapes::hex8::{Layers, Points, Quadrature};
