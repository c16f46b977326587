//! What a model knows of each of its elements, beside their nodes.

use crate::life::{Life, Stage};
use std::collections::HashMap;

/// Lists by element of the mesh; those of slabs and columns lie behind the user's.
#[derive(Clone, Debug, Default)]
pub struct Elements {
    /// The body of each element of the user's, none for void ones.
    pub body_of: Vec<Option<usize>>,
    /// When each is there.
    pub lives: Vec<Life>,
    /// Elements that stand in the place of others before these do: (stand-in, the other).
    pub stand_ins: Vec<(u32, u32)>,
    /// Elements that take over from others: later → earlier.
    pub successors: HashMap<u32, u32>,
    /// Of each element, the one of the user's that it was made of, or beside which its column stands: itself if it is one.
    pub parents: Vec<u32>,
    /// Stress \[Pa\] of each element before anything moves; empty for none.
    pub initial: Vec<[f64; 6]>,
    /// Artificial viscosity of each element, a share of critical damping: that of its body, or of an interface that it has a
    /// node on if that is more.
    pub viscosity: Vec<f64>,
    /// Of each element, the natural axis through its thickness where its body is layered, else 2.
    pub thickness: Vec<u8>,
}

impl Elements {
    /// The user's elements that are there in the shaking, ascending.
    pub(super) fn shaken(&self) -> Vec<u32> {
        (0..self.body_of.len()).filter(|&e| self.stands(e, Stage::Shaking)).map(|e| e as u32).collect()
    }

    /// Whether an element of the user's is there in a stage.
    pub(super) fn stands(&self, element: usize, stage: Stage) -> bool {
        self.body_of.get(element).is_some_and(Option::is_some) && self.lives[element].holds(stage)
    }
}
