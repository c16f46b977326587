//! The stress of a sound element: what its strain would ask of a material without damage or yield.

use super::full::FullGeometry;
use super::{BINARY, Hex8, OnePointGeometry, OnePointShape, Quadrature, Stabilisation, to_modes};
use crate::lane::Isa;
use crate::material::Moduli;

/// C : ε \[Pa\] with the element's own strain of the displacements \[m\] of its corners in VTK order, and Hooke's C of these
/// moduli: at its one point, or at 2×2×2 points, of layered elements as well, whose strain is the same.
pub fn elastic_stress(
    hex: &Hex8,
    moduli: Moduli,
    quadrature: Quadrature,
    u: &[[f64; 3]; 8],
) -> Vec<[f64; 6]> {
    let modes = modal(u);
    // The element is the first of eight lanes, and the only one that is worked on.
    if quadrature == Quadrature::OnePoint {
        let mut geometry = OnePointGeometry::EMPTY;
        geometry.set(0, hex);
        let (strain, _) = geometry.strain::<f64>(&modes, 0);
        return vec![moduli.stress(&strain)];
    }
    let mut geometry = FullGeometry::EMPTY;
    geometry.set(0, hex, &Stabilisation::new(moduli));
    geometry.strains(&modes, 0).iter().map(|strain| moduli.stress(strain)).collect()
}

/// Modal displacements from those of corners in VTK order.
#[inline(always)]
fn modal(u: &[[f64; 3]; 8]) -> [[f64; 8]; 3] {
    let mut modes = [[0.0; 8]; 3];
    for i in 0..3 {
        for corner in 0..8 {
            modes[i][BINARY[corner]] = u[corner][i];
        }
        to_modes(&mut modes[i]);
    }
    modes
}

/// Elements of one material whose [`elastic_stress`] at 2×2×2 points is asked for again and again, with their geometry worked out once.
pub struct ElasticPoints {
    moduli: Moduli,
    /// Of eight elements each.
    geometry: Vec<FullGeometry>,
    wide: bool,
}

impl ElasticPoints {
    /// Of some elements, in their order.
    pub fn new(hexes: &[Hex8], moduli: Moduli) -> Self {
        let elastic = Stabilisation::new(moduli);
        let eight = |hexes: &[Hex8]| {
            let mut geometry = FullGeometry::EMPTY;
            hexes.iter().enumerate().for_each(|(lane, hex)| geometry.set(lane, hex, &elastic));
            geometry
        };
        ElasticPoints { moduli, geometry: hexes.chunks(8).map(eight).collect(), wide: Isa::Avx2.available() }
    }

    /// What [`elastic_stress`] gives, to the bit.
    ///
    /// # Panics
    /// If there is no element of this number.
    pub fn stress(&self, element: usize, u: &[[f64; 3]; 8]) -> [[f64; 6]; 8] {
        let (geometry, lane) = (&self.geometry[element / 8], element % 8);
        #[cfg(target_arch = "x86_64")]
        if self.wide {
            #[target_feature(enable = "avx2,fma")]
            unsafe fn wide(
                geometry: &FullGeometry,
                lane: usize,
                moduli: Moduli,
                u: &[[f64; 3]; 8],
            ) -> [[f64; 6]; 8] {
                at_points(geometry, lane, moduli, u)
            }
            // SAFETY: `wide` says that the processor has AVX2 and FMA.
            return unsafe { wide(geometry, lane, self.moduli, u) };
        }
        let _ = self.wide;
        at_points(geometry, lane, self.moduli, u)
    }
}

#[inline(always)]
fn at_points(geometry: &FullGeometry, lane: usize, moduli: Moduli, u: &[[f64; 3]; 8]) -> [[f64; 6]; 8] {
    let strains = geometry.strains(&modal(u), lane);
    let mut stresses = [[0.0; 6]; 8];
    for (stress, strain) in stresses.iter_mut().zip(&strains) {
        *stress = moduli.stress(strain);
    }
    stresses
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Distorted elements, ten of them, so that a second eight is begun.
    #[test]
    fn stresses_asked_for_again_have_the_same_bits() {
        let mut seed = 3u64;
        let mut random = || {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        };
        let mut corners = || super::super::CORNERS.map(|c| c.map(|x| x + 0.3 * random()));
        let hexes: Vec<Hex8> = (0..10).filter_map(|_| Hex8::new(corners()).ok()).collect();
        assert_eq!(hexes.len(), 10);
        let moduli = Moduli { lambda: 3.0e9, mu: 2.0e9 };
        let points = ElasticPoints::new(&hexes, moduli);
        for (k, hex) in hexes.iter().enumerate() {
            let u = super::super::CORNERS.map(|c| c.map(|x| 1e-3 * (x + 0.1 * k as f64).sin()));
            let once = elastic_stress(hex, moduli, Quadrature::Full, &u);
            assert_eq!(points.stress(k, &u).map(|s| s.map(f64::to_bits)).to_vec(), bits(&once));
        }
    }

    fn bits(stresses: &[[f64; 6]]) -> Vec<[u64; 6]> {
        stresses.iter().map(|s| s.map(f64::to_bits)).collect()
    }
}
