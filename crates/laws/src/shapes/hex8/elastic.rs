//! The stress of a sound element: what its strain would ask of a material without damage or yield.

use super::full::FullGeometry;
use super::{BINARY, Hex8, OnePointGeometry, OnePointShape, Quadrature, Stabilisation, to_modes};
use crate::material::Moduli;

/// C : ε \[Pa\] with the element's own strain of the displacements \[m\] of its corners in VTK order, and Hooke's C of these
/// moduli: at its one point, or at 2×2×2 points, of layered elements as well, whose strain is the same.
pub fn elastic_stress(
    hex: &Hex8,
    moduli: Moduli,
    quadrature: Quadrature,
    u: &[[f64; 3]; 8],
) -> Vec<[f64; 6]> {
    let mut modes = [[0.0; 8]; 3];
    for i in 0..3 {
        for corner in 0..8 {
            modes[i][BINARY[corner]] = u[corner][i];
        }
        to_modes(&mut modes[i]);
    }
    // The element is the first of eight lanes, and the only one that is worked on.
    if quadrature == Quadrature::OnePoint {
        let mut geometry = OnePointGeometry::EMPTY;
        geometry.set(0, hex);
        let (strain, _) = geometry.strain::<f64>(&modes, 0);
        return vec![moduli.stress(&strain)];
    }
    let mut geometry = FullGeometry::EMPTY;
    geometry.set(0, hex, &Stabilisation::new(moduli));
    geometry.strains(&modes).iter().map(|strain| moduli.stress(strain)).collect()
}
