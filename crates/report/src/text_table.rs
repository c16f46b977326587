//! Tables of the page whose columns depend on the results, and chapters made of them and of figures.

use serde::Serialize;

use crate::figure::Figure;

/// A chapter of the page.
pub struct Chapter {
    pub id: &'static str,
    pub heading: String,
    pub blocks: Vec<Block>,
}

/// A part of a chapter. What is empty is not set.
#[derive(Default)]
pub struct Block {
    pub heading: String,
    /// What it is and what to look for.
    pub text: String,
    pub tables: Vec<TextTable>,
    pub figures: Vec<Figure>,
    /// A sentence for what the files do not hold.
    pub notes: Vec<String>,
}

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
