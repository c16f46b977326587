//! Units of parameters, as results write them.

use tremolite_laws::{Dimension, Kind};

/// The SI unit of a parameter, as results write it.
pub(crate) fn unit(kind: Kind) -> &'static str {
    match kind {
        Kind::Number(Dimension::PRESSURE) => "Pa",
        Kind::Number(Dimension::LENGTH) => "m",
        Kind::Number(Dimension::TIME) => "s",
        Kind::Number(Dimension::RATE) => "1/s",
        Kind::Number(Dimension::FRACTURE_ENERGY) => "N/m",
        Kind::Number(Dimension::STIFFNESS) => "Pa/m",
        Kind::Number(Dimension::ANGLE) => "rad",
        _ => "",
    }
}
