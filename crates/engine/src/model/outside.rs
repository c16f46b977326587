//! The ground outside the sides of a model.

use crate::column::Column;
use crate::sheet::Sheet;
use crate::slabs::{Slab, sheets};

/// Ground that leads what the user meshed, or that it is compared with.
#[derive(Clone, Debug, Default)]
pub struct Outside {
    /// Ground outside free-field sides.
    pub slabs: Vec<Slab>,
    /// At the ends of slabs, where all four sides are free field; else reference columns, where the base absorbs and there is
    /// ground along the model's vertical edges.
    pub columns: Vec<Column>,
    /// Why there are none, in words.
    pub no_column: String,
}

impl Outside {
    /// Every sheet, each slab's before those of its columns.
    pub fn sheets(&self) -> impl Iterator<Item = &Sheet> {
        sheets(&self.slabs, &self.columns)
    }
}
