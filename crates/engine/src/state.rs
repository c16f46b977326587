//! Everything that evolves, and nothing else: a checkpoint is a State.

use std::collections::BTreeMap;
use tremolite_kernels::Lines;
use tremolite_laws::{Octet, Row};

/// The books of the energy balance \[J\], sums since the start.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ledger {
    /// Of the lines that are booked step by step, and of what the run started with.
    pub lines: Lines,
    /// Sum of the positive increments of what is put in and of what was held at the start: what the guard measures
    /// against.
    pub supplied: f64,
    /// By account ([`crate::Assembly::accounts`]): work on the elements less what artificial viscosity took of it, and what
    /// they held and had lost at the start.
    pub bodies: Vec<f64>,
}

impl Ledger {
    /// Empty books for so many accounts.
    pub fn new(accounts: usize) -> Self {
        Ledger { bodies: vec![0.0; accounts], ..Ledger::default() }
    }
}

/// What observers remember: envelopes, steps seen, bytes written, by observer and column.
pub type Memory = BTreeMap<String, Vec<f64>>;

/// What a relaxation remembers from one cycle to the next.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Relaxing {
    /// Number of the next cycle; 0 before the first.
    pub cycle: u64,
    /// c of [`crate::Engine::relax`].
    pub damping: f64,
    /// Δuⁿ⁺¹·fⁿ \[J\].
    pub work: f64,
}

/// All that evolves in a run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// Number n of the step whose displacements these are, counted from the first of all.
    pub step: u64,
    /// Number of the step at which t = 0: those before it belong to stages before the earthquake.
    pub origin: u64,
    /// Step \[s\] of `du`.
    pub dt: f64,
    /// u^n \[m\], engine nodes.
    pub u: Vec<Row>,
    /// u^n − u^(n−1) \[m\].
    pub du: Vec<Row>,
    /// Histories of the laws, part by part.
    pub history: Vec<Octet>,
    /// Memory of damping over a band, part by part.
    pub overstress: Vec<Octet>,
    /// What other parts remember.
    pub numbers: Vec<f64>,
    /// What is held at each engine node \[N\]: left of what was out of balance when a relaxation began; empty before the first.
    pub held: Vec<Row>,
    /// Displacement \[m\] at which it began.
    pub start: Vec<Row>,
    pub relaxing: Relaxing,
    pub ledger: Ledger,
    pub observers: Memory,
}

/// A column of the state, for writing and reading.
pub enum Column<'a> {
    Count(&'a mut u64),
    Numbers(&'a mut Vec<f64>),
    Rows(&'a mut Vec<Row>),
    Octets(&'a mut Vec<Octet>),
    Scalars(Vec<&'a mut f64>),
}

impl State {
    /// Steps since t = 0.
    pub fn steps(&self) -> u64 {
        self.step - self.origin
    }

    /// Time of the displacements by the scheme \[s\]; what laws are told of the time is
    /// [`crate::Phase::tick`]'s.
    pub fn time(&self) -> f64 {
        self.steps() as f64 * self.dt
    }

    /// Begins to count the time here, with steps of `dt` \[s\] and everything at rest where it is.
    pub fn begin(&mut self, dt: f64) {
        (self.origin, self.dt) = (self.step, dt);
        self.du.fill(Row::ZERO);
    }

    /// Every column with its name and unit: the one list that checkpoints and exchanges go by.
    pub fn columns(&mut self) -> Vec<(String, &'static str, Column<'_>)> {
        let Ledger { lines, supplied, bodies } = &mut self.ledger;
        let Relaxing { cycle, damping, work } = &mut self.relaxing;
        let ledger = lines.values_mut().chain([supplied]).collect();
        let mut columns = vec![
            ("step".to_owned(), "1", Column::Count(&mut self.step)),
            ("origin".to_owned(), "1", Column::Count(&mut self.origin)),
            ("dt".to_owned(), "s", Column::Scalars(vec![&mut self.dt])),
            ("displacement".to_owned(), "m", Column::Rows(&mut self.u)),
            ("increment".to_owned(), "m", Column::Rows(&mut self.du)),
            ("history".to_owned(), "law", Column::Octets(&mut self.history)),
            ("overstress".to_owned(), "1", Column::Octets(&mut self.overstress)),
            ("numbers".to_owned(), "part", Column::Numbers(&mut self.numbers)),
            ("held".to_owned(), "N", Column::Rows(&mut self.held)),
            ("start".to_owned(), "m", Column::Rows(&mut self.start)),
            ("cycle".to_owned(), "1", Column::Count(cycle)),
            ("relaxation".to_owned(), "1, J", Column::Scalars(vec![damping, work])),
            ("ledger".to_owned(), "J", Column::Scalars(ledger)),
            ("bodies".to_owned(), "J", Column::Numbers(bodies)),
        ];
        for (name, values) in &mut self.observers {
            columns.push((format!("observer {name}"), "observer", Column::Numbers(values)));
        }
        columns
    }
}
