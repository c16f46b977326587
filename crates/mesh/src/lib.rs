//! Meshes of solid elements: the type, generators, readers and writers. No physics.

#![forbid(unsafe_code)]

pub mod abaqus;
mod assembly;
pub mod boxes;
mod cards;
pub mod cavern;
pub mod cdb;
mod coincident;
mod content;
pub mod cut;
mod dyna;
pub mod f3grid;
mod fault;
mod foreign;
mod format;
pub mod gmsh;
pub mod grading;
pub mod hole;
mod input;
mod isoparametric;
pub mod locate;
pub mod merge;
pub mod mesh;
mod nastran;
pub mod note;
pub mod order;
pub mod overburden;
pub mod pairs;
pub mod picture;
pub mod placement;
pub mod places;
pub mod plane;
pub mod quality;
pub mod reach;
pub mod read;
#[cfg(test)]
mod sample;
mod shortest;
pub mod sides;
mod sound;
pub mod split;
pub mod topology;
mod trouble;
pub mod vtk;
pub mod vtu;
pub mod write;

pub use mesh::{Element, Face, Mesh, Shape};
pub use note::Note;
pub use read::{ReadError, read, read_with_notes};
pub use sound::sound;
pub use write::{WriteError, write};
