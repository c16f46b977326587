//! What is unusual of a model though it can be run, at its place in the case.

mod ground;
mod monitors;
mod near;
mod pieces;
mod stairs;
mod waves;

pub use ground::of_ground;
pub use monitors::{of_bolts, of_pairs};
pub use near::{mirrored, of_near};
pub use pieces::{in_words, of_pieces, pressure};
pub use stairs::of_stairs;
pub use waves::{of_rows, of_step, of_waves};
