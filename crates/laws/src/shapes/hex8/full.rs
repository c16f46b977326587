//! 2×2×2 quadrature of the assumed-strain field.

use super::field::{Field, FieldShape, G, Scale};
use super::pores::Pressed;
use super::{Given, Hex8, LEFT, Probe, Stabilisation, gather_modes, gauss_point, scatter_nodal, store_nodal};
use crate::band::{BandStep, MEMORY};
use crate::lane::{Lane, Octet, Row};
use crate::material::{Material, Point, Sym, load};

/// Geometry of eight elements of 2×2×2 points, whatever of it their shape needs.
pub trait FullShape: Copy + Send + Sync + 'static {
    type Field: FieldShape;
    /// Without extent: forces from it are zero. Pads the last octet of a patch.
    const EMPTY: Self;
    /// Puts an element into a lane.
    fn set(&mut self, lane: usize, hex: &Hex8, elastic: &Stabilisation);
    fn field(&self) -> &Self::Field;
    /// Volume of a point \[m³\].
    fn weight<L: Lane>(&self, p: usize, at: usize) -> L;
}

/// Geometry of eight elements of any shape; 134 octets, that is 1072 bytes an element.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct FullGeometry {
    field: Field,
    /// det J at the points.
    weights: [Octet; 8],
}

pub(super) const SCALE: Scale = Scale { linear: [G; 3], product: [G * G; 3], bends: [true; 3] };

impl FullGeometry {
    /// Geometry without extent: forces from it are zero. Pads the last octet of a patch.
    pub const EMPTY: Self = FullGeometry { field: Field::EMPTY, weights: [Octet::ZERO; 8] };

    /// Puts an element into a lane.
    pub fn set(&mut self, lane: usize, hex: &Hex8, elastic: &Stabilisation) {
        self.field.set(lane, hex, elastic, (0..8).map(|p| (gauss_point(p), hex.weights[p])));
        for p in 0..8 {
            self.weights[p].0[lane] = hex.weights[p];
        }
    }
}

impl FullGeometry {
    /// Strains at the points of the element in a lane, from its modal displacements.
    #[inline(always)]
    pub(super) fn strains(&self, modes: &[[f64; 8]; 3], lane: usize) -> [Sym<f64>; 8] {
        let mut e = self.field.strain::<f64>(modes, &SCALE, &[], lane);
        Field::to_points(&mut e);
        core::array::from_fn(|p| core::array::from_fn(|c| e[c][p]))
    }
}

impl FullShape for FullGeometry {
    type Field = Field;
    const EMPTY: Self = Self::EMPTY;

    fn set(&mut self, lane: usize, hex: &Hex8, elastic: &Stabilisation) {
        self.set(lane, hex, elastic);
    }

    #[inline(always)]
    fn field(&self) -> &Field {
        &self.field
    }

    #[inline(always)]
    fn weight<L: Lane>(&self, p: usize, at: usize) -> L {
        L::load(&self.weights[p], at)
    }
}

/// Internal forces of eight elements, added to `out`; history (point by point) is updated in place.
///
/// Arguments and sign as in [`super::one_point`]; strains reach the law in global axes, those of bricks in axes along their edges.
///
/// # Safety
/// All indices must be below `rows.len()` and `out.len()`, and the lane's instruction set must be enabled.
#[inline(always)]
pub unsafe fn full<L: Lane, G: FullShape, M: Material, const PROBE: bool>(
    material: &M,
    _: &Stabilisation,
    point: &Point<f64>,
    geometry: &G,
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
    let facts = material.facts();
    let columns = facts.columns;
    let field = geometry.field();
    let mut nodal = [[Octet::ZERO; 3]; 8];
    let mut at = 0;
    while at < 8 {
        // SAFETY: passed on to the caller.
        let modes = unsafe { gather_modes::<L>(rows, index, at) };
        let mut e = field.strain::<L>(&modes, &SCALE, given.strain, at);
        let mut pressed = Pressed::<L>::none();
        if let Some(water) = &given.water {
            let dilatation = field.dilatation(&e, &SCALE, at) - super::dilatation(given.strain, at);
            pressed = water.press(dilatation, at);
            super::widen(&mut e, &pressed);
        }
        G::Field::to_points(&mut e);

        // The law at the eight points; strains make room for weighted stresses.
        let mut lane_point = Point::<L>::splat(point);
        if facts.needs_size {
            lane_point.size = field.size(&given, at);
            lane_point.gradient = field.gradient(&modes, at);
        }
        let mut energy = L::splat(0.0);
        let (mut dissipated, mut created, mut of_band) = (energy, energy, energy);
        let mut moved = [[L::splat(0.0); 8]; 6];
        let mut is_moved_known = false;
        let mut p = 0;
        while p < 8 {
            let strain: Sym<L> = [e[0][p], e[1][p], e[2][p], e[3][p], e[4][p], e[5][p]];
            let own = &mut history[p * columns..(p + 1) * columns];
            let answer = material.update_in_place(&lane_point, strain, own, at);
            if facts.damages && !left.is_empty() {
                super::keep_left(&answer.left, &mut left[p * LEFT..], at);
            }
            let of_law = answer.stress;
            let weight = geometry.weight::<L>(p, at);
            let mut stress = of_law;
            let mut held = L::splat(0.0);
            if let Some(band) = band {
                let memory = &mut overstress[p * MEMORY..(p + 1) * MEMORY];
                if facts.damages && !is_moved_known && band.asks(answer.before, answer.now) {
                    // SAFETY: passed on to the caller.
                    moved = unsafe { has_moved(field, index, given.moved, at) };
                    G::Field::to_points(&mut moved);
                    is_moved_known = true;
                }
                let moved = [moved[0][p], moved[1][p], moved[2][p], moved[3][p], moved[4][p], moved[5][p]];
                let carried = band.stress(&strain, answer.before, answer.now, &moved, memory, at);
                stress = super::plus(stress, carried);
                if PROBE && probe.wanted {
                    held = band.held(&strain, answer.now, memory, at);
                    of_band = weight.mul_add(BandStep::dissipated::<L>(memory, at), of_band);
                }
            }
            let mut c = 0;
            while c < 6 {
                e[c][p] = weight * stress[c];
                c += 1;
            }
            if PROBE && probe.wanted {
                let new: M::History<L> = load(own, at);
                let stored = material.stored_energy(&strain, &of_law, &new) + held;
                energy = weight.mul_add(stored, energy);
                dissipated = weight.mul_add(super::booked(&new, facts.dissipation), dissipated);
                created = weight.mul_add(super::booked(&new, facts.creation), created);
                let stress = field.global(&stress, at);
                let mut c = 0;
                while c < 6 {
                    stress[c].store(&mut probe.stress[p][c], at);
                    c += 1;
                }
            }
            p += 1;
        }
        if PROBE && probe.wanted {
            if let Some(water) = &given.water {
                energy = energy - water.given(&pressed, at);
            }
            energy.store(&mut probe.strain_energy, at);
            dissipated.store(&mut probe.dissipated, at);
            created.store(&mut probe.created, at);
            of_band.store(&mut probe.of_band, at);
        }

        // Back the same way.
        G::Field::to_resultants(&mut e);
        if let Some(water) = &given.water {
            let less = water.book(e[0][0] + e[1][0] + e[2][0], &pressed, at);
            field.press(&mut e, less, &SCALE, at);
        }
        let mut forces = field.forces::<L>(e, &SCALE, at);
        store_nodal(&mut forces, &mut nodal, at);
        at += L::WIDTH;
    }
    // SAFETY: passed on to the caller.
    unsafe { scatter_nodal::<L>(out, index, &nodal) };
}

/// How far the strain has moved in the step, by its coefficients; not at all where no increments are given.
///
/// # Safety
/// As for [`full`].
#[inline(always)]
unsafe fn has_moved<L: Lane>(
    field: &impl FieldShape,
    index: &[[u16; 8]; 8],
    moved: &[Row],
    at: usize,
) -> [[L; 8]; 6] {
    if moved.is_empty() {
        return [[L::splat(0.0); 8]; 6];
    }
    // SAFETY: passed on to the caller.
    let modes = unsafe { gather_modes::<L>(moved, index, at) };
    field.strain::<L>(&modes, &SCALE, &[], at)
}
