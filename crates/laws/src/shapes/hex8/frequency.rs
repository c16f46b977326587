//! The highest frequency of a single element: what it alone would demand of the time step.

use super::{
    FullGeometry, Given, Hex8, OnePointGeometry, OnePointShape, Probe, Quadrature, Stabilisation, full,
    one_point,
};
use crate::lane::{Isa, Lane, Octet, Row};
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

#[cfg(target_arch = "x86_64")]
mod wide {
    use super::{Eight, Moduli, Row, Stabilisation, forces};
    use crate::lane::{Avx2, Enabled};

    #[derive(Clone, Copy)]
    struct Here;
    // SAFETY: named below alone, in a function that is called where the instruction set is there.
    unsafe impl Enabled for Here {}

    #[target_feature(enable = "avx2,fma")]
    pub(super) unsafe fn avx2(
        moduli: Moduli,
        stabilisation: &Stabilisation,
        eight: &Eight,
        w: &[Row; 64],
        f: &mut [Row; 64],
    ) {
        // SAFETY: this function enables the instruction set.
        unsafe { forces::<Avx2<Here>>(moduli, stabilisation, eight, w, f) }
    }
}

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
    let mut w: [Row; 64] = core::array::from_fn(|n| {
        Row::new([1.0, 2.0, 3.0].map(|i: f64| (12.9898 * (n as f64 + 64.0 * i)).sin()))
    });
    let mut lambda = vec![0.0; hexes.len()];
    for _ in 0..ITERATIONS {
        let mut f = [Row::ZERO; 64];
        #[cfg(target_arch = "x86_64")]
        let wide = Isa::Avx2.available();
        #[cfg(not(target_arch = "x86_64"))]
        let wide = false;
        // SAFETY: the processor has the instruction set; plain f64 needs none.
        unsafe {
            match wide {
                #[cfg(target_arch = "x86_64")]
                true => wide::avx2(moduli, &stabilisation, &eight, &w, &mut f),
                _ => forces::<f64>(moduli, &stabilisation, &eight, &w, &mut f),
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
