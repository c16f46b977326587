//! What is seen of a state at one time.

use crate::parts::ElementEnergy;
use tremolite_kernels::Lines;
use tremolite_laws::Row;

/// What is seen at one time, beside the histories and numbers that parts keep.
#[derive(Clone, Debug, Default)]
pub struct Snapshot {
    /// Steps since t = 0, and the time \[s\].
    pub step: u64,
    pub time: f64,
    /// Displacement \[m\] by engine node.
    pub displacement: Vec<Row>,
    /// v̂ \[m/s\] by engine node.
    pub velocity: Vec<Row>,
    /// dv/dt \[m/s²\] by engine node.
    pub acceleration: Vec<Row>,
    /// Total stress \[Pa\] of every point, global axes, in the order of members.
    pub stress: Vec<[f64; 6]>,
    /// Pressure \[Pa\] in the pores of every element, in the order of members, 0 of what has none; empty in a model without water.
    pub pore: Vec<f64>,
    /// Energies of every element, in the order of members.
    pub energy: Vec<ElementEnergy>,
    /// The energy balance at this time.
    pub balance: Lines,
    /// Energy held by elements, springs and motion (that of v⁻), and all that was ever supplied \[J\]: what the guard compares.
    pub held: f64,
    pub supplied: f64,
    /// ⅛Δt²aᵀMa \[J\]: the part of the balance's error that belongs to the scheme and shrinks with Δt².
    pub scheme: f64,
    /// The balance of each account ([`Assembly::accounts`](crate::Assembly::accounts)).
    pub bodies: Vec<BodyBooks>,
}

/// The books of a body's elements \[J\].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BodyBooks {
    /// Work done on them, but for what artificial viscosity took, and what they held and had lost at the start.
    pub work: f64,
    /// What they hold, have dissipated and created.
    pub held: Lines,
}

impl BodyBooks {
    /// Work that is in none of their lines \[J\].
    pub fn error(&self) -> f64 {
        self.work - self.held.sum()
    }
}
