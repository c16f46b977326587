//! What stands for a part that another rank evaluates: where it pushes and how its memory is laid out, without geometry and without a law.

use super::{Motion, Own, Part, Scratch, StateSizes, Tick, UNKNOWN};
use tremolite_kernels::Lines;
use tremolite_laws::{Column, Row};

/// A part of another rank. What it would push with is not a number here.
pub struct Absent {
    nodes: Vec<u32>,
    sizes: StateSizes,
    elements: (usize, usize),
    columns: &'static [Column],
    keeps_books: bool,
}

impl Absent {
    /// What stands for a part.
    pub fn of(part: &dyn Part) -> Self {
        Absent {
            nodes: part.nodes().to_vec(),
            sizes: part.state_sizes(),
            elements: part.elements(),
            columns: part.columns(),
            keeps_books: part.keeps_books(),
        }
    }
}

impl Part for Absent {
    fn nodes(&self) -> &[u32] {
        &self.nodes
    }

    fn state_sizes(&self) -> StateSizes {
        self.sizes
    }

    fn elements(&self) -> (usize, usize) {
        self.elements
    }

    fn columns(&self) -> &'static [Column] {
        self.columns
    }

    fn keeps_books(&self) -> bool {
        self.keeps_books
    }

    fn forces(&self, _: &Tick, _: &Motion, _: Own, out: &mut [Row], _: &mut Scratch) -> Lines {
        out.fill(UNKNOWN);
        Lines::default()
    }

    fn stiffness_times(&self, _: &[Row], out: &mut [Row], _: &mut Scratch) {
        out.fill(UNKNOWN);
    }
}
