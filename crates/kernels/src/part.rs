//! Parts: everything that pushes on nodes. M a = −Σ over parts.

use crate::line::Lines;
use crate::stage::Stage;
use tremolite_laws::shapes::hex8::Held;
use tremolite_laws::{Column, Octet, Row};

/// What laws and loads may know of the time, which is not the scheme's: before the earthquake time stands still for
/// them while the scheme goes on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tick {
    /// Time of the displacements \[s\].
    pub time: f64,
    /// The part's own step \[s\]; 0 while time stands still: no rates, no Maxwell bodies.
    pub dt: f64,
    /// How many of its own steps lie before the displacements.
    pub step: u64,
}

/// Motion of all nodes at a time.
#[derive(Clone, Copy)]
pub struct Motion<'a> {
    /// Displacement u^n \[m\].
    pub u: &'a [Row],
    /// Increment u^n − u^(n−1) over a step of the finest level \[m\].
    pub du: &'a [Row],
    /// Steps of the finest level in one of the part's own, a power of two.
    pub span: f64,
}

impl<'a> Motion<'a> {
    /// Motion as a part of the finest level sees it, whose own step is that of the increments.
    pub fn new(u: &'a [Row], du: &'a [Row]) -> Self {
        Motion { u, du, span: 1.0 }
    }

    /// Increment \[m\] of a node that the part pushes over the part's own step.
    #[inline(always)]
    pub fn increment(&self, node: u32) -> Row {
        Row(self.du[node as usize].0.map(|d| d * self.span))
    }
}

/// What a part reads beyond its own nodes and its own memory. Whoever evaluates it elsewhere must bring this; in a test all else is
/// not a number.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Reads {
    /// Engine nodes whose motion it reads and which it does not push.
    pub nodes: Vec<u32>,
    /// Elements of the mesh whose stress or memory it is given where a stage begins.
    pub elements: Vec<u32>,
}

/// Where a stage begins, as a part is told of it.
pub struct Entry<'a> {
    pub stage: Stage,
    /// Displacement \[m\] of all nodes.
    pub u: &'a [Row],
    /// Mean stress \[Pa\] of an element of the mesh that the part [reads](Part::reads), or of what has taken over from it; none where
    /// none is known.
    pub stress: &'a dyn Fn(u32) -> Option<[f64; 6]>,
}

/// What a part alone reads and writes of the state.
pub struct Own<'a> {
    /// History of the law, octet by octet.
    pub history: &'a mut [Octet],
    /// Memory of the damping bodies, octet by octet.
    pub overstress: &'a mut [Octet],
    /// Other numbers that the part remembers.
    pub numbers: &'a mut [f64],
    /// Displacement \[m\] of each of its nodes from which it counts, of a part of elements that begins later than the model; else
    /// empty.
    pub reference: &'a mut [Row],
    /// Strain that its elements begin with, six octets an octet of elements, where there is initial stress; else empty.
    pub initial: &'a [Octet],
}

/// What of it others may ask a part about, to be read alone.
#[derive(Clone, Copy)]
pub struct Kept<'a> {
    pub history: &'a [Octet],
    pub numbers: &'a [f64],
    pub reference: &'a [Row],
    pub initial: &'a [Octet],
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

/// Energies of an element \[J\], each of the line of its name.
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
    /// Taken by damping over a band since the start.
    pub band: f64,
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
    /// Rows of a part's nodes, and others.
    pub rows: Vec<Row>,
    pub others: Vec<Row>,
    /// Forces of a second product.
    pub out: Vec<Row>,
    /// A copy of a history, or what stands for one.
    pub history: Vec<Octet>,
    /// What is left at the points of an octet.
    pub left: Vec<Octet>,
    /// What pores remember.
    pub held: Vec<Held>,
}

/// Something that pushes on nodes. No part reads another's memory.
pub trait Part: Send + Sync {
    /// Nodes pushed, in the order of the part's contributions.
    fn nodes(&self) -> &[u32];
    /// What it reads beyond these nodes and its own memory.
    fn reads(&self) -> Reads {
        Reads::default()
    }
    /// Length of the part's slices of the state.
    fn state_sizes(&self) -> StateSizes {
        StateSizes::default()
    }
    /// Number of elements and of integration points in each; zero for parts without elements.
    fn elements(&self) -> (usize, usize) {
        (0, 0)
    }
    /// Columns of the history of each point. The octets lie element octet by element octet, in each point by point, in
    /// each column by column; a part without elements may lay out its history as it likes and names no columns.
    fn columns(&self) -> &'static [Column] {
        &[]
    }
    /// Bytes of what the part was made from, the nodes that it pushes included: shapes, weights, places.
    fn bytes(&self) -> usize {
        size_of_val(self.nodes())
    }
    /// Whether all that the part takes and gives out is in the lines that it reports; without, the balance cannot close.
    fn keeps_books(&self) -> bool {
        true
    }
    /// Called once when the part's life begins later than the model's: what moved before is none of its.
    fn begin(&self, _x: &Motion, _own: Own) {}
    /// Called where a stage begins in which the part is there, the shaking included, before anything is evaluated: what it holds
    /// on to may change with stages.
    fn enter(&self, _entry: &Entry, _own: Own) {}
    /// Called once when the shaking begins, after its first evaluation: books of the part's own count from here.
    fn settle(&self, _own: Own) {}
    /// Forces that resist the displacements (sign of ∫Bᵀσ), one row a node, and the work that they did on the nodes since
    /// the last step, by those lines that are booked so ([`crate::Booked::Work`]); positive where energy flows from the
    /// nodes into the part.
    fn forces(&self, tick: &Tick, x: &Motion, own: Own, out: &mut [Row], scratch: &mut Scratch) -> Lines;
    /// As [`Part::forces`], and stresses and energies as well. Parts without elements need not provide it.
    fn probe(
        &self,
        tick: &Tick,
        x: &Motion,
        own: Own,
        out: &mut [Row],
        _: ProbeOut,
        scratch: &mut Scratch,
    ) -> Lines {
        self.forces(tick, x, own, out, scratch)
    }
    /// What the part holds \[J\], has dissipated and created since the start, by line, beside what it leaves by element
    /// in [`Part::probe`]. Of a line that is booked as work it counts at the start of a run alone: what is held then was
    /// supplied.
    fn energy(&self, _x: &Motion, _kept: Kept) -> Lines {
        Lines::default()
    }
    /// By how much \[Pa\] the pressure in the pores of each element has changed since the shaking began, added to `change`; nothing where
    /// it stays as it is.
    fn pressures(&self, _kept: Kept, _change: &mut [f64]) {}
    /// K w with the elastic stiffness, as the search for the stable step wants it.
    fn stiffness_times(&self, w: &[Row], out: &mut [Row], scratch: &mut Scratch);
    /// Forces of given stresses \[Pa\] at the points alone, ∫Bᵀσ: those of [`Part::forces`] at these stresses but for the
    /// stabilisation. Nothing of parts without elements.
    fn stress_forces(&self, _stress: &[[f64; 6]], out: &mut [Row], _scratch: &mut Scratch) {
        out.fill(Row::ZERO);
    }
    /// ½wᵀKw \[J\] of each element with the elastic stiffness, by which the step's limit is traced to one; asked of the
    /// model's own patches, while other parts are traced to their nodes.
    fn stiffness_energy(&self, _w: &[Row], _energy: &mut [ElementEnergy], _scratch: &mut Scratch) {}
    /// K w as Rayleigh's damping ξK wants it: with what damage has left of the stiffness at displacements `u` and with what is
    /// `kept`. Nothing by default: ξK acts on elements alone.
    fn damping_times(&self, _u: &[Row], _kept: Kept, _w: &[Row], out: &mut [Row], _scratch: &mut Scratch) {
        out.fill(Row::ZERO);
    }
    /// C w of forces that go by v⁻, as artificial viscosity does, without damage: the stable step goes by it, in models
    /// of which a body has such viscosity or a program's own part does. Says whether there are any; `out` is left alone where there are none.
    fn viscosity_times(&self, _w: &[Row], _out: &mut [Row], _scratch: &mut Scratch) -> bool {
        false
    }
}
