//! Tables of the page whose columns depend on the results.

use serde::Serialize;

/// A table as it is set.
#[derive(Clone, Debug, Default, Serialize)]
pub struct TextTable {
    /// Rows of headings.
    pub head: Vec<Vec<Head>>,
    pub rows: Vec<Vec<Cell>>,
}

/// A heading over `span` columns.
#[derive(Clone, Debug, Serialize)]
pub struct Head {
    pub text: String,
    pub span: usize,
    /// Over numbers: to the right.
    pub number: bool,
}

/// An entry with its small print.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Cell {
    pub text: String,
    pub note: String,
    pub number: bool,
}

impl Head {
    pub fn words(text: impl Into<String>) -> Self {
        Head { text: text.into(), span: 1, number: false }
    }

    pub fn number(text: impl Into<String>) -> Self {
        Head { text: text.into(), span: 1, number: true }
    }

    pub fn over(self, span: usize) -> Self {
        Head { span, ..self }
    }
}

impl Cell {
    pub fn words(text: impl Into<String>) -> Self {
        Cell { text: text.into(), ..Cell::default() }
    }

    pub fn number(text: impl Into<String>) -> Self {
        Cell { text: text.into(), number: true, ..Cell::default() }
    }

    pub fn with(self, note: impl Into<String>) -> Self {
        Cell { note: note.into(), ..self }
    }
}
