//! Meshes of solid elements: the type, generators, readers and writers. No physics.

pub mod abaqus;
mod assembly;
pub mod boxes;
pub mod cavern;
pub mod cdb;
pub mod f3grid;
pub mod gmsh;
pub mod grading;
mod input;
mod isoparametric;
pub mod locate;
pub mod merge;
pub mod mesh;
pub mod note;
pub mod order;
pub mod picture;
pub mod quality;
pub mod read;
#[cfg(test)]
mod sample;
pub mod topology;
pub mod vtk;
pub mod vtu;
pub mod write;

pub use mesh::{Element, Face, Mesh, Shape};
pub use note::Note;
pub use read::{ReadError, read, read_with_notes};
pub use write::{WriteError, write};
