//! Steady flow against exact solutions, and what must hold of any.

mod common;
mod confined;
mod drains;
mod free_surface;
mod hall;
mod patch;
mod refused;
