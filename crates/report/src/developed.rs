//! Surfaces developed flat: unfolded, laid out on a figure, and told of.

pub mod layout;
pub mod unfold;
pub mod words;
