//! 2×2 points in the plane of a lining and several through its thickness, which is ζ, of the assumed-strain field.
//!
//! The field is linear in ζ, so a layer's strain has four coefficients in ξ and η, those of its four points: each layer is worked
//! on by itself and adds its resultants and their first moments. All that the element owes to its quadrature are the weights,
//! which make 1 and ζ² exact through the thickness ([`Through`]) as Gauss's two do, and the means that go with them: elastic
//! parallelepipeds are those of 2×2×2 points to round-off.
//!
//! Damping over a band is kept by the strain's coefficients in place of its values at the points (`bodies.rs`): 1352 bytes an
//! element in place of 7200 with nine layers.

use super::bodies::{self, Bodies};
use super::field::{Field, FieldShape, G, Scale};
use super::geometry::determinant_at;
use super::layer::{LayeredShape, add_elastic, add_layer, elastic_energy, in_layer, moments, of_point};
use super::pores::Pressed;
use super::quadrature::Through;
use super::{Given, Hex8, LEFT, Probe, Stabilisation, gather_modes, gauss_point, scatter_nodal, store_nodal};
use crate::band::BandStep;
use crate::lane::{Lane, Octet, Row};
use crate::material::{Material, Moduli, Point, load};

/// Geometry of eight elements of any shape; 138 octets, that is 1104 bytes an element, however many layers there are.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct LayeredGeometry {
    field: Field,
    /// det J at the four points of a layer, as coefficients of 1, ζ and ζ².
    depth: [[Octet; 3]; 4],
}

const SCALE: Scale = Scale { linear: [G, G, 1.0], product: [G, G, G * G], bends: [false, false, true] };

impl LayeredGeometry {
    /// Geometry without extent: forces from it are zero. Pads the last octet of a patch.
    pub const EMPTY: Self = LayeredGeometry { field: Field::EMPTY, depth: [[Octet::ZERO; 3]; 4] };

    /// Puts an element, numbered so that ζ is its thickness, into a lane.
    pub fn set(&mut self, lane: usize, hex: &Hex8, elastic: &Stabilisation, through: &Through) {
        let depth: [[f64; 3]; 4] = core::array::from_fn(|q| {
            let [xi, eta, _] = gauss_point(q);
            let [low, middle, high] =
                [-1.0, 0.0, 1.0].map(|zeta| determinant_at(&hex.corners, [xi, eta, zeta]));
            [middle, 0.5 * (high - low), 0.5 * (high + low) - middle]
        });
        let points = (0..4 * through.count).map(|p| {
            let [xi, eta, _] = gauss_point(p % 4);
            let (zeta, weight) = (through.zeta[p / 4], through.weight[p / 4]);
            let [a, b, c] = depth[p % 4];
            ([xi, eta, zeta], weight * (a + zeta * (b + zeta * c)))
        });
        self.field.set(lane, hex, elastic, points);
        for (octets, values) in self.depth.iter_mut().zip(depth) {
            for (octet, value) in octets.iter_mut().zip(values) {
                octet.0[lane] = value;
            }
        }
    }
}

impl LayeredShape for LayeredGeometry {
    type Field = Field;
    const EMPTY: Self = Self::EMPTY;

    fn set(&mut self, lane: usize, hex: &Hex8, elastic: &Stabilisation, through: &Through) {
        self.set(lane, hex, elastic, through);
    }

    #[inline(always)]
    fn field(&self) -> &Field {
        &self.field
    }

    /// det J times the weight of a point in a layer.
    #[inline(always)]
    fn weight<L: Lane>(&self, through: &Through, layer: usize, q: usize, at: usize) -> L {
        let (depth, zeta) = (&self.depth[q], L::splat(through.zeta[layer]));
        let linear = zeta.mul_add(L::load(&depth[2], at), L::load(&depth[1], at));
        L::splat(through.weight[layer]) * zeta.mul_add(linear, L::load(&depth[0], at))
    }

    #[inline(always)]
    fn add_elastic<L: Lane>(
        &self,
        through: &Through,
        sums: &mut [[L; 8]; 6],
        moduli: &Moduli,
        e: &[[L; 8]; 6],
        at: usize,
    ) {
        add_elastic(sums, moduli, e, &moments(through, &self.depth, at));
    }

    #[inline(always)]
    fn elastic_energy<L: Lane>(&self, through: &Through, moduli: &Moduli, e: &[[L; 8]; 6], at: usize) -> L {
        elastic_energy(moduli, e, &moments(through, &self.depth, at))
    }
}

/// Internal forces of eight elements, added to `out`; history (layer by layer, four points in each) is updated in place.
///
/// Arguments and sign as in [`super::one_point`]; strains reach the law in global axes, those of bricks in axes along their edges. `overstress` has
/// [`super::MODAL_MEMORY`] octets.
///
/// # Safety
/// All indices must be below `rows.len()` and `out.len()`, and the lane's instruction set must be enabled.
#[inline(always)]
pub unsafe fn layered<L: Lane, G: LayeredShape, M: Material, const PROBE: bool>(
    through: &Through,
    material: &M,
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
        let zero = L::splat(0.0);
        let mut taken = zero;
        let mut band = match band {
            Some(step) => {
                Some((step, Bodies::advance(step, &e, overstress, (through, geometry), &mut taken, at)))
            }
            None => None,
        };
        let mut lane_point = Point::<L>::splat(point);
        if facts.needs_size {
            lane_point.size = field.size(&given, at);
            lane_point.gradient = field.gradient(&modes, at);
        }
        let mut sums = [[zero; 8]; 6];
        if let Some((step, bodies)) = &band {
            bodies.add_whole(step, &mut sums, (through, geometry), at);
        }
        let mut is_moved_known = false;
        let (mut energy, mut dissipated, mut created) = (zero, zero, zero);
        let mut layer = 0;
        while layer < through.count {
            let zeta = through.zeta[layer];
            let mut values = in_layer(&e, zeta);
            let (mut weight, mut before, mut now) = ([zero; 4], [zero; 4], [zero; 4]);
            let mut q = 0;
            while q < 4 {
                let p = 4 * layer + q;
                let strain = of_point(&values, q);
                let own = &mut history[p * columns..(p + 1) * columns];
                let answer = material.update_in_place(&lane_point, strain, own, at);
                if facts.damages && !left.is_empty() {
                    super::keep_left(&answer.left, &mut left[p * LEFT..], at);
                }
                weight[q] = geometry.weight(through, layer, q, at);
                (before[q], now[q]) = (answer.before, answer.now);
                let mut c = 0;
                while c < 6 {
                    values[c][q] = weight[q] * answer.stress[c];
                    c += 1;
                }
                if PROBE && probe.wanted {
                    let new: M::History<L> = load(own, at);
                    let mut stress = answer.stress;
                    let mut stored = material.stored_energy(&strain, &stress, &new);
                    if let Some((step, bodies)) = &band {
                        let carried = bodies.stress(step, zeta, q);
                        let mut c = 0;
                        while c < 6 {
                            stress[c] = answer.now.mul_add(carried[c], stress[c]);
                            c += 1;
                        }
                        stored = stored + bodies::held(step, &strain, overstress, zeta, q, answer.now, at);
                    }
                    energy = weight[q].mul_add(stored, energy);
                    dissipated = weight[q].mul_add(super::booked(&new, facts.dissipation), dissipated);
                    created = weight[q].mul_add(super::booked(&new, facts.creation), created);
                    let stress = field.global(&stress, at);
                    let mut c = 0;
                    while c < 6 {
                        stress[c].store(&mut probe.stress[p][c], at);
                        c += 1;
                    }
                }
                q += 1;
            }
            if facts.damages
                && let Some((step, bodies)) = &mut band
            {
                let least = now[0].smaller(now[1]).smaller(now[2].smaller(now[3]));
                if L::any(least.less(L::splat(1.0))) {
                    let asks = step.asks(before[0], now[0])
                        | step.asks(before[1], now[1])
                        | step.asks(before[2], now[2])
                        | step.asks(before[3], now[3]);
                    if asks && !is_moved_known && !given.moved.is_empty() {
                        // SAFETY: passed on to the caller.
                        let modes = unsafe { gather_modes::<L>(given.moved, index, at) };
                        bodies.has_moved(field.strain::<L>(&modes, &SCALE, &[], at));
                        is_moved_known = true;
                    }
                    let shares = [&before, &now];
                    let beyond = bodies.lessen(step, &e, overstress, zeta, &weight, shares, &mut values, at);
                    taken = taken + beyond;
                }
            }
            add_layer(&mut sums, &values, zeta);
            layer += 1;
        }
        if let Some((step, _)) = &band {
            bodies::book(step, taken, overstress, at);
        }
        if PROBE && probe.wanted {
            if let Some(water) = &given.water {
                energy = energy - water.given(&pressed, at);
            }
            energy.store(&mut probe.strain_energy, at);
            dissipated.store(&mut probe.dissipated, at);
            created.store(&mut probe.created, at);
            if band.is_some() {
                bodies::dissipated::<L>(overstress, at).store(&mut probe.of_band, at);
            }
        }
        if let Some(water) = &given.water {
            let less = water.book(sums[0][0] + sums[1][0] + sums[2][0], &pressed, at);
            field.press(&mut sums, less, &SCALE, at);
        }
        let mut forces = field.forces::<L>(sums, &SCALE, at);
        store_nodal(&mut forces, &mut nodal, at);
        at += L::WIDTH;
    }
    // SAFETY: passed on to the caller.
    unsafe { scatter_nodal::<L>(out, index, &nodal) };
}

/// Forces of the elasticity that damage has left ([`LEFT`] octets a point) times a factor of each element, added to `out`. What a
/// whole element would carry is integrated in closed form; points that damage has weakened take theirs off it.
///
/// # Safety
/// As for [`layered`].
#[inline(always)]
pub unsafe fn layered_left<L: Lane, G: LayeredShape>(
    through: &Through,
    moduli: &Moduli,
    geometry: &G,
    index: &[[u16; 8]; 8],
    left: &[Octet],
    factor: &Octet,
    rows: &[Row],
    out: &mut [Row],
) {
    let field = geometry.field();
    let (zero, three) = (L::splat(0.0), L::splat(3.0));
    let mut nodal = [[Octet::ZERO; 3]; 8];
    let mut at = 0;
    while at < 8 {
        // SAFETY: passed on to the caller.
        let modes = unsafe { gather_modes::<L>(rows, index, at) };
        let e = field.strain::<L>(&modes, &SCALE, &[], at);
        let mut sums = [[zero; 8]; 6];
        geometry.add_elastic(through, &mut sums, moduli, &e, at);
        let mut layer = 0;
        while layer < through.count {
            let zeta = through.zeta[layer];
            let mut traces = [zero; 4];
            let mut q = 0;
            while q < 4 {
                let v = &left[(4 * layer + q) * LEFT..];
                traces[q] = L::load(&v[0], at) + L::load(&v[1], at) + L::load(&v[2], at);
                q += 1;
            }
            let least = traces[0].smaller(traces[1]).smaller(traces[2].smaller(traces[3]));
            if L::any(least.less(three)) {
                let mut values = in_layer(&e, zeta);
                let mut q = 0;
                while q < 4 {
                    let strain = of_point(&values, q);
                    let v = super::load_tensor(&left[(4 * layer + q) * LEFT..], at);
                    let (whole, part) = (moduli.stress(&strain), moduli.stress_left(&strain, &v));
                    let weight = geometry.weight(through, layer, q, at);
                    // A closed crack leaves V at I but for the round-off of its axes: it carries all.
                    let weight = L::select(traces[q].less(three), weight, zero);
                    let mut c = 0;
                    while c < 6 {
                        values[c][q] = weight * (part[c] - whole[c]);
                        c += 1;
                    }
                    q += 1;
                }
                add_layer(&mut sums, &values, zeta);
            }
            layer += 1;
        }
        let factor = L::load(factor, at);
        let mut c = 0;
        while c < 6 {
            let mut mode = 0;
            while mode < 7 {
                sums[c][mode] = factor * sums[c][mode];
                mode += 1;
            }
            c += 1;
        }
        let mut forces = field.forces::<L>(sums, &SCALE, at);
        store_nodal(&mut forces, &mut nodal, at);
        at += L::WIDTH;
    }
    // SAFETY: passed on to the caller.
    unsafe { scatter_nodal::<L>(out, index, &nodal) };
}
