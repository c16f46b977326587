//! `[[reinforcement]]`: bars in the concrete of a lining.

use std::ops::Range;

use tremolite_laws::parameter::Dimension;

use crate::Spanned;
use crate::fields::Fields;
use crate::keys::{Key, Kind, Limit, Table, words};

const LENGTH: Kind = Kind::Number(Dimension::LENGTH, Limit::Positive);
const STRESS: Kind = Kind::Number(Dimension::PRESSURE, Limit::Positive);

pub(crate) static REINFORCEMENT: Table = Table {
    path: "reinforcement",
    doc: "Bars in a lining, all of one direction, that move with the concrete they lie in. They are there from the stage that \
          installs it.",
    keys: &[
        Key::optional("name", Kind::Text, "", "What they are called"),
        Key::required(
            "on",
            Kind::List(&Kind::Text, 1, 1000),
            "groups of the mesh that have a thickness, such as \"*.lining\"; * stands for any text",
        ),
        Key::required(
            "area",
            LENGTH,
            "steel of each face that is reinforced, per metre across the bars: \"1570 mm2/m\" (1.57 mm)",
        ),
        Key::required("cover", LENGTH, "from the concrete's face to the axis of the bars"),
        Key::required(
            "direction",
            Kind::Word(BarDirection::WORDS),
            "across: round the section, in the plane normal to y; along: in the direction of y",
        ),
        Key::default(
            "face",
            Kind::Word(BarFace::WORDS),
            "\"both\"",
            "The faces of the lining that are reinforced",
        ),
        Key::default("young", STRESS, "\"200 GPa\"", "Young's modulus of the bars"),
        Key::optional(
            "yield",
            STRESS,
            "bars do not yield",
            "Stress at which they yield, in tension and in compression",
        ),
        Key::optional(
            "breaking_strain",
            Kind::Number(Dimension::NONE, Limit::Positive),
            "",
            "Strain in tension beyond which they are broken; without it they never are",
        ),
    ],
    choice: &[],
};

words! {
    /// Which way bars run in a lining.
    BarDirection {
        /// Round the section, in the plane normal to the caverns' axis y.
        Across = "across",
        /// Along the caverns' axis.
        Along = "along",
    }
}

words! {
    /// Faces of a lining.
    BarFace {
        /// The inner one, towards the opening.
        Intrados = "intrados",
        /// The outer one, towards the rock.
        Extrados = "extrados",
        /// Both, each with the whole area.
        Both = "both",
    }
}

/// Bars in a lining.
#[derive(Clone, Debug, PartialEq)]
pub struct Reinforcement {
    /// Nothing: named after what they are in.
    pub name: Option<Spanned<String>>,
    /// Groups: names in which `*` stands for any text (see [`pattern::matches`](crate::pattern::matches)).
    pub on: Vec<Spanned<String>>,
    /// Of each face per metre across the bars, m²/m.
    pub area: Spanned<f64>,
    /// From the face to the bars' axis, m.
    pub cover: Spanned<f64>,
    /// Which way they run.
    pub direction: Spanned<BarDirection>,
    /// Where they lie.
    pub face: Spanned<BarFace>,
    /// Young's modulus, Pa.
    pub young: Spanned<f64>,
    /// Stress at which they yield, Pa; nothing: never.
    pub yields: Option<Spanned<f64>>,
    /// Strain beyond which they break; nothing: never.
    pub breaks: Option<Spanned<f64>>,
    /// Its table in the case: the header, or the braces.
    pub span: Range<usize>,
}

impl Reinforcement {
    pub(crate) fn read(f: &Fields) -> Option<Self> {
        let (name, yields, breaks) = (f.text("name"), f.number("yield"), f.number("breaking_strain"));
        Some(Reinforcement {
            name,
            on: f.texts("on"),
            area: f.number("area")?,
            cover: f.number("cover")?,
            direction: f.word("direction", BarDirection::from_word)?,
            face: f.word("face", BarFace::from_word)?,
            young: f.number("young")?,
            yields,
            breaks,
            span: f.span.clone(),
        })
    }
}
