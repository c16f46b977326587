//! A figure for the page and the folder, or the reason why there is none; chapters made of tables and figures.

use crate::chapter::text_table::TextTable;
use crate::script::curves::Curves;

/// A section of the page that is drawn.
pub struct Figure {
    /// Heading on the page.
    pub heading: String,
    /// File name in `figures/`.
    pub file: String,
    /// The drawing.
    pub svg: String,
    /// A sentence or two below it; may be empty.
    pub caption: String,
    /// The numbers behind its curves, where the page's script is to know them.
    pub curves: Option<Curves>,
    /// The same drawing for half a page's width, as the sheets show it; where there is none they show the wide one.
    pub narrow: Option<String>,
}

/// A section of the page: drawn, told with tables and figures, or left out with a reason.
pub enum Section {
    Drawn(Vec<Figure>),
    Told(Chapter),
    /// Heading, and a sentence that says why it is left out.
    LeftOut {
        heading: String,
        why: String,
    },
}

impl Section {
    pub fn left_out(heading: &str, why: impl Into<String>) -> Section {
        Section::LeftOut { heading: heading.into(), why: why.into() }
    }

    /// Its heading; that of its first figure.
    pub fn heading(&self) -> &str {
        match self {
            Section::Drawn(figures) => figures.first().map_or("", |figure| &figure.heading),
            Section::Told(chapter) => &chapter.heading,
            Section::LeftOut { heading, .. } => heading,
        }
    }

    /// All its figures.
    pub fn figures(&self) -> Vec<&Figure> {
        match self {
            Section::Drawn(figures) => figures.iter().collect(),
            Section::Told(chapter) => chapter.figures().collect(),
            Section::LeftOut { .. } => Vec::new(),
        }
    }
}

/// A chapter of the page.
pub struct Chapter {
    /// By which the page can be pointed into.
    pub id: &'static str,
    pub heading: String,
    pub blocks: Vec<Block>,
}

impl Chapter {
    /// All its figures.
    pub fn figures(&self) -> impl Iterator<Item = &Figure> {
        self.blocks.iter().flat_map(|block| &block.figures)
    }
}

/// A part of a chapter. What is empty is not set.
#[derive(Default)]
pub struct Block {
    pub heading: String,
    /// What is found, before all else.
    pub lead: String,
    /// What it is and what to look for.
    pub text: String,
    pub tables: Vec<TextTable>,
    pub figures: Vec<Figure>,
    /// Whether it is detail, folded away until one asks for it.
    pub folded: bool,
    /// A sentence for what the files do not hold.
    pub notes: Vec<String>,
}
