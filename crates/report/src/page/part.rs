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
    folded: bool,
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
    /// The rest of it, which one asks for.
    more: String,
}

fn paragraph(block: &Block) -> Paragraph {
    Paragraph {
        heading: block.heading.clone(),
        lead: block.lead.clone(),
        text: block.text.clone(),
        tables: block.tables.clone(),
        figures: block.figures.iter().map(drawing).collect(),
        folded: block.folded,
        notes: block.notes.clone(),
    }
}

/// Sections of detail, folded away on a screen and left out on paper until one opens them: what repeats others in other words, what
/// only specialists read, and what was left to defaults.
const FOLDED: [&str; 16] = [
    "displacement-less-mean",
    "stress-elastic",
    "damage-map-2",
    "interface-history",
    "interface-monitors",
    "depth",
    "spectra",
    "velocity",
    "acceleration",
    "further",
    "peaks",
    "free-field",
    "energy",
    "materials",
    "defaulted",
    "case",
];

/// A section as it is set.
pub fn part(placed: &Placed) -> PagePart {
    let numbered = |id: &str| {
        let more = placed.id.strip_prefix(id).and_then(|rest| rest.strip_prefix('-'));
        more.is_some_and(|number| number.bytes().all(|b| b.is_ascii_digit()))
    };
    let folded = FOLDED.iter().any(|id| placed.id == *id || numbered(id));
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
    let (caption, more) = split(&figure.caption);
    PageDrawing {
        curves: figure.curves.as_ref().map(|_| figure.file.clone()).unwrap_or_default(),
        svg: markup(&figure.svg),
        height,
        caption: caption.into(),
        more: more.into(),
    }
}

/// What a caption says at once: whole sentences, as many as have so many letters, of which a Chinese one counts as two. Digits do not
/// count: captions that differ by numbers alone are split alike.
const AT_ONCE: usize = 46;

/// A caption's first sentences and the rest. A sentence ends with a full stop before a space, or with a Chinese one.
fn split(caption: &str) -> (&str, &str) {
    let mut width = 0;
    let mut before = ' ';
    for (at, c) in caption.char_indices() {
        let ends = before == '。' || before == '.' && c == ' ';
        if ends && width >= AT_ONCE {
            return (&caption[..at], caption[at..].trim_start());
        }
        width += match (c.is_alphabetic(), c.is_ascii()) {
            (false, _) => 0,
            (true, true) => 1,
            (true, false) => 2,
        };
        before = c;
    }
    (caption, "")
}

#[cfg(test)]
mod tests {
    use super::split;

    #[test]
    fn a_caption_is_split_between_sentences_and_nothing_is_lost() {
        let long = "Of each pair, the displacement of the first monitor less that of the second by 1.5 mm. Look there. And there.";
        let (first, rest) = split(long);
        assert!(first.ends_with("1.5 mm.") && rest == "Look there. And there.");
        assert_eq!(split("Short. And more."), ("Short. And more.", ""));
        let chinese =
            "每对监测点中第一点减去第二点的位移，即两点之间衬砌须随之变形的量，单位为毫米。其余不计。";
        let (first, rest) = split(chinese);
        assert!(first.ends_with('。') && rest == "其余不计。");
    }
}
