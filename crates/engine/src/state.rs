//! Everything that evolves, and nothing else: a checkpoint is a State.

use std::collections::BTreeMap;
use tremolite_kernels::Lines;
use tremolite_kernels::part::Kept;
use tremolite_laws::{Octet, Row};

/// The books of the energy balance \[J\]: sums since the start, kept by who books and added where somebody looks.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ledger {
    /// What the run started with, by line.
    pub lines: Lines,
    /// What was put in when the guard last [watched](crate::Engine::watches), and the sum of its positive increments from one such
    /// time to the next and of what was held at the start: what the guard measures against.
    pub put_in: f64,
    pub supplied: f64,
    /// What was stored at rest and came free, at most, where the guard looked for it.
    pub freed: f64,
    /// By account ([`crate::Assembly::accounts`]): what its elements held and had lost at the start.
    pub bodies: Vec<f64>,
    /// What each account held and had lost when the shaking began from rest under load.
    pub rest: Vec<Lines>,
    /// By member: the work that it booked.
    pub members: Vec<Lines>,
    /// By block of nodes ([`crate::Nodes::blocks`]): what its nodes booked, [`Ledger::width`] numbers each.
    pub blocks: Vec<f64>,
}

/// What a block of nodes books before the work on the elements of each account: work against Rayleigh's damping, the dashpots of
/// the base and of the sides, the work of the dashpots of free-field sides, and what is taken where levels of steps meet.
pub const OF_NODES: usize = 5;

impl Ledger {
    /// Empty books for so many accounts, members and blocks.
    pub fn new(accounts: usize, members: usize, blocks: usize) -> Self {
        Ledger {
            bodies: vec![0.0; accounts],
            rest: vec![Lines::default(); accounts],
            members: vec![Lines::default(); members],
            blocks: vec![0.0; (OF_NODES + accounts) * blocks],
            ..Ledger::default()
        }
    }

    /// Numbers that each block books.
    pub fn width(&self) -> usize {
        OF_NODES + self.bodies.len()
    }

    /// Empty books of the same size.
    #[must_use]
    pub fn cleared(&self) -> Self {
        let accounts = self.bodies.len();
        Ledger::new(accounts, self.members.len(), self.blocks.len() / self.width())
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
    /// Work \[J\] that the damping of the relaxation took so far.
    pub damped: f64,
    /// Largest Σ|contributions| of a cycle so far \[N\].
    pub most: f64,
    /// Whether pairs that begin under load were given what passed between their sides at rest, in the initial equilibrium: 1, and
    /// else 0.
    pub freed: u64,
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
    /// Displacements \[m\] from which elements count that begin later than the model, part by part.
    pub reference: Vec<Row>,
    /// Strain that elements begin with, part by part.
    pub initial: Vec<Octet>,
    /// Number of the stage before the shaking that is going on or comes next.
    pub stage: u64,
    /// Displacement \[m\] of each engine node from which results count; empty for none.
    pub datum: Vec<Row>,
    /// What is held at each engine node \[N\]: left of what was out of balance when a relaxation began; in the shaking what all
    /// parts do at its start. Empty where nothing was.
    pub held: Vec<Row>,
    /// Displacement \[m\] at which it began.
    pub start: Vec<Row>,
    pub relaxing: Relaxing,
    /// Largest motion \[m\] of any stage so far.
    pub moved: f64,
    /// What every part did to its nodes when the shaking began \[N\], and what of it was elements' stabilisation; empty where it
    /// began from rest without stress.
    pub carried: Vec<Row>,
    pub carried_hourglass: Vec<Row>,
    pub ledger: Ledger,
    pub observers: Memory,
}

/// A column of the state, for writing and reading.
pub enum StateColumn<'a> {
    Count(&'a mut u64),
    Numbers(&'a mut Vec<f64>),
    Rows(&'a mut Vec<Row>),
    /// Rows that may not be there yet.
    SomeRows(&'a mut Vec<Row>),
    Octets(&'a mut Vec<Octet>),
    Scalars(Vec<&'a mut f64>),
}

impl State {
    /// Displacement \[m\] of an engine node as results count it.
    pub fn shown(&self, node: usize) -> Row {
        let zero = self.datum.get(node).copied().unwrap_or(Row::ZERO);
        Row([0, 1, 2, 3].map(|i| self.u[node].0[i] - zero.0[i]))
    }

    /// What all parts remember.
    pub fn kept(&self) -> Kept<'_> {
        let State { history, numbers, reference, initial, .. } = self;
        Kept { history, numbers, reference, initial }
    }

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
    pub fn columns(&mut self) -> Vec<(String, &'static str, StateColumn<'_>)> {
        let State {
            step,
            origin,
            dt,
            u,
            du,
            history,
            overstress,
            numbers,
            reference,
            initial,
            stage,
            datum,
            held,
            start,
            relaxing: Relaxing { cycle, damping, work, damped, most, freed },
            moved,
            carried,
            carried_hourglass,
            ledger: Ledger { lines, put_in, supplied, freed: came_free, bodies, rest, members, blocks },
            observers,
        } = self;
        let ledger = lines.values_mut().chain([put_in, supplied, came_free]).collect();
        let members = members.iter_mut().flat_map(Lines::values_mut).collect();
        let rest = rest.iter_mut().flat_map(Lines::values_mut).collect();
        let mut columns = vec![
            ("step".to_owned(), "1", StateColumn::Count(step)),
            ("origin".to_owned(), "1", StateColumn::Count(origin)),
            ("dt".to_owned(), "s", StateColumn::Scalars(vec![dt])),
            ("displacement".to_owned(), "m", StateColumn::Rows(u)),
            ("increment".to_owned(), "m", StateColumn::Rows(du)),
            ("history".to_owned(), "law", StateColumn::Octets(history)),
            ("overstress".to_owned(), "1", StateColumn::Octets(overstress)),
            ("numbers".to_owned(), "part", StateColumn::Numbers(numbers)),
            ("reference".to_owned(), "m", StateColumn::Rows(reference)),
            ("initial".to_owned(), "1", StateColumn::Octets(initial)),
            ("stage".to_owned(), "1", StateColumn::Count(stage)),
            ("datum".to_owned(), "m", StateColumn::SomeRows(datum)),
            ("held".to_owned(), "N", StateColumn::SomeRows(held)),
            ("start".to_owned(), "m", StateColumn::SomeRows(start)),
            ("cycle".to_owned(), "1", StateColumn::Count(cycle)),
            ("freed".to_owned(), "1", StateColumn::Count(freed)),
            ("relaxation".to_owned(), "1, J, N", StateColumn::Scalars(vec![damping, work, damped, most])),
            ("moved".to_owned(), "m", StateColumn::Scalars(vec![moved])),
            ("carried".to_owned(), "N", StateColumn::SomeRows(carried)),
            ("carried_hourglass".to_owned(), "N", StateColumn::SomeRows(carried_hourglass)),
            ("ledger".to_owned(), "J", StateColumn::Scalars(ledger)),
            ("bodies".to_owned(), "J", StateColumn::Numbers(bodies)),
            ("bodies at rest".to_owned(), "J", StateColumn::Scalars(rest)),
            ("books of parts".to_owned(), "J", StateColumn::Scalars(members)),
            ("books of nodes".to_owned(), "J", StateColumn::Numbers(blocks)),
        ];
        for (name, values) in observers {
            columns.push((format!("observer {name}"), "observer", StateColumn::Numbers(values)));
        }
        columns
    }
}
