//! The highest frequency of a single element: what it alone would demand of the time step.

use super::{
    FullGeometry, Given, Hex8, OnePointGeometry, OnePointShape, Probe, Quadrature, Stabilisation, full,
    one_point,
};
use crate::lane::{Octet, Row};
use crate::material::{Moduli, Point};
use crate::materials::Elastic;

/// Power iterations; the estimate is then within about a per cent of the largest frequency, from below.
const ITERATIONS: usize = 40;

/// √λmax(m⁻¹k) \[rad/s\] of up to eight elements with free nodes, lumped masses and elastic stiffness.
///
/// No mesh of these elements has a higher frequency than the highest of its elements (Irons & Treharne 1971), so
/// 2/ω bounds the stable step from below. Layered elements have the stiffness of 2×2×2 points, to round-off in parallelepipeds
/// and nearly in others, and are taken to have it here.
pub fn element_frequencies(hexes: &[Hex8], moduli: Moduli, density: f64, quadrature: Quadrature) -> Vec<f64> {
    let full_quadrature = quadrature != Quadrature::OnePoint;
    hexes.chunks(8).flat_map(|eight| octet(eight, moduli, density, full_quadrature)).collect()
}

fn octet(hexes: &[Hex8], moduli: Moduli, density: f64, full_quadrature: bool) -> Vec<f64> {
    let law = Elastic::from_moduli(moduli);
    let stabilisation = Stabilisation::new(moduli);
    let point = Point::new(0.0);
    let (mut one, mut eight) = (OnePointGeometry::EMPTY, FullGeometry::EMPTY);
    for (lane, hex) in hexes.iter().enumerate() {
        one.set(lane, hex);
        eight.set(lane, hex, &stabilisation);
    }
    // Every lane has eight rows of its own.
    let index: [[u16; 8]; 8] = core::array::from_fn(|k| core::array::from_fn(|lane| (8 * lane + k) as u16));
    let mut w: Vec<Row> = (0..64)
        .map(|n: u32| Row::new([1.0, 2.0, 3.0].map(|i: f64| (12.9898 * (f64::from(n) + 64.0 * i)).sin())))
        .collect();
    let mut lambda = vec![0.0; hexes.len()];
    let mut probe = Probe::ZERO;
    for _ in 0..ITERATIONS {
        let mut f = vec![Row::ZERO; 64];
        // SAFETY: the indices are below 64, and plain f64 needs no instruction set.
        unsafe {
            if full_quadrature {
                full::<f64, _, false>(
                    &law,
                    &stabilisation,
                    &point,
                    &eight,
                    &index,
                    &mut [] as &mut [Octet],
                    None,
                    &mut [],
                    Given::NONE,
                    &mut [],
                    &w,
                    &mut f,
                    &mut probe,
                );
            } else {
                one_point::<f64, _, _, false>(
                    &law,
                    &stabilisation,
                    &point,
                    &one,
                    &index,
                    &mut [] as &mut [Octet],
                    None,
                    &mut [],
                    Given::NONE,
                    &mut [],
                    &w,
                    &mut f,
                    &mut probe,
                );
            }
        }
        for (lane, hex) in hexes.iter().enumerate() {
            let rows = 8 * lane..8 * lane + 8;
            let (mut wkw, mut wmw) = (0.0, 0.0);
            for (k, n) in rows.clone().enumerate() {
                let mass = density * hex.corner_volumes[k];
                for i in 0..3 {
                    wkw += w[n].0[i] * f[n].0[i];
                    wmw += mass * w[n].0[i] * w[n].0[i];
                }
            }
            lambda[lane] = wkw / wmw;
            let scale = 1.0 / (lambda[lane] * wmw.sqrt());
            for (k, n) in rows.enumerate() {
                let mass = density * hex.corner_volumes[k];
                w[n] = Row(f[n].0.map(|x| x * scale / mass));
            }
        }
    }
    lambda.into_iter().map(f64::sqrt).collect()
}
