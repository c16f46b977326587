//! The highest frequency of a single element: what it alone would demand of the time step.

use super::{
    FullGeometry, Given, Hex8, OnePointGeometry, OnePointShape, Probe, Quadrature, Stabilisation, full,
    one_point,
};
use crate::lane::{Isa, Lane, Octet, Row};
use crate::material::{Moduli, Point};
use crate::materials::Elastic;
use std::sync::LazyLock;

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

/// Geometry of up to eight elements, of one point each or of 2×2×2.
enum Eight {
    OnePoint(Box<OnePointGeometry>),
    Full(Box<FullGeometry>),
}

/// Elastic forces of the elements at displacements `w`, added to `f`; every lane has eight rows of its own.
///
/// # Safety
/// The lane's instruction set must be enabled.
#[inline(always)]
unsafe fn forces<L: Lane>(
    moduli: Moduli,
    stabilisation: &Stabilisation,
    eight: &Eight,
    w: &[Row; 64],
    f: &mut [Row; 64],
) {
    let law = Elastic::from_moduli(moduli);
    let point = Point::new(0.0);
    let mut index = [[0; 8]; 8];
    let mut k = 0;
    while k < 64 {
        index[k % 8][k / 8] = k as u16;
        k += 1;
    }
    let (history, band): (&mut [Octet], &mut [Octet]) = (&mut [], &mut []);
    let mut probe = Probe::ZERO;
    // SAFETY: the indices are below 64; passed on to the caller.
    unsafe {
        match eight {
            Eight::Full(geometry) => full::<L, _, _, false>(
                &law,
                stabilisation,
                &point,
                &**geometry,
                &index,
                history,
                None,
                band,
                Given::NONE,
                &mut [],
                w,
                f,
                &mut probe,
            ),
            Eight::OnePoint(geometry) => one_point::<L, _, _, false>(
                &law,
                stabilisation,
                &point,
                &**geometry,
                &index,
                history,
                None,
                band,
                Given::NONE,
                &mut [],
                w,
                f,
                &mut probe,
            ),
        }
    }
}

/// √λmax of up to eight elements by power iteration; every lane has eight rows of its own.
///
/// # Safety
/// The lane's instruction set must be enabled.
#[inline(always)]
unsafe fn iterate<L: Lane>(
    hexes: &[Hex8],
    moduli: Moduli,
    density: f64,
    stabilisation: &Stabilisation,
    (eight, start): (&Eight, &[Row; 64]),
) -> Vec<f64> {
    let mut masses = [1.0; 64];
    for (masses, hex) in masses.chunks_exact_mut(8).zip(hexes) {
        for (mass, volume) in masses.iter_mut().zip(&hex.corner_volumes) {
            *mass = density * volume;
        }
    }
    let mut w = *start;
    let mut lambda = vec![0.0; hexes.len()];
    for _ in 0..ITERATIONS {
        let mut f = [Row::ZERO; 64];
        // SAFETY: passed on to the caller.
        unsafe { forces::<L>(moduli, stabilisation, eight, &w, &mut f) };
        for (lane, lambda) in lambda.iter_mut().enumerate() {
            let rows = 8 * lane..8 * lane + 8;
            let (mut wkw, mut wmw) = (0.0, 0.0);
            for n in rows.clone() {
                for i in 0..3 {
                    wkw += w[n].0[i] * f[n].0[i];
                    wmw += masses[n] * w[n].0[i] * w[n].0[i];
                }
            }
            *lambda = wkw / wmw;
            let scale = 1.0 / (*lambda * wmw.sqrt());
            for n in rows {
                for i in 0..4 {
                    w[n].0[i] = f[n].0[i] * scale / masses[n];
                }
            }
        }
    }
    lambda.into_iter().map(f64::sqrt).collect()
}

#[cfg(target_arch = "x86_64")]
mod wide {
    use super::{Eight, Hex8, Moduli, Row, Stabilisation, iterate};
    use crate::lane::{Avx2, Avx512, Enabled};

    #[derive(Clone, Copy)]
    struct Here;
    // SAFETY: named below alone, in functions that are called where the instruction set is there.
    unsafe impl Enabled for Here {}

    #[target_feature(enable = "avx2,fma")]
    pub(super) unsafe fn avx2(
        hexes: &[Hex8],
        moduli: Moduli,
        density: f64,
        stabilisation: &Stabilisation,
        of: (&Eight, &[Row; 64]),
    ) -> Vec<f64> {
        // SAFETY: this function enables the instruction set.
        unsafe { iterate::<Avx2<Here>>(hexes, moduli, density, stabilisation, of) }
    }

    #[target_feature(enable = "avx512f,avx2,fma")]
    pub(super) unsafe fn avx512(
        hexes: &[Hex8],
        moduli: Moduli,
        density: f64,
        stabilisation: &Stabilisation,
        of: (&Eight, &[Row; 64]),
    ) -> Vec<f64> {
        // SAFETY: this function enables the instruction set.
        unsafe { iterate::<Avx512<Here>>(hexes, moduli, density, stabilisation, of) }
    }
}

/// What the iteration starts from, the same in every lane.
static START: LazyLock<[Row; 64]> = LazyLock::new(|| {
    core::array::from_fn(|n| {
        Row::new([1.0, 2.0, 3.0].map(|i: f64| (12.9898 * ((n % 8) as f64 + 64.0 * i)).sin()))
    })
});

fn octet(hexes: &[Hex8], moduli: Moduli, density: f64, full_quadrature: bool) -> Vec<f64> {
    let stabilisation = Stabilisation::new(moduli);
    let mut eight = match full_quadrature {
        true => Eight::Full(Box::new(FullGeometry::EMPTY)),
        false => Eight::OnePoint(Box::new(OnePointGeometry::EMPTY)),
    };
    for (lane, hex) in hexes.iter().enumerate() {
        match &mut eight {
            Eight::Full(geometry) => geometry.set(lane, hex, &stabilisation),
            Eight::OnePoint(geometry) => geometry.set(lane, hex),
        }
    }
    // SAFETY: the processor has the instruction set; plain f64 needs none.
    unsafe {
        #[cfg(target_arch = "x86_64")]
        match Isa::best() {
            Isa::Avx512 => return wide::avx512(hexes, moduli, density, &stabilisation, (&eight, &START)),
            Isa::Avx2 => return wide::avx2(hexes, moduli, density, &stabilisation, (&eight, &START)),
            Isa::Scalar => {}
        }
        iterate::<f64>(hexes, moduli, density, &stabilisation, (&eight, &START))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::hex8::CORNERS;

    /// An element's frequency is its own, whatever elements are asked beside it.
    #[test]
    fn the_frequency_of_an_element_does_not_go_by_its_place_among_others() {
        let shape = |k: u32| {
            let noise = |i: u32| 0.2 * (12.9898 * f64::from(24 * k + i)).sin();
            let mut corners = CORNERS;
            for (i, x) in (0..).zip(corners.iter_mut().flatten()) {
                *x += noise(i);
            }
            Hex8::new(corners).unwrap()
        };
        let shapes: Vec<Hex8> = (0..19).map(shape).collect();
        let moduli = Moduli::from_young_poisson(25e9, 0.2);
        for quadrature in [Quadrature::OnePoint, Quadrature::Full] {
            let of = |some: &[Hex8]| element_frequencies(some, moduli, 2500.0, quadrature);
            let alone: Vec<f64> = shapes.chunks(1).flat_map(of).collect();
            assert_eq!(of(&shapes), alone, "{quadrature:?}");
            let speed = moduli.wave_speeds(2500.0).0;
            assert!(alone.iter().all(|omega| (0.5..4.0).contains(&(omega / speed))), "{alone:?}");
        }
    }
}
