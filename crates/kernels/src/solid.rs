//! A patch of hexahedra of one law and one quadrature: the unit of threads and the fused kernel.

mod pass;
mod weakened;

pub use pass::{Full, OnePoint, Rule};

use crate::line::Lines;
use crate::part::{ElementEnergy, Motion, Own, Part, ProbeOut, Scratch, StateSizes, Tick};
use pass::{Pass, dispatch};
use std::marker::PhantomData;
use std::sync::Arc;
use tremolite_laws::band::{Band, BandStep, MEMORY};
use tremolite_laws::materials::Elastic;
use tremolite_laws::shapes::hex8::{Hex8, Stabilisation};
use tremolite_laws::{Column, Isa, Material, Moduli, Octet, Point, Row};
use weakened::{LEFT, Weakened};

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
        let bending = if M::FLOWS { Stabilisation::flowing(moduli) } else { stabilisation };
        let octets = corners.len().div_ceil(8);
        let mut index = vec![[[0; 8]; 8]; octets];
        let mut packed = vec![R::EMPTY; octets];
        for (e, (corner, hex)) in corners.iter().zip(geometry).enumerate() {
            for k in 0..8 {
                index[e / 8][k][e % 8] = corner[k];
            }
            R::set(&mut packed[e / 8], e % 8, hex, &bending);
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
            left: None,
        }
    }

    /// The Maxwell bodies over a step; none while time stands still, where without memory they would be springs.
    fn band_step(&self, dt: f64) -> Option<BandStep> {
        self.band.filter(|_| dt > 0.0).map(|b| b.step(dt, self.law.moduli()))
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

    fn columns(&self) -> &'static [Column] {
        M::HISTORY
    }

    fn keeps_books(&self) -> bool {
        self.band.is_none() && (M::HISTORY.is_empty() || M::DISSIPATION.is_some())
    }

    fn forces(&self, tick: &Tick, x: &Motion, own: Own, out: &mut [Row], scratch: &mut Scratch) -> Lines {
        let rows = self.gather(x.u, scratch);
        let band = self.band_step(tick.dt);
        dispatch::<R, M, false>(
            self.isa,
            self.pass(&*self.law, tick.dt, own.history, band, own.overstress, rows, out, None),
        );
        Lines::default()
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
        let rows = self.gather(x.u, scratch);
        let band = self.band_step(tick.dt);
        dispatch::<R, M, true>(
            self.isa,
            self.pass(&*self.law, tick.dt, own.history, band, own.overstress, rows, out, Some(probe)),
        );
        Lines::default()
    }

    fn damping_times(&self, u: &[Row], history: &[Octet], w: &[Row], out: &mut [Row], scratch: &mut Scratch) {
        if !M::DAMAGES {
            return self.stiffness_times(w, out, scratch);
        }
        let mut left = std::mem::take(&mut scratch.left);
        left.resize(self.index.len() * R::POINTS * LEFT, Octet::ZERO);
        let mut own = std::mem::take(&mut scratch.history);
        own.clear();
        own.extend_from_slice(history);
        // Time stands still: the law finds the damage that it left, and its forces are not wanted.
        let mut pass =
            self.pass(&*self.law, 0.0, &mut own, None, &mut [], self.gather(u, scratch), out, None);
        pass.left = Some(&mut left);
        dispatch::<R, M, true>(self.isa, pass);
        let weakened = Weakened(self.elastic.moduli());
        dispatch::<R, Weakened, false>(
            self.isa,
            self.pass(&weakened, 0.0, &mut left, None, &mut [], self.gather(w, scratch), out, None),
        );
        (scratch.left, scratch.history) = (left, own);
    }

    fn stiffness_times(&self, w: &[Row], out: &mut [Row], scratch: &mut Scratch) {
        let rows = self.gather(w, scratch);
        dispatch::<R, Elastic, false>(
            self.isa,
            self.pass(&self.elastic, 0.0, &mut [], None, &mut [], rows, out, None),
        );
    }

    fn stiffness_energy(&self, w: &[Row], energy: &mut [ElementEnergy], scratch: &mut Scratch) {
        let mut out = vec![Row::ZERO; self.nodes.len()];
        let mut stress = vec![[0.0; 6]; energy.len() * R::POINTS];
        let probe = ProbeOut { stress: &mut stress, energy };
        let rows = self.gather(w, scratch);
        dispatch::<R, Elastic, true>(
            self.isa,
            self.pass(&self.elastic, 0.0, &mut [], None, &mut [], rows, &mut out, Some(probe)),
        );
    }
}
