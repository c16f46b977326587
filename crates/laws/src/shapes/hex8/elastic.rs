//! The stress of a sound element: what its strain would ask of a material without damage or yield.

use super::{
    FullGeometry, Given, Hex8, OnePointGeometry, OnePointShape, Probe, Quadrature, Stabilisation, full,
    one_point,
};
use crate::lane::{Octet, Row};
use crate::material::{Moduli, Point};
use crate::materials::Elastic;

/// C : ε \[Pa\] with the element's own strain of the displacements \[m\] of its corners in VTK order, and Hooke's C of these
/// moduli: at its one point, or at 2×2×2 points, of layered elements as well, whose strain is the same.
pub fn elastic_stress(
    hex: &Hex8,
    moduli: Moduli,
    quadrature: Quadrature,
    u: &[[f64; 3]; 8],
) -> Vec<[f64; 6]> {
    let full_quadrature = quadrature != Quadrature::OnePoint;
    let law = Elastic::from_moduli(moduli);
    let stabilisation = Stabilisation::new(moduli);
    let point = Point::new(0.0);
    // The element is the first of eight lanes; the others have no extent.
    let index: [[u16; 8]; 8] = core::array::from_fn(|corner| [corner as u16; 8]);
    let rows = u.map(Row::new);
    let mut forces = [Row::ZERO; 8];
    let mut probe = Probe::ZERO;
    let history: &mut [Octet] = &mut [];
    // SAFETY: the indices are below eight, and plain f64 needs no instruction set.
    unsafe {
        if full_quadrature {
            let mut geometry = FullGeometry::EMPTY;
            geometry.set(0, hex, &stabilisation);
            full::<f64, _, true>(
                &law,
                &stabilisation,
                &point,
                &geometry,
                &index,
                history,
                None,
                &mut [],
                Given::NONE,
                &mut [],
                &rows,
                &mut forces,
                &mut probe,
            );
        } else {
            let mut geometry = OnePointGeometry::EMPTY;
            geometry.set(0, hex);
            one_point::<f64, _, _, true>(
                &law,
                &stabilisation,
                &point,
                &geometry,
                &index,
                history,
                None,
                &mut [],
                Given::NONE,
                &mut [],
                &rows,
                &mut forces,
                &mut probe,
            );
        }
    }
    let points = if full_quadrature { 8 } else { 1 };
    probe.stress[..points].iter().map(|stress| stress.map(|c| c.0[0])).collect()
}
