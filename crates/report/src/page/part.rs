//! Sections of the page as the template sets them.

use minijinja::Value;
use serde::Serialize;

use crate::chapter::figure::{Block, Figure, Section};
use crate::chapter::text_table::TextTable;
use crate::drawing::svg;
use crate::page::contents::{Content, Placed};
use crate::page::templates::markup;

/// A block as it is set.
#[derive(Serialize)]
struct Paragraph {
    heading: String,
    lead: String,
    text: String,
    tables: Vec<TextTable>,
    figures: Vec<PageDrawing>,
    notes: Vec<String>,
}

/// One section: what the template sets by its id; or figures, or blocks with tables and figures, or the reason for having
/// none.
#[derive(Default, Serialize)]
pub struct PagePart {
    id: String,
    heading: String,
    template: bool,
    /// Whether it is folded away until one asks for it.
    folded: bool,
    why: String,
    figures: Vec<PageDrawing>,
    blocks: Vec<Paragraph>,
}

#[derive(Serialize)]
struct PageDrawing {
    /// The name by which the manifest of the curves knows it; empty for a figure without.
    curves: String,
    svg: Value,
    /// How much of a page of paper it wants: `tall` all of it, `high` more than half; else nothing.
    height: &'static str,
    caption: String,
}

fn paragraph(block: &Block) -> Paragraph {
    Paragraph {
        heading: block.heading.clone(),
        lead: block.lead.clone(),
        text: block.text.clone(),
        tables: block.tables.clone(),
        figures: block.figures.iter().map(drawing).collect(),
        notes: block.notes.clone(),
    }
}

/// Sections of detail, folded away on a screen: what repeats others in other words, and what was left to defaults.
const FOLDED: [&str; 9] = [
    "displacement-less-mean",
    "stress-elastic",
    "velocity",
    "acceleration",
    "further",
    "peaks",
    "free-field",
    "materials",
    "defaulted",
];

/// A section as it is set.
pub fn part(placed: &Placed) -> PagePart {
    let folded = FOLDED.iter().any(|id| placed.id == *id || placed.id.starts_with(&format!("{id}-")));
    let part =
        PagePart { id: placed.id.clone(), heading: placed.heading.clone(), folded, ..PagePart::default() };
    match &placed.content {
        Content::Template => PagePart { template: true, ..part },
        Content::Section(Section::LeftOut { why, .. }) => PagePart { why: why.clone(), ..part },
        Content::Section(Section::Drawn(figures)) => {
            PagePart { figures: figures.iter().map(drawing).collect(), ..part }
        }
        Content::Section(Section::Told(chapter)) => {
            PagePart { blocks: chapter.blocks.iter().map(paragraph).collect(), ..part }
        }
    }
}

/// Height over width from which on a figure has a page of its own, or more than half of one: shrunk to half a page its texts
/// could not be read.
const TALL: f64 = 1.0;
const HIGH: f64 = 0.75;

fn drawing(figure: &Figure) -> PageDrawing {
    let height = match svg::proportion(&figure.svg) {
        Some(proportion) if proportion > TALL => "tall",
        Some(proportion) if proportion > HIGH => "high",
        _ => "",
    };
    PageDrawing {
        curves: figure.curves.as_ref().map(|_| figure.file.clone()).unwrap_or_default(),
        svg: markup(&figure.svg),
        height,
        caption: figure.caption.clone(),
    }
}
