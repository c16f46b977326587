//! Quadratures of the hexahedron, each with its geometry and kernel.

use super::weakened::Weakened;
use std::marker::PhantomData;
use tremolite_laws::band::{BandStep, MEMORY};
use tremolite_laws::shapes::hex8::{
    BrickField, FieldShape, FullGeometry, FullShape, Given, Hex8, LEFT, LayeredShape, Layers, MODAL_MEMORY,
    OnePointShape, Probe, Stabilisation, Through, bricks_left, full, layered, layered_left, one_point,
};
use tremolite_laws::{Lane, Material, Octet, Point, Row};

/// A quadrature with its geometry and kernel.
pub trait Rule: Send + Sync + 'static {
    type Geometry: Copy + Send + Sync;
    const EMPTY: Self::Geometry;
    /// Points of an element.
    fn points(&self) -> usize;
    /// Whether the products of [`Rule::weakened`] cost less than those of an elastic law at the points.
    const CLOSED: bool = false;
    /// Whether steps with AVX2 are made by the instance that probes: one that cannot takes as long to compile again, and is not faster.
    const PROBING_STEPS: bool = false;
    /// Octets that the damping bodies of eight elements keep.
    fn memory(&self) -> usize {
        self.points() * MEMORY
    }
    fn set(&self, geometry: &mut Self::Geometry, lane: usize, hex: &Hex8, elastic: &Stabilisation);

    /// A stress of the element in a lane in the axes in which the law sees strains, from one in global axes.
    fn local(_: &Self::Geometry, _lane: usize, stress: &[f64; 6]) -> [f64; 6] {
        *stress
    }

    /// Forces of one octet.
    ///
    /// # Safety
    /// All indices must be in range of both `rows` and `out`; the lane's instruction set must be enabled.
    unsafe fn kernel<L: Lane, M: Material, const PROBE: bool>(
        &self,
        law: &M,
        elastic: &Stabilisation,
        point: &Point<f64>,
        geometry: &Self::Geometry,
        index: &[[u16; 8]; 8],
        history: &mut [Octet],
        band: Option<&BandStep>,
        overstress: &mut [Octet],
        given: Given,
        left: &mut [Octet],
        rows: &[Row],
        out: &mut [Row],
        probe: &mut Probe,
    );

    /// Forces of the elasticity that is left at the points (`left`, [`LEFT`] octets each) of one octet, times `factor`.
    ///
    /// # Safety
    /// As for [`Rule::kernel`].
    #[inline(always)]
    unsafe fn weakened<L: Lane>(
        &self,
        law: &Weakened,
        elastic: &Stabilisation,
        geometry: &Self::Geometry,
        index: &[[u16; 8]; 8],
        left: &mut [Octet],
        factor: &Octet,
        rows: &[Row],
        out: &mut [Row],
    ) {
        for point in left.chunks_exact_mut(LEFT) {
            point[LEFT - 1] = *factor;
        }
        let mut probe = Probe::ZERO;
        // SAFETY: passed on to the caller.
        unsafe {
            self.kernel::<L, Weakened, false>(
                law,
                elastic,
                &Point::new(0.0),
                geometry,
                index,
                left,
                None,
                &mut [],
                Given::NONE,
                &mut [],
                rows,
                out,
                &mut probe,
            );
        }
    }
}

/// One point with stabilisation, in elements of any shape or in bricks.
pub struct OnePoint<G>(PhantomData<G>);

impl<G> Default for OnePoint<G> {
    fn default() -> Self {
        OnePoint(PhantomData)
    }
}

/// 2×2×2 points, in elements of any shape.
pub struct Full;

/// 2×2×2 points, in bricks.
pub struct FullBricks;

/// 2×2 points in each of several layers, in elements of any shape or in bricks. The number of layers is no parameter of the type: one
/// instance of a kernel serves all.
pub struct Layered<G>(&'static Through, PhantomData<G>);

impl<G> Layered<G> {
    pub fn new(layers: Layers) -> Self {
        Layered(Through::of(layers), PhantomData)
    }
}

impl<G: OnePointShape> Rule for OnePoint<G> {
    type Geometry = G;
    const EMPTY: Self::Geometry = G::EMPTY;
    fn points(&self) -> usize {
        1
    }
    fn set(&self, geometry: &mut Self::Geometry, lane: usize, hex: &Hex8, _: &Stabilisation) {
        geometry.set(lane, hex);
    }
    #[inline(always)]
    unsafe fn kernel<L: Lane, M: Material, const PROBE: bool>(
        &self,
        law: &M,
        elastic: &Stabilisation,
        point: &Point<f64>,
        geometry: &Self::Geometry,
        index: &[[u16; 8]; 8],
        history: &mut [Octet],
        band: Option<&BandStep>,
        overstress: &mut [Octet],
        given: Given,
        left: &mut [Octet],
        rows: &[Row],
        out: &mut [Row],
        probe: &mut Probe,
    ) {
        // SAFETY: passed on to the caller.
        unsafe {
            one_point::<L, G, M, PROBE>(
                law, elastic, point, geometry, index, history, band, overstress, given, left, rows, out,
                probe,
            )
        }
    }
}

impl Rule for Full {
    type Geometry = FullGeometry;
    const EMPTY: Self::Geometry = FullGeometry::EMPTY;
    fn points(&self) -> usize {
        8
    }
    fn set(&self, geometry: &mut Self::Geometry, lane: usize, hex: &Hex8, elastic: &Stabilisation) {
        geometry.set(lane, hex, elastic);
    }
    #[inline(always)]
    unsafe fn kernel<L: Lane, M: Material, const PROBE: bool>(
        &self,
        law: &M,
        elastic: &Stabilisation,
        point: &Point<f64>,
        geometry: &Self::Geometry,
        index: &[[u16; 8]; 8],
        history: &mut [Octet],
        band: Option<&BandStep>,
        overstress: &mut [Octet],
        given: Given,
        left: &mut [Octet],
        rows: &[Row],
        out: &mut [Row],
        probe: &mut Probe,
    ) {
        // SAFETY: passed on to the caller.
        unsafe {
            full::<L, _, M, PROBE>(
                law, elastic, point, geometry, index, history, band, overstress, given, left, rows, out,
                probe,
            )
        }
    }
}

impl Rule for FullBricks {
    type Geometry = BrickField;
    const EMPTY: Self::Geometry = <BrickField as FullShape>::EMPTY;
    const CLOSED: bool = true;
    fn points(&self) -> usize {
        8
    }
    fn set(&self, geometry: &mut Self::Geometry, lane: usize, hex: &Hex8, elastic: &Stabilisation) {
        FullShape::set(geometry, lane, hex, elastic);
    }
    fn local(geometry: &Self::Geometry, lane: usize, stress: &[f64; 6]) -> [f64; 6] {
        geometry.local(stress, lane)
    }
    #[inline(always)]
    unsafe fn kernel<L: Lane, M: Material, const PROBE: bool>(
        &self,
        law: &M,
        elastic: &Stabilisation,
        point: &Point<f64>,
        geometry: &Self::Geometry,
        index: &[[u16; 8]; 8],
        history: &mut [Octet],
        band: Option<&BandStep>,
        overstress: &mut [Octet],
        given: Given,
        left: &mut [Octet],
        rows: &[Row],
        out: &mut [Row],
        probe: &mut Probe,
    ) {
        // SAFETY: passed on to the caller.
        unsafe {
            full::<L, _, M, PROBE>(
                law, elastic, point, geometry, index, history, band, overstress, given, left, rows, out,
                probe,
            )
        }
    }

    /// What whole points carry is integrated in closed form.
    #[inline(always)]
    unsafe fn weakened<L: Lane>(
        &self,
        law: &Weakened,
        _: &Stabilisation,
        geometry: &Self::Geometry,
        index: &[[u16; 8]; 8],
        left: &mut [Octet],
        factor: &Octet,
        rows: &[Row],
        out: &mut [Row],
    ) {
        // SAFETY: passed on to the caller.
        unsafe { bricks_left::<L>(&law.0, geometry, index, left, factor, rows, out) }
    }
}

impl<G: LayeredShape> Rule for Layered<G> {
    const PROBING_STEPS: bool = true;
    type Geometry = G;
    const CLOSED: bool = true;
    const EMPTY: Self::Geometry = G::EMPTY;
    fn points(&self) -> usize {
        4 * self.0.count
    }
    fn memory(&self) -> usize {
        MODAL_MEMORY
    }
    fn set(&self, geometry: &mut Self::Geometry, lane: usize, hex: &Hex8, elastic: &Stabilisation) {
        geometry.set(lane, hex, elastic, self.0);
    }
    fn local(geometry: &Self::Geometry, lane: usize, stress: &[f64; 6]) -> [f64; 6] {
        geometry.field().local(stress, lane)
    }
    #[inline(always)]
    unsafe fn kernel<L: Lane, M: Material, const PROBE: bool>(
        &self,
        law: &M,
        _: &Stabilisation,
        point: &Point<f64>,
        geometry: &Self::Geometry,
        index: &[[u16; 8]; 8],
        history: &mut [Octet],
        band: Option<&BandStep>,
        overstress: &mut [Octet],
        given: Given,
        left: &mut [Octet],
        rows: &[Row],
        out: &mut [Row],
        probe: &mut Probe,
    ) {
        // SAFETY: passed on to the caller.
        unsafe {
            layered::<L, _, M, PROBE>(
                self.0, law, point, geometry, index, history, band, overstress, given, left, rows, out, probe,
            )
        }
    }

    /// What whole points carry is integrated in closed form.
    #[inline(always)]
    unsafe fn weakened<L: Lane>(
        &self,
        law: &Weakened,
        _: &Stabilisation,
        geometry: &Self::Geometry,
        index: &[[u16; 8]; 8],
        left: &mut [Octet],
        factor: &Octet,
        rows: &[Row],
        out: &mut [Row],
    ) {
        // SAFETY: passed on to the caller.
        unsafe { layered_left::<L, _>(self.0, &law.0, geometry, index, left, factor, rows, out) }
    }
}
