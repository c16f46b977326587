//! A part with what the model knows of it.

use crate::life::Life;
use crate::parts::Part;
use tremolite_kernels::Line;

/// One of a model's parts.
pub struct Member {
    /// For messages, and by which a program finds its own.
    pub name: String,
    pub part: Box<dyn Part>,
    /// Mass \[kg\] that it gives each of its nodes, in the order of its nodes; empty for a part without mass.
    pub masses: Vec<f64>,
    /// Engine nodes with the stiffness \[N/m\] of springs at them, of a part without elements: relaxation takes its masses from
    /// these. A node may be there several times.
    pub springs: Vec<(u32, f64)>,
    /// Stages in which it is there.
    pub life: Life,
    /// Whether its elements begin with strain.
    pub initial: bool,
    /// The line from which the work of what it carried at the hand-over is taken, where it is not of elements.
    pub line: Option<Line>,
    /// Whether its energy is part of the balance (not the reference column's).
    pub counted: bool,
}

impl Member {
    /// A part without mass that is always there and enters the balance.
    pub fn new(name: impl Into<String>, part: Box<dyn Part>) -> Self {
        Member {
            name: name.into(),
            part,
            masses: Vec::new(),
            springs: Vec::new(),
            life: Life::ALWAYS,
            initial: false,
            line: None,
            counted: true,
        }
    }
}
