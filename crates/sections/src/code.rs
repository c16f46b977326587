//! The codes that are known.

/// A code of concrete structures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Code {
    /// EN 1992-1-1:2004 (`en1992`).
    En,
    /// GB 50010-2010 (`gb2010`).
    Gb,
}
