//! Pairs of an interface as a part: what opens, closes and slides between two surfaces.
//!
//! A pair is two nodes at one place with the area and normal of the faces around them. Its relative displacement
//! d = u₂ − u₁, counted from its activation, has the gap d·m and the slips d·e₁, d·e₂; the law answers with p and t per area,
//! and the second node is pushed by A(p m + t), the first by the opposite, bit for bit (`wang2018` (28), (29), with the sign
//! that restores). Normals do not turn: slip must stay well below an element.

mod memory;
mod pass;

pub use memory::{EXTRA, PairSeen};
pub(crate) use memory::{gap, load, seen};

use crate::line::{Line, Lines};
use crate::part::{Kept, Motion, Own, Part, Scratch, StateSizes, Tick};
use pass::Pass;
use std::sync::Arc;
use tremolite_laws::{Interface, Isa, Octet, Row};

/// A pair among the nodes of its part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair {
    /// Positions of the first and second side's node.
    pub nodes: [u16; 2],
    /// m, out of the first side into the second, and the tangents e₁, e₂.
    pub axes: [[f64; 3]; 3],
    /// |A_n| \[m²\]
    pub area: f64,
}

/// Geometry of eight pairs.
#[derive(Clone, Copy, Debug)]
struct Geometry {
    index: [[u16; 8]; 2],
    /// m, e₁, e₂ by component.
    axes: [[Octet; 3]; 3],
    area: Octet,
}

impl Geometry {
    /// Pairs without area.
    const EMPTY: Geometry = Geometry { index: [[0; 8]; 2], axes: [[Octet::ZERO; 3]; 3], area: Octet::ZERO };
}

/// Pairs of one interface that a thread works on together.
pub struct Contact<I: Interface> {
    law: Arc<I>,
    isa: Isa,
    nodes: Vec<u32>,
    pairs: Vec<Pair>,
    geometry: Vec<Geometry>,
    /// Pressure over closing velocity \[Pa s/m\] of closed pairs whose bond is broken.
    damping: f64,
}

impl<I: Interface> Contact<I> {
    /// A part of pairs over its nodes.
    ///
    /// # Panics
    /// If there are no nodes, or a pair's are not among them.
    pub fn new(law: Arc<I>, nodes: Vec<u32>, pairs: &[Pair], damping: f64, isa: Isa) -> Self {
        assert!(pairs.iter().flat_map(|pair| pair.nodes).all(|n| (n as usize) < nodes.len()));
        assert!(!nodes.is_empty());
        let mut geometry = vec![Geometry::EMPTY; pairs.len().div_ceil(8)];
        for (k, pair) in pairs.iter().enumerate() {
            let (to, lane) = (&mut geometry[k / 8], k % 8);
            for side in 0..2 {
                to.index[side][lane] = pair.nodes[side];
            }
            for (axis, components) in pair.axes.iter().zip(&mut to.axes) {
                for (x, component) in axis.iter().zip(components) {
                    component.0[lane] = *x;
                }
            }
            to.area.0[lane] = pair.area;
        }
        let isa = if isa.available() { isa } else { Isa::Scalar };
        Contact { law, isa, nodes, pairs: pairs.to_vec(), geometry, damping }
    }

    /// Columns of a pair: those of its law, then the part's own.
    const WIDTH: usize = I::HISTORY.len() + EXTRA;

    /// w₂ − w₁ of a pair.
    fn across(&self, pair: &Pair, w: &[Row]) -> [f64; 3] {
        let [a, b] = pair.nodes.map(|n| w[self.nodes[n as usize] as usize]);
        [0, 1, 2].map(|i| b.0[i] - a.0[i])
    }

    /// Adds A(normal m m + tangential (I − m m)) (w₂ − w₁) of every pair.
    fn product(&self, normal: f64, tangential: f64, w: &[Row], out: &mut [Row]) {
        out.fill(Row::ZERO);
        for pair in &self.pairs {
            let d = self.across(pair, w);
            let [m, ..] = pair.axes;
            let along = d[0] * m[0] + d[1] * m[1] + d[2] * m[2];
            for i in 0..3 {
                let force = pair.area * (tangential * d[i] + (normal - tangential) * along * m[i]);
                out[pair.nodes[0] as usize].0[i] -= force;
                out[pair.nodes[1] as usize].0[i] += force;
            }
        }
    }
}

impl<I: Interface> Part for Contact<I> {
    fn nodes(&self) -> &[u32] {
        &self.nodes
    }

    fn bytes(&self) -> usize {
        let Contact { nodes, pairs, geometry, .. } = self;
        size_of_val(&nodes[..]) + size_of_val(&pairs[..]) + size_of_val(&geometry[..])
    }

    fn state_sizes(&self) -> StateSizes {
        StateSizes { history: Self::WIDTH * self.geometry.len(), ..StateSizes::default() }
    }

    /// From now on d counts from here.
    fn begin(&self, x: &Motion, own: Own) {
        for (k, pair) in self.pairs.iter().enumerate() {
            let rows = pair.nodes.map(|n| x.u[self.nodes[n as usize] as usize]);
            memory::activate::<I>(own.history, k, [0, 1, 2].map(|i| rows[1].0[i] - rows[0].0[i]));
        }
    }

    /// What impacts gain counts from here.
    fn settle(&self, own: Own) {
        (0..self.pairs.len()).for_each(|k| memory::settle(&*self.law, own.history, k));
    }

    fn forces(&self, tick: &Tick, x: &Motion, own: Own, out: &mut [Row], scratch: &mut Scratch) -> Lines {
        let damping = if tick.dt > 0.0 { self.damping / tick.dt } else { 0.0 };
        let Scratch { rows, others, .. } = scratch;
        rows.clear();
        rows.extend(self.nodes.iter().map(|&n| x.u[n as usize]));
        others.clear();
        others.extend(self.nodes.iter().map(|&n| x.increment(n)));
        out.fill(Row::ZERO);
        let mut lines = Lines::default();
        lines[Line::ContactDamping] = pass::dispatch(
            self.isa,
            Pass {
                law: &*self.law,
                geometry: &self.geometry,
                history: own.history,
                rows,
                increments: others,
                out,
                damping,
            },
        );
        lines
    }

    /// What pairs hold, have lost to friction and breaking bonds, and given out.
    fn energy(&self, x: &Motion, kept: Kept) -> Lines {
        let mut lines = Lines::default();
        for (k, pair) in self.pairs.iter().enumerate() {
            let (mut history, extra) = memory::read::<I>(kept.history, k);
            let d = self.across(pair, x.u);
            let d = [0, 1, 2].map(|i| d[i] - extra[memory::OFFSET + i]);
            let [gap, slip1, slip2] = pair.axes.map(|a| a[0] * d[0] + a[1] * d[1] + a[2] * d[2]);
            // Pairs that were evaluated here already answer with the same.
            let shear;
            (_, shear, history) = self.law.update(gap, [slip1, slip2], history);
            let of = |column: usize| pair.area * history.as_ref()[column];
            lines[Line::Interface] += pair.area * self.law.stored_energy(gap, shear, &history);
            lines[Line::Friction] += of(I::DISSIPATION);
            lines[Line::CreatedByInterface] += of(I::CREATION);
        }
        lines
    }

    fn stiffness_times(&self, w: &[Row], out: &mut [Row], _: &mut Scratch) {
        let [normal, tangential] = self.law.stiffest();
        self.product(normal, tangential, w, out);
    }

    fn viscosity_times(&self, w: &[Row], out: &mut [Row], _: &mut Scratch) -> bool {
        if self.damping > 0.0 {
            self.product(self.damping, 0.0, w, out);
        }
        self.damping > 0.0
    }
}
