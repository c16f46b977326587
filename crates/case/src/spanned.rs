//! A value and where it stands in the case file.

use std::ops::{Deref, Range};

/// A value with the byte range of the case's source text it was read from.
///
/// A value that was left out and took its default has the range of the table it would stand in.
#[derive(Clone, Debug, PartialEq)]
pub struct Spanned<T> {
    /// The value, in SI where it has a unit.
    pub value: T,
    /// Bytes of [`Case::source`](crate::Case::source).
    pub span: Range<usize>,
}

impl<T> Spanned<T> {
    pub fn new(value: T, span: Range<usize>) -> Self {
        Spanned { value, span }
    }
}

impl<T> Deref for Spanned<T> {
    type Target = T;

    fn deref(&self) -> &T {
        &self.value
    }
}
