//! A part with what the model knows of it.

use crate::life::Life;
use crate::parts::absent::Absent;
use crate::parts::{Part, Reads};
use std::collections::HashSet;
use std::sync::Arc;
use tremolite_kernels::Line;

/// What a member is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// Elements: a patch, by its number in [`Model::patches`](crate::Model::patches).
    Patch(u32),
    /// What a base, or another boundary, pushes with.
    Boundary,
    /// A load that varies in time.
    Load,
    /// Weight, or a traction on faces: constant, before the shaking alone.
    Weight,
    /// Pairs of an interface, by its number in [`Model::seams`](crate::Model::seams).
    Pairs(u32),
    /// Bolts, by their number in [`Model::bolts`](crate::Model::bolts).
    Bolts(u32),
    /// Of the program's own.
    Own,
}

impl Kind {
    /// The patch that it is.
    pub fn patch(self) -> Option<usize> {
        match self {
            Kind::Patch(patch) => Some(patch as usize),
            _ => None,
        }
    }
}

/// One of a model's parts.
#[derive(Clone)]
pub struct Member {
    /// For messages, and by which a program finds its own.
    pub name: String,
    pub kind: Kind,
    pub part: Arc<dyn Part>,
    /// The body of its elements, a number in [`Model::bodies`](crate::Model::bodies).
    pub body: Option<u32>,
    /// The level of its step in the shaking, the finest of the nodes that it pushes.
    pub level: u8,
    /// What it reads beyond its own nodes and memory: what its part names, elements that its own take over from, and those beside
    /// pairs that a stage frees.
    pub reads: Reads,
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
    /// A part of a program's own, without mass, that is always there and enters the balance.
    pub fn new(name: impl Into<String>, part: Box<dyn Part>) -> Self {
        Member::of(Kind::Own, name, part)
    }

    /// A part without mass that is always there and enters the balance.
    pub(crate) fn of(kind: Kind, name: impl Into<String>, part: Box<dyn Part>) -> Self {
        let own: HashSet<u32> = part.nodes().iter().copied().collect();
        let mut reads = part.reads();
        reads.nodes.retain(|node| !own.contains(node));
        Member {
            name: name.into(),
            kind,
            body: None,
            level: 0,
            reads,
            part: Arc::from(part),
            masses: Vec::new(),
            springs: Vec::new(),
            life: Life::ALWAYS,
            initial: false,
            line: None,
            counted: true,
        }
    }

    /// The same as a rank knows it that does not evaluate it.
    #[must_use]
    pub(crate) fn absent(&self) -> Self {
        Member { part: Arc::new(Absent::of(&*self.part)), ..self.clone() }
    }
}
