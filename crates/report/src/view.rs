//! The model in three dimensions: what the page's script draws, in blocks of compressed numbers.

use crate::blocks::Blocks;
use crate::source::Source;

/// The page's manifest of the view, its numbers in `blocks`; empty where there is nothing to draw or the case wants none.
pub fn embedded(_source: &Source, _blocks: &mut Blocks) -> String {
    String::new()
}
