//! A cavern's place in the grid, and what galleries ask of its walls.

use std::ops::Range;

use super::Cavern;
use super::profile::Outline;
use super::rows::Counts;
use super::wall::{Rows, Stops};

/// A level on a cavern's wall that a gallery asks for.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pin {
    /// Number of the wall's node, 0 at the foot.
    pub node: usize,
    /// Above the clear floor.
    pub level: f64,
    pub sides: [bool; 2],
}

/// A cavern's place in the grid.
pub(super) struct Plot {
    /// The middle of the clear floor: x, z.
    pub centre: [f64; 2],
    pub outline: Outline,
    pub counts: Counts,
    /// Grid lines of the rectangle, first and last.
    pub columns: Range<usize>,
    pub rows: Range<usize>,
    /// Rows of the straight walls; none of a closed outline.
    pub wall: Rows,
    /// Levels over the foot at which galleries meet its walls, rising.
    pub galleries: Vec<f64>,
    /// Where the walls have nodes whatever their number; nothing without galleries.
    pub stops: Option<Stops>,
    /// The walls' nodes at the galleries' levels.
    pub pins: Vec<Pin>,
    /// Where the rings of rock lie between the outside of lining and shotcrete (0) and rectangle (1), both included.
    pub rings: Vec<f64>,
}

impl Plot {
    /// Prepares a cavern for the galleries that meet its walls.
    pub fn meet_galleries(&mut self, cavern: &Cavern, near: f64) {
        let Outline::Walls(profile) = &mut self.outline else { return };
        let Some(&lowest) = self.galleries.first() else { return };
        self.stops = Some(Stops::new(profile.inner.springing, cavern.benches, &self.galleries, near));
        // A row that ends at the foot would leave the rock below it a corner of 180 degrees: it gets a row of its own,
        // as a floor slab is.
        if lowest == 0.0 && self.counts.slab == 0 {
            profile.floor = 0.7 * near;
            self.counts.slab = 1;
        }
    }

    /// The grid's row, from the rectangle's base, at a straight wall's foot.
    pub fn first_row(&self) -> usize {
        self.counts.inset + self.counts.slab
    }

    /// The level at which node `t` of the outline, and the ring nodes on its line, are held for a gallery.
    pub fn held(&self, t: usize) -> Option<f64> {
        let (foot, vault) = (self.first_row(), self.counts.vault());
        let held =
            |pin: &&Pin| pin.sides[0] && t == foot + pin.node || pin.sides[1] && t == foot + vault - pin.node;
        self.pins.iter().find(held).map(|pin| self.centre[1] + pin.level)
    }
}
