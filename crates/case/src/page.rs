//! `[report]`: how the page of a run is set.

use crate::fields::Fields;
use crate::keys::{Key, Kind, Table, words};

pub(crate) static REPORT: Table = Table {
    path: "report",
    doc: "How the page of the run is set.",
    keys: &[
        Key::default("language", Kind::Word(Language::WORDS), "\"en\"", "The page's language"),
        Key::default(
            "view",
            Kind::Flag,
            "true",
            "Whether the page holds the model in three dimensions, with the fields of its field files",
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

/// How the page of the run is set.
#[derive(Clone, Debug, PartialEq)]
pub struct Page {
    /// The page's language.
    pub language: Language,
    /// Whether the page holds the model in three dimensions.
    pub view: bool,
}

impl Page {
    pub(crate) fn read(f: &Fields) -> Option<Self> {
        Some(Page { language: f.word("language", Language::from_word)?.value, view: f.flag("view")? })
    }
}
