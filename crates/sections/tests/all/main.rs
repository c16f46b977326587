//! Tests of the crate's interface.

mod border;
mod crack;
mod independent;
mod plain;
mod published;
mod shear;

use tremolite_sections::{Code, Grade, Layer, Rule};

/// Steel of 500 MPa at a depth \[m\] from the mid-surface, in m² a metre.
fn layer(area: f64, depth: f64) -> Layer {
    Layer { area, depth, young: 200e9, yields: 500e6, breaks: f64::INFINITY }
}

/// A code without factors.
fn rule(code: Code, grade: &str) -> Rule {
    Rule {
        code,
        grade: Grade::of(code, grade).unwrap(),
        concrete_factor: 1.0,
        steel_factor: 1.0,
        compression_factor: 1.0,
        tension_factor: 1.0,
        resistance_factor: 1.0,
        tension: true,
    }
}

/// EN 1992-1-1 with its recommended factors.
fn en_design() -> Rule {
    Rule { concrete_factor: 1.5, steel_factor: 1.15, ..rule(Code::En, "C30/37") }
}
