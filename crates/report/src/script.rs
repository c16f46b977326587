//! What the page holds for its script, and nobody reads without one: the numbers of curves, in blocks.

pub mod blocks;
pub mod curves;
pub mod plot_curves;
