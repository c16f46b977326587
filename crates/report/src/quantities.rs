//! Numbers with their units, as an engineer writes them.

pub mod scale;
pub mod units;
