//! Elements of one material.

use std::sync::Arc;
use tremolite_kernels::{AnyMaterial, Quadrature};

/// Elements of one material and one quadrature.
#[derive(Clone)]
pub struct Body {
    /// For messages and reports.
    pub name: String,
    /// Indices into the mesh's elements.
    pub elements: Vec<u32>,
    pub material: Arc<dyn AnyMaterial>,
    /// Density ρ \[kg/m³\].
    pub density: f64,
    pub quadrature: Quadrature,
    /// Artificial viscosity b: share of critical damping at each element's own highest frequency, 0 for none.
    pub viscosity: f64,
}
