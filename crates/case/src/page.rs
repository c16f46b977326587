//! `[report]`: how the page of a run is set, who signs it, and what the lining is held to.

use crate::fields::Fields;
use crate::keys::{Key, Kind, Limit, Table, words};
use tremolite_laws::parameter::Dimension;

const LENGTH: Kind = Kind::Number(Dimension::LENGTH, Limit::Positive);

pub(crate) static REPORT: Table = Table {
    path: "report",
    doc: "How the page of the run is set, who signs it, and what the lining is held to.",
    keys: &[
        Key::default("language", Kind::Word(Language::WORDS), "\"en\"", "The page's language"),
        Key::default(
            "view",
            Kind::Flag,
            "true",
            "Whether the page holds the model in three dimensions, with the fields of its field files",
        ),
        Key::optional("project", Kind::Text, "", "The project that the page is for"),
        Key::optional(
            "design_level",
            Kind::Text,
            "",
            "The level of the design earthquake, as it is to stand on the page: \"5000 years, class I\"",
        ),
        Key::optional("designed", Kind::Text, "", "Who designed; left out, a line to sign on"),
        Key::optional("checked", Kind::Text, "", "Who checked"),
        Key::optional("reviewed", Kind::Text, "", "Who reviewed"),
        Key::optional("approved", Kind::Text, "", "Who approved"),
        Key::optional("limits", Kind::Table(&LIMITS), "", "What the results are held to"),
    ],
    choice: &[],
};

pub(crate) static LIMITS: Table = Table {
    path: "report.limits",
    doc: "Limits of acceptance: the page's first sheet says of each whether it is met. `tremolite report DIR --limits FILE` takes the \
          same keys from a file.",
    keys: &[
        Key::optional(
            "displacement",
            LENGTH,
            "",
            "Of a monitor, relative to the state before the earthquake: the ground's own motion included",
        ),
        Key::optional(
            "relative_displacement",
            LENGTH,
            "",
            "Of two monitors against each other, of every [[monitor_pair]]: what closes or widens an opening",
        ),
        Key::optional(
            "crack_width",
            LENGTH,
            "",
            "Widest crack that crosses bars; one whose normal lies within 45° of the thickness is parallel to the wall and not held to it",
        ),
        Key::optional(
            "damage",
            Kind::Number(Dimension::NONE, Limit::Within(1.0)),
            "",
            "Cracked share of a lining's volume, D⁺ above 0.5",
        ),
        Key::optional(
            "crushing",
            Kind::Number(Dimension::NONE, Limit::Within(1.0)),
            "",
            "Crushed or sheared share of a lining's volume, D⁻ above 0.5",
        ),
        Key::optional(
            "utilisation",
            Kind::Number(Dimension::NONE, Limit::Positive),
            "",
            "Of a section's strength by its [[section]], in thrust with moment and in shear; 1 is all of it",
        ),
    ],
    choice: &[],
};

words! {
    /// The language of the page.
    Language {
        /// English.
        En = "en",
        /// Chinese, in simplified characters.
        Zh = "zh",
    }
}

/// How the page of a run is set, and what stands on its first sheet.
#[derive(Clone, Debug, PartialEq)]
pub struct Page {
    /// The page's language.
    pub language: Language,
    /// Whether the page holds the model in three dimensions.
    pub view: bool,
    /// The project, and the level of the design earthquake, as they are to stand there.
    pub project: Option<String>,
    pub design_level: Option<String>,
    /// Who designed, checked, reviewed and approved.
    pub signed: [Option<String>; 4],
    pub limits: Limits,
}

/// Limits of acceptance; those left out hold nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Limits {
    /// m
    pub displacement: Option<f64>,
    /// m
    pub relative_displacement: Option<f64>,
    /// m
    pub crack_width: Option<f64>,
    /// Share of a lining's volume.
    pub damage: Option<f64>,
    /// Share of a lining's volume.
    pub crushing: Option<f64>,
    /// 1
    pub utilisation: Option<f64>,
}

impl Page {
    pub(crate) fn read(f: &Fields) -> Option<Self> {
        let text = |key| f.text(key).map(|text| text.value);
        Some(Page {
            language: f.word("language", Language::from_word)?.value,
            view: f.flag("view")?,
            project: text("project"),
            design_level: text("design_level"),
            signed: ["designed", "checked", "reviewed", "approved"].map(text),
            limits: f.table("limits").map(Limits::read).unwrap_or_default(),
        })
    }
}

impl Limits {
    pub(crate) fn read(f: &Fields) -> Self {
        let number = |key| f.number(key).map(|number| number.value);
        Limits {
            displacement: number("displacement"),
            relative_displacement: number("relative_displacement"),
            crack_width: number("crack_width"),
            damage: number("damage"),
            crushing: number("crushing"),
            utilisation: number("utilisation"),
        }
    }
}
