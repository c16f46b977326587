//! A patch of hexahedra of one law and one quadrature: the unit of threads and the fused kernel.

use super::{Motion, Own, Part, ProbeOut, Scratch, StateSizes, Tick, Work};
use std::marker::PhantomData;
use std::sync::Arc;
use tremolite_laws::band::{Band, BandStep, MEMORY};
use tremolite_laws::materials::Elastic;
use tremolite_laws::shapes::hex8::{self, FullGeometry, Hex8, OnePointGeometry, Probe, Stabilisation};
use tremolite_laws::{Isa, Lane, Material, Moduli, Octet, Point, Row};

/// A quadrature with its geometry and kernel.
pub trait Rule: Send + Sync + 'static {
    const POINTS: usize;
    type Geometry: Copy + Send + Sync;
    const EMPTY: Self::Geometry;
    fn set(geometry: &mut Self::Geometry, lane: usize, hex: &Hex8, elastic: &Stabilisation);

    /// Forces of one octet.
    ///
    /// # Safety
    /// All indices must be in range of both `rows` and `out`; the lane's instruction set must be enabled.
    unsafe fn kernel<L: Lane, M: Material, const PROBE: bool>(
        law: &M,
        elastic: &Stabilisation,
        point: &Point<f64>,
        geometry: &Self::Geometry,
        index: &[[u16; 8]; 8],
        history: &mut [Octet],
        band: Option<&BandStep>,
        overstress: &mut [Octet],
        rows: &[Row],
        out: &mut [Row],
        probe: &mut Probe,
    );
}

macro_rules! rule {
    ($(#[$doc:meta])* $name:ident, $points:literal, $geometry:ty, $kernel:ident) => {
        $(#[$doc])*
        pub struct $name;
        impl Rule for $name {
            const POINTS: usize = $points;
            type Geometry = $geometry;
            const EMPTY: $geometry = <$geometry>::EMPTY;
            fn set(geometry: &mut $geometry, lane: usize, hex: &Hex8, elastic: &Stabilisation) {
                geometry.set(lane, hex, elastic);
            }
            #[inline(always)]
            unsafe fn kernel<L: Lane, M: Material, const PROBE: bool>(
                law: &M,
                elastic: &Stabilisation,
                point: &Point<f64>,
                geometry: &$geometry,
                index: &[[u16; 8]; 8],
                history: &mut [Octet],
                band: Option<&BandStep>,
                overstress: &mut [Octet],
                rows: &[Row],
                out: &mut [Row],
                probe: &mut Probe,
            ) {
                // SAFETY: passed on to the caller.
                unsafe {
                    hex8::$kernel::<L, M, PROBE>(
                        law, elastic, point, geometry, index, history, band, overstress, rows, out, probe,
                    )
                }
            }
        }
    };
}

rule!(
    /// One point with stabilisation.
    OnePoint, 1, OnePointGeometry, one_point
);
rule!(
    /// 2×2×2 points.
    Full, 8, FullGeometry, full
);

/// A patch of elements.
pub struct Solid<M: Material, R: Rule> {
    law: Arc<M>,
    /// The stiffest elastic moduli as a law of its own, for K w.
    elastic: Elastic,
    band: Option<Band>,
    stabilisation: Stabilisation,
    isa: Isa,
    nodes: Vec<u32>,
    elements: usize,
    index: Vec<[[u16; 8]; 8]>,
    geometry: Vec<R::Geometry>,
    rule: PhantomData<R>,
}

/// Arguments of a pass over the octets of a patch.
struct Pass<'a, R: Rule, M> {
    law: &'a M,
    stabilisation: &'a Stabilisation,
    point: Point<f64>,
    index: &'a [[[u16; 8]; 8]],
    geometry: &'a [R::Geometry],
    history: &'a mut [Octet],
    band: Option<BandStep>,
    overstress: &'a mut [Octet],
    rows: &'a [Row],
    out: &'a mut [Row],
    probe: Option<ProbeOut<'a>>,
}

#[inline(always)]
unsafe fn octets<L: Lane, R: Rule, M: Material, const PROBE: bool>(pass: Pass<R, M>) {
    let per_octet = R::POINTS * M::HISTORY.len();
    let mut probe = Probe::ZERO;
    let mut wanted = pass.probe;
    for (i, (index, geometry)) in pass.index.iter().zip(pass.geometry).enumerate() {
        let history = &mut pass.history[i * per_octet..(i + 1) * per_octet];
        let overstress = match pass.band {
            Some(_) => &mut pass.overstress[i * R::POINTS * MEMORY..(i + 1) * R::POINTS * MEMORY],
            None => &mut [],
        };
        // SAFETY: `Solid::new` checked every index against the number of nodes, which both slices have.
        unsafe {
            R::kernel::<L, M, PROBE>(
                pass.law,
                pass.stabilisation,
                &pass.point,
                geometry,
                index,
                history,
                pass.band.as_ref(),
                overstress,
                pass.rows,
                pass.out,
                &mut probe,
            );
        }
        if PROBE && let Some(to) = wanted.as_mut() {
            keep::<R>(&probe, i, to);
        }
    }
}

/// Copies an octet's probe to the places of its real elements.
fn keep<R: Rule>(probe: &Probe, octet: usize, to: &mut ProbeOut) {
    for lane in 0..8.min(to.energy.len() - 8 * octet) {
        let element = 8 * octet + lane;
        to.energy[element] = [probe.strain_energy.0[lane], probe.hourglass_energy.0[lane]];
        for p in 0..R::POINTS {
            to.stress[element * R::POINTS + p] = [0, 1, 2, 3, 4, 5].map(|c| probe.stress[p][c].0[lane]);
        }
    }
}

#[cfg(target_arch = "x86_64")]
mod instances {
    use super::{Material, Pass, Rule, octets};
    use tremolite_laws::lane::{Avx2, Avx512};

    #[target_feature(enable = "avx512f,avx2,fma")]
    pub(super) unsafe fn avx512<R: Rule, M: Material, const PROBE: bool>(pass: Pass<R, M>) {
        // SAFETY: this function enables the instruction set; indices were checked.
        unsafe { octets::<Avx512, R, M, PROBE>(pass) }
    }

    #[target_feature(enable = "avx2,fma")]
    pub(super) unsafe fn avx2<R: Rule, M: Material, const PROBE: bool>(pass: Pass<R, M>) {
        // SAFETY: as above.
        unsafe { octets::<Avx2, R, M, PROBE>(pass) }
    }

    /// The reference with hardware `mul_add`; without it each one is a library call.
    #[target_feature(enable = "fma")]
    pub(super) unsafe fn scalar_fma<R: Rule, M: Material, const PROBE: bool>(pass: Pass<R, M>) {
        // SAFETY: indices were checked.
        unsafe { octets::<f64, R, M, PROBE>(pass) }
    }
}

fn dispatch<R: Rule, M: Material, const PROBE: bool>(isa: Isa, pass: Pass<R, M>) {
    // SAFETY: `Solid::new` keeps only available instruction sets, and checked all indices.
    unsafe {
        #[cfg(target_arch = "x86_64")]
        match isa {
            Isa::Avx512 => return instances::avx512::<R, M, PROBE>(pass),
            Isa::Avx2 => return instances::avx2::<R, M, PROBE>(pass),
            Isa::Scalar if is_x86_feature_detected!("fma") => {
                return instances::scalar_fma::<R, M, PROBE>(pass);
            }
            Isa::Scalar => {}
        }
        let _ = isa;
        octets::<f64, R, M, PROBE>(pass);
    }
}

impl<M: Material, R: Rule> Solid<M, R> {
    /// A patch from its nodes, the elements' corners as positions among them (VTK order), and their geometry.
    ///
    /// `moduli` are the material's own; with a band, which adds to them, the law must have the relaxed ones.
    ///
    /// # Panics
    /// If a corner is not among the nodes, or corners and geometry differ in number.
    pub fn new(
        law: Arc<M>,
        moduli: Moduli,
        band: Option<Band>,
        nodes: Vec<u32>,
        corners: &[[u16; 8]],
        geometry: &[Hex8],
        isa: Isa,
    ) -> Self {
        assert_eq!(corners.len(), geometry.len());
        assert!(corners.iter().flatten().all(|&c| (c as usize) < nodes.len()));
        let stabilisation = Stabilisation::new(moduli);
        let octets = corners.len().div_ceil(8);
        let mut index = vec![[[0; 8]; 8]; octets];
        let mut packed = vec![R::EMPTY; octets];
        for (e, (corner, hex)) in corners.iter().zip(geometry).enumerate() {
            for k in 0..8 {
                index[e / 8][k][e % 8] = corner[k];
            }
            R::set(&mut packed[e / 8], e % 8, hex, &stabilisation);
        }
        Solid {
            elastic: Elastic::from_moduli(band.map_or(moduli, |b| moduli.scaled(b.unrelaxed()))),
            band,
            stabilisation,
            law,
            isa: if isa.available() { isa } else { Isa::Scalar },
            nodes,
            elements: corners.len(),
            index,
            geometry: packed,
            rule: PhantomData,
        }
    }

    fn gather<'s>(&self, global: &[Row], scratch: &'s mut Scratch) -> &'s [Row] {
        scratch.rows.clear();
        scratch.rows.extend(self.nodes.iter().map(|&n| global[n as usize]));
        &scratch.rows
    }

    fn pass<'a, N>(
        &'a self,
        law: &'a N,
        dt: f64,
        history: &'a mut [Octet],
        band: Option<BandStep>,
        overstress: &'a mut [Octet],
        rows: &'a [Row],
        out: &'a mut [Row],
        probe: Option<ProbeOut<'a>>,
    ) -> Pass<'a, R, N> {
        assert!(rows.len() == self.nodes.len() && out.len() == self.nodes.len());
        out.fill(Row::ZERO);
        Pass {
            law,
            stabilisation: &self.stabilisation,
            point: Point::new(dt),
            index: &self.index,
            geometry: &self.geometry,
            history,
            band,
            overstress,
            rows,
            out,
            probe,
        }
    }

    fn band_step(&self, dt: f64) -> Option<BandStep> {
        self.band.map(|b| b.step(dt, self.law.moduli()))
    }
}

impl<M: Material, R: Rule> Part for Solid<M, R> {
    fn nodes(&self) -> &[u32] {
        &self.nodes
    }

    fn state_sizes(&self) -> StateSizes {
        let points = self.index.len() * R::POINTS;
        StateSizes {
            history: points * M::HISTORY.len(),
            overstress: if self.band.is_some() { points * MEMORY } else { 0 },
            numbers: 0,
        }
    }

    fn elements(&self) -> (usize, usize) {
        (self.elements, R::POINTS)
    }

    fn forces(&self, tick: &Tick, x: &Motion, own: Own, out: &mut [Row], scratch: &mut Scratch) -> Work {
        let rows = self.gather(x.u, scratch);
        let band = self.band_step(tick.dt);
        dispatch::<R, M, false>(
            self.isa,
            self.pass(&*self.law, tick.dt, own.history, band, own.overstress, rows, out, None),
        );
        Work::default()
    }

    fn probe(
        &self,
        tick: &Tick,
        x: &Motion,
        own: Own,
        out: &mut [Row],
        probe: ProbeOut,
        scratch: &mut Scratch,
    ) -> Work {
        let rows = self.gather(x.u, scratch);
        let band = self.band_step(tick.dt);
        dispatch::<R, M, true>(
            self.isa,
            self.pass(&*self.law, tick.dt, own.history, band, own.overstress, rows, out, Some(probe)),
        );
        Work::default()
    }

    fn stiffness_times(&self, w: &[Row], out: &mut [Row], scratch: &mut Scratch) {
        let rows = self.gather(w, scratch);
        dispatch::<R, Elastic, false>(
            self.isa,
            self.pass(&self.elastic, 0.0, &mut [], None, &mut [], rows, out, None),
        );
    }
}
