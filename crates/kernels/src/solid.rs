//! A patch of hexahedra of one law and one quadrature: the unit of threads and the fused kernel.

#[cfg(target_arch = "x86_64")]
mod any;
mod pass;
mod pores;
mod prescribed;
mod rule;
mod weakened;

pub use rule::{Full, FullBricks, Layered, OnePoint, Rule};

use crate::line::{Line, Lines};
use crate::part::{ElementEnergy, Entry, Kept, Motion, Own, Part, ProbeOut, Scratch, StateSizes, Tick};
use crate::stage::Stage;
use pass::{After, ONE, Pass, dispatch, dispatch_rare, products, whole};
pub use pores::PoresOf;
use pores::Porous;
use prescribed::Prescribed;
use std::sync::Arc;
use tremolite_laws::band::{Band, BandStep};
use tremolite_laws::materials::Elastic;
use tremolite_laws::shapes::hex8::{Given, Hex8, LEFT, Stabilisation};
use tremolite_laws::{Column, Isa, Material, Moduli, Octet, Point, Row};
use weakened::{Remembered, Weakened};

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
    /// Artificial viscosity over stiffness \[s\], an octet of elements each; empty without.
    viscosity: Vec<Octet>,
    /// Size tensors that the law sees in place of the elements' own, six octets an octet of elements; empty for their own.
    sizes: Vec<Octet>,
    /// Water in the shaking, which cannot leave the pores; none without.
    porous: Option<Porous>,
    rule: R,
}

impl<M: Material, R: Rule> Solid<M, R> {
    /// A patch integrated by a rule, from its nodes, the elements' corners as positions among them (VTK order), and their geometry.
    ///
    /// `moduli` are the material's own; with a band, which adds to them, the law must have the relaxed ones. `viscosity` is
    /// that of each element over its stiffness \[s\], or empty; `sizes` are the size tensors \[m²\] that the law is to see
    /// ([`tremolite_laws::Point::size`]), or empty for the elements' own. `pores` are those of each element in which water changes its
    /// pressure as the ground shakes, or empty.
    ///
    /// # Panics
    /// If a corner is not among the nodes, or corners, geometry, viscosity, sizes and pores differ in number.
    pub fn new(
        rule: R,
        law: Arc<M>,
        moduli: Moduli,
        band: Option<Band>,
        nodes: Vec<u32>,
        corners: &[[u16; 8]],
        geometry: &[Hex8],
        viscosity: &[f64],
        sizes: &[[f64; 6]],
        pores: &[PoresOf],
        isa: Isa,
    ) -> Self {
        assert_eq!(corners.len(), geometry.len());
        assert!(viscosity.is_empty() || viscosity.len() == corners.len());
        assert!(sizes.is_empty() || sizes.len() == corners.len());
        assert!(pores.is_empty() || pores.len() == corners.len());
        assert!(corners.iter().flatten().all(|&c| (c as usize) < nodes.len()));
        let stabilisation = Stabilisation::new(moduli);
        let bending = if M::FLOWS { Stabilisation::flowing(moduli) } else { stabilisation };
        let octets = corners.len().div_ceil(8);
        let law_moduli = law.moduli();
        let mut index = vec![[[0; 8]; 8]; octets];
        let mut packed = vec![R::EMPTY; octets];
        for (e, (corner, hex)) in corners.iter().zip(geometry).enumerate() {
            for k in 0..8 {
                index[e / 8][k][e % 8] = corner[k];
            }
            rule.set(&mut packed[e / 8], e % 8, hex, &bending);
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
            viscosity: viscosity
                .chunks(8)
                .map(|eight| Octet(std::array::from_fn(|lane| eight.get(lane).copied().unwrap_or(0.0))))
                .collect(),
            sizes: sizes
                .chunks(8)
                .flat_map(|eight| {
                    (0..6).map(|c| {
                        Octet(std::array::from_fn(|lane| eight.get(lane).map_or(0.0, |size| size[c])))
                    })
                })
                .collect(),
            porous: Porous::of(pores, geometry, law_moduli),
            rule,
        }
    }

    /// Displacements of the nodes since they were `reference`, which may be empty.
    fn since<'s>(&self, u: &[Row], reference: &[Row], rows: &'s mut Vec<Row>) -> &'s [Row] {
        self.gather(u, rows);
        for (row, before) in rows.iter_mut().zip(reference) {
            for i in 0..4 {
                row.0[i] -= before.0[i];
            }
        }
        rows
    }

    fn gather<'s>(&self, global: &[Row], rows: &'s mut Vec<Row>) -> &'s [Row] {
        rows.clear();
        rows.extend(self.nodes.iter().map(|&n| global[n as usize]));
        rows
    }

    fn pass<'a>(
        &'a self,
        dt: f64,
        history: &'a mut [Octet],
        band: Option<BandStep>,
        overstress: &'a mut [Octet],
        strain: &'a [Octet],
        rows: &'a [Row],
        out: &'a mut [Row],
        probe: Option<ProbeOut<'a>>,
    ) -> Pass<'a, R> {
        assert!(rows.len() == self.nodes.len() && out.len() == self.nodes.len());
        out.fill(Row::ZERO);
        Pass {
            rule: &self.rule,
            stabilisation: &self.stabilisation,
            point: Point { looked_at: probe.is_some(), ..Point::new(dt) },
            index: &self.index,
            geometry: &self.geometry,
            history,
            band,
            overstress,
            given: Given { strain, size: &self.sizes, moved: &[], water: None },
            rows,
            out,
            probe,
            after: None,
        }
    }

    /// Forces of the law, its band and artificial viscosity, and what the latter took.
    fn evaluate<const PROBE: bool>(
        &self,
        tick: &Tick,
        x: &Motion,
        own: Own,
        out: &mut [Row],
        probe: Option<ProbeOut>,
        scratch: &mut Scratch,
    ) -> Lines {
        let Scratch { rows, others, out: second, left, held, .. } = scratch;
        let viscous = !self.viscosity.is_empty() && tick.dt > 0.0;
        let band = self.band.map(|b| b.step(tick.dt, self.law.moduli(), tick.step));
        let law = self.weakened();
        let rows = self.since(x.u, own.reference, rows);
        let Own { history, overstress, initial, numbers, .. } = own;
        let (of_viscosity, of_pores) = numbers.split_at_mut(self.viscous_numbers());
        let mut pass = self.pass(tick.dt, history, band, overstress, initial, rows, out, probe);
        let every = self.law.slow_steps(tick.dt);
        let (brings, late) = match tick.step % every {
            0 => (true, every),
            late => (false, late),
        };
        pass.point = Point { brings, since: late as f64 * tick.dt, ..pass.point };
        if viscous || (M::DAMAGES && self.band.is_some()) {
            others.clear();
            others.extend(self.nodes.iter().map(|&n| x.increment(n)));
            pass.given.moved = &others[..];
        }
        if viscous {
            second.clear();
            second.resize(self.nodes.len(), Row::ZERO);
            let rows = &others[..];
            pass.after =
                Some(After { law: &law, rows, out: second, factor: &self.viscosity, left: self.room(left) });
        }
        // Before the shaking, while time stands still, pressures are given.
        let porous = self.porous.as_ref().filter(|_| tick.dt > 0.0);
        if let Some(porous) = porous {
            pass.given.water = Some(porous.remembered(of_pores, held));
        }
        if PROBE {
            dispatch_rare::<R, M, true>(self.isa, &*self.law, pass);
        } else {
            dispatch::<R, M>(self.isa, &*self.law, pass);
        }
        let mut lines = Lines::default();
        if let Some(porous) = porous {
            lines[Line::PoreWater] = porous.remember(held, of_pores);
        }
        if viscous {
            lines[Line::Viscosity] = resist(1.0 / tick.dt, others, second, of_viscosity, out);
        }
        lines
    }

    /// Room for what is left at the points of an octet.
    fn room<'s>(&self, left: &'s mut Vec<Octet>) -> &'s mut [Octet] {
        left.resize(self.rule.points() * LEFT, Octet::ZERO);
        left
    }

    /// Elastic forces times a factor of each element, 1 if empty.
    fn whole_times(&self, factor: &[Octet], w: &[Row], out: &mut [Row], scratch: &mut Scratch) {
        let Scratch { rows, left, .. } = scratch;
        left.clear();
        left.extend((0..self.rule.points()).flat_map(|_| whole(ONE)));
        let law = self.weakened();
        let rows = self.gather(w, rows);
        products(self.isa, &law, self.pass(0.0, &mut [], None, &mut [], &[], rows, out, None), factor, left);
    }

    /// K w of the law alone: water does not damp by ξK.
    fn law_times(&self, w: &[Row], out: &mut [Row], scratch: &mut Scratch) {
        if R::CLOSED {
            return self.whole_times(&[], w, out, scratch);
        }
        let rows = self.gather(w, &mut scratch.rows);
        let pass = self.pass(0.0, &mut [], None, &mut [], &[], rows, out, None);
        dispatch::<R, Elastic>(self.isa, &self.elastic, pass);
    }

    /// How many numbers artificial viscosity remembers.
    fn viscous_numbers(&self) -> usize {
        if self.viscosity.is_empty() { 0 } else { 3 * self.nodes.len() }
    }

    fn weakened(&self) -> Weakened {
        Weakened(self.elastic.moduli())
    }
}

/// Adds the forces of artificial viscosity at v⁻, which are `forces` times `rate` \[1/s\], to `out`; the work \[J\] that they
/// did over the last increments `du`, by the mean of the forces at its ends. `numbers` remembers the forces.
fn resist(rate: f64, du: &[Row], forces: &[Row], numbers: &mut [f64], out: &mut [Row]) -> f64 {
    let mut work = 0.0;
    for ((du, (force, out)), last) in du.iter().zip(forces.iter().zip(out)).zip(numbers.chunks_exact_mut(3)) {
        for i in 0..3 {
            let now = rate * force.0[i];
            work += 0.5 * (last[i] + now) * du.0[i];
            out.0[i] += now;
            last[i] = now;
        }
    }
    work
}

impl<M: Material, R: Rule> Part for Solid<M, R> {
    fn nodes(&self) -> &[u32] {
        &self.nodes
    }

    fn state_sizes(&self) -> StateSizes {
        let octets = self.index.len();
        StateSizes {
            history: octets * self.rule.points() * self.law.columns().len(),
            overstress: if self.band.is_some() { octets * self.rule.memory() } else { 0 },
            numbers: self.viscous_numbers() + self.porous.as_ref().map_or(0, Porous::numbers),
        }
    }

    fn elements(&self) -> (usize, usize) {
        (self.elements, self.rule.points())
    }

    fn columns(&self) -> &'static [Column] {
        self.law.columns()
    }

    fn bytes(&self) -> usize {
        let Solid { nodes, index, geometry, viscosity, sizes, porous, .. } = self;
        let packed = size_of_val(&index[..]) + size_of_val(&geometry[..]);
        let given = size_of_val(&viscosity[..]) + size_of_val(&sizes[..]);
        size_of_val(&nodes[..]) + packed + given + porous.as_ref().map_or(0, Porous::bytes)
    }

    fn keeps_books(&self) -> bool {
        M::HISTORY.is_empty() || M::DISSIPATION.is_some()
    }

    /// In the shaking pressures count from where it begins, which the next evaluation finds.
    fn enter(&self, entry: &Entry, own: Own) {
        if let Some(porous) = self.porous.as_ref().filter(|_| entry.stage == Stage::Shaking) {
            porous.begin(&mut own.numbers[self.viscous_numbers()..]);
        }
    }

    fn pressures(&self, kept: Kept, change: &mut [f64]) {
        if let Some(porous) = &self.porous {
            porous.pressures(&kept.numbers[self.viscous_numbers()..], change);
        }
    }

    /// From now on displacements count from here.
    fn begin(&self, x: &Motion, own: Own) {
        for (reference, &node) in own.reference.iter_mut().zip(&self.nodes) {
            *reference = x.u[node as usize];
        }
    }

    fn forces(&self, tick: &Tick, x: &Motion, own: Own, out: &mut [Row], scratch: &mut Scratch) -> Lines {
        self.evaluate::<false>(tick, x, own, out, None, scratch)
    }

    fn probe(
        &self,
        tick: &Tick,
        x: &Motion,
        own: Own,
        out: &mut [Row],
        probe: ProbeOut,
        scratch: &mut Scratch,
    ) -> Lines {
        self.evaluate::<true>(tick, x, own, out, Some(probe), scratch)
    }

    fn damping_times(&self, u: &[Row], kept: Kept, w: &[Row], out: &mut [Row], scratch: &mut Scratch) {
        if !M::DAMAGES {
            return self.law_times(w, out, scratch);
        }
        let Scratch { rows, others, out: unused, history: own, left, .. } = scratch;
        own.clear();
        own.extend_from_slice(kept.history);
        unused.resize(self.nodes.len(), Row::ZERO);
        let (law, weakened) = (Remembered(self.law.clone()), self.weakened());
        let u = self.since(u, kept.reference, rows);
        let mut pass = self.pass(0.0, own, None, &mut [], kept.initial, u, unused, None);
        out.fill(Row::ZERO);
        let rows = self.gather(w, others);
        pass.after = Some(After { law: &weakened, rows, out, factor: &[], left: self.room(left) });
        dispatch_rare::<R, Remembered<M>, false>(self.isa, &law, pass);
    }

    fn viscosity_times(&self, w: &[Row], out: &mut [Row], scratch: &mut Scratch) -> bool {
        if self.viscosity.is_empty() {
            return false;
        }
        self.whole_times(&self.viscosity, w, out, scratch);
        true
    }

    fn stress_forces(&self, stress: &[[f64; 6]], out: &mut [Row], scratch: &mut Scratch) {
        let Scratch { rows, history, .. } = scratch;
        let points = self.rule.points();
        rows.clear();
        rows.resize(self.nodes.len(), Row::ZERO);
        history.clear();
        history.resize(6 * points * self.index.len(), Octet::ZERO);
        for (k, point) in stress.iter().enumerate() {
            let (element, point_of_it) = (k / points, k % points);
            let first = 6 * (element / 8 * points + point_of_it);
            let own = R::local(&self.geometry[element / 8], element % 8, point);
            for (octet, value) in history[first..].iter_mut().zip(own) {
                octet.0[element % 8] = value;
            }
        }
        let law = Prescribed(self.elastic.moduli());
        dispatch_rare::<R, Prescribed, false>(
            self.isa,
            &law,
            self.pass(0.0, history, None, &mut [], &[], rows, out, None),
        );
    }

    fn stiffness_times(&self, w: &[Row], out: &mut [Row], scratch: &mut Scratch) {
        let Some(porous) = &self.porous else { return self.law_times(w, out, scratch) };
        let Scratch { rows, held, .. } = scratch;
        let rows = self.gather(w, rows);
        let mut pass = self.pass(0.0, &mut [], None, &mut [], &[], rows, out, None);
        pass.given.water = Some(porous.linear(held));
        dispatch::<R, Elastic>(self.isa, &self.elastic, pass);
    }

    fn stiffness_energy(&self, w: &[Row], energy: &mut [ElementEnergy], scratch: &mut Scratch) {
        let mut out = vec![Row::ZERO; self.nodes.len()];
        let mut stress = vec![[0.0; 6]; energy.len() * self.rule.points()];
        let probe = ProbeOut { stress: &mut stress, energy };
        let Scratch { rows, held, .. } = scratch;
        let rows = self.gather(w, rows);
        let mut pass = self.pass(0.0, &mut [], None, &mut [], &[], rows, &mut out, Some(probe));
        if let Some(porous) = &self.porous {
            pass.given.water = Some(porous.linear(held));
        }
        dispatch_rare::<R, Elastic, true>(self.isa, &self.elastic, pass);
        if let Some(porous) = &self.porous {
            porous.add_energy(held, energy);
        }
    }
}
