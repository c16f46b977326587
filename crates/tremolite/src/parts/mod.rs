//! Parts: everything that pushes on nodes. M a = −Σ over parts.

pub mod base;
pub mod loads;
pub mod solid;

use std::ops::Range;
use tremolite_laws::{Octet, Row};

/// How an element is integrated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Quadrature {
    /// One point and elastic stabilisation: fast, for rock.
    OnePoint,
    /// 2×2×2 points: sees bending cracks through a thickness, for linings.
    Full,
}

impl Quadrature {
    /// Integration points in an element.
    pub const fn points(self) -> usize {
        match self {
            Quadrature::OnePoint => 1,
            Quadrature::Full => 8,
        }
    }
}

/// What a part may know of the time.
#[derive(Clone, Copy, Debug)]
pub struct Tick {
    /// Time of the displacements \[s\].
    pub time: f64,
    /// Step \[s\].
    pub dt: f64,
}

/// Motion of all nodes at a time.
#[derive(Clone, Copy)]
pub struct Motion<'a> {
    /// Displacement u^n \[m\].
    pub u: &'a [Row],
    /// Increment u^n − u^(n−1) \[m\].
    pub du: &'a [Row],
}

/// What a part alone reads and writes of the state.
pub struct Own<'a> {
    /// History of the law, octet by octet.
    pub history: &'a mut [Octet],
    /// Memory of the damping bodies, octet by octet.
    pub overstress: &'a mut [Octet],
    /// Other numbers that the part remembers.
    pub numbers: &'a mut [f64],
}

/// Lengths of a part's slices of the state.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StateSizes {
    /// Octets of the law's history.
    pub history: usize,
    /// Octets of the damping bodies.
    pub overstress: usize,
    /// Other numbers.
    pub numbers: usize,
}

/// Work of a part's forces on the nodes since the last step \[J\], by the line of the balance it belongs to; positive
/// where energy flows from the nodes into the part.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Work {
    /// Springs of the boundary.
    pub springs: f64,
    /// Incident waves and loads: negative where they drive the model.
    pub input: f64,
}

/// Energies of an element \[J\].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ElementEnergy {
    /// Held by the law at its points.
    pub strain: f64,
    /// Held by the stabilisation.
    pub hourglass: f64,
    /// Booked by the law as dissipated since the start.
    pub dissipated: f64,
    /// Booked by the law as created since the start.
    pub created: f64,
}

impl ElementEnergy {
    /// What the element holds.
    pub fn held(&self) -> f64 {
        self.strain + self.hourglass
    }
}

/// What a probing pass leaves per element and point.
pub struct ProbeOut<'a> {
    /// Stress \[Pa\] of every point, global axes, element by element.
    pub stress: &'a mut [[f64; 6]],
    /// Energies \[J\] of every element.
    pub energy: &'a mut [ElementEnergy],
}

/// Room a thread reuses from part to part.
#[derive(Default)]
pub struct Scratch {
    pub rows: Vec<Row>,
    /// A copy of a history.
    pub history: Vec<Octet>,
    /// What damage has left, point by point.
    pub left: Vec<Octet>,
}

/// Something that pushes on nodes. No part reads another's memory.
pub trait Part: Send + Sync {
    /// Nodes pushed, in the order of the part's contributions.
    fn nodes(&self) -> &[u32];
    /// Length of the part's slices of the state.
    fn state_sizes(&self) -> StateSizes {
        StateSizes::default()
    }
    /// Number of elements and of integration points in each; zero for parts without elements.
    fn elements(&self) -> (usize, usize) {
        (0, 0)
    }
    /// Whether all that the part's laws take and give out is booked in their histories.
    fn keeps_books(&self) -> bool {
        true
    }
    /// Forces that resist the displacements (sign of ∫Bᵀσ), one row a node, and the part's own work.
    fn forces(&self, tick: &Tick, x: &Motion, own: Own, out: &mut [Row], scratch: &mut Scratch) -> Work;
    /// As [`Part::forces`], and stresses and energies as well. Parts without elements need not provide it.
    fn probe(
        &self,
        tick: &Tick,
        x: &Motion,
        own: Own,
        out: &mut [Row],
        _: ProbeOut,
        scratch: &mut Scratch,
    ) -> Work {
        self.forces(tick, x, own, out, scratch)
    }
    /// K w with the elastic stiffness, as the power iteration wants it.
    fn stiffness_times(&self, w: &[Row], out: &mut [Row], scratch: &mut Scratch);
    /// K w as Rayleigh's damping ξK wants it: with what damage has left of the stiffness at displacements `u` and
    /// with this `history`.
    fn damping_times(
        &self,
        _u: &[Row],
        _history: &[Octet],
        w: &[Row],
        out: &mut [Row],
        scratch: &mut Scratch,
    ) {
        self.stiffness_times(w, out, scratch);
    }
}

/// Where each part's slices begin and end.
#[derive(Clone, Debug)]
pub struct Slices {
    pub contributions: Range<usize>,
    pub history: Range<usize>,
    pub overstress: Range<usize>,
    pub numbers: Range<usize>,
    pub points: Range<usize>,
    pub elements: Range<usize>,
}
