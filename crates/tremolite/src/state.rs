//! Everything that evolves, and nothing else: a checkpoint is a State.

use std::collections::BTreeMap;
use tremolite_laws::{Octet, Row};

/// Lines of the energy balance \[J\], sums since the start.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ledger {
    /// Energy the run started with.
    pub initial: f64,
    /// Work into springs of the boundary.
    pub springs: f64,
    /// Work of incident waves and loads on the model.
    pub input: f64,
    /// Sum of the positive increments of `input` and of `initial`: what the guard measures against.
    pub supplied: f64,
    /// Taken by Rayleigh damping.
    pub rayleigh: f64,
    /// Taken by the dashpots of the base.
    pub base_dashpots: f64,
    /// Taken by the dashpots of the sides.
    pub side_dashpots: f64,
    /// Work against the forces of all parts, and the energy that elements held at the start.
    pub parts: f64,
}

/// All that evolves in a run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// Number n of the step whose displacements these are.
    pub step: u64,
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
    pub ledger: Ledger,
    /// What observers remember: envelopes, steps seen, bytes written, by observer and column.
    pub observers: BTreeMap<String, Vec<f64>>,
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
    /// Time of the displacements \[s\].
    pub fn time(&self) -> f64 {
        self.step as f64 * self.dt
    }

    /// Every column with its name and unit: the one list that checkpoints and exchanges go by.
    pub fn columns(&mut self) -> Vec<(String, &'static str, Column<'_>)> {
        let Ledger { initial, springs, input, supplied, rayleigh, base_dashpots, side_dashpots, parts } =
            &mut self.ledger;
        let ledger = vec![initial, springs, input, supplied, rayleigh, base_dashpots, side_dashpots, parts];
        let mut columns = vec![
            ("step".to_owned(), "1", Column::Count(&mut self.step)),
            ("dt".to_owned(), "s", Column::Scalars(vec![&mut self.dt])),
            ("displacement".to_owned(), "m", Column::Rows(&mut self.u)),
            ("increment".to_owned(), "m", Column::Rows(&mut self.du)),
            ("history".to_owned(), "law", Column::Octets(&mut self.history)),
            ("overstress".to_owned(), "1", Column::Octets(&mut self.overstress)),
            ("numbers".to_owned(), "part", Column::Numbers(&mut self.numbers)),
            ("ledger".to_owned(), "J", Column::Scalars(ledger)),
        ];
        for (name, values) in &mut self.observers {
            columns.push((format!("observer {name}"), "observer", Column::Numbers(values)));
        }
        columns
    }
}
