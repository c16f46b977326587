//! What figures are drawn with, whatever they show.
//!
//! [`svg`] writes; [`axes`] with their [`ticks`] stand on it, and on these three kinds of figures: histories in panels over one
//! time axis ([`chart`]; [`small_multiples`] where there are many), curves over anything else ([`plot`]; [`loops`] for paths of a
//! law, [`convergence`] for errors over sizes), and maps of a plane to scale ([`frame`]; [`frame_row`] for several of them).

pub mod axes;
pub mod chart;
pub mod colours;
mod contours;
pub mod convergence;
pub mod frame;
pub mod frame_row;
pub mod loops;
pub mod period_axis;
pub mod plot;
pub mod small_multiples;
pub mod state_strips;
pub mod svg;
pub mod thinning;
pub mod ticks;
pub mod window;
