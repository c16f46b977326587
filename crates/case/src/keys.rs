//! Tables of keys as data: what may stand in each table of a case.
//!
//! Each part of the case keeps its table beside the type it is read into. The tables alone drive the checks, the
//! defaults, the suggestions for misspelt keys and the JSON schema.

use tremolite_laws::parameter::{Dimension, Parameter};

use crate::units;

/// One table of the case file.
#[derive(Debug)]
pub struct Table {
    /// Its place, as in a header: `mesh.caverns.cavern`.
    pub path: &'static str,
    pub doc: &'static str,
    pub keys: &'static [Key],
    /// Groups of keys of which exactly one group must be given, by at least one of its keys; an empty group: none of them
    /// may be given as well. Empty: no such choice.
    pub choice: &'static [&'static [&'static str]],
}

impl Table {
    /// What the one value looks like that may stand for the whole table where it stands for these keys of it, in tables
    /// below as well.
    pub fn brief(&self, keys: &[&str]) -> Option<&'static Kind> {
        match &self.keys.iter().find(|key| keys.contains(&key.name))?.kind {
            Kind::Brief(table, keys) => table.brief(keys),
            kind => Some(kind),
        }
    }
}

/// One key of a table.
#[derive(Clone, Copy, Debug)]
pub struct Key {
    pub name: &'static str,
    pub kind: Kind,
    pub need: Need,
    pub when: When,
    pub doc: &'static str,
}

/// What a value looks like.
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    /// A number with its unit in a string; a bare one where it is 0, has no dimension, or the file is in SI.
    Number(Dimension, Limit),
    /// A whole number from 1 to this one.
    Count(u32),
    /// Text that is not empty, without control characters: a terminal, a log and a page may show it as it is.
    Text,
    /// The name of a file. It is shown with escapes, and of one that was written with backslashes, `"data\tables"`, whoever opens it tells.
    File,
    /// Text that can stand in a column name or a group name: no blanks or quotes, and none of `. , [ ] * ?`.
    Name,
    /// true or false.
    Flag,
    /// A unit alone, read as its SI value.
    Unit(Dimension),
    /// A permeability in m² or in m²/(Pa s), read as the hydraulic conductivity \[m/s\] for water.
    Permeability,
    /// One of these words.
    Word(&'static [&'static str]),
    /// From so many to so many values of one kind.
    List(&'static Kind, usize, usize),
    /// A list of numbers, one a row of a table of columns.
    Numbers(Dimension),
    Table(&'static Table),
    /// A table of columns, each a list with as many numbers.
    Columns(&'static [Parameter]),
    /// A table with one number for each of these entries.
    Set(&'static [Parameter]),
    /// An array of tables, `[[…]]`.
    Tables(&'static Table),
    /// A table, or one value that stands for a table with this value at each of these keys.
    Brief(&'static Table, &'static [&'static str]),
    /// A table whose keys are free, such as patterns of groups, with values of one kind; the text is an example of a key.
    Map(&'static str, &'static Kind),
    /// Tables of materials by name, each with these keys and the parameters of its law.
    Materials(&'static Table),
    /// An array of tables of interfaces, each with these keys and the parameters of its law.
    Interfaces(&'static Table),
    /// One of several kinds that differ in their TOML type; a word goes before a number.
    Either(&'static [Kind]),
}

/// What numbers are allowed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Limit {
    Any,
    Positive,
    NotNegative,
    /// Above 0, at most this.
    UpTo(f64),
    /// From 0 to this.
    Within(f64),
}

impl Limit {
    pub fn holds(self, x: f64) -> bool {
        match self {
            Limit::Any => true,
            Limit::Positive => x > 0.0,
            Limit::NotNegative => x >= 0.0,
            Limit::UpTo(most) => x > 0.0 && x <= most,
            Limit::Within(most) => (0.0..=most).contains(&x),
        }
    }

    /// The condition in words, to be read after 'must be'.
    pub fn words(self, dimension: Dimension) -> String {
        match self {
            Limit::Any => "finite".to_owned(),
            Limit::Positive => "above 0".to_owned(),
            Limit::NotNegative => "0 or more".to_owned(),
            Limit::UpTo(most) => format!("above 0 and at most {}", units::format(most, dimension)),
            Limit::Within(most) => format!("from 0 to {}", units::format(most, dimension)),
        }
    }
}

/// Whether a key may be left out.
#[derive(Clone, Copy, Debug)]
pub enum Need {
    Required,
    /// Required where this key of the same table is given; else this value, written as in a case, is used, and not listed.
    RequiredBeside(&'static str, &'static str),
    /// This value, written as in a case, is used and listed as defaulted.
    Default(&'static str),
    /// This value in SI is used and listed as defaulted.
    Number(f64),
    /// This word is used and listed as defaulted.
    Word(&'static str),
    /// Nothing is used. The text is listed as defaulted, unless it is empty.
    Optional(&'static str),
}

/// When a key has a meaning.
#[derive(Clone, Copy, Debug)]
pub enum When {
    Always,
    /// Only where this key of the same table is this word.
    Is(&'static str, &'static str),
    /// Only where this key of the same table is not this word.
    IsNot(&'static str, &'static str),
    /// Only where this key of the same table is given.
    Beside(&'static str),
    /// Only where one of these keys of the same table is given.
    BesideAny(&'static [&'static str]),
    /// Only where this key of the same table is not given.
    Without(&'static str),
    /// Only where none of these keys of the same table is given.
    WithoutAny(&'static [&'static str]),
}

impl When {
    /// The condition in words, to be read after 'only'; nothing where there is none.
    pub fn words(self) -> Option<String> {
        match self {
            When::Always => None,
            When::Is(key, word) => Some(format!("with `{key} = \"{word}\"`")),
            When::IsNot(key, word) => Some(format!("where `{key}` is not \"{word}\"")),
            When::Beside(key) => Some(format!("beside `{key}`")),
            When::BesideAny(keys) => Some(format!("beside one of `{}`", keys.join("`, `"))),
            When::Without(key) => Some(format!("without `{key}`")),
            When::WithoutAny(keys) => Some(format!("without `{}`", keys.join("` and `"))),
        }
    }
}

impl Key {
    const fn new(name: &'static str, kind: Kind, need: Need, doc: &'static str) -> Key {
        Key { name, kind, need, when: When::Always, doc }
    }

    pub const fn required(name: &'static str, kind: Kind, doc: &'static str) -> Key {
        Key::new(name, kind, Need::Required, doc)
    }

    /// A key that is required where the key `beside` is given, and else takes this value, written as in a case.
    pub const fn required_beside(
        name: &'static str,
        kind: Kind,
        beside: &'static str,
        otherwise: &'static str,
        doc: &'static str,
    ) -> Key {
        Key::new(name, kind, Need::RequiredBeside(beside, otherwise), doc)
    }

    /// A key that takes this value, written as in a case, where it is left out.
    pub const fn default(name: &'static str, kind: Kind, value: &'static str, doc: &'static str) -> Key {
        Key::new(name, kind, Need::Default(value), doc)
    }

    /// A key that may be left out; `without` says what happens then, for the list of defaulted keys.
    pub const fn optional(name: &'static str, kind: Kind, without: &'static str, doc: &'static str) -> Key {
        Key::new(name, kind, Need::Optional(without), doc)
    }

    pub const fn when(mut self, when: When) -> Key {
        self.when = when;
        self
    }
}

/// Declares an enumeration of words of the case file; the words are written once.
macro_rules! words {
    ($(#[$meta:meta])* $name:ident { $($(#[doc = $doc:literal])+ $variant:ident = $word:literal,)* }) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum $name { $($(#[doc = $doc])+ $variant,)* }

        impl $name {
            /// The words as they are written in a case.
            pub const WORDS: &'static [&'static str] = &[$($word),*];

            /// Each word with what it means.
            pub const MEANINGS: &'static [(&'static str, &'static str)] =
                &[$(($word, concat!($($doc),+).trim_ascii())),*];

            /// The word as it is written in a case.
            pub fn word(self) -> &'static str {
                match self { $($name::$variant => $word,)* }
            }

            pub(crate) fn from_word(word: &str) -> Option<Self> {
                match word { $($word => Some($name::$variant),)* _ => None }
            }
        }
    };
}

pub(crate) use words;
