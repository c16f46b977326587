//! A figure for the page and the folder, or the reason why there is none.

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
}

/// A section of the page: drawn, or left out with a reason.
pub enum Section {
    Drawn(Vec<Figure>),
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
}
