//! The model in three dimensions: what the page's script draws, in blocks of compressed numbers.

use crate::source::Source;

/// The page's part with the blocks; empty where there is nothing to draw or the case wants none.
pub fn embedded(_source: &Source) -> String {
    String::new()
}
